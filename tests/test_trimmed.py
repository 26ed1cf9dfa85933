"""Trimmed faces: numbers are those of what the loops hold, against closed forms and OpenCASCADE."""

import json
from dataclasses import replace

import mpmath
import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as cli
from quintrig.analysis.agreement import compare_methods
from quintrig.analysis.integrate import area_means, area_weights, integrals
from quintrig.analysis.summary import summarise
from quintrig.analysis.table import tabulate
from quintrig.developables.unroll import Sheet, unroll
from quintrig.exchange.cad.trim import area
from quintrig.exchange.pattern.flatten import FlattenOptions, export_pattern
from quintrig.exchange.pattern.layout import PatternOptions, bends
from quintrig.figure.scene import Scene, bounds, share_outside
from quintrig.geometry.nurbs import nurbs
from quintrig.geometry.polygon import polygon
from quintrig.report.facts import MARKS, marks_of

PI = np.pi
ROUND = 1e-9  # what is left of a loop's curves in its polygon
SQUARE = [[[10.0 * i, 10.0 * j, 0.0] for j in range(2)] for i in range(2)]


def circle(radius, u=0.5, v=0.5):
    return polygon(
        lambda t: np.stack([u + radius * np.cos(t), v + radius * np.sin(t)], axis=1), np.array([0.0, 2 * PI])
    )


def wave(loops):
    """z = x (1 - x) y over the unit square, as a polynomial."""
    x = [0.0, 0.5, 1.0]
    points = [[[a, b, h * b] for b in (0.0, 1.0)] for a, h in zip(x, (0.0, 0.5, 0.0), strict=True)]
    return nurbs(points, trim=loops)


# ---------------------------------------------------------------------------------------------------------------- loops


@pytest.mark.parametrize("radius", [0.5, 0.25, 0.01])
def test_a_polygon_holds_the_area_of_its_curve(radius):
    loop = circle(radius)
    assert abs(area(loop)) == pytest.approx(PI * radius**2, rel=1e-7 if radius < 0.1 else ROUND)
    away = np.abs(np.hypot(*(loop - 0.5).T) - radius)
    assert away.max() <= 1e-5
    assert loop.min() >= 0.0
    assert loop.max() <= 1.0


def test_a_polygon_follows_a_curve_that_bends_both_ways_and_keeps_its_ends():
    loop = polygon(lambda t: np.stack([t, 0.5 + 0.4 * np.sin(2 * PI * t)], axis=1), np.array([0.0, 1.0]))
    assert loop[0].tolist() == [0.0, 0.5]
    assert loop[-1] == pytest.approx([1.0, 0.5], abs=1e-15)
    assert np.abs(loop[:, 1] - 0.5 - 0.4 * np.sin(2 * PI * loop[:, 0])).max() <= 3e-5
    rest = np.interp(0.25, *loop.T) - 0.9
    assert abs(rest) <= 1e-5


# ------------------------------------------------------------------------------------------------------------ integrals


def test_a_disc_has_the_area_of_a_disc_and_the_whole_on_request():
    surface = nurbs(SQUARE, trim=[circle(0.3)])
    found = integrals(surface)
    assert found.area.value == pytest.approx(9 * PI, rel=ROUND)
    assert found.area.converged
    assert found.region == "trimmed"
    assert any("trimmed" in note for note in found.notes)
    whole = integrals(surface.carrier)
    assert whole.area.value == pytest.approx(100.0, rel=1e-13)
    assert whole.region == "whole"


