"""Surfaces that nearly stand still along an edge: finite integrals, met to their error, by panels of another making."""

import numpy as np
import pytest

import quintrig
from quintrig.analysis.edge_layers import layers_at_edges
from quintrig.analysis.integrate import area_means, integrals
from quintrig.analysis.quadrature import graded

SECTION = np.array([[0, 0, 0], [20, 0, 10], [40, 0, 30], [60, 0, 30], [80, 0, 10], [100, 0, 0.0]])
TRAJECTORY = np.array([[0, 0, 0], [0, 20, 11], [0, 40, 30], [0, 60, 34], [0, 80, 14], [0, 100, 3.0]])
KEYS = ("area", "total_gaussian", "total_mean", "bending_energy")


def nodes(ratio=0.4, depth=26, whole=6, count=20):
    """Gauss-Legendre nodes on panels graded to both ends far below every layer here."""
    half = np.unique(np.concatenate([[0.0], 0.5 * ratio ** np.arange(1.0, depth), np.linspace(0.2, 0.5, whole)]))
    ends = np.concatenate([half, 1.0 - half[-2::-1]])
    x, w = np.polynomial.legendre.leggauss(count)
    gaps = np.diff(ends)[:, None]
    return (ends[:-1, None] + 0.5 * gaps * (x + 1.0)).ravel(), (0.5 * gaps * w).ravel()


def reference(surface):
    """Return the four integrals at these nodes."""
    t, w = nodes()
    total = np.zeros(4)
    for some in np.array_split(np.arange(len(t)), 12):
        u, v = t[some, None], t[None, :]
        sample = quintrig.analyse(surface, u, v, ("gaussian", "mean", "curvedness"))
        p = surface.partials(u, v, 1)
        area = np.linalg.norm(np.cross(p[1, 0], p[0, 1]), axis=-1) * w[some, None] * w
        curved = sample["curvedness"]
        values = (np.ones_like(curved), sample["gaussian"], sample["mean"], 2 * curved**2)
        total += [(x * area).sum() for x in values]
    return total


SHAPES = [(0, 0, 0, -3.7), (0, 0, 0, -3.95), (0, 0, 0, -3.99), (-3.999, 1, 0.3, -2), (-3.99, -3.9, -3.999, -3.95)]


@pytest.mark.parametrize("shape", SHAPES)
def test_integrals_just_above_minus_four_are_finite_and_right(shape):
    surface = quintrig.swept(SECTION, TRAJECTORY, shape)
    found, wanted = integrals(surface), reference(surface)
    scale = wanted[3]
    for key, value in zip(KEYS, wanted, strict=True):
        assert found[key].converged, key
        assert abs(found[key].value - value) <= found[key].error + 1e-11 * max(abs(value), min(scale, 1.0)), key
    assert found.cautions == ()


def test_the_lid_that_was_called_infinite():
    found = integrals(quintrig.swept(SECTION, TRAJECTORY, (0, 0, 0, -3.99)))
    assert found.total_gaussian.value == pytest.approx(0.868899778562, abs=1e-11)
    assert found.total_mean.value == pytest.approx(-98.39537, abs=1e-5)
    assert found.bending_energy.value == pytest.approx(5585.6612, abs=1e-4)


@pytest.mark.parametrize("shape", [(-3.99, 0, 0, 0), (-3.95, 0.5, -3.95, 0), (0, 1, -3, -3.97)])
def test_a_corner_of_a_ruled_surface_that_is_nearly_singular(shape):
    surface = quintrig.ruled(SECTION, SECTION[::-1] * [-1, 1, 0.5] + [100, 80, 20], shape)
    found, wanted = integrals(surface), reference(surface)
    for key, value in zip(KEYS, wanted, strict=True):
        assert found[key].converged, key
        assert found[key].value == pytest.approx(value, rel=1e-8), key


def test_total_curvature_of_a_cylinder_is_the_turn_of_its_curve_however_near():
    curve = SECTION
    turn = 2 * np.arctan2(10, 20)  # the tangent turns from the first leg of the polygon to the last
    for alpha in (-3.9, -3.99, -3.9999):
        surface = quintrig.ruled(curve, curve + np.array([0, 50, 0]), (alpha, 0, alpha, 0))
        assert abs(integrals(surface).total_mean.value) == pytest.approx(0.5 * turn * 50, rel=1e-9)
        assert area_means(surface, ("mean",))["mean"].converged


