"""A local origin: where a surface lies far out, its rows hold how far they are from a point near it.

Then no sum, product or quotient sees the distance, and only points lose the digits that their coordinates lack. The
origin is a multiple of a power of two of about four sizes, so that subtracting it rounds nothing far out, and zero for
whatever lies about the coordinate origin.
"""

from fractions import Fraction

import numpy as np

from quintrig.support.arrays import FloatArray


def local_origin(points: FloatArray) -> FloatArray:
    """Return an origin (d,) for points (..., d), length¹; those that are not finite are left out."""
    flat: FloatArray = points.reshape(-1, points.shape[-1])
    finite: FloatArray = flat[np.isfinite(flat).all(axis=-1)]
    if not len(finite):
        return np.zeros((points.shape[-1],))
    low: FloatArray = finite.min(axis=0)
    high: FloatArray = finite.max(axis=0)
    with np.errstate(over="ignore", invalid="ignore"):
        size = float((high - low).max())
    middle: FloatArray = 0.5 * low + 0.5 * high
    if size == 0.0:
        return middle
    if not np.isfinite(size):
        return np.zeros_like(middle)
    step = 2.0 ** min(np.frexp(size)[1] + 2, 1000)
    return np.rint(middle / step) * step if step > 0.0 else middle


def moved_plane(plane: FloatArray, origin: FloatArray) -> FloatArray:
    """Return the plane (a, b, c, d), a x + b y + c z + d = 0, as seen from an origin, d rounded once."""
    if not origin.any():
        return plane
    *normal, offset = (Fraction(float(x)) for x in plane)
    there = sum((n * Fraction(float(o)) for n, o in zip(normal, origin, strict=True)), offset)
    return np.array([*plane[:3], float(there)])
