"""Where a point of a CAD surface lies on its exact NURBS form, whose parameters run otherwise along circles."""

from collections.abc import Callable
from typing import Any

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

Box = tuple[float, float, float, float]
Places = Callable[[FloatArray], FloatArray]

SAME = ("BSplineSurface", "BezierSurface", "Plane")
"""Kinds of surfaces whose NURBS form has the same parameters."""

_STEPS = 30
_SETTLED = 1e-14


def places(carrier: Any, kind: str, surface: Surface, box: Box) -> Places:
    """Return the function from parameters (n, 2) of a CAD surface to (u, v) in [0, 1]² of its NURBS form.

    ``box`` (u0, u1, v0, v1) is the part of the CAD surface that the NURBS ``surface`` is. Along a circle a CAD surface
    has the angle, a NURBS a quotient of polynomials: each parameter is found where the points agree, by Gauss's and
    Newton's method along a line through the middle, where neither has a pole.
    """
    low, span = np.array([box[0], box[2]]), np.array([box[1] - box[0], box[3] - box[2]])

    def evenly(at: FloatArray) -> FloatArray:
        return np.clip((at - low) / span, 0.0, 1.0)

    if kind in SAME:
        return evenly
    middle = low + 0.5 * span
    centre = _solved(surface, _points(carrier, middle[None]), np.full((1, 2), 0.5), (0, 1))[0]

    def solved(at: FloatArray) -> FloatArray:
        guess, result = evenly(at), np.empty_like(at)
        for axis in (0, 1):
            line, start = np.tile(middle, (len(at), 1)), np.tile(centre, (len(at), 1))
            line[:, axis], start[:, axis] = (low + span * guess)[:, axis], guess[:, axis]
            result[:, axis] = _solved(surface, _points(carrier, line), start, (axis,))[:, axis]
        return result

    return solved


def _points(carrier: Any, at: FloatArray) -> FloatArray:
    found = [carrier.Value(u, v) for u, v in at.tolist()]
    return np.array([(p.X(), p.Y(), p.Z()) for p in found])


def _solved(surface: Surface, points: FloatArray, at: FloatArray, axes: tuple[int, ...]) -> FloatArray:
    """Return the parameters (n, 2) of points (n, 3) on the surface, near ``at``, moved along these axes only."""
    for _ in range(_STEPS):
        partials = surface.partials(at[:, 0], at[:, 1], 1)
        slopes = np.stack([partials[1, 0], partials[0, 1]], axis=-1)[..., axes]
        step = np.einsum("nij,nj->ni", np.linalg.pinv(slopes), points - partials[0, 0])
        moved = at.copy()
        moved[:, axes] = np.clip(at[:, axes] + step, 0.0, 1.0)
        change, at = float(np.abs(moved - at).max()), moved
        if change <= _SETTLED:
            break
    return at
