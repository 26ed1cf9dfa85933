"""Conditions at places of a surface, with exact gradients: points it is near or passes, tangent planes, rulings."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quintrig.geometry.closest_point import projected, refined
from quintrig.geometry.surface import Surface
from quintrig.shaping.conditions import MARGIN, Worst, grid_points
from quintrig.shaping.forms import Forms, forms, pulled_back
from quintrig.shaping.unknowns import State
from quintrig.support.arrays import FloatArray

_RULINGS = 513  # at which normals are looked at
_MOST_TARGETS = 400  # points of a target that the search sees from the start


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
    feet = np.stack(grid_points(33), axis=-1)
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

    def _unit(self, state: State) -> tuple[FloatArray, Forms]:
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


_SPARE = 2e-5  # of the sine of a turn: more than the search is off, so that the angle asked for is kept


@dataclass(eq=False)
class Twist:
    """Normals turn by at most ``angle`` degrees along any ruling, u = const: seen at the rulings ``seen`` of 513."""

    name: str
    angle: float
    seen: NDArray[np.int64] = field(default_factory=lambda: np.arange(0, _RULINGS, 16))
    equal: bool = False

    def _ends(
        self, state: State, which: NDArray[np.int64] | slice
    ) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        u: FloatArray = np.linspace(0.0, 1.0, _RULINGS)[which]
        first, second = (state.partials(u, np.full_like(u, end), 1) for end in (0.0, 1.0))
        return u, first, second, second[0] - first[0]

    def values(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Return sin(angle) ∓ |R| det(A', B', R) / (|A' x R| |B' x R|), R = B - A, and the gradients."""
        u, first, second, r = self._ends(state, self.seen)
        a, b = first[1], second[1]
        na, nb = (_cross(one, r) for one in (a, b))
        length = _norm(r)
        da, db = _norm(na), _norm(nb)
        tiny = np.finfo(float).tiny
        sine = length * _dot(_cross(a, b), r) / np.maximum(da * db, tiny)
        scale = (length / np.maximum(da * db, tiny))[:, None]
        back_a, back_b = (sine / np.maximum(d**2, tiny) for d in (da, db))
        by_a: FloatArray = scale * _cross(b, r) - back_a[:, None] * _cross(r, na)
        by_b: FloatArray = scale * _cross(r, a) - back_b[:, None] * _cross(r, nb)
        by_r: FloatArray = (
            scale * _cross(a, b)
            + (sine / np.maximum(length**2, tiny))[:, None] * r
            - back_a[:, None] * _cross(na, a)
            - back_b[:, None] * _cross(nb, b)
        )
        zero: FloatArray = np.zeros_like(by_a)
        rows = state.pulled(u, np.zeros_like(u), np.stack([-by_r, by_a, zero])) + state.pulled(
            u, np.ones_like(u), np.stack([by_r, by_b, zero])
        )
        most = np.sin(np.radians(self.angle))
        most -= min(_SPARE, 0.02 * most)
        return np.concatenate([most - sine, most + sine]), np.concatenate([-rows, rows])

    def _turned(self, state: State) -> FloatArray:
        """Return by how much normals turn along each ruling, degrees."""
        _, first, second, r = self._ends(state, slice(None))
        na, nb = _cross(first[1], r), _cross(second[1], r)
        return np.degrees(np.arctan2(_norm(_cross(na, nb)), np.abs(_dot(na, nb))))

    def worst(self, state: State) -> Worst:
        """Return the largest angle that normals turn by along a ruling, degrees."""
        turned = self._turned(state)
        index = int(turned.argmax())
        most = float(np.sin(np.radians(self.angle)))  # by which it is measured: 1e-5 is much beside a small angle
        slack = (most - float(np.sin(np.radians(turned[index])))) / max(most, 0.01)
        return Worst(slack, float(turned[index]), index / (_RULINGS - 1), None)

    def exchange(self, state: State) -> bool:
        """Add the worst ruling of each part of the strip where normals turn by more."""
        turned = self._turned(state)
        parts = np.array_split(np.arange(_RULINGS), 32)
        worst = np.array([part[int(turned[part].argmax())] for part in parts])
        fresh = np.setdiff1d(worst[turned[worst] > self.angle * (1.0 - MARGIN)], self.seen)
        self.seen = np.concatenate([self.seen, fresh])
        return bool(len(fresh))


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    return (a * b).sum(axis=-1)


def _norm(a: FloatArray) -> FloatArray:
    return np.sqrt(_dot(a, a))


def _cross(a: FloatArray, b: FloatArray) -> FloatArray:
    return np.asarray(np.cross(a, b), dtype=np.float64)
