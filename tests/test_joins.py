"""Continuity across edges, against closed forms and splits of one surface."""

import json
import time

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from quintrig.geometry.nurbs import nurbs
from quintrig.multipatch.boundary import edges
from quintrig.multipatch.find import find_joins
from quintrig.multipatch.limits import Limits, limits

LIMITS = Limits(1e-6, 1e-3, 1e-4)


def casteljau(points, t):
    """Split a polynomial net along its first axis at t (de Casteljau): the halves are the same surface."""
    left, right = [points[0]], [points[-1]]
    while len(points) > 1:
        points = (1 - t) * points[:-1] + t * points[1:]
        left.append(points[0])
        right.append(points[-1])
    return np.array(left), np.array(right[::-1])


def wavy(seed=1, n=6):
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(n, dtype=float), np.arange(n, dtype=float), indexing="ij")
    return np.stack([x, y, rng.normal(size=(n, n))], axis=-1)


def bezier(points, **options):
    return quintrig.tensor(points, basis="bernstein", **options)


def strip(x, z, width=5.0):
    """A patch straight along y over the polygon (x, z)."""
    net = np.zeros((len(x), 2, 3))
    net[..., 0], net[..., 2] = np.asarray(x)[:, None], np.asarray(z)[:, None]
    net[..., 1] = [0.0, width]
    return net


def only(found):
    assert len(found) == 1
    return found[0]


def test_halves_of_one_polynomial_join_to_third_order():
    join = only(find_joins([bezier(half) for half in casteljau(wavy(), 0.4)], LIMITS))
    assert (join.first.side, join.second.side, join.order, join.reversed) == ("u1", "u0", "G3", False)
    assert join.gap.most < 1e-12
    assert join.angle.most < 1e-10
    assert join.curvature.most < 1e-8
    assert join.rate.most < 1e-6


@pytest.mark.parametrize("first", [0, 1])
@pytest.mark.parametrize("turn", ["none", "u", "v", "uv", "swap"])
def test_neither_direction_nor_flip_nor_order_changes_what_is_measured(turn, first):
    left, right = casteljau(wavy(2), 0.3)
    turned = {"none": right, "u": right[::-1], "v": right[:, ::-1], "uv": right[::-1, ::-1]}
    net = turned.get(turn, right.transpose(1, 0, 2))
    pair = [bezier(left), bezier(net, flip=turn in ("u", "swap"))]
    join = only(find_joins(pair[:: 1 if first == 0 else -1], LIMITS))
    assert join.order == "G3"
    assert join.reversed is (turn in ("v", "uv"))
    # A half turn keeps the normal; one mirrored axis, or a swap, turns it, and the flip turns it back.
    assert join.opposed is (turn == "v")
    reference = only(find_joins([bezier(left), bezier(right)], LIMITS))
    expected = [reference.first_curvature.least, reference.first_curvature.most]
    found = [join.first_curvature.least, join.first_curvature.most]
    sign = -1.0 if join.opposed and first == 1 else 1.0
    np.testing.assert_allclose(sorted(sign * np.array(found)), expected, atol=1e-9)


@pytest.mark.parametrize("degrees", [0.001, 1.0, 30.0, 90.0, 150.0])
def test_a_crease_reads_its_angle(degrees):
    turn = np.radians(degrees)
    flat, bent = strip([0.0, 5.0], [0.0, 0.0]), strip([5.0, 5 + 5 * np.cos(turn)], [0.0, 5 * np.sin(turn)])
    join = only(find_joins([bezier(flat), bezier(bent)], Limits(1e-6, 1e-4, 0.05)))
    assert join.angle.least == pytest.approx(degrees, abs=1e-9)
    assert join.angle.most == pytest.approx(degrees, abs=1e-9)
    assert join.order == "G0"


