"""Verdicts that must not hang on the last bits, which differ between processors with and without fused multiply-add."""

import numpy as np
import pytest

import quintrig
from catalogue import CALM, CUSPED, LEVEL, TILTED
from quintrig.geometry.origin import moved_plane

COUNTS = (2, 3, 4, 5, 8, 9, 16, 17, 31, 64, 65, 99, 100, 127, 128, 129, 255, 256, 257, 511, 512, 513, 1000, 1024, 4096)
PAIRS = ((0.5, 0.5), (0.0, 0.0), (-1.0, -1.0), (1.0, 1.0), (0.3, 0.3), (-3.5, -3.5))


def turning_back(factor=1.0, planes=CALM):
    """Planes that come back the way they went, so that all of the ruling at u = 1/2 is singular."""
    there = factor * np.array(planes[:3], dtype=float)
    return [*there, *there[::-1]]


@pytest.mark.parametrize("count", COUNTS)
@pytest.mark.parametrize("pair", PAIRS)
def test_a_ruling_that_stands_still_is_found_with_any_number_of_samples(pair, count):
    for bounds in (LEVEL, TILTED):
        found = quintrig.regression(quintrig.developable(turning_back(), bounds, pair), samples=count)
        assert found.still == pytest.approx([0.5], abs=1e-8)
        assert found.intervals == ()


@pytest.mark.parametrize("count", [128, 255, 256, 512])
@pytest.mark.parametrize("factor", [1.0, 3.0, 0.7, 1e-6, -7.7e5])
def test_rounding_does_not_decide_whether_a_ruling_stands_still(factor, count):
    """Another factor, and another place, round every number otherwise."""
    for shift in ((0.0, 0.0, 0.0), (0.3, -0.1, 0.7), (1e3, -7e2, 4e2), (1e6, 1.0, -3e5)):
        planes = [moved_plane(plane, np.array(shift)) for plane in turning_back(factor)]
        bounds = [moved_plane(np.array(plane, dtype=float), np.array(shift)) for plane in LEVEL]
        found = quintrig.regression(quintrig.developable(planes, bounds, (0.5, 0.5)), samples=count)
        assert found.still == pytest.approx([0.5], abs=1e-7)
        assert found.intervals == ()


@pytest.mark.parametrize("count", [64, 65, 256, 257, 512])
def test_a_pole_of_a_boundary_is_no_ruling_that_stands_still(count):
    """Where a ruling is parallel to a bounding plane S_u x S_v turns as well, but grows."""
    strip = quintrig.developable(CALM, ((0.594, 0.891, 0.321, -0.818), (0.0, 0.0, 1.0, -5.0)), (0.5, -1.0))
    ends = strip.rows.derivatives(np.linspace(0.0, 1.0, 513), 0)[0]
    assert np.abs(ends).max() > 50.0 * np.median(np.abs(ends))
    assert quintrig.regression(strip, samples=count).still == ()


@pytest.mark.parametrize("count", [63, 64, 128, 256, 512, 513])
def test_an_edge_that_crosses_is_told_from_a_ruling_that_stands_still(count):
    """A strip so thin that its edge of regression crosses it within less than two samples."""
    whole = quintrig.regression(quintrig.developable(CUSPED, ((0, 1, 0, 0), (0, 1, 0, -10)), (0.0, 0.0)))
    k = int(np.flatnonzero(whole.inside & (whole.v > 0.3) & (whole.v < 0.7))[0])
    y = 5.0 * float(whole.v[k] + whole.v[k + 1])
    for width in (1e-2, 1e-4, 1e-6):
        thin = quintrig.developable(CUSPED, ((0, 1, 0, -y), (0, 1, 0, -y - width)), (0.0, 0.0))
        found = quintrig.regression(thin, samples=count)
        assert len(found.intervals) >= 1
        assert found.still == ()
