"""The edges of patches and trimmed faces as curves, sampled: what joins are looked for among."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import SINGULAR, rounding

SIDES = ("u0", "u1", "v0", "v1")
"""Sides of a patch: u0 is u = 0; an edge of trim loop 1 is called loop1.1, loop1.2, ..."""

SAMPLES = 65
"""Points of an edge, ends included."""

_CORNER = np.cos(np.radians(20.0))  # a trim loop that turns more than this has a corner there
_ENOUGH = 9  # vertices of a trim loop's edge from which no point between them is needed
_ACROSS = np.linspace(0.0, 1.0, 9)
_INWARD = 1e-4  # step in the parameters from a trim loop, to see on which side of it the face lies


@dataclass(frozen=True, eq=False)
class Edge:
    """One edge of a patch: a polyline ``path`` (n, 2) in its parameters, run through by t in [0, 1] at ``knots`` (n,).

    ``left`` is 1 where the patch lies to the left of the path in the (u, v) plane, -1 where it lies to the right.
    """

    patch: int
    side: str
    surface: Surface
    path: FloatArray
    knots: FloatArray
    left: float
    t: FloatArray
    points: FloatArray

    @cached_property
    def length(self) -> float:
        """Length of the sampled polygon, length¹."""
        return float(np.linalg.norm(np.diff(self.points, axis=0), axis=-1).sum())

    @cached_property
    def size(self) -> float:
        """Size of the patch, length¹: its surface's, or of a trimmed face that of this edge if less."""
        extent = float(np.linalg.norm(np.ptp(self.points, axis=0))) if self.surface.trim else np.inf
        return min(self.surface.size, extent)

    def place(self, t: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return (u, v) at parameters t, (..., 2), and the direction of the path there, per unit of t."""
        k = np.clip(np.searchsorted(self.knots, t, side="right") - 1, 0, len(self.knots) - 2)
        step = (self.path[k + 1] - self.path[k]) / (self.knots[k + 1] - self.knots[k])[..., None]
        return np.clip(self.path[k] + (t - self.knots[k])[..., None] * step, 0.0, 1.0), step

    def curve(self, t: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return points and tangents at parameters t, (..., 3) each, length¹."""
        uv, step = self.place(t)
        s = self.surface.partials(uv[..., 0], uv[..., 1], 1)
        return s[0, 0], s[1, 0] * step[..., :1] + s[0, 1] * step[..., 1:]

    @cached_property
    def slack(self) -> float:
        """How far the path of a trimmed face's edge may stray from the edge itself, length¹; 0 for a patch's side."""
        if len(self.path) < 3:
            return 0.0
        points = self.surface(*self.path.T)
        return 0.25 * float(np.linalg.norm(points[:-2] - 2.0 * points[1:-1] + points[2:], axis=-1).max())

    @cached_property
    def width(self) -> float:
        """Extent of the patch across the edge in its middle, length¹; of a trimmed face that of the whole edge."""
        if self.surface.trim:
            return float(np.linalg.norm(np.ptp(self.points, axis=0)))
        half = np.full_like(_ACROSS, 0.5)
        line = self.surface(*((_ACROSS, half) if self.side in SIDES[:2] else (half, _ACROSS)))
        return float(np.linalg.norm(np.diff(line, axis=0), axis=-1).sum())

    def spread(self) -> float:
        """Return the extent of the sampled points, length¹."""
        return float(np.ptp(self.points, axis=0).max())


def edges(surfaces: Sequence[Surface]) -> tuple[list[Edge], list[Edge]]:
    """Return the edges of all surfaces, and apart from them those collapsed to a point (poles)."""
    alive: list[Edge] = []
    poles: list[Edge] = []
    for patch, surface in enumerate(surfaces):
        for edge in _trimmed(patch, surface) if surface.trim else _natural(patch, surface):
            if not np.isfinite(edge.points).all():
                continue
            pole = edge.spread() <= SINGULAR * surface.size + rounding(edge.points)
            (poles if pole else alive).append(edge)
    return alive, poles


def _natural(patch: int, surface: Surface) -> Iterator[Edge]:
    t = np.linspace(0.0, 1.0, SAMPLES)
    zero, one = np.zeros_like(t), np.ones_like(t)
    u, v = np.concatenate([zero, one, t, t]), np.concatenate([t, t, zero, one])
    points = surface(u, v).reshape(4, SAMPLES, 3)
    for k, side in enumerate(SIDES):
        path = np.stack([u, v], axis=-1).reshape(4, SAMPLES, 2)[k, [0, -1]]
        yield Edge(patch, side, surface, path, np.array([0.0, 1.0]), -1.0 if k in (0, 3) else 1.0, t, points[k])


def _trimmed(patch: int, surface: Surface) -> Iterator[Edge]:
    for number, loop in enumerate(surface.trim, 1):
        closed = np.concatenate([loop, loop[:1]])
        points = surface(*closed.T)
        for index, (start, end) in enumerate(_runs(points), 1):
            path = np.concatenate([closed[:-1], closed])[start : end + 1]
            yield _along(patch, f"loop{number}.{index}", surface, path)


def _along(patch: int, side: str, surface: Surface, path: FloatArray) -> Edge:
    """Return the edge along a polyline in the parameters, run through at even speed in space."""
    steps = np.linalg.norm(np.diff(surface(*path.T), axis=0), axis=-1)
    steps = np.maximum(steps, 1e-9 * max(float(steps.max()), 1e-300))
    knots = np.concatenate([[0.0], np.cumsum(steps) / steps.sum()])
    knots[-1] = 1.0
    # A polyline's vertices lie on the edge; between them it may stray by the chords' sagitta.
    t = knots if len(knots) >= _ENOUGH else np.union1d(np.linspace(0.0, 1.0, SAMPLES), knots)
    edge = Edge(patch, side, surface, path, knots, 1.0, t, np.zeros((0, 3)))
    uv = edge.place(t)[0]
    middle, way = edge.place(np.array([0.5]))
    inward = middle + _INWARD * np.stack([-way[:, 1], way[:, 0]], axis=-1) / np.linalg.norm(way)
    left = bool(surface.inside(*np.clip(inward, 0.0, 1.0).T).all() and ((inward >= 0.0) & (inward <= 1.0)).all())
    return Edge(patch, side, surface, path, knots, 1.0 if left else -1.0, t, surface(*uv.T))


def _runs(points: FloatArray) -> list[tuple[int, int]]:
    """Return first and last index of each run between corners of a closed polygon (n + 1, 3); ends may pass n."""
    steps = np.diff(points, axis=0)
    length = np.linalg.norm(steps, axis=-1)
    steps = steps / np.where(length > 0.0, length, 1.0)[:, None]
    corners = np.flatnonzero((np.roll(steps, 1, axis=0) * steps).sum(axis=-1) < _CORNER)
    if not len(corners):
        corners = np.array([0])
    n = len(steps)
    return [(int(a), int(b)) for a, b in zip(corners, [*corners[1:], corners[0] + n], strict=True)]
