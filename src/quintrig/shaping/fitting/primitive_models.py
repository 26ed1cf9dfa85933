"""Closed forms that were fitted as models: of their own kind in its frame, or exact NURBS where they lie."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from quintrig.support.arrays import FloatArray


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


def axis_of(tilt: FloatArray) -> FloatArray:
    """Return a unit vector from two angles (2,), so that no length is free."""
    a, b = tilt
    return np.array([np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)])


def in_own_frame(kind: str, sizes: FloatArray, scale: float, points: FloatArray) -> Primitive:
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
            return in_place(kind, x / ([scale] * 3 + [1, 1] + [scale]), scale, np.zeros(3), points)
        own = {"radius": radius, "height": top}
        return Primitive(kind, own, origin | up, {"kind": kind, **own})
    height, angle = float(sizes[0]) * scale, float(sizes[1] % np.pi)
    if height <= 0.0 or foot < -slack or np.tan(angle) <= 0.0:
        x = np.array([0.0, 0.0, height / scale, 0.0, 0.0, angle])
        return in_place(kind, x, scale, np.zeros(3), points)
    own = {"radius": height * float(np.tan(angle)), "height": height}
    apex = {"apex": [0.0, 0.0, height]}
    return Primitive(kind, own | {"half_angle_degrees": float(np.degrees(angle))}, apex | up, {"kind": kind, **own})


def flat_piece(points: FloatArray) -> Primitive:
    """Return the plane of least squares through points (n, 3), as far as they reach."""
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


def in_place(kind: str, x: FloatArray, scale: float, centre: FloatArray, points: FloatArray) -> Primitive:
    """Return a form where it lies, as the exact rational B-spline that reaches as far as the points."""
    spot = x[:3] * scale + centre
    if kind == "sphere":
        radius = abs(float(x[3])) * scale
        keys = _revolved(spot, np.eye(3), _arc(radius, -90.0, 90.0))
        return Primitive(kind, {"radius": radius}, {"centre": spot.tolist()}, keys)
    axis = axis_of(x[3:5])
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
