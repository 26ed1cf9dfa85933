"""Curves: values, derivatives, curvature, torsion, length and comb against 40 digits and closed forms."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import oracle
from catalogue import PAIRS, arch, rail
from quintrig import Curve

T = np.concatenate([[0.0, 1.0, 0.5], np.random.default_rng(0).random(7)])
repeatable = settings(deadline=None, derandomize=True, max_examples=50)

PARABOLA = Curve([[-1, 1], [0, -1], [1, 1]], basis="bernstein")  # y = x², x = 2t - 1
TWISTED = Curve([[0, 0, 0], [1 / 3, 0, 0], [2 / 3, 1 / 3, 0], [1, 1, 1]], basis="bernstein")  # (t, t², t³)


def turn(axis, angle):
    """The rotation about an axis (Rodrigues)."""
    k = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    cross = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


# ---------------------------------------------------------------------------------------------- exact values


@pytest.mark.parametrize(("alpha", "zeta"), PAIRS)
def test_derivatives_to_order_six(alpha, zeta):
    points = arch()
    found = Curve(points, alpha, zeta).derivatives(T, 6)
    size = np.ptp(points, axis=0).max()
    for k, t in enumerate(T):
        for order, exact in enumerate(oracle.curve(points, alpha, zeta, t, 6)):
            error = max(abs(oracle.number(a) - b) for a, b in zip(found[order, k], exact, strict=True))
            assert error <= 1e-13 * size * 4.0**order * 4, f"order {order} at {t}"


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize(("alpha", "zeta"), PAIRS)
def test_curvature_and_torsion(alpha, zeta, scale):
    points = scale * arch(seed=5)
    curve = Curve(points, alpha, zeta)
    curvature, torsion = curve.curvature(T), curve.torsion(T)
    for k, t in enumerate(T):
        stands_still = (t == 0 and alpha == -4) or (t == 1 and zeta == -4)
        if stands_still:
            assert np.isnan(curvature[k])
            assert np.isnan(torsion[k])
        else:
            bend = oracle.curvature(points, alpha, zeta, t)
            assert abs(oracle.number(curvature[k]) - bend) <= 1e-11 * bend
            twist = oracle.torsion(points, alpha, zeta, t)
            assert abs(oracle.number(torsion[k]) - twist) <= 1e-11 * max(abs(twist), bend)


@pytest.mark.parametrize(("alpha", "zeta"), PAIRS)
def test_length(alpha, zeta):
    points = arch()
    exact = float(oracle.length(points, alpha, zeta))
    assert abs(Curve(points, alpha, zeta).length() - exact) <= 1e-12 * exact


# ---------------------------------------------------------------------------------------------- closed forms


def test_parabola():
    x = 2 * T - 1
    np.testing.assert_allclose(PARABOLA(T), np.stack([x, x**2], axis=-1), rtol=0, atol=1e-15)
    np.testing.assert_allclose(PARABOLA.signed_curvature(T), 2 / (1 + 4 * x**2) ** 1.5, rtol=1e-14)
    np.testing.assert_allclose(PARABOLA.curvature(T), PARABOLA.signed_curvature(T), rtol=1e-14)
    exact = np.sqrt(5) + np.arcsinh(2) / 2
    assert abs(PARABOLA.length() - exact) <= 1e-12 * exact
    assert abs(PARABOLA.length(0.5, 1.0) - exact / 2) <= 1e-12 * exact
    assert PARABOLA.length(1.0, 0.0) == pytest.approx(-exact, rel=1e-12)
    assert PARABOLA.length(0.3, 0.3) == 0.0


def test_signed_curvature_changes_sign_with_the_direction():
    back = Curve(PARABOLA.points[::-1], basis="bernstein")
    np.testing.assert_allclose(back.signed_curvature(1 - T), -PARABOLA.signed_curvature(T), rtol=1e-13)
    with pytest.raises(ValueError, match="plane curve"):
        TWISTED.signed_curvature(0.5)


def test_twisted_cubic():
    q = 9 * T**4 + 9 * T**2 + 1
    speed = np.sqrt(1 + 4 * T**2 + 9 * T**4)
    np.testing.assert_allclose(TWISTED.torsion(T), 3 / q, rtol=1e-13)
    np.testing.assert_allclose(TWISTED.curvature(T), 2 * np.sqrt(q) / speed**3, rtol=1e-13)
    mirrored = Curve(TWISTED.points * [1, 1, -1], basis="bernstein")
    np.testing.assert_allclose(mirrored.torsion(T), -3 / q, rtol=1e-13)


@pytest.mark.parametrize("basis", ["trigonometric", "bernstein"])
def test_straight_line(basis):
    along = np.array([2.0, -1.0, 2.0])
    line = Curve(np.array([0.0, 0.1, 0.3, 0.6, 0.7, 1.0])[:, None] * along, 0.5, -3.0, basis=basis)
    assert np.abs(line.curvature(T)).max() <= 1e-13
    assert np.isnan(line.torsion(T)).all()
    assert abs(line.length() - 3.0) <= 3e-12


def test_plane_curve_in_space_has_no_torsion():
    points = np.stack([*arch()[:, :2].T, np.zeros(6)], axis=-1) @ turn([1, 2, 3], 0.7).T
    curve = Curve(points, 1.0, -2.0)
    assert np.abs(curve.torsion(T)).max() <= 1e-12 * curve.curvature(T).max()


def test_plane_and_space_curve_agree():
    flat = arch()[:, :2]
    plane, space = Curve(flat, 0.5, -1.0), Curve(np.pad(flat, [(0, 0), (0, 1)]), 0.5, -1.0)
    np.testing.assert_array_equal(plane.curvature(T), space.curvature(T))
    np.testing.assert_allclose(np.abs(plane.signed_curvature(T)), space.curvature(T), rtol=1e-13)
    assert plane.length() == space.length()


# ---------------------------------------------------------------------------------------------- properties


@pytest.mark.parametrize("basis", ["trigonometric", "bernstein"])
def test_curve_starts_and_ends_at_its_control_points(basis):
    curve = Curve(arch(), 0.3, -4.0, basis=basis)
    np.testing.assert_array_equal(curve([0, 1]), curve.points[[0, 5]])


@repeatable
@given(st.floats(0, 1), st.floats(-4, 1), st.floats(-4, 1), st.integers(0, 2**32 - 1))
def test_curve_stays_in_the_hull_of_its_points(t, alpha, zeta, seed):
    rng = np.random.default_rng(seed)
    curve, direction = Curve(rng.normal(size=(6, 3)), alpha, zeta), rng.normal(size=3)
    heights = curve.points @ direction
    assert heights.min() - 1e-14 <= curve(t) @ direction <= heights.max() + 1e-14


@repeatable
@given(st.floats(0, 1), st.floats(-4, 1), st.floats(-4, 1))
def test_reversed_points_give_the_reversed_curve(t, alpha, zeta):
    points = arch()
    there, back = Curve(points, alpha, zeta), Curve(points[::-1], zeta, alpha)
    np.testing.assert_allclose(there(t), back(1.0 - t), rtol=0, atol=1e-14)


@repeatable
@given(st.floats(0.02, 0.98), st.floats(-3.5, 1), st.floats(-3.5, 1), st.floats(0, 6), st.floats(1e-3, 1e3))
def test_motion_and_scaling(t, alpha, zeta, angle, scale):
    rotation = turn([1, -2, 0.5], angle)
    here = Curve(rail(), alpha, zeta)
    there = Curve(scale * (rail() @ rotation.T) + 3.0 * scale, alpha, zeta)
    np.testing.assert_allclose(there(t), scale * (here(t) @ rotation.T) + 3.0 * scale, rtol=0, atol=3e-14 * scale)
    bend = here.curvature(t)
    assert abs(there.curvature(t) * scale - bend) <= 1e-11 * bend
    assert abs(there.torsion(t) * scale - here.torsion(t)) <= 1e-10 * (abs(here.torsion(t)) + bend)


def test_distance_from_the_origin_does_not_matter():
    points = np.round(arch() * 2**20) / 2**20  # so that the shift below is exact
    here, there = Curve(points, 0.5, -2.0), Curve(points + 2.0**24, 0.5, -2.0)
    np.testing.assert_array_equal(there.curvature(T), here.curvature(T))
    np.testing.assert_array_equal(there.torsion(T), here.torsion(T))
    assert there.length() == here.length()


def test_length_scales_and_adds_up():
    curve = Curve(arch(), -4.0, 1.0)
    whole = curve.length()
    assert abs(curve.length(0, 0.3) + curve.length(0.3, 1) - whole) <= 2e-12 * whole
    assert abs(Curve(1e3 * arch(), -4.0, 1.0).length() - 1e3 * whole) <= 2e-9 * whole
    chords = np.linalg.norm(np.diff(curve(np.linspace(0, 1, 2001)), axis=0), axis=1).sum()
    assert chords <= whole <= np.linalg.norm(np.diff(curve.points, axis=0), axis=1).sum()


def test_length_of_a_curve_that_turns_back_on_a_line():
    """The length is the sum of the ways between the turning points, where the speed has a corner."""
    way = np.array([0.0, 3.0, -1.3, 2.0, 0.2, 1.0])
    curve = Curve(np.outer(way, [1.0, 2.0, 2.0]), 0.3, -0.5)
    line = Curve(np.outer(way, [1.0, 0.0]), 0.3, -0.5)
    t = np.linspace(0, 1, 2001)
    speed = line.derivatives(t, 1)[1, :, 0]
    turns = [0.0]
    for k in np.flatnonzero(speed[1:] * speed[:-1] < 0):
        low, high = t[k], t[k + 1]
        for _ in range(60):
            middle = (low + high) / 2
            rising = line.derivatives(middle, 1)[1, 0] * speed[k] > 0
            low, high = (middle, high) if rising else (low, middle)
        turns.append(low)
    ways = np.abs(np.diff(line([*turns, 1.0])[:, 0]))
    assert len(ways) >= 3
    assert curve.length() == pytest.approx(3 * ways.sum(), rel=1e-12)


def test_length_to_any_tolerance():
    curve = Curve(arch(), 1.0, -4.0)
    best = curve.length(tolerance=1e-300)
    for tolerance in (1e-15, 1e-12, 1e-6, 1e-2):
        assert curve.length(tolerance=tolerance) == pytest.approx(best, rel=max(tolerance, 1e-14))


@pytest.mark.parametrize("points", [PARABOLA.points, arch()])
def test_comb_stands_on_the_outside_with_the_length_of_the_curvature(points):
    curve = Curve(points, basis="bernstein")
    t = np.linspace(0, 1, 51)
    tooth = curve.comb(t, 0.1) - curve(t)
    np.testing.assert_allclose(np.linalg.norm(tooth, axis=-1), 0.1 * curve.curvature(t), rtol=1e-12)
    _, first, second = curve.derivatives(t, 2)
    assert np.abs((tooth * first).sum(axis=-1)).max() <= 1e-13
    assert ((tooth * second).sum(axis=-1) < 0).all()
    longest = np.linalg.norm(curve.comb(t) - curve(t), axis=-1).max()
    assert longest == pytest.approx(0.25 * np.linalg.norm(np.diff(points, axis=0), axis=1).sum(), rel=1e-12)


def test_comb_of_a_straight_line_is_the_line():
    line = Curve(np.arange(6.0)[:, None] * [1.0, 2.0], basis="bernstein")
    np.testing.assert_allclose(line.comb(T), line(T), rtol=0, atol=1e-12)


def test_coincident_points_give_nan_not_an_error():
    curve = Curve(np.ones((6, 3)), 1.0, -4.0)
    assert np.isnan(curve.curvature(T)).all()
    assert np.isnan(curve.torsion(T)).all()
    assert np.isnan(curve.comb(T)).all()
    assert curve.length() == 0.0
    np.testing.assert_allclose(curve(T), 1.0, rtol=0, atol=1e-15)


@pytest.mark.parametrize("shape", [(), (4,), (2, 3), (2, 1, 3), (0,)])
def test_results_have_the_shape_of_the_parameters(shape):
    curve, t = Curve(arch(), 0.5, 0.5), np.full(shape, 0.4)
    assert curve(t).shape == (*shape, 3)
    assert curve.derivatives(t, 2).shape == (3, *shape, 3)
    assert curve.curvature(t).shape == curve.torsion(t).shape == shape
    assert curve.comb(t, 1.0).shape == (*shape, 3)


def test_curve_is_frozen():
    points = arch()
    curve = Curve(points)
    points[0] = 7.0
    assert (curve.points[0] != 7.0).any()
    with pytest.raises(ValueError, match="read-only"):
        curve.points[0, 0] = 1.0
    with pytest.raises(AttributeError):
        curve.alpha = 1.0
