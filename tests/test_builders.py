"""Builders: continuity of what they add, by an evaluation of its own, and what they refuse."""

import json

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from measured import seam
from quintrig.builders.strips import blended

CUBIC = "cubic"
SHAPE = [0.4, -1.5, 0.2, -0.7]


def net(x, y, seed=0, tilt=0.0):
    rng = np.random.default_rng(seed)
    a, b = np.meshgrid(20.0 * np.arange(6), 20.0 * np.arange(6), indexing="ij")
    points = np.stack([a, b, 6 * rng.normal(size=(6, 6))], axis=-1)
    c, s = np.cos(tilt), np.sin(tilt)
    return points @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]) + [x, y, 0]


def patch(name, points, shape=SHAPE, **more):
    return {"name": name, "kind": "tensor", "points": np.asarray(points).tolist(), "shape": list(shape), **more}


def model(*patches):
    return quintrig.Model.from_dict({"unit": "mm", "patch": list(patches)})


def apart(second=SHAPE):
    return model(patch("a", net(0, 0, 1)), patch("b", net(160, 0, 2, 0.9), second))


def reached(model, first, second):
    """Largest gap (length), angle (degrees) and relative jump of normal curvature across, by differences of points."""
    return seam(*((model.patch(text.rpartition(":")[0]).surface, text[-2:]) for text in (first, second)))


def check(model, first, second, order, tight=1e-7):
    gap, angle, jump = reached(model, first, second)
    assert gap < 1e-9
    assert order == "G0" or angle < 1e-6
    assert order in ("G0", "G1") or jump < tight


@pytest.mark.parametrize(
    ("order", "second"),
    [("G0", SHAPE), ("G1", SHAPE), ("G2", SHAPE), ("G3", SHAPE), ("G2", [0.9, 0.3, -2.0, 0.5])],
)
def test_a_blend_meets_both_sides(order, second):
    after = quintrig.blend(apart(second), "a:u1", "b:u0", order)
    check(after, "a:u1", "blend:u0", order)
    check(after, "blend:u1", "b:u0", order)
    seams = {one.order for one in after.joins()}
    assert min(seams) >= order
    # The others have not moved, and the strip looks where its neighbours do.
    assert [one.name for one in after.patches] == ["a", "b", "blend"]
    assert not any(one.opposed for one in after.joins())


@pytest.mark.parametrize(("first", "second"), [("a:v1", "b:u0"), ("a:u1", "b:v1"), ("a:v0", "b:v0")])
def test_a_blend_starts_from_any_side(first, second):
    turn = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    after = quintrig.blend(model(patch("a", net(0, 0, 1)), patch("b", net(0, 300, 2) @ turn)), first, second, "G2")
    check(after, first, "blend:u0", "G2")
    check(after, "blend:u1", second, "G2")


def test_a_blend_of_two_planes_is_about_an_arc():
    flat = net(0, 0) * [1, 1, 0]
    right = model(patch("a", flat), patch("b", flat[:, :, [2, 1, 0]] + [150, 0, 50]))
    points = quintrig.blend(right, "a:u1", "b:u0", "G1").patch("blend").surface(np.linspace(0, 1, 50), 0.5)
    away = np.linalg.norm(points[:, [0, 2]] - [100, 50], axis=-1)
    assert 45 < away.min() <= away.max() < 55


def test_what_is_held_follows():
    before = quintrig.blend(apart(), "a:u1", "b:u0", "G2", hold=True)
    after = before.with_patch(before.patch("a").with_parameters({"zeta1": 0.7}))
    check(after, "a:u1", "blend:u0", "G2")
    check(after, "blend:u1", "b:u0", "G2")
    assert np.abs(after.patch("blend").surface.net - before.patch("blend").surface.net).max() > 1e-3


@pytest.mark.parametrize(("order", "side"), [("G0", "u0"), ("G1", "v0"), ("G2", "v1"), ("G3", "u1")])
def test_an_extension_goes_on(order, side):
    after = quintrig.extend(model(patch("a", net(0, 0, 3) * [1, 1, 0.2])), f"a:{side}", 40, order)
    check(after, f"a:{side}", "extension:u0", order)
    new = after.patch("extension").surface
    far = np.linalg.norm(new(1.0, np.linspace(0, 1, 20)) - new(0.0, np.linspace(0, 1, 20)), axis=-1)
    assert 30 < far.mean() < 50