def test_integrals_over_polygons_are_exact():
    triangle = [[0.1, 0.2], [0.9, 0.3], [0.4, 0.8]]
    hole = [[0.4, 0.4], [0.5, 0.4], [0.5, 0.5], [0.4, 0.5]]
    surface = wave([triangle, hole])

    def over(f):
        """∬ f over the triangle without the hole, by mpmath along straight sides."""
        low = lambda u: 0.2 + (u - 0.1) / 8  # noqa: E731
        left = lambda u: 0.2 + 2 * (u - 0.1)  # noqa: E731
        right = lambda u: 0.8 - (u - 0.4)  # noqa: E731
        part = lambda a, b, top: mpmath.quad(lambda u: mpmath.quad(lambda v: f(u, v), [low(u), top(u)]), [a, b])  # noqa: E731
        return float(part(0.1, 0.4, left) + part(0.4, 0.9, right) - mpmath.quad(f, [0.4, 0.5], [0.4, 0.5]))

    def element(u, v):
        return mpmath.sqrt(1 + ((1 - 2 * u) * v) ** 2 + (u * (1 - u)) ** 2)

    found = integrals(surface)
    assert found.area.value == pytest.approx(over(element), rel=1e-12)
    assert found.thin_plate_energy.value == pytest.approx(
        over(lambda u, v: 4 * v * v + 2 * (1 - 2 * u) ** 2), rel=1e-12
    )
    mean = area_means(surface, ["E"])["E"].value
    first = over(lambda u, v: (1 + ((1 - 2 * u) * v) ** 2) * element(u, v))
    assert mean == pytest.approx(first / over(element), rel=1e-5)


def test_what_is_cut_off_does_no_harm():
    """A spherical zone: the poles, where curvature is undefined, are outside."""
    sphere = quintrig.sphere(2.0)
    from dataclasses import replace

    _u, _v = quintrig.grid(2, 2)
    across = 0 if np.ptp(sphere(np.zeros(5), np.linspace(0, 1, 5)), axis=0).max() < 1e-12 else 1
    band = np.array([[0.25, 0.0], [0.75, 0.0], [0.75, 1.0], [0.25, 1.0]])
    zone = replace(sphere, trim=(band if across == 0 else band[:, ::-1],))
    heights = [zone(*(pair if across == 0 else pair[::-1]))[2] for pair in ((0.25, 0.0), (0.75, 0.0))]
    found = integrals(zone)
    assert found.area.value == pytest.approx(2 * PI * 2.0 * abs(heights[1] - heights[0]), rel=1e-12)
    assert found.undefined == 0.0
    assert not found.cautions
    assert found.bending_energy.value == pytest.approx(found.area.value * 2 / 4.0, rel=1e-11)


def test_shares_count_the_face_alone():
    surface = nurbs(SQUARE, trim=[circle(0.3)])
    u, v = quintrig.grid(65, 65)
    sample = quintrig.analyse(surface, u, v, ("E", "F", "G"))
    weights = area_weights(sample)
    assert weights.sum() == pytest.approx(1.0)
    assert (weights[~surface.inside(u, v)] == 0.0).all()


# ------------------------------------------------------------------------------------------------------------ CAD files


@pytest.fixture(scope="module")
def parts(tmp_path_factory):
    """Faces by name, as read from STEP files made by OpenCASCADE, each with its area and centroid's height there."""
    pytest.importorskip("OCP", reason="the extra 'cad' is not installed")
    from quintrig.exchange.cad import isolated
    from quintrig.exchange.cad.faces import to_model
    from quintrig.exchange.cad.occ import explored, module, quiet

    gp, prim = module("gp"), module("BRepPrimAPI")
    up, side = gp.gp_Dir(0, 0, 1), gp.gp_Dir(1, 0, 0)
    folder = tmp_path_factory.mktemp("parts")

    def cylinder(radius, height, at=(0, 0, 0), along=up):
        return prim.BRepPrimAPI_MakeCylinder(gp.gp_Ax2(gp.gp_Pnt(*at), along), radius, height).Shape()

    def minus(one, other):
        return module("BRepAlgoAPI").BRepAlgoAPI_Cut(one, other).Shape()

    def at(*place):
        return gp.gp_Ax2(gp.gp_Pnt(*place), up)

    shapes = {
        "rod": cylinder(10.0, 20.0),
        "pierced pipe": minus(cylinder(20.0, 60.0), cylinder(5.0, 30.0, (0, 0, 30), side)),
        "pierced cone": minus(
            prim.BRepPrimAPI_MakeCone(at(0, 0, 0), 30.0, 10.0, 40.0).Shape(), cylinder(4.0, 60.0, (0, 0, 20), side)
        ),
        "pierced ball": minus(prim.BRepPrimAPI_MakeSphere(at(0, 0, 0), 10.0).Shape(), cylinder(3.0, 30.0, (0, 0, -15))),
        "pierced ring": minus(
            prim.BRepPrimAPI_MakeTorus(at(0, 0, 0), 30.0, 10.0).Shape(), cylinder(3.0, 60.0, (0, 0, 0), side)
        ),
    }
    found = {}
    with quiet():
        module("STEPControl").STEPControl_Controller.Init_s()
        for name, shape in shapes.items():
            writer = module("STEPControl").STEPControl_Writer()
            writer.Transfer(shape, module("STEPControl").STEPControl_StepModelType.STEPControl_AsIs)
            writer.Write(str(folder / f"{name}.step"))
    for name, shape in shapes.items():
        contents = isolated.read_here(folder / f"{name}.step")
        model = to_model(contents, name)
        assert not any(face.problem or face.note for face in contents.faces)
        for number, (patch, face) in enumerate(zip(model.patches, explored(shape, "FACE"), strict=True)):
            props = module("GProp").GProp_GProps()
            module("BRepGProp").BRepGProp.SurfaceProperties_s(face, props, 1e-10, False)
            found[name, number] = patch.surface, props.Mass()
    return found


