"""All tolerances: what of a value is only rounding, and where a surface has no tangent plane or a vertical one."""

import math

import numpy as np

from quintrig.support.arrays import FloatArray

NOISE = 1e-12
"""Share of the scale of a quantity at or below which a value is only rounding."""

SAME_COLOUR = 1e-9
"""Share of the scale of a quantity at or below which a spread of values is drawn in one colour."""

SINGULAR = 4096 * np.finfo(np.float64).eps
"""A point is singular where |S_u x S_v| <= SINGULAR size²: three digits above rounding, so that the normal has some
left."""

VERTICAL = 1e-9
"""At or below this |n_z| the tangent plane counts as vertical: what is left of n_z after rounding means nothing."""

_STEPS = 64.0
"""Units in the last place that two evaluations of a point may differ by; they differ by about ten in practice."""


def rounding_floor(curvedness: FloatArray, size: float, power: int) -> FloatArray:
    """Return the size at or below which values, length^``power``, at points of this curvedness are only rounding.

    The scale is a power of the surface's ``size``; for curvatures, of C or of 1 / size where that is greater.
    """
    if power >= 0 or not size > 0.0:
        return np.full(curvedness.shape, NOISE * size ** max(power, 0))
    return NOISE * np.fmax(curvedness, 1.0 / size) ** -power


def typical_rounding(curvedness: float, power: int) -> float:
    """Return the size at or below which one value, length^``power``, is rounding on a surface of this mean curvedness.

    0 where nothing is told: for lengths and areas, and where the curvedness has no bound.
    """
    return NOISE * curvedness**-power if power < 0 and math.isfinite(curvedness) else 0.0


def rounding(points: FloatArray) -> float:
    """Return how far apart rounding may put two computations of one of the points (..., 3), length¹.

    It grows with the distance from the origin; points at infinity are left out.
    """
    finite = np.abs(points[np.isfinite(points)])
    return _STEPS * float(np.finfo(np.float64).eps) * float(finite.max(initial=0.0))
