"""Integrals over surfaces with inner knots: panels end at the knots, where derivatives jump."""

import numpy as np
import pytest

import quintrig
from quintrig.analysis.integrate import area_means
from quintrig.analysis.quadrature import graded, nodes_for
from quintrig.geometry.nurbs import nurbs


def cylinder(radius=10.0, height=20.0):
    """A full turn in three arcs, as OpenCASCADE writes it: knots of multiplicity 2 at each third."""
    angles = np.arange(7) * np.pi / 3
    reach = radius * np.where(np.arange(7) % 2, 2.0, 1.0)
    ring = np.stack([reach * np.cos(angles), reach * np.sin(angles), np.zeros(7)], axis=-1)
    weights = np.where(np.arange(7) % 2, 0.5, 1.0)
    points = np.stack([ring, ring + np.array([0, 0, height])], axis=1)
    knots = ([0, 0, 0, 1, 1, 2, 2, 3, 3, 3], [0, 0, 1, 1])
    return nurbs(points, np.stack([weights, weights], axis=1), (2, 1), knots)


def test_a_cylinder_of_three_arcs_is_exact_with_few_points():
    found = quintrig.integrals(cylinder())
    assert found.cautions == ()
    assert found.points <= 4096
    assert found.area.value == pytest.approx(400 * np.pi, rel=1e-12)
    assert abs(found.total_mean.value) == pytest.approx(20 * np.pi, rel=1e-12)  # A / 2r
    assert found.bending_energy.value == pytest.approx(4 * np.pi, rel=1e-12)  # A / r²
    assert abs(found.total_gaussian.value) <= 1e-12
    assert abs(area_means(cylinder(), ["mean"])["mean"].value) == pytest.approx(0.05, rel=1e-12)


@pytest.mark.parametrize("spans", [1, 3, 10])
def test_a_graph_of_piecewise_quadratics_has_the_plate_energy_of_its_pieces(spans):
    # z = f(x) with a second derivative that is constant between knots: ∬ |S_uu|² is a sum over spans.
    rng = np.random.default_rng(spans)
    heights = rng.normal(size=spans + 2)
    inner = np.arange(1, spans)
    knots = np.concatenate([[0, 0, 0], inner, [spans] * 3]).astype(float)
    places = np.array([knots[i + 1 : i + 3].mean() for i in range(spans + 2)]) / spans  # linear precision
    ends = np.array([0.0, 1.0])
    points = np.stack(
        [np.repeat(places[:, None], 2, 1), np.tile(ends, (spans + 2, 1)), np.repeat(heights[:, None], 2, 1)], -1
    )
    surface = nurbs(points, None, (2, 1), (knots, [0, 0, 1, 1]))
    middles = (np.arange(spans) + 0.5) / spans
    second = surface.partials(middles, 0.5, 2)[2, 0, :, 2]
    found = quintrig.integrals(surface)
    assert found.thin_plate_energy.value == pytest.approx((second**2).mean(), rel=1e-12)
    assert found.thin_plate_energy.converged


def test_panels_end_at_breaks_and_are_graded_at_the_ends_only():
    breaks = np.array([0.0, 0.1, 0.75, 1.0])
    ends = graded(2, np.inf, np.inf, breaks)
    np.testing.assert_allclose(ends, [0, 0.05, 0.1, 0.425, 0.75, 0.875, 1], atol=1e-15)
    fine = graded(2, 1e-3, np.inf, breaks)
    assert set(np.round(ends, 12)) <= set(np.round(fine, 12))
    assert 0 < fine[1] <= 1e-3
    assert (np.diff(fine) > 0).all()
    assert nodes_for(1) > nodes_for(20) > nodes_for(200) >= 2


def test_many_knots_take_bounded_time_and_points():
    n = 100
    x, y = np.meshgrid(np.linspace(0, 10, n + 2), np.linspace(0, 10, n + 2), indexing="ij")
    knots = [0, 0, *range(n + 1), n, n]
    surface = nurbs(np.stack([x, y, np.sin(x) * np.cos(y)], -1), None, (2, 2), (knots, knots))
    found = quintrig.integrals(surface)
    assert found.points <= 2**20
    assert found.area.converged