def test_areas_of_faces_agree_with_opencascade(parts):
    for name, (surface, expected) in parts.items():
        assert integrals(surface, 1e-8).area.value == pytest.approx(expected, rel=1e-7), name


def test_areas_of_faces_have_their_closed_forms(parts):
    areas = sorted(integrals(surface, 1e-8).area.value for (name, _), (surface, _) in parts.items() if name == "rod")
    assert areas == pytest.approx([100 * PI, 100 * PI, 400 * PI], rel=ROUND)
    wall = max(
        integrals(surface, 1e-8).area.value for (name, _), (surface, _) in parts.items() if name == "pierced pipe"
    )
    hole = mpmath.quad(lambda x: 2 * mpmath.sqrt(25 - x * x) * 20 / mpmath.sqrt(400 - x * x), [-5, 0, 5])
    assert wall == pytest.approx(2 * PI * 20 * 60 - float(hole), rel=1e-8)
    ball = max(
        integrals(surface, 1e-8).area.value for (name, _), (surface, _) in parts.items() if name == "pierced ball"
    )
    assert ball == pytest.approx(2 * PI * 10 * 2 * np.sqrt(100 - 9), rel=1e-8)


# ------------------------------------------------------------------------------------------------------------- extremes


def paraboloid(loops=()):
    """z = x² + y² over [-1, 1]², whose Gaussian curvature is 4 / (1 + 4 r²)²."""
    line = [1.0, -1.0, 1.0]  # x² in Bézier form over [-1, 1]
    x = [-1.0, 0.0, 1.0]
    return nurbs([[[x[i], x[j], line[i] + line[j]] for j in range(3)] for i in range(3)], trim=loops)


def test_extremes_are_those_of_the_face():
    """A ring from r = 0.2 to r = 0.6 about the middle, K from its outer to its inner rim."""
    surface = paraboloid([circle(0.3), circle(0.1)])
    found = quintrig.find_extremes(surface, ["gaussian"])["gaussian"]
    assert found.minimum.value == pytest.approx(4 / (1 + 4 * 0.36) ** 2, rel=1e-4)
    assert found.maximum.value == pytest.approx(4 / (1 + 4 * 0.04) ** 2, rel=1e-4)
    assert np.hypot(*found.maximum.point[:2]) == pytest.approx(0.2, abs=4e-5)
    assert found.minimum.status == found.maximum.status == "attained"
    whole = quintrig.find_extremes(surface.carrier, ["gaussian"])["gaussian"]
    assert whole.maximum.value == pytest.approx(4.0, rel=1e-12)


def test_an_extreme_on_a_straight_side_is_met_exactly():
    side = [[0.6, 0.3], [0.9, 0.3], [0.9, 0.9], [0.6, 0.9]]
    found = quintrig.find_extremes(paraboloid([side]), ["gaussian"])["gaussian"]
    assert found.maximum.value == pytest.approx(4 / (1 + 4 * 0.04) ** 2, rel=2e-8)
    assert (found.maximum.u, found.maximum.v) == pytest.approx((0.6, 0.5), abs=1e-6)
    assert found.minimum.value == pytest.approx(4 / (1 + 4 * 2 * 0.64) ** 2, rel=2e-8)


