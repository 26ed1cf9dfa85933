"""Trim loops: closed polygons in the parameters (u, v) of a face."""

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np

from quintrig.arrays import FloatArray

_SAME = 1e-9  # parameters this near are one point
_CHORD = 1e-5  # of the domain: how far a polygon may be from its curve
_HALVINGS = 12
_BALANCED = 3  # vertices at the border of the domain cannot give way: their neighbours do


def polygon(curve: Callable[[FloatArray], FloatArray], breaks: FloatArray) -> FloatArray:
    """Return a polygon (n, 2) in the domain for a curve in it, which is smooth between the ``breaks`` (m,).

    It is within 1e-5 of the curve, now on one side of it and now on the other, so that the area beside it is right to
    1e-9 and less. It starts and ends where the curve does.
    """
    pieces: list[FloatArray] = [np.linspace(low, high, 17)[:-1] for low, high in pairwise(breaks)]
    t = refined(curve, np.concatenate([*pieces, breaks[-1:]]), _CHORD)
    return _balanced(curve(t), curve(0.5 * (t[:-1] + t[1:])))


def refined(curve: Callable[[FloatArray], FloatArray], t: FloatArray, chord: float) -> FloatArray:
    """Return the parameters ``t`` (m,) and more, between which the chords of a curve are within ``chord`` of it."""
    for _ in range(_HALVINGS):
        points = curve(t)
        far = np.zeros(len(t) - 1)
        for share in (0.25, 0.5, 0.75):  # an inflection crosses its chord in the middle
            far = np.maximum(far, _off(curve((1.0 - share) * t[:-1] + share * t[1:]), points[:-1], points[1:]))
        if not (far > chord).any():
            break
        t = np.sort(np.concatenate([t, (0.5 * (t[:-1] + t[1:]))[far > chord]]))
    return t


def _off(points: FloatArray, start: FloatArray, end: FloatArray) -> FloatArray:
    """Return how far points (n, 2) are from the lines through two others each."""
    along, away = end - start, points - start
    length = np.hypot(*along.T)
    side = np.abs(along[:, 0] * away[:, 1] - along[:, 1] * away[:, 0])
    return np.divide(side, length, out=np.hypot(*away.T), where=length > 0.0)


def _balanced(points: FloatArray, middle: FloatArray) -> FloatArray:
    """Return the points (n, 2) of a curve, moved across it so that its polygon encloses what the curve does.

    Between a chord and its arc lie two thirds of the chord times the rise at the ``middle`` (n - 1, 2) (Archimedes);
    its ends move out for it, save those of the whole curve, which other curves meet.
    """
    if len(points) < 3:
        return points
    chord, rise = np.diff(points, axis=0), middle - points[:-1]
    missing = (chord[:, 1] * rise[:, 0] - chord[:, 0] * rise[:, 1]) * (2.0 / 3.0)
    across = np.zeros_like(points)
    across[1:-1] = (points[2:] - points[:-2]) @ np.array([[0.0, -1.0], [1.0, 0.0]])
    wide = (across**2).sum(axis=1)
    free = wide > 0.0
    moved = points
    for _ in range(_BALANCED):
        takers = free[:-1].astype(np.float64) + free[1:]
        share = np.divide(missing, takers, out=np.zeros_like(missing), where=takers > 0.0)
        taken = free * (np.append(share, 0.0) + np.append(0.0, share))
        moved = points + across * np.divide(2.0 * taken, wide, out=np.zeros_like(wide), where=free)[:, None]
        out = free & ((moved < 0.0) | (moved > 1.0)).any(axis=1)
        if not out.any():
            break
        free = free & ~out
    return np.clip(moved, 0.0, 1.0)


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
