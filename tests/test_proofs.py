"""Proofs against exact rational arithmetic, known surfaces and near misses, never contradicted."""

import math
from fractions import Fraction

import numpy as np
import pytest

import exact_curvature
import quintrig
import quintrig.geometry.nurbs
from quintrig.enclosures import ball
from quintrig.enclosures.ball import Ball
from quintrig.enclosures.charts import charts
from quintrig.enclosures.prove import NoProofError
from quintrig.enclosures.shape import Shape
from quintrig.enclosures.whole import Whole

PLACES = [Fraction(k, 8) for k in range(1, 8, 3)]
CLAIMS = ("regular", "gaussian > 0", "gaussian <= 0", "mean < 0", "mean > 0")


def dome(rng, bend):
    """Return a net of 6 x 6 points near a dome, the farther from it the larger ``bend``."""
    x, y = np.meshgrid(np.linspace(0.0, 3.0, 6), np.linspace(0.0, 2.0, 6), indexing="ij")
    smooth = np.stack([x, y, -0.2 * (x - 1.5) ** 2 - 0.3 * (y - 1.0) ** 2], axis=-1)
    return smooth + bend * rng.uniform(-1.0, 1.0, smooth.shape)


def never_contradicted(count, seed):
    """Prove claims on random nets; return how often each verdict was given, exact values having agreed with all."""
    rng = np.random.default_rng(seed)
    told = dict.fromkeys(("proved", "refuted", "undecided"), 0)
    for k in range(count):
        points = dome(rng, (0.02, 0.1, 0.4)[k % 3])
        shape = tuple(rng.choice([-4.0, -3.9, -1.0, 0.0, 0.3, 1.0], 4).tolist())
        surface = quintrig.tensor(points, shape)
        exact = [exact_curvature.curvature(points, shape, x, y) for x in PLACES for y in PLACES]
        values = {
            "regular": [area > 0 for area, _, _ in exact],
            "gaussian > 0": [k > 0 for _, k, _ in exact],
            "gaussian <= 0": [k <= 0 for _, k, _ in exact],
            "mean < 0": [h < 0 for _, _, h in exact],
            "mean > 0": [h > 0 for _, _, h in exact],
        }
        for claim in CLAIMS:
            verdict = quintrig.prove(surface, claim)
            told[verdict.verdict] += 1
            if verdict.proved:
                assert all(values[claim]), (claim, k)
            if verdict.verdict == "refuted" and claim != "regular":
                # At the fraction nearest to the witness, the exact value fails the claim too.
                x, y = (Fraction(math.tan(0.25 * math.pi * t)) for t in (verdict.witness.u, verdict.witness.v))
                _, gauss, mean = exact_curvature.curvature(points, shape, x, y)
                found = gauss if "gaussian" in claim else mean
                assert {">": found > 0, "<": found < 0, "<=": found <= 0}[claim.split()[1]] is False, (claim, k)
        if k % 10 == 0:
            bounds = quintrig.bounds(surface, "gaussian", 1e-2, boxes=64)
            assert all(bounds.minimum[0] <= gauss <= bounds.maximum[1] for _, gauss, _ in exact)
    return told


def test_random_nets_are_never_contradicted_by_exact_arithmetic():
    told = never_contradicted(9, 20261128)
    assert told["proved"] > 5
    assert told["refuted"] > 5


def contained(points, shape):
    """Return whether every exact coefficient lies within its rounded one's bound."""
    (chart,) = charts(quintrig.tensor(points, shape))
    rounded, exact = Shape(chart, Ball), Shape(chart, Whole)
    for name in ("area", "gauss", "mean"):
        near, true = getattr(rounded, name), getattr(exact, name)
        for (i, j), over in np.ndenumerate(true.over):
            off = abs(Fraction(float(near.middle[i, j])) - Fraction(over, true.under))
            if off > Fraction(float(near.radius[i, j])):
                return False
    return True


@pytest.mark.parametrize("shape", [(0.0, 0.0, 0.0, 0.0), (-3.9, 0.7, 1.0, -4.0)])
def test_every_rounding_is_within_its_bound(shape):
    assert contained(dome(np.random.default_rng(5), 0.1), shape)


