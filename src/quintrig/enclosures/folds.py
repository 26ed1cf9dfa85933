"""Folds along which the normal turns over, as of surfaces in a plane: proved where N keeps to one line across them.

Where N = s(t) e along a parameter line, to the last digit, and s has both signs, N vanishes between them. Of other
surfaces N has single zeros at most, as a rule.
"""

import math
from itertools import pairwise

import numpy as np

from quintrig.basis.exact_numbers import Exact
from quintrig.enclosures.whole import Whole

_LINES, _PLACES = 8, 64


def turning(normal: list[Whole]) -> tuple[float, float] | None:
    """Return a place (x, y) of a chart where N has a zero between N and -N; None where none is seen."""
    under = math.lcm(*(part.under for part in normal))
    over = np.stack([part.over * (under // part.under) for part in normal], axis=-1)
    for axis, forms in ((0, over), (1, over.transpose(1, 0, 2))):
        for k in range(_LINES + 1):
            across = _powers(forms.shape[1] - 1, k, _LINES)
            found = _zero(np.stack([forms[..., i].dot(across) for i in range(3)], axis=-1))
            if found is not None:
                return (found, k / _LINES) if axis == 0 else (k / _LINES, found)
    return None


def _powers(degree: int, k: int, of: int) -> Exact:
    """Return what the coefficients of a form are multiplied by at k / of, times a power of ``of``."""
    return np.array([(of - k) ** (degree - j) * k**j for j in range(degree + 1)], dtype=object)


def _zero(line: Exact) -> float | None:
    """Return where a form (n + 1, 3) goes from one direction to its opposite; None if it keeps to no line, or never."""
    way = next((row for row in line if row.any()), None)
    if way is None or any(x[i - 2] * way[i - 1] != x[i - 1] * way[i - 2] for x in line for i in range(3)):
        return None
    size = line.dot(way)
    values = [(k, size.dot(_powers(len(size) - 1, k, _PLACES))) for k in range(_PLACES + 1)]
    signed = [(k, value) for k, value in values if value]
    for (first, one), (last, other) in pairwise(signed):
        if (one > 0) != (other > 0):
            return (first + (last - first) * (one / (one - other))) / _PLACES
    return None
