"""Umbilics: place, curvature, index and type against what is known, and the sum of indices."""

import json

import numpy as np
import pytest
from scipy.special import comb

import quintrig
import quintrig.geometry.nurbs
from cli_runner import quintrig as command
from quintrig import umbilics
from quintrig.enclosures.ball import Ball
from quintrig.enclosures.boxes import Boxes
from quintrig.enclosures.turns import Part, turn
from quintrig.enclosures.zeros import zeros


def height(z, low=(-0.6, -0.5), high=(0.5, 0.6), degree=4):
    """Return z(x, y), a polynomial, over a rectangle as a model of one Bézier patch."""
    t = np.linspace(0, 1, degree + 1)
    x = low[0] + (high[0] - low[0]) * t[:, None] + 0 * t[None, :]
    y = low[1] + (high[1] - low[1]) * t[None, :] + 0 * t[:, None]
    bernstein = np.stack([comb(degree, k) * t**k * (1 - t) ** (degree - k) for k in range(degree + 1)], axis=1)
    inverse = np.linalg.inv(bernstein)
    points = np.einsum("ia,jb,abk->ijk", inverse, inverse, np.stack([x, y, z(x, y)], axis=-1))
    knots = [[0] * (degree + 1) + [1] * (degree + 1)] * 2
    return quintrig.Model.from_dict(
        {"kind": "nurbs", "degrees": [degree] * 2, "knots": knots, "points": points.tolist()}
    )


def test_an_ellipsoid_has_four_lemons():
    a, b, c = 3.0, 2.0, 1.0
    found = umbilics(quintrig.ellipsoid(a, b, c))
    x, z = a * np.sqrt((a * a - b * b) / (a * a - c * c)), c * np.sqrt((b * b - c * c) / (a * a - c * c))
    wanted = np.array(sorted([[p * x, 0.0, q * z] for p in (-1, 1) for q in (-1, 1)]))
    points = np.array(sorted(np.round(one.point, 12).tolist() for one in found.umbilics))
    assert np.abs(points - wanted).max() < 1e-8
    for one in found.umbilics:
        assert (one.type, one.index) == ("lemon", 0.5)
        assert one.curvature == pytest.approx(-a * c / b**3, rel=1e-12)  # n outwards
    assert found.sums[0]["index_sum"] == found.sums[0]["boundary_rotation"] == 2.0  # Euler's number of a sphere
    assert found.sums[0]["agree"] is True
    assert found.complete


def test_an_ellipsoid_of_revolution_has_two_umbilics_at_its_poles():
    found = umbilics(quintrig.ellipsoid(2.0, 2.0, 1.0))
    assert sorted(one.point[2] for one in found.umbilics) == pytest.approx([-1.0, 1.0])
    assert [(one.index, one.type) for one in found.umbilics] == [(1.0, "other")] * 2
    assert [one.curvature for one in found.umbilics] == pytest.approx([-0.25] * 2, rel=1e-8)  # c / a²
    assert found.sums[0]["agree"] is True
    assert found.complete


def test_a_pole_of_a_rational_face_is_one_umbilic_whatever_rounding_makes_of_it():
    half, arc = np.sqrt(0.5), np.array([[1, 0], [1, 1], [0, 1]])
    points = [[(2 * r * x, 2 * r * y, z) for x, y in arc] for r, z in arc]
    knots = [0, 0, 0, 1, 1, 1]
    face = quintrig.geometry.nurbs.nurbs(points, np.outer([1, half, 1], [1, half, 1]), (2, 2), (knots, knots))
    (one,) = umbilics(face).umbilics
    assert (one.u, one.index) == (1.0, 1.0)
    assert one.curvature == pytest.approx(0.25, rel=1e-6)


@pytest.mark.parametrize(
    ("a", "c", "kind", "index", "leave"),
    [(1.0, -1.0, "star", -0.5, 3), (3.0, 1.0, "lemon", 0.5, 1), (1.5, 1.0, "monstar", 0.5, 3)],
)
@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_types_by_the_cubic_form(a, c, kind, index, leave, turn):
    def z(x, y):
        p, q = np.cos(turn) * x + np.sin(turn) * y, np.cos(turn) * y - np.sin(turn) * x
        return (p * p + q * q) / 2 + (a * p**3 + 3 * c * p * q * q) / 6

    found = umbilics(height(z))
    (one,) = [one for one in found.umbilics if np.linalg.norm(one.point) < 1e-6]
    assert (one.type, one.index, len(one.directions)) == (kind, index, leave)
    assert one.curvature == pytest.approx(1.0)
    assert found.complete
    assert np.abs(one.point).max() < 1e-9
    assert found.sums[0]["agree"] is True
    assert any(abs((angle - np.degrees(turn) + 90) % 180 - 90) < 1e-5 for angle in one.directions)  # by symmetry


