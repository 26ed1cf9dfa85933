"""The Bézier bases: quintic trigonometric with two shape parameters, and classical Bernstein."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from quintrig import taylor
from quintrig.arrays import BoolArray, FloatArray, number, parameter
from quintrig.functions import Functions, sin_cos

SHAPE_RANGE = (-4.0, 1.0)
"""Shape parameters in this range keep the trigonometric basis non-negative (Misro et al. 2017)."""

BasisName = Literal["trigonometric", "bernstein"]


@dataclass(frozen=True)
class Trigonometric:
    """The six quintic trigonometric Bézier functions (Misro, Ramli and Ali 2017; thesis eq. 2.2).

    ``alpha`` acts at t = 0, ``zeta`` at t = 1, both in [-4, 1]; outside, ValueError unless ``unchecked``, and then
    functions turn negative and the convex-hull property is lost.
    """

    alpha: float = 0.0
    zeta: float = 0.0
    unchecked: bool = False

    def __post_init__(self) -> None:
        """Check both parameters once, at birth."""
        for name in ("alpha", "zeta"):
            object.__setattr__(self, name, shape_parameter(getattr(self, name), name, self.unchecked))

    @property
    def size(self) -> int:
        """Number of functions: six."""
        return 6

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, 6); ValueError for t outside [0, 1].

        Written as products of powers of a = 1 - sin and b = 1 - cos, each computed without cancellation, because
        they keep their relative accuracy at the end points, where a Fourier sum does not. The two functions that a
        shape parameter enters are integrated from their slopes, which vanish at that end when it is -4.
        """
        t = parameter(t, "t")
        sine, cosine = sin_cos(t)
        s = _rotation(sine, cosine, order)
        c = _rotation(cosine, -sine, order)
        a, b = -s, -c
        a[0] = 2.0 * np.sin(0.25 * np.pi * (1.0 - t)) ** 2
        b[0] = 2.0 * np.sin(0.25 * np.pi * t) ** 2
        near_start = t < 0.5
        f0, f1 = _end_pair(s, a, self.alpha, near_start)
        f5, f4 = _end_pair(c, b, self.zeta, ~near_start)
        a2, b2 = taylor.product(a, a), taylor.product(b, b)
        nine = taylor.constant(9.0, s)
        f2 = taylor.product(taylor.product(a2, b), 8.0 * s + 3.0 * c + nine)
        f3 = taylor.product(taylor.product(b2, a), 8.0 * c + 3.0 * s + nine)
        return taylor.derivatives(np.stack([f0, f1, f2, f3, f4, f5], axis=-1))


@dataclass(frozen=True)
class Bernstein:
    """The Bernstein polynomials of any degree, for comparison with the classical Bézier forms."""

    degree: int

    def __post_init__(self) -> None:
        """Check the degree once, at birth."""
        if self.degree < 0:
            raise ValueError(f"degree: expected 0 or more, found {self.degree}")

    @property
    def size(self) -> int:
        """Number of functions: degree + 1."""
        return self.degree + 1

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, size); ValueError for t outside [0, 1]."""
        t = parameter(t, "t")
        x: FloatArray = np.zeros((order + 1, *t.shape))
        x[0] = t
        x[1:2] = 1.0
        rest = -x
        rest[0] = 1.0 - t
        return taylor.derivatives(bernstein_series(x, rest, self.degree))


@dataclass(frozen=True)
class TangentBernstein:
    """Bernstein polynomials in w = tan(πt/4): the exact rational form of trigonometric curves lives in these."""

    degree: int

    @property
    def size(self) -> int:
        """Number of functions: degree + 1."""
        return self.degree + 1

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by t, shape (order + 1, *t.shape, size); ValueError for t not in [0, 1]."""
        t = parameter(t, "t")
        rate = 0.25 * np.pi
        w: FloatArray = np.zeros((order + 1, *t.shape))
        w[0] = np.where(t == 1.0, 1.0, np.tan(rate * t))
        for k in range(order):  # w' = (π/4)(1 + w²)
            square = sum((w[i] * w[k - i] for i in range(k + 1)), np.zeros(()))
            w[k + 1] = rate / (k + 1) * (square + (1.0 if k == 0 else 0.0))
        rest = -w
        rest[0] = np.tan(rate * (1.0 - t)) * (1.0 + w[0])  # 1 - tan x = tan(π/4 - x)(1 + tan x)
        return taylor.derivatives(bernstein_series(w, rest, self.degree))


