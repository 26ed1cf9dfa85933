"""Whole figures: every kind, on every kind of surface, says what it must and becomes a file."""

import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import matplotlib
import numpy as np
import pytest

import quintrig
from quintrig import figure
from quintrig.quantities.table import QUANTITIES
from quintrig.support.errors import QuintrigError

CASES = json.loads((Path(__file__).parent / "data" / "cases.json").read_text())
WAVY = next(c["model"] for c in CASES if c["model"]["name"] == "wavy net")


def wavy(size=1.0, flip=False):
    return quintrig.tensor(np.array(WAVY["points"]) * size, WAVY["shape"], flip=flip)


def coarse(**changes):
    return figure.Scene(cells=16, **changes)


SURFACES = {
    "wavy": wavy(),
    "tiny": wavy(1e-3),
    "large": wavy(1e3),
    "sphere": quintrig.sphere(),
    "torus": quintrig.torus(),
    "cylinder": quintrig.cylinder(),
    "monkey saddle": quintrig.monkey_saddle(),
    "edge inside": quintrig.Model.from_dict(CASES[28]["model"]).surface,
    "plane": quintrig.tensor(np.array(WAVY["points"]) * [1.0, 1.0, 0.0]),
    "line": quintrig.tensor(np.array(WAVY["points"]) * [1.0, 0.0, 0.0]),
    "point": quintrig.tensor(np.ones((6, 6, 3))),
}
MARKS = (figure.Mark(0.0, 0.0, "A"), figure.Mark(0.5, 0.5, "B"), figure.Mark(1.0, 0.3, "C"))
KINDS = {
    "space": lambda s, unit: figure.space_picture(s, "gaussian", coarse(marks=MARKS, net=True), unit=unit),
    "plain": lambda s, unit: figure.space_picture(s, None, coarse(net=True, normal=True, isolines=3), unit=unit),
    "map": lambda s, unit: figure.flat_map(s, "mean", marks=MARKS, unit=unit),
    "panels": lambda s, unit: figure.panels(s, (None, "mean", "hk_type"), coarse(), unit=unit),
    "maps": lambda s, unit: figure.map_panels(s, ("gaussian", "shape_class"), unit=unit),
    "comparison": lambda s, unit: figure.comparison([s, s], ["a", "b"], "k1", coarse(), unit=unit),
    "map comparison": lambda s, unit: figure.map_comparison([s, s], ["a", "b"], "curvedness", unit=unit),
    "projections": lambda s, unit: figure.projections(s, "gaussian", coarse(), unit=unit),
    "overlay": lambda s, unit: figure.overlay([s, s], ["a", "b"], coarse(), unit=unit),
}


def words(drawn) -> str:
    found = [text.get_text() for text in drawn.texts]
    for axes in drawn.axes:
        found += [text.get_text() for text in axes.texts]
        found += [axes.get_xlabel(), axes.get_ylabel()]
    return "\n".join(found).replace("\n", " ")


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", SURFACES)
def test_every_figure_of_every_surface_is_drawn_and_states_unit_and_normal(kind, name):
    drawn = KINDS[kind](SURFACES[name], "mm")
    drawn.canvas.draw()
    said = words(drawn)
    assert "lengths in mm" in said
    assert "ormal" in said


@pytest.mark.parametrize("kind", KINDS)
def test_the_normal_that_is_stated_turns_with_the_surface(kind):
    assert "Normal along" in words(KINDS[kind](wavy(), ""))
    assert "Normal turned" in words(KINDS[kind](wavy(flip=True), ""))
    assert "no unit of length given" in words(KINDS[kind](wavy(), ""))


@pytest.mark.parametrize("key", [q.key for q in QUANTITIES if q.colour != "vector"])
def test_every_quantity_has_a_map_and_a_picture_with_its_name_and_unit(key):
    q = figure.whole.quantity(key)
    for drawn in (
        figure.flat_map(quintrig.torus(), key, unit="mm"),
        figure.space_picture(wavy(), key, coarse(), unit="mm"),
    ):
        drawn.canvas.draw()
        said = words(drawn)
        assert q.name.lower() in said.lower()
        assert q.unit("mm") in said


def test_undefined_points_are_counted():
    assert "grey: undefined" in words(figure.flat_map(quintrig.sphere(), "gaussian"))
    assert "grey" not in words(figure.flat_map(quintrig.torus(), "gaussian"))


def test_the_clipped_share_is_stated():
    cone = quintrig.cone()  # H grows without bound towards the apex
    assert "% beyond" in words(figure.flat_map(cone, "mean"))
    assert "% beyond" not in words(figure.flat_map(quintrig.torus(), "mean"))


def test_the_edge_of_regression_is_warned_of_in_every_figure():
    for make in KINDS.values():
        assert "Warning: the edge of regression" in words(make(SURFACES["edge inside"], "mm"))


def test_class_keys_list_just_the_classes_that_occur():
    said = words(figure.flat_map(quintrig.torus(), "hk_type"))
    assert "peak" in said
    assert "saddle ridge" in said
    assert "pit" not in said
    assert "minimal" not in said


def test_surfaces_side_by_side_share_one_scale_of_length():
    drawn = figure.comparison([quintrig.sphere(1.0), quintrig.sphere(3.0)], ["small", "large"], None, coarse())
    spans = {tuple(np.subtract(*axes.get_xlim()[::-1]) for axes in drawn.axes)}
    first, second = spans.pop()
    assert first == pytest.approx(second)