def test_a_small_face_of_a_large_surface_is_searched_as_finely():
    surface = paraboloid([circle(0.003, 0.7, 0.2)])
    summary = summarise(surface)
    assert summary.integrals.region == "trimmed"
    radius = np.hypot(0.4, 0.6)
    low, high = (4 / (1 + 4 * (radius + turn * 0.006) ** 2) ** 2 for turn in (1, -1))
    assert summary.extremes["gaussian"].minimum.value == pytest.approx(low, rel=1e-4)
    assert summary.extremes["gaussian"].maximum.value == pytest.approx(high, rel=1e-4)
    assert summary.box[1] - summary.box[0] == pytest.approx([0.012, 0.012, 4 * radius * 0.006], rel=2e-3)
    assert [part.name for part in summary.shares["point_type"]] == ["elliptic"]
    assert not summary.warnings
    assert any("trimmed" in note for note in summary.notes)


def test_inside_agrees_with_a_plain_rule():
    rng = np.random.default_rng(3)
    loops = [rng.random((40, 2)), circle(0.3), np.array([[0.1, 0.1], [0.9, 0.1], [0.9, 0.1], [0.5, 0.9]])]
    surface = nurbs(SQUARE, trim=loops)
    u, v = rng.random((2, 3000))
    odd = np.zeros(3000, dtype=bool)
    for loop in loops:
        for (u0, v0), (u1, v1) in zip(loop, np.roll(loop, -1, axis=0), strict=True):
            if v0 != v1:
                odd ^= ((v0 > v) != (v1 > v)) & (u < u0 + (v - v0) / (v1 - v0) * (u1 - u0))
    np.testing.assert_array_equal(surface.inside(u, v), odd)
    assert surface.inside(*circle(0.3)[7])
    assert surface.inside(0.5, 0.1)


# -------------------------------------------------------------------------------------------------------- flat patterns


def tube(loops, flip=False):
    """A quarter of a cylinder of radius 2 and height 5, exact: u around, v along its axis."""
    h = np.sqrt(0.5)
    points = [[[x, y, z] for z in (0.0, 5.0)] for x, y in ((2.0, 0.0), (2.0, 2.0), (0.0, 2.0))]
    return nurbs(points, [[1.0, 1.0], [h, h], [1.0, 1.0]], trim=loops, flip=flip)


def shoelace(loop):
    x, y = loop.T
    return 0.5 * float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())


OUTER = [[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9]]
HOLE = [[0.4, 0.4], [0.6, 0.4], [0.6, 0.7], [0.4, 0.7]]


@pytest.mark.parametrize("flip", [False, True])
def test_a_pattern_has_the_outline_and_the_holes_of_the_face(flip):
    surface = tube([OUTER, HOLE, circle(0.05, 0.2, 0.5)], flip)
    pattern = unroll(surface)
    angle = lambda u: np.arctan2(*surface(u, 0.0)[[1, 0]])  # noqa: E731
    sides = [2.0 * (angle(b) - angle(a)) for a, b in ((0.1, 0.9), (0.4, 0.6))]
    assert [np.ptp(loop, axis=0).max() for loop in pattern.loops[:2]] == pytest.approx([4.0, 1.5], rel=1e-9)
    areas = [abs(shoelace(loop)) for loop in pattern.loops]
    assert areas[:2] == pytest.approx([4.0 * sides[0], 1.5 * sides[1]], rel=1e-7)
    expected = integrals(surface).area.value
    assert pattern.isometry.area == pytest.approx(expected, rel=1e-9)
    assert areas[0] - areas[1] - areas[2] == pytest.approx(expected, rel=1e-6)
    assert pattern.isometry.area_change <= 1e-6
    assert unroll(surface.carrier).loops == ()


def test_a_thick_sheet_has_the_area_of_its_neutral_layer():
    """The sheet lies outside, its neutral layer half of it further out: that of a tube of radius 2.5."""
    surface = tube([OUTER, HOLE])
    for side in ("back", "front"):
        pattern = unroll(surface, Sheet(1.0, 0.5, side))
        factor = pattern.isometry.area / integrals(surface).area.value
        assert min(abs(factor - 1.25), abs(factor - 0.75)) <= 1e-9
        assert pattern.isometry.area_change <= 1e-6


