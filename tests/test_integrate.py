"""Integrals against closed forms, their errors, and what is said of those that are infinite."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import quintrig
from quintrig.analysis.integrate import INTEGRALS, area_means, area_weights, integrals, orientation

PI = np.pi
QUARTER = [[0, 0, 0], [1, 2, 0], [3, 3, 1], [5, 2, 1], [7, 1, 0], [9, 2, -1]]


def waved(seed=0, amplitude=1.0):
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    return np.stack([x, y, amplitude * rng.normal(size=(6, 6))], axis=-1)


CLOSED = {
    "sphere": (
        quintrig.sphere(2),
        {"area": 16 * PI, "total_gaussian": 4 * PI, "total_mean": -8 * PI, "bending_energy": 8 * PI},
    ),
    "ellipsoid": (quintrig.ellipsoid(3, 2, 1), {"total_gaussian": 4 * PI}),
    "torus": (
        quintrig.torus(3, 1),
        {
            "area": 12 * PI**2,
            "total_gaussian": 0,
            "total_mean": -6 * PI**2,
            "bending_energy": 4 * PI**2 * 9 / np.sqrt(8),
        },
    ),
    "cylinder": (
        quintrig.cylinder(2, 3),
        {"area": 12 * PI, "total_gaussian": 0, "total_mean": -3 * PI, "bending_energy": 3 * PI},
    ),
    "catenoid": (
        quintrig.catenoid(1.5, 4),
        {
            "area": PI * 1.5 * (4 + 1.5 * np.sinh(4 / 1.5)),
            "total_gaussian": -4 * PI * np.tanh(2 / 1.5),
            "total_mean": 0,
            "bending_energy": 8 * PI * np.tanh(2 / 1.5),
        },
    ),
    "helicoid": (
        quintrig.helicoid(2, 2 * PI * 0.7),
        {"total_gaussian": -4 * PI * 2 / np.hypot(0.7, 2), "total_mean": 0},
    ),
    "enneper": (quintrig.enneper(1), {"area": 4 + 16 / 3 + 8 / 5 + 8 / 9, "total_mean": 0}),
    "hyperbolic paraboloid": (
        quintrig.hyperbolic_paraboloid(1),
        {"total_gaussian": -2 * PI / 3, "total_mean": 0, "thin_plate_energy": 32},
    ),
    "plane": (
        quintrig.ruled([[0, 0], [4, 0]] @ np.eye(2, 3), [[0, 3], [4, 3]] @ np.eye(2, 3), basis="bernstein"),
        {"area": 12, "total_gaussian": 0, "total_mean": 0, "bending_energy": 0, "thin_plate_energy": 0},
    ),
}


@pytest.mark.parametrize("name", CLOSED)
def test_closed_forms_are_met_within_the_stated_error(name):
    surface, expected = CLOSED[name]
    result = integrals(surface)
    for key, value in expected.items():
        assert result[key].converged, key
        # The error is that of the coarser resolution; sums of a million terms round to about 1e-13.
        assert abs(result[key].value - value) <= result[key].error + 1e-13 * max(abs(value), 10), key
        assert result[key].error <= 1e-8 * max(abs(value), 10), key


def test_total_curvature_and_bending_of_a_minimal_surface_are_one():
    result = integrals(quintrig.enneper(1))
    assert result.bending_energy.value == pytest.approx(-2 * result.total_gaussian.value, rel=1e-12)


@pytest.mark.parametrize("shape", [(0, 0), (1, -3), (-4, 1)])
def test_a_cylinder_over_a_curve_has_the_integrals_of_the_curve(shape):
    points = np.array([[0, 0], [1, 2], [3, 3], [5, 2], [7, 1], [9, 2]]) @ np.eye(2, 3)
    surface = quintrig.ruled(points, points + np.array([0, 0, 2]), (*shape, *shape))
    curve = quintrig.Curve(points[:, :2], *shape)
    result = integrals(surface)
    assert result.area.value == pytest.approx(2 * curve.length(), rel=1e-9)
    # The tangent turns from one leg of the polygon to the other; with α = -4 the first leg is P0 to 2 P1 + 3 P2.
    first = points[1] - points[0] if shape[0] > -4 else 2 * points[1] + 3 * points[2] - 5 * points[0]
    last = points[5] - points[4]
    turn = np.arctan2(last[1], last[0]) - np.arctan2(first[1], first[0])
    # With n = S_u × S_v and v upwards, a curve that turns left bends towards -n.
    assert result.total_mean.value == pytest.approx(-turn * 2 / 2, rel=1e-8)
    assert result.total_gaussian.value == pytest.approx(0, abs=1e-10)


@settings(max_examples=15, deadline=None)
@given(
    seed=st.integers(0, 10**6),
    shape=st.tuples(*[st.floats(-3.5, 1)] * 4),
    scale=st.sampled_from([1e-3, 1.0, 1e3]),
    flip=st.booleans(),
)
def test_integrals_scale_and_flip_as_their_table_says(seed, shape, scale, flip):
    net = waved(seed, 0.5)
    one = integrals(quintrig.tensor(net, shape), tolerance=1e-6)
    other = integrals(quintrig.tensor(scale * net, shape, flip=flip), tolerance=1e-6)
    for row in INTEGRALS:
        sign = -1 if flip and row.parity == "odd" else 1
        size = one.area.value ** (row.power / 2) * (1 + one.bending_energy.value)
        assert other[row.key].value == pytest.approx(
            sign * scale**row.power * one[row.key].value, rel=1e-9, abs=1e-9 * size * scale**row.power
        )


def test_gauss_bonnet_on_a_patch_with_straight_sides():
    # A cap over a square with all sides straight: ∫K dA = 2π - sum of the turning angles at the corners.
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    z = np.zeros((6, 6))
    z[1:5, 1:5] = 2.0
    surface = quintrig.tensor(np.stack([x, y, z], axis=-1), (0.5, -1, -2, 1))
    result = integrals(surface)
    # The normal at the sides tips, but the sides are straight lines, which are geodesics, and the corners are flat.
    assert result.total_gaussian.value == pytest.approx(0, abs=1e-9)
    assert result.bending_energy.value > 1


def test_an_apex_has_finite_mean_and_infinite_bending():
    result = integrals(quintrig.cone(1, 2))
    assert result.area.value == pytest.approx(PI * np.sqrt(5), rel=1e-12)
    assert result.total_mean.value == pytest.approx(-2 * PI, rel=1e-12)
    assert result.bending_energy.status == "grows without bound"
    # κ = 2 / (√5 ρ) on rings dA = 2π √5 ρ dρ: halving the least ρ always adds the same.
    assert result.bending_energy.error == pytest.approx(8 * PI / np.sqrt(5) * np.log(2), rel=0.01)
    assert any("bending energy is probably infinite" in line for line in result.cautions)


def test_an_edge_with_alpha_minus_four_is_flagged():
    result = integrals(quintrig.tensor(waved(), (-4, 1, -3, -3)))
    assert result.bending_energy.status == "grows without bound"
    assert result.area.converged
    assert result.total_gaussian.converged
    assert result.total_mean.converged


def test_a_value_that_is_not_reached_says_so_and_its_error_is_honest():
    surface = quintrig.tensor(waved(3, 2.0), (1, 1, 1, 1))
    coarse, fine = integrals(surface, panels=2), integrals(surface)
    assert coarse.bending_energy.status == "not converged"
    assert any("bending energy" in line and "not resolved" in line for line in coarse.cautions)
    assert abs(coarse.bending_energy.value - fine.bending_energy.value) <= coarse.bending_energy.error


def test_a_surface_without_area_has_no_curvature():
    for net in (np.zeros((6, 6, 3)), waved() * [1, 0, 0]):
        result = integrals(quintrig.tensor(net))
        assert result.area.value == pytest.approx(0, abs=1e-12)
        assert result.bending_energy.status == "undefined"
        assert np.isnan(result.total_gaussian.value)
        assert result.undefined == 1


def test_means_are_weighted_with_the_area():
    means = area_means(quintrig.torus(3, 1), ("gaussian", "mean", "k2"))
    assert means["gaussian"].value == pytest.approx(0, abs=1e-12)
    assert means["mean"].value == pytest.approx(-0.5, rel=1e-12)
    assert means["k2"].value == pytest.approx(-1, rel=1e-12)
    slope = area_means(quintrig.sphere(), ("beta0_surface",))["beta0_surface"]
    assert slope.value == pytest.approx(2 / 3, rel=1e-12)  # of 1 - n_z²


def test_a_mean_that_is_infinite_is_none():
    # On a sphere β1 in the metric of the plane grows like 1/n_z³ on both sides of the equator, with opposite signs.
    assert area_means(quintrig.sphere(), ("beta1",))["beta1"].status == "grows without bound"


def test_the_mean_leaves_out_where_a_quantity_is_undefined():
    surface = quintrig.monkey_saddle(1)
    means = area_means(surface, ("shape_index", "curvedness"))
    assert means["shape_index"].value == pytest.approx(0, abs=1e-9)
    assert means["curvedness"].converged


def test_weights_are_shares_of_the_area():
    sample = quintrig.analyse(quintrig.torus(3, 1), *quintrig.grid(65, 65), ("E", "F", "G", "gaussian"))
    weights = area_weights(sample)
    assert weights.sum() == pytest.approx(1, rel=1e-14)
    outer = 0.5 + 1 / (3 * PI)  # the share with K > 0
    edge = weights[np.abs(sample["gaussian"]) < 1e-12].sum()
    assert weights[sample["gaussian"] >= 1e-12].sum() + edge / 2 == pytest.approx(outer, rel=1e-3)


def test_orientation_is_told():
    assert "along" in orientation(quintrig.enneper())
    assert "against" in orientation(quintrig.enneper(flip=True))
    assert any("against" in note for note in integrals(quintrig.enneper(flip=True)).notes)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"tolerance": 0.0}, "tolerance: expected a number from 1e-13 to 0.1, found 0"),
        ({"tolerance": np.nan}, "tolerance"),
        ({"panels": 1}, "panels: expected 2 or more, found 1"),
    ],
)
def test_bad_arguments_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        integrals(quintrig.sphere(), **arguments)


def test_unfit_quantities_are_refused():
    with pytest.raises(ValueError, match="normal: expected a scalar quantity"):
        area_means(quintrig.sphere(), ("normal",))
    with pytest.raises(ValueError, match="did you mean 'gaussian'"):
        area_means(quintrig.sphere(), ("gausian",))
    with pytest.raises(KeyError, match="area"):
        integrals(quintrig.sphere())["volume"]
