"""How often two forms turn around 0 along the sides of a rectangle, for certain: the index of what vanishes inside.

Along a piece of a side one of the two forms has one sign, told by its coefficients over a box around the piece. Four
such half planes lie a quarter turn apart; where two pieces meet both signs hold, so that a quarter turn is told from
one against it. Where the turn is not 0, the forms have a common zero inside (Kronecker 1869).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.enclosures.ball import LEAST, UP, bound
from quintrig.enclosures.boxes import Boxes
from quintrig.enclosures.zeros import over
from quintrig.support.arrays import FloatArray

_THICK = 2.0**-40
"""Of a chart: more than the rounding of parameters, by which the boxes around a side reach over it."""

_DEEPEST = 7
"""Times that a side is halved."""

Place = Callable[[FloatArray], FloatArray]
"""From u, v (2,) to the parameters of a chart (2,)."""


@dataclass(frozen=True, eq=False)
class Part:
    """Two forms over a chart, the u, v (2,) between which they stand for the surface, and the chart's own places."""

    whole: Boxes
    low: FloatArray
    high: FloatArray
    place: Place


def turn(parts: Sequence[Part], low: FloatArray, high: FloatArray) -> int | None:
    """Return how often the forms turn around 0 against the clock along a rectangle in u, v; None where it is open."""
    corners = [low, np.array([high[0], low[1]]), high, np.array([low[0], high[1]])]
    quarters, first, last = 0, -1, -1
    for k, (start, end) in enumerate(zip(corners, [*corners[1:], corners[0]], strict=True)):
        for part, begin, stop in _pieces(parts, start, end, k % 2):
            labels = None if part is None else _labels(part, begin, stop, last, 0)
            if labels is None:
                return None
            for label in labels:
                if last >= 0:
                    step = (label - last + 1) % 4 - 1
                    if step == 2:
                        return None
                    quarters += step
                first = label if first < 0 else first
                last = label
    step = (first - last + 1) % 4 - 1
    return None if step == 2 or (quarters + step) % 4 else (quarters + step) // 4


def _pieces(
    parts: Sequence[Part], start: FloatArray, end: FloatArray, axis: int
) -> list[tuple[Part | None, FloatArray, FloatArray]]:
    """Return the parts that a side runs through, with where it enters and leaves each; None for one that is missing."""
    sense = 1.0 if end[axis] > start[axis] else -1.0
    here = [part for part in parts if part.low[1 - axis] <= start[1 - axis] <= part.high[1 - axis]]
    found: list[tuple[Part | None, FloatArray, FloatArray]] = []
    at = start.copy()
    while sense * (float(end[axis]) - float(at[axis])) > 0.0:
        best, reach = None, float(at[axis])
        for part in here:
            near, far = (part.low, part.high) if sense > 0.0 else (part.high, part.low)
            if sense * (at[axis] - near[axis]) >= 0.0 and sense * (far[axis] - reach) > 0.0:
                best, reach = part, float(far[axis])
        following = end.copy()
        if best is None:
            return [*found, (None, at, end)]
        following[axis] = min(reach, float(end[axis])) if sense > 0.0 else max(reach, float(end[axis]))
        found.append((best, at, following))
        at = following
    return found


def _labels(part: Part, start: FloatArray, end: FloatArray, last: int, depth: int) -> list[int] | None:
    """Return what half planes the forms run through: first > 0, second > 0, first < 0, second < 0 as 0 to 3."""
    places = part.place(start), part.place(end)
    middle, radius = over(part.whole, np.minimum(*places) - _THICK, np.maximum(*places) + _THICK)
    off = radius + bound(4) * np.abs(middle) + LEAST
    held = [form + way for form in (0, 1) for sign, way in ((1, 0), (-1, 2)) if _sure(sign * middle[form], off[form])]
    if held:
        return [last if last in held else held[0]]
    if depth == _DEEPEST:
        return None
    between = 0.5 * (start + end)
    before = _labels(part, start, between, last, depth + 1)
    after = None if before is None else _labels(part, between, end, before[-1], depth + 1)
    return None if before is None or after is None else before + after


def _sure(values: FloatArray, off: FloatArray) -> bool:
    return bool((values > off * UP).all())
