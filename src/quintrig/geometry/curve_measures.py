"""Arc length and its inverse, bending energy, area and moments of a curve."""

import heapq
from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from quintrig.geometry.curve_frames import Frames
from quintrig.support.arrays import FloatArray
from quintrig.support.legendre import legendre

_NODES = 16  # of a panel
_DEEPEST = 48  # halvings of a panel after which an integral that still grows is infinite
_GROWS = 1e-4  # of the integral: what a panel so small must add to it for that
_MOST_PANELS = 400


@dataclass(frozen=True)
class Moments:
    """Area (length²), centroid (length¹) and second moments about it (length⁴) of a closed plane curve's inside."""

    area: float
    centroid: FloatArray
    xx: float
    yy: float
    xy: float


class Measures(Frames):
    """What a curve measures along itself."""

    @abstractmethod
    def length(self, start: float = 0.0, end: float = 1.0, tolerance: float = 1e-12) -> float:
        """Return the arc length between two parameters, length¹."""

    @abstractmethod
    def curvature(self, t: ArrayLike) -> FloatArray:
        """Return the curvature, shape t.shape, length⁻¹."""

    @property
    def closed(self) -> bool:
        """Whether the curve ends where it starts, to rounding."""
        size = np.ptp(self.points, axis=0).max()
        return bool(np.linalg.norm(self.points[-1] - self.points[0]) <= 1e-12 * size)

    def parameter_at(self, length: ArrayLike) -> FloatArray:
        """Return the parameters at which the arc length from t = 0 has these values, shape of ``length``.

        Raises ValueError for lengths outside 0 to the length of the curve.
        """
        wanted = np.asarray(length, dtype=np.float64)
        knots = np.linspace(0.0, 1.0, 65)
        along = np.concatenate([[0.0], np.cumsum([self.length(a, b) for a, b in pairwise(knots.tolist())])])
        total = float(along[-1])
        if not np.all((wanted >= -1e-12 * total) & (wanted <= total * (1.0 + 1e-12))):
            raise ValueError(
                f"length: expected 0 to {total:.10g}, the length of the curve, found {wanted.tolist()}"[:200]
            )
        return np.array([self._at(x, knots, along) for x in wanted.ravel().tolist()]).reshape(wanted.shape)

    def _at(self, wanted: float, knots: FloatArray, along: FloatArray) -> float:
        panel = int(np.clip(np.searchsorted(along, wanted, "right") - 1, 0, len(knots) - 2))
        start, low, high = float(knots[panel]), float(knots[panel]), float(knots[panel + 1])
        rest = wanted - float(along[panel])
        if rest <= 0.0:
            return start
        share = rest / float(along[panel + 1] - along[panel])
        t = low + min(share, 1.0) * (high - low)
        for _ in range(80):
            miss = self.length(start, t) - rest
            low, high = (low, t) if miss > 0.0 else (t, high)
            speed = float(np.linalg.norm(self.derivatives(t, 1)[1]))
            step = t - miss / speed if speed > 0.0 else np.nan
            new = step if low < step < high else 0.5 * (low + high)
            if abs(new - t) <= 4e-16 or abs(miss) <= 4e-16 * float(along[-1]):
                break
            t = new
        return t

    def bending_energy(self) -> float:
        """Return ∫ κ² ds, length⁻¹; infinite where a cusp or a still end makes it so.

        Gauss-Legendre with 16 nodes a panel; the panel that halving changes most is halved next, until what all of
        them changed by is rounding of the whole, or noise that no halving lessens.
        """
        whole = self._bending([(0.0, 1.0)])
        panels, total, noise = [(-np.inf, 0.0, 1.0, float(whole[0]), 0)], float(whole[0]), np.inf
        if not np.isfinite(total):
            return np.inf
        while noise > 1e-12 * total and len(panels) < _MOST_PANELS:
            change, low, high, before, depth = heapq.heappop(panels)
            if depth > _DEEPEST:
                if -change > _GROWS * total:
                    return np.inf
                heapq.heappush(panels, (0.0, low, high, before, depth))
            else:
                middle = 0.5 * (low + high)
                first, second = self._bending([(low, middle), (middle, high)]).tolist()
                change = -0.5 * abs(first + second - before)
                heapq.heappush(panels, (change, low, middle, first, depth + 1))
                heapq.heappush(panels, (change, middle, high, second, depth + 1))
            total, noise = sum(one[3] for one in panels), -sum(one[0] for one in panels)
            if not np.isfinite(total):
                return np.inf
        return total

    def _bending(self, panels: Sequence[tuple[float, float]]) -> FloatArray:
        low, high = np.array(panels).T[:, :, None]
        nodes, weights = legendre(_NODES)
        half = 0.5 * (high - low)
        t = np.clip(0.5 * (low + high) + half * nodes, 0.0, 1.0)
        speed = np.linalg.norm(self.derivatives(t, 1)[1], axis=-1)
        return (half * self.curvature(t) ** 2 * speed) @ weights

    def area_under(self) -> float:
        """Return ∫ y dx of a plane curve, length²; ValueError in space."""
        (_, y), (dx, _), weights = self._plane()
        return float(y * dx @ weights)

    def moments(self) -> Moments:
        """Return area, centroid and second moments of the inside, by Green's theorem.

        The area is positive for a curve that runs anticlockwise. Raises ValueError for a curve that is not closed, lies
        in space, or encloses no area.
        """
        if not self.closed:
            raise ValueError("moments: expected a closed plane curve, found one whose ends differ; close it first")
        (x, y), (dx, dy), weights = self._plane()
        at = np.array([x.mean(), y.mean()])  # so that no digits are lost far from the origin
        x, y = x - at[0], y - at[1]
        turn = x * dy - y * dx
        area = float(0.5 * turn @ weights)
        if abs(area) <= 1e-14 * float(np.abs(turn) @ weights):
            raise ValueError("moments: expected a curve around an area, found one that encloses none")
        centre = np.array([x * turn @ weights, y * turn @ weights]) / (3.0 * area)
        xx, yy, xy = (float(part @ weights) / 4.0 for part in (x * x * turn, y * y * turn, x * y * turn))
        return Moments(
            area,
            at + centre,
            xx - area * float(centre[0] ** 2),
            yy - area * float(centre[1] ** 2),
            xy - area * float(centre[0] * centre[1]),
        )

    def _plane(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return x and y, their derivatives, and weights, for integrals over t of a plane curve."""
        if self.points.shape[1] != 2:
            raise ValueError("area: expected a plane curve (n x 2 points), found one in space")
        edges = np.linspace(0.0, 1.0, 9)
        half = 0.5 * np.diff(edges)[:, None]
        nodes, weights = legendre(_NODES)
        t = (0.5 * (edges[:-1] + edges[1:])[:, None] + half * nodes).ravel()
        values = self.derivatives(t, 1)
        return values[0].T, values[1].T, (half * weights).ravel()
