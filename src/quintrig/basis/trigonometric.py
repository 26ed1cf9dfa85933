"""The Bézier bases: quintic trigonometric with two shape parameters, and classical Bernstein."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import Functions, sin_cos
from quintrig.support import taylor
from quintrig.support.arrays import BoolArray, FloatArray, number, parameter, whole

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

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1: they do."""
        return True

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, 6); ValueError for t outside [0, 1].

        Each value is a product of s = sin, c = cos, a = 1 - s and b = 1 - c, none of which cancels, and each derivative
        a difference of ``slopes``: so all keep their relative accuracy at the end points, where a Fourier sum does not.
        """
        t = parameter(t, "t")
        s, c, a, b = (series[0] for series in _sines(t, 0))
        values: list[FloatArray] = [
            a**4 * np.where(t < 0.5, 1.0 - self.alpha * s, 1.0 - self.alpha + self.alpha * a),
            s * a**3 * np.where(t < 0.5, 4.0 + self.alpha - self.alpha * s, 4.0 + self.alpha * a),
            a**2 * b * (8.0 * s + 3.0 * c + 9.0),
            b**2 * a * (8.0 * c + 3.0 * s + 9.0),
            c * b**3 * np.where(t < 0.5, 4.0 + self.zeta * b, 4.0 + self.zeta - self.zeta * c),
            b**4 * np.where(t < 0.5, 1.0 - self.zeta + self.zeta * b, 1.0 - self.zeta * c),
        ]
        result: FloatArray = np.empty((order + 1, *t.shape, 6))
        result[0] = np.stack(values, axis=-1)
        if order:
            slopes = self.slopes(t, order - 1)
            result[1:, ..., 0] = -slopes[..., 0]
            result[1:, ..., 1:5] = slopes[..., :4] - slopes[..., 1:]
            result[1:, ..., 5] = slopes[..., 4]
        return result

    def slopes(self, t: ArrayLike, order: int, start: bool = False, end: bool = False) -> FloatArray:
        """Return the functions of the hodograph z'(t) = Σ G_i(t) (P_{i+1} - P_i) and their derivatives.

        The shape is (order + 1, *t.shape, 5). G_i = -(f0' + ... + fi') >= 0 for α, ζ in [-4, 1]:

            G0 = (π/2) c a³ (4 + α - 5α s)      G4 = (π/2) s b³ (4 + ζ - 5ζ c)
            G1 = (π/2) 12 a² s c                G3 = (π/2) 12 b² s c
            G2 = (π/2) a b s c (32 + 4 / (1 + s + c))

        With ``start`` (``end``) all are divided by s (c), and 4 + α (4 + ζ) is left out: what remains where the curve
        stands still at that end, because α (ζ) is -4 or two control points coincide there. Raises ValueError for t
        outside [0, 1].
        """
        t = parameter(t, "t")
        s, c, a, b = _sines(t, order)
        near_start = t < 0.5
        one = taylor.constant(1.0, s)
        rising, falling = one if start else s, one if end else c
        first = -5.0 * self.alpha * one if start else _outer_factor(self.alpha, s, a, near_start)
        last = -5.0 * self.zeta * one if end else _outer_factor(self.zeta, c, b, ~near_start)
        both, a2, b2 = taylor.product(rising, falling), taylor.product(a, a), taylor.product(b, b)
        middle = 32.0 * one + 4.0 * taylor.quotient(one, one + s + c)
        functions: list[FloatArray] = [
            taylor.product(falling, taylor.product(taylor.product(a2, a), first)),
            12.0 * taylor.product(a2, both),
            taylor.product(taylor.product(a, b), taylor.product(both, middle)),
            12.0 * taylor.product(b2, both),
            taylor.product(rising, taylor.product(taylor.product(b2, b), last)),
        ]
        return 0.5 * np.pi * taylor.derivatives(np.stack(functions, axis=-1))


@dataclass(frozen=True)
class Bernstein:
    """The Bernstein polynomials of any degree, for comparison with the classical Bézier forms."""

    degree: int

    def __post_init__(self) -> None:
        """Check the degree once, at birth."""
        object.__setattr__(self, "degree", whole(self.degree, "degree", 0))

    @property
    def size(self) -> int:
        """Number of functions: degree + 1."""
        return self.degree + 1

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1: they do."""
        return True

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

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1: they do."""
        return True

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
            raise ValueError(f"points: expected 6 control points for the trigonometric basis, found {points}")
        return Trigonometric(alpha, zeta, unchecked)
    if name == "bernstein":
        if points < 2:
            raise ValueError(f"points: expected 2 or more control points, found {points}")
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


def _sines(t: FloatArray, order: int) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Return the series of sine and cosine of πt/2, 1 - sine and 1 - cosine; none cancels, the ends are exact."""
    sine, cosine = sin_cos(t)
    s, c = _rotation(sine, cosine, order), _rotation(cosine, -sine, order)
    a, b = -s, -c
    a[0] = np.where(t < 0.5, 1.0 - sine, 2.0 * np.sin(0.25 * np.pi * (1.0 - t)) ** 2)
    b[0] = np.where(t < 0.5, 2.0 * np.sin(0.25 * np.pi * t) ** 2, 1.0 - cosine)
    return s, c, a, b


def _outer_factor(alpha: float, s: FloatArray, a: FloatArray, near: BoolArray) -> FloatArray:
    """Return the series of 4 + α - 5α s; from a = 1 - s where not ``near`` the end where s = 0."""
    series = -5.0 * alpha * s
    series[0] = np.where(near, 4.0 + alpha - 5.0 * alpha * s[0], 4.0 - 4.0 * alpha + 5.0 * alpha * a[0])
    return series


def _rotation(value: FloatArray, slope: FloatArray, order: int) -> FloatArray:
    """Return the series of a function with f'' = -(π/2)² f, from f and f' / (π/2)."""
    cycle = (value, slope, -value, -slope)
    rate = 0.5 * np.pi
    return np.stack([rate**k / math.factorial(k) * cycle[k % 4] for k in range(order + 1)])
