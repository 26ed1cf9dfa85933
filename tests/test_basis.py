"""The families of functions: what a basis must satisfy, and its values and derivatives against 40 digits."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import oracle
from catalogue import BASES, FAMILIES, PAIRS
from quintrig.basis.bernstein import Bernstein, TangentBernstein
from quintrig.basis.elementary import Circular
from quintrig.basis.formula_checks import check_values
from quintrig.basis.library import LIBRARY
from quintrig.basis.registry import family
from quintrig.basis.trigonometric import Trigonometric

T = np.concatenate([[0.0, 1.0, 0.5, 1e-9, 1 - 1e-9, 1e-3], np.random.default_rng(0).random(12)])
HALF = 0.5 * np.pi

parameters = st.floats(0.0, 1.0)
shapes = st.floats(-4.0, 1.0)
repeatable = settings(deadline=None, derandomize=True, max_examples=200)


@pytest.mark.parametrize("name", FAMILIES)
def test_derivatives_have_the_shape_of_the_parameters(name):
    functions = FAMILIES[name]
    for shape in ((), (3,), (2, 1), (2, 3, 4), (0,), (3, 0)):
        t = np.full(shape, 0.25)
        assert functions.derivatives(t, 3).shape == (4, *shape, functions.size)
    np.testing.assert_array_equal(functions.derivatives([0, 1], 1), functions.derivatives(np.array([0.0, 1.0]), 1))


@pytest.mark.parametrize("name", FAMILIES)
def test_each_derivative_is_the_limit_of_differences(name):
    functions = FAMILIES[name]
    # Away from the knots of the B-spline, at 1/4 and 1/2, where its third derivative jumps.
    t = np.array([0.1, 0.2, 0.33, 0.42, 0.66, 0.85])
    exact = functions.derivatives(t, 5)

    def difference(h):
        return (functions.derivatives(t + h, 4) - functions.derivatives(t - h, 4)) / (2 * h)

    h = 1e-3
    coarse, fine = (np.abs(difference(step) - exact[1:]).max(axis=(1, 2)) for step in (h, h / 2))
    size = np.abs(exact[1:]).max(axis=(1, 2))
    # Second order: half the step, a quarter of the error, until rounding.
    floor = 1e-11 * np.abs(exact[:-1]).max(axis=(1, 2)) / h
    assert (fine <= coarse / 3.9 + floor).all()
    assert (coarse <= 1e-3 * size + floor).all()


@pytest.mark.parametrize("name", BASES)
def test_basis_sums_to_one_and_is_not_negative(name):
    values = BASES[name].derivatives(np.linspace(0, 1, 201), 4)
    np.testing.assert_allclose(values[0].sum(axis=-1), 1.0, rtol=0, atol=4e-15)
    for k in range(1, 5):
        assert np.abs(values[k].sum(axis=-1)).max() <= 1e-13 * max(1.0, np.abs(values[k]).max())
    assert values[0].min() >= 0.0


@pytest.mark.parametrize("name", BASES)
def test_basis_starts_at_the_first_and_ends_at_the_last_function(name):
    size = BASES[name].size
    np.testing.assert_array_equal(BASES[name].derivatives([0, 1], 0)[0], np.eye(size)[[0, size - 1]])


@repeatable
@given(parameters, shapes, shapes)
def test_trigonometric_basis_is_convex_and_symmetric(t, alpha, zeta):
    values = Trigonometric(alpha, zeta).derivatives(t, 0)[0]
    assert values.min() >= 0.0
    assert abs(values.sum() - 1.0) <= 4e-15
    mirrored = Trigonometric(zeta, alpha).derivatives(1.0 - t, 0)[0]
    np.testing.assert_allclose(values, mirrored[::-1], rtol=0, atol=2e-15)


@repeatable
@given(parameters, shapes, shapes)
def test_trigonometric_basis_is_affine_in_its_shape_parameters(t, alpha, zeta):
    def at(a, z):
        return Trigonometric(a, z).derivatives(t, 2)

    plain = at(0.0, 0.0)
    s, c = math.sin(HALF * t), math.cos(HALF * t)
    moved = at(alpha, zeta) - plain
    start = alpha * s * (1 - s) ** 4 * np.array([-1, 1, 0, 0, 0, 0])
    end = zeta * c * (1 - c) ** 4 * np.array([0, 0, 0, 0, 1, -1])
    np.testing.assert_allclose(moved[0], start + end, rtol=0, atol=4e-15)
    apart = at(alpha, 0.0) + at(0.0, zeta) - 2.0 * plain
    np.testing.assert_allclose(moved, apart, rtol=0, atol=1e-12)


@pytest.mark.parametrize(("alpha", "zeta"), [(1.001, 0.0), (0.0, 1.001), (-4.001, 0.0), (0.0, -4.001)])
def test_outside_the_range_the_basis_turns_negative(alpha, zeta):
    near = np.logspace(-6, -1, 101)
    values = Trigonometric(alpha, zeta, unchecked=True).derivatives([*near, *(1 - near)], 0)[0]
    assert values.min() < 0.0


@pytest.mark.parametrize(("alpha", "zeta"), [*PAIRS, (2.0, -7.5)])
def test_trigonometric_values_and_derivatives_to_order_six(alpha, zeta):
    found = Trigonometric(alpha, zeta, unchecked=True).derivatives(T, 6)
    for k, t in enumerate(T):
        exact = oracle.trigonometric(t, alpha, zeta, 6)
        for order in range(7):
            largest = max(abs(x) for x in exact[order])
            errors = [abs(oracle.number(a) - b) for a, b in zip(found[order, k], exact[order], strict=True)]
            assert max(errors) <= 1e-13 * max(largest, 1e-12), f"order {order} at {t}"
            if order == 0 and alpha <= 1.0:  # each function to its own relative accuracy; the oracle has 60 digits
                assert all(e <= 1e-14 * max(x, 1e-40) for e, x in zip(errors, exact[0], strict=True)), f"at {t}"


@pytest.mark.parametrize("t", [1e-4, 1e-9, 1 - 1e-4, 1 - 2**-40])
def test_slopes_vanish_with_relative_accuracy_at_minus_four(t):
    found = Trigonometric(-4.0, -4.0).derivatives(t, 1)[1]
    exact = oracle.trigonometric(t, -4.0, -4.0, 1)[1]
    assert max(abs(x) for x in exact) < 1e-2
    assert all(abs(oracle.number(a) - b) <= 1e-14 * max(abs(b), 1e-40) for a, b in zip(found, exact, strict=True))


@pytest.mark.parametrize(("alpha", "zeta"), PAIRS)
def test_derivatives_at_the_end_points(alpha, zeta):
    """FORMULAS: z'(0) = (π/2)(4+α)(P1-P0), z''(0) = π²[(3+2α)P0 - 2(3+α)P1 + 3P2], z'''(0) likewise; mirrored at 1."""

    def start(a):
        first = HALF * (4 + a) * np.array([-1, 1, 0, 0, 0, 0])
        second = np.pi**2 * np.array([3 + 2 * a, -2 * (3 + a), 3, 0, 0, 0])
        third = np.pi**3 / 8 * np.array([-5 * (7 * a + 4), 35 * a + 68, -48, 0, 0, 0])
        return np.array([first, second, third])

    found = Trigonometric(alpha, zeta).derivatives([0.0, 1.0], 3)
    signs = np.array([-1, 1, -1])[:, None]
    np.testing.assert_allclose(found[1:, 0], start(alpha), rtol=0, atol=1e-12)
    np.testing.assert_allclose(found[1:, 1], signs * start(zeta)[:, ::-1], rtol=0, atol=1e-12)


@pytest.mark.parametrize(("alpha", "zeta"), PAIRS)
def test_hodograph_functions_are_positive_and_give_the_derivative(alpha, zeta):
    functions = Trigonometric(alpha, zeta)
    t = np.linspace(0, 1, 101)
    slopes = functions.slopes(t, 3)
    assert slopes[0].min() >= 0.0
    points = np.random.default_rng(1).normal(size=(6, 3))
    derived = functions.derivatives(t, 4) @ points
    scale = np.abs(derived[1:]).max(axis=(1, 2), keepdims=True)
    assert (np.abs(slopes @ np.diff(points, axis=0) - derived[1:]) <= 1e-13 * scale).all()


def test_divided_hodograph_functions_times_the_factors_are_the_others():
    functions = Trigonometric(-4.0, -4.0)
    t = np.linspace(0, 1, 101)
    s, c = np.sin(HALF * t)[:, None], np.cos(HALF * t)[:, None]
    whole = functions.slopes(t, 0)[0]
    for start, end in ((True, False), (False, True), (True, True)):
        divided = functions.slopes(t, 0, start, end)[0]
        np.testing.assert_allclose(divided * (s if start else 1) * (c if end else 1), whole, rtol=0, atol=1e-14)
        assert (divided[0] > 0).any() or not start
        assert (divided[-1] > 0).any() or not end


@pytest.mark.parametrize("degree", [0, 1, 2, 5, 11])
def test_bernstein_values_and_derivatives_to_order_six(degree):
    found = Bernstein(degree).derivatives(T, 6)
    for k, t in enumerate(T):
        exact = oracle.bernstein(t, degree, 6)
        for order in range(7):
            largest = max(abs(x) for x in exact[order])
            for a, b in zip(found[order, k], exact[order], strict=True):
                assert abs(oracle.number(a) - b) <= 1e-13 * max(largest, 1), f"order {order} at {t}"


@pytest.mark.parametrize("degree", [1, 10, 18])
def test_tangent_bernstein_is_bernstein_in_the_tangent_of_half_the_angle(degree):
    found = TangentBernstein(degree).derivatives(T, 4)
    quarter = oracle.mp.pi / 4
    for k, t in enumerate(T):
        # Derivatives by t of polynomials in w = tan(πt/4), through the powers of w: w' = (π/4)(1 + w²).
        w = oracle.mp.tan(quarter * oracle.number(t))
        for i in range(0, degree + 1, 3):
            polynomial = [oracle.ZERO] * i + [
                oracle.mp.binomial(degree, i) * oracle.mp.binomial(degree - i, j) * (-1) ** j
                for j in range(degree - i + 1)
            ]
            for order in range(5):
                exact = oracle.mp.fsum(x * w**j for j, x in enumerate(polynomial))
                scale = np.abs(found[order, k]).max() + 1.0
                assert abs(oracle.number(found[order, k, i]) - exact) <= 1e-13 * scale, f"order {order} at {t}"
                slope = [quarter * j * x for j, x in enumerate(polynomial)][1:]
                polynomial = [
                    (slope[j] if j < len(slope) else 0) + (slope[j - 2] if 0 <= j - 2 < len(slope) else 0)
                    for j in range(len(slope) + 2)
                ]


@pytest.mark.parametrize("start", [-1.0, 0.0, 1.0, 2.0])
def test_circular_functions_are_exact_at_whole_right_angles(start):
    found = Circular(start, start + 4.0).derivatives([0.0, 0.25, 0.5, 0.75, 1.0], 0)[0]
    expected = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])
    np.testing.assert_array_equal(found, expected[(int(start) + np.arange(5)) % 4])
    assert not np.signbit(found[found == 0.0]).any()


def test_family_gives_the_basis_that_fits_the_points():
    assert family("trigonometric", 6, (1.0, -2.0)) == Trigonometric(1.0, -2.0)
    assert family("bernstein", 4) == Bernstein(3)
    with pytest.raises(ValueError, match="expected 6 control points"):
        family("trigonometric", 5)


@pytest.mark.parametrize("entry", LIBRARY, ids=lambda entry: entry.name)
def test_the_formulas_that_are_vouched_for_have_values_in_all_of_their_range(entry):
    basis = entry.basis()
    assert basis.vouched
    check_values(basis.trees, basis.parameters)