def cylinder(radius, height=4.0):
    """A quarter of a cylinder about the z axis, exact as NURBS, from (radius, 0, z) towards (0, radius, z)."""
    net = np.zeros((3, 2, 3))
    net[:, :, :2] = radius * np.array([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])[:, None]
    net[..., 2] = [0.0, height]
    return nurbs(net, np.array([1.0, np.sqrt(0.5), 1.0])[:, None] * np.ones((1, 2)))


@pytest.mark.parametrize("radius", [0.5, 2.0, 40.0])
def test_a_cylinder_runs_into_a_tangent_plane_with_a_jump_of_one_over_its_radius(radius):
    plane = np.array([[[radius, -3.0, z] for z in (0.0, 4.0)], [[radius, 0.0, z] for z in (0.0, 4.0)]])
    join = only(find_joins([bezier(plane), cylinder(radius)], LIMITS))
    assert join.order == "G1"
    assert join.difference.most == pytest.approx(1.0 / radius, rel=1e-12)
    assert join.curvature.least == pytest.approx(1.0, abs=1e-12)
    assert not join.sign_change


def test_an_inflection_is_a_jump_of_one_and_told():
    x = np.linspace(0.0, 2.0, 3)
    up, down = strip(x - 2.0, [0.4, 0.0, 0.0]), strip(x, [0.0, 0.0, -0.4])
    join = only(find_joins([bezier(up), bezier(down)], LIMITS))
    assert (join.order, join.sign_change) == ("G1", True)
    assert join.curvature.most == pytest.approx(1.0, abs=1e-12)
    # z = 0.4 (1 - t)², x = 2t - 2: z'' / x'² = 0.8 / 4 at the seam.
    assert join.first_curvature.most == pytest.approx(0.2, rel=1e-12)
    assert join.second_curvature.least == pytest.approx(-0.2, rel=1e-12)


def test_the_rate_of_curvature_tells_second_from_third_order():
    # z = x³ beside z = 0: curvature 0 on both sides, its rate 6 on one.
    cubic, flat = strip([0.0, 1 / 3, 2 / 3, 1.0], [0.0, 0.0, 0.0, 1.0]), strip([-1.0, 0.0], [0.0, 0.0])
    join = only(find_joins([bezier(flat), bezier(cubic)], LIMITS))
    assert join.order == "G2"
    assert join.rate.most == pytest.approx(1.0)


def test_closed_surfaces_meet_themselves():
    sphere = find_joins([quintrig.sphere(2.0)], LIMITS)
    seam = only(sphere)
    assert ({seam.first.side, seam.second.side}, seam.order) == ({"v0", "v1"}, "G3")
    assert seam.first_curvature.most == pytest.approx(-0.5)
    assert {pole.side for pole in sphere.poles} == {"u0", "u1"}
    assert not sphere.free
    torus = find_joins([quintrig.torus(3.0, 1.0)], LIMITS)
    assert [join.order for join in torus] == ["G3", "G3"]
    assert not torus.free


def test_a_junction_of_one_edge_with_two_and_what_is_left_free():
    left, right = casteljau(wavy(3), 0.5)
    low, high = (half.transpose(1, 0, 2) for half in casteljau(right.transpose(1, 0, 2), 0.3))
    found = find_joins([bezier(left), bezier(low), bezier(high)], LIMITS)
    ends = {(join.first.patch, join.second.patch): join for join in found}
    assert set(ends) == {("1", "2"), ("1", "3"), ("2", "3")}
    assert [join.order for join in found] == ["G3"] * 3
    assert (ends["1", "2"].first.start, ends["1", "2"].first.stop) == pytest.approx((0.0, 0.3), abs=1e-7)
    assert (ends["1", "3"].first.start, ends["1", "3"].first.stop) == pytest.approx((0.3, 1.0), abs=1e-7)
    alone = find_joins([bezier(left), bezier(low)], LIMITS)
    rest = [end for end in alone.free if (end.patch, end.side) == ("1", "u1")]
    assert [(end.start, end.stop) for end in rest] == [pytest.approx((0.3, 1.0), abs=1e-7)]