def test_bend_lines_stay_on_the_face_and_add_up_to_its_bend():
    surface = tube([OUTER, HOLE])
    pattern = unroll(surface)
    lines = bends(pattern, 3.0)
    by_place = {bend.t: bend.angle for bend in lines}
    turn = np.degrees(np.ptp([np.arctan2(*surface(u, 0.0)[[1, 0]]) for u in (0.1, 0.9)]))
    assert sum(by_place.values()) == pytest.approx(turn, rel=1e-6)
    for bend in lines:
        length = np.linalg.norm(np.ptp(bend.ends, axis=0))
        pieces = [other for other in lines if other.t == bend.t]
        assert len(pieces) == (2 if 0.4 < bend.t < 0.6 else 1)
        assert length == pytest.approx(4.0 if len(pieces) == 1 else length, rel=1e-5)
        assert sum(np.linalg.norm(np.ptp(other.ends, axis=0)) for other in pieces) == pytest.approx(
            4.0 if len(pieces) == 1 else 2.5, rel=1e-5
        )


def patch_of(surface):
    from types import SimpleNamespace

    return SimpleNamespace(name="wall", surface=surface)


def test_files_hold_the_outline_and_the_holes(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="the extra 'flat' is not installed")
    told = export_pattern(patch_of(tube([OUTER, HOLE])), "mm", tmp_path / "wall.dxf")
    assert any("outline and holes" in line for line in told)
    drawn = [
        e for e in ezdxf.readfile(tmp_path / "wall.dxf").modelspace().query("LWPOLYLINE") if e.dxf.layer == "OUTLINE"
    ]
    areas = sorted(abs(shoelace(np.array([point[:2] for point in line.get_points()]))) for line in drawn)
    assert areas[1] - areas[0] == pytest.approx(integrals(tube([OUTER, HOLE])).area.value, rel=1e-6)
    assert all(line.closed for line in drawn)


def test_a_trimmed_face_that_fits_no_sheet_is_refused(tmp_path):
    options = FlattenOptions(drawing=PatternOptions(stock=(2.0, 3.0)))
    with pytest.raises(ValueError, match="expected one that holds all of a trimmed face"):
        export_pattern(patch_of(tube([OUTER])), "mm", tmp_path / "wall.svg", options)
    fits = FlattenOptions(drawing=PatternOptions(stock=(6.0, 3.0)))
    export_pattern(patch_of(tube([OUTER])), "mm", tmp_path / "wall.svg", fits)


# ----------------------------------------------------------------------------------------- tables, pictures, commands


def model_file(folder, name="face.toml"):
    from quintrig.model.toml import to_toml

    points = [[[0, 0, 0], [0, 10, 0]], [[10, 0, 0], [10, 10, 0]]]
    knots = [[0, 0, 1, 1], [0, 0, 1, 1]]
    keys = {"schema": 1, "name": "disc", "unit": "mm", "kind": "nurbs", "degrees": [1, 1], "knots": knots}
    path = folder / name
    path.write_text(to_toml({**keys, "points": points, "trim": [circle(0.3).tolist()]}))
    return path


def test_a_table_has_values_of_the_face_alone_or_of_the_whole():
    surface = tube([OUTER, HOLE])
    table = tabulate(surface, [0.5, 0.2], [0.5, 0.5], ["mean", "point_type"])
    assert table.region == "trimmed"
    by_key = {column.key: column.values for column in table.columns}
    assert np.isnan(by_key["mean"][0])
    assert abs(by_key["mean"][1]) == pytest.approx(0.25)
    assert by_key["point_type"] == ("undefined", "parabolic")
    assert by_key["x"][0] == pytest.approx(np.sqrt(2.0))
    whole = tabulate(surface, [0.5, 0.2], [0.5, 0.5], ["mean"], whole=True)
    assert abs(np.array({column.key: column.values for column in whole.columns}["mean"])) == pytest.approx(0.25)
    assert whole.region == "whole"


