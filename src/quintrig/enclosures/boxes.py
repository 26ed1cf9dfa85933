"""Bernstein coefficients of several forms over one box and its parts: halved, enclosed, with every rounding counted.

A polynomial lies between its least and its greatest Bernstein coefficient, and takes the corner coefficients at the
corners. Halving a box replaces coefficients by averages, so the bounds of their errors are averaged too.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from quintrig.enclosures.ball import LEAST, UP, Ball, bound, product
from quintrig.support.arrays import BoolArray, FloatArray

_LONGEST = 8.0  # of the other side
_STILL = 1e-6

Enclose = Callable[[FloatArray, FloatArray], tuple[FloatArray, FloatArray]]
"""From lower and upper bounds of coefficients (boxes, forms, n, m) to bounds of the quantity in each box (boxes,)."""


@dataclass(frozen=True, eq=False)
class Boxes:
    """Coefficients ``middle`` ± ``radius`` (boxes, forms, n + 1, m + 1) over the boxes [low, high], (boxes, 2) each."""

    middle: FloatArray
    radius: FloatArray
    low: FloatArray
    high: FloatArray

    @staticmethod
    def whole(forms: Sequence[Ball], low: tuple[float, float] = (0.0, 0.0), wide: float = 1.0) -> "Boxes":
        """Return one box from forms of one bidegree over it: a chart, or a part of it ``wide`` from ``low``."""
        n, m = forms[0].degree
        scale = _binomials(n)[:, None] * _binomials(m)[None, :]
        middle = np.stack([form.middle for form in forms]) / scale
        radius = np.stack([form.radius for form in forms]) / scale + bound(2) * np.abs(middle)
        radius = (radius + LEAST * (radius > 0.0)) * UP
        return Boxes(middle[None], radius[None], np.array([low]), np.array([low]) + wide)

    def __len__(self) -> int:
        """Return the number of boxes."""
        return len(self.middle)

    def take(self, chosen: BoolArray | slice) -> "Boxes":
        """Return some of the boxes."""
        return Boxes(self.middle[chosen], self.radius[chosen], self.low[chosen], self.high[chosen])

    def bounds(self) -> tuple[FloatArray, FloatArray]:
        """Return lower and upper bounds of all coefficients."""
        return ends(self.middle, self.radius)

    def corners(self) -> tuple[FloatArray, FloatArray]:
        """Return bounds of the values at the corners (boxes × 4, forms, 1, 1)."""
        n, m = (max(size - 1, 1) for size in self.middle.shape[2:])
        parts: list[FloatArray] = []
        for array in (self.middle, self.radius):
            found = array[:, :, ::n, ::m]
            if found.shape[2] == 1 or found.shape[3] == 1:
                found = np.broadcast_to(found, (*found.shape[:2], 2, 2))
            parts.append(found.transpose(0, 2, 3, 1).reshape(-1, array.shape[1], 1, 1))
        return ends(parts[0], parts[1])

    def places(self) -> FloatArray:
        """Return the corners themselves, (boxes × 4, 2), in the same order."""
        ends_ = np.stack([self.low, self.high], axis=1)
        return np.stack(
            [np.stack([ends_[:, i, 0], ends_[:, j, 1]], axis=-1) for i in (0, 1) for j in (0, 1)], 1
        ).reshape(-1, 2)

    def halved(self, quotients: bool = True) -> "Boxes":
        """Return the halves of all boxes, each cut along the side over which its coefficients differ more.

        With ``quotients`` several forms count by how the first and the third differ when divided by the second.
        """
        values = self._relative() if quotients else self.middle
        size = np.abs(values).max(axis=(2, 3), initial=LEAST)
        along, across = (
            (np.abs(np.diff(values, axis=axis)).max(axis=(2, 3), initial=0.0) / size).max(axis=1) * values.shape[axis]
            for axis in (2, 3)
        )
        wide = self.high - self.low
        first = along >= across
        # A box much longer than wide is cut across, unless nothing changes that way.
        first |= (wide[:, 0] > _LONGEST * wide[:, 1]) & (along > _STILL * across)
        first &= ~((wide[:, 1] > _LONGEST * wide[:, 0]) & (across > _STILL * along))
        cut = np.where(first & (wide[:, 0] > 2.0**-40) | (self.middle.shape[3] == 1), 0, 1)
        if self.middle.shape[2] == 1:
            cut[:] = 1
        parts = [self.take(cut == axis)._cut(axis) for axis in (0, 1) if (cut == axis).any()]
        fields = ("middle", "radius", "low", "high")
        return Boxes(*(np.concatenate([getattr(part, name) for part in parts]) for name in fields))

    def _relative(self) -> FloatArray:
        """Return the coefficients, or the quotients of the first and third by the second form, which σ is not in."""
        if self.middle.shape[1] == 1:
            return self.middle
        below = self.middle[:, 1:2]
        size = np.abs(below).max(axis=(2, 3), keepdims=True)
        usable = np.abs(below) > 1e-12 * size
        return np.where(usable, self.middle[:, :3:2] / np.where(usable, below, 1.0), 0.0)

    def _cut(self, axis: int) -> "Boxes":
        n = self.middle.shape[2 + axis] - 1
        first = halving(n)
        error = self.radius + bound(n + 1) * np.abs(self.middle)
        parts: list[tuple[FloatArray, FloatArray]] = []
        for matrix in (first, first[::-1, ::-1]):
            if axis:
                middle, radius = product(self.middle, matrix.T), product(error, matrix.T)
            else:
                middle, radius = product(matrix, self.middle), product(matrix, error)
            parts.append((middle, (radius + LEAST * (radius > 0.0)) * UP))
        centre = 0.5 * (self.low[:, axis] + self.high[:, axis])
        low, high = self.low.copy(), self.high.copy()
        low[:, axis], high[:, axis] = centre, centre
        return Boxes(
            np.concatenate([parts[0][0], parts[1][0]]),
            np.concatenate([parts[0][1], parts[1][1]]),
            np.concatenate([self.low, low]),
            np.concatenate([high, self.high]),
        )

    def at(self, x: float, y: float) -> tuple[FloatArray, FloatArray]:
        """Return bounds of the forms at a place of the first box, (1, forms, 1, 1)."""
        x, y = ((np.array([x, y]) - self.low[0]) / (self.high[0] - self.low[0])).tolist()
        n, m = self.middle.shape[2] - 1, self.middle.shape[3] - 1
        left, right = bernstein(n, x), bernstein(m, y)
        off = bound(2 * (n + m) + 8)
        middle = left @ self.middle[0] @ right
        radius = left @ (self.radius[0] + off * np.abs(self.middle[0])) @ right
        return ends(middle[None, :, None, None], (radius[None, :, None, None] + LEAST) * UP)


def ends(middle: FloatArray, radius: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return middle - radius and middle + radius, rounded outwards; exact where the radius is 0."""
    exact = radius == 0.0
    low, high = middle - radius, middle + radius
    return (
        np.where(exact, middle, np.nextafter(low, -np.inf)),
        np.where(exact, middle, np.nextafter(high, np.inf)),
    )


@lru_cache(maxsize=64)
def halving(n: int) -> FloatArray:
    """Return the matrix (n + 1, n + 1) that takes coefficients to those of the first half: C(k, j) / 2^k."""
    rows = [[math.comb(k, j) / 2**k for j in range(n + 1)] for k in range(n + 1)]
    matrix = np.array(rows)
    matrix.flags.writeable = False
    return matrix


@lru_cache(maxsize=64)
def _binomials(n: int) -> FloatArray:
    return np.array([float(math.comb(n, k)) for k in range(n + 1)])


def bernstein(n: int, x: float) -> FloatArray:
    """Return the Bernstein polynomials at x (n + 1,), each off by at most 2n + 4 units of roundoff."""
    ends_ = [np.multiply.accumulate(np.concatenate([[1.0], np.full(n, end)])) for end in (1.0 - x, x)]
    return _binomials(n) * ends_[0][::-1] * ends_[1]
