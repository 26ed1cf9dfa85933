"""Conditions on all of a surface, with exact gradients: demands at every point, integrals, and that it stays one."""

from dataclasses import dataclass
from math import comb
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quintrig.geometry.surface import Surface
from quintrig.shaping.demands import Demand
from quintrig.shaping.energies import nodes
from quintrig.shaping.forms import forms, pulled_back
from quintrig.shaping.unknowns import INDICES, State
from quintrig.support.arrays import BoolArray, FloatArray

GRID = 65
"""Points each way at which demands on all of a surface are looked at."""

MARGIN = 1e-6
"""By so much of what is natural for a patch of its size demands are to be met at the points that the search sees."""

_NODES = 24  # of Gauss on a span: integrals of a design need no more than the search does
_FEW = 7  # points each way that the search sees from the start
_COARSE = 17  # points each way at which a surface is kept from folding
_NONE = 1e-20  # of the largest |S_u x S_v|²: no tangent plane
_LEFT = 0.04  # of |S_u x S_v|² is to be left


@dataclass(frozen=True, eq=False)
class Worst:
    """How far a condition is met: ``slack``, scaled, below 0 where it is not; ``value`` in the model's unit, where."""

    slack: float
    value: float
    u: float | None = None
    v: float | None = None


class Condition(Protocol):
    """What a design is to meet: ``equal`` where it is to be 0, not just above."""

    equal: bool

    @property
    def name(self) -> str:
        """As the user wrote it."""
        ...

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return values (k,) and their gradients by the unknowns (k, n)."""
        ...

    def worst(self, state: State) -> Worst:
        """Return how far it is met on all of the surface."""
        ...

    def exchange(self, state: State) -> bool:
        """Add points where it fails to those that the search sees; return whether there are any new ones."""
        ...


def grid_points(count: int = GRID) -> tuple[FloatArray, FloatArray]:
    """Return u and v of a grid, (count²,)."""
    t = np.linspace(0.0, 1.0, count)
    u, v = np.meshgrid(t, t, indexing="ij")
    return u.ravel(), v.ravel()


@dataclass(eq=False)
class OnSurface:
    """A demand at every point, seen at ``seen`` (k,), numbers of points of the grid.

    ``defined`` tells at which points of the grid a patch has a tangent plane: not at a pole.
    """

    demand: Demand
    size: float
    seen: NDArray[np.int64]
    defined: BoolArray
    equal: bool = False

    @property
    def name(self) -> str:
        """As the user wrote it."""
        return self.demand.text

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return the forms at the points seen, less the margin, and their gradients."""
        u, v = (part[self.seen] for part in grid_points())
        found, gradients = self.demand.slack_and_gradient(state.partials(u, v), state.surface.sign, self.size, MARGIN)
        return found.ravel(), np.concatenate([state.pulled(u, v, one) for one in gradients])

    def _slack(self, state: State, margin: float = 0.0) -> tuple[FloatArray, FloatArray]:
        partials = state.partials(*grid_points())
        with np.errstate(invalid="ignore"):
            found = self.demand.slack(partials, state.surface.sign, self.size, margin).min(axis=0)
        found = np.where(self.defined, np.where(np.isnan(found), -1e6, found), np.inf)
        return found, self.demand.measured(partials, state.surface.sign)

    def worst(self, state: State) -> Worst:
        """Return the least slack on the grid, and the quantity there."""
        slack, values = self._slack(state)
        if np.ptp(slack[self.defined]) > 0.0:
            index = int(slack.argmin())
        else:
            index = int(np.where(self.defined, self.demand.sign * values, np.inf).argmin())
        u, v = grid_points()
        return Worst(float(slack[index]), float(values[index]), float(u[index]), float(v[index]))

    def exchange(self, state: State) -> bool:
        """Add the worst point of each part of the surface where it fails."""
        slack = self._slack(state, 0.5 * MARGIN)[0].reshape(GRID, GRID)
        added: list[int] = []
        for rows in np.array_split(np.arange(GRID), 4):
            for columns in np.array_split(np.arange(GRID), 4):
                part = slack[np.ix_(rows, columns)]
                i, j = np.unravel_index(int(part.argmin()), part.shape)
                if part[i, j] < 0.0:
                    added.append(int(rows[i] * GRID + columns[j]))
        fresh = np.setdiff1d(np.array(added, np.int64), self.seen)
        self.seen = np.concatenate([self.seen, fresh])
        return bool(len(fresh))


def on_surface(demand: Demand, surface: Surface) -> OnSurface:
    """Return a demand at every point, seen at 7 x 7 points at first."""
    t = np.rint(np.linspace(0, GRID - 1, _FEW)).astype(np.int64)
    seen = (t[:, None] * GRID + t).ravel()
    area2 = _area2(surface, GRID)
    defined = area2 > _NONE * area2.max()
    if not defined.any():
        raise ValueError(f"demands: {demand.text[:60]!r}: expected a surface, found none with a tangent plane")
    return OnSurface(demand, surface.size, seen[defined[seen]], defined)


def _area2(surface: Surface, count: int) -> FloatArray:
    """Return |S_u x S_v|² on a grid, length⁴."""
    p = surface.local_partials(*grid_points(count), 1)
    return (np.cross(p[1, 0], p[0, 1]) ** 2).sum(axis=-1)


