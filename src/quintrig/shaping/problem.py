"""A design as numbers to search: the objective, and what is to be 0 or more or equal to 0, with exact gradients."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import comb
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from quintrig.geometry.closest_point import projected, refined
from quintrig.geometry.surface import Surface
from quintrig.shaping.demands import Demand
from quintrig.shaping.energies import nodes, quadratic
from quintrig.shaping.forms import forms, pulled_back
from quintrig.shaping.unknowns import INDICES, State, Unknowns
from quintrig.support.arrays import FloatArray

GRID = 65
"""Points each way at which demands on all of a surface are looked at."""

MARGIN = 1e-6
"""By so much of what is natural for a patch of its size demands are to be met at the points that the search sees."""

_NODES = 24  # of Gauss on a span: integrals of a design need no more than the search does
_FEW = 7  # points each way that the search sees from the start
_COARSE = 17  # points each way at which a surface is kept from folding
_LEFT = 0.04  # of |S_u x S_v|² is to be left
_MOST_TARGETS = 400  # points of a target that the search sees from the start


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


def _grid(count: int = GRID) -> tuple[FloatArray, FloatArray]:
    t = np.linspace(0.0, 1.0, count)
    u, v = np.meshgrid(t, t, indexing="ij")
    return u.ravel(), v.ravel()


@dataclass(eq=False)
class OnSurface:
    """A demand at every point, seen at ``seen`` (k,), numbers of points of the grid."""

    demand: Demand
    size: float
    seen: NDArray[np.int64]
    equal: bool = False

    @property
    def name(self) -> str:
        """As the user wrote it."""
        return self.demand.text

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return the forms at the points seen, less the margin, and their gradients."""
        u, v = (part[self.seen] for part in _grid())
        found, gradients = self.demand.slack_and_gradient(state.partials(u, v), state.surface.sign, self.size)
        return found.ravel() - MARGIN, np.concatenate([state.pulled(u, v, one) for one in gradients])

    def _slack(self, state: State) -> tuple[FloatArray, FloatArray]:
        partials = state.partials(*_grid())
        with np.errstate(invalid="ignore"):
            found = self.demand.slack(partials, state.surface.sign, self.size).min(axis=0)
        return np.where(np.isnan(found), -1e6, found), self.demand.measured(partials, state.surface.sign)

    def worst(self, state: State) -> Worst:
        """Return the least slack on the grid, and the quantity there."""
        slack, values = self._slack(state)
        index = int((slack if np.ptp(slack) > 0 else self.demand.sign * values).argmin())
        u, v = _grid()
        return Worst(float(slack[index]), float(values[index]), float(u[index]), float(v[index]))

    def exchange(self, state: State) -> bool:
        """Add the worst point of each part of the surface where it fails."""
        slack = self._slack(state)[0].reshape(GRID, GRID)
        added: list[int] = []
        for rows in np.array_split(np.arange(GRID), 4):
            for columns in np.array_split(np.arange(GRID), 4):
                part = slack[np.ix_(rows, columns)]
                i, j = np.unravel_index(int(part.argmin()), part.shape)
                if part[i, j] < 0.5 * MARGIN:
                    added.append(int(rows[i] * GRID + columns[j]))
        fresh = np.setdiff1d(np.array(added, np.int64), self.seen)
        self.seen = np.concatenate([self.seen, fresh])
        return bool(len(fresh))


