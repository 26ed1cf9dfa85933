"""The exact rational form: proved by exact fractions, met to rounding, and a second way to every curvature."""

from fractions import Fraction
from math import comb

import numpy as np
import pytest
from scipy.interpolate import NdBSpline

import quintrig
import shapes
from quintrig.basis import rational, trigonometric
from quintrig.basis.bernstein import Bernstein
from quintrig.basis.bspline import BSpline, clamped
from quintrig.basis.elementary import Circular, Powers
from quintrig.basis.joined import Joined
from quintrig.basis.rational import NotRationalError, TangentMap
from quintrig.basis.trigonometric import Trigonometric
from quintrig.geometry.exact import blossomed, exact_curve, exact_surface, weight_ratio

SURFACES = shapes.rational()


class Polynomial:
    """A polynomial in w with exact coefficients, lowest first: just enough arithmetic to write eq. 2.2 down."""

    def __init__(self, *coefficients):
        self.c = [Fraction(c) for c in coefficients]

    def __add__(self, other):
        other = other if isinstance(other, Polynomial) else Polynomial(other)
        n = max(len(self.c), len(other.c))
        return Polynomial(*(sum(p.c[k] if k < len(p.c) else 0 for p in (self, other)) for k in range(n)))

    def __mul__(self, other):
        other = other if isinstance(other, Polynomial) else Polynomial(other)
        result = [Fraction(0)] * (len(self.c) + len(other.c) - 1)
        for i, x in enumerate(self.c):
            for j, y in enumerate(other.c):
                result[i + j] += x * y
        return Polynomial(*result)

    def __pow__(self, n):
        result = Polynomial(1)
        for _ in range(n):
            result = result * self
        return result

    def bernstein(self, degree):
        """Coefficients b_k of the Bernstein form: Σ_j a_j C(k, j)/C(n, j)."""
        return [
            sum(a * Fraction(comb(k, j), comb(degree, j)) for j, a in enumerate(self.c[: k + 1]))
            for k in range(degree + 1)
        ]


def thesis_basis(alpha, zeta):
    """Numerators of f_0, ..., f_5 (thesis eq. 2.2) over (1 + w²)⁵, s = 2w/(1 + w²), c = (1 - w²)/(1 + w²)."""
    one, s, c = Polynomial(1, 0, 1), Polynomial(0, 2), Polynomial(1, 0, -1)
    a, b = one + s * -1, one + c * -1
    return [
        a**4 * (one + s * -alpha),
        s * a**3 * (one * (4 + alpha) + s * -alpha),
        a**2 * b * (s * 8 + c * 3 + one * 9) * one,
        b**2 * a * (c * 8 + s * 3 + one * 9) * one,
        c * b**3 * (one * (4 + zeta) + c * -zeta),
        b**4 * (one + c * -zeta),
    ]


def unit_points():
    return np.array([[Fraction(int(i == j)) for j in range(6)] for i in range(6)], dtype=object)


@pytest.mark.parametrize(("alpha", "zeta"), [(0, 0), (1, 1), (-4, -4), (Fraction(1, 3), Fraction(-17, 7)), (1, -4)])
def test_degree_ten_is_the_thesis_basis_in_exact_fractions(alpha, zeta):
    weights = (Polynomial(1, 0, 1) ** 5).bernstein(10)
    control = trigonometric.degree_ten(unit_points(), alpha, zeta)
    for i, numerator in enumerate(thesis_basis(Fraction(alpha), Fraction(zeta))):
        assert [w * b for w, b in zip(weights, control[:, i], strict=True)] == numerator.bernstein(10)
    assert [float(w) for w in weights] == trigonometric.WEIGHTS.tolist()


def test_degree_eight_times_one_plus_w_squared_is_degree_ten():
    weights = (Polynomial(1, 0, 1) ** 4).bernstein(8)
    control = trigonometric.degree_eight(unit_points())
    assert [float(w) for w in weights] == rational.circle_weights(8).tolist()
    for i, numerator in enumerate(thesis_basis(Fraction(0), Fraction(0))):
        coefficients = [w * b for w, b in zip(weights, control[:, i], strict=True)]
        powers = Polynomial(0)
        for k, b in enumerate(coefficients):
            powers = powers + Polynomial(0, 1) ** k * Polynomial(1, -1) ** (8 - k) * (b * comb(8, k))
        assert (powers * Polynomial(1, 0, 1)).bernstein(10) == numerator.bernstein(10)


def test_symmetric_weights_are_the_tangent_ones_over_powers_of_the_tenth_root_of_32():
    form = Trigonometric(1, 0).rational()
    np.testing.assert_allclose(form.weights, trigonometric.WEIGHTS * 32 ** (-np.arange(11) / 10), rtol=1e-15)
    np.testing.assert_allclose(form.weights, form.weights[::-1], rtol=1e-15)
    assert form.weights.max() / form.weights.min() == pytest.approx(2.4, abs=0.01)


