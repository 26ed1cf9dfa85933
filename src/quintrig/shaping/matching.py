"""Which points of two rails a ruling joins: those at which both have the same tangent plane, as far as there are such.

On a developable the normals at the two ends of a ruling agree, det(A'(s), B'(t), B(t) - A(s)) = 0 (Aumann 1991). Of all
ways t(s) that rise from one end of the second rail to the other, the one with the least twist is taken: first on a
grid, by dynamic programming, then among polynomials in Bernstein form whose coefficients rise, then at each ruling by
itself where the condition can be met.
"""

from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from typing import Any

import numpy as np

from quintrig.basis.bernstein import Bernstein
from quintrig.shaping.rails import Rail, spline
from quintrig.support.arrays import FloatArray

SITES = np.linspace(0.0, 1.0, 257)
"""Parameters on the first rail at which rulings are looked at."""

_GRID = 97  # rulings, and points of the second rail, in the first search
_STEEPEST = 5  # cells that t may rise by from one ruling to the next
_DEGREE = 14  # of t(s)
_SLOWEST = 0.1  # pace of t: where rulings fan out from one point, the patch would have no normal there
_SMOOTH = 1e-4  # of a smooth t(s), beside twist
_STEP = 1e-6  # of t, for derivatives by differences
_NONE = 1e-9  # radians: rulings along which the normal turns by less are those of a developable
_JUMPY = 1e-4  # second difference of t between rulings beyond which it is no longer smooth


@dataclass(frozen=True, eq=False)
class Pace:
    """The parameters ``t`` (n,) on the second rail that rulings join to ``SITES`` on the first; ``plain``: the same."""

    t: FloatArray
    plain: bool = False

    @cached_property
    def _spline(self) -> Any:
        return spline(SITES, self.t)

    def __call__(self, s: FloatArray) -> FloatArray:
        """Return t at parameters s (n,)."""
        return s if self.plain else np.clip(self._spline(s), 0.0, 1.0)

    def slope(self, s: FloatArray) -> FloatArray:
        """Return dt/ds at parameters s (n,)."""
        return np.ones_like(s) if self.plain else np.asarray(self._spline(s, 1), dtype=np.float64)

    def inverse(self, t: FloatArray) -> FloatArray:
        """Return the s whose ruling ends at t (n,)."""
        if self.plain:
            return t
        s = np.interp(t, self.t, SITES)
        for _ in range(4):
            s = np.clip(s - (self(s) - t) / np.maximum(self.slope(s), 1e-3), 0.0, 1.0)
        return s


def turns(first: FloatArray, second: FloatArray) -> FloatArray:
    """Return by how much normals turn along rulings between points with derivatives (2, n, 3), radians with sign."""
    r = second[0] - first[0]
    length = np.linalg.norm(r, axis=-1)
    sine = length * (np.cross(first[1], second[1]) * r).sum(axis=-1)
    cosine = (np.cross(first[1], r) * np.cross(second[1], r)).sum(axis=-1)
    return np.arctan2(sine, cosine)


def rising(x: FloatArray, functions: FloatArray) -> FloatArray:
    """Return t that rises from 0 to 1 by numbers x (14,) that nothing holds; ``functions`` are of Bernstein form."""
    steps = np.exp(x - x.max())
    rise = _SLOWEST / _DEGREE + (1.0 - _SLOWEST) * steps / steps.sum()
    return np.clip(functions @ np.concatenate([[0.0], np.cumsum(rise)]), 0.0, 1.0)


def rising_slopes(x: FloatArray, functions: FloatArray) -> FloatArray:
    """Return the derivatives (n, 14) of what ``rising`` returns, by its numbers."""
    share = np.exp(x - x.max())
    share /= share.sum()
    onward = np.cumsum(functions[:, :0:-1], axis=1)[:, ::-1]  # each rise moves all coefficients after it
    return (1.0 - _SLOWEST) * (onward * share - (onward @ share)[:, None] * share)


def functions_at(s: FloatArray) -> FloatArray:
    """Return the functions (n, 15) that ``rising`` takes."""
    return Bernstein(_DEGREE).derivatives(s, 0)[0]


