"""Patches moved to join: the order measured by an evaluation of its own, the least change, and what is refused."""

import json
import math

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from quintrig.multipatch.attach import attach

EDGE = [0.3, -2.0]


def net(start, seed, n=6, m=6):
    x, y = np.meshgrid(start + 100 / (n - 1) * np.arange(n), 100 / (m - 1) * np.arange(m), indexing="ij")
    return np.stack([x, y, 10 * np.random.default_rng(seed).normal(size=(n, m))], axis=-1)


def tensor(name, points, shape=(0, 0, 0, 0), **more):
    return {"name": name, "kind": "tensor", "points": np.asarray(points).tolist(), "shape": list(shape), **more}


def model(*patches):
    return quintrig.Model.from_dict({"unit": "mm", "patch": list(patches)})


def pair(side1="u1", side2="u0", reverse=False, shape1=(0.5, -1.0), shape2=(-0.5, 0.7)):
    """Two patches whose neighbouring edges are the sides named, with the same functions along both."""
    a, b = net(0.0, 1), net(100.0, 2)
    if reverse:
        b = b[:, ::-1]
    along = EDGE[::-1] if reverse else EDGE
    shapes = [[*shape1, *EDGE], [*shape2, *along]]
    nets = []
    for plain, side, shape, own in ((a, side1, shapes[0], "u1"), (b, side2, shapes[1], "u0")):
        points = plain
        if side[1] != own[1]:
            points, shape[:2] = points[::-1], shape[1::-1]
        if side[0] == "v":
            points, shape[:] = points.transpose(1, 0, 2), [*shape[2:], *shape[:2]]
        nets.append(points)
    return model(tensor("a", nets[0], shapes[0]), tensor("b", nets[1], shapes[1]))


def across(surface, side, t, order):
    """Derivatives across a side towards growing distance from it on its far side or into the patch, by differences.

    Independent of the partials: a polynomial of degree 12 through points of the line across, on one side of the edge.
    """
    k, fixed = "uv".index(side[0]), float(side[1])
    h = 0.5 * (1 - np.cos(np.pi * np.arange(17) / 16)) * 0.15
    s = fixed + (1 - 2 * fixed) * h
    u, v = (s, np.full_like(s, t)) if k == 0 else (np.full_like(s, t), s)
    points = surface(u, v)
    powers = np.polynomial.polynomial.polyvander(h / 0.15, 16)
    coefficients = np.linalg.solve(powers, points)
    return [math.factorial(i) * coefficients[i] / 0.15**i for i in range(order + 1)]


@pytest.mark.parametrize("order", ["G0", "G1", "G2", "G3"])
@pytest.mark.parametrize(
    ("side1", "side2", "reverse"),
    [("u1", "u0", False), ("u0", "u1", True), ("v1", "u0", False), ("v0", "v1", True)],
)
@pytest.mark.parametrize("both", [False, True])
def test_each_order_is_reached_along_every_pair_of_sides(order, side1, side2, reverse, both):
    before = pair(side1, side2, reverse)
    done = attach(before, f"a:{side1}", f"b:{side2}", order, both=both)
    seam = done.join
    assert done.exact
    assert seam.order == order
    assert seam.reversed is reverse
    assert seam.gap.most < 1e-10
    assert order == "G0" or seam.angle.most < 1e-6
    assert order in ("G0", "G1") or seam.curvature.most < 1e-8
    assert order != "G3" or seam.rate.most < 1e-6
    unmoved = np.array_equal(done.model.patch("a").surface.net, before.patch("a").surface.net)
    assert unmoved is not both


def test_the_chain_rule_holds_by_differences_of_points():
    done = attach(pair(), "a:u1", "b:u0", "G2", 0.8)
    a, b = (done.model.patch(name).surface for name in "ab")
    mus = []
    for t in (0.0, 0.37, 1.0):
        p, q = across(a, "u1", t, 2), across(b, "u0", t, 2)
        np.testing.assert_allclose(q[0], p[0], atol=1e-9)
        np.testing.assert_allclose(q[1], -0.8 * p[1], atol=1e-5)
        rest = q[2] - 0.64 * p[2]
        mus.append(float(rest @ p[1] / (p[1] @ p[1])))
        np.testing.assert_allclose(rest, mus[-1] * p[1], atol=1e-3)
    assert np.ptp(mus) < 1e-4  # one μ along the whole edge


