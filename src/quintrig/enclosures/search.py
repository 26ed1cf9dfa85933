"""Subdivision: whether a quantity is in a range all over a chart, and between which values it lies."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from quintrig.enclosures.boxes import Boxes, Enclose
from quintrig.support.arrays import BoolArray, FloatArray

NARROWEST = 2.0**-30
"""A box this narrow is not halved again."""

_DEEP = 2.0**-7  # so narrow a box open says that the quantity comes near to the bound
_AT_ONCE = 1 << 20  # coefficients worked on together
_INWARD = tuple(2.0**-k for k in (4, 8, 12, 16, 20, 24, 28, 32, 36, 40))

Outside = Callable[[FloatArray, FloatArray], BoolArray]
"""Which boxes of a chart, low and high (boxes, 2), lie outside what counts, as outside the loops of a trimmed face."""


def nothing(low: FloatArray, high: FloatArray) -> BoolArray:
    """Return that no box lies outside."""
    return np.zeros(len(low), dtype=np.bool_)


@dataclass(frozen=True)
class Range:
    """The values from ``low`` to ``high``, ends that are ``open`` left out."""

    low: float = -np.inf
    high: float = np.inf
    open: tuple[bool, bool] = (False, False)

    def holds(self, low: FloatArray, high: FloatArray) -> BoolArray:
        """Return whether all between the bounds are in the range."""
        above = low > self.low if self.open[0] else low >= self.low
        return above & (high < self.high if self.open[1] else high <= self.high)

    def misses(self, low: FloatArray, high: FloatArray) -> BoolArray:
        """Return whether none between the bounds is in the range."""
        below = high <= self.low if self.open[0] else high < self.low
        return below | (low >= self.high if self.open[1] else low > self.high)

    def distance(self, low: FloatArray, high: FloatArray) -> FloatArray:
        """Return by how much the bounds leave the range at most."""
        with np.errstate(invalid="ignore"):
            return np.nan_to_num(np.maximum(self.low - low, high - self.high), nan=np.inf)


@dataclass
class Search:
    """What came out: ``boxes`` looked at, a ``place`` (x, y) where the claim fails, regions (k, 4) left ``open``.

    ``touching`` where some are open because they are narrow or nothing but rounding is left, not for want of boxes.
    """

    boxes: int = 0
    place: tuple[float, float] | None = None
    low: float = np.nan
    high: float = np.nan
    touching: bool = False
    open: list[tuple[float, float, float, float]] = field(default_factory=list[tuple[float, float, float, float]])


def settle(
    whole: Boxes,
    enclose: Enclose,
    wanted: Range,
    most: int,
    outside: Outside = nothing,
    edges: tuple[int, int, int, int] = (0, 0, 0, 0),
) -> Search:
    """Halve boxes until a quantity is seen to be in the range in all, or out of it at a corner, or ``most`` are seen.

    Where ``edges`` says that a factor was divided out, a witness is looked for beside the edge, not on it.
    """
    found, waiting = Search(), whole
    if any(edges) and _beside_corners(whole, enclose, wanted, outside, edges, found):
        return found
    while len(waiting):
        count = max(1, _AT_ONCE // whole.middle[0].size)
        now, waiting = waiting.take(slice(0, count)), waiting.take(slice(count, None))
        now = now.take(~outside(now.low, now.high))
        if not len(now):
            continue
        found.boxes += len(now)
        low, high = enclose(*now.bounds())
        undecided = ~wanted.holds(low, high)
        now = now.take(undecided)
        if not len(now):
            continue
        if _refuted(now, whole, enclose, wanted, outside, edges, found):
            return found
        narrow = (now.high - now.low).max(axis=1) <= NARROWEST
        if now.middle.shape[1] == 1:  # a sign, of which nothing but rounding may be left
            narrow |= (np.abs(now.middle[:, 0]) <= now.radius[:, 0]).all(axis=(1, 2))
        if narrow.any() or found.boxes + len(waiting) + 2 * len(now) > most:
            found.touching |= bool(((now.high - now.low).max(axis=1) <= _DEEP).any() | narrow.any())
            give_up = narrow if found.boxes + len(waiting) + 2 * len(now) <= most else np.ones(len(now), dtype=np.bool_)
            found.open += [(*a, *b) for a, b in zip(now.low[give_up].tolist(), now.high[give_up].tolist(), strict=True)]
            now = now.take(~give_up)
            if not len(now):
                continue
        waiting = joined(now.halved(), waiting)  # depth first: memory stays small
    return found


def _beside_corners(
    whole: Boxes, enclose: Enclose, wanted: Range, outside: Outside, edges: tuple[int, int, int, int], found: Search
) -> bool:
    """Note a place beside a corner of edges with a factor, where curvature may have no bound; whether one fails."""
    for corner in whole.places():
        for place in _beside(corner, edges):
            at = np.array([place])
            if tuple(corner) == place or outside(at, at)[0]:
                continue
            low, high = enclose(*whole.at(*place))
            if wanted.misses(low, high)[0]:
                found.boxes, found.place, found.low, found.high = 1, place, float(low[0]), float(high[0])
                return True
    return False


def _refuted(
    now: Boxes,
    whole: Boxes,
    enclose: Enclose,
    wanted: Range,
    outside: Outside,
    edges: tuple[int, int, int, int],
    found: Search,
) -> bool:
    """Note a place where the quantity is out of the range, for certain; return whether there is one."""
    places = now.places()
    low, high = enclose(*now.corners())
    missed = wanted.misses(low, high)
    if not missed.any():
        return False
    order = np.argsort(-np.where(missed, wanted.distance(low, high), -np.inf), kind="stable")
    for index in order[: int(missed.sum())][:8]:
        for place in _beside(places[index], edges):
            at = np.array([place])
            if outside(at, at)[0]:
                continue
            least, most = enclose(*whole.at(*place)) if place != tuple(places[index]) else (low[[index]], high[[index]])
            if wanted.misses(least, most)[0]:
                found.place, found.low, found.high = place, float(least[0]), float(most[0])
                return True
    return False


def _beside(place: FloatArray, edges: tuple[int, int, int, int]) -> list[tuple[float, float]]:
    """Return places to look at: the place itself, or some beside it where it lies on an edge with a factor."""
    x, y = place.tolist()
    on = [(x == 0.0 and edges[0]) - (x == 1.0 and edges[1]), (y == 0.0 and edges[2]) - (y == 1.0 and edges[3])]
    if not any(on):
        return [(x, y)]
    ways = [float(np.sign(way)) for way in on]
    return [(x + ways[0] * step, y + ways[1] * step) for step in _INWARD]


def joined(first: Boxes, second: Boxes) -> Boxes:
    """Return all boxes of both."""
    if not len(second):
        return first
    pairs = zip(
        (first.middle, first.radius, first.low, first.high),
        (second.middle, second.radius, second.low, second.high),
        strict=True,
    )
    return Boxes(*(np.concatenate(pair) for pair in pairs))


@dataclass(frozen=True)
class Bounds:
    """What surely encloses the least and the greatest value, each (low, high), and the boxes it took.

    ``complete`` where both are as near as was asked for; the least only for a radius of curvature.
    """

    minimum: tuple[float, float]
    maximum: tuple[float, float]
    boxes: int
    complete: bool = True
    unit: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Return it as keys and values; ends at infinity are null."""
        ends = {
            name: [end if np.isfinite(end) else None for end in pair]
            for name, pair in (("minimum", self.minimum), ("maximum", self.maximum))
        }
        return {**ends, "boxes": self.boxes, "complete": self.complete, "unit": self.unit}