def test_a_monkey_saddle_has_one_planar_umbilic_of_index_minus_a_half():
    found = umbilics(quintrig.monkey_saddle())
    (one,) = found.umbilics
    assert (one.type, one.index, one.curvature) == ("planar", -0.5, 0.0)
    assert found.sums[0]["boundary_rotation"] == -0.5


def test_an_umbilic_that_is_not_simple_has_its_index_by_turning():
    found = umbilics(height(lambda x, y: x**4 - 6 * x * x * y * y + y**4))
    (one,) = found.umbilics
    assert (one.type, one.index) == ("planar", -1.0)
    assert found.sums[0]["agree"] is True
    assert not found.complete
    assert found.none_elsewhere
    assert (one.proved, one.directions) == ("index", ())
    assert one.box[0] < one.u < one.box[2]
    assert one.box[1] < one.v < one.box[3]
    assert "the index -1 of a box" in found.notes[0]


def power(n, more=lambda x, y: 0 * x):
    """Return Re (x + iy)^n and something of a higher order."""
    return lambda x, y: np.real((x + 1j * y) ** n) + more(x, y)


@pytest.mark.parametrize(
    ("z", "degree", "index", "kind"),
    [
        # The Hessian of Re (x + iy)^n is a vector that turns n - 2 times against the clock's sense: index -(n - 2)/2.
        (power(3, lambda x, y: 0.3 * x**4 - x * y**3), 4, -0.5, "planar"),
        (power(4, lambda x, y: x**5 - 2 * x * x * y**3), 5, -1.0, "planar"),
        (power(5), 5, -1.5, "planar"),
        (lambda x, y: 0.5 * (x * x + y * y), 4, 1.0, "other"),  # of revolution: meridians and parallels
        (lambda x, y: 0.5 * (x * x + y * y) + 0.25 * x**4 + 0.125 * y**4, 4, -1.0, "other"),
        (lambda x, y: x**4 + y**4, 4, -1.0, "planar"),  # κ1 = κ2 nearly on the diagonals too, but there is no curve
        (lambda x, y: 0.5 * (x * x + y * y) + x**3 + y**4, 4, -0.5, "other"),
    ],
)
def test_the_index_of_an_umbilic_that_is_not_simple_is_proved(z, degree, index, kind):
    found = umbilics(height(z, degree=degree))
    one = min(found.umbilics, key=lambda one: np.linalg.norm(one.point[:2]))
    assert np.linalg.norm(one.point[:2]) < 1e-3
    assert (one.index, one.type) == (index, kind)
    assert one.proved == ("alone" if index == -0.5 and kind == "planar" else "index")
    assert not found.regions
    assert found.none_elsewhere
    assert found.complete is all(one.proved == "alone" for one in found.umbilics)
    assert found.sums[0]["agree"] is True


def test_umbilics_of_revolution_on_a_seam_and_amid_a_patch():
    for a, b, c in ((2, 1, 1), (1, 2, 2)):  # a long and a flat one, whose axis is that of x: no pole of the parameters
        found = umbilics(quintrig.ellipsoid(a, b, c))
        assert sorted(round(float(one.point[0]), 6) for one in found.umbilics) == [-a, a]
        assert [(one.index, one.type, one.proved) for one in found.umbilics] == [(1.0, "other", "index")] * 2
        assert [one.curvature for one in found.umbilics] == pytest.approx([-a / b**2] * 2, rel=1e-6)
        assert found.sums[0]["agree"] is True
        assert found.none_elsewhere
        assert not found.complete


def test_four_lemons_beside_the_poles_of_the_parameters():
    a, b, c = 1.000001, 1.0, 2.0
    found = umbilics(quintrig.ellipsoid(a, b, c))
    y, z = b * np.sqrt((a * a - b * b) / (c * c - b * b)), c * np.sqrt((c * c - a * a) / (c * c - b * b))
    points = sorted(np.round(one.point, 9).tolist() for one in found.umbilics)
    np.testing.assert_allclose(points, sorted([0.0, p * y, q * z] for p in (-1, 1) for q in (-1, 1)), atol=1e-7)
    assert found.complete
    assert found.sums[0]["agree"] is True


