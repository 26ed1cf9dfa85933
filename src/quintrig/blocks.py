"""Functions evaluated in the layout that the compiled driver reads: blocks of points, one row of a block a function.

``functions`` and ``basis`` hold the definitions, for any order and by plain NumPy. The trigonometric basis, which
nearly all work goes through, has a compiled twin here for derivatives 0 to 2; the tests hold the two together.
"""

import numpy as np

from quintrig.arrays import FloatArray
from quintrig.basis import Trigonometric
from quintrig.compiled import loop, scalar
from quintrig.functions import Functions, Joined

BLOCK = 128
"""Points in a block: 31 scratch rows of 1 KiB each stay in a 32 KiB cache. Measured best of 64, 128, 256."""

Three = tuple[float, float, float]


def derivative_blocks(functions: Functions, t: FloatArray) -> FloatArray:
    """Return derivatives 0 to 2 of all functions at ``t`` (n,), shape (blocks, 3, size, BLOCK).

    The last block is filled up with the last point.
    """
    padded = pad(t)
    if isinstance(functions, Joined):
        return np.concatenate([derivative_blocks(part, t) for part in functions.parts], axis=2)
    if isinstance(functions, Trigonometric):
        result: FloatArray = np.empty((len(padded), 3, 6, BLOCK))
        _trigonometric(padded, functions.alpha, functions.zeta, result.reshape(len(padded), -1))
        return result
    return np.ascontiguousarray(functions.derivatives(padded, 2).transpose(1, 0, 3, 2))


def pad(t: FloatArray) -> FloatArray:
    """Return (n,) parameters as (blocks, BLOCK), the last block filled up with the last point."""
    count = -(-t.size // BLOCK)
    result: FloatArray = np.empty(count * BLOCK)
    result[: t.size] = t
    result[t.size :] = t[-1]
    return result.reshape(count, BLOCK)


@scalar
def _half_angle(x: float) -> tuple[float, float]:
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
def _product(x: float, x1: float, x2: float, y: float, y1: float, y2: float) -> Three:
    """Return the product of two functions with its first and second derivative."""
    return x * y, x1 * y + x * y1, x2 * y + 2.0 * x1 * y1 + x * y2


@scalar
def _end_pair(s: float, s1: float, s2: float, a: float, shape: float, near: bool) -> tuple[Three, Three]:
    """Return f0 = a⁴ (1 - α s) and f1 = s a³ (4 + α - α s), a = 1 - s, with derivatives; f5 and f4 with cos for s.

    Each linear factor is taken from the end that is near, so that no term cancels there, whatever α.
    """
    bend = 5.0 * shape
    outer = (4.0 + shape) - bend * s if near else (4.0 - 4.0 * shape) + bend * a
    inner = (4.0 + shape) - shape * s if near else 4.0 + shape * a
    share = 1.0 - shape * s if near else (1.0 - shape) + shape * a
    square = a * a
    cube = square * a
    slope = -cube * outer
    curve = 3.0 * square * outer + bend * cube
    first = square * square * share, slope * s1, curve * s1 * s1 + slope * s2
    slope = square * ((a - 3.0 * s) * inner - shape * s * a)
    curve = 2.0 * a * (3.0 * (s - a) * inner + shape * a * (3.0 * s - a))
    return first, (s * cube * inner, slope * s1, curve * s1 * s1 + slope * s2)


@scalar
def _middle(a: float, a1: float, a2: float, b: float, b1: float, b2: float, q: float, q1: float, q2: float) -> Three:
    """Return a² b q and its derivatives: f2, and f3 with a and b exchanged."""
    x, x1, x2 = _product(a * a, 2.0 * a * a1, 2.0 * (a1 * a1 + a * a2), b, b1, b2)
    return _product(x, x1, x2, q, q1, q2)


@loop
def _trigonometric(t: FloatArray, alpha: float, zeta: float, out: FloatArray) -> None:
    """Fill ``out`` (blocks, 18 BLOCK) with the trigonometric basis, ordered (derivative, function, point)."""
    rate = 0.5 * np.pi
    for block in range(t.shape[0]):
        x = t[block]
        d = out[block]
        for k in range(BLOCK):
            p, q = _half_angle(x[k])
            r, w = _half_angle(1.0 - x[k])
            # sin and cos of πt/2, and one minus each without cancellation, as in basis.Trigonometric.
            s, c = 2.0 * p * q, 2.0 * r * w
            a = 1.0 - s if x[k] < 0.5 else 2.0 * r * r
            b = 1.0 - c if x[k] > 0.5 else 2.0 * p * p
            s1, c1, s2, c2 = rate * c, -rate * s, -rate * rate * s, -rate * rate * c
            # _middle's third factors
            g, g1, g2 = 8.0 * s + 3.0 * c + 9.0, 8.0 * s1 + 3.0 * c1, 8.0 * s2 + 3.0 * c2
            h, h1, h2 = 8.0 * c + 3.0 * s + 9.0, 8.0 * c1 + 3.0 * s1, 8.0 * c2 + 3.0 * s2
            f0, f1 = _end_pair(s, s1, s2, a, alpha, x[k] < 0.5)
            f5, f4 = _end_pair(c, c1, c2, b, zeta, x[k] >= 0.5)
            f2 = _middle(a, -s1, -s2, b, -c1, -c2, g, g1, g2)
            f3 = _middle(b, -c1, -c2, a, -s1, -s2, h, h1, h2)
            d[k], d[6 * BLOCK + k], d[12 * BLOCK + k] = f0
            d[BLOCK + k], d[7 * BLOCK + k], d[13 * BLOCK + k] = f1
            d[2 * BLOCK + k], d[8 * BLOCK + k], d[14 * BLOCK + k] = f2
            d[3 * BLOCK + k], d[9 * BLOCK + k], d[15 * BLOCK + k] = f3
            d[4 * BLOCK + k], d[10 * BLOCK + k], d[16 * BLOCK + k] = f4
            d[5 * BLOCK + k], d[11 * BLOCK + k], d[17 * BLOCK + k] = f5
