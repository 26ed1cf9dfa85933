"""All common zeros of two or three forms over a chart: those known are each alone in a box, and none is elsewhere.

A box holds at most one zero where the two derivatives of two forms, made near to the unit matrix by its inverse in
the middle, stay a matrix with a dominant diagonal; it holds one where each form has its two signs on two opposite
sides (Miranda 1940; Moore and Jones 1977). The box may reach over the edges of the chart, as zeros on an edge need. All
others are looked through in halves, and one is free of zeros where one combination of the forms has one sign.
"""

from dataclasses import dataclass, field

import numpy as np

from quintrig.enclosures.ball import LEAST, UP, Ball, bound, product
from quintrig.enclosures.boxes import Boxes, bernstein
from quintrig.enclosures.search import NARROWEST, Outside, joined, nothing
from quintrig.support.arrays import BoolArray, FloatArray

_WIDEST, _NEAR = 3, 16
"""Boxes around zeros are 2^(1 - k) wide, k between these; the zero itself lies in the last."""

_BEYOND = 0.125
"""Zeros this far beyond a chart do not concern it."""

_GRID = 2.0**30  # boxes begin and end at multiples of its inverse, so that 1 - x is exact
_AT_ONCE = 1 << 20

Rectangle = tuple[float, float, float, float]
"""x and y where it begins, x and y where it ends."""


@dataclass
class Zeros:
    """Which zeros known are ``alone`` in a box, (k,), the rectangles left ``open``, and how many boxes it took."""

    alone: BoolArray
    open: list[Rectangle] = field(default_factory=list[Rectangle])
    boxes: int = 0


def zeros(forms: list[Ball], known: FloatArray, most: int, outside: Outside = nothing) -> Zeros:
    """Return what is known of the common zeros of two or three forms over [0, 1]², ``known`` (k, 2) near some of them.

    The first two forms, or the last two, have no other common zeros near such a one.
    """
    whole = Boxes.whole(forms)
    alone, around = alone_in(whole, known)
    return searched(whole, alone, around, most, outside)


def alone_in(whole: Boxes, known: FloatArray) -> tuple[BoolArray, list[Rectangle]]:
    """Return which of the zeros known are alone in a box, and these boxes."""
    alone: BoolArray = np.zeros(len(known), dtype=np.bool_)
    around: list[Rectangle] = []
    for index, place in enumerate(known):
        if (np.abs(place - 0.5) <= 0.5 + _BEYOND).all():
            box = _alone(whole, place)
            if box is not None:
                alone[index] = True
                around.append(box)
    return alone, around


