"""NURBS surfaces against SciPy's B-splines, mpmath-free closed forms, and their own derivatives."""

import re

import numpy as np
import pytest
from scipy.interpolate import BSpline as ScipyBSpline

import quintrig
from quintrig.basis.bspline import BSpline, clamped, normalised
from quintrig.geometry.nurbs import nurbs

KNOTS = {
    "bezier": ([0, 0, 0, 0, 1, 1, 1, 1], 3),
    "clamped": ([0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3], 3),
    "uniform": (list(range(-3, 12)), 4),
    "linear": ([0, 0, 0.25, 0.5, 1, 1], 1),
    "creased": ([-1, -1, -1, 2, 2, 3, 3, 3], 2),
    "high": ([0] * 12 + [0.3] + [1] * 12, 11),
}


@pytest.mark.parametrize("name", KNOTS)
@pytest.mark.parametrize("order", [0, 1, 2, 3])
def test_functions_and_derivatives_are_scipys(name, order):
    knots, degree = KNOTS[name]
    functions = normalised(knots, degree)
    t = np.linspace(0, 1, 41)
    ours = functions.derivatives(t, order)[order]
    reference = ScipyBSpline(np.array(functions.knots), np.eye(functions.size), degree)
    theirs = reference(t, nu=order) if order <= degree else np.zeros_like(ours)
    if degree >= order:
        # Scipy takes the last span at t = 1 too; creases are compared away from the crease.
        smooth = ~np.isin(t, functions.breaks[1:-1])
        scale = np.abs(theirs).max()
        assert np.abs(ours - theirs)[smooth].max() <= 1e-13 * max(scale, 1)


@pytest.mark.parametrize("name", KNOTS)
def test_functions_sum_to_one_and_are_not_negative(name):
    knots, degree = KNOTS[name]
    values = normalised(knots, degree).derivatives(np.linspace(0, 1, 57), 2)
    np.testing.assert_allclose(values[0].sum(-1), 1, rtol=0, atol=1e-14)
    assert values[0].min() >= -1e-16
    assert np.abs(values[1].sum(-1)).max() <= 1e-12 * np.abs(values[1]).max()


def random_nurbs(seed):
    rng = np.random.default_rng(seed)
    points = (
        rng.normal(size=(7, 6, 3)) + np.stack(np.meshgrid(range(7), range(6), [0], indexing="ij"), -1)[:, :, 0] * 2.0
    )
    knots = (KNOTS["clamped"][0], [-2, -2, -2, 0, 1, 1.5, 4, 4, 4])
    return nurbs(points, rng.uniform(0.5, 2, size=(7, 6)), (3, 2), knots)


def test_partials_meet_central_differences_at_second_order():
    surface = random_nurbs(1)
    rng = np.random.default_rng(2)
    u, v = rng.uniform(0.05, 0.3, 30), rng.uniform(0.05, 0.3, 30)
    exact = surface.partials(u, v, 2)

    def error(h):
        du = (surface(u + h, v) - surface(u - h, v)) / (2 * h)
        duu = (surface(u + h, v) - 2 * surface(u, v) + surface(u - h, v)) / h**2
        cross = surface(u + h, v + h) - surface(u - h, v + h) - surface(u + h, v - h) + surface(u - h, v - h)
        pairs = ((du, exact[1, 0]), (duu, exact[2, 0]), (cross / (4 * h**2), exact[1, 1]))
        return np.array([np.abs(a - b).max() for a, b in pairs])

    coarse, fine = error(2e-3), error(1e-3)
    assert (fine < 1e-2 * np.abs(exact[2, 0]).max()).all()
    np.testing.assert_allclose(np.log2(coarse / fine), 2, atol=0.15)


def quarter_sphere(radius):
    """A rational biquadratic octant-like patch of a sphere: two exact quarter circles."""
    arc, weights = np.array([[1, 0], [1, 1], [0, 1]]), np.array([1, np.sqrt(0.5), 1])
    points = np.array([[[r * x, r * y, z] for x, y in arc] for r, z in arc]) * radius
    return nurbs(points, np.outer(weights, weights))


def test_rational_patch_is_an_exact_sphere_with_exact_curvature():
    surface = quarter_sphere(2.5)
    u, v = quintrig.grid(9, 9)
    assert surface.rational
    np.testing.assert_allclose(np.linalg.norm(surface(u, v), axis=-1), 2.5, rtol=1e-15)
    p = surface.partials(u[:-1], v, 2)
    normal = np.cross(p[1, 0], p[0, 1])
    normal /= np.linalg.norm(normal, axis=-1)[..., None]
    first = [[(p[1, 0] * p[1, 0]).sum(-1), (p[1, 0] * p[0, 1]).sum(-1)], [0, (p[0, 1] * p[0, 1]).sum(-1)]]
    second = [(p[2, 0] * normal).sum(-1), (p[1, 1] * normal).sum(-1), (p[0, 2] * normal).sum(-1)]
    gauss = (second[0] * second[2] - second[1] ** 2) / (first[0][0] * first[1][1] - first[0][1] ** 2)
    np.testing.assert_allclose(gauss, 1 / 2.5**2, rtol=1e-12)


