"""Extremes against closed forms and against dense sampling, on edges, at corners and beside singular points."""

import numpy as np
import pytest

import quintrig
from quintrig.analysis.extremes import find_extremes
from quintrig.analysis.table import tabulate

WAVED = np.stack(
    [*np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij"), np.random.default_rng(0).normal(size=(6, 6))], axis=-1
)


def test_a_saddle_has_its_extremes_in_the_middle_and_at_the_corners():
    found = find_extremes(quintrig.hyperbolic_paraboloid(1), ("gaussian", "mean", "k1"))
    least, most = found["gaussian"].minimum, found["gaussian"].maximum
    assert (least.value, least.u, least.v) == pytest.approx((-1, 0.5, 0.5), abs=1e-8)
    assert least.unique
    assert least.describe() == ""
    assert most.value == pytest.approx(-1 / 9, rel=1e-14)
    assert (most.u, most.v) == (0, 0)  # exactly: corners are sampled
    assert not most.unique
    assert "several places" in most.describe()
    assert found["mean"].maximum.value == pytest.approx(3**-1.5, rel=1e-14)
    assert (found["mean"].maximum.u, found["mean"].maximum.v) == (0, 1)
    np.testing.assert_allclose(most.point, [-1, -1, 1], atol=1e-15)
    assert found["k1"].maximum.value == pytest.approx(1, rel=1e-12)


def test_an_extreme_off_the_samples_is_met():
    # z = x³ - 3xy²: across y = 0, κ = -6x / sqrt(1 + 9x⁴), greatest at x = -1/√3, and twice more by symmetry.
    found = find_extremes(quintrig.monkey_saddle(1), ("k1",), samples=30)["k1"].maximum
    assert found.value == pytest.approx(np.sqrt(6), rel=1e-13)
    assert np.hypot(*found.point[:2]) == pytest.approx(1 / np.sqrt(3), abs=1e-6)
    assert not found.unique


def test_a_torus_has_circles_of_extremes():
    found = find_extremes(quintrig.torus(3, 1), ("gaussian", "mean", "k1"))
    assert (found["gaussian"].maximum.value, found["gaussian"].minimum.value) == pytest.approx((1 / 4, -1 / 2))
    assert (found["gaussian"].maximum.u, found["gaussian"].maximum.v) == (0, 0)
    assert found["gaussian"].minimum.u == pytest.approx(0.5, abs=1e-8)
    assert not found["gaussian"].maximum.unique
    assert found["mean"].mean.value == pytest.approx(-0.5, rel=1e-12)
    assert found["mean"].grid_mean != pytest.approx(-0.5, rel=1e-2)  # it depends on the parametrisation


def test_rings_of_extremes_between_the_samples_do_not_hide_another():
    # A cylinder over a curve with two bends: with few samples the sharper one looks blunter, and each is a whole line.
    points = np.array([[0, 0], [0.2, 1.3], [2, 1], [3, 1.6], [4.1, 1.4], [4, 0]]) @ np.eye(2, 3)
    surface = quintrig.ruled(points, points + np.array([0, 0, 3]), (0.3, 0.9, 0.3, 0.9))
    curve = quintrig.Curve(points[:, :2], 0.3, 0.9)
    bends = np.abs(curve.signed_curvature(np.linspace(0, 1, 200001)))
    for samples in (7, 12, 20, 65):
        found = find_extremes(surface, ("curvedness",), samples)["curvedness"].maximum
        assert found.value == pytest.approx(bends.max() / np.sqrt(2), rel=1e-9)
        assert not found.unique
        assert found.v == 0


@pytest.mark.parametrize("radius", [1e-3, 1.0, 1e3])
def test_a_constant_is_told_as_one_that_is_not_unique(radius):
    found = find_extremes(quintrig.sphere(radius), ("gaussian", "mean"))["gaussian"]
    for end in (found.minimum, found.maximum):
        assert end.value == pytest.approx(radius**-2, rel=1e-12)
        assert end.status == "attained"
        assert not end.unique
    assert found.undefined == 2 * 65  # both poles
    assert found.samples == 65 * 65


def test_a_curvature_that_vanishes_is_zero_not_its_rounding():
    strip = quintrig.developable(
        np.stack(
            [
                np.cos(np.radians(np.linspace(0, 60, 6))),
                np.sin(np.radians(np.linspace(0, 60, 6))),
                np.full(6, 0.3),
                -10 - 0.2 * np.arange(6.0),
            ],
            axis=-1,
        ),
        [[0, 0, 1, 0], [0.1, 0.05, 1, -5]],
        (0.5, -1),
    )
    for surface, key in ((strip, "gaussian"), (quintrig.cylinder(), "gaussian"), (quintrig.catenoid(), "mean")):
        found = find_extremes(surface, (key,))[key]
        assert (found.minimum.value, found.maximum.value) == (0, 0)
        assert not found.minimum.unique


@pytest.mark.parametrize("shape", [(1, 1, -3, -3), (0, 0, 0, 0), (-2, 1, 1, -3)])
def test_nothing_sampled_densely_lies_beyond_the_extremes(shape):
    surface = quintrig.tensor(WAVED, shape)
    keys = ("gaussian", "mean", "k1", "k2", "curvedness", "shape_index")
    dense = quintrig.analyse(surface, *quintrig.grid(701, 701), keys)
    found = find_extremes(surface, keys)
    for key in keys:
        spread = np.ptp(dense[key])
        assert found[key].minimum.value <= dense[key].min() + 1e-12 * spread, key
        assert found[key].maximum.value >= dense[key].max() - 1e-12 * spread, key
        # And the values are taken where it says.
        for end in (found[key].minimum, found[key].maximum):
            there = quintrig.analyse(surface, end.u, end.v, (key,))[key]
            assert there == pytest.approx(end.value, abs=1e-9 * spread), key
            np.testing.assert_allclose(end.point, surface(end.u, end.v), atol=1e-12)


def test_places_do_not_move_with_scale_and_turn_with_the_normal():
    one = find_extremes(quintrig.tensor(WAVED, (1, 1, -3, -3)), ("gaussian", "mean"))
    other = find_extremes(quintrig.tensor(1e-3 * WAVED, (1, 1, -3, -3), flip=True), ("gaussian", "mean"))
    assert other["gaussian"].maximum.value == pytest.approx(1e6 * one["gaussian"].maximum.value, rel=1e-10)
    assert other["mean"].minimum.value == pytest.approx(-1e3 * one["mean"].maximum.value, rel=1e-10)
    assert (other["mean"].minimum.u, other["mean"].minimum.v) == pytest.approx(
        (one["mean"].maximum.u, one["mean"].maximum.v), abs=1e-6
    )
    assert "against" in other["mean"].orientation


def test_beside_an_apex_there_is_no_least_mean_curvature():
    found = find_extremes(quintrig.cone(), ("mean", "gaussian"))
    assert found["mean"].minimum.status == "unbounded"
    assert "without bound" in found["mean"].minimum.describe()
    assert found["mean"].maximum.status == "attained"
    assert found["mean"].maximum.value == pytest.approx(-1 / np.sqrt(5), rel=1e-12)  # at the base
    assert found["gaussian"].minimum.value == 0


def test_an_edge_with_alpha_minus_four_has_unbounded_curvature():
    found = find_extremes(quintrig.tensor(WAVED, (-4, 1, -3, -3)), ("gaussian", "curvedness"))
    assert found["gaussian"].minimum.status == "unbounded"
    assert found["curvedness"].maximum.status == "unbounded"
    assert found["curvedness"].maximum.u < 1e-3
    assert found["curvedness"].minimum.status == "attained"


def test_a_limit_at_a_pole_is_approached_not_attained():
    # Least K of the ellipsoid x²/9 + y²/4 + z² = 1: at the poles, c²/(a²b²), where the parameters are singular.
    found = find_extremes(quintrig.ellipsoid(3, 2, 1), ("gaussian",))["gaussian"]
    assert found.minimum.status == "approached"
    assert found.minimum.value == pytest.approx(1 / 36, rel=1e-6)
    assert found.maximum.value == pytest.approx(9 / 4, rel=1e-13)
    assert found.maximum.status == "attained"


def test_invariants_have_no_bound_where_the_tangent_plane_is_vertical():
    found = find_extremes(quintrig.sphere(), ("beta0", "beta0_surface"))
    assert found["beta0"].maximum.status == "unbounded"
    assert found["beta0"].mean.status == "grows without bound"
    assert found["beta0_surface"].maximum.value == pytest.approx(1, rel=1e-14)
    assert found["beta0"].undefined == 3 * 65  # poles and equator


def test_where_nothing_is_defined_there_are_no_extremes():
    found = find_extremes(quintrig.tensor(WAVED * 0))["mean"]
    assert found.minimum.status == "undefined"
    assert np.isnan(found.maximum.value)
    assert np.isnan(found.mean.value)
    assert found.undefined == found.samples


def test_bad_arguments_are_refused():
    with pytest.raises(ValueError, match="hk_type: expected a scalar quantity"):
        find_extremes(quintrig.sphere(), ("hk_type",))
    with pytest.raises(ValueError, match="nu: expected 2 or more"):
        find_extremes(quintrig.sphere(), samples=1)


def test_rounding_of_a_tilted_plane_is_zero_as_in_a_table():
    x = np.linspace(0.0, 100.0, 6)
    section, trajectory = np.stack([x, 0 * x, 0.35 * x], axis=-1), np.stack([0 * x, x, 0.15 * x], axis=-1)
    surface = quintrig.swept(section, trajectory, (0.3, -1, 0.2, -2.3))
    keys = ("gaussian", "mean", "k1", "k2", "curvedness")
    for key, found in find_extremes(surface, keys).items():
        assert (found.minimum.value, found.maximum.value) == (0, 0), key
    table = tabulate(surface, *quintrig.grid(9, 9), keys)
    for column in table.columns:
        if column.key in keys:
            assert set(column.rounded) == {0.0}, column.key
