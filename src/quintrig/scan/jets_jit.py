"""Osculating jets, compiled: polynomials of height over the neighbours of each point (Cazals and Pouget 2005)."""

import numpy as np
from numpy.typing import NDArray

from quintrig.support.array_loops import array_loop
from quintrig.support.arrays import FloatArray

FORM = 5
"""Numbers that curvature is made of: z_x, z_y, z_xx, z_xy, z_yy."""

_ROUND = 36  # neighbours that tell where none are: among more, those beyond a hole hide it


@array_loop
def columns(degree: int) -> int:
    """Return how many coefficients a polynomial of two variables has."""
    return (degree + 1) * (degree + 2) // 2


@array_loop
def jets(
    points: FloatArray,
    at: FloatArray,
    near: NDArray[np.int64],
    frames: FloatArray,
    degree: int,
    upper: int,
    values: FloatArray,
    check: FloatArray,
    covariance: FloatArray,
    residual: FloatArray,
    gap: FloatArray,
) -> None:
    """Write the first and second derivatives of the height over the tangent plane at each point, and how sure they are.

    ``near`` (n, k) are the neighbours of ``at`` (n, 3) among ``points``, ``frames`` (n, 3, 3) rows e1, e2, n.
    ``values`` (n, 5) are of ``degree``, ``check`` (n, 5) of the degree ``upper``, by one decomposition. ``covariance``
    (n, 5, 5) is that of the values for residuals of size 1, ``residual`` (n,) the size of those, length¹, and ``gap``
    (n,) the widest angle without one of the nearest neighbours.
    """
    k = near.shape[1]
    small, wide = columns(degree), columns(upper)
    a = np.empty((k, wide))
    z = np.empty(k)
    x, y = np.empty(k), np.empty(k)
    angles = np.empty(k)
    inverse = np.empty((wide, wide))
    for i in range(at.shape[0]):
        h = 0.0
        count = 0
        for j in range(k):
            u = v = w = 0.0
            for c in range(3):
                d = points[near[i, j], c] - at[i, c]
                u += d * frames[i, 0, c]
                v += d * frames[i, 1, c]
                w += d * frames[i, 2, c]
            x[j], y[j], z[j] = u, v, w
            r = np.sqrt(u * u + v * v)
            h = max(h, r)
            if r > 0.0 and j < _ROUND:
                angles[count] = np.arctan2(v, u)
                count += 1
        part = np.sort(angles[:count])
        widest = 2.0 * np.pi
        if count:
            widest = part[0] + 2.0 * np.pi - part[count - 1]
            for j in range(1, count):
                widest = max(widest, part[j] - part[j - 1])
        gap[i] = widest
        if not h > 0.0:
            values[i] = np.nan
            check[i] = np.nan
            covariance[i] = np.nan
            residual[i] = np.nan
            continue
        for j in range(k):
            u, v = x[j] / h, y[j] / h
            column = 0
            for total in range(upper + 1):
                for power in range(total + 1):
                    a[j, column] = u ** (total - power) * v**power
                    column += 1
        # Householder; columns in the order of their degree, so that the lower degree is a part of the higher one.
        for c in range(wide):
            size = 0.0
            for j in range(c, k):
                size += a[j, c] * a[j, c]
            size = np.sqrt(size)
            if size == 0.0:
                continue
            lead = -size if a[c, c] > 0.0 else size
            head = a[c, c] - lead
            square = head * head
            for j in range(c + 1, k):
                square += a[j, c] * a[j, c]
            if square > 0.0:
                for other in range(c + 1, wide):
                    along = head * a[c, other]
                    for j in range(c + 1, k):
                        along += a[j, c] * a[j, other]
                    along *= 2.0 / square
                    a[c, other] -= along * head
                    for j in range(c + 1, k):
                        a[j, other] -= along * a[j, c]
                along = head * z[c]
                for j in range(c + 1, k):
                    along += a[j, c] * z[j]
                along *= 2.0 / square
                z[c] -= along * head
                for j in range(c + 1, k):
                    z[j] -= along * a[j, c]
            a[c, c] = lead
        rest = 0.0
        for j in range(small, k):
            rest += z[j] * z[j]
        residual[i] = np.sqrt(rest / max(k - small, 1))
        solve(a, z, small, h, values[i])
        solve(a, z, wide, h, check[i])
        # Rows 1 to 5 of the inverse of R: what their products sum to is the covariance.
        for c in range(small):
            for r in range(small):
                inverse[r, c] = 0.0
            if abs(a[c, c]) < 1e-12:
                inverse[c, c] = np.nan
                continue
            inverse[c, c] = 1.0 / a[c, c]
            for r in range(c - 1, -1, -1):
                total_ = 0.0
                for m in range(r + 1, c + 1):
                    total_ += a[r, m] * inverse[m, c]
                inverse[r, c] = -total_ / a[r, r] if abs(a[r, r]) >= 1e-12 else np.nan
        for r in range(5):
            for s in range(5):
                total_ = 0.0
                for c in range(small):
                    total_ += inverse[1 + r, c] * inverse[1 + s, c]
                covariance[i, r, s] = total_ * weight(r, h) * weight(s, h)


@array_loop
def weight(which: int, h: float) -> float:
    """Return what turns a coefficient of x/h and y/h into a derivative."""
    if which < 2:
        return 1.0 / h
    return (1.0 if which == 3 else 2.0) / (h * h)


@array_loop
def solve(a: FloatArray, z: FloatArray, size: int, h: float, out: FloatArray) -> None:
    """Write the derivatives of the polynomial of ``size`` coefficients to ``out`` (5,); NaN where undetermined."""
    found = np.empty(size)
    for r in range(size - 1, -1, -1):
        total = z[r]
        for m in range(r + 1, size):
            total -= a[r, m] * found[m]
        found[r] = total / a[r, r] if abs(a[r, r]) >= 1e-12 else np.nan
    for which in range(5):
        out[which] = found[1 + which] * weight(which, h)
