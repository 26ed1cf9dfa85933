"""Intervals of curvature from intervals of its forms: quotients and roots, rounded outwards."""

import numpy as np

from quintrig.support.arrays import FloatArray

Interval = tuple[FloatArray, FloatArray]

_SLACK, _LEAST = 2.0**-49, 1e-307
"""More than the rounding of a few operations, relative to what they give, and where that underflows."""


def outward(low: FloatArray, high: FloatArray) -> Interval:
    """Return an interval somewhat larger: by more than a few roundings. An end that is 0 was not rounded."""
    with np.errstate(invalid="ignore"):
        return _outward(low, high)


def _outward(low: FloatArray, high: FloatArray) -> Interval:
    below = np.where(np.isfinite(low), low - (_SLACK * np.abs(low) + _LEAST) * (low != 0.0), low)
    above = np.where(np.isfinite(high), high + (_SLACK * np.abs(high) + _LEAST) * (high != 0.0), high)
    return below, above


def sign(low: FloatArray, high: FloatArray, form: int = 0) -> Interval:
    """Return bounds of a form in each box, from those of its coefficients (boxes, forms, n, m)."""
    return low[:, form].min(axis=(1, 2)), high[:, form].max(axis=(1, 2))


def quotient(top: Interval, bottom: Interval) -> Interval:
    """Return bounds, for each box, of Σ n_k B_k / Σ d_k B_k, d_k >= 0: the least and the greatest n_k / d_k.

    Without any bound where a d_k may be negative. Where it may be 0, a bound is kept if n_k has the sign for it.
    """
    (low, high), (least, most) = top, bottom
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        below = np.where(low >= 0.0, low / most, low / least)
        above = np.where(high <= 0.0, high / most, high / least)
    # 0 / 0 says nothing, and neither does a coefficient that both bounds leave open.
    below = np.where((low >= 0.0) & ~(below > 0.0), np.where((most <= 0.0) & (high <= 0.0), np.inf, 0.0), below)
    above = np.where((high <= 0.0) & ~(above < 0.0), np.where((most <= 0.0) & (low >= 0.0), -np.inf, 0.0), above)
    below = np.where((low < 0.0) & (least <= 0.0), -np.inf, below)
    above = np.where((high > 0.0) & (least <= 0.0), np.inf, above)
    axes = tuple(range(1, below.ndim))
    lower, upper = below.min(axis=axes), above.max(axis=axes)
    lost = (least < 0.0).any(axis=axes) | ~(most > 0.0).any(axis=axes)
    lower, upper = outward(lower, upper)
    return np.where(lost, -np.inf, lower), np.where(lost, np.inf, upper)


def root(low: FloatArray, high: FloatArray) -> Interval:
    """Return bounds of the root of what is not negative."""
    below, above = outward(np.sqrt(np.maximum(low, 0.0)), np.sqrt(np.maximum(high, 0.0)))
    return np.maximum(below, 0.0), above


def square(low: FloatArray, high: FloatArray) -> Interval:
    """Return bounds of the square."""
    least = np.where((low <= 0.0) & (high >= 0.0), 0.0, np.minimum(np.abs(low), np.abs(high)))
    most = np.maximum(np.abs(low), np.abs(high))
    return outward(least * least, most * most)


def principal(mean: Interval, gauss: Interval) -> tuple[Interval, Interval]:
    """Return bounds of κ1 and κ2 from those of H and K."""
    squared = square(*mean)
    with np.errstate(invalid="ignore"):
        half = root(*(np.nan_to_num(part, nan=wide) for part, wide in _minus(squared, gauss)))
        first = outward(mean[0] + half[0], mean[1] + half[1])
        second = outward(mean[0] - half[1], mean[1] - half[0])
    first = np.nan_to_num(first[0], nan=-np.inf), np.nan_to_num(first[1], nan=np.inf)
    second = np.nan_to_num(second[0], nan=-np.inf), np.nan_to_num(second[1], nan=np.inf)
    # κ1 κ2 = K: where H and R cancel, their difference is K over their sum.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        other = over(gauss, first)
        use = first[0] > 0.0
        second = (
            np.where(use, np.fmax(second[0], other[0]), second[0]),
            np.where(use, np.fmin(second[1], other[1]), second[1]),
        )
        other = over((-gauss[1], -gauss[0]), (-second[1], -second[0]))
        use = second[1] < 0.0
        first = (
            np.where(use, np.fmax(first[0], other[0]), first[0]),
            np.where(use, np.fmin(first[1], other[1]), first[1]),
        )
    round_, bowl, cap = gauss[0] >= 0.0, mean[0] >= 0.0, mean[1] <= 0.0
    second = np.where(round_ & bowl, np.maximum(second[0], 0.0), second[0]), second[1]
    first = first[0], np.where(round_ & cap, np.minimum(first[1], 0.0), first[1])
    saddle = gauss[1] <= 0.0
    first = np.where(saddle, np.maximum(first[0], 0.0), first[0]), first[1]
    second = second[0], np.where(saddle, np.minimum(second[1], 0.0), second[1])
    return first, second


def over(top: Interval, bottom: Interval) -> Interval:
    """Return bounds of x / y, y > 0."""
    low = np.where(top[0] >= 0.0, top[0] / bottom[1], top[0] / bottom[0])
    high = np.where(top[1] <= 0.0, top[1] / bottom[1], top[1] / bottom[0])
    return outward(low, high)


def largest(first: Interval, second: Interval) -> Interval:
    """Return bounds of max(|κ1|, |κ2|)."""
    ends = [_absolute(*part) for part in (first, second)]
    return np.maximum(ends[0][0], ends[1][0]), np.maximum(ends[0][1], ends[1][1])


def inverse(low: FloatArray, high: FloatArray) -> Interval:
    """Return bounds of 1 / x for x >= 0, infinite where x may be 0."""
    with np.errstate(divide="ignore"):
        return outward(1.0 / high, 1.0 / np.maximum(low, 0.0))


def curvedness(mean: Interval, gauss: Interval) -> Interval:
    """Return bounds of C = √(2H² - K)."""
    squared = square(*mean)
    low, high = _minus((2.0 * squared[0], 2.0 * squared[1]), gauss)
    return root(np.nan_to_num(low[0], nan=low[1]), np.nan_to_num(high[0], nan=high[1]))


def _minus(x: Interval, y: Interval) -> tuple[tuple[FloatArray, float], tuple[FloatArray, float]]:
    with np.errstate(invalid="ignore"):
        low, high = outward(x[0] - y[1], x[1] - y[0])
    return (low, -np.inf), (high, np.inf)


def _absolute(low: FloatArray, high: FloatArray) -> Interval:
    least = np.where((low <= 0.0) & (high >= 0.0), 0.0, np.minimum(np.abs(low), np.abs(high)))
    return least, np.maximum(np.abs(low), np.abs(high))
