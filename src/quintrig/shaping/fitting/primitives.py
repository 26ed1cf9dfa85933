"""Planes, spheres, cylinders, cones and tori through points, by orthogonal distances (Ahn, Rauh and Warnecke 2001)."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from quintrig.shaping.fitting.primitive_models import Primitive, axis_of, flat_piece, in_own_frame, in_place
from quintrig.support.arrays import FloatArray
from quintrig.support.scipy_inside import optimize_, shortest, tree_of

PRIMITIVES = ("plane", "sphere", "cylinder", "cone", "torus")
"""Kinds with few parameters that are fitted wherever they lie."""

_MOST = 20_000  # points of a fit of so few parameters
_AS_GOOD = 1.02  # times the rms of the free fit: then the form may lie in the frame of the model file's kind


def fit_primitive(kind: str, points: FloatArray, robust: bool = True) -> Primitive:
    """Return the form of this kind that is nearest to points (n, 3), length¹; ValueError for too few points.

    Where one in the frame of the model kind (around the z axis, from z = 0 or the origin) is as good, it is that one.
    """
    least = {"plane": 3, "sphere": 4, "cylinder": 6, "cone": 7, "torus": 8}[kind]
    if len(points) < least:
        raise ValueError(f"points: expected at least {least} for a {kind}, found {len(points)}")
    few = points if len(points) <= _MOST else points[np.random.default_rng(0).permutation(len(points))[:_MOST]]
    centre = few.mean(axis=0)
    scale = float(np.linalg.norm(np.ptp(few, axis=0))) or 1.0
    local = (few - centre) / scale
    if kind == "plane":
        return flat_piece(points)
    gap = _GAPS[kind]
    best, least_rms = np.zeros(0), np.inf
    for start in _STARTS[kind](local):
        found, rms = _least(gap, local, start, robust)
        if rms < least_rms:
            best, least_rms = found, rms
    if not np.isfinite(least_rms):
        raise ValueError(f"points: expected points near a {kind}, found none that comes near them")
    own = _in_frame(kind, few / scale, centre / scale, best, least_rms, robust)
    if own is not None:
        return in_own_frame(kind, own, scale, points)
    return in_place(kind, best, scale, centre, points)


def rough_cylinder(points: FloatArray) -> tuple[FloatArray, FloatArray, float] | None:
    """Return centre, axis and radius of a cylinder near points, from their normals; None where there is none."""
    few = points if len(points) <= 1500 else points[np.linspace(0, len(points) - 1, 1500).astype(int)]
    if len(few) < 20:
        return None
    starts = list(_cylinders(few))[:1]
    if not starts:
        return None
    found, rms = _least(_cylinder_gap, few, starts[0], True)
    radius = abs(float(found[5]))
    if not rms < 0.2 or radius > 5.0:
        return None
    axis = axis_of(found[3:5])
    return found[:3], axis, radius


def normals_of(points: FloatArray, at: FloatArray, neighbours: int = 14) -> FloatArray:
    """Return unit normals (n, 3) at places, to either side, of planes through their neighbours."""
    tree: Any = tree_of(points)
    _, near = tree.query(at, k=min(neighbours, len(points)))
    local = points[np.asarray(near)]
    local = local - local.mean(axis=1, keepdims=True)
    _, vectors = np.linalg.eigh(np.einsum("nki,nkj->nij", local, local))
    return np.asarray(vectors[:, :, 0])


Gap = Callable[[FloatArray, FloatArray], FloatArray]


def _least(gap: Gap, points: FloatArray, start: FloatArray, robust: bool) -> tuple[FloatArray, float]:
    """Return parameters of least squares, and the rms; outliers are left out the second time."""
    found, kept = start, points
    rms = np.inf
    for _ in range(3 if robust else 1):
        # A form whose parameters run away is a bad start, not a fault.
        with np.errstate(all="ignore"):
            try:
                found = np.asarray(
                    optimize_.least_squares(
                        gap, found, args=(kept,), method="trf", x_scale="jac", xtol=1e-14, ftol=1e-14
                    ).x
                )
            except ValueError:
                return start, np.inf
        off = np.abs(gap(found, points))
        inside = off <= 6.0 * max(1.4826 * float(np.median(off)), 1e-12)
        kept = points[inside] if inside.mean() > 0.7 else points
        rms = float(np.sqrt(np.mean(gap(found, kept) ** 2)))
        if len(kept) == len(points):
            break
    return found, rms


def _tilt(axis: FloatArray) -> FloatArray:
    x, y, z = axis / np.linalg.norm(axis)
    return np.array([np.arctan2(np.hypot(x, y), z), np.arctan2(y, x)])


def _radial(x: FloatArray, points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the distances from an axis through x[:3] along x[3:5], and the heights along it."""
    axis = axis_of(x[3:5])
    local = points - x[:3]
    along = local @ axis
    return np.linalg.norm(local - along[:, None] * axis, axis=1), along


def _sphere_gap(x: FloatArray, points: FloatArray) -> FloatArray:
    return np.linalg.norm(points - x[:3], axis=1) - x[3]


def _cylinder_gap(x: FloatArray, points: FloatArray) -> FloatArray:
    return _radial(x, points)[0] - x[5]


