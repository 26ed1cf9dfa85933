"""Bounds of what hangs on H and K together, from their coefficients pair by pair: to second order in a box's size.

With one denominator S = Σ s_j B_j, s_j > 0, the pair (H, K) = Σ s_j (h_j, k_j) B_j / S lies in the convex hull of the
(h_j, k_j). Where κ1 <= c is where c² - 2cH + K >= 0 and H <= c, a half-plane cut by another: so κ1 of all pairs is at
most the largest κ1 of one, h_j where h_j² < k_j. Where c² - 2cH + K <= 0 for all, κ2 <= c <= κ1. The same holds of κ2
with signs turned, and 2H² - K, of which C is the root, is convex.
"""

from dataclasses import dataclass

import numpy as np

from quintrig.enclosures import intervals
from quintrig.enclosures.intervals import Interval, outward, over
from quintrig.support.arrays import BoolArray, FloatArray


@dataclass(frozen=True, eq=False)
class Pairs:
    """Bounds of each h_j and k_j, (boxes, n, m); ``known`` (boxes,) where all denominators are above 0."""

    mean: Interval
    gauss: Interval
    known: BoolArray

    @staticmethod
    def of(mean: Interval, gauss: Interval, below: Interval, factor: FloatArray) -> "Pairs":
        """Return the pairs of numerators over one denominator, H to be divided by what is between 1 and ``factor``."""
        known = _all(below[0] > 0.0) & np.isfinite(factor)
        safe = np.where(known[:, None, None], below[0], 1.0), np.where(known[:, None, None], below[1], 1.0)
        wide = np.where(known, factor, 1.0)[:, None, None]
        low, high = over(mean, safe)
        low, high = outward(np.minimum(low, low / wide), np.maximum(high, high / wide))
        return Pairs((low, high), over(gauss, safe), known)

    @property
    def _roots(self) -> tuple[BoolArray, Interval]:
        """Which h_j² are surely no less than k_j, and bounds of the roots of h_j² - k_j."""
        square = intervals.square(*self.mean)
        low, high = outward(square[0] - self.gauss[1], square[1] - self.gauss[0])
        return low >= 0.0, intervals.root(low, high)

    def principal(self) -> tuple[Interval, Interval]:
        """Return bounds of κ1 and of κ2 in each box."""
        real, (near, far) = self._roots
        low, high = self.mean
        larger = outward(low + near, high + far)
        smaller = outward(low - far, high - near)
        most, least = larger[1].max(axis=(1, 2)), smaller[0].min(axis=(1, 2))
        inner, outer = smaller[1].max(axis=(1, 2)), larger[0].min(axis=(1, 2))  # κ2 <= inner, outer <= κ1
        apart = _all(real) & (inner <= outer)
        ends: list[FloatArray] = [low.min(axis=(1, 2)), high.max(axis=(1, 2))]  # κ2 <= H <= κ1
        return (
            self._where(np.where(apart, outer, ends[0]), most),
            self._where(least, np.where(apart, inner, ends[1])),
        )

    def curvedness(self) -> Interval:
        """Return bounds of C in each box."""
        low, high = self.mean
        square = intervals.square(low, high)[1]
        most = outward(square, 2.0 * square - self.gauss[0])[1].max(axis=(1, 2))
        middle = 0.5 * (low.mean(axis=(1, 2)) + high.mean(axis=(1, 2)))[:, None, None]
        # 2H² >= 4 H middle - 2 middle²
        ends = outward(4.0 * np.minimum(middle * low, middle * high), 2.0 * middle * middle)
        least = outward(ends[0] - ends[1] - self.gauss[1], square)[0].min(axis=(1, 2))
        return self._where(*intervals.root(least, most))

    def _where(self, low: FloatArray, high: FloatArray) -> Interval:
        return np.where(self.known, low, -np.inf), np.where(self.known, high, np.inf)


def both(first: Interval, second: Interval) -> Interval:
    """Return what lies in two intervals."""
    return np.fmax(first[0], second[0]), np.fmin(first[1], second[1])


def _all(tested: BoolArray) -> BoolArray:
    return np.logical_and.reduce(tested, axis=(1, 2))