def on_surface(demand: Demand, surface: Surface) -> OnSurface:
    """Return a demand at every point, seen at 7 x 7 points at first."""
    t = np.rint(np.linspace(0, GRID - 1, _FEW)).astype(np.int64)
    return OnSurface(demand, surface.size, (t[:, None] * GRID + t).ravel())


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
class Near:
    """Points (n, 3) that the surface is to be within a distance of: a target's, or the given patch's own (u, v).

    ``feet`` (n, 2) are the parameters of the nearest points as last found; ``fixed`` where they are those of the
    given patch and stay.
    """

    name: str
    points: FloatArray
    within: float
    feet: FloatArray
    fixed: bool
    seen: NDArray[np.int64]
    equal: bool = False

    def _feet(self, state: State, which: NDArray[np.int64]) -> FloatArray:
        if not self.fixed:
            self.feet[which] = refined(state.surface, self.points[which], self.feet[which])
        return self.feet[which]

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return 1 - d² / within² at the points seen, and the gradients: a foot that slides changes d by nothing."""
        at = self._feet(state, self.seen)
        apart = state.partials(at[:, 0], at[:, 1], 0)[0] - self.points[self.seen]
        rows = state.pulled(at[:, 0], at[:, 1], -2.0 * apart[None] / self.within**2)
        return 1.0 - (apart**2).sum(axis=1) / self.within**2 - MARGIN, rows

    def distances(self, state: State) -> FloatArray:
        """Return the distances of all points, length¹."""
        if not self.fixed:
            self.feet = projected(state.surface, self.points) if len(self.points) <= 20000 else refined(
                state.surface, self.points, self.feet)  # fmt: skip
        at = self.feet
        return np.sqrt(((state.partials(at[:, 0], at[:, 1], 0)[0] - self.points) ** 2).sum(axis=1))

    def worst(self, state: State) -> Worst:
        """Return the largest distance."""
        found = self.distances(state)
        index = int(found.argmax())
        u, v = self.feet[index].tolist()
        return Worst(1.0 - float(found[index] / self.within) ** 2, float(found[index]), u, v)

    def exchange(self, state: State) -> bool:
        """Add the farthest points."""
        found = self.distances(state)
        far = found.argsort()[::-1][:50]
        fresh = np.setdiff1d(far[found[far] > self.within], self.seen)[:20]
        self.seen = np.concatenate([self.seen, fresh])
        return bool(len(fresh))

    def mean_square(self, state: State, scale: float) -> tuple[float, FloatArray]:
        """Return the mean of the squared distances of the points seen over ``scale``², and its gradient."""
        at = self._feet(state, self.seen)
        apart = state.partials(at[:, 0], at[:, 1], 0)[0] - self.points[self.seen]
        count = len(self.seen) * scale**2
        return float((apart**2).sum() / count), state.total(at[:, 0], at[:, 1], 2.0 * apart[None] / count)


def near(name: str, points: FloatArray, within: float, surface: Surface) -> Near:
    """Return points to be near, with their feet on the surface as it is."""
    if len(points) <= 20000:
        feet = projected(surface, points)
    else:  # each starts at the foot of a neighbour among fewer points
        rough = projected(surface, points[:: len(points) // 5000])
        feet = np.repeat(rough, len(points) // 5000 + 1, axis=0)[: len(points)]
        feet = refined(surface, points, feet)
    seen = np.unique(np.linspace(0, len(points) - 1, min(len(points), _MOST_TARGETS)).astype(np.int64))
    return Near(name, points, within, feet, False, seen)


def near_given(name: str, within: float, surface: Surface) -> Near:
    """Return the given patch's own points to be near, at equal (u, v)."""
    feet = np.stack(_grid(33), axis=-1)
    seen = np.arange(0, len(feet), 8)
    return Near(name, surface(feet[:, 0], feet[:, 1]), within, feet, True, seen)


