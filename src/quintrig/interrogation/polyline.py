"""From parameters along a line to a ``Line``: points, arc length, chord error; cut where a face is trimmed away."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import cast

import numpy as np
from numpy.typing import NDArray

from quintrig.geometry.surface import Surface
from quintrig.interrogation.line import Line
from quintrig.support.arrays import BoolArray, FloatArray

Values = Callable[[Surface, FloatArray], FloatArray]
"""The quantity at parameters (n, 2) of a surface, (n,)."""

_HALVINGS = 40  # to find where a line leaves a face


@dataclass(frozen=True, eq=False)
class Path:
    """Parameters on one patch: ``uv`` (n, 2), and ``middles`` (n - 1, 2) of the line between them.

    ``known`` are the points of both, where they were looked up before. ``quarters`` (n - 1, 2, 2), where there are any,
    lie before and after the middles.
    """

    patch: int
    uv: FloatArray
    middles: FloatArray
    closed: bool = False
    known: tuple[FloatArray, FloatArray] | None = None
    quarters: FloatArray | None = None

    def on(self, surface: Surface) -> tuple[FloatArray, FloatArray]:
        """Return the points (n, 3), and those in the middles (n - 1, 3), length¹."""
        if self.known is None:
            object.__setattr__(self, "known", (surface(*self.uv.T), surface(*self.middles.T)))
        return cast(tuple[FloatArray, FloatArray], self.known)

    def part(self, first: int, last: int) -> "Path":
        """Return the path from point ``first`` up to before ``last``."""
        known = None if self.known is None else (self.known[0][first:last], self.known[1][first : last - 1])
        whole = last - first == len(self.uv)
        quarters = None if self.quarters is None else self.quarters[first : last - 1]
        closed = self.closed and whole
        return Path(self.patch, self.uv[first:last], self.middles[first : last - 1], closed, known, quarters)

    @property
    def backwards(self) -> "Path":
        """The path from its end to its beginning."""
        known = None if self.known is None else (self.known[0][::-1], self.known[1][::-1])
        quarters = None if self.quarters is None else self.quarters[::-1, ::-1]
        return Path(self.patch, self.uv[::-1], self.middles[::-1], self.closed, known, quarters)

    def then(self, other: "Path") -> "Path":
        """Return the path that goes on from its last point with another, which begins there."""
        uv, middles = np.concatenate([self.uv, other.uv[1:]]), np.concatenate([self.middles, other.middles])
        known = None
        if self.known is not None and other.known is not None:
            known = (
                np.concatenate([self.known[0], other.known[0][1:]]),
                np.concatenate([self.known[1], other.known[1]]),
            )
        return Path(self.patch, uv, middles, known=known)

    def cut(self, surface: Surface) -> "list[Path]":
        """Return the parts inside the trim loops; itself where there are none."""
        if not surface.trim:
            return [self]
        inside = surface.inside(*self.uv.T)
        return self.parts(inside, [self._crossing(surface, int(i), bool(inside[i])) for i in changes(inside)])

    def parts(self, kept: BoolArray, crossings: Sequence[FloatArray]) -> "list[Path]":
        """Return the stretches of points that are kept, each to the crossing between them and the next one.

        A crossing (9, 2) holds the points of the line at 1/4, 2/4, 3/4 of the way there and of the way on, and ends.
        """
        if kept.all():
            return [self]
        parts: list[Path] = []
        start = 0
        ends = dict(zip(changes(kept).tolist(), crossings, strict=True))
        inner = np.stack([self.middles] * 3, axis=1)
        if self.quarters is not None:
            inner[:, ::2] = self.quarters
        for i in [*ends, len(kept) - 1]:
            if kept[i]:
                head = [ends[start - 1][4:]] if start else []
                tail = [ends[i][:5]] if i in ends else []
                if start < i or head or tail:
                    ways = [*(part[1:4] for part in head), *inner[start:i], *(part[1:4] for part in tail)]
                    uv = np.concatenate([*(x[:1] for x in head), self.uv[start : i + 1], *(x[4:] for x in tail)])
                    between = np.stack(ways)
                    quarters = None if self.quarters is None else between[:, ::2]
                    parts.append(Path(self.patch, uv, between[:, 1], quarters=quarters))
            start = i + 1
        return parts

    def _crossing(self, surface: Surface, i: int, leaving: bool) -> FloatArray:
        """Return the crossing (9, 2) of a loop between points i and i + 1."""
        known = (
            [self.middles[i]]
            if self.quarters is None
            else [*self.quarters[i, :1], self.middles[i], *self.quarters[i, 1:]]
        )
        points = np.stack([self.uv[i], *known, self.uv[i + 1]])
        t = np.linspace(0.0, 1.0, len(points))
        curve = np.linalg.solve(np.vander(t), points)  # the polynomial through them
        low, high = 0.0, 1.0
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            if bool(surface.inside(*_clipped(np.vander([middle], len(t)) @ curve)[0])) == leaving:
                low = middle
            else:
                high = middle
        return _clipped(np.vander(stops(low if leaving else high), len(t)) @ curve)


def stops(at: float) -> FloatArray:
    """Return quarters of the way from 0 to a place between 0 and 1, and on to 1 (9,)."""
    return np.concatenate([np.linspace(0.0, at, 5), np.linspace(at, 1.0, 5)[1:]])


def straight(start: FloatArray, at: FloatArray, end: FloatArray) -> FloatArray:
    """Return the crossing (9, 2) at a place between two points, by straight lines."""
    t = np.linspace(0.0, 1.0, 5)[:, None]
    return np.concatenate([start + t * (at - start), (at + t * (end - at))[1:]])


def _clipped(uv: FloatArray) -> FloatArray:
    return np.clip(uv, 0.0, 1.0)


def looked_up(surfaces: Sequence[Surface], paths: Sequence[Path]) -> None:
    """Look the points of all paths up, those of a patch at once."""
    for patch in {path.patch for path in paths}:
        here = [path for path in paths if path.patch == patch]
        uv = [part for path in here for part in (path.uv, path.middles)]
        ends = np.cumsum([len(part) for part in uv])[:-1]
        points = np.split(surfaces[patch](*np.concatenate(uv).T), ends)
        for path, pair in zip(here, zip(points[::2], points[1::2], strict=True), strict=True):
            object.__setattr__(path, "known", pair)


def changes(kept: BoolArray) -> NDArray[np.intp]:
    """Return after which points of a line it is kept no longer, or from the next one on."""
    return np.flatnonzero(kept[1:] != kept[:-1])


def strayed(points: FloatArray, between: FloatArray) -> FloatArray:
    """Return how far a line through points (n, 3) is from each chord (n - 1,), length¹.

    ``between`` (n - 1, m, 3) are points of it in the middle of each and, where known, at the quarters. There a smooth
    line is off by 3/4 of what it is in the middle; where it is not, it may be off by more between them, and twice
    the difference is added.
    """
    chord, before = np.diff(points, axis=0)[:, None], between - points[:-1, None]
    square = np.einsum("nmk,nmk->nm", chord, chord)
    share = np.clip(np.einsum("nmk,nmk->nm", before, chord) / np.where(square > 0.0, square, 1.0), 0.0, 1.0)
    away = before - share[..., None] * chord
    rough = np.linalg.norm(away[:, 1:] - 0.75 * away[:, :1], axis=2).max(axis=1, initial=0.0)
    return np.linalg.norm(away, axis=2).max(axis=1) + 2.0 * rough


def measured(surface: Surface, path: Path) -> tuple[FloatArray, FloatArray, float]:
    """Return points (n, 3), arc length (n,) and chord error of a path, length¹."""
    points, middles = path.on(surface)
    between = middles[:, None]
    stops = [points[:-1], middles, points[1:]]
    lengths = [_length(stops[::2]), _length(stops)]
    if path.quarters is not None:
        quarters = surface(path.quarters[..., 0], path.quarters[..., 1])
        between = np.concatenate([between, quarters], axis=1)
        lengths.append(_length([stops[0], quarters[:, 0], stops[1], quarters[:, 1], stops[2]]))
    step = (4.0 * lengths[-1] - lengths[-2]) / 3.0  # chords of half the width are off by a quarter
    s = np.concatenate([[0.0], np.cumsum(np.maximum(step, lengths[0]))])
    return points, s, float(strayed(points, between).max(initial=0.0))


def _length(stops: Sequence[FloatArray]) -> FloatArray:
    """Return the length of polylines through points (n, 3) each."""
    steps = [np.linalg.norm(after - before, axis=1) for before, after in pairwise(stops)]
    return np.asarray(np.sum(steps, axis=0))


def line_of(
    surface: Surface,
    name: str,
    path: Path,
    label: str,
    values: Values,
    *,
    chain: int = 0,
    level: float | None = None,
    strength: bool = False,
) -> Line:
    """Return the line of a path on a patch; ``strength`` adds ∫|values| ds."""
    points, s, off = measured(surface, path)
    found = values(surface, path.uv)
    total = float(np.sum(0.5 * (np.abs(found[1:]) + np.abs(found[:-1])) * np.diff(s))) if strength else None
    return Line(name, label, chain, path.closed, path.uv, points, s, found, off, level, total)


def chained(lines: Sequence[Line], reach: float) -> tuple[Line, ...]:
    """Return the lines with one chain number for those of a label whose ends meet within ``reach``, length¹."""
    from dataclasses import replace

    chain = list(range(len(lines)))

    def root(k: int) -> int:
        while chain[k] != k:
            k = chain[k]
        return k

    ends = [(k, point) for k, line in enumerate(lines) if not line.closed for point in line.points[[0, -1]]]
    if ends:
        cloud = np.array([point for _, point in ends])
        for i, (k, point) in enumerate(ends):
            near = np.flatnonzero(np.linalg.norm(cloud[i + 1 :] - point, axis=1) <= reach) + i + 1
            for j in near.tolist():
                if lines[ends[j][0]].label == lines[k].label:
                    chain[root(ends[j][0])] = root(k)
    roots = [root(k) for k in range(len(lines))]
    numbers = {r: i for i, r in enumerate(dict.fromkeys(roots))}
    return tuple(replace(line, chain=numbers[r]) for line, r in zip(lines, roots, strict=True))
