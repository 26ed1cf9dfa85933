"""Planes, spheres, cylinders, cones and tori through points, by orthogonal distances (Ahn, Rauh and Warnecke 2001)."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from quintrig.support.arrays import FloatArray
from quintrig.support.scipy_inside import optimize_, shortest, tree_of

PRIMITIVES = ("plane", "sphere", "cylinder", "cone", "torus")
"""Kinds with few parameters that are fitted wherever they lie."""

_MOST = 20_000  # points of a fit of so few parameters
_AS_GOOD = 1.02  # times the rms of the free fit: then the form may lie in the frame of the model file's kind


@dataclass(frozen=True, eq=False)
class Primitive:
    """A form that was found: its sizes by name, its place, and the keys of a model of it."""

    kind: str
    sizes: dict[str, float]
    place: dict[str, list[float]]
    keys: dict[str, Any]

    def to_dict(self) -> dict[str, Any]:
        """Return sizes and place for JSON."""
        return {"kind": self.kind, **self.sizes, **self.place}


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
        return _plane(points)
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
        return _framed(kind, own, scale, points)
    return _placed(kind, best, scale, centre, points)


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
    axis = _axis(found[3:5], 0)
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


def _axis(tilt: FloatArray, pole: int) -> FloatArray:
    """Return a unit vector from two angles, so that no length is free."""
    a, b = tilt
    return np.array([np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)]) if pole == 0 else np.zeros(3)


def _tilt(axis: FloatArray) -> FloatArray:
    x, y, z = axis / np.linalg.norm(axis)
    return np.array([np.arctan2(np.hypot(x, y), z), np.arctan2(y, x)])


def _radial(x: FloatArray, points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the distances from an axis through x[:3] along x[3:5], and the heights along it."""
    axis = _axis(x[3:5], 0)
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
        axis = _axis(start[3:5], 0)
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


def _framed(kind: str, sizes: FloatArray, scale: float, points: FloatArray) -> Primitive:
    """Return a form in the frame of the model kind, whose sizes are those of its keys."""
    top = float(points[:, 2].max())
    foot = float(points[:, 2].min())
    origin, up = {"centre": [0.0, 0.0, 0.0]}, {"axis": [0.0, 0.0, 1.0]}
    if kind == "sphere":
        own = {"radius": abs(float(sizes[0])) * scale}
        return Primitive(kind, own, origin, {"kind": kind, **own})
    if kind == "torus":
        own = {"major": abs(float(sizes[0])) * scale, "minor": abs(float(sizes[1])) * scale}
        return Primitive(kind, own, origin | up, {"kind": kind, **own})
    slack = 0.02 * scale
    if kind == "cylinder":
        radius = abs(float(sizes[0])) * scale
        x = np.array([0.0, 0.0, 0.0, 0.0, 0.0, radius])
        if foot < -slack or top <= 0.0:
            return _placed(kind, x / ([scale] * 3 + [1, 1] + [scale]), scale, np.zeros(3), points)
        own = {"radius": radius, "height": top}
        return Primitive(kind, own, origin | up, {"kind": kind, **own})
    height, angle = float(sizes[0]) * scale, float(sizes[1] % np.pi)
    if height <= 0.0 or foot < -slack or np.tan(angle) <= 0.0:
        x = np.array([0.0, 0.0, height / scale, 0.0, 0.0, angle])
        return _placed(kind, x, scale, np.zeros(3), points)
    own = {"radius": height * float(np.tan(angle)), "height": height}
    apex = {"apex": [0.0, 0.0, height]}
    return Primitive(kind, own | {"half_angle_degrees": float(np.degrees(angle))}, apex | up, {"kind": kind, **own})


def _plane(points: FloatArray) -> Primitive:
    centre = points.mean(axis=0)
    centred = points - centre
    _, axes = np.linalg.eigh(centred.T @ centred)
    normal, e1, e2 = axes[:, 0], axes[:, 2], axes[:, 1]
    a, b = centred @ e1, centred @ e2
    corners = [
        [(centre + x * e1 + y * e2).tolist() for y in (float(b.min()), float(b.max()))]
        for x in (float(a.min()), float(a.max()))
    ]
    keys = {"kind": "tensor", "basis": "bernstein", "points": corners}
    return Primitive("plane", {}, {"normal": normal.tolist(), "point": centre.tolist()}, keys)


