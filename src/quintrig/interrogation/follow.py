"""Lines of a flow through given points, to both sides."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from quintrig.interrogation.polyline import Path
from quintrig.interrogation.trace import Seed, Tracer, Trail
from quintrig.support.arrays import FloatArray

Place = tuple[int, FloatArray, int]
"""Patch, parameters (2,) and family."""


@dataclass(frozen=True, eq=False)
class Curve:
    """A traced line: its paths in order, the family in each, and why it ends."""

    paths: tuple[Path, ...]
    modes: tuple[int, ...]
    closed: bool
    ended: str


def both_ways(tracer: Tracer, places: Sequence[Place], length: float) -> list[Curve]:
    """Return the lines through (patch, parameters, family), ``length`` long to each side (length¹)."""
    ahead = tracer.trace([Seed(patch, uv, mode=mode) for patch, uv, mode in places], length)
    again = [k for k, trail in enumerate(ahead) if not trail.closed]
    turned = [Seed(*places[k][:2], mode=places[k][2], sense=-1.0) for k in again]
    back = dict(zip(again, tracer.trace(turned, length), strict=True))
    return [_joined(trail, back.get(k)) for k, trail in enumerate(ahead)]


def _joined(ahead: Trail, back: Trail | None) -> Curve:
    first = ahead.paths
    if back is None or not back.paths:
        closed = ahead.closed and len(first) == 1
        paths = tuple(replace(path, closed=closed) for path in first)
        return Curve(paths, tuple(ahead.modes), ahead.closed, ahead.ended)
    behind = [path.backwards for path in reversed(back.paths)]
    modes = [*reversed(back.modes)]
    if not first:
        return Curve(tuple(behind), tuple(modes), False, back.ended)
    # Both began at one point of one patch: that is one path.
    ended = ahead.ended if ahead.ended == back.ended else f"{back.ended}; {ahead.ended}"
    paths = (*behind[:-1], behind[-1].then(first[0]), *first[1:])
    return Curve(paths, (*modes[:-1], *ahead.modes), False, ended)
