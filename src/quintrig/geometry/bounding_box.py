"""The box around a surface, refined beyond the points at which it is first looked at."""

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

_ZOOMS = 3
_SIDE = 9


def bounding_box(surface: Surface, u: FloatArray, v: FloatArray, points: FloatArray) -> FloatArray:
    """Return the least and the greatest x, y, z of a surface or trimmed face, (2, 3), length¹, read-only.

    ``points`` (n, m, 3) are those at u (n,) x v (m,). Beside each extreme of them the surface is looked at again, on a
    grid of 9 x 9, and so on: three times, after which a smooth extreme is met to about 1e-6 of what a cell rises.
    """
    inside = surface.inside(u[:, None], v)
    masked: FloatArray = np.where(inside[..., None], points, np.nan)
    rims = [surface(*loop.T) for loop in surface.trim]
    box: FloatArray = np.empty((2, 3))
    for row, sign in enumerate((-1.0, 1.0)):
        for axis in range(3):
            found = _highest(surface, u, v, sign * masked[..., axis], axis, sign)
            box[row, axis] = sign * max([found, *(float((sign * rim[:, axis]).max()) for rim in rims)])
    box.setflags(write=False)
    return box


def _highest(surface: Surface, u: FloatArray, v: FloatArray, heights: FloatArray, axis: int, sign: float) -> float:
    best = -np.inf
    for _ in range(_ZOOMS + 1):
        if not np.isfinite(heights).any():
            break
        i, j = np.unravel_index(int(np.nanargmax(heights)), heights.shape)
        best = max(best, float(heights[i, j]))
        u, v = _around(u, int(i)), _around(v, int(j))
        closer = sign * surface(u[:, None], v)[..., axis]
        heights = np.where(surface.inside(u[:, None], v), closer, np.nan)
    return best


def _around(t: FloatArray, index: int) -> FloatArray:
    """Return parameters from the one before to the one after one of ``t``."""
    return np.linspace(float(t[max(index - 1, 0)]), float(t[min(index + 1, len(t) - 1)]), _SIDE)
