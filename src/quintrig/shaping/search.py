"""The search of a design: SLSQP (Kraft 1988, in SciPy) on points where demands fail, which an exchange adds.

A round solves the problem with the conditions at the points seen so far; then the points of the grid where one fails
worst are added, until none does (the exchange method for semi-infinite programs; Hettich and Kortanek 1993). Where a
round finds nothing that meets all, an elastic one makes the sum of what is missed least, a slack for each condition.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from quintrig.shaping.conditions import MARGIN, Condition
from quintrig.shaping.problem import Problem
from quintrig.shaping.unknowns import State
from quintrig.support.arrays import FloatArray

_ROUNDS = 14
_STEPS = 100  # of one round
_FARTHEST = 6.0  # of one call in each direction: curvature is far from linear
_RANGES = 6  # times that ends of ranges are added to what SLSQP sees
_ENOUGH = 1e-8  # of the objective, scaled
_BAD = 1e6  # in place of what is not finite
_OFF = 10.0 * MARGIN
"""What is missed by more than this, scaled, is not met."""


@dataclass(frozen=True, eq=False)
class Found:
    """Where a search ended: y (q,), the objective there, scaled, and the most that a condition is missed by."""

    y: FloatArray
    least: float
    missed: float

    def better(self, other: "Found | None") -> bool:
        """Return whether this one is to be had rather than another: it misses less, or has less of the objective."""
        if other is None:
            return True
        met, also = self.missed <= _OFF, other.missed <= _OFF
        if met != also:
            return met
        return self.least < other.least if met else self.missed < other.missed


@dataclass(eq=False)
class _At:
    """Objective and conditions at a place, worked out once for the functions that SLSQP calls one by one."""

    problem: Problem
    conditions: Sequence[Condition]
    y: FloatArray | None = None
    state: State | None = None
    least: tuple[float, FloatArray] = (0.0, np.zeros(0))
    values: tuple[FloatArray, ...] = ()
    rows: tuple[FloatArray, ...] = ()

    def __call__(self, y: FloatArray) -> "_At":
        if self.y is not None and np.array_equal(y, self.y):
            return self
        self.y = y.copy()
        with np.errstate(all="ignore"):
            try:
                state = self.problem.state(y)
                value, gradient = self.problem.least(state, y)
                self.least = (value if np.isfinite(value) else _BAD, np.nan_to_num(gradient, posinf=0.0, neginf=0.0))
                found = [one.values(state) for one in self.conditions]
            except (ValueError, ArithmeticError):  # a step to where there is no surface
                self.least = (_BAD, np.zeros_like(y))
                if not self.values:
                    self.values = tuple(np.array([-_BAD]) for _ in self.conditions)
                    self.rows = tuple(np.zeros((1, len(y))) for _ in self.conditions)
                self.values = tuple(np.full_like(part, -_BAD) for part in self.values)
                return self
        self.values = tuple(np.nan_to_num(part, nan=-_BAD, posinf=_BAD, neginf=-_BAD) for part, _ in found)
        rows = [part @ self.problem.basis for _, part in found]
        self.rows = tuple(np.nan_to_num(part, posinf=0.0, neginf=0.0) for part in rows)
        return self


@dataclass(eq=False)
class Search:
    """A search of one problem; ``told`` is called before every round, and may stop it by raising."""

    problem: Problem
    told: Callable[[Found], None] = lambda found: None

    def run(self, y: FloatArray, conditions: Sequence[Condition] | None = None) -> Found:
        """Return the best design found from a start: what meets all conditions, or misses least."""
        conditions = self.problem.conditions if conditions is None else conditions
        best = self.judged(y, conditions)
        for _ in range(_ROUNDS):
            y = self._eased(y, conditions)
            possible = self._missing(y, conditions) <= _OFF
            if possible:
                further = self._solve(y, conditions, elastic=False)
                y = further if self._missing(further, conditions) <= _OFF else y
            found = self.judged(y, conditions)
            best = found if found.better(best) else best
            self.told(best)
            if not self._exchange(y, conditions) or not possible:
                break
        return best

    def _eased(self, y: FloatArray, conditions: Sequence[Condition]) -> FloatArray:
        """Return what misses less, from here or, where that is a hilltop of what is missed, from beside it."""
        missed = self._missing(y, conditions)
        for attempt in range(2):
            if missed <= _OFF:
                break
            beside = y + attempt * 0.1 * np.random.default_rng(attempt).normal(size=len(y))
            found = self._solve(self._inside(beside, y, *self._ends()), conditions, elastic=True)
            now = self._missing(found, conditions)
            y, missed = (found, now) if now < missed else (y, missed)
        return y

    def _missing(self, y: FloatArray, conditions: Sequence[Condition]) -> float:
        """Return the most that a condition is missed by at the points that the search sees."""
        values = _At(self.problem, conditions)(y).values
        return max((_missed(part, one) for part, one in zip(values, conditions, strict=True)), default=0.0)

    def compromise(self, y: FloatArray, conditions: Sequence[Condition]) -> Found:
        """Return the design that misses as little as can be, in sum over the conditions."""
        found = self.judged(y, conditions)
        for _ in range(_ROUNDS):
            y = self._eased(y, conditions)
            found = self.judged(y, conditions)
            if found.missed <= _OFF or not self._exchange(y, conditions):
                break
        return found

    def judged(self, y: FloatArray, conditions: Sequence[Condition]) -> Found:
        """Return what a place comes to on the whole grid."""
        with np.errstate(all="ignore"):
            try:
                state = self.problem.state(y)
                missed = max((-one.worst(state).slack for one in conditions), default=0.0)
                value = self.problem.least(state, y)[0]
            except (ValueError, ArithmeticError):
                return Found(y, np.inf, np.inf)
        fine = np.isfinite(value) and np.isfinite(missed)
        return Found(y, value if fine else np.inf, max(missed, 0.0) if fine else np.inf)

    def _exchange(self, y: FloatArray, conditions: Sequence[Condition]) -> bool:
        try:
            with np.errstate(all="ignore"):
                state = self.problem.state(y)
                found = [one.exchange(state) for one in conditions]  # all of them, whatever the first one says
                return any(found)
        except (ValueError, ArithmeticError):
            return False

    def _solve(self, y: FloatArray, conditions: Sequence[Condition], *, elastic: bool) -> FloatArray:
        """Return where SLSQP goes from here; ends of ranges that it would leave are added until it leaves none."""
        count = len(self.problem.space.start)
        parameters = np.arange(self.problem.space.coordinates, count)
        ends = np.concatenate([parameters, parameters + count])
        rows, edges = self._ends()
        at = _At(self.problem, conditions)
        x = y
        for _ in range(_RANGES):
            x = self._stepped(at, x, conditions, rows[ends], edges[ends], elastic)
            left = np.flatnonzero(rows @ x + edges < -1e-9)
            if not len(left):
                return x
            ends = np.union1d(ends, left)
            x = self._inside(x, y, rows, edges)
        return x

    def _ends(self) -> tuple[FloatArray, FloatArray]:
        """Return rows and constants of what is 0 or more in the ranges: low ends, then high ones, as shares of them."""
        space, basis = self.problem.space, self.problem.basis
        width = np.tile(space.high - space.low, 2)
        edges = np.concatenate([space.start - space.low, space.high - space.start])
        return np.concatenate([basis, -basis]) / width[:, None], edges / width

    def _stepped(
        self,
        at: "_At",
        y: FloatArray,
        conditions: Sequence[Condition],
        limits: FloatArray,
        edges: FloatArray,
        elastic: bool,
    ) -> FloatArray:
        """Return what one call of SLSQP gives, with a slack t >= 0 for each condition in the elastic case."""
        count = len(y)
        slacks = len(conditions) if elastic else 0
        first = at(y).values

        def parted(x: FloatArray) -> tuple[FloatArray, FloatArray]:
            """Return all that is to be 0 or more, and its derivatives."""
            here = at(x[:count])
            values, rows = [limits @ x[:count] + edges], [_wide(limits, slacks)]
            for index, (one, value, row) in enumerate(zip(conditions, here.values, here.rows, strict=True)):
                if one.equal and not elastic:
                    continue
                for sign in (1.0, -1.0) if one.equal else (1.0,):
                    values.append(sign * value + (x[count + index] if elastic else 0.0))
                    rows.append(_wide(sign * row, slacks, index))
            return np.concatenate(values), np.concatenate(rows)

        def equal(x: FloatArray) -> tuple[FloatArray, FloatArray]:
            here = at(x[:count])
            which = [index for index, one in enumerate(conditions) if one.equal]
            return np.concatenate([here.values[k] for k in which]), np.concatenate([here.rows[k] for k in which])

        def objective(x: FloatArray) -> tuple[float, FloatArray]:
            if not elastic:
                return at(x[:count]).least
            near = x[:count] - y
            value = float(x[count:].sum() + 0.5e-6 * near @ near)
            return value, np.concatenate([1e-6 * near, np.ones(slacks)])

        constraints: list[dict[str, Any]] = [_constraint("ineq", parted)]
        if not elastic and any(one.equal for one in conditions):
            constraints.append(_constraint("eq", equal))
        missing = [_missed(part, one) for part, one in zip(first, conditions, strict=True)] if elastic else []
        done = _minimize()(
            objective,
            np.concatenate([y, missing]),
            jac=True,
            method="SLSQP",
            bounds=[*((at - _FARTHEST, at + _FARTHEST) for at in y.tolist()), *[(0.0, None)] * slacks],
            constraints=constraints,
            options={"maxiter": _STEPS, "ftol": _ENOUGH},
        )
        x = np.asarray(done.x, dtype=np.float64)[:count]
        return x if np.isfinite(x).all() else y

    def _inside(self, x: FloatArray, y: FloatArray, rows: FloatArray, edges: FloatArray) -> FloatArray:
        """Return the last place on the way from y to x that is in the ranges."""
        here, step = rows @ y + edges, rows @ (x - y)
        falling = step < -1e-15
        share = float((np.maximum(here[falling], 0.0) / -step[falling]).min(initial=1.0))
        return y + share * (x - y)


def _constraint(kind: str, both: Callable[[FloatArray], tuple[FloatArray, FloatArray]]) -> dict[str, Any]:
    def values(x: FloatArray) -> FloatArray:
        return both(x)[0]

    def rows(x: FloatArray) -> FloatArray:
        return both(x)[1]

    return {"type": kind, "fun": values, "jac": rows}


def _wide(rows: FloatArray, slacks: int, owner: int | None = None) -> FloatArray:
    """Return rows with columns for the slacks, 1 in that of the owner."""
    added = np.zeros((len(rows), slacks))
    if owner is not None and slacks:
        added[:, owner] = 1.0
    return np.hstack([rows, added])


def _missed(values: FloatArray, one: Condition) -> float:
    return float(max((np.abs(values) if one.equal else -values).max(initial=0.0), 0.0))


def contradiction(
    search: Search, y: FloatArray, conditions: Sequence[Condition], always: Sequence[Condition] = ()
) -> tuple[Condition, ...]:
    """Return conditions that contradict each other, none of which can be left out (deletion filter; Chinneck 2008)."""
    kept = list(conditions)
    for one in conditions:
        fewer = [other for other in kept if other is not one]
        if fewer and search.compromise(y, [*fewer, *always]).missed > _OFF:
            kept = fewer
    return tuple(kept)


def met(missed: float) -> bool:
    """Return whether what is missed, scaled, is no more than the search's own accuracy."""
    return missed <= _OFF


def _minimize() -> Any:
    return import_module("scipy.optimize").minimize  # takes long; its types are open
