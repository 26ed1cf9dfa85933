"""The exact rational form of functions of one parameter: trigonometric ones are rational Bézier functions of degree 10.

With w = tan(πt/4), s = 2w/(1 + w²) and c = (1 - w²)/(1 + w²), the six quintic trigonometric functions are polynomials
of degree 10 in w over (1 + w²)⁵; without shape parameters of degree 8 over (1 + w²)⁴. The weights run from 1 to 32. A
projective change of parameter makes them symmetric, 1 at both ends and 2.4 times less in the middle (``TangentMap``).
"""

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quintrig.basis.bspline import BSpline, clamped
from quintrig.basis.functions import Circular, Functions, Joined, Powers
from quintrig.basis.trigonometric import Bernstein, Trigonometric
from quintrig.support.arrays import FloatArray, parameter


class NotRationalError(ValueError):
    """A surface that has no exact rational form, such as a catenoid; a fit has to do."""


def circle_weights(degree: int) -> FloatArray:
    """Return the Bernstein coefficients of (1 + w²)^(degree / 2), even ``degree``: the weights of the form in w."""
    half = degree // 2

    def weight(k: int) -> Fraction:
        terms = (Fraction(math.comb(half, j) * math.comb(k, 2 * j), math.comb(degree, 2 * j)) for j in range(half + 1))
        return sum(terms, Fraction(0))

    return np.array([float(weight(k)) for k in range(degree + 1)])


WEIGHTS: FloatArray = circle_weights(10)
"""Weights of the eleven control points, which do not depend on the shape parameters: 1, 1, 10/9, ..., 32."""


def degree_ten(points: NDArray[Any], alpha: Any, zeta: Any) -> NDArray[Any]:
    """Return the eleven control points of the rational form, from six of shape (6, ...); length¹.

    With ``WEIGHTS`` they give the same curve in w = tan(πt/4), w in [0, 1] (Sánchez-Reyes 1998 for the principle).
    Exact arithmetic, such as arrays of fractions, passes through.
    """
    start = _half(points, alpha)
    end = _half(points[::-1], zeta)
    middle = (points[2] + points[3]) / 2
    return np.stack([*start, middle, *end[::-1]])


def degree_eight(points: NDArray[Any]) -> NDArray[Any]:
    """Return the nine control points for α = ζ = 0, which go with ``circle_weights(8)``; length¹."""
    p = points
    first, last = p[1] + 3 * (p[2] - p[1]) / 4, p[4] + 3 * (p[3] - p[4]) / 4
    return np.stack([p[0], p[1], first, p[2], (p[2] + p[3]) / 2, p[3], last, p[4], p[5]])


def homogeneous(points: FloatArray, alpha: float, zeta: float) -> FloatArray:
    """Return weight times control point in the lowest degree that α and ζ allow, 10 or 8: shape (11 or 9, ...)."""
    control = degree_eight(points) if alpha == zeta == 0.0 else degree_ten(points, alpha, zeta)
    return control * circle_weights(len(control) - 1).reshape(-1, *([1] * (control.ndim - 1)))


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

    def _split(self, t: FloatArray) -> tuple[FloatArray, FloatArray]:
        part = np.minimum(np.floor(t * self.spans), self.spans - 1)
        return part, t * self.spans - part


RIGHT_ANGLE = TangentMap(0.5 * math.pi)
"""The map of the quintic trigonometric functions."""


@dataclass(frozen=True, eq=False)
class RationalFunctions:
    """Functions f_i(t) = Σ_k c_ki N_k(x) / Σ_k w_k N_k(x), x = ``map``.forward(t).

    ``weights`` (n,) are positive, ``coefficients`` (n, size) are the numerators' (weights included).
    """

    basis: BSpline
    map: TangentMap
    weights: FloatArray
    coefficients: FloatArray


def rational_functions(functions: Functions) -> RationalFunctions:
    """Return the exact rational form; NotRationalError for functions that have none.

    Trigonometric functions give degree 10, or 8 without shape parameters; circular ones degree 2 in spans of at most a
    right angle; Bernstein, B-spline and power functions are polynomials already.
    """
    parts = functions.parts if isinstance(functions, Joined) else (functions,)
    maps = {_map(part) for part in parts} - {None} or {TangentMap()}
    if len(maps) > 1:
        raise NotRationalError(f"{_named(functions)} have no common rational parameter")
    (common,) = maps
    assert common is not None
    if isinstance(functions, BSpline):
        return RationalFunctions(functions, common, np.ones(functions.size), np.eye(functions.size))
    degree = max(1, *(_degree(part) for part in parts))
    blocks = [_coefficients(part, common, degree) for part in parts]
    basis = clamped(np.linspace(0.0, 1.0, common.spans + 1), degree, degree)
    weights = _shared([_span_weights(common, degree)] * common.spans)
    return RationalFunctions(basis, common, weights, np.concatenate(blocks, axis=-1))


