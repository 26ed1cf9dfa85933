"""Umbilics at poles of the parameters, where a side of the domain is one point: told by what is around them."""

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.local import Local
from quintrig.interrogation.rotation import turned
from quintrig.interrogation.umbilic import Type, Umbilic
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray

_NEAR = 1e-3
_AROUND = 721
_FLAT = 1e-7  # of 1 / size: a curvature this small is that of a planar point


def at_pole(patch: Patch, axis: int, end: float) -> Umbilic:
    """Return the umbilic at the side ``end`` of u (``axis`` 0) or v that is one point.

    The index is NaN where the side does not lead around it once.
    """
    surface = patch.surface
    curvature, flat = _curvature(surface, axis, end), _FLAT / surface.size
    index = _index(surface, axis, end)
    kind: Type = "planar" if abs(curvature) <= flat else "star" if index == -0.5 else "other"
    u, v = (end, 0.0) if axis == 0 else (0.0, end)
    return Umbilic(patch.name, u, v, surface(u, v), 0.0 if kind == "planar" else curvature, index, kind)


def _ring(axis: int, end: float, near: float) -> FloatArray:
    around = np.linspace(0.0, 1.0, _AROUND)
    beside = np.full(_AROUND, near if end == 0.0 else 1.0 - near)
    return np.stack([beside, around] if axis == 0 else [around, beside])


def _curvature(surface: Surface, axis: int, end: float) -> float:
    """Return the curvature at the pole, from means around it at one distance and at twice that."""
    with np.errstate(divide="ignore", invalid="ignore"):
        first, second = (float(np.mean(Local.at(surface, *_ring(axis, end, k * _NEAR)).mean)) for k in (1, 2))
    return (4.0 * first - second) / 3.0


def _index(surface: Surface, axis: int, end: float) -> float:
    """Return the index: e1 turns once on the way around, and the principal directions turn against it."""
    ring = _ring(axis, end, _NEAR).T
    against = turned(surface, ring)
    if np.abs(surface(*ring[0]) - surface(*ring[-1])).max() > 1e-9 * surface.size:
        return 1.0 if abs(against) < 1e-6 else float("nan")
    return 1.0 + round(2.0 * (against if (axis == 0) == (end == 0.0) else -against)) / 2.0
