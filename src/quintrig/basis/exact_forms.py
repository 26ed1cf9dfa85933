"""Functions of one parameter as homogeneous forms in p, q >= 0 with exact coefficients: what proofs start from.

A form of degree n is Σ_k s_k p^(n-k) q^k. On a span of [0, 1] one quadratic form σ stands for 1, and x = q / (p + q)
runs from 0 to 1. For polynomials p and q are the distances to the two ends and σ = (p + q)². For trigonometric ones,
σ = p² + 2pq + 2q² makes p = √2 sin(π(1-t)/4) and q = sin(πt/4): a sine is 2pq + 2q², all in whole numbers. For sines of
another angle γ, σ = p² + 2 cos(γ) pq + q². The Poisson bracket {σ, F} / 2 = (σ_p F_q - σ_q F_p) / 2 is the derivative
of F up to a positive constant; it keeps the degree and obeys the product rule, and {σ, σ} = 0.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np

from quintrig.basis.exact_numbers import Exact, fractions
from quintrig.basis.rational import NotRationalError
from quintrig.support.arrays import FloatArray

POLYNOMIAL: Exact = np.array([1, 2, 1], dtype=object)
"""The coefficients of σ for polynomials."""

RIGHT: Exact = np.array([1, 2, 2], dtype=object)
"""The coefficients of σ for a right angle; SINE and COSINE are those of the angle's sine and cosine."""

SINE: Exact = np.array([0, 2, 2], dtype=object)
COSINE: Exact = np.array([1, 2, 0], dtype=object)


@dataclass(frozen=True, eq=False)
class Span:
    """Functions over [``start``, ``end``]: coefficients ``columns`` (degree + 1, size) over ``unit``, which is σ (3,).

    Constants, which have a form over any σ, have no unit. ``angle`` is that which the span turns by, 0 for polynomials.
    """

    start: float
    end: float
    unit: Exact | None
    columns: Exact
    angle: float = 0.0

    def parameter(self, x: FloatArray) -> FloatArray:
        """Return t at x = q / (p + q) in [0, 1], rounded."""
        if not self.angle:
            share = x
        elif self.unit is RIGHT:
            share = np.arctan(x) * (4.0 / math.pi)
        else:
            k = 0.5 * self.angle
            share = np.arctan2(x * math.sin(k), 1.0 - x + x * math.cos(k)) / k
        return np.clip(self.start + (self.end - self.start) * share, self.start, self.end)

    def place(self, t: FloatArray) -> FloatArray:
        """Return the x at which ``parameter`` is t, rounded; beyond [0, 1] for t beyond the span."""
        share = (t - self.start) / (self.end - self.start)
        if not self.angle:
            return share
        tangent = np.tan(0.5 * self.angle * share)
        if self.unit is RIGHT:
            return tangent
        k = 0.5 * self.angle
        return tangent / (math.sin(k) + tangent * (1.0 - math.cos(k)))

    def raised(self, degree: int, unit: Exact) -> Exact:
        """Return the columns in a higher degree; NotRationalError where σ has no power of that degree."""
        return np.stack([raised(column, degree, unit) for column in self.columns.T], axis=-1)


def times(x: Exact, y: Exact) -> Exact:
    """Return the product of two forms."""
    result: Exact = np.zeros(len(x) + len(y) - 1, dtype=object)
    for i, value in enumerate(x):
        if value:
            result[i : i + len(y)] += y * value
    return result


def raised(form: Exact, degree: int, unit: Exact) -> Exact:
    """Return the form times powers of ``unit``, in ``degree``; a polynomial's unit is a square and has a root."""
    root = np.array([1, 1], dtype=object) if unit is POLYNOMIAL else unit
    if (degree + 1 - len(form)) % (len(root) - 1):
        raise NotRationalError("they add even and odd forms in the half angle")
    while len(form) <= degree:
        form = times(form, root)
    return form


def bracket(form: Exact, unit: Exact) -> Exact:
    """Return the derivative {σ, F} / 2 of forms (degree + 1, ...), in the same degree."""
    n, (a, b, c) = len(form) - 1, unit
    result: Exact = np.zeros_like(form)
    for k in range(n + 1):
        result[k] = Fraction(2 * k - n, 2) * b * form[k]
        if k < n:
            result[k] = result[k] + a * (k + 1) * form[k + 1]
        if k:
            result[k] = result[k] - c * (n - k + 1) * form[k - 1]
    return result


def joined(parts: Sequence[tuple[Span, ...]]) -> tuple[Span, ...]:
    """Return spans of several families one after the other; NotRationalError where they have no common σ."""
    longest = max(parts, key=len)
    result: list[Span] = []
    for index, model in enumerate(longest):
        spans = [part[index] if len(part) == len(longest) else part[0] for part in parts]
        units = [span.unit for span in spans if span.unit is not None]
        same = all(np.array_equal(unit, units[0]) for unit in units)
        still = all(span.unit is None or (span.start, span.end) == (model.start, model.end) for span in spans)
        if not units or not same or not still:
            raise NotRationalError("they mix functions that have no common form, as polynomials and sines")
        unit = units[0]
        angle = next(span.angle for span in spans if span.unit is not None)
        degree = max(len(span.columns) for span in spans) - 1
        columns = np.concatenate([span.raised(degree, unit) for span in spans], axis=1)
        result.append(Span(model.start, model.end, unit, columns, angle))
    return tuple(result)


