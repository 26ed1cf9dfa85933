"""The exact rational form: a quintic trigonometric curve is a rational Bézier curve of degree 10 in w = tan(πt/4)."""

import math

import numpy as np

from quintrig.arrays import FloatArray

WEIGHTS: FloatArray = np.array([1, 1, 10 / 9, 4 / 3, 12 / 7, 148 / 63, 24 / 7, 16 / 3, 80 / 9, 16, 32])
"""Weights of the eleven control points, which do not depend on the shape parameters."""


def degree_ten(points: FloatArray, alpha: float, zeta: float) -> FloatArray:
    """Return the eleven control points of the rational form, from six of shape (6, ...); length¹.

    With ``WEIGHTS`` they give the same curve in w = tan(πt/4), w in [0, 1] (Sánchez-Reyes 1998 for the principle).
    """
    start = _half(points, alpha)
    end = _half(points[::-1], zeta)
    middle = 0.5 * (points[2] + points[3])
    return np.stack([*start, middle, *end[::-1]])


def wedge_points(homogeneous: FloatArray) -> FloatArray:
    """Return the Bernstein products of the two points that de Casteljau's last step joins.

    From coefficients b_0, ..., b_n of shape (n + 1, d), the coefficients of degree 2n - 2 of U(w) ⊗ V(w), where U takes
    b_0, ..., b_{n-1} and V takes b_1, ..., b_n: shape (2n - 1, d, d). Any alternating product of the two is the tangent.
    """
    n = len(homogeneous) - 1
    result: FloatArray = np.zeros((2 * n - 1, homogeneous.shape[1], homogeneous.shape[1]))
    for k in range(n):
        for j in range(n):
            factor = math.comb(n - 1, k) * math.comb(n - 1, j) / math.comb(2 * n - 2, k + j)
            result[k + j] += factor * np.outer(homogeneous[k], homogeneous[j + 1])
    return result


def without_factor(coefficients: FloatArray, at_start: bool, at_end: bool) -> FloatArray:
    """Divide a Bernstein form (n + 1, ...) by w where ``at_start`` and by 1 - w where ``at_end``; exact."""
    if at_start:
        coefficients = _lowered(coefficients[1:])
    if at_end:
        coefficients = _lowered(coefficients[:-1][::-1])[::-1]
    return coefficients


def _half(p: FloatArray, alpha: float) -> list[FloatArray]:
    """Return b_0 to b_4; written in differences, so that α = -4 gives b_1 = b_0 to the last bit."""
    return [
        p[0],
        p[0] + (4.0 + alpha) / 5.0 * (p[1] - p[0]),
        p[0] + (12.0 + alpha) / 25.0 * (p[1] - p[0]) + 12.0 / 25.0 * (p[2] - p[0]),
        p[1] + 0.8 * (p[2] - p[1]),
        p[2] + (4.0 * (p[1] - p[2]) + 17.0 * (p[3] - p[2])) / 90.0,
    ]


def _lowered(rest: FloatArray) -> FloatArray:
    """Return the coefficients in degree n - 1 of Σ_{m>=1} c_m B_m^n / w, given c_1, ..., c_n."""
    n = len(rest)
    ratios = np.array([math.comb(n, m) / math.comb(n - 1, m - 1) for m in range(1, n + 1)])
    return rest * ratios.reshape(-1, *([1] * (rest.ndim - 1)))
