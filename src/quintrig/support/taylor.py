"""Arithmetic of truncated Taylor series, vectorised over any number of expansion points.

A series is an array of shape (order + 1, ...): entry k holds the k-th derivative divided by k!.
Derivatives of any order of a product, quotient or square root follow without a formula of their own.
"""

import math

import numpy as np

from quintrig.support.arrays import FloatArray


def product(x: FloatArray, y: FloatArray) -> FloatArray:
    """Return the series of x y (Cauchy product); shapes (order + 1, ...) broadcast as in NumPy."""
    order = len(x)
    result: FloatArray = np.zeros(np.broadcast_shapes(x.shape, y.shape))
    for k in range(order):
        for i in range(k + 1):
            result[k] += x[i] * y[k - i]
    return result


def quotient(x: FloatArray, y: FloatArray) -> FloatArray:
    """Return the series of x / y; where y vanishes the result is not finite."""
    result: FloatArray = np.empty(np.broadcast_shapes(x.shape, y.shape))
    for k in range(len(x)):
        rest = x[k] - sum((result[i] * y[k - i] for i in range(k)), np.zeros(()))
        result[k] = rest / y[0]
    return result


def powers(x: FloatArray, highest: int) -> list[FloatArray]:
    """Return the series of 1, x, x², ..., x^highest."""
    one = constant(1.0, x)
    result = [one]
    for _ in range(highest):
        result.append(product(result[-1], x))
    return result


def constant(value: float, like: FloatArray) -> FloatArray:
    """Return the series of a constant with the shape of ``like``."""
    result: FloatArray = np.zeros_like(like)
    result[0] = value
    return result


def derivatives(series: FloatArray) -> FloatArray:
    """Turn Taylor coefficients into derivatives: entry k is multiplied by k!."""
    return series * _factorials(series)


def coefficients(derived: FloatArray) -> FloatArray:
    """Turn derivatives into Taylor coefficients: entry k is divided by k!."""
    return derived / _factorials(derived)


def _factorials(series: FloatArray) -> FloatArray:
    factors: FloatArray = np.array([math.factorial(k) for k in range(len(series))], dtype=np.float64)
    return factors.reshape(-1, *([1] * (series.ndim - 1)))
