"""Geodesics: from a point in a direction, and between two points, across patches."""

import math

import numpy as np

from quintrig.interrogation.follow import Curve
from quintrig.interrogation.local import Local
from quintrig.interrogation.polyline import Path
from quintrig.interrogation.trace import RELATIVE, Seed, Tracer
from quintrig.support.arrays import FloatArray

_FAN = 24  # directions tried first
_TRIES = 4  # of which the nearest are refined
_STEPS = 20
_ROUGH = 1e-6  # relative error of the geodesics tried first
_TURN = 1e-4  # degrees, by which it is told where a geodesic moves when it is turned
_MET = 1e-9  # of the size: how near the second point is met
_REACH = 1.5, 4.0  # of the size: how long geodesics between two points may be, tried in turn


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
    aim = tracer.surfaces[end[0]](*end[1])
    for reach in _REACH if longest is None else (longest / tracer.size,):
        found = _shots(tracer, start, aim, _fan(tracer, start, aim, reach * tracer.size))
        if found is not None:
            return found
    return None


def _fan(tracer: Tracer, start: tuple[int, FloatArray], aim: FloatArray, reach: float) -> list[tuple[float, float]]:
    """Return (angle in degrees, length) of the geodesics from a point that pass nearest to another."""
    patch, uv = start
    frame = Local.at(tracer.surfaces[patch], *uv, order=1)
    x, y = _in_frame(frame, aim - frame.point)
    straight = math.degrees(math.atan2(y, x))
    angles = [straight + k * (360.0 / _FAN) for k in range(_FAN)]
    tracer.relative = _ROUGH
    trails = tracer.trace([Seed(patch, uv, tangent(tracer, patch, uv, angle)) for angle in angles], reach)
    tracer.relative = RELATIVE
    tries: list[tuple[float, float, float]] = []
    for angle, trail in zip(angles, trails, strict=True):
        points = [path.on(tracer.surfaces[path.patch])[0] for path in trail.paths]
        if not points:
            continue
        cloud = np.concatenate(points)
        s = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(cloud, axis=0), axis=1))])
        apart = np.linalg.norm(cloud - aim, axis=1)
        nearest = int(apart.argmin())
        if s[nearest] > 0.0:  # by the angle under which the miss is seen, so that far points have their fair chance
            tries.append((float(apart[nearest] / s[nearest]), float(angle), float(s[nearest])))
    return [(angle, s) for _, angle, s in sorted(tries)[:_TRIES]]


def _in_frame(frame: Local, vector: FloatArray) -> tuple[float, float]:
    e1 = frame.su / np.linalg.norm(frame.su)
    return float(vector @ e1), float(vector @ np.cross(frame.up, e1))


def _shots(
    tracer: Tracer, start: tuple[int, FloatArray], aim: FloatArray, tries: list[tuple[float, float]]
) -> Curve | None:
    """Return the shortest of the geodesics that Newton's iteration makes of (angle in degrees, length)."""
    patch, uv = start
    met: list[tuple[float, Curve]] = []
    for _ in range(_STEPS):
        ends = [(angle + turn, s) for angle, s in tries for turn in (0.0, _TURN)]
        seeds = [Seed(patch, uv, tangent(tracer, patch, uv, angle)) for angle, _ in ends]
        trails = tracer.trace(seeds, [s for _, s in ends])
        following: list[tuple[float, float]] = []
        for (angle, s), one, other in zip(tries, trails[::2], trails[1::2], strict=True):
            if not one.paths or not other.paths:
                continue
            point, heading = _end(tracer, one.paths[-1])
            beside, _ = _end(tracer, other.paths[-1])
            gap = aim - point
            if np.linalg.norm(gap) <= _MET * tracer.size:
                met.append((s, Curve(tuple(one.paths), tuple(one.modes), False, "reaches the second point")))
                continue
            side = (beside - point) / _TURN
            side -= (side @ heading) * heading
            square = float(side @ side)
            if square > 0.0:
                turned = float(np.clip(float(gap @ side) / square, -10.0, 10.0))
                longer = s + float(np.clip(float(gap @ heading), -0.3 * s, 0.3 * s))
                if not any(abs(angle + turned - a) < 1e-3 and abs(longer - b) < 1e-3 * b for a, b in following):
                    following.append((angle + turned, longer))
        # Whoever is far longer than one that has arrived need not arrive.
        best = min((s for s, _ in met), default=np.inf)
        tries = [(angle, s) for angle, s in following if s < 1.5 * best]
        if not tries:
            break
    return min(met, key=lambda one: one[0])[1] if met else None


def _end(tracer: Tracer, path: Path) -> tuple[FloatArray, FloatArray]:
    """Return the last point of a path and the unit direction in which it arrives."""
    points = path.on(tracer.surfaces[path.patch])[0]
    step = points[-1] - points[-2]
    return points[-1], step / np.linalg.norm(step)
