"""The compiled loop that works out a tape of formulas with its first two derivatives, and their increments."""

import numpy as np

from quintrig.basis.trigonometric_jit import half_angle
from quintrig.support.compiled import BLOCK, loop, scalar
from quintrig.support.memory import floats_at, stack_at, table_at, whole_table_at, words_at

SPARE = 6 * BLOCK
"""Numbers of room that the loop needs beside three lines for every operation."""


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
def run(
    t: int,
    blocks: int,
    tape: int,
    count: int,
    constants: int,
    ends: int,
    size: int,
    partition: int,
    scratch: int,
    out: int,
) -> None:
    """Fill ``out`` (blocks, 3 terms BLOCK) with increments, ordered (derivative, term, point), at t (blocks, BLOCK).

    ``tape`` (count, 3), ``constants`` (count,) and ``ends`` (size,) are operations, numbers and roots of a ``Tape``,
    ``scratch`` is room for (count, 3, BLOCK) and SPARE numbers. For a partition of unity derivatives are summed over
    the functions that vanish at the nearer end.
    """
    places, operations, numbers = table_at(t, blocks, BLOCK), whole_table_at(tape, count, 3), floats_at(constants)
    roots = words_at(ends)
    # Values and first two derivatives of every operation; sine and cosine of the angle and what they lack of 1 once a
    # block. Every inner loop runs over the points of the block alone, without a branch, so that it goes in lanes.
    f = stack_at(scratch, count, 3, BLOCK)
    room = stack_at(scratch + 8 * 3 * count * BLOCK, 1, 6, BLOCK)[0]
    turning = False
    for n in range(count):
        turning = turning or 3 <= operations[n, 0] <= 6
    increments = table_at(out, blocks, 3 * (size - 1 if partition else size) * BLOCK)
    rate = 0.5 * np.pi
    terms = size - 1 if partition else size
    for block in range(blocks):
        x = places[block]
        if turning:
            for k in range(BLOCK):
                h, g = half_angle(x[k])
                w, z = half_angle(1.0 - x[k])
                sine, cosine = 2.0 * h * g, 2.0 * w * z
                near = x[k] < 0.5
                room[0, k] = sine
                room[1, k] = cosine
                room[2, k] = 1.0 - sine if near else 2.0 * w * w
                room[3, k] = 2.0 * h * h if near else 1.0 - cosine
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
                value, along, back = room[code - 3], room[1 - own], room[own]
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
        o = increments[block]
        for d in range(3):
            if not partition:
                for i in range(terms):
                    at = (d * terms + i) * BLOCK
                    for k in range(BLOCK):
                        o[at + k] = f[roots[i], d, k]
                continue
            for k in range(BLOCK):
                room[4, k] = 0.0
                room[5, k] = 0.0
            for i in range(terms - 1, -1, -1):
                at = (d * terms + i) * BLOCK
                for k in range(BLOCK):
                    room[4, k] += f[roots[i + 1], d, k]
                    o[at + k] = room[4, k]
            if d == 0:
                continue
            for i in range(terms):
                at = (d * terms + i) * BLOCK
                for k in range(BLOCK):
                    room[5, k] -= f[roots[i], d, k]
                    o[at + k] = o[at + k] if x[k] < 0.5 else room[5, k]