@dataclass(eq=False)
class Passing:
    """A point that the surface goes through: at (u, v), or where it is nearest."""

    name: str
    point: FloatArray
    at: tuple[float, float] | None
    scale: float
    equal: bool = True

    def _foot(self, state: State) -> FloatArray:
        return np.array([self.at]) if self.at is not None else projected(state.surface, self.point[None])

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return how far off the surface is, and the gradient: of a free foot only across the ways it may slide."""
        foot = self._foot(state)
        p = state.partials(foot[:, 0], foot[:, 1], 1)
        apart = (p[0, 0] - self.point) / self.scale
        keep = np.eye(3)
        if self.at is None:
            inside = [p[1 + axis, 0] for axis in (0, 1) if 0.0 < foot[0, axis] < 1.0]
            if inside:
                basis = np.linalg.svd(np.stack(inside), full_matrices=True)
                keep = basis[2][len(inside) :]
        unit = np.stack([state.pulled(foot[:, 0], foot[:, 1], axis[None, None])[0] for axis in keep])
        return keep @ apart, unit / self.scale

    def worst(self, state: State) -> Worst:
        """Return the distance."""
        foot = self._foot(state)
        apart = float(np.linalg.norm(state.partials(foot[:, 0], foot[:, 1], 0)[0] - self.point))
        return Worst(-apart / self.scale, apart, float(foot[0, 0]), float(foot[0, 1]))

    def exchange(self, state: State) -> bool:
        """Nothing is hidden from the search."""
        return False


@dataclass(eq=False)
class TangentPlane:
    """The normal (3,) that the tangent plane has at (u, v), whichever way the surface's own points."""

    name: str
    at: tuple[float, float]
    normal: FloatArray
    equal: bool = True

    @cached_property
    def _across(self) -> FloatArray:
        return np.linalg.svd(self.normal[None], full_matrices=True)[2][1:]

    def _unit(self, state: State) -> tuple[FloatArray, Any]:
        u, v = (np.array([x]) for x in self.at)
        at = forms(state.partials(u, v)[1:])
        return at.cross[0] / np.sqrt(at.area2[0]), at

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return n·a and n·b with a and b in the wanted plane, and their gradients."""
        u, v = (np.array([x]) for x in self.at)
        unit, at = self._unit(state)
        values = self._across @ unit
        nothing = np.zeros_like(at.area2)
        rows: list[FloatArray] = []
        for axis, value in zip(self._across, values, strict=True):
            cross = axis[None] / np.sqrt(at.area2)[:, None]
            gradient = pulled_back(at, nothing, nothing, -0.5 * value / at.area2, cross)
            rows.append(state.pulled(u, v, np.concatenate([np.zeros((1, 1, 3)), gradient]))[0])
        return values, np.stack(rows)

    def worst(self, state: State) -> Worst:
        """Return the angle between the planes, degrees."""
        unit, _ = self._unit(state)
        sine = float(np.linalg.norm(self._across @ unit))
        return Worst(-sine, float(np.degrees(np.arcsin(min(sine, 1.0)))), *self.at)

    def exchange(self, state: State) -> bool:
        """Nothing is hidden from the search."""
        return False


@dataclass(eq=False)
class Twist:
    """Normals turn by no more than ``angle`` degrees along any ruling, u = const: seen at ``count`` rulings."""

    name: str
    angle: float
    count: int = 33
    equal: bool = False

    def _ends(self, state: State, count: int) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        u = np.linspace(0.0, 1.0, count)
        first, second = (state.partials(u, np.full(count, end), 1) for end in (0.0, 1.0))
        return u, first, second, second[0] - first[0]

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return sin(angle) ∓ |R| det(A', B', R) / (|A' x R| |B' x R|), R = B - A, and the gradients."""
        u, first, second, r = self._ends(state, self.count)
        a, b = first[1], second[1]
        na, nb = (np.asarray(np.cross(one, r), dtype=np.float64) for one in (a, b))
        length = _norm(r)
        da, db = _norm(na), _norm(nb)
        tiny = np.finfo(float).tiny
        sine = length * _dot(np.asarray(np.cross(a, b), dtype=np.float64), r) / np.maximum(da * db, tiny)
        scale = (length / np.maximum(da * db, tiny))[:, None]
        back_a, back_b = (sine / np.maximum(d**2, tiny) for d in (da, db))
        by_a: FloatArray = scale * np.cross(b, r) - back_a[:, None] * np.cross(r, na)
        by_b: FloatArray = scale * np.cross(r, a) - back_b[:, None] * np.cross(r, nb)
        by_r: FloatArray = (
            scale * np.cross(a, b)
            + (sine / np.maximum(length**2, tiny))[:, None] * r
            - back_a[:, None] * np.cross(na, a)
            - back_b[:, None] * np.cross(nb, b)
        )
        zero: FloatArray = np.zeros_like(by_a)
        rows = state.pulled(u, np.zeros_like(u), np.stack([-by_r, by_a, zero])) + state.pulled(
            u, np.ones_like(u), np.stack([by_r, by_b, zero])
        )
        most = np.sin(np.radians(self.angle))
        return np.concatenate([most - sine, most + sine]) - MARGIN, np.concatenate([-rows, rows])

    def worst(self, state: State) -> Worst:
        """Return the largest angle that normals turn by along a ruling, degrees."""
        u, first, second, r = self._ends(state, 513)
        na, nb = np.cross(first[1], r), np.cross(second[1], r)
        turned = np.degrees(np.arctan2(_norm(np.cross(na, nb)), np.abs(_dot(na, nb))))
        index = int(turned.argmax())
        slack = float(np.sin(np.radians(self.angle)) - np.sin(np.radians(turned[index])))
        return Worst(slack, float(turned[index]), float(u[index]), None)

    def exchange(self, state: State) -> bool:
        """See more rulings where that is not met between them."""
        if self.worst(state).slack < 0.0 and self.count < 257:
            self.count = 2 * self.count - 1
            return True
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
        u, v = (part[self.seen] for part in _grid(_COARSE))
        at = forms(state.partials(u, v)[1:])
        nothing = np.zeros_like(at.area2)
        gradient = pulled_back(at, nothing, nothing, 1.0 / self.least[self.seen])
        full = np.concatenate([np.zeros((1, *gradient.shape[1:])), gradient])
        return at.area2 / self.least[self.seen] - _LEFT - MARGIN, state.pulled(u, v, full)

    def _left(self, state: State) -> FloatArray:
        return forms(state.partials(*_grid(_COARSE))[1:]).area2 / self.least - _LEFT

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
    p = surface.local_partials(*_grid(_COARSE), 1)
    area2 = (np.cross(p[1, 0], p[0, 1]) ** 2).sum(axis=-1)
    seen = (np.arange(0, _COARSE, 4)[:, None] * _COARSE + np.arange(0, _COARSE, 4)).ravel()
    return Regular(area2, seen) if area2.min() > 1e-6 * area2.mean() else None


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    return (a * b).sum(axis=-1)