def _map(functions: Functions) -> TangentMap | None:
    """Return the map that a family needs, None where any will do."""
    if isinstance(functions, Trigonometric):
        return RIGHT_ANGLE
    if isinstance(functions, Circular):
        turn = abs(functions.end - functions.start)
        spans = max(1, math.ceil(turn))
        return TangentMap(0.5 * math.pi * turn / spans, spans)
    if isinstance(functions, Bernstein | Powers | BSpline):
        return None if functions.size == 1 else TangentMap()
    raise NotRationalError(f"{_named(functions)} have no exact rational form")


def _degree(functions: Functions) -> int:
    if isinstance(functions, Trigonometric):
        return 8 if functions.alpha == functions.zeta == 0.0 else 10
    if isinstance(functions, Circular):
        return 2
    if isinstance(functions, BSpline):
        raise NotRationalError("B-spline functions joined with others have no rational form here")
    return functions.size - 1


def _coefficients(functions: Functions, to: TangentMap, degree: int) -> FloatArray:
    """Return the numerators' coefficients (n, size) in ``degree`` over the common weights."""
    if isinstance(functions, Trigonometric):
        alpha, zeta = functions.alpha, functions.zeta
        control = degree_eight(np.eye(6)) if degree == 8 else degree_ten(np.eye(6), alpha, zeta)
        return control * _span_weights(to, degree)[:, None]
    if isinstance(functions, Circular):
        step = (functions.end - functions.start) / to.spans
        return _shared([_arc(functions.start + k * step, step, degree) for k in range(to.spans)])
    if functions.size == 1:
        return _shared([_span_weights(to, degree)] * to.spans)[:, None]
    if isinstance(functions, Powers):
        return np.stack([_power(functions, k, degree) for k in range(functions.size)], axis=-1)
    return elevated(np.eye(functions.size), degree)


def _span_weights(to: TangentMap, degree: int) -> FloatArray:
    """Return the symmetric weights of one span: 1 at the ends; all 1 for a polynomial."""
    if not to.angle:
        return np.ones(degree + 1)
    if to == RIGHT_ANGLE:
        return circle_weights(degree) * 2.0 ** (-0.5 * np.arange(degree + 1))
    return _arc_power(math.cos(0.5 * to.angle), degree)


def _arc_power(middle: float, degree: int) -> FloatArray:
    """Return the Bernstein coefficients of (B_0 + middle B_1 + B_2)^(degree / 2), B of degree 2."""
    result: FloatArray = np.ones(1)
    for _ in range(degree // 2):
        result = bernstein_product(result, np.array([1.0, middle, 1.0]))
    return result


def _arc(start: float, turn: float, degree: int) -> FloatArray:
    """Return the numerators (degree + 1, 2) of cosine and sine over ``turn`` <= 1 right angles from ``start``."""
    angle = 0.5 * math.pi
    quarter = Circular(start, start + turn).derivatives([0.0, 0.5, 1.0], 0)[0]
    rest = _arc_power(math.cos(0.5 * angle * abs(turn)), degree - 2)
    return np.stack([bernstein_product(rest, quarter[:, i]) for i in range(2)], axis=-1)


def _power(powers: Powers, k: int, degree: int) -> FloatArray:
    a, b = powers.start, powers.end
    alone = np.array([a ** (k - i) * b**i for i in range(k + 1)], dtype=np.float64)
    return elevated(alone, degree)


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


def _shared(spans: list[FloatArray]) -> FloatArray:
    """Return the coefficients of spans that meet, the common one once."""
    return np.concatenate([spans[0], *(span[1:] for span in spans[1:])])


def _named(functions: Functions) -> str:
    names = functions.parts if isinstance(functions, Joined) else (functions,)
    return " and ".join(f"{type(part).__name__.lower()} functions" for part in names)


def _half(p: NDArray[Any], alpha: Any) -> list[NDArray[Any]]:
    """Return b_0 to b_4; written in differences, so that α = -4 gives b_1 = b_0 to the last bit."""
    return [
        p[0],
        p[0] + (4 + alpha) * (p[1] - p[0]) / 5,
        p[0] + ((12 + alpha) * (p[1] - p[0]) + 12 * (p[2] - p[0])) / 25,
        p[1] + 4 * (p[2] - p[1]) / 5,
        p[2] + (4 * (p[1] - p[2]) + 17 * (p[3] - p[2])) / 90,
    ]


def _lowered(rest: FloatArray) -> FloatArray:
    """Return the coefficients in degree n - 1 of Σ_{m>=1} c_m B_m^n / w, given c_1, ..., c_n."""
    n = len(rest)
    ratios = np.array([math.comb(n, m) / math.comb(n - 1, m - 1) for m in range(1, n + 1)])
    return rest * ratios.reshape(-1, *([1] * (rest.ndim - 1)))
