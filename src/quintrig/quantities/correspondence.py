"""Which types of the three classifications correspond, for ``agreement``.

HK types and shape classes are compared by the ranges of the shape index S that they stand for, HK types and the types
of the invariants by their signs.
"""

from fractions import Fraction

import numpy as np

from quintrig.quantities.classify import HK_TYPES, INVARIANT_TYPES, SHAPE_CLASSES
from quintrig.support.arrays import IntArray

LEVELS = ("undefined", "agree", "neighbouring", "conflict")
"""Index is the code."""
UNDEFINED, AGREE, NEIGHBOURING, CONFLICT = range(4)

_PLANE = HK_TYPES.index("flat")
_PLANAR = SHAPE_CLASSES.index("planar")

# Where the HK types lie on the scale of S, from both ends.
_HK_RANGES = {
    "pit": (Fraction(-1), Fraction(-1, 2)),
    "valley": (Fraction(-1, 2), Fraction(-1, 2)),
    "saddle valley": (Fraction(-1, 2), Fraction(0)),
    "minimal": (Fraction(0), Fraction(0)),
    "saddle ridge": (Fraction(0), Fraction(1, 2)),
    "ridge": (Fraction(1, 2), Fraction(1, 2)),
    "peak": (Fraction(1, 2), Fraction(1)),
}


def _class_levels() -> IntArray:
    """Return the levels of HK types and shape classes: agree where one range of S holds the other.

    Neighbouring where they only overlap.
    """
    levels = np.full((len(HK_TYPES), len(SHAPE_CLASSES)), CONFLICT, dtype=np.int8)
    levels[0, :] = levels[:, 0] = UNDEFINED
    levels[_PLANE, _PLANAR] = AGREE
    for name, (low, high) in _HK_RANGES.items():
        for code in range(1, 10):
            left, right = max(Fraction(2 * code - 11, 8), Fraction(-1)), min(Fraction(2 * code - 9, 8), Fraction(1))
            within = low <= left and right <= high
            holds = low == high and left <= low <= right
            overlap = max(low, left) < min(high, right)
            level = AGREE if within or holds else NEIGHBOURING if overlap else CONFLICT
            levels[HK_TYPES.index(name), code] = level
    levels.setflags(write=False)
    return levels


def _besl_levels() -> IntArray:
    """Return the level of two types in Besl's numbering: neighbouring where no sign of the one opposes the other's."""
    levels = np.full((len(HK_TYPES), len(INVARIANT_TYPES)), UNDEFINED, dtype=np.int8)
    for i in range(1, 10):
        for j in range(1, 10):
            h, k = abs((i - 1) // 3 - (j - 1) // 3), abs((i - 1) % 3 - (j - 1) % 3)
            levels[i, j] = AGREE if i == j else CONFLICT if max(h, k) == 2 else NEIGHBOURING
    levels.setflags(write=False)
    return levels


def _height_levels(hk_class: IntArray, hk_height: IntArray) -> IntArray:
    """Return the level of every shape class and invariant type.

    The HK types that a class allows stand for it: where one of them agrees fully, so does the class; where all
    conflict, it does too.
    """
    levels = np.full((len(SHAPE_CLASSES), len(INVARIANT_TYPES)), UNDEFINED, dtype=np.int8)
    for i in range(1, len(SHAPE_CLASSES)):
        allowed = [hk for hk in range(1, 10) if hk_class[hk, i] in (AGREE, NEIGHBOURING)]
        for j in range(1, 10):
            best = min(int(hk_height[hk, j]) for hk in allowed)
            levels[i, j] = AGREE if hk_class[j, i] == AGREE else max(best, NEIGHBOURING)
    levels.setflags(write=False)
    return levels


HK_VERSUS_CLASS: IntArray = _class_levels()
"""Level of each HK type (10 codes) against each shape class (11 codes)."""
HK_VERSUS_HEIGHT: IntArray = _besl_levels()
"""Level of each HK type, seen from above, against each type of the invariants (10 codes each)."""
CLASS_VERSUS_HEIGHT: IntArray = _height_levels(HK_VERSUS_CLASS, HK_VERSUS_HEIGHT)
"""Level of each shape class, seen from above, against each type of the invariants (11 and 10 codes)."""
