"""The parts of figures: camera, painting, zero lines, words on axes, diagrams."""

import json
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.colors import to_rgb
from scipy.spatial import ConvexHull

import quintrig
from quintrig.basis.trigonometric import Trigonometric
from quintrig.figure import (
    camera,
    compared,
    curve,
    diagram,
    edge,
    field,
    frame,
    palette,
    scene,
    shade,
    sheet,
    space,
    space_curves,
    space_picture,
    to_png_bytes,
    wording,
)
from quintrig.geometry.surface import Surface
from quintrig.quantities.classify import HK_TYPES
from quintrig.quantities.table import quantity

CASES = json.loads((Path(__file__).parent / "data" / "cases.json").read_text())
EDGE_INSIDE = next(c["model"] for c in CASES if c["model"]["name"] == "developable" and c["model"]["shape"] == [1, 1])

angles = st.floats(-180.0, 180.0)


def patch(corner, side=(1.0, 0.0, 0.0), up=(0.0, 1.0, 0.0)) -> Surface:
    a, b, c = (np.array(x, dtype=float) for x in (corner, side, up))
    return quintrig.tensor([[a, a + c], [a + b, a + b + c]], basis="bernstein")


# --- camera ---------------------------------------------------------------------------------------------------------


@settings(deadline=None)
@given(angles, st.floats(-90.0, 90.0))
def test_a_view_is_a_rotation(azimuth, elevation):
    axes = camera.View("", azimuth, elevation).axes
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-11)
    assert np.linalg.det(axes) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("name", "right", "up"),
    [("side", (1, 0, 0), (0, 0, 1)), ("back", (0, 1, 0), (0, 0, 1)), ("top", (1, 0, 0), (0, 1, 0))],
)
def test_standard_views_show_true_axes(name, right, up):
    axes = camera.VIEWS[name].axes
    assert np.array_equal(axes[0], right)
    assert np.array_equal(axes[1], up)


def test_a_point_is_hidden_only_behind_the_surface():
    t = np.linspace(0.0, 1.0, 4)
    mesh = np.stack([*np.meshgrid(t, t, indexing="ij"), np.zeros((4, 4))], axis=-1)
    points = np.array([[0.4, 0.5, -1.0], [0.4, 0.5, 1.0], [1.5, 0.5, -1.0], [0.4, 0.5, -1e-9]])
    assert camera.hidden(points, [mesh], 1e-6).tolist() == [True, False, False, False]


# --- painting -------------------------------------------------------------------------------------------------------


