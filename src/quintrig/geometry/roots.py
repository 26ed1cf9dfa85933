"""All roots of a smooth function on [0, 1]: isolated by sampling, refined inside their brackets."""

from collections.abc import Callable
from typing import Any, cast

import numpy as np

from quintrig.support.arrays import BoolArray, FloatArray

_SAMPLES = 2049
_TOUCH = 1e-12  # a root without change of sign: share of the largest value below which a lowest one is rounding

_STEEP = 16.0  # times that change


def roots(function: Callable[[FloatArray], FloatArray], samples: int = _SAMPLES) -> FloatArray:
    """Return the roots on [0, 1] in order, double ones once; none where the function vanishes throughout.

    Signs at ``samples`` points isolate simple roots; between them every lowest |value| is refined, so that two roots
    closer than the samples, and one that only touches zero, are found as well.
    """
    t = np.linspace(0.0, 1.0, samples)
    values = function(t)
    scale = float(np.abs(values[np.isfinite(values)]).max(initial=0.0))
    if not scale > 0.0:
        return np.empty(0)

    def at(x: float) -> float:
        return float(function(np.array([x]))[0])

    zero = np.abs(values) <= 1e-15 * scale
    # A function that vanishes at whole stretches of samples has no roots to tell apart there.
    found = [float(x) for x in t[zero & ~(np.roll(zero, 1) & np.roll(zero, -1))]]
    found += [x for i in np.flatnonzero(zero) for x in _beside(at, t, zero, values, int(i))]
    change = (values[:-1] * values[1:] < 0.0) & ~zero[:-1] & ~zero[1:]
    found += [_root(at, t[i], t[i + 1]) for i in np.flatnonzero(change)]
    size = np.abs(values)
    low = (size[1:-1] <= size[:-2]) & (size[1:-1] <= size[2:]) & ~zero[:-2] & ~zero[1:-1] & ~zero[2:]
    # One that lies far above what it changes by from sample to sample, as rounding of a constant does, meets no zero.
    low &= size[1:-1] <= _STEEP * (size[:-2] + size[2:] - 2.0 * size[1:-1])
    same = (values[:-2] * values[1:-1] > 0.0) & (values[1:-1] * values[2:] > 0.0)
    for i in np.flatnonzero(low & same) + 1:
        found += _touching(at, t[i - 1], t[i + 1], float(np.sign(values[i])), _TOUCH * scale)
    return _distinct(np.array(sorted(found)))


def _beside(
    at: Callable[[float], float], t: FloatArray, zero: BoolArray, values: FloatArray, index: int
) -> list[float]:
    """Return the roots between a sample that is a root itself and its neighbours."""
    found: list[float] = []
    for other in (index - 1, index + 1):
        if 0 <= other < len(t) and not zero[other]:
            near = float(t[index] + 1e-4 * (t[other] - t[index]))
            if at(near) * values[other] < 0.0:
                found.append(_root(at, near, float(t[other])))
    return found


def _touching(at: Callable[[float], float], low: float, high: float, sign: float, small: float) -> list[float]:
    """Return the roots, none, one or two, about the lowest |value| between two parameters of one sign."""
    from scipy import optimize

    def height(x: float) -> float:
        return sign * at(x)

    best = cast(Any, optimize).minimize_scalar(height, bounds=(low, high), method="bounded", options={"xatol": 1e-12})
    middle, value = float(best.x), float(best.fun)
    if value < -small:
        return [_root(at, low, middle), _root(at, middle, high)]
    return [middle] if value <= small else []


def _root(at: Callable[[float], float], low: float, high: float) -> float:
    from scipy import optimize

    ends = at(low), at(high)
    if ends[0] * ends[1] >= 0.0:  # one of them is zero, or rounding of it with another sign than in the samples
        return low if abs(ends[0]) <= abs(ends[1]) else high
    return float(cast(Any, optimize).brentq(at, low, high, xtol=1e-16, rtol=8.9e-16))


def _distinct(found: FloatArray) -> FloatArray:
    return found[np.concatenate([[True], np.diff(found) > 1e-9])] if found.size else found