def enclosed(
    starts: list[tuple[Boxes, Enclose, Outside]],
    tolerance: float,
    most: int,
    ends: tuple[bool, bool] = (True, True),
) -> Bounds:
    """Return what encloses the extremes of a quantity over charts.

    Each of the ``ends`` asked for is known to ``tolerance`` times the larger of both values.
    """
    waiting = [(boxes, *enclose(*boxes.bounds()), enclose, outside) for boxes, enclose, outside in starts]
    least, greatest = np.inf, -np.inf  # surely taken, somewhere
    settled: list[tuple[float, float]] = []
    count = len(waiting)
    while True:
        for boxes, _, _, enclose, outside in waiting:
            if not len(boxes):
                continue
            places, (low, high) = boxes.places(), enclose(*boxes.corners())
            use = ~outside(places, places) & np.isfinite(low) & np.isfinite(high)
            least = min(least, float(high[use].min(initial=np.inf)))
            greatest = max(greatest, float(low[use].max(initial=-np.inf)))
        lows = [float(low.min()) for _, low, _, _, _ in waiting if len(low)] + [low for low, _ in settled]
        highs = [float(high.max()) for _, _, high, _, _ in waiting if len(high)] + [high for _, high in settled]
        bottom, top = min(lows, default=np.inf), max(highs, default=-np.inf)
        known = [abs(end) for end, asked in zip((least, greatest), ends, strict=True) if asked and np.isfinite(end)]
        allowed = tolerance * max(known, default=0.0)
        done = (least - bottom <= allowed or not ends[0]) and (top - greatest <= allowed or not ends[1])
        if done or count >= most or not any(len(boxes) for boxes, *_ in waiting):
            return Bounds((bottom, max(least, bottom)), (min(greatest, top), top), count, bool(done))
        following: list[tuple[Boxes, FloatArray, FloatArray, Enclose, Outside]] = []
        gaps = [_gap(low, high, (least, greatest), ends) for _, low, high, _, _ in waiting]
        worst = max((float(gap.max(initial=0.0)) for gap in gaps), default=0.0)
        for (boxes, low, high, enclose, outside), gap in zip(waiting, gaps, strict=True):
            chosen = (low < least - allowed) & ends[0] | (high > greatest + allowed) & ends[1]
            narrow = (boxes.high - boxes.low).max(axis=1) <= NARROWEST
            kept = ~chosen | narrow
            if kept.any():
                settled.append((float(low[kept].min()), float(high[kept].max())))
            later = ~kept & (gap < 0.5 * worst)  # first those that say least
            if later.any():
                following.append((boxes.take(later), low[later], high[later], enclose, outside))
            now = boxes.take(~kept & ~later)
            if not len(now):
                continue
            now = now.halved()
            now = now.take(~outside(now.low, now.high))
            if not len(now):
                continue
            count += len(now)
            following.append((now, *enclose(*now.bounds()), enclose, outside))
        waiting = following


def _gap(low: FloatArray, high: FloatArray, taken: tuple[float, float], ends: tuple[bool, bool]) -> FloatArray:
    """Return by how much each box may exceed the values that are surely taken, at the ends asked for."""
    with np.errstate(invalid="ignore"):
        below, above = np.nan_to_num(taken[0] - low, nan=np.inf), np.nan_to_num(high - taken[1], nan=np.inf)
    return np.maximum(np.where(ends[0], below, 0.0), np.where(ends[1], above, 0.0))
