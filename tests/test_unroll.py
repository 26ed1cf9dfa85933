"""Flat patterns: isometry against closed forms and independent measures, refusals, and drawings others read."""

import os
import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import quintrig
import shapes
from quintrig.developables.unroll import Sheet, unroll
from quintrig.exchange.pattern.drawing import LAYERS
from quintrig.exchange.pattern.flatten import PATTERN_SUFFIXES, FlattenOptions, export_pattern, overlaps
from quintrig.exchange.pattern.layout import PatternOptions, bends, drawing, parts
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.errors import QuintrigError

if not os.environ.get("CI"):
    pytest.importorskip("ezdxf", reason="needs the extra flat: pip install 'quintrig[flat]'")


def cylinder_by_net():
    """A ruled surface that happens to be developable: two equal curves, the second moved along one direction."""
    return quintrig.ruled(shapes.CURVE, shapes.CURVE + np.array([0.5, 0, 4.0]), (0.5, -1, 0.5, -1))


def cone_by_net():
    """A ruled surface that happens to be developable: a curve and the same curve shrunk towards an apex."""
    apex = np.array([4.0, 1.0, 12.0])
    return quintrig.ruled(shapes.CURVE, apex + 0.4 * (shapes.CURVE - apex), (1, 0, 1, 0))


STRIPS = shapes.developables() | {
    "cylinder by net": cylinder_by_net(),
    "cone by net": cone_by_net(),
    "cylinder": quintrig.cylinder(),
    "cone": quintrig.cone(),
}


@pytest.mark.parametrize("name", STRIPS)
def test_nothing_is_stretched(name):
    surface = STRIPS[name]
    pattern = unroll(surface, chord=1e-7 * surface.size)
    assert pattern.isometry.worst <= 1e-9
    # Independently: lengths of polygons through many points of the surface and of the pattern agree.
    for flat, space in zip((pattern.first, pattern.second), boundaries(surface, pattern, 5001), strict=True):
        ours, theirs = (np.linalg.norm(np.diff(points, axis=0), axis=1).sum() for points in (flat, space))
        assert abs(ours - theirs) <= 1e-5 * surface.size
    lengths = [
        np.linalg.norm(b - a, axis=1) for a, b in ((pattern.first, pattern.second), boundaries(surface, pattern))
    ]
    np.testing.assert_allclose(lengths[0], lengths[1], rtol=1e-10)


def boundaries(surface, pattern, count=0):
    """Points of both boundaries, at the pattern's own parameters or at ``count`` equal steps."""
    t = np.linspace(0, 1, count) if count else pattern.t
    return [surface(*((t, 0 * t + end) if pattern.along == "u" else (0 * t + end, t))) for end in (0.0, 1.0)]


@pytest.mark.parametrize("name", STRIPS)
def test_area_is_that_of_a_fine_mesh(name):
    from quintrig.mesh.triangulate import mesh

    surface = STRIPS[name]
    result = mesh([surface], grid=(2, 1501) if name in ("cylinder", "cone") else (1501, 12))
    a, b, c = np.moveaxis(result.points[result.triangles], 1, 0)
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    assert unroll(surface).isometry.area == pytest.approx(area, rel=2e-5)


def test_cylinder_is_its_rectangle_and_cone_its_sector():
    pattern = unroll(quintrig.cylinder(2.0, 5.0))
    edges = np.linalg.norm(np.diff(pattern.first, axis=0), axis=1)
    assert edges.sum() == pytest.approx(4 * np.pi, rel=1e-12)
    assert np.degrees(pattern.bend[-1]) == pytest.approx(360, rel=1e-12)
    cone = unroll(quintrig.cone(3.0, 4.0))  # slant 5: a sector of radius 5 and 2π 3/5
    apex = cone.second[0]
    np.testing.assert_allclose(cone.second - apex, 0, atol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(cone.first - apex, axis=1), 5, rtol=1e-12)
    angle = np.unwrap(np.arctan2(*(cone.first - apex).T[::-1]))
    assert abs(angle[-1] - angle[0]) == pytest.approx(2 * np.pi * 3 / 5, rel=1e-10)


