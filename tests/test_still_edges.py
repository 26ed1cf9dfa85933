"""Beside an edge that stands still, and beside an end of a curve that does: as many digits as anywhere else."""

import numpy as np
import pytest

import oracle
import quintrig
from catalogue import build
from quintrig.basis.trigonometric import Trigonometric
from quintrig.kernel.blocks import increment_blocks
from random_models import RANDOM

KINDS = ("tensor", "symmetric", "swept", "swung", "ruled")
DISTANCES = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7)
ROUNDING = 5e-13
"""Processors differ: the largest seen is 1.2e-13, without AVX-512; undivided, errors are 1e-16/t²."""

STILL = ((True, False), (False, True), (True, True))


def across(functions, t, still):
    """Return f (G/f)' for the functions G of the hodograph, f = sin and cos at still ends."""
    factor, slopes = functions.hodograph(t, 1, still)
    return factor[:, None] * slopes[1]


def near_edges(t):
    """Points at a distance from each edge and two corners."""
    return np.array([(t, 0.3), (0.4, t), (1.0 - t, 0.6), (0.7, 1.0 - t), (t, max(t, 1e-4)), (1.0 - max(t, 1e-4), t)]).T


def meets_exact_values(model, t, allowed):
    u, v = near_edges(t)
    sample = quintrig.analyse(build(model), u, v)
    on_grid = quintrig.analyse(build(model), u[:, None], v[None, :])
    for k in range(len(u)):
        exact = oracle.values(model, u[k], v[k])
        lean = float(exact["E"] * exact["G"]) ** 0.5 / float(exact["area"])  # of u and v lines to each other
        curved = float(exact["curvedness"]) * lean**2
        for found in (sample["gaussian"][k], on_grid["gaussian"][k, k]):
            assert abs(oracle.number(found) - exact["gaussian"]) <= allowed * curved**2
        for key in ("mean", "k1", "k2"):
            assert abs(oracle.number(sample[key][k]) - exact[key]) <= allowed * curved
        for key, speed in (("L", exact["E"]), ("N", exact["G"])):
            assert abs(oracle.number(sample[key][k]) - exact[key]) <= allowed * curved * float(speed)


@pytest.mark.parametrize("t", DISTANCES)
@pytest.mark.parametrize("kind", KINDS)
def test_curvature_beside_edges_at_exactly_minus_four(kind, t):
    rng = np.random.default_rng([1, *kind.encode()])
    mixed = [-4.0, 1.0, -4.0, 1.0] if kind == "ruled" else [-4.0, 0.5, 1.0, -4.0]
    for shape in ([-4.0] * 4, mixed):
        meets_exact_values({"kind": kind, **RANDOM[kind](rng, 1.0), "shape": shape}, t, ROUNDING)


@pytest.mark.parametrize("t", DISTANCES)
@pytest.mark.parametrize("shape", [(0.5, -2.0, 1.0, 0.0), (-4.0, 0.0, -1.0, -4.0)])
def test_curvature_beside_edges_where_two_rows_of_points_coincide(shape, t):
    """There curvature is bounded, a quotient of u² by u²: of its digits some are lost, like 1/u."""
    net = RANDOM["tensor"](np.random.default_rng(8), 1.0)["points"].copy()
    net[1] = net[0]
    net[:, 4] = net[:, 5]
    meets_exact_values({"kind": "tensor", "points": net, "shape": shape}, t, ROUNDING + 1e-15 / t)


def test_what_stands_still_on_one_boundary_only_is_left_alone():
    """At v = 0 the boundary stands still, at v = 1 it does not: u = 0 is no singular edge, but for its corner."""
    model = {"kind": "ruled", **RANDOM["ruled"](np.random.default_rng(4), 1.0), "shape": [-4.0, 0.0, 0.5, 0.0]}
    sample = quintrig.analyse(build(model), [0.0, 0.0, 1e-7], [0.5, 1.0, 0.5])
    for k, (u, v) in enumerate([(0.0, 0.5), (0.0, 1.0), (1e-7, 0.5)]):
        exact = oracle.values(model, u, v)
        assert sample["gaussian"][k] == pytest.approx(float(exact["gaussian"]), rel=1e-12)


@pytest.mark.parametrize("still", STILL)
@pytest.mark.parametrize("pair", [(-4.0, -4.0), (0.5, -4.0), (-4.0, 1.0), (0.3, -2.0)])
def test_the_compiled_second_derivatives_across_the_first_are_the_definition(pair, still):
    functions = Trigonometric(*pair)
    t = np.concatenate([np.array(DISTANCES), np.linspace(0.15, 0.85, 60), 1.0 - np.array(DISTANCES)])
    blocks = increment_blocks(functions, t, still=still).transpose(1, 0, 3, 2).reshape(3, -1, 5)[:, : len(t)]
    np.testing.assert_allclose(blocks[2], across(functions, t, still), rtol=1e-12, atol=1e-13)
    np.testing.assert_allclose(blocks[:2], functions.increments(t, 2)[:2], rtol=1e-12, atol=1e-16)


@pytest.mark.parametrize("pair", [(-4.0, -4.0), (-4.0, 1.0), (0.5, -4.0)])
def test_second_derivatives_across_the_first_differ_from_plain_ones_by_a_share_of_the_first(pair):
    functions, t = Trigonometric(*pair), np.linspace(0.1, 0.9, 9)
    still = (pair[0] == -4.0, pair[1] == -4.0)
    _, first, second = functions.increments(t, 2)
    rate = 0.5 * np.pi * (still[0] / np.tan(0.5 * np.pi * t) - still[1] * np.tan(0.5 * np.pi * t))
    np.testing.assert_allclose(across(functions, t, still), second - rate[:, None] * first, rtol=0, atol=1e-12)


SPACE = np.array([[0, 0, 0], [1, 2, 0.5], [2.5, 2, 2], [4, -1, 1], [5, 0.5, -1], [6, 2, 1.0]])


@pytest.mark.parametrize("t", DISTANCES)
@pytest.mark.parametrize("distance", [0.0, 1e6])
def test_curvature_and_torsion_beside_an_end_that_stands_still(distance, t):
    for alpha, zeta in ((-4.0, -4.0), (-4.0, 0.5), (0.3, -4.0)):
        there = SPACE + distance
        curve = quintrig.Curve(there, alpha, zeta)
        for place in (t, 1.0 - t):
            wanted = oracle.curvature(there, alpha, zeta, place)
            assert abs(oracle.number(curve.curvature(place)) - wanted) <= 1e-13 * abs(wanted)
            wanted = oracle.torsion(there, alpha, zeta, place)
            assert abs(oracle.number(curve.torsion(place)) - wanted) <= 1e-12 * max(abs(wanted), 1e-2)


def test_a_curve_that_stands_still_has_no_curvature_at_that_end():
    curve = quintrig.Curve(SPACE, -4.0, -4.0)
    assert np.isnan(curve.curvature([0.0, 1.0])).all()
    assert np.isnan(curve.torsion([0.0, 1.0])).all()
    assert np.isnan(curve.comb([0.0, 1.0], 1.0)).all()
    plane = quintrig.Curve(SPACE[:, :2], -4.0, 0.0)
    t = np.array([1e-7, 1e-4, 0.3])
    np.testing.assert_allclose(np.abs(plane.signed_curvature(t)), plane.curvature(t), rtol=1e-12)
    teeth = np.linalg.norm(plane.comb(t, 1.0) - plane(t), axis=-1)
    np.testing.assert_allclose(teeth, plane.curvature(t), rtol=1e-9)