def test_third_order_of_the_quintic_needs_its_own_mu():
    kappa = 0.6
    done = attach(pair(), "a:u1", "b:u0", "G3", kappa)
    a, b = (done.model.patch(name).surface for name in "ab")
    p, q = (s.partials(u, 0.4, 2)[:, 0] for s, u in ((a, 1.0), (b, 0.0)))
    rest = q[2] - kappa**2 * p[2]
    mu = float(rest @ p[1] / (p[1] @ p[1]))
    assert mu == pytest.approx(-2 * np.pi / 3 * kappa * (1 + kappa), rel=1e-9)


def test_the_first_rows_are_those_of_the_formula_and_no_others_move():
    kappa, zeta, alpha = 0.6, -1.0, -0.5
    before = pair()
    after = quintrig.join(before, "a:u1", "b:u0", "G1", kappa)
    p, q = (after.patch(name).surface.net for name in "ab")
    np.testing.assert_allclose(q[0], p[5], atol=1e-11)
    np.testing.assert_allclose(q[1], p[5] + kappa * (4 + zeta) / (4 + alpha) * (p[5] - p[4]), atol=1e-10)
    np.testing.assert_array_equal(q[2:], before.patch("b").surface.net[2:])


def test_the_ratio_chosen_is_the_one_of_least_change():
    best = attach(pair(), "a:u1", "b:u0", "G1")
    for factor in (0.95, 1.05):
        assert attach(pair(), "a:u1", "b:u0", "G1", factor * best.ratio).moved > best.moved


def test_what_joins_already_stays():
    once = quintrig.join(pair(), "a:u1", "b:u0", "G2", 1.0)
    again = attach(once, "a:u1", "b:u0", "G2", 1.0)
    assert again.moved < 1e-9


def test_different_functions_along_the_edge_are_met_by_least_squares_and_told():
    a, b = tensor("a", net(0, 1), (0, 0, 0.3, -2)), tensor("b", net(100, 2), (0, 0, -1, 0.5))
    done = attach(model(a, b), "a:u1", "b:u0", "G1")
    assert not done.exact
    assert "same shape parameters" in done.notes[0]
    # The best fit of the one edge in the functions of the other, to the corners:
    assert 0.01 < done.join.gap.most < 1.0


@pytest.mark.parametrize("order", ["G0", "G1", "G2", "G3"])
@pytest.mark.parametrize("n", [4, 5, 7])
def test_bernstein_patches_of_any_degree_join(order, n):
    a, b = (tensor(name, net(x, k, n, 5), basis="bernstein") for name, x, k in (("a", 0, 1), ("b", 100, 2)))
    if n <= int(order[1]):
        with pytest.raises(ValueError, match="raise the degree"):
            quintrig.join(model(a, b), "a:u1", "b:u0", order)
        return
    done = attach(model(a, b), "a:u1", "b:u0", order)
    assert done.join.order == order
    assert done.exact


def test_a_patch_joins_to_a_reference_surface():
    cylinder = {"name": "a", "kind": "cylinder", "radius": 50.0, "height": 100.0}
    done = attach(model(cylinder, tensor("b", net(100, 2))), "a:u1", "b:u0", "G2", 1.0)
    assert not done.exact  # the quintic has no exact circle
    assert done.join is None or done.join.gap.most < 10.0


SWEPT = {
    "kind": "swept",
    "section": [[20 * i, 0, z] for i, z in enumerate((0, 10, 30, 30, 10, 0))],
    "trajectory": [[0, 20 * i, z] for i, z in enumerate((0, 14, 38, 42, 18, 4))],
}


@pytest.mark.parametrize("order", ["G0", "G1", "G2", "G3"])
def test_swept_patches_stay_swept(order):
    second = SWEPT | {"name": "b", "section": [[100 + 22 * i, 3, i * i] for i in range(6)]}
    done = attach(model(SWEPT | {"name": "a"}, second), "a:u1", "b:u0", order)
    assert done.model.patch("b").kind == "swept"
    assert (done.exact, done.join.order) == (True, order)


