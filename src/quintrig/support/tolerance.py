"""What of a value is only rounding: the one rule by which tables, extremes and summaries tell 0 for it."""

import numpy as np

from quintrig.support.arrays import FloatArray

NOISE = 1e-12
"""Share of the scale of a quantity at or below which a value is only rounding."""


def rounding_floor(curvedness: FloatArray, size: float, power: int) -> FloatArray:
    """Return the size at or below which values, length^``power``, at points of this curvedness are only rounding.

    The scale is a power of the surface's ``size``; for curvatures, of C or of 1 / size where that is greater.
    """
    if power >= 0 or not size > 0.0:
        return np.full(curvedness.shape, NOISE * size ** max(power, 0))
    return NOISE * np.fmax(curvedness, 1.0 / size) ** -power
