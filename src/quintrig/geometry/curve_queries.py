"""Where on a curve: the closest point, meetings with lines and planes, inflections, extremes of curvature."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from quintrig.geometry.curve_measures import Measures
from quintrig.geometry.roots import roots
from quintrig.support.arrays import FloatArray, frozen

_MEETS = 1e-9  # of the curve's size: nearer to a line in space than this, the curve meets it
_BEND = 1e-9  # of second derivatives, beside what a bend of the whole curve would make: below, it is none


@dataclass(frozen=True)
class Closest:
    """The point of a curve closest to a given one: its parameter, itself and the distance, length¹."""

    t: float
    point: FloatArray
    distance: float


class Queries(Measures):
    """What a curve is asked about its places."""

    def closest(self, point: ArrayLike) -> Closest:
        """Return the point of the curve that is closest to ``point``, the first where several are."""
        target = self._vector(point, "point")

        def slope(t: FloatArray) -> FloatArray:
            place, tangent = self.derivatives(t, 1)
            return ((place - target) * tangent).sum(axis=-1)

        t = np.concatenate([[0.0], roots(slope), [1.0]])
        places = self.derivatives(t, 0)[0]
        distances = np.linalg.norm(places - target, axis=-1)
        best = int(np.argmin(distances))
        return Closest(float(t[best]), places[best], float(distances[best]))

    def meets_plane(self, plane: ArrayLike) -> FloatArray:
        """Return the parameters at which the curve meets the plane (a, b, c, d), a x + b y + c z + d = 0, in order.

        For a plane curve the line (a, b, c), a x + b y + c = 0. Places where it only touches count; a curve that lies
        in it has none. Raises ValueError for a plane without a normal.
        """
        values = frozen(plane, "plane", (self.points.shape[1] + 1,))
        normal = values[:-1]
        length = float(np.linalg.norm(normal))
        if not length > 0.0:
            raise ValueError("plane: expected a normal that is not zero, found (0, 0, ...)")
        heights = (self.points @ normal + values[-1]) / length
        if float(np.abs(heights).max()) <= 1e-14 * float(np.abs(self.points).max()):
            return np.empty(0)
        return roots(lambda t: (self.derivatives(t, 0)[0] @ normal + values[-1]) / length)

    def meets_line(self, point: ArrayLike, direction: ArrayLike) -> FloatArray:
        """Return the parameters at which the curve meets a line, in order; in space, comes within 1e-9 of its size.

        Raises ValueError for a direction of zero.
        """
        start, along = self._vector(point, "point"), self._vector(direction, "direction")
        length = float(np.linalg.norm(along))
        if not length > 0.0:
            raise ValueError("direction: expected one that is not zero")
        along = along / length
        if along.size == 2:
            normal = np.array([-along[1], along[0]])
            return self.meets_plane([*normal, -float(normal @ start)])

        def across(vectors: FloatArray) -> FloatArray:
            return vectors - (vectors @ along)[..., None] * along

        def slope(t: FloatArray) -> FloatArray:
            place, tangent = self.derivatives(t, 1)
            return (across(place - start) * tangent).sum(axis=-1)

        t = np.concatenate([[0.0], roots(slope), [1.0]])
        gaps = np.linalg.norm(across(self.derivatives(t, 0)[0] - start), axis=-1)
        met = t[gaps <= _MEETS * float(np.ptp(self.points, axis=0).max())]
        return met[np.concatenate([[True], np.diff(met) > 1e-9])] if met.size else met

    def inflections(self) -> FloatArray:
        """Return the parameters in (0, 1) at which a plane curve changes the side to which it turns, in order.

        For a curve in space those at which the curvature vanishes. A straight one has none.
        """
        if self.points.shape[1] == 2:
            if self._straight():
                return np.empty(0)
            found = roots(self._turn)
            inside = found[(found > 1e-9) & (found < 1.0 - 1e-9)]
            step = 1e-6
            before, after = (self._turn(np.clip(inside + side, 0.0, 1.0)) for side in (-step, step))
            return inside[before * after < 0.0]
        extremes = self.curvature_extremes()
        values = self.curvature(extremes)
        return extremes[values <= _BEND / float(np.ptp(self.points, axis=0).max())]

    def curvature_extremes(self) -> FloatArray:
        """Return the parameters in (0, 1) at which the curvature, signed in the plane, has a highest or lowest value.

        A straight curve has none; one of constant curvature neither.
        """
        if self._straight():
            return np.empty(0)
        # On an arc of constant curvature only rounding is left, whose signs are no extremes.
        noise = 1e-13 * float(self._bend_slope(np.linspace(0.0, 1.0, 513))[1].max())

        def slope(t: FloatArray) -> FloatArray:
            values = self._bend_slope(t)[0]
            return np.where(np.abs(values) <= noise, 0.0, values)

        found = roots(slope)
        return found[(found > 1e-9) & (found < 1.0 - 1e-9)]

    def _turn(self, t: FloatArray) -> FloatArray:
        _, first, second = self.hodograph(t, 2)
        return first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]

    def _bend_slope(self, t: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return |z'|⁵ dκ/dt, in space times |z' x z''|, which vanish where κ is extreme, and a bound of both terms."""
        _, first, second, third = self.derivatives(t, 3)
        speed, along = (first**2).sum(axis=-1), (first * second).sum(axis=-1)
        if self.points.shape[1] == 2:
            bend = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
            change = first[..., 0] * third[..., 1] - first[..., 1] * third[..., 0]
            result = change * speed - 3.0 * bend * along
        else:
            cross, slope = np.cross(first, second), np.cross(first, third)
            left, right = (cross * slope).sum(axis=-1) * speed, 3.0 * (cross**2).sum(axis=-1) * along
            result = left - right
        # By lengths alone: on a circle both terms vanish, and what they are of is rounding too.
        lengths = [np.sqrt((part**2).sum(axis=-1)) for part in (first, second, third)]
        scale = lengths[0] ** 3 * lengths[2] + 3.0 * (lengths[0] * lengths[1]) ** 2
        return result, scale if self.points.shape[1] == 2 else scale * lengths[0] * lengths[1]

    def _straight(self) -> bool:
        """Whether the control points lie on one line."""
        spread = np.linalg.svd(self.points - self.points.mean(axis=0), compute_uv=False)
        return bool(spread[1] <= 1e-13 * spread[0]) if spread[0] > 0.0 else True

    def _vector(self, value: ArrayLike, name: str) -> FloatArray:
        return frozen(value, name, (self.points.shape[1],))