def middle_colour(surfaces, colours, view) -> np.ndarray:
    figure = sheet.new_figure(2.0, 2.0)
    axes = sheet.Area(figure, 0.0, 0.0, 2.0, 2.0).axes()
    space.draw_space(axes, surfaces, scene.Scene(view=view, frame=False, cells=9), colours=colours)
    figure.canvas.draw()
    picture = np.asarray(figure.canvas.buffer_rgba())
    return picture[picture.shape[0] // 2, picture.shape[1] // 2, :3].astype(int)


@pytest.mark.parametrize("order", [0, 1])
@pytest.mark.parametrize(("elevation", "upper_wins"), [(90.0, True), (-90.0, False)])
def test_the_near_surface_covers_the_far_one(order, elevation, upper_wins):
    pair = [(patch((0, 0, 0)), "#0000ff"), (patch((0, 0, 1)), "#ff0000")]
    pair = pair[::-1] if order else pair
    red, _, blue = middle_colour([s for s, _ in pair], [c for _, c in pair], camera.View("", -90.0, elevation))
    assert (red > blue) == upper_wins


def test_the_side_of_the_normal_has_its_own_colour():
    surface, turned = patch((0, 0, 0)), quintrig.tensor(patch((0, 0, 0)).net, basis="bernstein", flip=True)
    from_above = [middle_colour([s], [], camera.TOP) for s in (surface, turned)]
    from_below = [middle_colour([s], [], camera.View("", -90.0, -90.0)) for s in (surface, turned)]
    assert from_above[0][2] > from_above[0][0]  # blue: the normal comes towards the viewer
    assert from_above[1][0] > from_above[1][2]
    assert np.abs(from_above[0] - from_below[1]).max() <= 2
    assert np.abs(from_above[1] - from_below[0]).max() <= 2


@pytest.mark.parametrize("view", [*camera.VIEWS.values(), camera.View("", 130.0, -20.0)], ids=lambda v: v.name)
@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_scales_are_equal_and_everything_is_inside(view, size):
    surface = quintrig.torus(3.0 * size, size)
    figure = sheet.new_figure(5.0, 3.0)
    axes = sheet.Area(figure, 0.5, 0.2, 4.0, 2.5).axes()
    space.draw_space(axes, [surface], scene.Scene(view=view, cells=24))
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    assert (right - left) / (high - low) == pytest.approx(4.0 / 2.5)
    seen = view.project(scene.mesh_points(surface, 24))
    assert left < seen[..., 0].min() < seen[..., 0].max() < right
    assert low < seen[..., 1].min() < seen[..., 1].max() < high


def test_projections_beside_each_other_have_one_scale():
    low, high = np.array([0.0, 0.0, 0.0]), np.array([500.0, 1400.0, 300.0])
    views = [camera.SIDE, camera.BACK, camera.TOP]
    sizes, point = frame.equal_scale(views, low, high, 9.0, True)
    assert sum(width for width, _ in sizes) <= 9.0 * 1.002
    for view, (width, height) in zip(views, sizes, strict=True):
        needed = frame.point_length(view, low, high, (72.0 * width, 72.0 * height), True)
        assert needed <= point * 1.001


# --- fields and zero lines ------------------------------------------------------------------------------------------


def lines(surface, key, count=61):
    t = np.linspace(0.0, 1.0, count)
    return field.zero_lines(field.field(surface, key, t, t))


def test_the_torus_has_zero_gaussian_curvature_on_its_top_and_bottom_circles():
    found = lines(quintrig.torus(), "gaussian")
    u = np.concatenate([line[:, 0] for line in found])
    assert {round(float(x), 2) for x in u} == {0.25, 0.75}
    assert np.abs(np.abs(u - 0.5) - 0.25).max() < 1e-3
    assert all(np.ptp(line[:, 1]) == pytest.approx(1.0) for line in found)


def test_the_saddle_xy_has_zero_mean_curvature_on_its_axes_and_never_zero_gaussian_curvature():
    surface = quintrig.hyperbolic_paraboloid()
    points = np.concatenate(lines(surface, "mean", 60))  # H = -x y / W³; no node lies on an axis
    assert np.abs(points - 0.5).min(axis=1).max() < 0.02
    assert lines(surface, "gaussian") == []


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_rounding_makes_no_zero_lines(size):
    net = np.array(CASES[0]["model"]["points"]) * size
    for surface in (quintrig.cylinder(size, size), quintrig.cone(size, size), quintrig.tensor(net, (1, 0, -2, -3))):
        assert lines(surface, "gaussian") == []
    plane = quintrig.tensor(net * [1.0, 1.0, 0.0], (1, 0, -2, -3))
    assert lines(plane, "gaussian") == []
    assert lines(plane, "mean") == []


def test_only_the_facets_at_the_poles_of_a_sphere_are_undefined():
    found = field.facet_fields([quintrig.sphere()], "gaussian", 12)[0]
    assert found.undefined[[0, -1]].all()
    assert not found.undefined[1:-1].any()
    codes = field.facet_fields([quintrig.sphere()], "hk_type", 12)[0]
    assert np.array_equal(codes.undefined, found.undefined)


def test_a_vector_has_no_colour():
    with pytest.raises(ValueError, match="vector"):
        field.field(quintrig.sphere(), "normal", np.array([0.5]), np.array([0.5]))


# --- the edge of regression, and what runs off to infinity -----------------------------------------------------------


def test_an_edge_of_regression_inside_is_drawn_and_warned_of():
    surface = quintrig.Model.from_dict(EDGE_INSIDE).surface
    assert "Warning" in edge.regression_note(surface)
    found = edge.regression_parameters(surface)
    assert found
    for line in found:
        u, v = line.T
        jacobian = np.cross(*surface.partials(u, v, 1)[[1, 0], [0, 1]])
        middle = np.cross(*surface.partials(u, 0.5 * np.ones_like(u), 1)[[1, 0], [0, 1]])
        inside = (v > 0.0) & (v < 1.0)
        assert np.linalg.norm(jacobian, axis=-1)[inside].max() < 1e-6 * np.linalg.norm(middle, axis=-1).max()


@pytest.mark.parametrize("surface", [quintrig.cylinder(), quintrig.sphere(), patch((0, 0, 0))])
def test_other_surfaces_have_no_edge_of_regression(surface):
    assert edge.regression_note(surface) == ""
    assert edge.regression_lines(surface) == []


def test_a_ruled_surface_that_is_not_developable_is_not_warned_of():
    first = [(0, i, 0) for i in range(6)]
    second = [(1, i, i) for i in range(6)]
    assert edge.regression_note(quintrig.ruled(first, second)) == ""


def test_a_surface_that_runs_off_to_infinity_is_cut_and_an_ordinary_one_is_not():
    wild = quintrig.Model.from_dict(EDGE_INSIDE).surface
    box = scene.bounds([wild], scene.Scene())
    assert scene.share_outside([wild], box) > 0.0
    for tame in (quintrig.torus(), quintrig.enneper(), quintrig.cylinder(1.0, 100.0)):
        box = scene.bounds([tame], scene.Scene())
        assert scene.share_outside([tame], box) == 0.0


def test_a_narrow_peak_is_not_cut():
    net = np.zeros((6, 6, 3))
    net[..., 0], net[..., 1] = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    net[2, 2, 2] = 40.0
    surface = quintrig.tensor(net)
    assert scene.share_outside([surface], scene.bounds([surface], scene.Scene())) == 0.0


# --- words ----------------------------------------------------------------------------------------------------------


@settings(deadline=None)
@given(st.floats(-1e9, 1e9), st.integers(-9, 9), st.integers(2, 6))
def test_ticks_that_differ_are_written_differently(start, power, count):
    step = 10.0**power * max(1.0, abs(start) * 1e-9)
    values = [round(start / step) * step + i * step for i in range(count)]
    if len(set(values)) == count:
        assert len(set(wording.tick_texts(values))) == count


@pytest.mark.parametrize(
    ("values", "power", "texts"),
    [
        ([-0.5, 0.0, 0.5], 0, ["−0.5", "0", "0.5"]),
        ([0.0, 0.001, 0.002], -3, ["0", "1", "2"]),
        ([1000000.0, 1000005.0], 0, ["1000000", "1000005"]),
        ([2.5], 0, ["2.5"]),
    ],
)
def test_ticks_read_as_people_write_them(values, power, texts):
    assert wording.tick_texts(values, power) == texts


@pytest.mark.parametrize(
    ("key", "unit", "power", "label"),
    [
        ("gaussian", "mm", 0, "Gaussian curvature $K$ (1/mm²)"),
        ("gaussian", "mm", -6, "Gaussian curvature $K$ ($10^{-6}$ 1/mm²)"),
        ("gaussian", "", 3, "Gaussian curvature $K$ (× $10^{3}$)"),
        ("shape_index", "mm", 0, "Shape index $S$"),
        ("hk_type", "mm", 0, "HK type"),
    ],
)
def test_a_label_states_name_symbol_and_unit(key, unit, power, label):
    assert wording.quantity_label(quantity(key), unit, power) == label


@pytest.mark.parametrize("text", ["costs $5", "$\\nonsense{$", "$$", "a\x00b\x07", "$K$ over $u$", "100 % & <b>"])
def test_any_text_can_be_drawn(text):
    figure = sheet.sheet(1, (1.0, 0.5), title=text, titles=[text], note=text).figure
    figure.canvas.draw()
    assert any(child.get_text() for child in figure.texts)


# --- curves and diagrams --------------------------------------------------------------------------------------------


def test_the_basis_plot_draws_functions_that_sum_to_one():
    figure = curve.basis_functions([Trigonometric(1.0, -3.0)])
    drawn = figure.axes[0].get_lines()
    assert len(drawn) == 6
    np.testing.assert_allclose(sum(np.asarray(line.get_ydata()) for line in drawn), 1.0, atol=1e-14)


def test_curves_are_drawn_where_they_are():
    family = [quintrig.Curve([(3, 0), (2, 5), (3, 10), (5, 10), (6, 5), (5, 0)], 0.0, z) for z in (1, 0, -4)]
    figure = curve.plane_curves(family, ["1", "0", "-4"], hull=True)
    drawn = [line.get_xydata() for line in figure.axes[0].get_lines()]
    assert len(drawn) == 4  # three curves and their one polygon
    np.testing.assert_allclose([line[[0, -1]] for line in drawn], [[[3.0, 0.0], [5.0, 0.0]]] * 4, atol=1e-12)
    lone = curve.plane_curves([quintrig.Curve([(i, 0) for i in range(6)])], hull=True, comb=True)  # a straight line
    lone.canvas.draw()


def test_a_curve_is_drawn_in_its_own_kind_of_space():
    plane = quintrig.Curve([(i, i * i) for i in range(6)])
    spatial = quintrig.Curve([(i, i * i, 1) for i in range(6)])
    with pytest.raises(ValueError, match="use space_curves"):
        curve.plane_curves([plane, spatial])
    with pytest.raises(ValueError, match="use plane_curves"):
        space_curves([spatial, plane])


@settings(deadline=None)
@given(st.floats(-3.0, 3.0), st.floats(-3.0, 3.0))
def test_a_canonical_patch_has_the_curvatures_it_is_named_for(first, second):
    k1, k2 = max(first, second), min(first, second)
    sample = quintrig.analyse(diagram.canonical_patch(k1, k2), 0.5, 0.5)
    assert sample["k1"] == pytest.approx(k1, abs=1e-12)
    assert sample["k2"] == pytest.approx(k2, abs=1e-12)
    assert sample.normal[2] > 0.0


@pytest.mark.parametrize("h", [-1, 0, 1])
@pytest.mark.parametrize("k", [-1, 0, 1])
def test_each_tile_of_the_sign_table_is_of_its_type(h, k):
    if (h, k) == (0, 1):
        return
    ends = {-1: (-0.9, -0.9), 0: (0.0, 0.0), 1: (0.9, 0.9)}
    sample = quintrig.analyse(diagram.canonical_patch(*diagram.tile_curvatures(h, k, ends)), 0.5, 0.5)
    assert np.sign(sample["mean"]) == h
    assert np.sign(sample["gaussian"]) == k


def test_diagrams_name_every_type():
    words = {t.get_text() for axes in diagram.hk_table().axes for t in axes.texts}
    assert set(HK_TYPES[1:]) - {"impossible"} <= words
    words = {t.get_text() for axes in diagram.shape_scale().axes for t in axes.texts}
    assert set(quantity("shape_class").classes[1:10]) <= words


@pytest.mark.parametrize("index", range(9))
def test_each_patch_of_the_scale_is_of_its_class(index):
    sample = quintrig.analyse(diagram.scale_patch(-1.0 + 0.25 * index), 0.5, 0.5)
    assert sample["shape_class"] == index + 1


def test_colours_of_a_family_differ():
    for count in (1, 3, 4, 8):
        assert len({to_rgb(colour) for colour in curve.family_colours(count)}) == count


def test_points_that_differ_by_rounding_frame_one_point():
    low = np.array([1.0, 2.0, 3.0])
    first, last = scene.settled(low, low * (1.0 + 1e-15))
    assert np.array_equal(first, last)
    first, last = scene.settled(low, low + 1e-6)
    assert np.all(last > first)


def test_points_side_by_side_are_drawn():
    points = [quintrig.tensor(np.full((6, 6, 3), 1.1), shape) for shape in ((1, 1, 1, 1), (1, 0, -2, -3))]
    picture = to_png_bytes(compared.comparison(points, ["first", "second"]), 40)
    assert picture.startswith(b"\x89PNG")


@pytest.mark.parametrize("elevation", [5.0, 26.0, 60.0, 90.0])
def test_colours_on_a_surface_read_off_the_key(elevation):
    # Whatever way a facet faces, its colour has the hue of the key's, nearly its lightness, and is never undefined's.
    surface = quintrig.sphere(2.0)
    mesh = scene.mesh_points(surface, 24)
    view = camera.View("", -55.0, elevation)
    everywhere = np.ones(mesh.shape[:2], dtype=bool)
    for share in np.linspace(0.0, 1.0, 21):
        given = np.array(palette.DIVERGING(share)[:3])
        skin = np.broadcast_to(given, (24, 24, 3))
        lit = shade.facets(mesh, view, skin, surface.sign, everywhere, readable=True).fill[:, :3]
        factor = lit / given
        assert np.ptp(factor, axis=1).max() <= 1e-12  # one factor for red, green and blue: the hue stays
        assert factor.min() >= 0.9 - 1e-12
        assert factor.max() <= 1.0 + 1e-12
        assert np.abs(lit - to_rgb(palette.UNDEFINED)).max(axis=1).min() > 0.1


@pytest.mark.parametrize("key", [None, "gaussian"])
def test_a_surface_that_is_one_point_is_drawn_and_said_to_be_one(key):
    surface = quintrig.tensor(np.tile([3.0, 4.0, 5.5], (6, 6, 1)))
    drawn = space_picture(surface, key)
    texts = [text.get_text() for axes in drawn.axes for text in axes.texts]
    assert "(3, 4, 5.5)" in texts
    assert "The surface is a single point, (3, 4, 5.5)" in " ".join(text for text in (*texts, *notes(drawn)))
    assert scene.single_point(quintrig.sphere()) is None


@pytest.mark.parametrize("width", np.linspace(1.5, 9.0, 31))
def test_no_formula_is_broken_at_the_end_of_a_line(width):
    text = "Normal along $S_u{\\times}S_v$; costs 5 \\$ or so; solid line: $K = 0$; dashed line: $H = 0$. More words."
    page = sheet.sheet(1, (width, 1.0), note=text)
    lines = page.figure.texts[0].get_text().splitlines()
    assert " ".join(lines) == text
    assert all(line.replace("\\$", "").count("$") % 2 == 0 for line in lines)


def notes(drawn):
    return [text.get_text().replace("\n", " ") for text in drawn.texts]


def enclosed(corners):
    """Return the signed area within a polygon (n, 2)."""
    (x, y), (a, b) = corners.T, np.roll(corners, -1, axis=0).T
    return 0.5 * float((x * b - a * y).sum())


@pytest.mark.parametrize("view", [*camera.VIEWS.values(), camera.View("", 45.0, 0.0), camera.View("", 17.0, -90.0)])
def test_the_outline_of_a_box_is_the_hull_of_its_corners(view):
    axes = sheet.new_figure(4.0, 3.0).add_axes((0.0, 0.0, 1.0, 1.0))
    stage = frame.set_stage(axes, view, np.array([-1.0, 2.0, 0.0]), np.array([3.0, 3.0, 0.5]), framed=True)
    rim = 3.0 * stage.point
    corners = view.project(np.array(list(product(*zip(stage.low - rim, stage.high + rim, strict=True)))))
    assert enclosed(frame.box_outline(stage)) == pytest.approx(ConvexHull(corners[:, :2]).volume, rel=1e-12)


@pytest.mark.parametrize("turn", [1, -1])
def test_facets_reach_over_their_edges_and_no_farther(turn):
    mesh = np.stack([*np.meshgrid([0.0, 1.0, 3.0], [0.0, 2.0, 2.0]), np.zeros((3, 3))], axis=-1)[::turn]
    paint = shade.facets(mesh, camera.TOP, None, 1, np.ones((3, 3), dtype=bool), rim=0.25)
    whole = paint.corners[np.ptp(paint.corners[..., 1], axis=1) > 1.0]
    assert len(whole) == 2
    assert sorted(abs(enclosed(quad)) for quad in whole) == pytest.approx([1.5 * 2.5, 2.5 * 2.5])
    flat = shade.facets(mesh, camera.TOP, None, 1, np.ones((3, 3), dtype=bool)).corners
    assert np.abs(paint.corners - flat).max() <= 0.5  # also of the two without any area
