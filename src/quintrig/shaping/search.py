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

from quintrig.shaping.problem import MARGIN, Condition, Problem
from quintrig.shaping.unknowns import State
from quintrig.support.arrays import FloatArray

_ROUNDS = 14
_STEPS = 150  # of one round
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
            y = self._solve(y, conditions, elastic=False)
            found = self.judged(y, conditions)
            if found.missed > _OFF:
                seen = self._exchange(y, conditions)
                y = self._solve(y, conditions, elastic=True)
                if self.judged(y, conditions).missed <= _OFF:
                    y = self._solve(y, conditions, elastic=False)
                found = self.judged(y, conditions)
                if found.missed > _OFF and not seen and not self._exchange(y, conditions):
                    best = found if found.better(best) else best
                    break
            if found.better(best) or (best.missed <= _OFF) != (found.missed <= _OFF):
                best = found if found.better(best) else best
            self.told(best)
            if not self._exchange(y, conditions):
                break
        return best

    def compromise(self, y: FloatArray, conditions: Sequence[Condition]) -> Found:
        """Return the design that misses as little as can be, in sum over the conditions."""
        found = self.judged(y, conditions)
        for _ in range(_ROUNDS // 2):
            y = self._solve(y, conditions, elastic=True)
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
                return any([one.exchange(state) for one in conditions])
        except (ValueError, ArithmeticError):
            return False

    def _solve(self, y: FloatArray, conditions: Sequence[Condition], *, elastic: bool) -> FloatArray:
        """Return where SLSQP goes from here, with a slack t >= 0 for each condition in the elastic case."""
        at = _At(self.problem, conditions)
        space, count = self.problem.space, len(y)
        slacks = len(conditions) if elastic else 0
        first = at(y)
        owners = [np.full(len(part), index) for index, part in enumerate(first.values)]
        limits = np.concatenate([self.problem.basis, -self.problem.basis])
        edges = np.concatenate([space.start - space.low, space.high - space.start])
        width = np.tile(space.high - space.low, 2)

        def values(x: FloatArray, equal: bool, sign: float = 1.0) -> FloatArray:
            found = at(x[:count]).values
            parts = [
                sign * part + (x[count + index] if elastic else 0.0)
                for index, (part, one) in enumerate(zip(found, conditions, strict=True))
                if one.equal == equal
            ]
            return np.concatenate([*parts, np.zeros(0)])

        def rows(x: FloatArray, equal: bool, sign: float = 1.0) -> FloatArray:
            found = at(x[:count]).rows
            parts = [
                np.hstack([sign * part, _ones(owners[index], slacks)])
                for index, (part, one) in enumerate(zip(found, conditions, strict=True))
                if one.equal == equal
            ]
            return np.concatenate([*parts, np.zeros((0, count + slacks))])

        def objective(x: FloatArray) -> tuple[float, FloatArray]:
            value, gradient = at(x[:count]).least
            if not elastic:
                return value, gradient
            near = 1e-6 * (x[:count] - y)
            return (
                float(x[count:].sum() + 0.5 * near @ (x[:count] - y)),
                np.concatenate([near, np.ones(slacks)]),
            )

        def bounds(x: FloatArray) -> FloatArray:
            return np.concatenate([(limits @ x[:count] + edges) / width, x[count:]])

        bound_rows = np.vstack(
            [
                np.hstack([limits / width[:, None], np.zeros((len(limits), slacks))]),
                np.hstack([np.zeros((slacks, count)), np.eye(slacks)]),
            ]
        )
        constraints: list[dict[str, Any]] = [{"type": "ineq", "fun": bounds, "jac": lambda x: bound_rows}]

        def add(kind: str, equal: bool, sign: float) -> None:
            constraints.append(
                {"type": kind, "fun": lambda x: values(x, equal, sign), "jac": lambda x: rows(x, equal, sign)}
            )

        if any(not one.equal for one in conditions):
            add("ineq", False, 1.0)
        if any(one.equal for one in conditions):
            for kind, sign in (("ineq", 1.0), ("ineq", -1.0)) if elastic else (("eq", 1.0),):
                add(kind, True, sign)
        start = np.concatenate([y, [_missed(part, one) for part, one in zip(first.values, conditions, strict=True)]]) \
            if elastic else y  # fmt: skip
        done = _minimize()(
            objective,
            start,
            jac=True,
            method="SLSQP",
            constraints=constraints,
            options={"maxiter": _STEPS, "ftol": 1e-10},
        )
        x = np.asarray(done.x, dtype=np.float64)[:count]
        if not np.isfinite(x).all():
            return y
        unknown = self.problem.unknowns(x)
        over = np.maximum(space.low - unknown, unknown - space.high) / (space.high - space.low)
        return x if over.max(initial=0.0) <= 1e-9 else self._inside(x, y)

    def _inside(self, x: FloatArray, y: FloatArray) -> FloatArray:
        """Return the last place on the way to x that is in the ranges."""
        space, share = self.problem.space, 1.0
        here, step = self.problem.unknowns(y), self.problem.basis @ (x - y)
        for at, move, low, high in zip(here, step, space.low, space.high, strict=True):
            end = high if move > 0.0 else low
            if (at + move - end) * np.sign(move) > 0.0:
                share = min(share, max((end - at) / move, 0.0))
        return y + share * (x - y)


def _ones(owner: FloatArray, slacks: int) -> FloatArray:
    return (owner[:, None] == np.arange(slacks)).astype(np.float64)


def _missed(values: FloatArray, one: Condition) -> float:
    return float(max((np.abs(values) if one.equal else -values).max(initial=0.0), 0.0))


def contradiction(search: Search, y: FloatArray, conditions: Sequence[Condition]) -> tuple[Condition, ...]:
    """Return conditions that contradict each other, none of which may be left out (a deletion filter; Chinneck 2008)."""
    kept = list(conditions)
    for one in conditions:
        fewer = [other for other in kept if other is not one]
        if fewer and search.compromise(y, fewer).missed > _OFF:
            kept = fewer
    return tuple(kept)


def met(missed: float) -> bool:
    """Return whether what is missed, scaled, is no more than the search's own accuracy."""
    return missed <= _OFF


def _minimize() -> Any:
    return import_module("scipy.optimize").minimize  # takes long; its types are open
