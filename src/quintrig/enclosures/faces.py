"""Which boxes of a chart lie outside a trimmed face, for certain."""

import numpy as np

from quintrig.enclosures.charts import Chart, rounded_edges
from quintrig.enclosures.search import Outside, nothing
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import BoolArray, FloatArray

BESIDE = 2.0**-10
"""Of the domain: so near to a pole that is one but for rounding, nothing is proved of curvature."""

_MARGIN = 1e-9
"""Of the domain: more than the rounding of parameters. Boxes this near to a loop count as inside."""


def outside(surface: Surface, chart: Chart) -> Outside:
    """Return what tells the boxes that no part of a trimmed face lies in; none for a whole surface."""
    if not surface.trim:
        return nothing
    start = np.concatenate(surface.trim)
    end = np.concatenate([np.roll(loop, -1, axis=0) for loop in surface.trim])

    def test(low: FloatArray, high: FloatArray) -> BoolArray:
        result = np.zeros(len(low), dtype=np.bool_)
        first = np.stack(chart.parameters(low[:, 0], low[:, 1]), axis=-1)
        last = np.stack(chart.parameters(high[:, 0], high[:, 1]), axis=-1)
        for i, (a, b) in enumerate(zip(first, last, strict=True)):
            point = bool((a == b).all())
            middle = 0.5 * (a + b)
            if not surface.inside(*middle) and (point or not _crossed(start, end, a - _MARGIN, b + _MARGIN)):
                result[i] = True
        return result

    return test


def beside(surface: Surface, chart: Chart) -> Outside:
    """Return ``outside``, and what lies beside poles that are such but for rounding: there K is rounding over 0."""
    trimmed, edges = outside(surface, chart), rounded_edges(surface)
    if not edges:
        return trimmed

    def test(low: FloatArray, high: FloatArray) -> BoolArray:
        result = trimmed(low, high)
        first, last = chart.parameters(low[:, 0], low[:, 1]), chart.parameters(high[:, 0], high[:, 1])
        for axis, end in edges:
            result = result | ((last[axis] <= BESIDE) if end == 0 else (first[axis] >= 1.0 - BESIDE))
        return result

    return test


def _crossed(start: FloatArray, end: FloatArray, low: FloatArray, high: FloatArray) -> bool:
    """Return whether a side of the loops may enter a box: its own box does, and the corners lie on both sides of it."""
    near = ((np.minimum(start, end) <= high) & (np.maximum(start, end) >= low)).all(axis=1)
    if not near.any():
        return False
    p, d = start[near], (end - start)[near]
    corners = np.array([[low[0], low[1]], [high[0], low[1]], [low[0], high[1]], [high[0], high[1]]])
    side = d[:, None, 0] * (corners[:, 1] - p[:, None, 1]) - d[:, None, 1] * (corners[:, 0] - p[:, None, 0])
    slack = 1e-12
    return bool(((side.min(axis=1) <= slack) & (side.max(axis=1) >= -slack)).any())