def test_minus_four_itself_is_infinite_beside_a_layer_too():
    found = integrals(quintrig.swept(SECTION, TRAJECTORY, (-4, 0, 0, -3.99)))
    assert found.bending_energy.status == "grows without bound"
    assert found.total_gaussian.converged
    assert found.total_mean.converged


def test_nothing_is_called_infinite_on_a_regular_surface():
    rng = np.random.default_rng(7)
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    for _ in range(6):
        net = np.stack([x, y, 0 * x], axis=-1) + 0.3 * rng.normal(size=(6, 6, 3))
        shape = -4 + 10 ** rng.uniform(-3, 0, size=4)
        found = integrals(quintrig.tensor(net, tuple(shape)), 1e-6, 16)
        assert all(found[key].status in ("converged", "not converged") for key in KEYS)


def test_a_layer_is_as_wide_as_the_basis_says():
    flat = np.stack([*np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij"), np.zeros((6, 6))], axis=-1)
    for delta in (1e-1, 1e-2, 1e-4):
        # f1' = (π/2)(4 + α) at 0, and S'' = (π/2)² (12 ΔP1 - 5α ΔP0 - 3 (4 + α) ΔP0), all ΔP alike here.
        width = delta / (0.5 * np.pi * (12 + 5 * (4 - delta) - 3 * delta))
        found = layers_at_edges(quintrig.tensor(flat, (delta - 4, 0, 0, delta - 4)))
        np.testing.assert_allclose(found, (width, np.inf, np.inf, width), rtol=1e-9)
    assert layers_at_edges(quintrig.tensor(flat, (-4, -4, 0, 1))) == (np.inf,) * 4
    assert layers_at_edges(quintrig.sphere()) == (np.inf,) * 4


@pytest.mark.parametrize("panels", [1, 2, 8])
def test_panels_are_graded_to_the_layer_and_cover_the_domain(panels):
    for first, last in ((np.inf, np.inf), (1e-3, np.inf), (np.inf, 1e-5), (1e-6, 1e-2)):
        ends = graded(panels, first, last)
        assert (ends[0], ends[-1]) == (0.0, 1.0)
        gaps = np.diff(ends)
        assert (gaps > 0).all()
        assert gaps.max() <= 1 / panels + 1e-15
        assert ends[1] <= first
        assert 1 - ends[-2] <= last * (1 + 1e-9)


def test_doubling_halves_every_panel_or_moves_it():
    for layers in ((1e-3, np.inf), (np.inf, 1e-5), (1e-6, 1e-2)):
        for panels in (1, 2, 4, 8):
            coarse, fine = np.diff(graded(panels, *layers)), np.diff(graded(2 * panels, *layers))
            assert fine.min() == pytest.approx(0.5 * coarse.min(), rel=1e-9)
            assert fine.max() <= 0.75 * coarse.max()


@pytest.mark.parametrize("place", [(0.1, 0.2, 0.3), (1 / 3, 7.7, 1e12), (0, 0, 0)])
def test_a_single_point_is_told_as_such(place):
    for surface in (
        quintrig.tensor(np.tile(place, (6, 6, 1)), (0.3, -1, 0.2, -2.3)),
        quintrig.swept([place] * 6, [place] * 6),
        quintrig.ruled([place] * 6, [place] * 6, (0, -4, 0, 0)),
    ):
        found = integrals(surface)
        assert found.bending_energy.status == "undefined"
        assert len(found.cautions) == 1
        assert "single point" in found.cautions[0]


@pytest.mark.parametrize("distance", [1e6, 1e9, 1e12])
def test_integrals_far_from_the_origin_are_those_of_the_coordinates(distance):
    net = np.round(SECTION[:, None] + TRAJECTORY[None])
    here, there = integrals(quintrig.tensor(net)), integrals(quintrig.tensor(net + distance))
    assert there.cautions == ()
    for key in ("area", "total_gaussian", "total_mean", "bending_energy"):
        assert there[key].value == pytest.approx(here[key].value, rel=1e-9), key
