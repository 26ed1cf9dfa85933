"""The summary of a surface: its numbers hang together, and all that is wrong with it is said, and nothing else."""

import numpy as np
import pytest

import quintrig
from quintrig.analysis.cautions import find_singular, shape_parameters
from quintrig.analysis.summary import CLASSIFIED, EXTREMES, summarise
from quintrig.quantities.classify import Thresholds

X, Y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
NET = np.stack([X, Y, 2 + 0.1 * np.random.default_rng(0).normal(size=(6, 6))], axis=-1)


def warnings(surface, **options):
    return summarise(surface, samples=33, tolerance=1e-6, **options).warnings


def only(lines, *words):
    """Return the one warning that has all these words."""
    found = [line for line in lines if all(word in line for word in words)]
    assert len(found) == 1, lines
    return found[0]


def test_a_regular_surface_has_no_warnings_and_consistent_numbers():
    result = summarise(quintrig.tensor(NET, (1, 1, -3, -3)), "mm", samples=33)
    assert result.warnings == ()
    assert result.unit == "mm"
    assert set(result.extremes) == set(EXTREMES)
    assert set(result.shares) == set(CLASSIFIED)
    for shares in result.shares.values():
        assert sum(part.share for part in shares) == pytest.approx(1, rel=1e-12)
        assert sum(part.count for part in shares) == 33 * 33
        assert [part.share for part in shares] == sorted((part.share for part in shares), reverse=True)
    assert result.singular.count == 0
    assert result.singular.describe() == ""
    assert "1/mm" in result.thresholds
    assert "along" in result.orientation
    np.testing.assert_allclose(result.box[:, :2], [[0, 0], [5, 5]], atol=1e-12)
    # The mean of H over the area is the integral over the area.
    mean = result.integrals.total_mean.value / result.integrals.area.value
    assert result.extremes["mean"].mean.value == pytest.approx(mean, rel=1e-6)


def test_shares_are_those_of_the_area():
    shares = summarise(quintrig.torus(3, 1)).shares["point_type"]
    by_name = {part.name: part.share for part in shares}
    assert by_name["elliptic"] + by_name["parabolic"] / 2 == pytest.approx(0.5 + 1 / (3 * np.pi), rel=1e-3)


def test_thresholds_are_used_and_told():
    coarse = summarise(quintrig.torus(3, 1), thresholds=Thresholds(relative=0.1))
    fine = summarise(quintrig.torus(3, 1))
    assert "0.1 C²" in coarse.thresholds

    def parabolic(result):
        return next(part.share for part in result.shares["point_type"] if part.name == "parabolic")

    assert parabolic(coarse) > parabolic(fine)


def test_the_poles_of_a_sphere_are_told():
    result = summarise(quintrig.sphere(), samples=33)
    assert result.singular.edges == ("u = 0", "u = 1")
    assert result.singular.count == 66
    only(result.warnings, "66 of 1089", "The edges u = 0 and u = 1 are single points")
    assert len(result.warnings) == 1
    only(result.notes, "33 of 1089", "vertical")
    assert not any("vertical" in line for line in result.warnings)
    assert result.integrals.bending_energy.converged


def test_an_apex_is_told_with_what_is_infinite_there():
    lines = warnings(quintrig.cone())
    only(lines, "The edge u = 1 is a single point")
    only(lines, "H, κ2, C grow without bound")
    only(lines, "bending energy", "infinite")


@pytest.mark.parametrize(
    ("shape", "words"),
    [
        ((-4, 0, 0, 0), ("S_u vanishes", "u = 0", "α1 = -4")),
        ((0, -4, 0, 0), ("S_u vanishes", "u = 1", "ζ1 = -4")),
        ((0, 0, -4, 0), ("S_v vanishes", "v = 0", "α2 = -4")),
        ((0, 0, 0, -4), ("S_v vanishes", "v = 1", "ζ2 = -4")),
    ],
)
def test_shape_parameters_at_minus_four_are_told_with_their_edge(shape, words):
    only(warnings(quintrig.tensor(NET, shape)), *words)


