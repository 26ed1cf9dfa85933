"""Exact rational forms of functions of one parameter: quintic trigonometric ones are rational of degree 10.

With w = tan(πt/4), s = 2w/(1 + w²) and c = (1 - w²)/(1 + w²), the six quintic trigonometric functions are polynomials
of degree 10 in w over (1 + w²)⁵; without shape parameters of degree 8 over (1 + w²)⁴. The weights run from 1 to 32. A
projective change of parameter makes them symmetric, 1 at both ends and 2.4 times less in the middle (``TangentMap``).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from quintrig.support.arrays import FloatArray, parameter

HIGHEST_DEGREE = 25
"""Highest degree that CAD kernels exchange."""


class NotRationalError(ValueError):
    """A surface that has no exact rational form, such as a catenoid; a fit has to do."""


def circle_weights(degree: int) -> FloatArray:
    """Return the Bernstein coefficients of (1 + w²)^(degree / 2), even ``degree``: the weights of the form in w."""
    half = degree // 2

    def weight(k: int) -> Fraction:
        terms = (Fraction(math.comb(half, j) * math.comb(k, 2 * j), math.comb(degree, 2 * j)) for j in range(half + 1))
        return sum(terms, Fraction(0))

    return np.array([float(weight(k)) for k in range(degree + 1)])


def wedge_points(homogeneous: FloatArray) -> FloatArray:
    """Return the Bernstein products of the two points that de Casteljau's last step joins.

    From coefficients b_0, ..., b_n of shape (n + 1, d), the coefficients of degree 2n - 2 of U(w) ⊗ V(w), where U
    takes b_0, ..., b_{n-1} and V takes b_1, ..., b_n: shape (2n - 1, d, d). Any alternating product of the two is the
    tangent.
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


@dataclass(frozen=True)
class TangentMap:
    """Between t and the parameter x of the symmetric rational form, both in [0, 1]; the identity for ``angle`` 0.

    Each of ``spans`` equal parts of the domain turns by ``angle`` radians. Within one, τ and ξ in [0, 1] belong
    together by 2ξ - 1 = tan(angle (2τ - 1)/4) / tan(angle / 4). For one part of π/2 that is x = w / (w + (1 - w)/√2),
    w = tan(πt/4).
    """

    angle: float = 0.0
    spans: int = 1

    def forward(self, t: ArrayLike) -> FloatArray:
        """Return x(t), the shape of t; ValueError outside [0, 1]."""
        part, local = self._split(parameter(t, "t"))
        if self.angle:
            local = np.tan(0.25 * self.angle * (2.0 * local - 1.0)) / math.tan(0.25 * self.angle)
            local = 0.5 * (1.0 + local)
        return np.clip((part + local) / self.spans, 0.0, 1.0)

    def backward(self, x: ArrayLike) -> FloatArray:
        """Return t(x), the shape of x; ValueError outside [0, 1]."""
        part, local = self._split(parameter(x, "x"))
        if self.angle:
            local = np.arctan((2.0 * local - 1.0) * math.tan(0.25 * self.angle)) / (0.25 * self.angle)
            local = 0.5 * (1.0 + local)
        return np.clip((part + local) / self.spans, 0.0, 1.0)

    def weights(self, degree: int) -> FloatArray:
        """Return the symmetric weights of all spans in ``degree``, 1 at the ends of each; all 1 for the identity."""
        if not self.angle:
            span: FloatArray = np.ones(degree + 1)
        elif self == RIGHT_ANGLE:
            span = circle_weights(degree) * 2.0 ** (-0.5 * np.arange(degree + 1))
        else:
            span = arc_power(math.cos(0.5 * self.angle), degree)
        return shared([span] * self.spans)

    def _split(self, t: FloatArray) -> tuple[FloatArray, FloatArray]:
        part = np.minimum(np.floor(t * self.spans), self.spans - 1)
        return part, t * self.spans - part


RIGHT_ANGLE = TangentMap(0.5 * math.pi)
"""The map of the quintic trigonometric functions."""