@dataclass(eq=False)
class Integral:
    """A quantity of all of a surface: area, volume above z = 0, or an energy; by Gauss's nodes on every span."""

    key: str
    u: FloatArray
    v: FloatArray
    weights: FloatArray

    def value(self, state: State) -> tuple[float, FloatArray]:
        """Return it and its gradient by the unknowns (n,)."""
        order = 3 if self.key == "variation" else 2
        partials = state.partials(self.u, self.v, order)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            value, gradient = self._parts(partials, state.surface.sign)
        return value, state.total(self.u, self.v, gradient)

    def _parts(self, partials: FloatArray, sign: float) -> tuple[float, FloatArray]:
        weights = self.weights
        gradient = np.zeros_like(partials)
        if self.key in ("thin_plate", "variation"):
            total = 2 if self.key == "thin_plate" else 3
            value = 0.0
            for index, (a, b) in enumerate(INDICES[: len(partials)]):
                if a + b == total:
                    part = comb(total, a) * weights[:, None] * partials[index]
                    value += float((part * partials[index]).sum())
                    gradient[index] = 2.0 * part
            return value, gradient
        at = forms(partials[1:])
        nothing = np.zeros_like(weights)
        if self.key == "area":
            root = np.sqrt(at.area2)
            gradient[1:] = pulled_back(at, nothing, nothing, 0.5 * weights / root)
            return float((weights * root).sum()), gradient
        if self.key == "volume":
            height, upward = partials[0, :, 2], at.cross[:, 2]
            way = 1.0 if float((weights * upward).sum()) >= 0.0 else -1.0
            cross = np.zeros_like(at.cross)
            cross[:, 2] = way * weights * height
            gradient[1:] = pulled_back(at, nothing, nothing, nothing, cross)
            gradient[0, :, 2] = way * weights * upward
            return float(way * (weights * height * upward).sum()), gradient
        power = at.area2**-2.5
        bend = at.mean**2 - 2.0 * at.gauss * at.area2
        gradient[1:] = pulled_back(
            at,
            -2.0 * weights * at.area2 * power,
            2.0 * weights * at.mean * power,
            weights * (-2.0 * at.gauss * power - 2.5 * bend * power / at.area2),
        )
        return float((weights * bend * power).sum()), gradient


def integral(key: str, surface: Surface) -> Integral:
    """Return a quantity of all of a surface with the nodes for its breaks."""
    (u, wu), (v, wv) = (nodes(surface.breaks(axis), _NODES) for axis in (0, 1))
    at = np.meshgrid(u, v, indexing="ij")
    return Integral(key, at[0].ravel(), at[1].ravel(), (wu[:, None] * wv).ravel())


@dataclass(eq=False)
class InTotal:
    """A demand on an integral."""

    demand: Demand
    integral: Integral
    scale: float
    equal: bool = False

    @property
    def name(self) -> str:
        """As the user wrote it."""
        return self.demand.text

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return how far the integral is on the right side of its bound, scaled, and the gradient."""
        value, gradient = self.integral.value(state)
        slack = self.demand.sign * (value - self.demand.bound) / self.scale
        return np.array([slack - MARGIN]), (self.demand.sign / self.scale * gradient)[None]

    def worst(self, state: State) -> Worst:
        """Return the integral and its slack."""
        value, _ = self.integral.value(state)
        return Worst(self.demand.sign * (value - self.demand.bound) / self.scale, value)

    def exchange(self, state: State) -> bool:
        """Nothing is hidden from the search."""
        return False


@dataclass(eq=False)
class Regular:
    """The surface stays one: |S_u x S_v|² at 17 x 17 points no less than 4 % of what it was, ``least``."""

    least: FloatArray
    seen: NDArray[np.int64]
    name: str = "regular"
    equal: bool = False

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return |S_u x S_v|² over what it was, less those 4 %, and the gradients."""
        u, v = (part[self.seen] for part in grid_points(_COARSE))
        at = forms(state.partials(u, v)[1:])
        nothing = np.zeros_like(at.area2)
        gradient = pulled_back(at, nothing, nothing, 1.0 / self.least[self.seen])
        full = np.concatenate([np.zeros((1, *gradient.shape[1:])), gradient])
        return at.area2 / self.least[self.seen] - _LEFT - MARGIN, state.pulled(u, v, full)

    def _left(self, state: State) -> FloatArray:
        return forms(state.partials(*grid_points(_COARSE))[1:]).area2 / self.least - _LEFT

    def worst(self, state: State) -> Worst:
        """Return the least share that is left."""
        left = float(self._left(state).min())
        return Worst(left, left + _LEFT)

    def exchange(self, state: State) -> bool:
        """Add the points where least is left."""
        left = self._left(state)
        low = left.argsort()[:20]
        fresh = np.setdiff1d(low[left[low] < 0.0], self.seen)
        self.seen = np.concatenate([self.seen, fresh])
        return bool(len(fresh))


def regular(surface: Surface) -> Regular | None:
    """Return what keeps a surface from folding; None where it stands still somewhere as it is given."""
    area2 = _area2(surface, _COARSE)
    seen = (np.arange(0, _COARSE, 4)[:, None] * _COARSE + np.arange(0, _COARSE, 4)).ravel()
    return Regular(area2, seen) if area2.min() > 1e-6 * area2.mean() else None