def _norm(a: FloatArray) -> FloatArray:
    return np.sqrt(_dot(a, a))


@dataclass(eq=False)
class Problem:
    """The unknowns, what is minimised (an integral, nearness, or None: the least change), and the conditions.

    Searched are y (q,), with unknowns ``start`` + ``basis`` y: one step of size 1 changes the objective by about 1.
    """

    space: Unknowns
    objective: Integral | Near | None
    conditions: Sequence[Condition]
    basis: FloatArray
    scale: float

    def unknowns(self, y: FloatArray) -> FloatArray:
        """Return the unknowns of a place in the search."""
        return self.space.start + self.basis @ y

    def state(self, y: FloatArray) -> State:
        """Return the patch there."""
        return self.space.at(self.unknowns(y))

    def least(self, state: State, y: FloatArray) -> tuple[float, FloatArray]:
        """Return the objective, scaled, and its gradient by y."""
        if self.objective is None:
            return float(y @ y), 2.0 * y
        if isinstance(self.objective, Near):
            value, gradient = self.objective.mean_square(state, self.scale)
            return value, gradient @ self.basis
        value, gradient = self.objective.value(state)
        return value / self.scale, gradient @ self.basis / self.scale


def search_basis(space: Unknowns, smooth: bool) -> FloatArray:
    """Return steps of the unknowns (n, q): free coordinates by the root of an energy's form, parameters by ranges.

    ``smooth``: the form is the thin-plate energy's, with a little of the mean square change; else that alone.
    """
    count, free = space.coordinates, space.directions.shape[1]
    width = space.high - space.low
    basis: FloatArray = np.zeros((len(space.start), free + len(space.start) - count))
    basis[count:, free:] = np.diag(0.25 * width[count:])
    if not count:
        return basis
    if space.of is None:
        basis[:count, :free] = space.directions * 0.25 * width[0]
        return basis
    choice = space.directions
    forms_of = [quadratic(space.of, order).form[np.ix_(space.chosen, space.chosen)] for order in (2, 0)]
    plate, mass = (choice.T @ form @ choice for form in forms_of)
    plate, mass = (form / (np.trace(form) / free or 1.0) for form in (plate, mass))
    sizes, vectors = np.linalg.eigh(plate + 1e-5 * mass if smooth else mass)
    kept = sizes > 1e-9 * sizes[-1]  # a swept surface stands still where its curves shift against each other
    root = vectors[:, kept] / np.sqrt(sizes[kept])
    moves = choice @ root
    moves *= 0.1 * width[0] / float(np.median(np.abs(moves).max(axis=0)))
    return np.block([[moves, np.zeros((count, len(width) - count))], [np.zeros((len(width) - count, moves.shape[1])),
                     basis[count:, free:]]])  # fmt: skip