def test_symmetric_parameter_is_the_projective_image_of_w():
    t = np.linspace(0, 1, 101)
    w = np.tan(np.pi * t / 4)
    x = rational.RIGHT_ANGLE.forward(t)
    np.testing.assert_allclose(x, w / (w + (1 - w) / np.sqrt(2)), rtol=0, atol=1e-15)
    np.testing.assert_allclose(x + x[::-1], 1, rtol=0, atol=3e-16)
    assert (x[0], x[-1]) == (0, 1)


@pytest.mark.parametrize("angle", [0.0, 0.3, np.pi / 2])
@pytest.mark.parametrize("spans", [1, 3, 4])
def test_parameter_map_goes_both_ways_and_rises(angle, spans):
    there = TangentMap(angle, spans)
    t = np.linspace(0, 1, 301)
    x = there.forward(t)
    np.testing.assert_allclose(there.backward(x), t, rtol=0, atol=5e-16)
    assert (np.diff(x) > 0).all()
    with pytest.raises(ValueError, match="outside the domain"):
        there.forward([0.5, np.nan])


FAMILIES = {
    "trigonometric": Trigonometric(0.3, -2.0),
    "trigonometric (0, 0)": Trigonometric(),
    "two of different degree": Joined((Trigonometric(), Trigonometric(1, -4))),
    "circle": Joined((Circular(0, 4), Powers(0, 1, 0))),
    "arc": Circular(-0.4, 1.9),
    "small arc": Circular(0.1, 0.2),
    "powers": Powers(-1.5, 2.0, 3),
    "powers and bernstein": Joined((Powers(-1.0, 2.0, 2), Bernstein(4))),
    "spline": clamped([0, 0.3, 1], 3, 2),
    "constant": Bernstein(0),
}


@pytest.mark.parametrize("name", FAMILIES)
def test_families_are_met_to_rounding(name):
    functions = FAMILIES[name]
    form = functions.rational()
    t = np.linspace(0, 1, 1001)
    values = BSpline(form.knots, form.degree).derivatives(form.map.forward(t), 0)[0]
    ours = (values @ form.coefficients) / (values @ form.weights)[:, None]
    exact = functions.derivatives(t, 0)[0]
    assert np.abs(ours - exact).max() <= 2e-15 * np.abs(exact).max()
    assert form.weights.min() > 0


def test_degrees_are_as_low_as_the_shape_parameters_allow():
    expected = {
        "tensor": (10, 10),
        "tensor (0, 0, 0, 0)": (8, 8),
        "tensor flipped": (10, 8),
        "swung": (10, 10),
        "ruled": (10, 1),
        "ruled half lowered": (10, 1),
        "classical": (3, 4),
        "developable": (18, 1),
        "developable oblique": (18, 1),
        "developable (0, 0)": (14, 1),
        "developable (-4, -4)": (16, 1),
        "sphere": (2, 2),
        "cylinder": (1, 2),
        "torus": (2, 2),
        "hyperbolic paraboloid": (1, 1),
        "enneper": (3, 3),
    }
    assert {name: exact_surface(SURFACES[name]).degrees for name in expected} == expected


@pytest.mark.parametrize("name", SURFACES)
def test_surface_is_met_to_1e_14_on_ten_thousand_points_at_mapped_parameters(name):
    surface = SURFACES[name]
    form = exact_surface(surface)
    u, v = quintrig.grid(100, 100)
    x, y = form.to_exact(u, v)
    other = form.surface()
    assert np.abs(other(x, y) - surface(u, v)).max() <= 1e-14 * surface.size
    back = form.from_exact(x, y)
    np.testing.assert_allclose(np.broadcast_arrays(*back), np.broadcast_arrays(u, v), rtol=0, atol=1e-14)
    assert other.sign == surface.sign
    assert form.weights.min() > 0


def textbook(forms):
    """K and H by the textbook formulas (do Carmo 1976, §3.3) from six partials (..., 3)."""
    su, sv, suu, suv, svv = forms
    normal = np.cross(su, sv)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    e, f, g = ((a * b).sum(-1) for a, b in ((su, su), (su, sv), (sv, sv)))
    el, em, en = ((a * normal).sum(-1) for a in (suu, suv, svv))
    area = e * g - f * f
    return (el * en - em * em) / area, (e * en - 2 * f * em + g * el) / (2 * area)


def scipy_partials(form, x, y):
    """Partial derivatives of the exact form, by SciPy's tensor-product B-splines and the quotient rule written out."""
    homogeneous = np.concatenate([form.points * form.weights[..., None], form.weights[..., None]], axis=-1)
    spline = NdBSpline((np.array(form.u.knots), np.array(form.v.knots)), homogeneous, form.degrees)
    at = np.stack(np.broadcast_arrays(x, y), axis=-1)

    def part(i, j):
        if i > form.degrees[0] or j > form.degrees[1]:
            return np.zeros((*at.shape[:-1], 3)), np.zeros((*at.shape[:-1], 1))
        values = spline(at, nu=(i, j))
        return values[..., :3], values[..., 3:]

    (n, w), (nx, wx), (ny, wy) = part(0, 0), part(1, 0), part(0, 1)
    (nxx, wxx), (nxy, wxy), (nyy, wyy) = part(2, 0), part(1, 1), part(0, 2)
    s = n / w
    sx, sy = (nx - wx * s) / w, (ny - wy * s) / w
    sxx = (nxx - 2 * wx * sx - wxx * s) / w
    sxy = (nxy - wx * sy - wy * sx - wxy * s) / w
    syy = (nyy - 2 * wy * sy - wyy * s) / w
    return sx, sy, sxx, sxy, syy


