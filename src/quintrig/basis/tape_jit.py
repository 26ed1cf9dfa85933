"""The compiled loop that works out a tape of formulas with its first two derivatives, and their increments."""

import numpy as np
from numpy.typing import NDArray

from quintrig.basis.trigonometric_jit import half_angle
from quintrig.support.arrays import FloatArray
from quintrig.support.compiled import BLOCK, loop, scalar


@scalar
def _rest(x: float, sign: float) -> float:
    """Return x - sin(x) for ``sign`` -1, sinh(x) - x for +1, by its power series where x is small."""
    square = sign * x * x
    near = 0.0
    for k in range(10, 1, -1):
        near = (1.0 + near) * square / (2.0 * k * (2.0 * k + 1.0))
    if abs(x) < 1.5:
        return x * x * x * (1.0 + near) / 6.0
    return x - np.sin(x) if sign < 0.0 else np.sinh(x) - x


@loop
def _angle(x: FloatArray, out: FloatArray) -> None:
    """Fill ``out`` (4 BLOCK,) with s, c, 1 - s and 1 - c at x (BLOCK,), each without cancellation."""
    for k in range(BLOCK):
        h, g = half_angle(x[k])
        w, z = half_angle(1.0 - x[k])
        sine, cosine = 2.0 * h * g, 2.0 * w * z
        near = x[k] < 0.5
        out[k] = sine
        out[BLOCK + k] = cosine
        out[2 * BLOCK + k] = 1.0 - sine if near else 2.0 * w * w
        out[3 * BLOCK + k] = 2.0 * h * h if near else 1.0 - cosine