def matched(first: Rail, second: Rail, names: str = "first, second") -> Pace:
    """Return how rulings join two rails that run the same way; ValueError where they meet."""
    refuse_meeting(first, second, names)
    a = first.derivatives(SITES)
    if np.abs(turns(a, second.derivatives(SITES))).max() <= _NONE:
        return Pace(SITES, plain=True)
    rough = _searched(first, second)
    functions = functions_at(SITES)

    def residual(x: FloatArray) -> FloatArray:
        return np.concatenate([turns(a, second.derivatives(rising(x, functions))), 1e-5 * np.diff(x)])

    def slopes(x: FloatArray) -> FloatArray:
        t = rising(x, functions)
        low, high = np.clip(t - _STEP, 0.0, 1.0), np.clip(t + _STEP, 0.0, 1.0)
        rate = (turns(a, second.derivatives(high)) - turns(a, second.derivatives(low))) / (high - low)
        return np.concatenate([rate[:, None] * rising_slopes(x, functions), 1e-5 * np.diff(np.eye(_DEGREE), axis=0)])

    best: Any = None
    for start in (np.log(np.maximum(np.diff(rough), 1e-3)), np.zeros(_DEGREE)):  # a constant is taken out by the sum
        done = import_module("scipy.optimize").least_squares(
            residual, start, slopes, xtol=1e-12, ftol=1e-12, max_nfev=200
        )
        best = done if best is None or done.cost < best.cost else best
    t = rising(np.asarray(best.x, dtype=np.float64), functions)
    return Pace(_met(a, second, t))


def refuse_meeting(first: Rail, second: Rail, names: str) -> None:
    """Raise ValueError for rails that meet."""
    grid = np.linspace(0.0, 1.0, _GRID)
    a, b = first(grid), second(grid)
    span = max(float(np.ptp(part, axis=0).max()) for part in (a, b))
    if np.linalg.norm(a[:, None] - b, axis=-1).min() <= 1e-9 * span:
        raise ValueError(f"{names}: the curves meet, and rulings there have no length; cut them off before")


def _searched(first: Rail, second: Rail) -> FloatArray:
    """Return t at 15 parameters of the first rail, from a grid."""
    grid = np.linspace(0.0, 1.0, _GRID)
    a, b = first.derivatives(grid), second.derivatives(grid)
    cost = turns(a[:, :, None], b[:, None, :]) ** 2
    total: FloatArray = np.full((_GRID, _GRID), np.inf)
    came = np.zeros((_GRID, _GRID), dtype=np.int64)
    total[0, 0] = cost[0, 0]
    for i in range(1, _GRID):
        for step in range(_STEEPEST + 1):
            before = np.full(_GRID, np.inf)
            before[step:] = total[i - 1, : _GRID - step] + _SMOOTH * (step - 1) ** 2
            better = before < total[i]
            total[i][better], came[i][better] = before[better], step
        total[i] += cost[i]
    path = np.zeros(_GRID)
    j = _GRID - 1
    for i in range(_GRID - 1, -1, -1):
        path[i] = j
        j -= came[i, j]
    return np.interp(np.linspace(0.0, 1.0, _DEGREE + 1), grid, path / (_GRID - 1))


def _met(a: FloatArray, second: Rail, t: FloatArray) -> FloatArray:
    """Return t at which the condition is met at every ruling, by Newton's steps; ``t`` itself where it cannot be."""
    at = t.copy()
    for _ in range(12):
        here = turns(a, second.derivatives(at))
        low, high = np.clip(at - _STEP, 0.0, 1.0), np.clip(at + _STEP, 0.0, 1.0)
        slope = (turns(a, second.derivatives(high)) - turns(a, second.derivatives(low))) / (high - low)
        step = np.divide(here, slope, out=np.zeros_like(here), where=np.abs(slope) > 1e-6)
        at = np.clip(at - np.clip(step, -0.01, 0.01), 0.0, 1.0)
    at[[0, -1]] = 0.0, 1.0
    smooth = np.abs(np.diff(at, 2)).max() <= 3.0 * np.abs(np.diff(t, 2)).max() + _JUMPY
    met = np.abs(turns(a, second.derivatives(at))).max() <= 1e-7
    return at if met and smooth and (np.diff(at) > 0.0).all() else t