def test_what_cannot_stay_of_its_kind_says_so_and_is_made_a_tensor_patch_on_request():
    two = model(tensor("a", net(0, 1)), SWEPT | {"name": "b", "section": [[100 + 20 * i, 0, 0] for i in range(6)]})
    with pytest.raises(ValueError, match="convert=True"):
        quintrig.join(two, "a:u1", "b:u0", "G1")
    done = attach(two, "a:u1", "b:u0", "G1", convert=True)
    assert done.model.patch("b").kind == "tensor"
    assert done.join.order == "G1"


PLANES = [[-1, 0.2, 1, -110], [-0.8, 0.1, 1, -90], [-0.35, -0.05, 1, -60], [0.35, -0.05, 1, -60], [0.8, 0.1, 1, -90]]


def developable(name, planes, shape=(0, 0)):
    bounds = [[0, 1, 0, 0], [0, 1, 0, -100]]
    return {"name": name, "kind": "developable", "planes": planes, "bounds": bounds, "shape": list(shape)}


@pytest.mark.parametrize("order", ["G1", "G2"])
def test_developable_strips_join_by_their_planes_and_stay_developable(order):
    first = [*PLANES, [1, 0.2, 1, -110]]
    second = [[1.02, 0.2, 1, -112], [1.3, 0.2, 1, -140], [1.8, 0.2, 1, -195], [2.4, 0.2, 1, -270]]
    second += [[3.1, 0.2, 1, -370], [4.0, 0.2, 1, -510]]
    done = attach(model(developable("a", first, (0, -1)), developable("b", second, (0.5, 0))), "a:u1", "b:u0", order)
    assert done.model.patch("b").kind == "developable"
    assert done.join.gap.most < 1e-8
    assert done.join.angle.most < 1e-6
    assert order == "G1" or done.join.curvature.most < 1e-7


def test_a_seam_that_a_join_tears_is_told():
    three = model(tensor("a", net(0, 1)), tensor("b", net(100, 2)), tensor("c", net(200, 3)))
    three = quintrig.join(three, "b:u1", "c:u0", "G1")
    done = attach(three, "a:u1", "b:u1", "G0")
    assert any("b:u1 and c:u0" in note or "G1 before" in note for note in done.notes)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("a:u1", "a:u0"), "not joined to itself"),
        (("a:u1", "b:w0"), "b:w0: expected PATCH:SIDE"),
        (("a:u1", "bb:u0"), "no patch 'bb'"),
        (("a:u1", "b:u0", "--ratio", "0"), "ratio: expected a finite number greater than 0"),
        (("a:u1", "b:u0", "--ratio", "nan"), "ratio: expected a finite number greater than 0"),
        (("a:u1", "pole:u0"), "single point"),
        (("a:u1", "tiny:u0"), "split the longer one"),
    ],
)
def test_what_cannot_be_joined_is_told_in_one_line(words, message, tmp_path):
    data = {
        "unit": "mm",
        "patch": [tensor("a", net(0, 1)), tensor("b", net(100, 2)), {"name": "pole", "kind": "sphere"}],
    }
    data["patch"].append(tensor("tiny", 0.01 * net(0, 5)))
    path = tmp_path / "m.json"
    path.write_text(json.dumps(data))
    done = run("join", path, *words, "-o", tmp_path / "out.json")
    assert done.code == 2
    assert message in done.err
    assert done.err.count("\n") == 1
    assert not (tmp_path / "out.json").exists()


def test_the_command_tells_what_it_reached_and_keeps_its_input(tmp_path):
    path = tmp_path / "m.json"
    path.write_text(json.dumps({"unit": "mm", "patch": [tensor("left:a", net(0, 1)), tensor("b", net(100, 2))]}))
    out = tmp_path / "joined.toml"
    done = run("join", path, "left:a:u1", "b:u0", "--order", "G2", "-o", out)
    assert done.code == 0
    assert "left:a:u1 and b:u0 join G2" in done.err
    assert quintrig.load(out).joins()[0].order == "G2"
    assert run("join", path, "left:a:u1", "b:u0", "-o", path).code == 2
    assert run("join", path, "left:a:u1", "b:u0", "-o", out).code == 2
    assert run("join", path, "left:a:u1", "b:u0", "-o", out, "--force").code == 0
    assert run("join", path, "left:a:u1", "b:u0", "-o", path, "--force").code == 0  # the model itself, when it is said
    assert quintrig.load(path).joins()[0].order == "G1"