def test_commands_take_the_face_and_the_whole_on_request(tmp_path):
    path = model_file(tmp_path)
    told = cli("check", path)
    assert "area 28.27 mm²" in told.out
    assert "no warnings" in told.out
    assert "area 100 mm²" in cli("check", "--whole", path).out
    for extra, region, value in (((), "trimmed", None), (("--whole",), "whole", 0.0)):
        table = json.loads(cli("table", path, "--at", "0,0", "-q", "gaussian", "-f", "json", *extra).out)
        assert table["region"] == region
        assert table["rows"][0]["gaussian"] == value
    assert cli("flatten", path, tmp_path / "a.svg").code == 0
    assert "28.27" in (tmp_path / "a.svg").read_text()
    assert cli("flatten", path, tmp_path / "b.svg", "--whole").code == 0
    assert "28.27" not in (tmp_path / "b.svg").read_text()


def test_pictures_draw_the_face_alone():
    from quintrig.figure.field import facet_fields
    from quintrig.figure.scene import Scene, bounds

    surface = nurbs(SQUARE, trim=[circle(0.3)])
    low, high = bounds([surface], Scene())
    assert (high - low)[:2] == pytest.approx([6.0, 6.0], abs=1e-3)
    inside = facet_fields([surface], "gaussian", 100)[0].inside
    assert inside.mean() == pytest.approx(PI / 4, abs=0.01)


def test_the_carrier_of_a_patch_is_not_trimmed_in_its_definition_either(tmp_path):
    patch = quintrig.load(model_file(tmp_path)).patches[0]
    whole = patch.carrier
    assert whole.surface.trim == ()
    assert "trim" not in whole.definition.model_dump(exclude_defaults=True)
    again = quintrig.Model.from_dict(quintrig.Model("whole", "mm", (whole,)).to_dict())
    assert again.surface.trim == ()
    assert quintrig.integrals(again.surface).area.value == pytest.approx(100.0, rel=1e-12)


# --------------------------------------------------------------------------------------------------------------- report


@pytest.mark.parametrize("loops", [[circle(0.3)], [circle(0.45), circle(0.2)[::-1]], [circle(0.01, 0.9, 0.2)]])
def test_labelled_points_lie_on_the_face(loops):
    surface = wave(loops)
    marks = marks_of(surface)
    assert [mark.label for mark in marks] == list("ABCDEFGHI")
    u, v = np.array([(mark.u, mark.v) for mark in marks]).T
    assert surface.inside(u, v).all()
    assert len({(mark.u, mark.v) for mark in marks}) == 9
    assert (np.diff(u[[1, 4, 7]]) > 0).all()  # B, E and H stand as on a whole surface
    assert [(m.u, m.v) for m in marks_of(surface.carrier)] == [(m.u, m.v) for m, _ in MARKS]


def test_methods_are_compared_on_the_face_alone():
    """z = x (1 - x) y has K < 0 where x is not 1/2; its lower part y < 1/2 lies in the loop."""
    surface = wave([np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.0, 0.5]])])
    half = compare_methods(surface, 9, 9)
    whole = compare_methods(
        nurbs([[[a, b / 2, h * b / 2] for b in (0.0, 1.0)] for a, h in ((0, 0), (0.5, 0.5), (1, 0))]), 9, 9
    )
    assert half.count == sum(half.counts()) == 81
    assert half.counts() == whole.counts()
    assert half.shares() == pytest.approx(whole.shares(), abs=1e-12)
    disc = compare_methods(wave([circle(0.3)]), 41, 41)
    assert disc.count == sum(disc.counts()) == int(disc.inside.sum()) < 41 * 41
    assert [table.counts.sum() for table in disc.tables] == [disc.count] * 3
    assert sum(disc.shares()) == pytest.approx(1.0)


def test_a_picture_of_a_face_does_not_count_what_its_loops_cut_off_as_not_drawn():
    t = np.linspace(0.0, 2.0 * np.pi, 60, endpoint=False)
    loop = 0.5 + 0.42 * np.stack([np.cos(t), np.sin(t)], axis=-1)
    x, y = np.meshgrid(np.linspace(-1, 1, 6), np.linspace(-1, 1, 6), indexing="ij")
    face = replace(quintrig.tensor(np.stack([x, y, 3.0 * x**4 + 2.0 * y**4], axis=-1)), trim=(loop,))
    assert share_outside([face], bounds([face], Scene())) == 0.0
