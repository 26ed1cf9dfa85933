"""Where a line that leaves a patch through an edge goes on: in the patch, or at the seam, whose edge lies there."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.local import Local, dot
from quintrig.support.arrays import FloatArray

_GAP = 1e-5  # of the size of the patches: edges this near are one
_SAMPLES = 65
_STEPS = 30
_POINT = 1e-9  # of the size: an edge no longer than this is a point


@dataclass(frozen=True, eq=False)
class _Edge:
    patch: int
    axis: int  # the parameter that is constant
    end: float
    points: FloatArray

    def at(self, t: float) -> FloatArray:
        return np.array([self.end, t]) if self.axis == 0 else np.array([t, self.end])


class Seams:
    """The edges of all patches."""

    def __init__(self, surfaces: Sequence[Surface]) -> None:
        """Sample the edges that are longer than a point."""
        self.surfaces = surfaces
        self.size = max((surface.size for surface in surfaces), default=0.0)
        t, same = np.linspace(0.0, 1.0, _SAMPLES), np.ones(_SAMPLES)
        self._edges: list[_Edge] = []
        for patch, surface in enumerate(surfaces):
            for axis in (0, 1):
                for end in (0.0, 1.0):
                    points = surface(end * same, t) if axis == 0 else surface(t, end * same)
                    if np.linalg.norm(np.ptp(points, axis=0)) > _POINT * self.size:
                        self._edges.append(_Edge(patch, axis, end, points))

    def enter(self, patch: int, uv: FloatArray, towards: FloatArray) -> tuple[int, FloatArray] | None:
        """Return patch and parameters (2,) where a line goes on that reaches the edge of a patch; None at a free edge.

        ``towards`` (3,) is its direction there.
        """
        point = self.surfaces[patch](*uv)
        best: tuple[float, int, FloatArray] | None = None
        for edge in self._edges:
            if edge.patch == patch and uv[edge.axis] == edge.end:
                continue
            apart = np.linalg.norm(edge.points - point, axis=1)
            nearest = int(apart.argmin())
            step = np.linalg.norm(np.diff(edge.points, axis=0), axis=1).max()
            if apart[nearest] > step + _GAP * self.size:
                continue
            place, gap = self._foot(edge, point, nearest / (_SAMPLES - 1.0))
            inwards = self._inwards(edge, place, towards)
            if gap <= _GAP * self.size and inwards and (best is None or gap < best[0]):
                best = gap, edge.patch, place
        return None if best is None else (best[1], best[2])

    def _foot(self, edge: _Edge, point: FloatArray, t: float) -> tuple[FloatArray, float]:
        surface = self.surfaces[edge.patch]
        for _ in range(_STEPS):
            p = surface.partials(*edge.at(t), order=1)
            along = p[0, 1] if edge.axis == 0 else p[1, 0]
            square = float(along @ along)
            moved = min(max(t + float((point - p[0, 0]) @ along) / square, 0.0), 1.0) if square > 0.0 else t
            if abs(moved - t) <= 1e-15:
                break
            t = moved
        return edge.at(t), float(np.linalg.norm(surface(*edge.at(t)) - point))

    def _inwards(self, edge: _Edge, uv: FloatArray, towards: FloatArray) -> bool:
        local = Local.at(self.surfaces[edge.patch], *uv, order=1)
        step = local.lowered(towards)
        # A line that turns back over the edge does not go on.
        onwards = dot(local.lifted(step), towards) > 0.0
        return bool(onwards and (step[edge.axis] > 0.0 if edge.end == 0.0 else step[edge.axis] < 0.0))