@pytest.mark.parametrize("name", SURFACES)
def test_curvature_by_scipy_on_the_exact_form_agrees(name):
    surface = SURFACES[name]
    form = exact_surface(surface)
    inner = np.linspace(0.03, 0.96, 23)
    u, v = inner[:, None], inner[None, :]
    sample = quintrig.analyse(surface, u, v, ("gaussian", "mean", "curvedness"))
    gauss, mean = textbook(scipy_partials(form, *form.to_exact(u, v)))
    scale = sample["curvedness"] + 1e-3 / surface.size
    assert (np.abs(sample["gaussian"] - gauss) / scale**2).max() <= 1e-9
    assert (np.abs(surface.sign * sample["mean"] - mean) / scale).max() <= 1e-9


@pytest.mark.parametrize("name", ["catenoid", "helicoid"])
def test_surfaces_without_a_rational_form_say_so(name):
    with pytest.raises(NotRationalError, match=r"hyperbolic functions|no common rational parameter"):
        exact_surface(getattr(quintrig, name)())


def test_parallel_bounding_planes_need_no_projective_rulings():
    assert not exact_surface(SURFACES["developable"]).projective
    assert exact_surface(SURFACES["developable oblique"]).projective


# Strips found by a random search: regular, yet with negative weights in the plain form of degree 18.
TWISTED = [
    (
        [0.23, 0.33, 3.12, 4.13, 4.68, 4.72],
        [0.14, -0.54, 0.41, 0.3, 0.48, 0.54],
        [15.4, 16, 15.6, 10.6, 12.6, 15.2],
        (-3.9, -2),
    ),
    (
        [0.07, 0.25, 0.8, 1.15, 3.86, 4.89],
        [-0.16, -0.28, -0.6, -0.37, 0.42, 0.06],
        [10.5, 10.3, 10.9, 10.9, 15.3, 13.4],
        (1, 1),
    ),
]


@pytest.mark.parametrize(("angle", "steep", "distance", "shape"), TWISTED)
def test_negative_weights_are_removed_by_knots_and_the_strip_stays_the_same(angle, steep, distance, shape):
    planes = np.stack([np.cos(angle), np.sin(angle), steep, np.negative(distance)], axis=-1)
    strip = quintrig.developable(planes, shapes.OBLIQUE, shape)
    plain = strip.rows.homogeneous.points[..., 3]
    assert (plain.min(axis=0) * plain.max(axis=0)).min() < 0
    assert not quintrig.regression(strip).intervals
    form = exact_surface(strip)
    assert len(form.u.breaks) > 2
    assert form.weights.min() > 0
    assert weight_ratio(form) < 1e6
    u, v = quintrig.grid(100, 100)
    assert np.abs(form.surface()(*form.to_exact(u, v)) - strip(u, v)).max() <= 1e-14 * strip.size


def test_a_strip_that_reaches_infinity_is_refused_with_the_place():
    planes = [[0, 1, 4, -20], [1, 1, 5, -24], [2, 1, 4, -30], [3, 0, 4, -33], [4, 1, 3, -40], [5, 2, 4, -44]]
    strip = quintrig.developable(planes, [[0, 1, 0, 0], [0, 1, 0, -10]], (1, 1))
    with pytest.raises(ValueError, match=r"infinity near u = 0\.97"):
        exact_surface(strip)


def test_blossom_gives_the_same_polynomial_over_any_knots():
    control = np.random.default_rng(0).normal(size=(8, 2))
    basis = clamped([0, 0.2, 0.25, 0.9, 1], 7, 3)
    t = np.linspace(0, 1, 99)
    again = basis.derivatives(t, 0)[0] @ blossomed(control, basis)
    np.testing.assert_allclose(again, Bernstein(7).derivatives(t, 0)[0] @ control, rtol=0, atol=1e-14)


@pytest.mark.parametrize("points", [shapes.CURVE, shapes.CURVE[:, :2]])
@pytest.mark.parametrize(("alpha", "zeta"), [(0.7, -3.0), (0, 0)])
def test_curve_is_met_to_rounding(points, alpha, zeta):
    curve = quintrig.Curve(points, alpha, zeta)
    form = exact_curve(curve)
    t = np.linspace(0, 1, 501)
    assert form.basis.degree == (8 if alpha == zeta == 0 else 10)
    assert np.abs(form(form.map.forward(t)) - curve(t)).max() <= 1e-14 * np.ptp(points[:, 0])