@loop
def run(
    t: FloatArray,
    operations: NDArray[np.int64],
    numbers: FloatArray,
    roots: NDArray[np.int64],
    partition: bool,
    out: FloatArray,
) -> None:
    """Fill ``out`` (blocks, 3 terms BLOCK) with increments, ordered (derivative, term, point), at t (blocks, BLOCK).

    For a partition of unity derivatives are summed over the functions that vanish at the nearer end.
    """
    count, size = operations.shape[0], roots.shape[0]
    # Values and first two derivatives of every operation; sine and cosine of the angle and what they lack of 1 once a
    # block. Every inner loop runs over the points of the block alone, without a branch, so that it goes in lanes.
    f = np.empty((count, 3, BLOCK))
    angle = np.empty(4 * BLOCK)
    turning = False
    for n in range(count):
        turning = turning or 3 <= operations[n, 0] <= 6
    total, other = np.empty(BLOCK), np.empty(BLOCK)
    rate = 0.5 * np.pi
    terms = size - 1 if partition else size
    for block in range(t.shape[0]):
        x = t[block]
        if turning:
            _angle(x, angle)
        for n in range(count):
            code, i, j, c = operations[n, 0], operations[n, 1], operations[n, 2], numbers[n]
            y, p, q = f[n], f[i], f[j]
            if code == 0:
                for k in range(BLOCK):
                    y[0, k], y[1, k], y[2, k] = c, 0.0, 0.0
            elif code <= 2:
                for k in range(BLOCK):
                    y[0, k] = x[k] if code == 1 else 1.0 - x[k]
                    y[1, k] = 1.0 if code == 1 else -1.0
                    y[2, k] = 0.0
            elif code <= 6:
                turn = rate if code <= 4 else -rate
                own = (code - 3) % 2  # of the sine, or of the cosine
                slope = turn if own == 0 else -turn
                value, along, back = angle[(code - 3) * BLOCK :], angle[(1 - own) * BLOCK :], angle[own * BLOCK :]
                for k in range(BLOCK):
                    y[0, k] = value[k]
                for k in range(BLOCK):
                    y[1, k] = slope * along[k]
                for k in range(BLOCK):
                    y[2, k] = -turn * rate * back[k]
            elif code <= 8:
                sign = 1.0 if code == 7 else -1.0
                for d in range(3):
                    for k in range(BLOCK):
                        y[d, k] = p[d, k] + sign * q[d, k]
            elif code == 9:
                # One row at a time: with three the compiler no longer sees that they do not overlap.
                for k in range(BLOCK):
                    y[0, k] = p[0, k] * q[0, k]
                for k in range(BLOCK):
                    y[1, k] = p[0, k] * q[1, k] + p[1, k] * q[0, k]
                for k in range(BLOCK):
                    y[2, k] = p[0, k] * q[2, k] + 2.0 * p[1, k] * q[1, k] + p[2, k] * q[0, k]
            elif code == 10:
                for k in range(BLOCK):
                    y[0, k] = p[0, k] / q[0, k]
                for k in range(BLOCK):
                    y[1, k] = (p[1, k] - y[0, k] * q[1, k]) / q[0, k]
                for k in range(BLOCK):
                    y[2, k] = (p[2, k] - 2.0 * y[1, k] * q[1, k] - y[0, k] * q[2, k]) / q[0, k]
            elif code == 11:
                for d in range(3):
                    for k in range(BLOCK):
                        y[d, k] = c * p[d, k]
            elif code == 12:
                for k in range(BLOCK):
                    y[0, k], y[1, k], y[2, k] = p[0, k] + c, p[1, k], p[2, k]
            elif code == 13:
                for k in range(BLOCK):
                    y[0, k] = c / p[0, k]
                    y[1, k] = -y[0, k] * p[1, k] / p[0, k]
                    y[2, k] = -(2.0 * y[1, k] * p[1, k] + y[0, k] * p[2, k]) / p[0, k]
            else:
                for k in range(BLOCK):
                    v, a, b = p[0, k], p[1, k], p[2, k]
                    # Value, and first and second derivative by the argument.
                    if code <= 17:
                        sine, half = np.sin(v), np.sin(0.5 * v)
                        cosine, less = np.cos(v), 2.0 * half * half
                        if code == 14:
                            g0, g1, g2 = sine, cosine, -sine
                        elif code == 15:
                            g0, g1, g2 = cosine, -sine, -cosine
                        elif code == 16:
                            g0, g1, g2 = less, sine, cosine
                        else:
                            g0, g1, g2 = _rest(v, -1.0), less, sine
                    elif code <= 21:
                        sine, half = np.sinh(v), np.sinh(0.5 * v)
                        cosine, less = np.cosh(v), 2.0 * half * half
                        if code == 18:
                            g0, g1, g2 = sine, cosine, sine
                        elif code == 19:
                            g0, g1, g2 = cosine, sine, cosine
                        elif code == 20:
                            g0, g1, g2 = less, sine, cosine
                        else:
                            g0, g1, g2 = _rest(v, 1.0), less, sine
                    elif code == 22:
                        g0 = np.sqrt(v)
                        g1 = 0.5 / g0
                        g2 = -0.5 * g1 / v
                    else:
                        g0 = np.exp(v)
                        g1, g2 = g0, g0
                    y[0, k], y[1, k], y[2, k] = g0, g1 * a, g1 * b + g2 * a * a
        o = out[block]
        for d in range(3):
            if not partition:
                for i in range(terms):
                    row, place = f[roots[i], d], o[(d * terms + i) * BLOCK : (d * terms + i + 1) * BLOCK]
                    for k in range(BLOCK):
                        place[k] = row[k]
                continue
            for k in range(BLOCK):
                total[k] = 0.0
                other[k] = 0.0
            for i in range(terms - 1, -1, -1):
                row, place = f[roots[i + 1], d], o[(d * terms + i) * BLOCK : (d * terms + i + 1) * BLOCK]
                for k in range(BLOCK):
                    total[k] += row[k]
                for k in range(BLOCK):
                    place[k] = total[k]
            if d == 0:
                continue
            for i in range(terms):
                row, place = f[roots[i], d], o[(d * terms + i) * BLOCK : (d * terms + i + 1) * BLOCK]
                for k in range(BLOCK):
                    other[k] -= row[k]
                for k in range(BLOCK):
                    here, there = place[k], other[k]
                    place[k] = here if x[k] < 0.5 else there