def test_a_broken_bound_of_the_rounding_is_caught(monkeypatch):
    monkeypatch.setattr(ball, "bound", lambda terms: 0.0)
    assert not contained(dome(np.random.default_rng(5), 0.1), (0.0, 0.3, 0.2, 0.1))


def graph(beyond):
    """Return z = g(x) - y²/2 over the unit square, g'' = -c (1 + beyond - x): K changes its sign beside x = 1."""
    c, x0 = 1.75e-3, 1.0 + beyond
    # Bernstein coefficients of g = -c (x0 x²/2 - x³/6) and of -y²/2.
    powers = [0.0, 0.0, -c * x0 / 2.0, c / 6.0]
    g = [sum(math.comb(k, i) / math.comb(3, i) * powers[i] for i in range(k + 1)) for k in range(4)]
    points = [[(k / 3.0, j / 2.0, g[k] - (0.5 if j == 2 else 0.0)) for j in range(3)] for k in range(4)]
    return quintrig.tensor(points, basis="bernstein")


def test_a_dip_beside_an_edge_is_found_and_a_near_miss_is_proved():
    verdict = quintrig.prove(graph(-4e-4), "gaussian > 0")
    assert verdict.verdict == "refuted"
    assert verdict.witness.u > 1.0 - 4e-4
    assert -7.1e-7 < verdict.witness.value < 0.0
    assert quintrig.prove(graph(4e-4), "gaussian > 0").proved
    least = quintrig.bounds(graph(-4e-4), "gaussian", 1e-4).minimum
    assert least[0] <= -6.9e-7
    assert least[0] > -1e-6


def test_a_bound_met_exactly_is_told_from_one_that_is_missed():
    surface = graph(0.0)  # K = 0 on the edge x = 1, above 0 elsewhere
    assert quintrig.prove(surface, "gaussian > 0").verdict != "proved"
    # Whether the rounded points lie on one side of 0 or on the other is decided, not guessed.
    assert quintrig.prove(surface, "gaussian >= -1e-15").proved


@pytest.mark.parametrize(
    ("surface", "claim", "verdict"),
    [
        (quintrig.sphere(2.0), "gaussian > 0", "proved"),
        (quintrig.sphere(2.0), "0.2499 <= gaussian <= 0.2501", "proved"),
        (quintrig.sphere(2.0), "curvature_radius >= 1.99", "proved"),
        (quintrig.sphere(2.0), "curvature_radius >= 2.01", "refuted"),
        (quintrig.sphere(2.0), "regular", "proved"),
        (quintrig.sphere(2.0), "mean < 0", "proved"),
        (quintrig.sphere(2.0), "convex", "proved"),
        (quintrig.ellipsoid(3.0, 2.0, 1.0), "gaussian > 0", "proved"),
        (quintrig.cone(1.0, 2.0), "regular", "refuted"),
        (quintrig.cone(1.0, 2.0), "no fold", "proved"),
        (quintrig.cone(1.0, 2.0), "developable", "proved"),
        (quintrig.cylinder(1.0, 2.0), "developable", "proved"),
        (quintrig.cylinder(1.0, 2.0), "gaussian > 0", "refuted"),
        (quintrig.cylinder(1.0, 2.0), "-1 deg <= draft <= 1 deg", "proved"),
        (quintrig.torus(3.0, 1.0), "gaussian >= 0", "refuted"),
        (quintrig.torus(3.0, 1.0), "curvature_radius >= 0.99", "proved"),
        (quintrig.hyperbolic_paraboloid(1.0), "gaussian < 0", "proved"),
        (quintrig.hyperbolic_paraboloid(1.0), "gaussian < -0.2", "refuted"),
        (quintrig.hyperbolic_paraboloid(1.0), "slope <= 54.8 deg", "proved"),
        (quintrig.hyperbolic_paraboloid(1.0), "slope <= 0.9 rad", "refuted"),
        (quintrig.enneper(1.0), "gaussian < 0", "proved"),
        (quintrig.enneper(1.0), "-1e-9 <= mean <= 1e-9", "proved"),
        (quintrig.monkey_saddle(1.0), "gaussian <= 0", "proved"),
        (quintrig.monkey_saddle(1.0), "gaussian < 0", "refuted"),
    ],
)
def test_surfaces_with_known_curvature(surface, claim, verdict):
    assert quintrig.prove(surface, claim).verdict == verdict


