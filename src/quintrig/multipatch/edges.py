"""Which edges of patches coincide, point by point: seams of closed surfaces and joints between patches."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import rounding

_SAME = 1e-9
"""Edges this near, relative to the smaller patch's size and beside rounding, are one."""

Side = tuple[int, int]
"""A patch's number and its side: 0, 1 are u = 0, 1 and 2, 3 are v = 0, 1."""


@dataclass(frozen=True)
class Link:
    """Two sides that are one curve with one parameter, ``reversed`` where it runs the other way on the second.

    ``opposed`` where the normals of the two patches there look to opposite sides.
    """

    first: Side
    second: Side
    reversed: bool
    opposed: bool


def links(surfaces: Sequence[Surface]) -> list[Link]:
    """Return every pair of coinciding sides; collapsed sides have none."""
    t = np.linspace(0.0, 1.0, 13)
    curves = {(k, side): _along(surface, side, t) for k, surface in enumerate(surfaces) for side in range(4)}
    sizes = [surface.size for surface in surfaces]
    rounded = {key: rounding(curve) for key, curve in curves.items()}
    alive = [key for key, c in curves.items() if np.ptp(c, axis=0).max() > _SAME * sizes[key[0]] + rounded[key]]
    result: list[Link] = []
    for first, second in _near(alive, curves, _SAME * max(sizes) + max(rounded.values())):
        reach = _SAME * min(sizes[first[0]], sizes[second[0]]) + max(rounded[first], rounded[second])
        for backwards in (False, True):
            other = curves[second][::-1] if backwards else curves[second]
            if np.abs(curves[first] - other).max() <= reach:
                result.append(Link(first, second, backwards, _opposed(surfaces, first, second, backwards)))
                break
    return result


def _near(sides: Sequence[Side], curves: dict[Side, FloatArray], reach: float) -> list[tuple[Side, Side]]:
    """Return the pairs of sides whose middles are within ``reach``: in a large model few are."""
    middles: FloatArray = np.array([curves[side][len(curves[side]) // 2] for side in sides]).reshape(-1, 3)
    order = np.argsort(middles[:, 0], kind="stable")
    along = middles[order]
    ends = np.searchsorted(along[:, 0], along[:, 0] + reach, side="right")
    pairs: list[tuple[int, int]] = []
    for i, end in enumerate(ends.tolist()):
        close = np.flatnonzero((np.abs(along[i + 1 : end] - along[i]) <= reach).all(axis=1)) + i + 1
        pairs += [(min(order[i], order[j]), max(order[i], order[j])) for j in close.tolist()]
    return [(sides[i], sides[j]) for i, j in sorted(pairs)]


def place(side: int, t: FloatArray | float) -> tuple[FloatArray, FloatArray]:
    """Return u and v of parameters along a side."""
    along = np.asarray(t, dtype=np.float64)
    fixed = np.full(along.shape, float(side % 2))
    return (fixed, along) if side < 2 else (along, fixed)


def _along(surface: Surface, side: int, t: FloatArray) -> FloatArray:
    return surface(*place(side, t))


def _opposed(surfaces: Sequence[Surface], first: Side, second: Side, backwards: bool) -> bool:
    """Compare the triangles' sense of running along the common edge: neighbours must run opposite ways."""
    # Along u = 0 and v = 1 a counter-clockwise boundary runs against the parameter, along u = 1 and v = 0 with it.
    senses = [(-1.0 if side in (0, 3) else 1.0) * surfaces[k].sign for k, side in (first, second)]
    return senses[0] * senses[1] * (-1.0 if backwards else 1.0) > 0.0