def test_the_extension_of_a_plane_is_its_plane_and_that_of_a_cylinder_bends_as_it_does():
    flat = quintrig.extend(model(patch("a", net(0, 0) * [1, 1, 0])), "a:u1", 40, "G2").patch("extension").surface
    np.testing.assert_allclose(flat(np.linspace(0, 1, 9), 0.3)[:, 2], 0.0, atol=1e-12)
    tube = quintrig.Model.from_dict({"name": "c", "kind": "cylinder", "radius": 10, "height": 20})
    after = quintrig.extend(tube, "c:u1", 5, "G1")
    np.testing.assert_allclose(np.linalg.norm(after.patches[1].surface(1.0, [0.1, 0.6])[:, :2], axis=-1), 10, rtol=1e-9)


def grid(order="G2", **more):
    x, y = np.meshgrid([0, 10, 25, 45, 60.0], [0, 20, 30, 55.0], indexing="ij")
    points = np.stack([x, y, 5 * np.random.default_rng(0).normal(size=x.shape)], axis=-1)
    return points, quintrig.grid_of_patches(points, order, unit="mm", **more)


@pytest.mark.parametrize("order", ["G1", "G2"])
def test_patches_through_a_grid_meet_it_and_each_other(order):
    points, body = grid(order, shape=(0.2, -1.0, 0.5, -2.0))
    assert len(body.patches) == 12
    for i in range(4):
        for j in range(3):
            corners = body.patch(f"p{i + 1}_{j + 1}").surface([0, 1, 0, 1], [0, 0, 1, 1])
            np.testing.assert_allclose(corners, points[[i, i + 1, i, i + 1], [j, j, j + 1, j + 1]], atol=1e-9)
            if i == 1:
                check(body, f"p{i + 1}_{j + 1}:u1", f"p{i + 2}_{j + 1}:u0", order)
            if j == 1:
                check(body, f"p{i + 1}_{j + 1}:v1", f"p{i + 1}_{j + 2}:v0", order)


def test_few_patches_come_near_to_many_points():
    x, y = np.meshgrid(np.linspace(0, 100, 40), np.linspace(0, 80, 30), indexing="ij")
    points = np.stack([x, y, 10 * np.sin(x / 20) * np.cos(y / 30)], axis=-1)
    off = []
    for count in ((1, 1), (2, 2), (5, 4)):
        body = quintrig.grid_of_patches(points, "G2", count)
        assert len(body.patches) == count[0] * count[1]
        spots = np.concatenate([one.surface(*np.random.default_rng(1).random((2, 50))) for one in body.patches])
        off.append(np.abs(spots[:, 2] - 10 * np.sin(spots[:, 0] / 20) * np.cos(spots[:, 1] / 30)).max())
        assert {one.order for one in body.joins()} <= {"G2", "G3"}
    assert off[0] > off[1] > off[2]
    assert off[2] < 0.05


@pytest.mark.parametrize(
    ("points", "words", "message"),
    [
        (np.zeros((3, 3, 3)), {}, "coincide"),
        (np.zeros((1, 3, 3)), {}, "expected a grid of 2 x 2 or more, found 1 x 3"),
        (np.ones((3, 3)), {}, "points"),
        (np.random.default_rng(0).random((3, 3, 3)), {"order": "G0"}, "expected G1 or G2"),
        (np.random.default_rng(0).random((3, 3, 3)), {"patches": (3, 1)}, "patches: expected 1 to 2"),
        (np.random.default_rng(0).random((3, 3, 3)), {"unit": "yd"}, "unit: expected one of"),
        (np.random.default_rng(0).random((3, 3, 3)), {"shape": (-4, 0, 0, 0)}, "stands still"),
    ],
)
def test_what_is_no_grid_is_refused(points, words, message):
    with pytest.raises(ValueError, match=message):
        quintrig.grid_of_patches(points, **words)