def _placed(kind: str, x: FloatArray, scale: float, centre: FloatArray, points: FloatArray) -> Primitive:
    """Return a form where it lies, as the exact rational B-spline that reaches as far as the points."""
    spot = x[:3] * scale + centre
    if kind == "sphere":
        radius = abs(float(x[3])) * scale
        keys = _revolved(spot, np.eye(3), _arc(radius, -90.0, 90.0))
        return Primitive(kind, {"radius": radius}, {"centre": spot.tolist()}, keys)
    axis = _axis(x[3:5], 0)
    angle = 0.0
    if kind == "cone":  # the axis towards the apex, and an angle below 90 degrees
        angle = float((x[5] + 0.5 * np.pi) % np.pi - 0.5 * np.pi)
        axis, angle = (axis, angle) if angle >= 0.0 else (-axis, -angle)
    helper = np.eye(3)[int(np.argmin(np.abs(axis)))]
    e1 = np.cross(helper, axis)
    e1 /= np.linalg.norm(e1)
    frame = np.stack([e1, np.cross(axis, e1), axis])
    if kind == "cylinder":  # any point of its axis would do
        spot = spot + float((points - spot).mean(axis=0) @ axis) * axis
    along = (points - spot) @ axis
    low, high = float(along.min()), float(along.max())
    place = {"axis": axis.tolist()}
    if kind == "cylinder":
        radius = abs(float(x[5])) * scale
        own = {"radius": radius, "height": high - low}
        line = [(radius, low, 1.0), (radius, high, 1.0)]
        return Primitive(kind, own, place | {"point": spot.tolist()}, _revolved(spot, frame, line))
    if kind == "cone":
        slope = float(np.tan(angle))
        line = [(max(-low * slope, 0.0), low, 1.0), (max(-high * slope, 0.0), high, 1.0)]
        own = {"half_angle_degrees": float(np.degrees(angle)), "radius": line[0][0], "height": high - low}
        return Primitive(kind, own, place | {"apex": spot.tolist()}, _revolved(spot, frame, line))
    major, minor = abs(float(x[5])) * scale, abs(float(x[6])) * scale
    ring = [(major + r, z, w) for r, z, w in _arc(minor, -180.0, 180.0)]
    own = {"major": major, "minor": minor}
    return Primitive(kind, own, place | {"centre": spot.tolist()}, _revolved(spot, frame, ring))


Profile = list[tuple[float, float, float]]


def _arc(radius: float, start: float, end: float) -> Profile:
    """Return a circle's control points (r, z, weight) in quarters, from an angle to another, in degrees."""
    quarters = round((end - start) / 90.0)
    result: Profile = []
    for k in range(2 * quarters + 1):
        angle = np.radians(start + 45.0 * k)
        out = np.sqrt(2.0) if k % 2 else 1.0
        result.append((float(radius * out * np.cos(angle)), float(radius * out * np.sin(angle)), float(1.0 / out)))
    return result


def _quarters(count: int) -> list[float]:
    """Return the knots of quadratic arcs that meet in double knots, for so many control points."""
    pieces = (count - 1) // 2
    inner = [k / pieces for k in range(1, pieces) for _ in range(2)]
    return [0.0] * 3 + inner + [1.0] * 3


def _revolved(spot: FloatArray, frame: FloatArray, profile: Profile) -> dict[str, Any]:
    """Return the keys of a profile turned once around the axis, the last row of a frame, through a point."""
    turn = _arc(1.0, 0.0, 360.0)
    # u runs along the profile, v around: the normal then points inwards along S_u x S_v, and is flipped.
    points = [[(spot + frame.T @ [r * c, r * s, z]).tolist() for c, s, _ in turn] for r, z, _ in profile]
    weights = [[w * around for _, _, around in turn] for _, _, w in profile]
    line = len(profile) == 2
    knots = [[0.0, 0.0, 1.0, 1.0] if line else _quarters(len(profile)), _quarters(9)]
    return {
        "kind": "nurbs",
        "degrees": [1 if line else 2, 2],
        "knots": knots,
        "points": points,
        "weights": weights,
        "flip": True,
    }