def test_rigid_motion_and_scale_move_the_pattern_alike():
    from scipy.spatial.transform import Rotation

    turn = Rotation.from_rotvec([0.3, -0.5, 1.1]).as_matrix()
    one = unroll(cone_by_net(), chord=1e-3)
    apex = np.array([4.0, 1.0, 12.0])
    a, b = shapes.CURVE, apex + 0.4 * (shapes.CURVE - apex)
    shift = np.array([100.0, -50.0, 3.0])
    two = unroll(quintrig.ruled(7 * a @ turn.T + shift, 7 * b @ turn.T + shift, (1, 0, 1, 0)), chord=7e-3)
    np.testing.assert_allclose(two.second[-1] - two.first[0], 7 * (one.second[-1] - one.first[0]), rtol=1e-10)
    np.testing.assert_allclose(two.bend[-1], one.bend[-1], rtol=1e-10)


def test_pattern_is_seen_from_the_side_of_the_normal():
    """Mirroring happens with the normal: the pattern of the flipped strip is the mirror image."""
    up, down = (unroll(quintrig.developable(shapes.planes(), shapes.OBLIQUE, flip=flip)) for flip in (False, True))
    np.testing.assert_allclose(down.first * [1, -1], up.first, atol=1e-11)
    assert (up.upward != down.upward).all()
    # A quarter pipe with its normal outwards bends away from whoever looks at the outside.
    assert not unroll(quintrig.cylinder()).upward.any()


@pytest.mark.parametrize(("side", "radius"), [("middle", 2 - 0.5 + 0.3), ("back", 2 + 0.3), ("front", 2 - 1 + 0.3)])
def test_neutral_layer_of_a_bent_sheet_has_the_length_of_its_radius(side, radius):
    """A pipe of radius 2 with the normal outwards, sheet 1 thick, k = 0.3 from the inside of the bend."""
    pattern = unroll(quintrig.cylinder(2.0, 5.0), Sheet(1.0, 0.3, side))
    assert pattern.isometry.first == pytest.approx(2 * np.pi * radius, rel=1e-12)
    inwards = unroll(
        quintrig.cylinder(2.0, 5.0, flip=True), Sheet(1.0, 0.3, {"back": "front", "front": "back"}.get(side, side))
    )
    assert inwards.isometry.first == pytest.approx(2 * np.pi * radius, rel=1e-12)


def test_bend_angles_add_up_to_the_turn_of_the_normal():
    surface = STRIPS["developable"]
    pattern = unroll(surface)
    lines = bends(pattern, 5.0)
    ends = surface.partials([0.0, 1.0], 0.5, 1)
    normal = np.cross(ends[1, 0], ends[0, 1])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    total = np.degrees(np.arccos(normal[0] @ normal[1]))
    assert sum(line.angle for line in lines) == pytest.approx(np.degrees(pattern.bend[-1]), rel=1e-9)
    # The normals turn about changing axes, so their end-to-end angle is at most the sum.
    assert total <= np.degrees(pattern.bend[-1]) <= 1.2 * total
    assert max(line.angle for line in lines) <= 5.0


def test_a_strip_that_bends_both_ways_has_both_kinds_of_line():
    wave = np.array([[0, 0, 0], [1, 3, 0], [3, 4, 0], [6, -4, 0], [8, -3, 0], [9, 0, 0.0]])
    pattern = unroll(quintrig.ruled(wave, wave + np.array([0, 0, 5.0])))
    kinds = {line.upward for line in bends(pattern, 5.0)}
    assert kinds == {True, False}
    assert pattern.isometry.worst <= 1e-9