HOLE = ("p1_2:u1", "p2_3:v0", "p3_2:u0", "p2_1:v1")


def hole():
    x, y = np.meshgrid([0, 30, 70, 100.0], [0, 40, 70, 100.0], indexing="ij")
    points = np.stack([x, y, 12 * np.sin(x / 40) * np.cos(y / 30)], axis=-1)
    body = quintrig.grid_of_patches(points, unit="mm")
    return quintrig.Model("body", "mm", tuple(one for one in body.patches if one.name != "p2_2"))


@pytest.mark.parametrize(("order", "turn"), [("G0", 0), ("G1", 0), ("G1", 3)])
def test_a_hole_between_smooth_neighbours_is_filled_exactly(order, turn):
    sides = HOLE[turn:] + HOLE[:turn]
    after = quintrig.fill(hole(), *sides, order=order)
    found = [one for one in after.joins() if "fill" in (one.first.patch, one.second.patch)]
    assert len(found) == 4
    for one in found:
        check(after, str(one.first), str(one.second), order)
        assert not one.opposed


def test_a_fill_of_four_curves_has_them_as_its_sides():
    def curve(*ends, bulge, alpha=0.0):
        a, b = np.array(ends, dtype=float)
        middle = np.linspace(0, 1, 6)[:, None]
        return quintrig.Curve((1 - middle) * a + middle * b + 4 * middle * (1 - middle) * np.array(bulge), alpha)

    corners = [(0, 0, 0), (50, 0, 5), (60, 40, 0), (0, 50, 10)]
    curves = [
        curve(corners[0], corners[1], bulge=(0, 0, 8)),
        curve(corners[2], corners[1], bulge=(5, 0, 8), alpha=0.5),
        curve(corners[2], corners[3], bulge=(0, 9, 8), alpha=-2.0),
        curve(corners[3], corners[0], bulge=(-9, 0, 8)),
    ]
    surface = quintrig.fill(curves).surface
    t = np.linspace(0, 1, 11)
    for (u, v), one, way in (((t, 0), 0, t), ((1, t), 1, t[::-1]), ((t, 1), 2, t[::-1]), ((0, t), 3, t[::-1])):
        np.testing.assert_allclose(surface(u, v), curves[one](way), atol=1e-9)
    with pytest.raises(ValueError, match="curves have no tangent planes"):
        quintrig.fill(curves, order="G1")


def test_neighbours_that_do_not_go_together_are_met_as_well_as_may_be():
    rough = [patch(one.name, one.surface.net + np.random.default_rng(k).normal(size=(6, 6, 3)) * _inside())
             for k, one in enumerate(hole().patches)]  # fmt: skip
    angles = {}
    for order in ("G0", "G1"):
        after = quintrig.fill(model(*rough), *HOLE, order=order)
        found = [one for one in after.joins() if "fill" in (one.first.patch, one.second.patch)]
        assert max(one.gap.most for one in found) < 1e-9
        angles[order] = max(one.angle.most for one in found)
    assert angles["G1"] < 0.5 * angles["G0"]


def _inside():
    """Move neither the borders of a patch nor what leaves its corners."""
    mask = np.zeros((6, 6, 1))
    mask[2:4, 1:5] = mask[1:5, 2:4] = 2.0
    return mask


@pytest.mark.parametrize("order", ["G0", "G1", "G2"])
def test_a_cap_closes_a_tube(order):
    tube = quintrig.Model.from_dict({"unit": "mm", "name": "t", "kind": "cylinder", "radius": 20, "height": 30})
    after = quintrig.cap(tube, "t:u1", order=order)
    check(after, "t:u1", "cap:u0", order, tight=1e-6)
    new = after.patch("cap").surface
    top = new(1.0, np.linspace(0, 1, 9))
    np.testing.assert_allclose(top, np.broadcast_to(top[0], top.shape), atol=1e-9)
    np.testing.assert_allclose(top[0, :2], 0.0, atol=1e-9)
    if order != "G0":  # the tangent plane at the top is level
        near = new(1.0 - 1e-5, np.linspace(0, 1, 9))
        assert np.abs((near - top)[:, 2]).max() < 1e-4 * np.linalg.norm(near - top, axis=-1).min()
    high = quintrig.cap(tube, "t:u0", order=order, height=7.0).patch("cap").surface(1.0, 0.5)
    assert high[2] == pytest.approx(-7.0, abs=1e-9)


