"""Geodesics: from a point in a direction, and between two points, across patches."""

import numpy as np

from quintrig.interrogation.flows import Geodesic
from quintrig.interrogation.follow import Curve
from quintrig.interrogation.local import Local
from quintrig.interrogation.trace import Seed, Tracer
from quintrig.support.arrays import FloatArray

_FAN = 36  # directions tried first
_TRIES = 4  # of which the nearest are refined
_STEPS = 30
_MET = 1e-9  # of the size: how near the second point is met
_REACH = 3.0  # of the size: how long geodesics between two points may be


def tangent(tracer: Tracer, patch: int, uv: FloatArray, degrees: float) -> FloatArray:
    """Return the unit tangent (3,) at an angle from S_u towards S_v."""
    local = Local.at(tracer.surfaces[patch], *uv, order=1)
    return local.lifted(local.along(np.asarray(np.radians(degrees))))


def from_point(tracer: Tracer, patch: int, uv: FloatArray, towards: FloatArray, length: float) -> Curve:
    """Return the geodesic that leaves a point along the tangent part of a vector (3,)."""
    trail = tracer.trace([Seed(patch, uv, towards)], length)[0]
    return Curve(tuple(trail.paths), tuple(trail.modes), trail.closed, trail.ended)


def between(
    tracer: Tracer, start: tuple[int, FloatArray], end: tuple[int, FloatArray], longest: float | None
) -> Curve | None:
    """Return the shortest geodesic found between two points (patch, parameters); None where none is met.

    A fan of geodesics leaves the first point; those that pass nearest to the second are turned onto it by Newton's
    iteration on angle and length.
    """
    patch, uv = start
    aim = tracer.surfaces[end[0]](*end[1])
    size = tracer.size
    reach = min(longest or np.inf, _REACH * size)
    frame = Local.at(tracer.surfaces[patch], *uv, order=1)
    straight = float(np.degrees(np.arctan2(*_in_frame(frame, aim - frame.point)[::-1])))
    angles = straight + np.arange(_FAN) * (360.0 / _FAN)
    trails = tracer.trace([Seed(patch, uv, tangent(tracer, patch, uv, angle)) for angle in angles], reach)
    tries: list[tuple[float, float, float]] = []
    for angle, trail in zip(angles.tolist(), trails, strict=True):
        points = [tracer.surfaces[path.patch](*path.uv.T) for path in trail.paths]
        if not points:
            continue
        cloud = np.concatenate(points)
        s = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(cloud, axis=0), axis=1))])
        apart = np.linalg.norm(cloud - aim, axis=1)
        # By the angle under which the miss is seen, so that far points have their fair chance.
        nearest = int(apart.argmin())
        if s[nearest] > 0.0:
            tries.append((float(apart[nearest] / s[nearest]), float(angle), float(s[nearest])))
    best: tuple[float, Curve] | None = None
    for _, angle, s in sorted(tries)[:_TRIES]:
        found = _shot(tracer, start, aim, angle, s)
        if found is not None and (best is None or found[0] < best[0]):
            best = found
    return None if best is None else best[1]


def _in_frame(frame: Local, vector: FloatArray) -> tuple[float, float]:
    e1 = frame.su / np.linalg.norm(frame.su)
    return float(vector @ e1), float(vector @ np.cross(frame.up, e1))


def _shot(
    tracer: Tracer, start: tuple[int, FloatArray], aim: FloatArray, angle: float, s: float
) -> tuple[float, Curve] | None:
    patch, uv = start
    size = tracer.size
    for _ in range(_STEPS):
        turn = 1e-4
        seeds = [Seed(patch, uv, tangent(tracer, patch, uv, a)) for a in (angle, angle + turn)]
        one, other = tracer.trace(seeds, [s, s])
        if not one.paths or not other.paths:
            return None
        point, heading = _end(tracer, one.paths[-1].patch, one.paths[-1].uv)
        beside, _ = _end(tracer, other.paths[-1].patch, other.paths[-1].uv)
        gap = aim - point
        if np.linalg.norm(gap) <= _MET * size:
            return s, Curve(tuple(one.paths), tuple(one.modes), False, "reaches the second point")
        along = float(gap @ heading)
        side = (beside - point) / turn
        side -= (side @ heading) * heading
        square = float(side @ side)
        if not square > 0.0:
            return None
        across = float(gap @ side) / square
        angle += float(np.clip(across, -10.0, 10.0))
        s = max(s + float(np.clip(along, -0.3 * s, 0.3 * s)), 1e-6 * size)
    return None


def _end(tracer: Tracer, patch: int, uv: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the last point of a path and the unit direction in which it arrives."""
    points = tracer.surfaces[patch](*uv[-2:].T)
    step = points[1] - points[0]
    return points[1], step / np.linalg.norm(step)