def test_umbilics_do_not_depend_on_unit_place_and_side():
    x, y = np.meshgrid(np.linspace(-0.6, 0.5, 6), np.linspace(-0.5, 0.6, 6), indexing="ij")
    net = np.stack([x, y, -0.5 * (x * x + 1.2 * y * y) + 0.3 * x**3 - 0.2 * x * y * y], axis=-1)
    turn = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)
    wanted = umbilics(quintrig.tensor(net))
    assert sorted(one.type for one in wanted.umbilics) == ["lemon", "star"]
    for scale, at, flip in ((1e-6, 0.0, False), (1e6, 0.0, True), (1.0, 1e6, False)):
        found = umbilics(quintrig.tensor(scale * net @ turn.T + at, flip=flip))
        assert found.complete
        for one, other in zip(found.umbilics, wanted.umbilics, strict=True):
            assert (one.type, one.index) == (other.type, other.index)
            assert (one.u, one.v) == pytest.approx((other.u, other.v), abs=1e-6)
            assert one.curvature * scale * (-1 if flip else 1) == pytest.approx(other.curvature, rel=1e-6)


def test_a_flat_part_of_a_face_is_a_region():
    i, j = np.meshgrid(np.arange(7.0), np.arange(7.0), indexing="ij")
    knots = [0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1]
    points = np.stack([i, j, np.where(i + j > 8, 1.0, 0.0)], axis=-1)
    found = umbilics(quintrig.geometry.nurbs.nurbs(points, None, (3, 3), (knots, knots)))
    kinds = [region.kind for region in found.regions]
    assert kinds == ["region", "curve", "curve"]  # and two edges along which K = H = 0
    assert np.abs(found.regions[0].points[:, 2]).max() < 1e-9
    u, v = found.regions[0].uv.T
    area = 0.5 * abs(np.sum(u * np.roll(v, -1) - v * np.roll(u, -1)))
    assert area == pytest.approx(6 / 16, abs=0.02)  # of 16 spans, those whose points all lie in the plane
    assert len(found) < 6
    assert not found.complete


def test_spheres_and_planes_are_told_as_regions():
    for model, curvature in (
        (quintrig.sphere(2), -0.5),
        (height(lambda x, y: 0.3 * x - 0.2 * y), 0.0),
        (quintrig.ellipsoid(2, 2, 2), -0.5),
    ):
        found = umbilics(model)
        assert not found.umbilics
        assert found.complete
        assert [region.kind for region in found.regions] == ["region"]
        assert found.regions[0].curvature == pytest.approx(curvature, abs=1e-12)


def test_a_curve_of_umbilics_is_told_as_one():
    # z = 7 r²/32 + r⁴/64: on r = 1 both curvatures are the same.
    found = umbilics(height(lambda x, y: 7 * (x * x + y * y) / 32 + (x * x + y * y) ** 2 / 64, (0.3, 0.2), (1.2, 1.3)))
    assert not found.umbilics
    assert [region.kind for region in found.regions] == ["curve"]
    assert np.abs(np.hypot(*found.regions[0].points[:, :2].T) - 1).max() < 1e-6
    assert not found.complete


def test_the_proof_finds_what_the_search_has_missed():
    found = umbilics(quintrig.load("examples/swung.toml"))  # one between the edge and the first cells of the grid
    assert any(one.u < 0.02 and abs(one.v) < 1e-9 for one in found.umbilics)
    assert len(found) == 6
    assert found.complete


def test_edges_that_stand_still_are_told_and_the_rest_is_complete():
    x, y = np.meshgrid(np.linspace(0.0, 3.0, 6), np.linspace(0.0, 2.0, 6), indexing="ij")
    points = np.stack([x, y, -0.2 * (x - 1.4) ** 2 - 0.3 * (y - 1.1) ** 2 + 0.03 * np.sin(5 * x + 3 * y)], axis=-1)
    found = umbilics(quintrig.tensor(points, (-4.0, -4.0, -1.0, 1.0)))
    assert found.complete
    assert [note for note in found.notes if "u = 0" in note]


def form(function, degree=3):
    """Return a polynomial f(x, y) over the unit square as a form, from its values to rounding."""
    t = np.linspace(0, 1, degree + 1)
    matrix = np.stack([comb(degree, k) * t**k * (1 - t) ** (degree - k) for k in range(degree + 1)], axis=1)
    inverse = np.linalg.inv(matrix)
    scale = comb(degree, np.arange(degree + 1))
    middle = inverse @ function(t[:, None], t[None, :]) @ inverse.T * scale[:, None] * scale
    return Ball(middle, np.full(middle.shape, 1e-13))