def searched(whole: Boxes, alone: BoolArray, around: list[Rectangle], most: int, outside: Outside = nothing) -> Zeros:
    """Return what is left open outside the boxes ``around`` zeros, after at most ``most`` boxes."""
    found = Zeros(alone)
    waiting, sides = whole, np.array(around).reshape(-1, 4)
    while len(waiting):
        count = max(1, _AT_ONCE // whole.middle[0].size)
        now, waiting = waiting.take(slice(0, count)), waiting.take(slice(count, None))
        now = now.take(~outside(now.low, now.high) & ~_within(now, sides))
        found.boxes += len(now)
        now = now.take(~_free(now))
        if not len(now):
            continue
        lost = (now.high - now.low).max(axis=1) <= NARROWEST
        lost |= (np.abs(now.middle) <= now.radius).all(axis=(1, 2, 3))
        if found.boxes + len(waiting) + 2 * len(now) > most:
            lost[:] = True
        found.open += [(*a, *b) for a, b in zip(now.low[lost].tolist(), now.high[lost].tolist(), strict=True)]
        now = now.take(~lost)
        if len(now):
            waiting = joined(now.halved(quotients=False), waiting)
    return found


def _within(boxes: Boxes, sides: FloatArray) -> BoolArray:
    """Return which boxes lie in one of the rectangles (k, 4)."""
    low, high = boxes.low[:, None], boxes.high[:, None]
    inside = ((low >= sides[:, :2]) & (high <= sides[:, 2:])).all(axis=2)
    return np.logical_or.reduce(inside, axis=1)


def _free(boxes: Boxes) -> BoolArray:
    """Return which boxes hold no common zero: all coefficients lie on one side of a line through 0."""
    if not len(boxes):
        return np.zeros(0, dtype=np.bool_)
    size = np.abs(boxes.middle).max(axis=(2, 3), keepdims=True)
    unit = 1.0 / np.where(size > 0.0, size, 1.0)
    ways = (boxes.middle * unit).mean(axis=(2, 3), keepdims=True) * unit
    result = np.zeros(len(boxes), dtype=np.bool_)
    for way in (ways, *(ways * one[:, None, None] for one in np.eye(boxes.middle.shape[1]))):
        middle = way * boxes.middle
        off = np.abs(way) * boxes.radius + bound(4) * np.abs(middle) + LEAST
        result |= (middle.sum(axis=1) > off.sum(axis=1) * UP).all(axis=(1, 2))
    return result


def _alone(whole: Boxes, place: FloatArray) -> Rectangle | None:
    """Return a box around a place that holds one zero and no other; None where there is no such box."""
    centre = np.round(place * _GRID) / _GRID
    near = over(whole, centre - 2.0**-_NEAR, centre + 2.0**-_NEAR)
    for start in range(whole.middle.shape[1] - 1):
        pair = slice(start, start + 2)
        if not _one(near[0][pair], near[1][pair]):
            continue
        for k in range(_WIDEST, _NEAR + 1):
            low, high = centre - 2.0**-k, centre + 2.0**-k
            middle, radius = over(whole, low, high)
            if _one(middle[pair], radius[pair]):
                return (*low.tolist(), *high.tolist())
    return None


def over(whole: Boxes, low: FloatArray, high: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the coefficients of the forms over a box that may reach beyond the chart, and bounds of their errors."""
    (left, left_size), (right, right_size) = (
        _moved(size - 1, a, b) for size, a, b in zip(whole.middle.shape[2:], low.tolist(), high.tolist(), strict=True)
    )
    n, m = whole.middle.shape[2:]
    middle = product(product(left, whole.middle[0]), right.T)
    off = whole.radius[0] + bound(6 * (n + m) + 24) * np.abs(whole.middle[0])
    return middle, (product(product(left_size, off), right_size.T) + LEAST) * UP


def _moved(n: int, a: float, b: float) -> tuple[FloatArray, FloatArray]:
    """Return what takes coefficients on [0, 1] to those on [a, b], (n + 1, n + 1), and the same by absolute values.

    A coefficient is the polar form at n - j times a and j times b (Ramshaw 1989). An entry is off by no more than some
    4n units of roundoff of the one by absolute values.
    """
    matrix, size = np.zeros((n + 1, n + 1)), np.zeros((n + 1, n + 1))
    for j in range(n + 1):
        first, second = bernstein(n - j, a), bernstein(j, b)
        matrix[j] = np.convolve(first, second)
        size[j] = np.convolve(np.abs(first), np.abs(second))
    return matrix, size * UP


def _one(middle: FloatArray, radius: FloatArray) -> bool:
    """Return whether two forms (2, n, m) over a box have one common zero in it, for certain."""
    slopes = [_slopes(middle, radius, axis) for axis in (1, 2)]
    matrix = np.array([[part[0][form].mean() for part in slopes] for form in (0, 1)])
    if not np.isfinite(matrix).all() or abs(np.linalg.det(matrix)) <= 1e-12 * float((matrix * matrix).sum()):
        return False
    inverse = np.linalg.inv(matrix)
    (xx, yx), (xy, yy) = (_combined(inverse, *part) for part in slopes)  # xy: of the first form along y
    if not (_least(xx) > _most(xy) and _least(yy) > _most(yx)):
        return False
    first, second = _combined(inverse, middle, radius)
    sides = (first[0][0], first[1][0], -1), (first[0][-1], first[1][-1], 1)
    ends = (second[0][:, 0], second[1][:, 0], -1), (second[0][:, -1], second[1][:, -1], 1)
    return all(bool((sense * value > off).all()) for value, off, sense in (*sides, *ends))


def _slopes(middle: FloatArray, radius: FloatArray, axis: int) -> tuple[FloatArray, FloatArray]:
    """Return the coefficients of the derivatives along an axis of a box of width 1, and bounds of their errors."""
    degree = middle.shape[axis] - 1
    parts = [np.take(array, range(1, degree + 1), axis) for array in (middle, radius)]
    before = [np.take(array, range(degree), axis) for array in (middle, radius)]
    off = parts[1] + before[1] + bound(2) * (np.abs(parts[0]) + np.abs(before[0]))
    return degree * (parts[0] - before[0]), degree * off * UP


def _combined(matrix: FloatArray, middle: FloatArray, radius: FloatArray) -> list[tuple[FloatArray, FloatArray]]:
    """Return combinations of two arrays (2, n, m), each with a bound of its error."""
    size = np.abs(matrix)
    value = np.einsum("ij,jnm->inm", matrix, middle)
    off = np.einsum("ij,jnm->inm", size, radius + bound(3) * np.abs(middle)) * UP + LEAST
    return [(value[0], off[0]), (value[1], off[1])]


def _least(ball: tuple[FloatArray, FloatArray]) -> float:
    """Return a lower bound of what the values are above 0."""
    return float((ball[0] - ball[1]).min())


def _most(ball: tuple[FloatArray, FloatArray]) -> float:
    """Return an upper bound of the absolute values."""
    return float((np.abs(ball[0]) + ball[1]).max())