def test_bounds_enclose_known_extremes():
    torus = quintrig.torus(3.0, 1.0)
    found = quintrig.bounds(torus, "gaussian", 1e-3)
    assert quintrig.bounds(torus, "K", 1e-3).to_dict() == found.to_dict()
    assert found.complete
    assert found.minimum[0] <= -0.5 <= found.minimum[1]
    assert found.maximum[0] <= 0.25 <= found.maximum[1]
    assert found.minimum[1] - found.minimum[0] < 1e-3
    radius = quintrig.bounds(torus, "curvature_radius").minimum
    assert radius[0] <= 1.0 + 1e-12
    assert radius[0] > 0.999


@pytest.mark.parametrize(("key", "least", "most"), [("k1", -0.25, 0.5), ("k2", -1.0, -1.0)])
def test_principal_curvatures_of_a_torus_are_enclosed(key, least, most):
    found = quintrig.bounds(quintrig.torus(3.0, 1.0), key)
    assert found.complete
    assert found.minimum[0] <= least <= found.minimum[1]
    assert found.maximum[0] <= most <= found.maximum[1]


@pytest.mark.parametrize("key", ["k1", "k2", "curvedness", "curvature_radius"])
def test_what_hangs_on_both_curvatures_is_enclosed_to_second_order(key):
    # Bounds from those of H and K apart are of first order: a thousand boxes do not bring them near.
    surface = quintrig.tensor(dome(np.random.default_rng(14), 0.02))
    found = quintrig.bounds(surface, key, 1e-3, boxes=256)
    assert found.complete
    sample = quintrig.analyse(surface, *quintrig.grid(65, 65), ("k1", "k2", "curvedness"))
    largest = np.maximum(np.abs(sample["k1"]), np.abs(sample["k2"]))
    values = 1.0 / largest if key == "curvature_radius" else sample[key]
    assert found.minimum[0] <= values.min() * (1.0 - 1e-12 * np.sign(values.min()))
    if key != "curvature_radius":
        assert found.maximum[1] >= values.max() * (1.0 - 1e-12 * np.sign(values.max()))


def test_ruled_surfaces_never_bulge():
    rng = np.random.default_rng(3)
    first, second = (rng.normal(size=(6, 3)) + np.linspace(0.0, 9.0, 6)[:, None] * [1, 0, 0] for _ in range(2))
    surface = quintrig.ruled(first, np.add(second, (0.0, 9.0, 0.0)))
    assert quintrig.prove(surface, "gaussian <= 0").proved
    assert quintrig.prove(surface, "developable").verdict == "refuted"


def test_a_strip_of_planes_is_developable_by_construction_and_curves_as_sampled():
    surface = quintrig.load("examples/developable.toml").surface
    assert quintrig.prove(surface, "developable").proved
    assert quintrig.prove(surface, "regular").proved
    assert quintrig.prove(surface, "gaussian > 0").verdict == "refuted"
    sample = quintrig.analyse(surface, *quintrig.grid(33, 9))
    for key in ("mean", "k1", "k2", "curvedness"):
        found = quintrig.bounds(surface, key)
        assert found.complete
        assert found.minimum[0] <= sample[key].min() + 1e-12
        assert found.maximum[1] >= sample[key].max() - 1e-12
        assert found.maximum[1] - sample[key].max() < 2e-3 * np.abs(sample[key]).max()


