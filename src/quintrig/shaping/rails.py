"""Rails of strips: one curve or several joined end to end, run either way by a parameter from 0 to 1."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from typing import Any

import numpy as np

from quintrig.geometry.curve import Curve
from quintrig.support.arrays import FloatArray
from quintrig.support.legendre import legendre

_SITES = 257  # at which the arc length of a curve of several is found
_MEET = 1e-6  # of the size: as near as curves of one rail must come to each other


def spline(x: FloatArray, y: FloatArray) -> Any:
    """Return the quintic spline through values y (n, ...) at rising x (n,)."""
    return import_module("scipy.interpolate").make_interp_spline(x, y, 5)


@dataclass(frozen=True, eq=False)
class Rail:
    """Curves in space in turn, each with whether it is run backwards.

    A single curve keeps its parameter; several run by the arc length, so that only corners part them.
    """

    curves: tuple[Curve, ...]
    back: tuple[bool, ...] = (False,)

    @cached_property
    def _paces(self) -> tuple[tuple[Any, ...], FloatArray]:
        """Splines of each curve's own parameter over its share of the arc length, and the breaks (n + 1,)."""
        nodes, weights = legendre(8)
        grid = np.linspace(0.0, 1.0, _SITES)
        inner = grid[:-1, None] + 0.5 * (nodes + 1.0) / (_SITES - 1)
        lengths: list[float] = []
        found: list[Any] = []
        for curve in self.curves:
            speed = np.linalg.norm(curve.derivatives(inner, 1)[1], axis=-1)
            steps = np.concatenate([[0.0], np.cumsum(speed @ weights)])
            lengths.append(0.5 * float(steps[-1]) / (_SITES - 1))
            found.append(spline(steps / steps[-1], grid))
        ends = np.concatenate([[0.0], np.cumsum(lengths)])
        return tuple(found), ends / ends[-1]

    @property
    def breaks(self) -> FloatArray:
        """Parameters at which one curve ends and the next begins, 0 and 1 included."""
        return np.array([0.0, 1.0]) if len(self.curves) == 1 else self._paces[1]

    @property
    def alone(self) -> Curve | None:
        """The curve that the rail is, run forwards; None where there is no such."""
        return self.curves[0] if len(self.curves) == 1 and not self.back[0] else None

    def derivatives(self, t: FloatArray, left: bool = False) -> FloatArray:
        """Return points and first derivatives (2, n, 3) at parameters (n,); ``left`` takes those before a break."""
        if len(self.curves) == 1:
            return _run(self.curves[0], t, self.back[0])
        own_of, breaks = self._paces
        index = np.clip(np.searchsorted(breaks, t, "left" if left else "right") - 1, 0, len(self.curves) - 1)
        result = np.empty((2, len(t), 3))
        for k, curve in enumerate(self.curves):
            here = index == k
            if not here.any():
                continue
            width = float(breaks[k + 1] - breaks[k])
            share = np.clip((t[here] - breaks[k]) / width, 0.0, 1.0)
            if self.back[k]:
                share = 1.0 - share
            own = np.clip(own_of[k](share), 0.0, 1.0)
            d = curve.derivatives(own, 1)
            speed = np.linalg.norm(d[1], axis=-1, keepdims=True)
            sign = -1.0 if self.back[k] else 1.0
            result[0, here] = d[0]
            result[1, here] = sign * self._length * d[1] / np.where(speed > 0.0, speed, 1.0)
        return result

    @cached_property
    def _length(self) -> float:
        return sum(curve.length(tolerance=1e-9) for curve in self.curves)

    def __call__(self, t: FloatArray) -> FloatArray:
        """Return points (n, 3) at parameters (n,), length¹."""
        return self.derivatives(t)[0]

    def turned(self) -> "Rail":
        """Return the rail run the other way."""
        return Rail(self.curves[::-1], tuple(not one for one in self.back[::-1]))


def _run(curve: Curve, t: FloatArray, back: bool) -> FloatArray:
    d = curve.derivatives(1.0 - t if back else t, 1)
    if back:
        d[1] = -d[1]
    return d


def rail(given: "Curve | Rail | Sequence[Curve]", name: str) -> Rail:
    """Return a rail; curves of one are turned so that each begins where the one before it ends.

    Raises ValueError for curves in the plane, and for curves that do not meet.
    """
    if isinstance(given, Rail):
        return given
    curves = (given,) if isinstance(given, Curve) else tuple(given)
    if not curves:
        raise ValueError(f"{name}: expected a curve, or several joined end to end, found none")
    if any(curve.points.shape[1] != 3 for curve in curves):
        raise ValueError(f"{name}: expected a curve in space, found one in the plane; give its points a z")
    ends = [curve(np.array([0.0, 1.0])) for curve in curves]
    size = max(float(np.linalg.norm(np.ptp(curve.points, axis=0))) for curve in curves)
    back = [False]
    if len(curves) > 1:  # the first is turned where its start, not its end, meets the second
        gaps = np.linalg.norm(ends[0][:, None] - ends[1][None], axis=-1).min(axis=1)
        back = [bool(gaps[0] < gaps[1])]
    for k in range(1, len(curves)):
        place = ends[k - 1][0 if back[-1] else 1]
        gaps = np.linalg.norm(ends[k] - place, axis=1)
        if not gaps.min() <= _MEET * size:
            raise ValueError(f"{name}: expected curves joined end to end, found a gap of {gaps.min():.3g} after {k}")
        back.append(bool(gaps[1] < gaps[0]))
    return Rail(curves, tuple(back))


def alike(rails: Sequence[Rail]) -> list[Rail]:
    """Return the rails, each run the same way as the one before it."""
    result = [rails[0]]
    for one in rails[1:]:
        before, here = (each(np.array([0.0, 1.0])) for each in (result[-1], one))
        ahead = np.linalg.norm(before - here, axis=1).sum()
        turned = np.linalg.norm(before - here[::-1], axis=1).sum() < ahead
        result.append(one.turned() if turned else one)
    return result
