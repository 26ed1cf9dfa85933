"""Questions to a sweep, by the library and by ``quintrig sweep``."""

import numpy as np
import pytest

from cli_runner import quintrig
from quintrig.exchange.tables import shown
from quintrig.figure.parallel import parallel_coordinates
from quintrig.model.model import Model
from quintrig.support.errors import QuintrigError
from quintrig.sweep import Axis, DesignSpace, Question, Task, count, load_sweep, open_sweep, run, select
from quintrig.sweep import store as sweep_store
from quintrig.sweep.part import columns

pl = pytest.importorskip("polars")
pytest.importorskip("pyarrow")

SWUNG = {
    "name": "vase",
    "unit": "cm",
    "kind": "swung",
    "flip": True,
    "shape": [0.5, -1.0, 0.0, 0.5],
    "profile": [[1, 0], [3, 1], [4, 3], [3, 5], [2, 7], [2, 8]],
    "trajectory": [[1, 0], [1, 0.6], [0.7, 1], [0, 1.2], [-0.6, 1.1], [-1, 0.9]],
}
CAR = "examples/car_boot.toml"


@pytest.fixture(scope="module")
def vases(tmp_path_factory):
    """Designs with one, λ = 0, that is no surface."""
    folder = tmp_path_factory.mktemp("sweep") / "a [strange] na*me"
    space = DesignSpace((Axis("scale", 0.0, 2.0, 9), Axis("alpha1", -3.0, 1.0, 5)))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sweep_store, "PART", 16)
        sweep = open_sweep(folder, Task(SWUNG, "vase", space, 8))
        run(sweep)
        yield sweep


def table(sweep):
    frame = pl.read_parquet(sweep.files(), glob=False)
    return {name: frame[name].to_numpy() for name in frame.columns}


def test_all_designs_come_back_in_order(vases):
    rows = select(vases, Question())
    assert list(rows) == list(columns(vases.task.space))
    for name, values in table(vases).items():
        np.testing.assert_array_equal(rows[name], values)


@pytest.mark.parametrize(
    ("where", "meets"),
    [
        ("area > 20", lambda t: t["area"] > 20),
        ("gaussian_min >= -0.5", lambda t: t["gaussian_min"] >= -0.5),
        (
            "GAUSSIAN_MIN < 0".lower() + " and area between 10 and 40",
            lambda t: (t["gaussian_min"] < 0) & (t["area"] >= 10) & (t["area"] <= 40),
        ),
        ("not (mean_max > 0) or alpha1 = 1", lambda t: (t["mean_max"] <= 0) | (t["alpha1"] == 1)),
        ("K_min >= -0.5 and α₁ < 0", lambda t: (t["gaussian_min"] >= -0.5) & (t["alpha1"] < 0)),
        ("singular > 0", lambda t: t["singular"] > 0),
        ("gaussian_min is null", lambda t: np.isnan(t["gaussian_min"])),
        ("area < -1", lambda t: t["area"] < -1),
    ],
)
def test_a_condition_keeps_the_designs_that_meet_it(vases, where, meets):
    whole = table(vases)
    kept = meets(whole)
    rows = select(vases, Question(where))
    for name, values in whole.items():
        np.testing.assert_array_equal(rows[name], values[kept])
    assert count(vases, Question(where)) == kept.sum()


@pytest.mark.parametrize("descending", [False, True])
def test_the_best_come_first_and_undefined_ones_last(vases, descending):
    rows = select(vases, Question("", "gaussian_min", descending))["gaussian_min"]
    undefined = np.isnan(rows)
    assert undefined.sum() == 5
    assert undefined[-5:].all()
    steps = np.diff(rows[:-5])
    assert (steps <= 0).all() if descending else (steps >= 0).all()


def test_a_limit_keeps_the_first(vases):
    question = Question("area > 1", "bending_energy")
    rows, whole = select(vases, question, 3), select(vases, question)
    for name, values in whole.items():
        np.testing.assert_array_equal(rows[name], values[:3])


