"""The increments of the quintic trigonometric basis, compiled: the twin of ``trigonometric`` that nearly all work uses.

The tests hold the two together.
"""

import numpy as np

from quintrig.support.compiled import BLOCK, loop, scalar
from quintrig.support.memory import table_at


@scalar
def half_angle(x: float) -> tuple[float, float]:
    """Return sin and cos of (π/4) x for x in [0, 1], within 2 units in the last place.

    The Taylor series to x^17 and x^18, whose remainders are below 1e-19: a library call would keep the loop from
    vectorising.
    """
    angle = 0.25 * np.pi * x
    y = angle * angle
    sine = 1.0 / 355687428096000.0
    sine = -1.0 / 1307674368000.0 + y * sine
    sine = 1.0 / 6227020800.0 + y * sine
    sine = -1.0 / 39916800.0 + y * sine
    sine = 1.0 / 362880.0 + y * sine
    sine = -1.0 / 5040.0 + y * sine
    sine = 1.0 / 120.0 + y * sine
    sine = -1.0 / 6.0 + y * sine
    cosine = -1.0 / 6402373705728000.0
    cosine = 1.0 / 20922789888000.0 + y * cosine
    cosine = -1.0 / 87178291200.0 + y * cosine
    cosine = 1.0 / 479001600.0 + y * cosine
    cosine = -1.0 / 3628800.0 + y * cosine
    cosine = 1.0 / 40320.0 + y * cosine
    cosine = -1.0 / 720.0 + y * cosine
    cosine = 1.0 / 24.0 + y * cosine
    cosine = -0.5 + y * cosine
    return angle + angle * y * sine, 1.0 + y * cosine


@scalar
def _end_pair(s: float, c: float, a: float, shape: float, near: bool) -> tuple[float, float, float, float]:
    """Return f1 = s a³ (4 + α - α s), f0 = a⁴ (1 - α s), c a³ (4 + α - 5 α s) and the derivative of the third.

    a = 1 - s, derivatives by the angle; f4, f5 and, with the opposite sign, the last from cos for sin. Each linear
    factor is taken from the end that is near, so that no term cancels there, whatever α.
    """
    bend = 5.0 * shape
    outer = (4.0 + shape) - bend * s if near else (4.0 - 4.0 * shape) + bend * a
    inner = (4.0 + shape) - shape * s if near else 4.0 + shape * a
    share = 1.0 - shape * s if near else (1.0 - shape) + shape * a
    square = a * a
    cube = square * a
    turn = -square * (s * a * outer + c * c * (3.0 * outer + bend * a))
    return s * cube * inner, square * square * share, c * cube * outer, turn


@loop
def fill(t: int, blocks: int, alpha: float, zeta: float, out: int) -> None:
    """Fill ``out`` (blocks, 15 BLOCK) with the increments of the trigonometric basis, ordered (derivative, i, point).

    Their derivatives are the hodograph functions of ``basis.Trigonometric.slopes``, where s c / (1 + s + c) is
    (s + c - 1)/2.
    """
    rate = 0.5 * np.pi
    square = rate * rate
    places, increments = table_at(t, blocks, BLOCK), table_at(out, blocks, 15 * BLOCK)
    for block in range(blocks):
        x = places[block]
        d = increments[block]
        for k in range(BLOCK):
            p, q = half_angle(x[k])
            r, w = half_angle(1.0 - x[k])
            near = x[k] < 0.5
            # sin and cos of πt/2, and one minus each without cancellation.
            s, c = 2.0 * p * q, 2.0 * r * w
            a = 1.0 - s if near else 2.0 * r * r
            b = 2.0 * p * p if near else 1.0 - c
            ab, both, twist = a * b, s * c, c * c - s * s
            f1, _, g0, h0 = _end_pair(s, c, a, alpha, near)
            f4, f5, g4, h4 = _end_pair(c, s, b, zeta, not near)
            last = f4 + f5
            three = last + ab * b * (8.0 * c + 3.0 * s + 9.0)
            two = three + ab * a * (8.0 * s + 3.0 * c + 9.0)
            middle = 32.0 * both + 2.0 * (s - b if near else c - a)
            d[k] = f1 + two
            d[BLOCK + k] = two
            d[2 * BLOCK + k] = three
            d[3 * BLOCK + k] = last
            d[4 * BLOCK + k] = f5
            d[5 * BLOCK + k] = rate * g0
            d[6 * BLOCK + k] = 12.0 * rate * a * a * both
            d[7 * BLOCK + k] = rate * ab * middle
            d[8 * BLOCK + k] = 12.0 * rate * b * b * both
            d[9 * BLOCK + k] = rate * g4
            d[10 * BLOCK + k] = square * h0
            d[11 * BLOCK + k] = 12.0 * square * a * (a * twist - 2.0 * both * c)
            d[12 * BLOCK + k] = square * ((a * s - b * c) * middle + ab * (32.0 * twist + 2.0 * (c - s)))
            d[13 * BLOCK + k] = 12.0 * square * b * (b * twist + 2.0 * both * s)
            d[14 * BLOCK + k] = -square * h4


@loop
def across(t: int, blocks: int, alpha: float, zeta: float, start: int, end: int, out: int) -> None:
    """Put f (G/f)' in place of the derivatives of the hodograph functions G, f = s at a still start, c at a still end.

    With f = 1 where an end moves, G = f g, and this is f g'; of G0 (G4) at a still start (end) the term 4 + α (4 + ζ)
    is left out.
    """
    square = 0.25 * np.pi * np.pi
    places, increments = table_at(t, blocks, BLOCK), table_at(out, blocks, 15 * BLOCK)
    for block in range(blocks):
        x = places[block]
        d = increments[block]
        for k in range(BLOCK):
            p, q = half_angle(x[k])
            r, w = half_angle(1.0 - x[k])
            near = x[k] < 0.5
            s, c = 2.0 * p * q, 2.0 * r * w
            a = 1.0 - s if near else 2.0 * r * r
            b = 2.0 * p * p if near else 1.0 - c
            # What stays of s and c, with their derivatives.
            rise, rising = (1.0, 0.0) if start else (s, c)
            fall, falling = (1.0, 0.0) if end else (c, -s)
            left = (s if start else 1.0) * (c if end else 1.0) * square
            both, twist = rise * fall, rising * fall + rise * falling
            first, bend = (-5.0 * alpha, 0.0) if start else (4.0 + alpha - 5.0 * alpha * s, -5.0 * alpha * c)
            last, turn = (-5.0 * zeta, 0.0) if end else (4.0 + zeta - 5.0 * zeta * c, 5.0 * zeta * s)
            whole = 1.0 + s + c
            middle, slope = 32.0 + 4.0 / whole, -4.0 * (c - s) / (whole * whole)
            d[10 * BLOCK + k] = left * a * a * (first * (falling * a - 3.0 * fall * c) + fall * a * bend)
            d[11 * BLOCK + k] = left * 12.0 * a * (a * twist - 2.0 * both * c)
            d[12 * BLOCK + k] = left * (middle * (both * (a * s - b * c) + a * b * twist) + a * b * both * slope)
            d[13 * BLOCK + k] = left * 12.0 * b * (b * twist + 2.0 * both * s)
            d[14 * BLOCK + k] = left * b * b * (last * (rising * b + 3.0 * rise * s) + rise * b * turn)
