"""Where a line that leaves a patch through an edge goes on: in the patch, or at the seam, whose edge lies there."""

from dataclasses import dataclass

import numpy as np

from quintrig.interrogation.cells import Compiled
from quintrig.interrogation.line_jit import foot
from quintrig.support.arrays import FloatArray
from quintrig.support.memory import address

_GAP = 1e-5  # of the size of the patches: edges this near are one
_SAMPLES = 65
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

    def __init__(self, compiled: Compiled) -> None:
        """Sample the edges that are longer than a point."""
        self.compiled, self.surfaces = compiled, compiled.surfaces
        surfaces = self.surfaces
        self.size = max((surface.size for surface in surfaces), default=0.0)
        t, same = np.linspace(0.0, 1.0, _SAMPLES), np.ones(_SAMPLES)
        self._edges: list[_Edge] = []
        for patch, surface in enumerate(surfaces):
            for axis in (0, 1):
                for end in (0.0, 1.0):
                    points = surface(end * same, t) if axis == 0 else surface(t, end * same)
                    if np.linalg.norm(np.ptp(points, axis=0)) > _POINT * self.size:
                        self._edges.append(_Edge(patch, axis, end, points))
        self._points = np.array([edge.points for edge in self._edges]).reshape(-1, _SAMPLES, 3)
        steps = np.linalg.norm(np.diff(self._points, axis=1), axis=2)
        self._reach = steps.max(axis=1, initial=0.0) + _GAP * self.size
        self._low, self._high = (
            end(self._points, axis=1) + sign * self._reach[:, None] for end, sign in ((np.min, -1.0), (np.max, 1.0))
        )

    def enter(self, patch: int, uv: FloatArray, towards: FloatArray) -> tuple[int, FloatArray] | None:
        """Return patch and parameters (2,) where a line goes on that reaches the edge of a patch; None at a free edge.

        ``towards`` (3,) is its direction there.
        """
        point = self.surfaces[patch](*uv)
        best: tuple[float, int, FloatArray] | None = None
        for number in np.flatnonzero(((point >= self._low) & (point <= self._high)).all(axis=1)).tolist():
            edge = self._edges[number]
            if edge.patch == patch and uv[edge.axis] == edge.end:
                continue
            apart = np.linalg.norm(self._points[number] - point, axis=1)
            nearest = int(apart.argmin())
            if apart[nearest] > self._reach[number]:
                continue
            place, gap, inwards = self._foot(edge, point, towards, nearest / (_SAMPLES - 1.0))
            if gap <= _GAP * self.size and inwards and (best is None or gap < best[0]):
                best = gap, edge.patch, place
        return None if best is None else (best[1], best[2])

    def _foot(self, edge: _Edge, point: FloatArray, towards: FloatArray, t: float) -> tuple[FloatArray, float, bool]:
        """Return the foot (2,) of a point on an edge, how far off it is, and whether a line goes on inwards."""
        asked = np.concatenate([edge.at(t), point - self.surfaces[edge.patch].origin, towards, np.zeros(4)])
        foot(self.compiled.address(edge.patch), edge.axis, address(asked), address(self.compiled.scratch))
        gap, onwards = float(asked[8]), float(asked[9])
        step = float(asked[10 + edge.axis])
        # A line that turns back over the edge does not go on.
        return asked[:2], gap, onwards > 0.0 and (step > 0.0 if edge.end == 0.0 else step < 0.0)