def test_a_cap_of_several_sides_is_smooth_across_its_seams():
    profile = [[20.0, 0], [20, 10], [19, 20], [17, 30], [16, 40], [15, 50]]
    quarter = {"kind": "swung", "profile": profile, "trajectory": [[1, 0], [1, 0.5], [0.5, 1], [0, 1]]}
    quarter |= {"basis": ["trigonometric", CUBIC]}
    one = quintrig.Model.from_dict({"unit": "mm", "name": "q1", **quarter})
    tube = quintrig.mirror(quintrig.mirror(one, "x=0", "G2"), "y=0", "G2")
    sides = [f"{patch.name}:u1" for patch in tube.patches]
    after = quintrig.cap(tube, *sides, order="G2")
    assert len(after.patches) == 8
    found = [one for one in after.joins() if one.first.patch.startswith("cap")]
    assert len(found) == 4
    for one in found:
        check(after, str(one.first), str(one.second), "G2", tight=1e-6)


@pytest.mark.parametrize(("order", "plane"), [("G0", "x=0"), ("G1", "x=-2.5"), ("G2", "x=0"), ("G2", (1, 0.05, 0, 1))])
def test_halves_meet_smoothly_in_the_plane(order, plane):
    body = quintrig.grid_of_patches(grid()[0], unit="mm")
    after = quintrig.mirror(body, plane, order, near=0.25)
    assert len(after.patches) == 24
    for j in (1, 3):
        check(after, f"p1_{j}:u0", f"p1_{j}_mirror:u0", order)
    # Seams of each half are as they were.
    assert {one.order for one in after.joins() if {one.first.side, one.second.side} != {"u0"}} <= {"G2", "G3"}
    assert not any(one.opposed for one in after.joins())
    if plane == "x=0":
        spot = after.patch("p2_2").surface(0.3, 0.6) * [-1, 1, 1]
        np.testing.assert_allclose(after.patch("p2_2_mirror").surface(0.3, 0.6), spot, atol=1e-12)


@pytest.mark.parametrize("name", ["swept", "swung", "ruled", "symmetric", "developable", "tensor", "classical"])
@pytest.mark.parametrize("plane", ["y=-30", "x=-200", "z=-90", (1, 0, 0, 0)])
def test_images_keep_their_kind(name, plane):
    one = quintrig.load(f"examples/{name}.toml")
    order, turned = "G0", name in ("swung", "classical") and plane in ("y=-30", "x=-200")
    if turned:
        with pytest.raises(ValueError, match="convert=True makes the image a tensor-product patch"):
            quintrig.mirror(one, plane, order)
    after = quintrig.mirror(one, plane, order, near=0.0, convert=turned)
    first, image = after.patches
    assert image.kind == ("tensor" if turned else first.kind)
    u, v = np.random.default_rng(5).random((2, 40))
    axis = "xyz".index(plane[0]) if isinstance(plane, str) else 0
    at = float(plane[2:]) if isinstance(plane, str) else 0.0
    expected = first.surface(u, v)
    expected[:, axis] = 2 * at - expected[:, axis]
    np.testing.assert_allclose(image.surface(u, v), expected, atol=1e-9)


def test_joins_that_hold_are_mirrored_too():
    table = [{"first": "a:u1", "second": "b:u0", "order": "G2"}]
    body = quintrig.Model.from_dict(
        {"unit": "mm", "patch": [patch("a", net(0, 0, 1)), patch("b", net(100, 0, 2))], "join": table}
    )
    after = quintrig.mirror(body, "y=0", "G2")
    assert [one.first for one in after.held] == ["a:u1", "a_mirror:u1"]
    check(after, "a_mirror:u1", "b_mirror:u0", "G2")
    check(after, "b:v0", "b_mirror:v0", "G2")