@dataclass(frozen=True, eq=False)
class RationalFunctions:
    """Functions f_i(t) = Σ_k c_ki N_k(x) / Σ_k w_k N_k(x), x = ``map``.forward(t), N_k the B-splines of ``knots``.

    ``weights`` (n,) are positive, ``coefficients`` (n, size) are the numerators' (weights included).
    """

    knots: tuple[float, ...]
    degree: int
    map: TangentMap
    weights: FloatArray
    coefficients: FloatArray


class Part(Protocol):
    """What a family says of its rational form; see ``functions.Functions``."""

    def tangent_map(self) -> TangentMap | None: ...  # noqa: D102
    def rational_degree(self) -> int: ...  # noqa: D102
    def numerators(self, to: TangentMap, degree: int) -> FloatArray: ...  # noqa: D102


def assembled(parts: Sequence[Part]) -> RationalFunctions:
    """Return the rational form of families one after the other; NotRationalError where they have none in common.

    Trigonometric functions give degree 10, or 8 without shape parameters; circular ones degree 2 in spans of at most a
    right angle; Bernstein and power functions are polynomials already.
    """
    found = [part.tangent_map() for part in parts]
    maps = {one for one in found if one is not None} or {TangentMap()}
    if len(maps) > 1:
        names = " and ".join(f"{type(part).__name__.lower()} functions" for part in parts)
        raise NotRationalError(f"{names} have no common rational parameter")
    (common,) = maps
    degree = max(1, *(part.rational_degree() for part in parts))
    if degree > HIGHEST_DEGREE:
        raise NotRationalError(
            f"their rational form is of degree {degree}, and CAD systems read at most {HIGHEST_DEGREE}"
        )
    coefficients = np.concatenate([part.numerators(common, degree) for part in parts], axis=-1)
    knots = clamped_knots(np.linspace(0.0, 1.0, common.spans + 1), degree, degree)
    return RationalFunctions(tuple(knots.tolist()), degree, common, common.weights(degree), coefficients)


def clamped_knots(breaks: FloatArray, degree: int, multiplicity: int) -> FloatArray:
    """Return knots with ends of full multiplicity and interior ``breaks`` of the given multiplicity."""
    inner = np.repeat(breaks[1:-1], multiplicity)
    return np.concatenate([np.repeat(breaks[0], degree + 1), inner, np.repeat(breaks[-1], degree + 1)])


def arc_power(middle: float, degree: int) -> FloatArray:
    """Return the Bernstein coefficients of (B_0 + middle B_1 + B_2)^(degree / 2), B of degree 2."""
    result: FloatArray = np.ones(1)
    for _ in range(degree // 2):
        result = bernstein_product(result, np.array([1.0, middle, 1.0]))
    return result


def bernstein_product(x: FloatArray, y: FloatArray) -> FloatArray:
    """Return the Bernstein coefficients of the product of two polynomials given by theirs, (n + 1,) and (m + 1,)."""
    n, m = len(x) - 1, len(y) - 1
    result: FloatArray = np.zeros(n + m + 1)
    for i in range(n + 1):
        for j in range(m + 1):
            result[i + j] += math.comb(n, i) * math.comb(m, j) / math.comb(n + m, i + j) * x[i] * y[j]
    return result


def elevated(coefficients: FloatArray, degree: int) -> FloatArray:
    """Return the same polynomials, Bernstein coefficients (n + 1, ...), in a degree of at least n."""
    while len(coefficients) <= degree:
        n = len(coefficients)
        share = (np.arange(n + 1) / n).reshape(-1, *([1] * (coefficients.ndim - 1)))
        padded = np.concatenate([coefficients[:1], coefficients, coefficients[-1:]])
        coefficients = share * padded[:-1] + (1.0 - share) * padded[1:]
    return coefficients


def shared(spans: list[FloatArray]) -> FloatArray:
    """Return the coefficients of spans that meet, the common one once."""
    return np.concatenate([spans[0], *(span[1:] for span in spans[1:])])


def _lowered(rest: FloatArray) -> FloatArray:
    """Return the coefficients in degree n - 1 of Σ_{m>=1} c_m B_m^n / w, given c_1, ..., c_n."""
    n = len(rest)
    ratios = np.array([math.comb(n, m) / math.comb(n - 1, m - 1) for m in range(1, n + 1)])
    return rest * ratios.reshape(-1, *([1] * (rest.ndim - 1)))
