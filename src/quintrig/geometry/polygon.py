"""Polygons for plane curves: as fine as asked, and enclosing the same area."""

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from quintrig.support.arrays import BoolArray, FloatArray

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
    points = curve(t)
    inner = np.append(False, np.ones(len(t) - 2, dtype=np.bool_))
    return balanced(points, curve(0.5 * (t[:-1] + t[1:])), np.append(inner, False), (0.0, 1.0))


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


def balanced(
    points: FloatArray, middle: FloatArray, free: BoolArray, bounds: tuple[float, float] = (-np.inf, np.inf)
) -> FloatArray:
    """Return the points (n, 2) of a curve, moved across it so that its polygon encloses what the curve does.

    Between a chord and its arc lie two thirds of the chord times the rise at the ``middle`` (n - 1, 2) (Archimedes);
    those of its ends that are ``free`` (n,) move out for it, within the ``bounds`` of both coordinates.
    """
    chord, rise = np.diff(points, axis=0), middle - points[:-1]
    missing = (chord[:, 1] * rise[:, 0] - chord[:, 0] * rise[:, 1]) * (2.0 / 3.0)
    across = np.zeros_like(points)
    across[1:-1] = (points[2:] - points[:-2]) @ np.array([[0.0, -1.0], [1.0, 0.0]])
    wide = (across**2).sum(axis=1)
    free = free & (wide > 0.0)
    moved = points
    for _ in range(_BALANCED):
        takers = free[:-1].astype(np.float64) + free[1:]
        share = np.divide(missing, takers, out=np.zeros_like(missing), where=takers > 0.0)
        taken = free * (np.append(share, 0.0) + np.append(0.0, share))
        moved = points + across * np.divide(2.0 * taken, wide, out=np.zeros_like(wide), where=free)[:, None]
        out = free & ((moved < bounds[0]) | (moved > bounds[1])).any(axis=1)
        if not out.any():
            break
        free = free & ~out
    return np.clip(moved, *bounds)