def test_forms_turn_around_their_zeros_as_often_as_they_must():
    def parts(function):
        forms = [
            form(lambda x, y: np.real(function(x + 1j * y)), 4),
            form(lambda x, y: np.imag(function(x + 1j * y)), 4),
        ]
        return [Part(Boxes.whole(forms), np.full(2, -1.0), np.full(2, 2.0), lambda uv: uv)]

    centre = 0.4 + 0.3j
    box = np.array([0.3, 0.2]), np.array([0.55, 0.4])
    for n in range(1, 5):
        assert turn(parts(lambda z, n=n: (z - centre) ** n), *box) == n
        assert turn(parts(lambda z, n=n: np.conj(z - centre) ** n), *box) == -n
    assert turn(parts(lambda z: (z - centre) * np.conj(z - 0.42 - 0.31j)), *box) == 0  # two that are against each other
    assert turn(parts(lambda z: (z - 0.9) ** 3), *box) == 0
    assert turn(parts(lambda z: z - 0.3 - 0.3j), *box) is None  # a zero on a side
    assert turn(parts(lambda z: (z - 0.3 - 1e-13 - 0.3j) ** 2), *box) is None  # and one that rounding may put there


def test_a_zero_is_never_told_to_be_alone_beside_another():
    for apart in (0.3, 1e-2, 1e-4):
        near, far = np.array([0.4, 0.3]), np.array([0.4 + apart, 0.3])
        pair = [form(lambda x, y: (x - 0.4) * (x - 0.4 - apart) + 0 * y), form(lambda x, y: (y - 0.3) * (1 + x + y))]  # noqa: B023
        both = zeros(pair, np.array([near, far]), 500)
        assert both.alone.all()
        assert not both.open
        one = zeros(pair, near[None], 500)
        assert one.alone.all()
        assert any((far >= low[:2]).all() and (far <= low[2:]).all() for low in np.array(one.open))
        wrong = zeros(pair, np.array([[0.41 + 0.3 * apart, 0.32]]), 500)
        assert not wrong.alone.any()


def test_zeros_on_an_edge_and_zeros_that_are_double():
    edge = [form(lambda x, y: x + 0 * y), form(lambda x, y: y - 0.5 + x * x)]
    found = zeros(edge, np.array([[0.0, 0.5]]), 500)
    assert found.alone.all()
    assert not found.open
    double = [form(lambda x, y: (x - 0.5) ** 2 + 0 * y), form(lambda x, y: y - 0.5 + 0 * x)]
    found = zeros(double, np.array([[0.5, 0.5]]), 500)
    assert not found.alone.any()
    assert found.open


@pytest.mark.parametrize("make", [quintrig.torus, quintrig.enneper, quintrig.catenoid, quintrig.hyperbolic_paraboloid])
def test_surfaces_without_umbilics_have_none(make):
    found = umbilics(make())
    assert len(found) == 0
    assert found.sums[0]["agree"] is True
    assert found.complete is (make is not quintrig.catenoid)  # which has no forms


def test_the_command_prints_the_same(tmp_path):
    file = tmp_path / "e.toml"
    file.write_text('kind = "ellipsoid"\na = 3\nb = 2\nc = 1\n')
    told = json.loads(command("umbilics", file, "--json").out)
    assert {"patch", "u", "v", "point", "curvature", "index", "type"} <= set(told["umbilics"][0])
    assert len(told["umbilics"]) == 4
    assert told["complete"] is True
    said = command("umbilics", file)
    assert said.code == 0
    assert said.out.count("lemon") == 4
    assert "sum of indices 2.0" in said.out
    file.write_text('kind = "ellipsoid"\na = 2\nb = 1\nc = 1\n')
    told = json.loads(command("umbilics", file, "--json").out)
    assert (told["complete"], told["none_elsewhere"]) == (False, True)
    assert [(one["index"], one["proved"], len(one["box"])) for one in told["umbilics"]] == [(1.0, "index", 4)] * 2
    assert "proved that there are none elsewhere" in command("umbilics", file).out


def test_lines_leave_an_umbilic_as_its_directions_say():
    found = quintrig.lines(
        height(lambda x, y: (x * x + y * y) / 2 + (x**3 - 3 * x * y * y) / 6), "curvature", umbilics=True
    )
    starts = [line for line in found if min(np.linalg.norm(line.points[[0, -1]], axis=1)) < 0.01]
    assert len(starts) == 6  # three to each side