@pytest.mark.parametrize("amount", [0.01, 0.3])
def test_a_seam_torn_open_is_told_with_its_gap(amount):
    left, right = casteljau(wavy(4), 0.5)
    right[0, -1, 2] += amount
    found = find_joins([bezier(left), bezier(right)], LIMITS)
    assert only(found).order == "open"
    assert only(found).gap.most == pytest.approx(amount, rel=0.01)
    assert f"open by {amount}" in found.warnings[0]
    assert len(found.free) == 8


def test_patches_in_a_row_touch_only_their_neighbours():
    strips = [bezier(strip([k, k + 1.0], [0.0, 0.0])) for k in range(6)]
    found = find_joins(strips, LIMITS)
    assert [(join.first.patch, join.second.patch) for join in found] == [(str(k), str(k + 1)) for k in range(1, 6)]
    assert len(found.free) == 14


def trimmed(center, radius, sign):
    """A square in the plane z = 0 with a round hole, or the round plug for it."""
    angle = np.linspace(0.0, 2.0 * np.pi, 201)[:-1]
    circle = center + radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    border = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    loops = [circle] if sign > 0 else [border, circle[::-1]]
    return nurbs([[[0, 0, 0], [0, 10, 0]], [[10, 0, 0], [10, 10, 0]]], trim=loops)


def test_a_plug_joins_the_hole_that_it_was_cut_from():
    found = find_joins([trimmed(0.5, 0.2, -1), trimmed(0.5, 0.2, 1)], LIMITS)
    join = only(found)
    assert join.first.side.startswith("loop")
    assert join.order == "G3"
    assert join.angle.most < 1e-9
    assert len(found.free) == 4  # the border


def test_a_thousand_patches_take_seconds_and_not_the_square():
    def body(n):
        t = np.linspace(0.0, 1.0, 6)
        nets = []
        for i, j in np.ndindex(n, n):
            x, y = np.broadcast_arrays((i + t)[:, None], (j + t)[None, :])
            nets.append(np.stack([x, y, 0.2 * np.sin(x + y)], axis=-1))
        surfaces = [bezier(net) for net in nets]
        start = time.process_time()
        found = find_joins(surfaces, Limits(1e-6, 1e-3, 0.05))
        assert len(found) == 2 * n * (n - 1)
        return time.process_time() - start

    small, large = body(8), body(32)
    assert large < 4.0 * 16 * small  # 16 times the patches; the square would be 256


def test_json_has_the_agreed_form(tmp_path):
    path = tmp_path / "two.json"
    left, right = casteljau(wavy(5), 0.5)
    patches = [
        {"name": name, "kind": "tensor", "basis": "bernstein", "points": net.tolist()}
        for name, net in (("a:x", left), ("b", right))
    ]
    path.write_text(json.dumps({"unit": "mm", "patch": patches}))
    data = json.loads(run("joins", path, "--json").out)
    assert data["unit"] == "mm"
    (join,) = data["joins"]
    assert (join["first"]["patch"], join["first"]["side"]) == ("a:x", "u1")
    assert join["second"] == {"patch": "b", "side": "u0", "from": 0.0, "to": 1.0}
    assert {"reversed", "gap", "angle", "curvature", "curvature_difference", "order"} <= set(join)
    assert join["order"] == "G3"
    assert len(data["free"]) == 6
    table = tmp_path / "seams.csv"
    run("joins", path, "-o", table)
    assert "a:x:u1,b:u0,G3" in table.read_text()
    assert run("joins", path, "-o", tmp_path / "seams.tex").code == 0
    assert r"\toprule" in (tmp_path / "seams.tex").read_text()