def _cone_gap(x: FloatArray, points: FloatArray) -> FloatArray:
    """Distance from a cone with its apex in x[:3], opening along -axis with half angle x[5]."""
    away, along = _radial(x, points)
    return away * np.cos(x[5]) + along * np.sin(x[5])


def _torus_gap(x: FloatArray, points: FloatArray) -> FloatArray:
    away, along = _radial(x, points)
    return np.hypot(away - x[5], along) - x[6]


def _spheres(points: FloatArray) -> Iterator[FloatArray]:
    rows = np.column_stack([2.0 * points, np.ones(len(points))])
    found = shortest(rows, (points**2).sum(axis=1))
    yield np.append(found[:3], np.sqrt(max(float(found[3] + found[:3] @ found[:3]), 1e-12)))


def _sampled(points: FloatArray) -> tuple[FloatArray, FloatArray]:
    at = points[np.linspace(0, len(points) - 1, min(len(points), 2000)).astype(int)]
    return at, normals_of(points, at)


def _axes(points: FloatArray, normals: FloatArray) -> Iterator[FloatArray]:
    """Yield directions that may be an axis: at right angles to all normals, of equal angle with them, principal."""
    yield np.linalg.eigh(normals.T @ normals)[1][:, 0]
    yield from np.linalg.eigh(normals.T @ normals)[1].T[1:]
    centred = points - points.mean(axis=0)
    yield from np.linalg.eigh(centred.T @ centred)[1].T
    yield np.array([0.0, 0.0, 1.0])


def _cylinders(points: FloatArray) -> Iterator[FloatArray]:
    at, normals = _sampled(points)
    for axis in _axes(at, normals):
        helper = np.eye(3)[int(np.argmin(np.abs(axis)))]
        e1 = np.cross(axis, helper)
        e1 /= np.linalg.norm(e1)
        e2 = np.cross(axis, e1)
        plane = np.stack([at @ e1, at @ e2], axis=1)
        rows = np.column_stack([2.0 * plane, np.ones(len(plane))])
        found = shortest(rows, (plane**2).sum(axis=1))
        radius = np.sqrt(max(float(found[2] + found[:2] @ found[:2]), 1e-12))
        yield np.concatenate([found[0] * e1 + found[1] * e2, _tilt(axis), [radius]])


def _cones(points: FloatArray) -> Iterator[FloatArray]:
    at, normals = _sampled(points)
    # Every tangent plane runs through the apex.
    apex = shortest(normals, np.einsum("ij,ij->i", normals, at))
    ways = at - apex
    ways /= np.maximum(np.linalg.norm(ways, axis=1), 1e-12)[:, None]
    mean = ways.mean(axis=0)
    tried = [-mean / max(float(np.linalg.norm(mean)), 1e-12), *_axes(at, normals)]
    for axis in tried:
        for side in (1.0, -1.0):
            slope = np.abs(ways @ axis)
            angle = float(np.arccos(np.clip(np.median(slope), 0.05, 0.999)))
            yield np.concatenate([apex, _tilt(side * axis), [angle]])
    for start in _cylinders(points):  # a slender one
        axis = axis_of(start[3:5])
        for side in (1.0, -1.0):
            yield np.concatenate([start[:3] + 3.0 * side * axis, _tilt(side * axis), [np.arctan(start[5] / 3.0)]])


def _tori(points: FloatArray) -> Iterator[FloatArray]:
    at, normals = _sampled(points)
    for axis in _axes(at, normals):
        for centre in (at.mean(axis=0), 0.5 * (at.min(axis=0) + at.max(axis=0))):
            away, along = _radial(np.concatenate([centre, _tilt(axis)]), at)
            major = 0.5 * float(away.min() + away.max())
            minor = max(0.5 * float(np.ptp(along)), 1e-3)
            yield np.concatenate([centre, _tilt(axis), [major, min(minor, major)]])


_GAPS: dict[str, Gap] = {
    "sphere": _sphere_gap,
    "cylinder": _cylinder_gap,
    "cone": _cone_gap,
    "torus": _torus_gap,
}
_STARTS: dict[str, Callable[[FloatArray], Iterator[FloatArray]]] = {
    "sphere": _spheres,
    "cylinder": _cylinders,
    "cone": _cones,
    "torus": _tori,
}


def _in_frame(
    kind: str, points: FloatArray, centre: FloatArray, free: FloatArray, rms: float, robust: bool
) -> FloatArray | None:
    """Return the sizes of the form in the frame of the model kind, where it is as good as the free one."""
    x = free.copy()
    x[:3] += centre
    tail = x[3:] if kind == "sphere" else x[[2, 5]] if kind == "cone" else x[5:]

    def gap(sizes: FloatArray, at: FloatArray) -> FloatArray:
        if kind == "sphere":
            return _sphere_gap(np.concatenate([np.zeros(3), sizes]), at)
        apex = np.array([0.0, 0.0, sizes[0] if kind == "cone" else 0.0])
        last = sizes[1:] if kind == "cone" else sizes
        return _GAPS[kind](np.concatenate([apex, np.zeros(2), last]), at)

    sizes, own = _least(gap, points, tail, robust)
    return sizes if own <= _AS_GOOD * rms + 1e-9 else None