def test_several_patches_are_one_picture():
    pair = [quintrig.sphere(), quintrig.cylinder(2.0, 1.0)]
    drawn = figure.panels(pair, (None, "gaussian", "hk_type"), coarse(net=True, normal=True))
    drawn.canvas.draw()
    said = words(drawn)
    assert "peak" in said
    assert "ridge" in said


@pytest.mark.parametrize("width", [3.0, 12.0])
@pytest.mark.parametrize("kind", ["panels", "projections", "comparison", "space", "maps"])
def test_figures_keep_the_width_asked_for(kind, width):
    s = wavy()
    drawn = {
        "panels": lambda: figure.panels(s, scene=coarse(), width=width),
        "projections": lambda: figure.projections(s, scene=coarse(), width=width),
        "comparison": lambda: figure.comparison([s] * 4, list("abcd"), scene=coarse(), width=width),
        "space": lambda: figure.space_picture(s, "mean", coarse(), width=width),
        "maps": lambda: figure.map_panels(s, ("gaussian", "mean", "k1"), width=width),
    }[kind]()
    assert drawn.get_size_inches()[0] == pytest.approx(width, abs=0.01)


def test_panels_do_not_overlap():
    drawn = figure.panels(wavy(), (None, "gaussian", "hk_type", "mean"), coarse(), title="A title", columns=2)
    boxes = [axes.get_position() for axes in drawn.axes]
    for i, one in enumerate(boxes):
        for other in boxes[i + 1 :]:
            wide = min(one.x1, other.x1) - max(one.x0, other.x0)
            tall = min(one.y1, other.y1) - max(one.y0, other.y0)
            assert wide <= 1e-9 or tall <= 1e-9
        assert 0.0 <= one.x0 < one.x1 <= 1.0
        assert 0.0 <= one.y0 < one.y1 <= 1.0


# --- files ----------------------------------------------------------------------------------------------------------

STARTS = {"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}


@pytest.mark.parametrize("kind", STARTS)
def test_a_figure_becomes_the_kind_of_file_its_suffix_names(kind, tmp_path):
    for suffix in (kind, kind.upper()):
        path = figure.save(figure.flat_map(wavy(), "mean"), tmp_path / f"deep/er/picture.{suffix}", 60)
        assert path.read_bytes().startswith(STARTS[kind])


@pytest.mark.parametrize("name", ["picture.jpg", "picture", "picture.", "svg"])
def test_another_suffix_is_refused_with_those_that_are_known(name, tmp_path):
    with pytest.raises(QuintrigError, match=r"\.png, \.svg, \.pdf, \.eps"):
        figure.save(figure.flat_map(wavy(), "mean"), tmp_path / name)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("kind", STARTS)
def test_the_same_figure_is_the_same_bytes(kind):
    one, two = (figure.to_bytes(KINDS["panels"](wavy(), "mm"), kind, 50) for _ in range(2))
    assert one == two


def test_threads_do_not_disturb_each_other():
    def make(kind):
        return figure.to_svg_text(KINDS[kind](wavy(), "mm"), 50)

    kinds = ["space", "map", "overlay", "panels"] * 2
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(make, kinds))
    assert together == [make(kind) for kind in kinds]


def test_matplotlib_is_left_as_it_was():
    before = dict(matplotlib.rcParams)
    figure.to_svg_text(KINDS["panels"](wavy(), "mm"), 50)
    assert dict(matplotlib.rcParams) == before
    code = (
        "import sys, quintrig; from quintrig import figure; "
        "figure.to_png_bytes(figure.flat_map(quintrig.torus(), 'mean'), 40); "
        "sys.exit('matplotlib.pyplot' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        (("gaussian",), "solid line: $K = 0$"),
        (("mean",), "dashed line: $H = 0$"),
        (("k1",), r"solid line: $\kappa_1 = 0$"),
        (("gaussian", "gamma1"), r"solid line: $K = 0$, in pictures of $\gamma_1$ their own zero"),
        (("beta1", "gamma1"), "solid line: zero of the quantity shown"),
    ],
)
def test_a_picture_in_space_says_what_its_zero_lines_are(keys, expected):
    assert expected in words(figure.panels(wavy(), keys, coarse()))


@pytest.mark.parametrize(
    ("surface", "gaussian", "mean"),
    [("sphere", False, False), ("cylinder", False, False), ("torus", True, False), ("wavy", True, True)],
)
def test_lines_are_spoken_of_only_where_they_are_drawn(surface, gaussian, mean):
    s = SURFACES[surface]
    for drawn in (figure.flat_map(s, "shape_index"), figure.map_panels(s, ("gaussian", "mean"))):
        assert ("solid line: $K = 0$" in words(drawn)) == gaussian
        assert ("dashed line: $H = 0$" in words(drawn)) == mean
    in_space = figure.panels(s, ("gaussian", "mean"), coarse())
    assert ("solid line: $K = 0$" in words(in_space)) == gaussian
    assert ("dashed line: $H = 0$" in words(in_space)) == mean


def test_a_picture_without_zero_lines_speaks_of_none():
    assert "line:" not in words(figure.panels(wavy(), ("curvedness", "hk_type"), coarse()))
    assert "line:" not in words(figure.space_picture(wavy(), "gaussian", coarse(zeros=False)))
