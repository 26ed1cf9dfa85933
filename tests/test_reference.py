"""Reference surfaces: curvature in closed form at random points, sides, singular points, and integral theorems."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import quintrig

inside = st.tuples(st.floats(0.02, 0.98), st.floats(0, 1))
lengths = st.floats(1e-3, 1e3)
ratios = st.floats(0.2, 5.0)
repeatable = settings(deadline=None, derandomize=True, max_examples=60)
ROUNDING = 1e-11


def curvature(surface, at):
    sample = quintrig.analyse(surface, *at)
    return float(sample["gaussian"]), float(sample["mean"]), float(sample["curvedness"]), sample


def assert_curvature(surface, at, gaussian, mean):
    k, h, c, _ = curvature(surface, at)
    assert abs(k - gaussian) <= ROUNDING * c**2
    assert abs(h - mean) <= ROUNDING * c


@repeatable
@given(inside, lengths, st.booleans())
def test_sphere(at, radius, flip):
    surface = quintrig.sphere(radius, flip=flip)
    side = 1.0 if flip else -1.0
    assert_curvature(surface, at, 1 / radius**2, side / radius)
    _, _, _, sample = curvature(surface, at)
    np.testing.assert_allclose(np.linalg.norm(sample.point), radius, rtol=1e-14)
    np.testing.assert_allclose(sample.normal, -side * sample.point / radius, rtol=0, atol=1e-13)
    assert sample["shape_index"] == pytest.approx(-side, abs=1e-10)
    assert sample["point_type"] == 5  # umbilic
    assert np.isnan(sample["direction1"]).all()


def test_sphere_is_an_ellipsoid_with_equal_axes():
    at = np.random.default_rng(1).random((2, 20))
    one = quintrig.analyse(quintrig.sphere(2.0), *at)
    two = quintrig.analyse(quintrig.ellipsoid(2.0, 2.0, 2.0), *at)
    for key in one.values:
        np.testing.assert_array_equal(one[key], two[key])


@repeatable
@given(inside, lengths, ratios, ratios)
def test_ellipsoid(at, a, b, c):
    b, c = a * b, a * c
    surface = quintrig.ellipsoid(a, b, c)
    x, y, z = point = surface(*at)
    np.testing.assert_allclose((x / a) ** 2 + (y / b) ** 2 + (z / c) ** 2, 1.0, rtol=0, atol=1e-14)
    q = x**2 / a**4 + y**2 / b**4 + z**2 / c**4
    gaussian = 1 / (a * b * c * q) ** 2
    mean = (point @ point - a**2 - b**2 - c**2) / (2 * (a * b * c) ** 2 * q**1.5)
    assert_curvature(surface, at, gaussian, mean)
    outwards = np.array([x / a**2, y / b**2, z / c**2]) / np.sqrt(q)
    np.testing.assert_allclose(quintrig.analyse(surface, *at, "normal").normal, outwards, rtol=0, atol=1e-12)


@repeatable
@given(inside, lengths, lengths)
def test_cylinder(at, radius, height):
    surface = quintrig.cylinder(radius, height)
    assert_curvature(surface, at, 0.0, -1 / (2 * radius))
    _, _, _, sample = curvature(surface, at)
    np.testing.assert_allclose(sample.normal, [*sample.point[:2] / radius, 0], rtol=0, atol=1e-14)
    assert sample["hk_type"] == 2  # ridge: the normal points outwards
    np.testing.assert_allclose(np.abs(sample["direction1"]), [0, 0, 1], rtol=0, atol=1e-12)


@repeatable
@given(inside, lengths, ratios)
def test_cone(at, radius, ratio):
    height = ratio * radius
    surface = quintrig.cone(radius, height)
    slant = np.hypot(radius, height)
    away = radius * (1 - at[0])
    assert_curvature(surface, at, 0.0, -height / (2 * away * slant))
    _, _, _, sample = curvature(surface, at)
    assert sample.normal[:2] @ sample.point[:2] > 0


@repeatable
@given(st.tuples(st.floats(0, 1), st.floats(0, 1)), lengths, st.floats(1.1, 10.0))
def test_torus(at, minor, ratio):
    major = ratio * minor
    surface = quintrig.torus(major, minor)
    w = 2 * np.pi * at[0]
    out = major + minor * np.cos(w)
    assert_curvature(surface, at, np.cos(w) / (minor * out), -(major + 2 * minor * np.cos(w)) / (2 * minor * out))
    _, _, _, sample = curvature(surface, at)
    x, y, z = sample.point
    tube = np.array([*(1 - major / np.hypot(x, y)) * sample.point[:2], z])
    np.testing.assert_allclose(sample.normal, tube / minor, rtol=0, atol=1e-11)


@repeatable
@given(st.tuples(st.floats(0, 1), st.floats(0, 1)), lengths, st.floats(0.1, 6.0))
def test_catenoid(at, waist, ratio):
    surface = quintrig.catenoid(waist, ratio * waist)
    x, y, z = surface(*at)
    assert abs(z) <= ratio * waist / 2 * (1 + 1e-15)
    np.testing.assert_allclose(np.hypot(x, y), waist * np.cosh(z / waist), rtol=1e-13)
    assert_curvature(surface, at, -1 / (waist * np.cosh(z / waist) ** 2) ** 2, 0.0)


@repeatable
@given(st.tuples(st.floats(0, 1), st.floats(0, 1)), lengths, ratios, st.booleans())
def test_helicoid(at, radius, ratio, left):
    pitch = (-1 if left else 1) * ratio * radius
    surface = quintrig.helicoid(radius, pitch)
    c = pitch / (2 * np.pi)
    x, y, z = surface(*at)
    assert abs(x * np.sin(z / c) - y * np.cos(z / c)) <= 1e-13 * radius
    assert_curvature(surface, at, -(c**2) / (c**2 + x**2 + y**2) ** 2, 0.0)


def test_catenoid_and_helicoid_are_bent_into_each_other():
    """Their curvatures agree at ρ = a sinh(z/a), for a pitch of 2πa (Bonnet's bending)."""
    waist, u = 1.3, np.linspace(0, 1, 21)
    catenoid = quintrig.catenoid(waist, 2 * waist)
    helicoid = quintrig.helicoid(waist * np.sinh(1), 2 * np.pi * waist)
    along = waist * np.sinh(2 * u - 1) / (2 * waist * np.sinh(1)) + 0.5
    first = quintrig.analyse(catenoid, u, 0.3)["gaussian"]
    second = quintrig.analyse(helicoid, np.clip(along, 0, 1), 0.3)["gaussian"]
    np.testing.assert_allclose(first, second, rtol=1e-12)


@repeatable
@given(st.tuples(st.floats(0, 1), st.floats(0, 1)), st.floats(0.01, 10.0))
def test_graphs_and_enneper(at, size):
    surface = quintrig.hyperbolic_paraboloid(size)
    x, y, z = surface(*at)
    assert z == pytest.approx(x * y, abs=1e-14 * size**2)
    w = np.sqrt(1 + x**2 + y**2)
    assert_curvature(surface, at, -1 / w**4, -x * y / w**3)

    surface = quintrig.monkey_saddle(size)
    x, y, z = surface(*at)
    assert z == pytest.approx(x**3 - 3 * x * y**2, abs=1e-14 * size**3)
    rho = x**2 + y**2
    w = np.sqrt(1 + 9 * rho**2)
    k, h, c, _ = curvature(surface, at)
    # z_xx = 6x, z_xy = -6y, z_yy = -6x, z_x = 3(x² - y²), z_y = -6xy.
    p, q = 3 * (x**2 - y**2), -6 * x * y
    mean = ((1 + q**2) * 6 * x + 2 * p * q * 6 * y - (1 + p**2) * 6 * x) / (2 * w**3)
    c = max(c, 1e-3 / surface.size)
    assert abs(k + 36 * rho / w**4) <= ROUNDING * c**2
    assert abs(h - mean) <= ROUNDING * c

    surface = quintrig.enneper(size)
    p, q = size * (2 * at[0] - 1), size * (2 * at[1] - 1)
    assert_curvature(surface, at, -4 / (1 + p**2 + q**2) ** 4, 0.0)


def test_monkey_saddle_is_flat_at_its_origin():
    sample = quintrig.analyse(quintrig.monkey_saddle(), 0.5, 0.5)
    assert sample["curvedness"] == 0.0
    assert sample["point_type"] == 4
    assert sample["hk_type"] == 5
    assert sample["shape_class"] == 10
    assert np.isnan(sample["shape_index"])
    assert np.isnan(sample["direction1"]).all()


@pytest.mark.parametrize(
    ("surface", "u", "singular"),
    [
        (quintrig.sphere(), [0.0, 0.5, 1.0], [True, False, True]),
        (quintrig.ellipsoid(), [0.0, 0.5, 1.0], [True, False, True]),
        (quintrig.cone(), [0.0, 0.5, 1.0], [False, False, True]),
        (quintrig.torus(1.0, 1.0), [0.0, 0.25, 0.5], [False, False, True]),
        (quintrig.cylinder(), [0.0, 0.5, 1.0], [False, False, False]),
    ],
)
def test_poles_and_apex_are_singular_at_every_longitude(surface, u, singular):
    sample = quintrig.analyse(surface, np.array(u)[:, None], np.linspace(0, 1, 13)[None, :])
    np.testing.assert_array_equal(sample.singular, np.repeat(np.array(singular)[:, None], 13, axis=1))
    assert np.isnan(sample["gaussian"][sample.singular]).all()
    assert (sample["point_type"][sample.singular] == 0).all()


@pytest.mark.parametrize("kind", [quintrig.sphere, quintrig.torus, quintrig.cylinder, quintrig.catenoid])
def test_seam_meets_itself_exactly(kind):
    u = np.linspace(0.01, 0.99, 9)
    start, end = (quintrig.analyse(kind(), u, v) for v in (0.0, 1.0))
    np.testing.assert_array_equal(start.point, end.point)
    np.testing.assert_array_equal(start["gaussian"], end["gaussian"])


def gauss(count, low=0.0, high=1.0):
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return low + (high - low) * (nodes + 1) / 2, weights * (high - low) / 2


def area_element(sample):
    return np.sqrt(sample["E"] * sample["G"] - sample["F"] ** 2)


def test_gauss_bonnet_on_the_torus():
    """∫K dA = 2πχ = 0; the mean over equal steps is exact to rounding for periodic functions."""
    u, v = np.arange(64)[:, None] / 64, np.arange(8)[None, :] / 8
    sample = quintrig.analyse(quintrig.torus(3.0, 1.0), u, v)
    dA = area_element(sample)
    assert abs((sample["gaussian"] * dA).mean()) <= 1e-12
    assert (np.abs(sample["gaussian"]) * dA).mean() == pytest.approx(8 * np.pi, rel=1e-3)
    assert dA.mean() == pytest.approx(4 * np.pi**2 * 3.0, rel=1e-13)


@pytest.mark.parametrize(("a", "b", "c"), [(1.0, 1.0, 1.0), (3.0, 2.0, 1.0), (1.0, 5.0, 0.7)])
def test_gauss_bonnet_on_ellipsoids(a, b, c):
    (u, weights), v = gauss(120), np.arange(480) / 480
    sample = quintrig.analyse(quintrig.ellipsoid(a, b, c), u[:, None], v[None, :])
    around = (sample["gaussian"] * area_element(sample)).mean(axis=1)
    assert weights @ around == pytest.approx(4 * np.pi, rel=1e-9)


def test_gauss_bonnet_on_a_patch_with_edges_and_corners():
    """∫K dA + Σ∫k_g ds + Σ exterior angles = 2π, on a patch of the hyperbolic paraboloid, whose edges are straight."""
    surface = quintrig.hyperbolic_paraboloid(1.5)
    (u, wu), (v, wv) = gauss(40), gauss(40)
    sample = quintrig.analyse(surface, u[:, None], v[None, :])
    total = wu @ (sample["gaussian"] * area_element(sample)) @ wv
    corners = surface([0, 1, 1, 0], [0, 0, 1, 1])
    sides = np.roll(corners, -1, axis=0) - corners
    sides /= np.linalg.norm(sides, axis=-1)[:, None]
    turns = np.arccos((sides * np.roll(sides, -1, axis=0)).sum(axis=-1))
    assert total + turns.sum() == pytest.approx(2 * np.pi, abs=1e-12)
