"""Edges that are one point: a pole, with one normal, or an apex, with many."""

import numpy as np

from quintrig.enclosures.charts import Chart
from quintrig.enclosures.shape import Form, Shape, Vector, cross
from quintrig.enclosures.whole import InexactError

_ROUNDED = 1e-9
"""Normals that differ by a smaller angle at a pole do so by the rounding of control points and weights."""


def apex(chart: Chart, shape: Shape) -> tuple[float, float] | None:
    """Return a place on an edge that is one point, where the normal hangs on the way to it; None if there is none.

    ``shape`` is exact; where it cannot be, such edges count as apexes.
    """
    try:
        first, second = shape.factors
        edges = ((0, 0.0, second[0]), (0, 1.0, second[1]), (1, 0.0, first[2]), (1, 1.0, first[3]))
        for axis, end, power in edges:
            if power and not _one_normal(shape.normal, axis, end):
                return (end, 0.5) if axis == 0 else (0.5, end)
    except InexactError:
        return None
    return None


def _one_normal(normal: Vector, axis: int, end: float) -> bool:
    """Return whether the normal keeps its direction along an edge, to the rounding of control points and weights."""
    along = [_side(part, axis, end) for part in normal]
    corner = [_side(part, 1 - axis, 0.0) for part in along]
    if all(part.vanishes for part in cross(along, corner)):
        return True
    rows = np.stack([part.ball().middle.ravel() for part in along], axis=-1)
    first = np.array([part.ball().middle.ravel()[0] for part in corner])
    sines = np.linalg.norm(np.cross(rows, first), axis=-1)
    return bool((sines <= _ROUNDED * np.linalg.norm(rows, axis=-1) * np.linalg.norm(first)).all())


def _side(form: Form, axis: int, end: float) -> Form:
    """Return a form along an edge across ``axis``, as one of degree 0 in that axis."""
    n = form.degree[axis]
    first, last = (0, n) if end == 0.0 else (n, 0)
    return form.divided((first, last, 0, 0) if axis == 0 else (0, 0, first, last))