@pytest.mark.parametrize("lift", [0.0, 0.1])
def test_folds_are_refuted_where_the_normal_turns_over(lift):
    x, y = np.meshgrid(np.linspace(0, 3, 6), np.linspace(0, 3, 6), indexing="ij")
    net = np.stack([x, y, lift * y * y], axis=-1)
    net[2:4, :, 0] = net[3:1:-1, :, 0] + [[0.7], [-0.7]]
    verdict = quintrig.prove(quintrig.tensor(net), "no fold")
    assert verdict.verdict == "refuted"
    su, sv = (quintrig.tensor(net).partials(verdict.witness.u, verdict.witness.v, 1)[k] for k in ((1, 0), (0, 1)))
    assert np.linalg.norm(np.cross(su, sv)) < 1e-2
    assert quintrig.prove(quintrig.tensor(np.stack([x, y, 0.1 * x * y], axis=-1)), "no fold").proved


def test_of_what_has_no_normal_anywhere_nothing_is_proved_of_curvature():
    net = np.linspace(0, 1, 36).reshape(6, 6, 1) * np.array([1.0, 0.0, 0.0])
    assert quintrig.prove(quintrig.tensor(net), "regular").verdict == "refuted"
    assert quintrig.prove(quintrig.tensor(net), "gaussian >= 0").verdict == "undecided"


def strip(bounds, cone=0.3):
    """Return a strip of planes that touch a cone-like surface, cut by two bounding planes."""
    angle = np.radians(np.linspace(0, 60, 6))
    planes = np.stack([np.cos(angle), np.sin(angle), cone + 0 * angle, -10 - 0.2 * np.arange(6.0)], axis=-1)
    return quintrig.developable(planes, bounds)


def test_a_strip_with_its_edge_of_regression_inside_is_judged_by_its_curvature():
    surface = strip([[0, 0, 1, 0], [0, 0, 1, -60.0]])
    verdict = quintrig.prove(surface, "regular")
    assert verdict.verdict == "refuted"
    assert 0.0 < verdict.witness.v < 1.0
    assert verdict.witness.value == 0.0
    assert "edge of regression" in verdict.why
    least = np.abs(quintrig.analyse(surface, *quintrig.grid(33, 65), ("mean",))["mean"]).min()
    for claim, word in (("mean <= 0", "proved"), ("mean >= -9", "refuted"), ("curvature_radius >= 1e-3", "refuted")):
        verdict = quintrig.prove(surface, claim)
        assert verdict.verdict == word, claim
        if verdict.witness:
            sample = quintrig.analyse(surface, verdict.witness.u, verdict.witness.v, ("mean",))["mean"]
            value = 2.0 * abs(verdict.witness.value) if "mean" in claim else 1.0 / verdict.witness.value
            assert 2.0 * abs(float(sample)) == pytest.approx(value, rel=1e-3)
    assert quintrig.prove(surface, f"curvedness >= {1.4 * least}").proved
    found = quintrig.bounds(surface, "mean")
    assert found.minimum[0] == -np.inf
    assert found.maximum[0] <= -least * (1 - 1e-9) or found.maximum[1] >= -least
    assert quintrig.prove(surface, "mean", bounds=True).bounds[0] == -np.inf


def test_a_strip_whose_boundaries_cross_is_not_regular_and_its_normal_turns_over():
    surface = strip([[0, 0, 1, 0], [1, -0.5, 1, -4.0]])
    verdict = quintrig.prove(surface, "regular")
    assert verdict.verdict == "refuted"
    assert np.linalg.norm(surface(verdict.witness.u, 0.0) - surface(verdict.witness.u, 1.0)) < 1e-9
    assert not any(quintrig.prove(surface, claim).proved for claim in ("mean <= 0", "mean >= 0", "convex", "no fold"))
    assert quintrig.prove(surface, "curvature_radius >= 1").proved


def test_edges_that_stand_still_are_divided_out():
    surface = quintrig.tensor(dome(np.random.default_rng(8), 0.02), (-4.0, 0.0, 0.0, -4.0))
    verdict = quintrig.prove(surface, "regular")
    assert verdict.proved
    assert any("u = 0" in note for note in verdict.notes)
    assert any("v = 1" in note for note in verdict.notes)


