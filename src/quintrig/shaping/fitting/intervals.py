"""How well shape parameters are determined: 95 % intervals by profiles over all of their ranges.

Near a fit the sum of squared distances is a parabola, and its curvature gives an interval. Farther away it may come
down again, since a net can take over much of what a shape parameter does. So each parameter is put to values all over
its range, from the fit outwards, and everything else is fitted anew from the value before: the points object to those
whose sum of squares is greater by more than 3.84 times the variance (Bates and Watts 1988, chapter 6), and by as much
as fits on the way were better than the fit itself, since so far none of them is at rest. What is left may be several
intervals, or most of the range: then the parameter is not determined, and that is said.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np

from quintrig.basis.formulas import Parameter
from quintrig.shaping.fitting import solve
from quintrig.shaping.fitting.forms import Form
from quintrig.shaping.fitting.result import ShapeValue
from quintrig.support.arrays import FloatArray

CHI = 3.84
"""Of 95 %, with one degree of freedom."""

T = TypeVar("T")

_NORMAL = 1.96
_GRID = 5  # values over the range of a parameter
_ROUNDS = 10
_BETTER = -30.0  # times the variance: a fit that is so much better is the fit
_STARTS, _APART = 4, 0.1  # fits that are looked for beside the best, and how far apart they begin, of a range
_ONE = 0.05  # of a range: intervals no farther apart are one
_UNDETERMINED = 0.5  # of a range that is left


def intervals(
    form: Form, few: solve.Data, many: solve.Data, state: solve.State
) -> tuple[tuple[ShapeValue, ...], solve.State | None]:
    """Return every shape parameter of a fit by ``many`` points with its intervals; profiles take ``few`` of them.

    A second value is a fit that was found to be better on the way, from which to start anew; None where there is none.
    """
    off, _ = solve.spread(form, many, state)
    few = solve.inner(form, few, state)
    best = solve.refined(form, few, replace(state, rms=np.inf), True, 15)
    variance = solve.variance(form, few, best)
    exact = 0.5 / len(few.points)
    least = best

    def at(k: int, value: float, near: solve.State) -> tuple[float, solve.State]:
        theta: FloatArray = near.theta.copy()
        theta[k] = value
        there = solve.refined(form, few, replace(near, theta=theta, rms=np.inf), True, _ROUNDS, exact, but=k)
        return float(few.weights.sum()) * (there.rms**2 - best.rms**2) / variance, there

    profiles: list[tuple[FloatArray, FloatArray]] = []
    tried: list[solve.State] = []
    for k, one in enumerate(form.ranges.values()):

        def fitted(wanted: float, near: solve.State, k: int = k) -> tuple[float, solve.State]:
            return at(k, wanted, near)

        values, grown, states = profile(one, float(state.theta[k]), float(off[k]), fitted, best)
        profiles.append((values, grown))
        tried += states[1:]
        least = min(least, *states, key=lambda one: one.rms)
    slack = max(0.0, -min(float(grown.min()) for _, grown in profiles))
    others: list[FloatArray] = []

    def found() -> tuple[ShapeValue, ...]:
        return tuple(
            told(label, one, value, std, *grown, slack, [other[k] for other in others])
            for k, ((label, one), value, std, grown) in enumerate(
                zip(form.ranges.items(), state.theta.tolist(), off.tolist(), profiles, strict=True)
            )
        )

    if any(one.determined for one in found()):  # narrow valleys lie between the values that were tried
        others += _others(form, few, best, tried, CHI + slack, variance)
    return found(), least if -slack < _BETTER else None


def _others(
    form: Form, data: solve.Data, best: solve.State, tried: list[solve.State], most: float, variance: float
) -> list[FloatArray]:
    """Return intervals (k, 2) of all shape parameters at other fits that are as good, from the best of those tried."""
    wide = np.array([one.high - one.low for one in form.ranges.values()])
    taken = [best.theta]
    found: list[FloatArray] = []
    for start in sorted(tried, key=lambda one: one.rms):
        if len(taken) > _STARTS:
            break
        if min(float((np.abs(start.theta - one) / wide).max()) for one in taken) < _APART:
            continue
        taken.append(start.theta)
        there = solve.refined(form, data, replace(start, rms=np.inf), True, 40, 0.1 / len(data.points))
        if float(data.weights.sum()) * (there.rms**2 - best.rms**2) / variance <= most:
            off, _ = solve.spread(form, data, there)
            found.append(np.stack([there.theta - _NORMAL * off, there.theta + _NORMAL * off], axis=1))
    return found


def profile(
    one: Parameter, value: float, std: float, fitted: Callable[[float, T], tuple[float, T]], best: T
) -> tuple[FloatArray, FloatArray, list[T]]:
    """Return values of a parameter, rising, how much the sum of squares grows by there, in variances, and the fits.

    ``fitted`` returns the growth at a value, and the fit there, from one near.
    """
    low, high = _inside(one, one.low), _inside(one, one.high)
    asked = np.concatenate([np.linspace(low, high, _GRID), value + std * _NORMAL * np.array([-2.0, -1.0, 1.0, 2.0])])
    asked = np.unique(asked[(asked >= low) & (asked <= high) & (np.abs(asked - value) > 1e-4 * (high - low))])
    values, grown = [value], [0.0]
    states = [best]
    for side in (asked[asked < value][::-1], asked[asked > value]):
        near = best
        for wanted in side.tolist():
            more, near = fitted(wanted, near)
            values.append(wanted)
            grown.append(more)
            states.append(near)
    order = np.argsort(values)
    return np.array(values)[order], np.array(grown)[order], states


def told(
    label: str,
    one: Parameter,
    value: float,
    std: float,
    values: FloatArray,
    grown: FloatArray,
    slack: float,
    others: Sequence[FloatArray] = (),
) -> ShapeValue:
    """Return a parameter with the intervals that its profile leaves, and those of ``others``, fits that are as good."""
    spans = list(accepted(values, grown, CHI + slack))
    for other in others:
        start, end = np.clip(other, one.low, one.high).tolist()
        spans.append((float(start), float(end)))
    apart = _ONE * (one.high - one.low)
    kept: list[tuple[float, float]] = []
    for start, end in sorted(spans):
        if kept and start <= kept[-1][1] + apart:
            kept[-1] = (kept[-1][0], max(kept[-1][1], end))
        else:
            kept.append((start, end))
    left = sum(end - start for start, end in kept)
    determined = left <= _UNDETERMINED * (one.high - one.low)
    return ShapeValue(label, value, std, kept[0][0], kept[-1][1], tuple(kept), determined)


def accepted(values: FloatArray, grown: FloatArray, most: float = CHI) -> tuple[tuple[float, float], ...]:
    """Return the intervals of rising ``values`` where the sum of squares grows by at most so many variances.

    Between two values the root of what it grows by is taken to be straight, as that of a parabola is.
    """
    root = np.sqrt(np.maximum(grown, 0.0))
    limit = np.sqrt(most)
    inside = root <= limit
    result: list[tuple[float, float]] = []
    start = 0
    while start < len(values):
        if not inside[start]:
            start += 1
            continue
        stop = start
        while stop + 1 < len(values) and inside[stop + 1]:
            stop += 1

        def end(own: int, beyond: int) -> float:
            if not 0 <= beyond < len(values):
                return float(values[own])
            share = (limit - root[own]) / (root[beyond] - root[own])
            return float(values[own] + share * (values[beyond] - values[own]))

        result.append((end(start, start - 1), end(stop, stop + 1)))
        start = stop + 1
    return tuple(result)


def _inside(one: Parameter, end: float) -> float:
    """Return an end of a range, or a value beside it where it does not belong to the range."""
    opened = one.open[0] if end == one.low else one.open[1]
    return end + (1e-4 * (one.high - one.low) if end == one.low else -1e-4 * (one.high - one.low)) * opened
