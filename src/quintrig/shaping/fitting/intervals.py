"""How well shape parameters are determined: 95 % intervals, by their profiles where points hardly tell values apart.

Near a fit the sum of squared distances is a parabola, and its curvature gives an interval. Farther away it may come
down again, since a net can take over much of what a shape parameter does. So the parameter is put to values farther
out, everything else is fitted anew, and the interval reaches as far as the points do not object (Bates and Watts 1988,
chapter 6): until the sum of squares has grown by 3.84 times the variance.
"""

from dataclasses import replace

import numpy as np

from quintrig.basis.formulas import Parameter
from quintrig.shaping.fitting import solve
from quintrig.shaping.fitting.forms import Form
from quintrig.shaping.fitting.result import ShapeValue
from quintrig.support.arrays import FloatArray

_NORMAL, _CHI = 1.96, 3.84  # of 95 %, with one degree of freedom
_ROUNDS = 15
_HALVINGS = 2


def intervals(form: Form, few: solve.Data, many: solve.Data, state: solve.State) -> tuple[ShapeValue, ...]:
    """Return every shape parameter of a fit by ``many`` points with its interval; profiles take ``few`` of them."""
    off, _ = solve.spread(form, many, state)
    best = solve.refined(form, few, replace(state, rms=np.inf), True, _ROUNDS)
    found: list[ShapeValue] = []
    for k, (label, one) in enumerate(form.ranges.items()):
        value, std = float(state.theta[k]), float(off[k])
        ends: list[float] = []
        for end, sign in ((one.low, -1.0), (one.high, 1.0)):
            near = float(np.clip(value + sign * _NORMAL * std, one.low, one.high))
            ends.append(_reached(form, few, best, k, near, _inside(one, end)))
        found.append(ShapeValue(label, value, std, min(ends), max(ends)))
    return tuple(found)


def _reached(form: Form, data: solve.Data, best: solve.State, k: int, near: float, end: float) -> float:
    """Return how far parameter ``k`` may go from ``near`` towards the end of its range before the points object."""
    if abs(end - near) < 1e-6:
        return near
    if not _objected(form, data, best, k, end):
        return end
    fine, wrong = near, end
    for _ in range(_HALVINGS):
        middle = 0.5 * (fine + wrong)
        if _objected(form, data, best, k, middle):
            wrong = middle
        else:
            fine = middle
    return fine


def _objected(form: Form, data: solve.Data, best: solve.State, k: int, value: float) -> bool:
    """Return whether the points speak against a value of a parameter, everything else fitted anew."""
    theta: FloatArray = best.theta.copy()
    theta[k] = value
    start = replace(best, theta=theta, rms=np.inf)
    there = solve.refined(form, data, start, True, _ROUNDS, but=k)
    count = len(data.points)
    freedom = max(count - len(best.q) - len(theta), 1)
    return count * (there.rms**2 - best.rms**2) > _CHI * max(count * best.rms**2 / freedom, 1e-28)


def _inside(one: Parameter, end: float) -> float:
    """Return an end of a range, or a value beside it where it does not belong to the range."""
    opened = one.open[0] if end == one.low else one.open[1]
    return end + (1e-4 * (one.high - one.low) if end == one.low else -1e-4 * (one.high - one.low)) * opened
