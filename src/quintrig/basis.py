"""The Bézier bases: quintic trigonometric with two shape parameters, and classical Bernstein."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from quintrig import taylor
from quintrig.arrays import FloatArray, number, parameter
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
        they keep their relative accuracy at the end points, where a Fourier sum does not.
        """
        t = parameter(t, "t")
        sine, cosine = sin_cos(t)
        s = _rotation(sine, cosine, order)
        c = _rotation(cosine, -sine, order)
        a, b = -s, -c
        a[0] = 2.0 * np.sin(0.25 * np.pi * (1.0 - t)) ** 2
        b[0] = 2.0 * np.sin(0.25 * np.pi * t) ** 2
        _, _, a2, a3, a4 = taylor.powers(a, 4)
        _, _, b2, b3, b4 = taylor.powers(b, 4)
        nine = taylor.constant(9.0, s)
        functions = [
            taylor.product(a4, self.alpha * a + taylor.constant(1.0 - self.alpha, s)),
            taylor.product(taylor.product(s, a3), self.alpha * a + taylor.constant(4.0, s)),
            taylor.product(taylor.product(a2, b), 8.0 * s + 3.0 * c + nine),
            taylor.product(taylor.product(b2, a), 8.0 * c + 3.0 * s + nine),
            taylor.product(taylor.product(c, b3), self.zeta * b + taylor.constant(4.0, s)),
            taylor.product(b4, self.zeta * b + taylor.constant(1.0 - self.zeta, s)),
        ]
        return taylor.derivatives(np.stack(functions, axis=-1))


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
        """Return derivatives by t, 0 to ``order``, shape (order + 1, *t.shape, size); ValueError for t outside [0, 1]."""
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


def _rotation(value: FloatArray, slope: FloatArray, order: int) -> FloatArray:
    """Return the series of a function with f'' = -(π/2)² f, from f and f' / (π/2)."""
    cycle = (value, slope, -value, -slope)
    rate = 0.5 * np.pi
    return np.stack([rate**k / math.factorial(k) * cycle[k % 4] for k in range(order + 1)])
