"""Trim loops: closed polygons in the parameters (u, v) of a face."""

from collections.abc import Sequence

import numpy as np

from quintrig.support.arrays import FloatArray

_SAME = 1e-9  # parameters this near are one point


def simplified(loop: FloatArray) -> FloatArray:
    """Return the loop (n, 2) without repeated points and without those on a straight line between their neighbours."""
    loop = loop[np.abs(loop - np.roll(loop, 1, axis=0)).max(axis=1) > _SAME]
    if len(loop) < 3:
        return loop
    before, after = loop - np.roll(loop, 1, axis=0), np.roll(loop, -1, axis=0) - loop
    bend = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    onward = (before * after).sum(axis=1) > 0.0
    return loop[~((np.abs(bend) <= _SAME * _SAME) & onward)]


def without_border(loops: Sequence[FloatArray]) -> list[FloatArray]:
    """Return the loops, none where the only one is the border of the domain: such a face is not trimmed."""
    kept = [loop for loop in loops if len(loop) >= 3]
    if len(kept) == 1 and _on_border(kept[0]) and abs(abs(area(kept[0])) - 1.0) <= 1e-6:
        return []
    return kept


def area(loop: FloatArray) -> float:
    """Return the signed area inside a closed loop (n, 2), positive where it runs counter-clockwise."""
    u, v = loop.T
    return 0.5 * float((u * np.roll(v, -1) - np.roll(u, -1) * v).sum())


def _on_border(loop: FloatArray) -> bool:
    return bool((np.minimum(loop, 1.0 - loop).min(axis=1) <= 1e-6).all())
