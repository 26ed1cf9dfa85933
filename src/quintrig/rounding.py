"""How far apart rounding may put two computations of one point: it grows with the distance from the origin."""

import numpy as np

from quintrig.support.arrays import FloatArray

_STEPS = 64.0
"""Units in the last place that two evaluations of a point may differ by; they differ by about ten in practice."""


def rounding(points: FloatArray) -> float:
    """Return that distance for points (..., 3), length¹; those at infinity are left out."""
    finite = np.abs(points[np.isfinite(points)])
    return _STEPS * float(np.finfo(np.float64).eps) * float(finite.max(initial=0.0))