@pytest.mark.parametrize(
    "where",
    [
        "gaussian_min >",
        "1; DROP TABLE designs",
        "nosuch > 1",
        "gaussian_min",
        "nosuch(area) > 1",
        "area = 'large'",
        "area > (SELECT 1)",
        "area > 1 ORDER BY area",
        "SELECT * FROM designs",
        "\0",
        "((((",
        "area > 1\nAND",
    ],
)
def test_a_condition_that_cannot_be_read_is_refused_in_one_line(vases, where):
    with pytest.raises(QuintrigError, match="where ") as error:
        select(vases, Question(where))
    assert "on the columns scale, alpha1, gaussian_min" in str(error.value)


@pytest.mark.parametrize(
    ("question", "said"),
    [
        (Question(best="bending_enrgy"), "did you mean 'bending_energy'"),
        (Question(best=""), None),
        (Question(descending=True), "descending: says the order"),
    ],
)
def test_an_order_needs_a_known_column(vases, question, said):
    if said is None:
        assert count(vases, question) == 45
        return
    for ask in (select, count):
        with pytest.raises(QuintrigError, match=said):
            ask(vases, question)


def test_a_broken_part_is_named(tmp_path):
    sweep = open_sweep(tmp_path, Task(SWUNG, "vase", DesignSpace((Axis("scale", 0.5, 2.0, 3),)), 8))
    with pytest.raises(QuintrigError, match="holds no finished part yet"):
        select(sweep, Question())
    run(sweep)
    part = sweep.files()[0]
    whole = part.read_bytes()
    part.write_bytes(whole[:8] + b"?" * (len(whole) - 16) + whole[-8:])
    with pytest.raises(QuintrigError, match="cannot be read"):
        select(sweep, Question())


# ---------------------------------------------------------------------------------------------- the command


