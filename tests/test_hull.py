"""The convex-hull property: distances against plane geometry, and the basis inside and outside its range."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import quintrig
from quintrig.enclosures.convex_hull import check_curve_hull, check_hull, hull_distances

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)


@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_distances_from_a_cube(scale):
    points = [[0.5, 0.5, 0.5], [1, 1, 1], [0.5, 0.5, 1.25], [2, 0.5, 2], [-1, -1, -1], [0.3, 1.0, 0.2]]
    expected = [0, 0, 0.25, np.sqrt(2), np.sqrt(3), 0]
    np.testing.assert_allclose(
        hull_distances(scale * np.array(points), scale * CUBE), scale * np.array(expected), rtol=1e-9
    )


def test_distances_from_flat_collinear_and_coincident_points():
    square = CUBE[:4]  # in the plane of y and z
    np.testing.assert_allclose(
        hull_distances([[3, 0.5, 0.5], [0, 0.5, 0.5], [0, 4, 0.5]], square), [3, 0, 3], rtol=1e-9
    )
    segment = np.outer(np.linspace(0, 1, 6), [1, 1, 0])
    np.testing.assert_allclose(
        hull_distances([[1, 0, 0], [2, 2, 1], [0.25, 0.25, 0]], segment), [np.sqrt(0.5), np.sqrt(3), 0], rtol=1e-9
    )
    np.testing.assert_allclose(hull_distances([[0, 0], [3, 4]], np.zeros((5, 2))), [0, 5], rtol=1e-9)


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**6), dimension=st.sampled_from([2, 3]), away=st.floats(0, 10))
def test_a_point_beyond_a_supporting_plane_is_as_far_as_it_says(seed, dimension, away):
    rng = np.random.default_rng(seed)
    control = rng.normal(size=(12, dimension))
    direction = rng.normal(size=dimension)
    direction /= np.linalg.norm(direction)
    # The nearest point of the hull to a point straight out from its outermost vertex is that vertex.
    vertex = control[np.argmax(control @ direction)]
    assert hull_distances(vertex + away * direction, control) == pytest.approx(away, rel=1e-9, abs=1e-11)
    inside = rng.dirichlet(np.ones(12)) @ control
    assert hull_distances(inside, control) == 0


@settings(max_examples=20, deadline=None)
@given(seed=st.integers(0, 10**6), shape=st.tuples(*[st.floats(-4, 1)] * 4), flat=st.sampled_from([1, 1e-8, 0]))
def test_curves_and_surfaces_in_the_range_stay_inside(seed, shape, flat):
    rng = np.random.default_rng(seed)
    net = rng.normal(size=(6, 6, 3)) * [1, 1, flat]
    assert check_hull(quintrig.tensor(net, shape), 9, 9).inside
    assert check_curve_hull(quintrig.Curve(net[0], *shape[:2]), 33).inside
    assert check_curve_hull(quintrig.Curve(net[0, :, :2], *shape[2:]), 33).inside


def test_outside_the_range_the_curve_leaves_by_what_the_formula_says():
    # On the line with points 0, 1, 1, 1, 1, 1 the curve is 1 - f0: with α = 2 f0 < 0 where α s > 1, so x > 1 there.
    points = np.array([[0.0, 0], [1, 0], [1, 0], [1, 0], [1, 0], [1, 0]])
    curve = quintrig.Curve(points, 2, 0, unchecked_shape=True)
    check = check_curve_hull(curve, 1001)
    sine = np.sin(np.pi / 2 * np.linspace(0, 1, 1001))
    beyond = (1 - sine) ** 4 * (2 * sine - 1)  # greatest at s = 0.6
    assert check.distance == pytest.approx(beyond.max(), rel=1e-9)
    assert np.sin(np.pi / 2 * check.at[0]) == pytest.approx(0.6, abs=2e-3)
    assert not check.inside
    assert (beyond > 1e-11).sum() <= check.outside <= (beyond > 1e-13).sum()


def test_outside_the_range_the_surface_leaves_too():
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    check = check_hull(quintrig.tensor(np.stack([x, y, x * y], axis=-1), (-6, 0, 0, 0), unchecked_shape=True))
    assert check.distance > 0.01
    assert check.outside > 0
    assert len(check.at) == 2
    assert check.samples == 33 * 33


def test_bad_arguments_are_refused():
    with pytest.raises(ValueError, match="no control net"):
        check_hull(quintrig.sphere())
    with pytest.raises(ValueError, match="expected 3 coordinates"):
        hull_distances([[0.0, 0]], CUBE)
    with pytest.raises(ValueError, match="found none"):
        hull_distances([[0.0, 0]], np.zeros((0, 2)))
    with pytest.raises(ValueError, match="NaN"):
        hull_distances([[0.0, np.nan, 0]], CUBE)
    with pytest.raises(ValueError, match="samples: expected 2"):
        check_curve_hull(quintrig.Curve(CUBE[:6]), 1)