REFUSED = {
    "ruled": (shapes.rational()["ruled"], r"not developable: .* change by 8\.5 % and 7\.81 % .* turns by up to 89\.9°"),
    "tensor": (shapes.rational()["tensor"], "no straight rulings: its lines bend by"),
    "sphere": (quintrig.sphere(), "no straight rulings"),
    "helicoid": (quintrig.helicoid(), "not developable"),
    "nearly": (shapes.rational()["ruled half lowered"], "not developable"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_others_are_refused_with_the_measured_distortion(name):
    surface, message = REFUSED[name]
    with pytest.raises(ValueError, match=message):
        unroll(surface)


def test_small_distortion_is_allowed_when_asked_for():
    pattern = unroll(shapes.rational()["ruled half lowered"], allowed=1e-3)
    assert 1e-9 < pattern.isometry.worst <= 1e-3


def test_edge_of_regression_inside_is_an_error_that_names_where():
    planes = shapes.planes(0.9)
    strip = quintrig.developable(planes, [[0, 0, 1, -5], [0, 0, 1, -13.5]], (0.5, -1.0))
    found = quintrig.regression(strip)
    assert found.intervals
    with pytest.raises(ValueError, match=r"edge of regression lies inside the strip for u = ") as caught:
        unroll(strip)
    told = [float(word) for word in re.findall(r"[\d.]+ to [\d.]+", str(caught.value))[0].split(" to ")]
    np.testing.assert_allclose(told, found.intervals[0], atol=2e-3)


def strip_patch(scale=100.0):
    planes = shapes.planes(0.3, 110.0) * [1, 1, 1, scale]
    return Patch(
        "duct & <cover>", None, quintrig.developable(planes, [[0, 0, 1, 0], [0.1, 0.05, 1, -5 * scale]], (0.5, -1))
    )


def test_parts_fit_the_stock_and_join_up_again():
    pattern = unroll(strip_patch().surface)
    options = PatternOptions(5.0, (900.0, 700.0), 10.0)
    pieces = parts(pattern, bends(pattern, 5.0), options)
    assert len(pieces) > 1
    assert pieces[0].start == 0
    assert pieces[-1].end == 1
    for piece in pieces:
        box = np.sort(np.ptp(np.concatenate([piece.first, piece.second]), axis=0))
        assert (box <= [680 + 1e-6, 880 + 1e-6]).all()
    for left, right in pairwise(pieces):
        assert left.end == right.start
        joint = [np.linalg.norm(p.second[k] - p.first[k]) for p, k in ((left, -1), (right, 0))]
        assert joint[0] == pytest.approx(joint[1], rel=1e-12)
    lengths = sum(np.linalg.norm(np.diff(p.first, axis=0), axis=1).sum() for p in pieces)
    assert lengths == pytest.approx(pattern.isometry.first, rel=1e-4)
    assert sum(len(p.bends) for p in pieces) == len(bends(pattern, 5.0))


def test_a_sheet_too_small_for_a_ruling_is_refused():
    with pytest.raises(ValueError, match="holds a ruling of"):
        parts(unroll(strip_patch().surface), (), PatternOptions(5.0, (300.0, 200.0)))


def dxf_of(tmp_path, options=None, unit="mm"):
    import ezdxf

    path = tmp_path / "p.dxf"
    export_pattern(strip_patch(), unit, path, options)
    return ezdxf.readfile(path)


def test_dxf_audit_is_clean_with_layers_units_outline_and_dimensions(tmp_path):
    document = dxf_of(tmp_path, FlattenOptions(Sheet(2.0, 0.4), PatternOptions(5.0, (900.0, 700.0), 10.0)))
    assert not document.audit().errors
    assert not document.audit().fixes
    assert document.header["$INSUNITS"] == 4
    assert set(LAYERS) <= {layer.dxf.name for layer in document.layers}
    space = document.modelspace()
    outlines = space.query('LWPOLYLINE[layer=="OUTLINE"]')
    assert len(outlines) == 2
    assert all(line.closed for line in outlines)
    pattern = unroll(strip_patch().surface, Sheet(2.0, 0.4))
    area = 0.0
    for line in outlines:
        x, y = np.array(line.get_points("xy")).T
        area += 0.5 * abs((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())
    assert area == pytest.approx(pattern.isometry.area, rel=1e-5)
    lines = bends(pattern, 5.0)
    assert len(space.query('LWPOLYLINE[layer=="BEND_DOWN"]')) == len(lines)
    assert len(space.query("DIMENSION")) == 4
    marks = [text.dxf.text for text in space.query('TEXT[layer=="MARKS"]')]
    assert marks == ["1"] * 4


@pytest.mark.parametrize(("unit", "code", "millimetres"), [("in", 1, 25.4), ("mm", 4, 1.0), ("", 0, 1.0)])
def test_scale_is_true_in_every_unit(unit, code, millimetres, tmp_path):
    assert dxf_of(tmp_path, None, unit).header["$INSUNITS"] == code
    page = drawing(unroll(strip_patch(1.0).surface), "p", unit, PatternOptions())
    for suffix in ("svg", "pdf"):
        export_pattern(strip_patch(1.0), unit, tmp_path / f"p.{suffix}")
    text = (tmp_path / "p.svg").read_text()
    width, height = (float(x) for x in re.search(r'width="([\d.]+)mm" height="([\d.]+)mm"', text).groups())
    np.testing.assert_allclose([width, height], millimetres * (page.high - page.low), rtol=1e-6)
    outline = re.search(r'<g id="OUTLINE".*?<polygon points="([^"]+)"', text, re.DOTALL).group(1)
    points = np.array([[float(x) for x in pair.split(",")] for pair in outline.split()])
    x, y = points.T
    area = 0.5 * abs((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())
    assert area == pytest.approx(unroll(strip_patch(1.0).surface).isometry.area * millimetres**2, rel=1e-4)
    box = re.search(rb"/MediaBox \[ ?0 0 ([\d.]+) ([\d.]+) ?\]", (tmp_path / "p.pdf").read_bytes())
    np.testing.assert_allclose([float(x) for x in box.groups()], np.array([width, height]) / 25.4 * 72, rtol=1e-4)


def test_svg_is_well_formed_whatever_the_name(tmp_path):
    from xml.etree import ElementTree

    path = tmp_path / "p.svg"
    export_pattern(strip_patch(), "mm", path)
    root = ElementTree.parse(path).getroot()
    words = " ".join(text for text in root.itertext())
    assert "duct & <cover>" in words
    assert "scale 1:1" in words


def test_notes_print_the_isometry(tmp_path):
    notes = "\n".join(export_pattern(strip_patch(), "mm", tmp_path / "p.svg"))
    for word in ("boundary 1: ", "boundary 2: ", "rulings: changed by", "area: "):
        assert word in notes
    changes = [float(word) for word in re.findall(r"changed by (?:at most )?(\S+)", notes)]
    assert len(changes) == 4
    assert max(changes) <= 1e-9


def test_a_pattern_over_itself_is_told():
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
    assert not overlaps(square)
    assert overlaps(square[[0, 2, 1, 3]])


def sector(degrees, inner=0.0, grows=0.0, n=300):
    """A sector of a ring as a pattern has it: both its boundaries, the inner one a point for a whole cone."""
    angle = np.radians(np.linspace(0, degrees, n))
    arc = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    wider = (1 + grows * angle)[:, None]
    rng = np.random.default_rng(0)
    return np.concatenate([wider * arc, (inner * wider * arc + 1e-16 * rng.normal(size=arc.shape))[::-1]])


@pytest.mark.parametrize("inner", [0.0, 0.3])
@pytest.mark.parametrize(("degrees", "over"), [(36, 0), (161, 0), (255, 0), (359.9, 0), (360, 0), (365, 1), (700, 1)])
def test_a_sector_lies_over_itself_beyond_a_full_turn(degrees, over, inner):
    assert overlaps(sector(degrees, inner)) == bool(over)
    assert overlaps(sector(degrees, inner)[::-1]) == bool(over)
    if degrees != 360:  # a spiral's ends cross
        assert overlaps(sector(degrees, inner, 1e-3)) == bool(over)


def turned_cone(radius, height, turns):
    """A cone around the z axis from z = 0 to its apex, wound ``turns`` times, as NURBS of arcs of a third of a turn."""
    spans = round(3 * turns)
    angle = np.pi / 3 * np.arange(2 * spans + 1)
    weights = np.where(np.arange(len(angle)) % 2, 0.5, 1.0)
    ring = np.stack([np.cos(angle) / weights, np.sin(angle) / weights, 0 * angle], axis=-1) * radius
    points = np.stack([ring, np.broadcast_to([0.0, 0.0, height], ring.shape)], axis=1)
    knots = np.repeat(np.arange(spans + 1.0), 2)
    keys = {"degrees": [2, 1], "points": points.tolist(), "weights": np.stack([weights, weights], 1).tolist()}
    keys["knots"] = [[0.0, *knots.tolist(), float(spans)], [0, 0, 1, 1]]
    return Model.from_dict({"kind": "nurbs", "name": "cone", **keys}).patch()


@pytest.mark.parametrize(("radius", "height"), [(5, 50), (2, 4), (1, 1), (3, 4), (10, 1), (0.1, 10)])
@pytest.mark.parametrize("turns", [1, 2])
def test_only_cones_that_lie_over_themselves_are_said_to(radius, height, turns, tmp_path):
    over = 360 * turns * radius / np.hypot(radius, height) > 360
    once = Patch("cone", None, quintrig.cone(radius, height))
    for patch in (turned_cone(radius, height, turns), once):
        notes = " ".join(export_pattern(patch, "mm", tmp_path / "cone.svg"))
        assert ("overlaps itself" in notes) == (over and patch is not once)


def test_a_pattern_split_into_parts_no_longer_lies_over_itself(tmp_path):
    patch = turned_cone(1, 1, 2)
    assert "overlaps itself" in " ".join(export_pattern(patch, "mm", tmp_path / "whole.svg"))
    options = FlattenOptions(drawing=PatternOptions(stock=(1.6, 3.0)))
    assert "overlaps itself" not in " ".join(export_pattern(patch, "mm", tmp_path / "parts.svg", options))


@pytest.mark.parametrize("far", [1e4, 1e6, 1e9])
def test_far_from_the_origin_the_pattern_is_the_same(far, tmp_path):
    near, there = (
        quintrig.ruled(shapes.CURVE + k, shapes.CURVE + np.array([0.5, 0, 4.0]) + k, (0.5, -1, 0.5, -1))
        for k in (0.0, far)
    )
    patterns = [unroll(surface, chord=1e-3) for surface in (near, there)]
    lengths = [np.linalg.norm(pattern.first[-1] - pattern.first[0]) for pattern in patterns]
    assert abs(lengths[1] - lengths[0]) <= 32 * np.spacing(far)
    assert abs(patterns[1].isometry.area - patterns[0].isometry.area) <= 32 * np.spacing(far) * near.size
    notes = " ".join(export_pattern(Patch("far", None, there), "mm", tmp_path / "far.svg"))
    assert ("from the origin" in notes) == (far > 1e4)


def test_far_from_the_origin_what_is_not_developable_is_still_refused():
    net = shapes.CURVE + np.array([0, 0, 4.0]) + np.linspace(0, 1, 6)[:, None] * [0, 0.1, 0]
    with pytest.raises(ValueError, match="not developable"):
        unroll(quintrig.ruled(shapes.CURVE + 1e6, net + 1e6))


def test_wrong_suffix_options_and_targets(tmp_path):
    with pytest.raises(QuintrigError, match=r"expected a file ending in \.dxf, \.svg, \.pdf"):
        export_pattern(strip_patch(), "mm", tmp_path / "p.png")
    with pytest.raises(ValueError, match="k-factor: expected 0 to 1"):
        Sheet(1.0, 1.5)
    with pytest.raises(ValueError, match="thickness"):
        Sheet(-1.0)
    with pytest.raises(ValueError, match="greater than its margins"):
        PatternOptions(5.0, (10.0, 10.0), 5.0)
    (tmp_path / "p.dxf").mkdir()
    for suffix in PATTERN_SUFFIXES:
        target = tmp_path / "folder" / f"p{suffix}"
        export_pattern(strip_patch(), "mm", target)
        assert target.stat().st_size > 1000
    with pytest.raises(QuintrigError, match="found a folder"):
        export_pattern(strip_patch(), "mm", tmp_path / "p.dxf")
    assert not [name for name in Path(tmp_path).iterdir() if name.name.startswith(".")]