@pytest.mark.parametrize("order", ["G0", "G1"])
def test_a_ruled_patch_stays_ruled_along_its_curves(order):
    a = tensor("a", net(0, 1), (0, 0, 0.3, -1))
    curve = [[100.0, 20 * i, 5.0] for i in range(6)]
    b = {"name": "b", "kind": "ruled", "first": curve, "second": [[200, y, z + 9] for _, y, z in curve]}
    done = attach(model(a, b | {"shape": [0.3, -1, 0.3, -1]}), "a:u1", "b:v0", order)
    assert done.model.patch("b").kind == "ruled"
    assert (done.exact, done.join.order) == (True, order)


def test_straight_lines_that_cannot_join_say_so():
    b = {"name": "b", "kind": "ruled", "first": [[100 + 20 * i, 0, 0] for i in range(6)]}
    b["second"] = [[x, 100, 9] for x, _, _ in b["first"]]
    with pytest.raises(ValueError, match="straight lines cannot join"):
        quintrig.join(model(tensor("a", net(0, 1)), b), "a:u1", "b:u0", "G1")


def test_symmetric_patches_stay_symmetric():
    half = net(100.0, 3)[:3]
    b = {"name": "b", "kind": "symmetric", "points": half.tolist(), "mirror": [1, 0, 0, -150]}
    done = attach(model(tensor("a", net(0, 1)), b), "a:u1", "b:u0", "G1")
    assert done.model.patch("b").kind == "symmetric"
    assert (done.exact, done.join.order) == (True, "G1")


def square(order, ratios=(None, None, None, None)):
    """Four patches around a corner, joined one after the other, and what was said of the last."""
    rng = np.random.default_rng(5)
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    patches = []
    for k, name in enumerate("abcd"):
        net = np.stack([x + 5.0 * (k % 2), y + 5.0 * (k // 2), 0.3 * rng.standard_normal((6, 6))], axis=-1)
        patches.append({"name": name, "kind": "tensor", "points": net.tolist(), "shape": [0.5, -1, 0.5, -1]})
    model, done = quintrig.Model.from_dict({"patch": patches}), None
    pairs = (("a:u1", "b:u0"), ("a:v1", "c:v0"), ("c:u1", "d:u0"), ("b:v1", "d:v0"))
    for pair, ratio in zip(pairs, ratios, strict=True):
        done = attach(model, *pair, order, ratio)
        model = done.model
    return done


@pytest.mark.parametrize("order", ["G1", "G2", "G3"])
def test_four_patches_joined_one_by_one_meet_at_their_corner(order):
    done = square(order)
    assert not done.notes
    for seam in done.model.joins(preset="class-a"):
        assert (seam.order >= order, seam.gap.most < 1e-10, seam.angle.most < 1e-6) == (True, True, True)


def test_ratios_that_differ_along_a_line_are_told():
    assert "c:u1 and d:u0 no longer meet exactly" in " ".join(square("G1", (1.0, 1.0, 1.5, 1.0)).notes)


@pytest.mark.parametrize("order", ["G1", "G2", "G3"])
@pytest.mark.parametrize("sides", [("u1", "u0"), ("v1", "v0")])
def test_a_swung_patch_stays_swung(order, sides):
    def bowl(name, **changed):
        keys = {"profile": [[20, 0], [30, 10], [35, 20], [38, 30], [40, 45], [38, 60]]}
        keys["trajectory"] = [[1, 0], [1, 0.2], [0.9, 0.4], [0.8, 0.6], [0.6, 0.8], [0.4, 0.9]]
        return {"name": name, "kind": "swung", "scale": 1.5, "shape": [0.5, -1, 0.5, -1], **keys, **changed}

    key = "profile" if sides[0] == "u1" else "trajectory"
    after = [[38, 62], [35, 70], [36, 80], [33, 90], [30, 99], [30, 110]]
    if key == "trajectory":
        after = [[0.4, 0.9], [0.3, 1], [0.1, 1], [-0.1, 1], [-0.3, 0.9], [-0.5, 0.8]]
    done = attach(model(bowl("a"), bowl("b", **{key: after})), f"a:{sides[0]}", f"b:{sides[1]}", order)
    moved = done.model.patch("b")
    assert (moved.kind, done.exact, done.join.order >= order) == ("swung", True, True)