def family(name: BasisName, points: int, alpha: float, zeta: float, unchecked: bool = False) -> Functions:
    """Return the basis called ``name`` for this many control points; ValueError where they do not fit."""
    if name == "trigonometric":
        if points != 6:
            raise ValueError(f"expected 6 control points for the trigonometric basis, found {points}")
        return Trigonometric(alpha, zeta, unchecked)
    if name == "bernstein":
        return Bernstein(points - 1)
    raise ValueError(f"basis: expected 'trigonometric' or 'bernstein', found {name!r}")


def shape_parameter(value: float, name: str, unchecked: bool = False) -> float:
    """Return a shape parameter as float; ValueError outside [-4, 1] unless ``unchecked``."""
    value = number(value, name)
    low, high = SHAPE_RANGE
    if not unchecked and not low <= value <= high:
        raise ValueError(
            f"{name} = {value:g} is outside [-4, 1], where the basis is non-negative; choose a value in the range, or "
            "set unchecked_shape = true and lose the convex-hull property"
        )
    return value


def bernstein_series(x: FloatArray, rest: FloatArray, degree: int) -> FloatArray:
    """Return the series of C(n, i) x^i (1 - x)^(n - i), shape (*x.shape, degree + 1), given x and 1 - x apart."""
    up, down = taylor.powers(x, degree), taylor.powers(rest, degree)
    terms = [math.comb(degree, i) * taylor.product(up[i], down[degree - i]) for i in range(degree + 1)]
    return np.stack(terms, axis=-1)


def _end_pair(s: FloatArray, a: FloatArray, alpha: float, near: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Return the series of f0 = a⁴ (1 - α s) and f1 = s a³ (4 + α - α s) from those of s and a = 1 - s.

    ``near`` is true near the end where s = 0. The slopes by s are -a³ (4 + α - 5α s) and
    a² ((a - 3s)(4 + α - α s) - α s a): near that end their terms do not cancel, whatever α, so that they keep their
    relative accuracy.
    """
    _, _, a2, a3, a4 = taylor.powers(a, 4)

    def linear(at_start: float, at_end: float) -> FloatArray:
        """Return the series of a linear function of s from its values at s = 0 and s = 1."""
        slope = at_end - at_start
        series = slope * s
        series[0] = np.where(near, at_start + slope * s[0], at_end - slope * a[0])
        return series

    q = linear(4.0 + alpha, 4.0)
    speed = taylor.product(taylor.slope(s), a2)
    f0_slope = -taylor.product(speed, taylor.product(a, linear(4.0 + alpha, 4.0 - 4.0 * alpha)))
    f1_slope = taylor.product(speed, taylor.product(a - 3.0 * s, q) - alpha * taylor.product(s, a))
    f0 = taylor.product(a4, linear(1.0, 1.0 - alpha))
    f1 = taylor.product(taylor.product(s, a3), q)
    return taylor.integral(f0_slope, f0[0]), taylor.integral(f1_slope, f1[0])


def _rotation(value: FloatArray, slope: FloatArray, order: int) -> FloatArray:
    """Return the series of a function with f'' = -(π/2)² f, from f and f' / (π/2)."""
    cycle = (value, slope, -value, -slope)
    rate = 0.5 * np.pi
    return np.stack([rate**k / math.factorial(k) * cycle[k % 4] for k in range(order + 1)])