def test_poles_are_no_edges():
    alive, poles = edges([quintrig.cone()])
    assert [pole.side for pole in poles] == ["u1"]
    assert len(alive) == 3


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--tolerance", "0"), "tolerance: expected a finite number greater than 0, found 0"),
        (("--angle", "-1"), "angle: expected a finite number greater than 0, found -1"),
        (("--curvature", "nan"), "curvature: expected a finite number greater than 0, found nan"),
        (("--near", "2"), "near: expected a part"),
        (("-o", "seams.xyz"), "expected a name ending in"),
    ],
)
def test_bad_limits_are_told_in_one_line(words, message):
    done = run("joins", "examples/swept.toml", *words)
    assert done.code == 2
    assert message in done.err
    assert done.err.count("\n") == 1


def test_presets_follow_the_unit():
    assert limits("mm").tolerance == 0.01
    assert limits("m").tolerance == pytest.approx(1e-5)
    assert limits("in", preset="class-a").tolerance == pytest.approx(0.001 / 25.4)
    assert limits("", 1000.0).tolerance == pytest.approx(0.01)


def torn(tmp_path, amount=0.3):
    left, right = casteljau(wavy(6), 0.5)
    right[0, -1, 2] += amount
    path = tmp_path / "torn.json"
    patches = [
        {"name": name, "kind": "tensor", "basis": "bernstein", "points": net.tolist()}
        for name, net in (("left", left), ("[b]right", right))
    ]
    path.write_text(json.dumps({"unit": "mm", "patch": patches}))
    return path


def test_check_and_export_warn_of_a_seam_that_is_nearly_closed(tmp_path):
    path, told = torn(tmp_path), "left:u1 and [b]right:u0 are open by 0.3 mm"
    done = run("check", path, "--strict")
    assert done.code == 1
    assert told in done.out
    assert told in run("export", path, tmp_path / "torn.stl").err
    assert run("joins", path, "--strict").code == 1
    assert told in run("joins", path).out
    closed = torn(tmp_path, 0.0)
    assert "open by" not in run("check", closed).out
    assert "1 G3" in run("check", closed).out


def test_every_order_has_a_colour_and_a_seam_lies_where_the_edges_do():
    from quintrig.figure.seams import SEAM_COLOURS, seam_traces
    from quintrig.multipatch.joins import ORDERS

    assert len(set(SEAM_COLOURS.values())) == len(SEAM_COLOURS) == len(ORDERS)
    left, right = (bezier(half) for half in casteljau(wavy(), 0.4))
    (trace,) = seam_traces(find_joins([left, right], LIMITS))
    assert (trace.label, trace.colour) == ("G3 (1 seam)", SEAM_COLOURS["G3"])
    np.testing.assert_allclose(trace.points, left(1.0, np.linspace(0.0, 1.0, 65)), atol=1e-12)


def test_the_picture_of_the_seams_is_written(tmp_path):
    path = tmp_path / "seams.png"
    assert run("joins", torn(tmp_path), "-o", path).code == 0
    assert path.read_bytes().startswith(b"\x89PNG")


def test_a_seam_table_leaves_out_nothing_but_the_smoothest(monkeypatch):
    from quintrig.report import tables

    joins = find_joins([bezier(strip([k, k + 1.0], [0.0, 0.1 * k])) for k in range(6)], LIMITS)
    assert len(tables.seams_table(joins).rows) == len(joins) > 2
    monkeypatch.setattr(tables, "_MOST_SEAMS", 2)
    cut = tables.seams_table(joins)
    assert len(cut.rows) == 2
    assert f"of {len(joins)} seams" in cut.notes[-1]


def test_a_step_file_is_one_shell_across_seams_that_count_as_closed(tmp_path):
    path = torn(tmp_path, 0.008)
    (seam,) = quintrig.load(path).joins()
    assert 0.005 < seam.gap.most < 0.01
    assert seam.order != "open"
    done = run("export", path, tmp_path / "torn.step")
    assert done.code == 0
    assert "1 shared edges" in done.err
