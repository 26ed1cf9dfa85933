"""Which edges of patches coincide, point by point: seams of closed surfaces and joints between patches."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.arrays import FloatArray
from quintrig.surface import Surface

_SAME = 1e-9
"""Edges this near, relative to the smaller patch's size, are one."""

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
    alive = [key for key, curve in curves.items() if np.ptp(curve, axis=0).max() > _SAME * sizes[key[0]]]
    result: list[Link] = []
    for i, first in enumerate(alive):
        for second in alive[i + 1 :]:
            reach = _SAME * min(sizes[first[0]], sizes[second[0]])
            ends = curves[first][[0, -1]], curves[second][[0, -1]]
            for backwards in (False, True):
                if np.abs(ends[0] - (ends[1][::-1] if backwards else ends[1])).max() > reach:
                    continue
                other = curves[second][::-1] if backwards else curves[second]
                if np.abs(curves[first] - other).max() <= reach:
                    result.append(Link(first, second, backwards, _opposed(surfaces, first, second, backwards)))
                    break
    return result


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