def test_equal_weights_make_no_quotient():
    points = np.random.default_rng(3).normal(size=(3, 4, 3))
    with_weights, without = nurbs(points, np.full((3, 4), 7.0)), nurbs(points)
    assert not with_weights.rational
    np.testing.assert_array_equal(with_weights(0.3, 0.7), without(0.3, 0.7))


def test_inside_a_square_with_a_hole():
    outer = [[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9]]
    hole = [[0.4, 0.4], [0.4, 0.6], [0.6, 0.6], [0.6, 0.4]]
    surface = nurbs(np.random.default_rng(4).normal(size=(2, 2, 3)), trim=[outer, hole])
    u, v = np.array([0.05, 0.2, 0.5, 0.5, 0.95]), np.array([0.5, 0.5, 0.5, 0.3, 0.5])
    np.testing.assert_array_equal(surface.inside(u, v), [False, True, False, True, False])
    assert nurbs(np.zeros((2, 2, 3))).inside(u, v).all()


@pytest.mark.parametrize(
    ("knots", "degree", "message"),
    [
        ([0, 0, 1], 1, "expected 4 or more for degree 1, found 3"),
        ([0, 0, 2, 1, 3, 3], 1, r"knots\[3\]: expected at least"),
        ([0, 0, 0, 0, 0, 0], 2, "expected them to rise"),
        ([0, 0, 0, 1, 1, 1, 2, 2, 2], 2, "no interior knot more than 2"),
        ([0, 0, 1, 1], 0, "degree: expected 1 to 25"),
        ([0, 0, float("nan"), 1], 1, "finite"),
    ],
)
def test_knots_that_are_none_are_refused(knots, degree, message):
    with pytest.raises(ValueError, match=message):
        normalised(knots, degree)


def test_counts_and_weights_that_do_not_fit_are_refused():
    points = np.zeros((4, 4, 3))
    with pytest.raises(ValueError, match=r"knots\[1\]: expected 6 for 4 control points of degree 1, found 4"):
        nurbs(points, None, (3, 1), ([0, 0, 0, 0, 1, 1, 1, 1], [0, 0, 1, 1]))
    with pytest.raises(ValueError, match=r"weights\[2\]\[1\]: expected a number greater than 0"):
        nurbs(points, [[1.0] * 4] * 2 + [[1.0, 0.0, 1.0, 1.0]] + [[1.0] * 4])


def test_clamped_repeats_ends_and_breaks():
    functions = clamped([0, 0.5, 2], 3, 2)
    assert functions == BSpline((0, 0, 0, 0, 0.25, 0.25, 1, 1, 1, 1), 3)
    np.testing.assert_array_equal(functions.breaks, [0, 0.25, 1])


def test_a_nurbs_model_comes_back_from_its_own_keys():
    keys = {
        "kind": "nurbs",
        "degrees": [1, 2],
        "knots": [[0, 0, 1, 1], [0, 0, 0, 5, 5, 5]],
        "points": np.arange(18.0).reshape(2, 3, 3).tolist(),
        "weights": [[1.0, 2.0, 1.0], [1.0, 1.0, 3.0]],
    }
    model = quintrig.Model.from_dict(keys)
    again = quintrig.Model.from_dict(model.to_dict())
    np.testing.assert_array_equal(again.surface(0.3, 0.6), model.surface(0.3, 0.6))
    with pytest.raises(quintrig.ModelError, match="degrees"):
        quintrig.Model.from_dict(keys | {"degrees": [1, 26]})


BEZIER, GOOD = [0, 0, 0, 1, 1, 1], [0, 0, 0, 0.5, 1, 1, 1]


@pytest.mark.parametrize(
    ("degrees", "knots", "message"),
    [
        ((2, 2), ([0, 0, 0, 0, 1, 1, 1], GOOD), "knots[0]: expected 6 for 3 control points of degree 2, found 7"),
        ((2, 2), (BEZIER, [0, 0, 0, 1, 1, 1]), "knots[1]: expected 7 for 4 control points of degree 2, found 6"),
        (
            (2, 2),
            ([0, 0, 0, 1, 1], [0, 0, 0, 1, 1, 1]),
            "knots[0]: expected 6 for 3 control points of degree 2, found 5",
        ),
        ((2, 2), (BEZIER, [0, 0, 0.5, 0.25, 1, 1, 1]), "knots[1][3]: expected at least 0.5, the knot before"),
        ((2, 2), (BEZIER, [0, 0, 0, 0, 1, 1, 1]), "knots[1]: expected no interior knot more than 2 times"),
        ((3, 2), ([0, 0, 0, 0, 1, 1, 1, 1], GOOD), "degrees[0]: expected at most 2 for 3 control points"),
        ((0, 2), ([0, 0, 1, 1], GOOD), "degrees[0]: expected 1 to 25, found 0"),
    ],
)
def test_what_is_wrong_with_knots_is_told_with_the_right_count(degrees, knots, message):
    with pytest.raises(ValueError, match=f"^{re.escape(message)}"):
        nurbs(np.zeros((3, 4, 3)), None, degrees, knots)