@pytest.fixture(scope="module")
def lids(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cli") / "lids"
    result = quintrig("sweep", CAR, "--vary", "zeta1=0:1:3", "--vary", "alpha2=-2:0:3", "-o", folder, "--points", 8)
    assert result.code == 0, result.err
    assert "9 designs in" in result.err
    assert "a second" in result.err
    return folder


def test_a_run_lists_designs_with_units_and_normal(lids):
    result = quintrig("sweep", lids)
    assert result.code == 0
    assert "9 of 9 designs; the normal points along S_u × S_v" in result.out
    for text in ("zeta1", "alpha2", "gaussian_min", "1/mm²", "bending_energy", "thin_plate_energy", "singular"):
        assert text in result.out


def test_values_are_those_of_the_files(lids):
    least = select(load_sweep(lids), Question("", "bending_energy"), 1)
    result = quintrig("sweep", lids, "--best", "bending_energy", "--top", 1)
    for name in ("zeta1", "alpha2", "gaussian_max", "bending_energy", "area"):
        told = float(next(line for line in result.out.splitlines() if f" {name} " in line).split("│")[-2])
        if name.endswith("_max"):  # refined between the points
            assert told >= float(shown(float(least[name][0]), 5))
        else:
            assert told == float(shown(float(least[name][0]), 5))


def test_infinity_is_told_as_such_and_comes_last(tmp_path):
    result = quintrig("sweep", CAR, "--vary", "alpha1=-4:1:2", "-o", tmp_path / "s", "--best", "bending_energy")
    row = next(line for line in result.out.splitlines() if " bending_energy " in line)
    assert row.rstrip("│ ").endswith("∞")
    assert row.count("∞") == 1
    kept = quintrig("sweep", tmp_path / "s", "--where", "bending_energy < 1e12")
    assert kept.out.startswith("1 of 2 designs")


def test_a_finished_run_is_not_done_again(lids):
    arguments = ("--vary", "zeta1=0:1:3", "--vary", "alpha2=-2:0:3", "-o", lids, "--points", 8)
    before = [(file.stat().st_ino, file.stat().st_mtime_ns) for file in load_sweep(lids).files()]
    result = quintrig("sweep", CAR, *arguments)
    assert result.code == 0
    assert "were there already" in result.err
    assert [(file.stat().st_ino, file.stat().st_mtime_ns) for file in load_sweep(lids).files()] == before


def test_nothing_found_is_said_in_words(lids):
    result = quintrig("sweep", lids, "--where", "area < 0")
    assert (result.code, result.out.splitlines()[0][:15]) == (0, "0 of 9 designs;")


@pytest.mark.parametrize("suffix", ["png", "svg", "pdf"])
def test_the_picture_is_written(lids, tmp_path, suffix):
    file = tmp_path / f"lids.{suffix}"
    result = quintrig("sweep", lids, "--plot", file, "--best", "curvedness_max")
    assert result.code == 0
    assert file.stat().st_size > 1000
    if suffix == "svg":
        assert "<svg" in file.read_text()


def test_the_picture_says_the_side_of_the_normal_and_the_unit():
    rows = {"alpha1": np.array([0.0, 1.0]), "bending_energy": np.array([2.0, 1.0]), "mean_min": np.array([0.0, 1.0])}
    for flip, side in ((True, "turned, against"), (False, "along")):
        surface = Model.from_dict({**SWUNG, "flip": flip}).surface
        texts = [text.get_text() for text in parallel_coordinates(rows, ("alpha1",), surface, unit="cm").texts]
        assert any(f"ormal {side}" in text and text.endswith("lengths in cm") for text in texts)


def test_infinite_designs_are_left_out_of_the_picture_and_counted():
    rows = {"alpha1": np.array([0.0, 1.0, -4.0]), "bending_energy": np.array([2.0, 1.0, np.inf])}
    drawn = parallel_coordinates(rows, ("alpha1",), Model.from_dict(SWUNG).surface)
    assert drawn.texts[0].get_text() == "3 designs; 1 with an infinite or undefined value left out"


@pytest.mark.parametrize(("name", "said"), [("lids.gif", "ending in .png"), ("file/lids.png", "not a folder")])
def test_a_picture_that_cannot_be_written_is_refused_before_the_work(tmp_path, name, said):
    (tmp_path / "file").write_text("")
    result = quintrig("sweep", CAR, "-o", tmp_path / "out", "--vary", "zeta1=0:1:3", "--plot", tmp_path / name)
    assert result.code == 2
    assert said in result.err
    assert result.err.count("\n") == 1
    assert not (tmp_path / "out").exists()


def test_nothing_to_draw_is_a_mistake_and_writes_nothing(lids, tmp_path):
    result = quintrig("sweep", lids, "--where", "area < 0", "--plot", tmp_path / "no.png")
    assert result.code == 2
    assert "nothing to draw" in result.err
    assert not (tmp_path / "no.png").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((CAR,), "-o: expected a folder"),
        ((CAR, "-o", "OUT"), "expected at least one parameter"),
        ((CAR, "-o", "OUT", "--vary", "zeta1=1:0:3"), "reversed"),
        ((CAR, "-o", "OUT", "--vary", "zeta1=0:2:3"), "leaves [-4, 1]"),
        ((CAR, "-o", "OUT", "--vary", "zeta=0:1:3"), "did you mean 'zeta"),
        ((CAR, "-o", "OUT", "--vary", "zeta1=0:1:3", "--vary", "zeta1=0:1:3"), "given twice"),
        ((CAR, "-o", "OUT", "--vary", "zeta1=0:1:3", "--points", "2"), "--points"),
        ((CAR, "-o", "OUT", "--vary", "zeta1=0:1", "--sampling", "sobol"), "--samples"),
        ((CAR, "-o", "OUT", "--vary", "zeta1=0:1:3", "--top", "0"), "--top"),
        (("examples/sphere.toml", "-o", "OUT", "--vary", "alpha1=0:1:3"), "a sphere has radius"),
        (("nosuch.toml", "-o", "OUT", "--vary", "alpha1=0:1:3"), "no such file"),
    ],
)
def test_a_mistake_is_told_in_one_line_and_leaves_nothing(tmp_path, arguments, said):
    result = quintrig("sweep", *(str(tmp_path / "out") if word == "OUT" else word for word in arguments))
    assert result.code == 2
    assert said in result.err
    assert result.err.count("\n") == 1
    assert not (tmp_path / "out").exists()


def test_a_question_that_cannot_be_read_is_told_before_the_work(tmp_path):
    for words in (("--where", "area >"), ("--best", "nosuch"), ("--greatest",)):
        result = quintrig("sweep", CAR, "--vary", "zeta1=0:1:3", "-o", tmp_path / "out", *words)
        assert result.code == 2
        assert result.err.count("\n") == 1
        assert not list((tmp_path / "out").glob("part-*"))


def test_ranges_cannot_be_given_for_a_folder(lids):
    result = quintrig("sweep", lids, "--vary", "zeta1=0:1:3")
    assert (result.code, "leave out --vary" in result.err) == (2, True)
