"""Umbilics at poles of the parameters, where a side of the domain is one point: told by what is around them."""

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.local import Local
from quintrig.interrogation.rotation import RIM, turned
from quintrig.interrogation.umbilic import Type, Umbilic
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray

_NEAR = 1e-3
_AROUND = 721
_MET = 1e-6  # of the scale: what is left of κ1 - κ2 at a pole that is an umbilic
_ONE_NORMAL = 0.1  # radians: normals this near to a pole differ by less, if it has one
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


def poles_of(surface: Surface) -> frozenset[tuple[int, float]]:
    """Return the sides (axis, end) that are one point, an umbilic as far as numbers tell."""
    if surface.trim:
        return frozenset()
    t = np.linspace(0.0, 1.0, _AROUND)
    found: set[tuple[int, float]] = set()
    for axis in (0, 1):
        for end in (0.0, 1.0):
            side = [np.full(_AROUND, end), t]
            points = surface(*(side if axis == 0 else side[::-1]))
            if np.linalg.norm(np.ptp(points, axis=0)) <= RIM * surface.size and _is_umbilic(surface, axis, end):
                found.add((axis, end))
    return frozenset(found)


def _is_umbilic(surface: Surface, axis: int, end: float) -> bool:
    """Return whether κ1 - κ2 goes to 0 at a pole from all sides, and the normal to one direction."""
    with np.errstate(divide="ignore", invalid="ignore"):
        first, second, third = (Local.at(surface, *_ring(axis, end, k * _NEAR)) for k in (1, 2, 3))
        spread = np.abs(3.0 * first.spread - 3.0 * second.spread + third.spread)
        scale = np.abs(first.mean) + first.spread + 1.0 / surface.size
        one = np.linalg.norm(first.up - first.up[0], axis=-1).max() < _ONE_NORMAL
        return bool(one and (spread <= _MET * scale).all())


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