@pytest.mark.parametrize(
    ("basis", "points"),
    [
        *(("cubic", 4), ("quadratic", 3), ("quartic", 5), ("lambda_bezier", 4), ("ali_cubic", 4), ("sg_bezier", 4)),
        *(("normalised_trigonometric", 5), ("generalised_trigonometric_squares", 4), ("bernstein", 5)),
    ],
)
def test_every_basis_with_a_form_has_proofs(basis, points):
    x = np.linspace(-1.0, 1.0, points)
    net = np.stack([*np.meshgrid(x, x, indexing="ij"), -(x[:, None] ** 2) - x[None] ** 2], axis=-1)
    surface = quintrig.tensor(net, basis=basis)
    assert quintrig.prove(surface, "regular").proved
    found = quintrig.bounds(surface, "gaussian", 1e-2)
    values = quintrig.analyse(surface, *quintrig.grid(17, 17), ("gaussian",))["gaussian"]
    assert found.complete
    assert found.minimum[0] <= values.min() + 1e-12
    assert found.maximum[1] >= values.max() - 1e-12


def test_a_basis_without_a_form_says_so():
    x = np.linspace(-1.0, 1.0, 4)
    net = np.stack([*np.meshgrid(x, x, indexing="ij"), x[:, None] * x[None]], axis=-1)
    with pytest.raises(NoProofError, match="can only be sampled"):
        quintrig.prove(quintrig.tensor(net, basis="c_bezier"), "regular")


def test_rational_faces_are_proved_span_by_span():
    half = math.sqrt(0.5)
    arc = np.array([[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0]])
    profile = np.array([[1, 0], [1, 1], [0, 1]])  # radius and height of a quarter: a pole at its end
    points = [[(r * x, r * y, z) for x, y in arc] for r, z in profile]
    weights = np.outer([1, half, 1], [1, half, 1, half, 1])
    knots = ([0, 0, 0, 1, 1, 1], [0, 0, 0, 0.5, 0.5, 1, 1, 1])
    surface = quintrig.geometry.nurbs.nurbs(points, weights, (2, 2), knots)
    assert quintrig.prove(surface, "regular").proved
    # √½ is rounded, so the surface is a sphere to its last digits only.
    assert quintrig.prove(surface, "0.99 < gaussian < 1.01").proved


def test_a_trimmed_face_is_judged_by_what_is_left_of_it():
    x = np.linspace(-1.0, 1.0, 4)
    powers = [-1.0, 1.0, -1.0, 1.0]  # Bernstein coefficients of x³
    net = [[(x[i], x[j], powers[i] + 0.5 * x[j] ** 2 * 1.5) for j in range(4)] for i in range(4)]
    corner = [(0.6, 0.1), (0.9, 0.1), (0.9, 0.9), (0.6, 0.9)]
    whole = quintrig.geometry.nurbs.nurbs(net)
    face = quintrig.geometry.nurbs.nurbs(net, trim=[corner])
    assert quintrig.prove(whole, "gaussian > 0").verdict == "refuted"
    assert quintrig.prove(face, "gaussian > 0").proved


def test_hulls_hold_in_the_range_and_are_lost_outside():
    points = dome(np.random.default_rng(2), 0.1)
    assert quintrig.prove(quintrig.tensor(points, (-4.0, 1.0, 0.3, -1.0)), "inside hull").proved
    outside = quintrig.tensor(points, (9.0, 9.0, 9.0, 9.0), unchecked_shape=True)
    assert quintrig.prove(outside, "inside hull").verdict == "refuted"


def test_turning_the_normal_turns_what_hangs_on_it():
    kept, turned = quintrig.sphere(2.0), quintrig.sphere(2.0, flip=True)
    assert quintrig.prove(kept, "k2 < 0").proved
    assert quintrig.prove(turned, "k1 > 0").proved
    assert quintrig.prove(turned, "mean > 0").proved
    assert quintrig.prove(turned, "gaussian > 0").proved


def test_size_and_place_do_not_matter():
    points = dome(np.random.default_rng(4), 0.02)
    for factor, shift in ((1e-25, 0.0), (1e25, 0.0), (1.0, 1e6)):
        surface = quintrig.tensor(factor * points + shift)
        assert quintrig.prove(surface, "gaussian > 0").proved


def test_a_verdict_is_no_truth_value():
    with pytest.raises(TypeError, match="undecided"):
        bool(quintrig.prove(quintrig.sphere(), "regular"))
