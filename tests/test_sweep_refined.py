"""Extremes of the designs that a question returns hold between the points of the sweep too."""

import numpy as np
import pytest

from cli_runner import quintrig
from quintrig.analysis.extremes import find_extremes
from quintrig.analysis.summary import summarise
from quintrig.model.model import load
from quintrig.quantities.classify import Thresholds
from quintrig.sweep import Axis, DesignSpace, Question, Task, count, load_sweep, open_sweep, run, select, select_refined

pl = pytest.importorskip("polars")
pytest.importorskip("pyarrow")

# A hill that is hardly curved along u near its edges: where it turns to a saddle there, it does so between the points.
HILL = {
    "name": "hill",
    "unit": "mm",
    "kind": "tensor",
    "points": [
        [[20 * i, 20 * j, round(a * b / 36)] for j, b in enumerate((0, 14, 38, 42, 18, 4))]
        for i, a in enumerate((0, 14, 38, 42, 18, 4))
    ],
}
CONVEX = {
    "name": "convex",
    "kind": "tensor",
    "points": [[[i, j, -((i - 2.6) ** 2) - 0.9 * (j - 2.4) ** 2] for j in range(6)] for i in range(6)],
}


@pytest.fixture(scope="module")
def sweep(tmp_path_factory):
    """Few points a design, so that much lies between them."""
    folder = tmp_path_factory.mktemp("sweep") / "out"
    space = DesignSpace((Axis("alpha1", -3.9, 1.0, 9), Axis("zeta2", -3.9, 1.0, 9)))
    found = open_sweep(folder, Task(CONVEX, "convex", space, 5, Thresholds()))
    run(found)
    return found


def surfaces(sweep, rows):
    names = sweep.task.space.names
    for values in zip(*(rows[name].tolist() for name in names), strict=True):
        yield sweep.task.varied()[0].with_parameters(dict(zip(names, values, strict=True))).surface


@pytest.fixture(scope="module")
def threshold(sweep):
    """A condition that some designs meet at the points, but not between them: found by looking at every design."""
    rows = select(sweep, Question())
    true = [find_extremes(surface, ("gaussian",))["gaussian"].minimum.value for surface in surfaces(sweep, rows)]
    seen, true = rows["gaussian_min"], np.array(true)
    bounds = [float(x) for x in 0.5 * (seen + true)[seen > true] if (true >= x).sum() >= 3]
    return max(bounds, key=lambda x: ((seen >= x) & (true < x)).sum()), true, seen


def test_every_design_returned_meets_the_condition_between_the_points_too(sweep, threshold):
    bound, true, seen = threshold
    question = Question(f"gaussian_min >= {bound!r}")
    wrong = int(((seen >= bound) & (true < bound)).sum())
    assert wrong > 0  # what the points alone would return
    assert count(sweep, question) == int((seen >= bound).sum())
    found = select_refined(sweep, question, 100)
    assert found.dropped == wrong
    assert found.all_tried
    assert len(found.rows["area"]) == count(sweep, question) - wrong
    for surface, told in zip(surfaces(sweep, found.rows), found.rows["gaussian_min"], strict=True):
        assert told >= bound
        assert find_extremes(surface, ("gaussian",))["gaussian"].minimum.value == pytest.approx(told, rel=1e-9)


def test_a_design_that_is_left_out_gives_its_place_to_the_next(sweep, threshold):
    bound, *_ = threshold
    question = Question(f"gaussian_min >= {bound!r}", "gaussian_min")
    few = select_refined(sweep, question, 3)
    assert len(few.rows["area"]) == 3
    assert few.dropped > 0
    assert (few.rows["gaussian_min"] >= bound).all()
    assert (np.diff(few.rows["gaussian_min"]) >= 0.0).all()


def test_refined_extremes_are_those_of_check_and_only_go_outwards(sweep):
    found = select_refined(sweep, Question(), 81).rows
    raw = select(sweep, Question())
    for key in ("gaussian", "mean", "curvedness"):
        assert (found[f"{key}_min"] <= raw[f"{key}_min"]).all()
        assert (found[f"{key}_max"] >= raw[f"{key}_max"]).all()
    for name in ("area", "bending_energy", "thin_plate_energy"):
        np.testing.assert_array_equal(found[name], raw[name])
    for row, surface in list(enumerate(surfaces(sweep, found)))[::40]:
        told = summarise(surface).extremes["mean"]
        assert found["mean_min"][row] == pytest.approx(told.minimum.value, rel=1e-9)
        assert found["mean_max"][row] == pytest.approx(told.maximum.value, rel=1e-9)


def test_designs_without_bound_keep_their_infinity(tmp_path):
    space = DesignSpace((Axis("alpha1", -4.0, 0.0, 3),))
    found = open_sweep(tmp_path / "out", Task(HILL, "hill", space, 8))
    run(found)
    rows = select_refined(found, Question(), 3).rows
    raw = select(found, Question())
    assert np.isinf(rows["curvedness_max"]).tolist() == np.isinf(raw["curvedness_max"]).tolist() == [True, False, False]


def test_nothing_found_is_nothing_refined(sweep):
    found = select_refined(sweep, Question("area < 0"), 5)
    assert (found.dropped, found.tried, len(found.rows["area"])) == (0, 0, 0)


def test_the_command_lists_refined_designs_and_says_what_it_left_out(sweep, threshold):
    bound, true, seen = threshold
    wrong = int(((seen >= bound) & (true < bound)).sum())
    told = quintrig("sweep", sweep.folder, "--where", f"gaussian_min >= {bound!r}", "--top", "100")
    assert (told.code, told.err) == (0, "")
    ones = "1 design" if wrong == 1 else f"{wrong} designs"
    assert f"of them, {ones} no longer met the condition" in told.out
    assert "counted by 5 × 5 points a design; extremes of those listed are refined between the points" in told.out
    assert load_sweep(sweep.folder).missing() == []


@pytest.mark.slow
def test_no_design_of_the_car_boot_passes_as_convex_and_is_not(tmp_path):
    model = load("examples/car_boot.toml")
    patch = model.patches[0]
    space = DesignSpace((Axis("alpha1", -3.5, 1.0, 21), Axis("zeta2", -3.5, 1.0, 21)))
    found = open_sweep(tmp_path / "out", Task(model.to_dict(), patch.name, space))
    run(found)
    for surface in surfaces(found, select_refined(found, Question("gaussian_min >= 0"), 200).rows):
        assert find_extremes(surface, ("gaussian",))["gaussian"].minimum.value >= 0.0
