"""The parameters of the point of a surface that is nearest to a given point."""

from typing import cast

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

_STEPS = 30


def projected(surface: Surface, points: FloatArray, density: int = 49) -> FloatArray:
    """Return (u, v), shape (n, 2), of the surface points nearest to ``points`` (n, 3), length¹.

    The nearest point of a grid of ``density`` a side starts Gauss and Newton's iteration, held inside the domain.
    """
    t = np.linspace(0.0, 1.0, density)
    cloud = surface(t[:, None], t[None, :]).reshape(-1, 3)
    nearest = np.array([int(((cloud - point) ** 2).sum(axis=1).argmin()) for point in points], dtype=np.int64)
    return refined(surface, points, np.stack([t[nearest // density], t[nearest % density]], axis=1))


def refined(surface: Surface, points: FloatArray, at: FloatArray) -> FloatArray:
    """Return the same from places ``at`` (n, 2) that are near already."""
    for _ in range(_STEPS):
        p = surface.partials(at[:, 0], at[:, 1], 1)
        gap, along = points - p[0, 0], np.stack([p[1, 0], p[0, 1]], axis=-1)
        metric = along.transpose(0, 2, 1) @ along
        metric += 1e-14 * np.trace(metric, axis1=1, axis2=2)[:, None, None] * np.eye(2) + 1e-300 * np.eye(2)
        downhill: FloatArray = along.transpose(0, 2, 1) @ gap[..., None]
        step = cast(FloatArray, np.linalg.solve(metric, downhill))[..., 0]
        moved: FloatArray = np.clip(at + step, 0.0, 1.0)
        if np.abs(moved - at).max() <= 1e-13:
            return moved
        at = moved
    return at