@lru_cache(maxsize=64)
def trigonometric(alpha: float, zeta: float) -> tuple[Span, ...]:
    """Return the quintic trigonometric functions in degree 10, or 8 without shape parameters."""
    plain_forms, by_alpha, by_zeta = _quintic()
    columns = plain_forms + Fraction(alpha) * by_alpha + Fraction(zeta) * by_zeta
    if alpha == zeta == 0.0:
        columns = _eighth()
    return (Span(0.0, 1.0, RIGHT, columns, 0.5 * math.pi),)


@lru_cache(maxsize=1)
def _eighth() -> Exact:
    a, b = RIGHT - SINE, RIGHT - COSINE
    inner = times(times(a, a), times(b, 8 * SINE + 3 * COSINE + 9 * RIGHT))
    first, second = times(times(a, a), times(a, a)), 4 * times(SINE, times(a, times(a, a)))
    last, before = times(times(b, b), times(b, b)), 4 * times(COSINE, times(b, times(b, b)))
    other = times(times(b, b), times(a, 8 * COSINE + 3 * SINE + 9 * RIGHT))
    return np.stack([first, second, inner, other, before, last], axis=-1)


@lru_cache(maxsize=1)
def _quintic() -> tuple[Exact, Exact, Exact]:
    """Return what of the six functions has no shape parameter, what α multiplies, and what ζ does: (11, 6) each."""
    plain_forms = np.stack([raised(column, 10, RIGHT) for column in _eighth().T], axis=-1)
    a, b = RIGHT - SINE, RIGHT - COSINE
    by_alpha, by_zeta = np.zeros_like(plain_forms), np.zeros_like(plain_forms)
    rising = times(SINE, times(times(a, a), times(a, a)))  # α moves s a⁴ from the first function to the second
    falling = times(COSINE, times(times(b, b), times(b, b)))
    by_alpha[:, 0], by_alpha[:, 1] = -rising, rising
    by_zeta[:, 5], by_zeta[:, 4] = -falling, falling
    return plain_forms, by_alpha, by_zeta


def bernstein(degree: int) -> tuple[Span, ...]:
    """Return the Bernstein polynomials."""
    columns: Exact = np.zeros((degree + 1, degree + 1), dtype=object)
    for k in range(degree + 1):
        columns[k, k] = math.comb(degree, k)
    return (Span(0.0, 1.0, POLYNOMIAL if degree else None, columns),)


def powers(start: float, end: float, degree: int) -> tuple[Span, ...]:
    """Return 1, x, ..., x^degree, x from ``start`` to ``end``."""
    line = fractions(np.array([start, end]))
    columns = [np.array([1], dtype=object)]
    for _ in range(degree):
        columns.append(times(columns[-1], line))
    raised_columns = [raised(column, degree, POLYNOMIAL) for column in columns]
    return (Span(0.0, 1.0, POLYNOMIAL if degree else None, np.stack(raised_columns, axis=-1)),)


def circular(start: float, end: float) -> tuple[Span, ...]:
    """Return cosine and sine of an angle that runs through whole right angles; NotRationalError for others."""
    count = round(abs(end - start))
    if start != round(start) or not count or count != abs(end - start):
        raise NotRationalError("they turn by a part of a right angle")
    way = 1 if end > start else -1
    result: list[Span] = []
    for k in range(count):
        quarter = int(start) + way * k
        turns = ((COSINE, way * SINE), (-way * SINE, COSINE), (-COSINE, -way * SINE), (way * SINE, -COSINE))
        pair = turns[quarter % 4]
        result.append(Span(k / count, (k + 1) / count, RIGHT, np.stack(pair, axis=-1), 0.5 * math.pi))
    return tuple(result)


@lru_cache(maxsize=16)
def bspline(knots: tuple[float, ...], degree: int) -> tuple[Span, ...]:
    """Return the B-splines span by span, their Bernstein coefficients by blossoms (Ramshaw 1989)."""
    exact = [Fraction(knot) for knot in knots]
    size = len(knots) - degree - 1
    result: list[Span] = []
    for i in range(degree, size):
        if knots[i] == knots[i + 1]:
            continue
        columns: Exact = np.zeros((degree + 1, size), dtype=object)
        for k in range(degree + 1):
            places = [exact[i]] * (degree - k) + [exact[i + 1]] * k
            values: list[Any] = [np.eye(degree + 1, dtype=object)[j] for j in range(degree + 1)]
            for level, x in enumerate(places, 1):
                for j in range(degree, level - 1, -1):
                    low, high = exact[i - degree + j], exact[i + 1 + j - level]
                    share = (x - low) / (high - low)
                    values[j] = (1 - share) * values[j - 1] + share * values[j]
            columns[k, i - degree : i + 1] = math.comb(degree, k) * values[degree]
        result.append(Span(knots[i], knots[i + 1], POLYNOMIAL, columns))
    return tuple(result)
