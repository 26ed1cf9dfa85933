"""Arithmetic of truncated Taylor series, vectorised over any number of expansion points.

A series is an array of shape (order + 1, ...): entry k holds the k-th derivative divided by k!.
Derivatives of any order of a product, quotient or square root follow without a formula of their own.
"""

import math
from typing import NamedTuple

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


def root(x: FloatArray) -> FloatArray:
    """Return the series of sqrt(x), x positive."""
    result: FloatArray = np.empty_like(x)
    result[0] = np.sqrt(x[0])
    for k in range(1, len(x)):
        rest = x[k] - sum((result[i] * result[k - i] for i in range(1, k)), np.zeros(()))
        result[k] = rest / (2.0 * result[0])
    return result


def exponential(x: FloatArray) -> FloatArray:
    """Return the series of exp(x)."""
    result: FloatArray = np.empty_like(x)
    result[0] = np.exp(x[0])
    for k in range(1, len(x)):
        result[k] = sum((j * x[j] * result[k - j] for j in range(1, k + 1)), np.zeros(())) / k
    return result


class Waves(NamedTuple):
    """The series of sin(x), cos(x) and 1 - cos(x), or of sinh(x), cosh(x) and cosh(x) - 1."""

    sine: FloatArray
    cosine: FloatArray
    versine: FloatArray


def waves(x: FloatArray, hyperbolic: bool = False) -> Waves:
    """Return the series of the circular or hyperbolic functions; none cancels where x is small."""
    sine, versine = np.empty_like(x), np.empty_like(x)
    sine[0] = np.sinh(x[0]) if hyperbolic else np.sin(x[0])
    versine[0] = 2.0 * (np.sinh(0.5 * x[0]) if hyperbolic else np.sin(0.5 * x[0])) ** 2
    turn = 1.0 if hyperbolic else -1.0
    cosine = turn * versine
    cosine[0] = np.cosh(x[0]) if hyperbolic else np.cos(x[0])
    for k in range(1, len(x)):
        sine[k] = sum((j * x[j] * cosine[k - j] for j in range(1, k + 1)), np.zeros(())) / k
        versine[k] = sum((j * x[j] * sine[k - j] for j in range(1, k + 1)), np.zeros(())) / k
        cosine[k] = turn * versine[k]
    return Waves(sine, cosine, versine)


def rest(x: FloatArray, hyperbolic: bool = False) -> FloatArray:
    """Return the series of x - sin(x), or of sinh(x) - x, by their power series where x is small."""
    result: FloatArray = np.empty_like(x)
    slope = waves(x, hyperbolic).versine
    value = x[0]
    square = value * value * (1.0 if hyperbolic else -1.0)
    near: FloatArray = np.zeros_like(value)
    for k in range(10, 0, -1):  # Horner's scheme for x³/3! ± x⁵/5! + ..., enough below 1.5
        near = (1.0 + near) * square / (2 * k * (2 * k + 1)) if k > 1 else (1.0 + near) / 6.0
    far = np.sinh(value) - value if hyperbolic else value - np.sin(value)
    result[0] = np.where(np.abs(value) < 1.5, value**3 * near, far)
    for k in range(1, len(x)):
        result[k] = sum((j * x[j] * slope[k - j] for j in range(1, k + 1)), np.zeros(())) / k
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