def test_a_ruled_surface_with_minus_four_has_a_singular_corner():
    surface = quintrig.ruled(NET[0], NET[5] + [0, 0, 1], (0, -4, 0, 0))
    lines = warnings(surface)
    only(lines, "ζ1 = -4", "corner u = 1, v = 0")
    only(lines, "1 of 1089 sample points is singular", "corner (u, v) = (1, 0)")
    assert find_singular(quintrig.analyse(surface, *quintrig.grid(9, 9), ("mean",))).corners == ("(1, 0)",)


def test_unchecked_shape_parameters_lose_the_hull_and_it_says_by_how_much():
    rising = np.stack([X, Y, 5.0 * (X > 0)], axis=-1)
    line = only(
        warnings(quintrig.tensor(rising, (3, 0, 0, -5), unchecked_shape=True), unit="cm"),
        "convex-hull property is lost",
    )
    assert "α1 = 3" in line
    assert "ζ2 = -5" in line
    assert "cm" in line
    assert warnings(quintrig.tensor(NET, (1, -3, 1, 0), unchecked_shape=True)) == ()


def test_the_edge_of_regression_is_told_with_its_interval():
    turn = np.radians(12 * X[:, 0])
    planes = np.stack([np.cos(turn), np.sin(turn), 0.3 + 0.025 * np.sin(X[:, 0]), -10 - 0.2 * X[:, 0]], axis=-1)
    assert not any(
        "regression" in line for line in warnings(quintrig.developable(planes, [[0, 0, 1, 0], [0, 0, 1, -5]]))
    )
    surface = quintrig.developable(planes, [[0, 0, 1, 0], [0, 0, 1, -40]])  # high enough to reach it
    intervals = quintrig.regression(surface).intervals
    assert len(intervals) == 1
    line = only(warnings(surface), "edge of regression")
    assert f"[{intervals[0][0]:.6g}, {intervals[0][1]:.6g}]" in line
    assert any("bending energy" in line for line in warnings(surface))  # infinite there


def test_a_fold_is_told():
    folded = NET.copy()
    folded[3:, :, 0] = 6 - folded[3:, :, 0]  # turns back on itself
    folded[3:, :, 2] -= 1e-3
    only(warnings(quintrig.tensor(folded)), "turns by more than 90°")


def test_coincident_points_are_told():
    net = NET.copy()
    net[2, 3] = net[2, 4]
    only(warnings(quintrig.tensor(net)), "1 pair of neighbouring", "points[2][3]", "points[2][4]")
    net[4] = net[3]
    only(warnings(quintrig.tensor(net)), "7 pairs")
    net[0] = net[0, 0]
    only(warnings(quintrig.tensor(net)), "The edge u = 0 is a single point")


@pytest.mark.parametrize("place", [0.0, 0.1, 7.7])
def test_a_surface_that_is_a_point_or_a_line_is_told_once(place):
    lines = warnings(quintrig.tensor(np.full((6, 6, 3), place)))
    only(lines, "single point")
    assert len(lines) == 1
    lines = warnings(quintrig.tensor(NET * [1, 0, 0]))
    only(lines, "All 1089 sample points are singular")
    assert not [line for line in lines if "undefined" in line or "tolerance" in line]


def test_shape_parameters_are_found_where_they_act():
    found = shape_parameters(quintrig.tensor(NET, (1, 0, -1, -2)))
    assert [(place, basis.alpha, basis.zeta) for place, basis in found.items()] == [("u", 1, 0), ("v", -1, -2)]
    found = shape_parameters(quintrig.ruled(NET[0], NET[5], (1, 0, -1, -2)))
    assert [(place, basis.alpha, basis.zeta) for place, basis in found.items()] == [("v = 0", 1, 0), ("v = 1", -1, -2)]
    assert shape_parameters(quintrig.torus()) == {}
    assert shape_parameters(quintrig.tensor(NET, basis="bernstein")) == {}


def test_bad_arguments_are_refused():
    with pytest.raises(ValueError, match="nu: expected"):
        summarise(quintrig.sphere(), samples=1)
    with pytest.raises(ValueError, match="tolerance"):
        summarise(quintrig.sphere(), tolerance=1)