PAIR = ("a:u1", "b:u0")


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda m: quintrig.blend(m, "a:u1", "a:u1"), "expected two sides to blend"),
        (lambda m: quintrig.blend(m, "a:u2", "b:u0"), "expected PATCH:SIDE"),
        (lambda m: quintrig.blend(m, "c:u1", "b:u0"), "no patch 'c'"),
        (lambda m: quintrig.blend(m, *PAIR, "G4"), "order: expected one of G0, G1, G2, G3"),
        (lambda m: quintrig.blend(m, *PAIR, fullness=0), "fullness: expected a finite number greater than 0"),
        (lambda m: quintrig.extend(m, "a:u1", -1), "length: expected a finite number greater than 0"),
        (lambda m: quintrig.extend(m, "a:u1", float("nan")), "length: expected"),
        (lambda m: quintrig.fill(m, "a:u0", "b:u1"), "expected four sides"),
        (lambda m: quintrig.fill(m, "a:u0", "a:u1", "b:u0", "b:u1"), "expected sides that meet at a corner"),
        (lambda m: quintrig.fill(m, *PAIR, "a:v0", "b:v0", order="G2"), "order: expected one of G0, G1, found 'G2'"),
        (lambda m: quintrig.cap(m, "a:u1"), "expected a closed edge"),
        (quintrig.cap, "expected a closed side"),
        (lambda m: quintrig.mirror(m, "w=0"), "plane: expected x=0"),
        (lambda m: quintrig.mirror(m, (0, 0, 0, 1)), "found a zero normal"),
        (lambda m: quintrig.mirror(m, order="G3"), "order: expected one of G0, G1, G2"),
    ],
)
def test_what_cannot_be_built_is_told(call, message):
    with pytest.raises(ValueError, match=message):
        call(apart())


def test_a_side_that_stands_still_gives_no_way_on():
    still = model(patch("a", net(0, 0, 1), (0, -4, 0, 0)), patch("b", net(160, 0, 2)))
    with pytest.raises(ValueError, match="stands still across this side"):
        quintrig.blend(still, *PAIR)
    assert blended(still, *PAIR, "G0").seams


def test_the_commands_write_models_and_tell_the_seams(tmp_path):
    start, end = tmp_path / "start.toml", tmp_path / "end.toml"
    quintrig.save(apart(), start)
    done = run("blend", start, *PAIR, "--order", "G2", "--hold", "-o", end)
    assert done.code == 0, done.err
    assert "join G2" in done.err
    assert "[[join]]" in end.read_text()
    assert run("blend", start, *PAIR, "-o", start).code == 2
    assert run("extend", end, "b:u1", "--length", 20, "-o", tmp_path / "c.toml").code == 0
    done = run("mirror", end, "--plane", "y=0", "--order", "G2", "-o", tmp_path / "d.toml")
    assert (done.code, done.err.count("join G")) == (0, 3)
    found = json.loads(run("joins", tmp_path / "d.toml", "--json").out)
    assert {one["order"] for one in found["joins"]} <= {"G2", "G3"}
    quintrig.save(hole(), tmp_path / "hole.toml")
    assert "join G1" in run("fill", tmp_path / "hole.toml", *HOLE, "--order", "G1", "-o", tmp_path / "e.toml").err
    (tmp_path / "t.toml").write_text('kind = "cylinder"\nname = "t"\nradius = 5\nheight = 9\n')
    assert run("cap", tmp_path / "t.toml", "t:u0", "-o", tmp_path / "f.toml").code == 0
    np.savetxt(tmp_path / "scan.csv", grid()[0].reshape(-1, 3), delimiter=",")
    done = run("patches", tmp_path / "scan.csv", "--grid", "5x4", "--patches", "1x2", "-o", tmp_path / "g.toml")
    assert done.code == 0, done.err
    assert "off the patches" in done.err
    assert run("patches", tmp_path / "scan.csv", "--grid", "4x4", "-o", tmp_path / "h.toml").code == 2
