"""The forms of ``ball`` with exact coefficients: whole numbers over one denominator.

A product is one of large whole numbers: each row of coefficients is written side by side into one (Kronecker 1882), far
enough apart not to meet. It takes some tenths of a second where balls take hundredths, so it is asked only where they
do not decide: where a form vanishes on an edge, at a pole, or everywhere.
"""

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from quintrig.basis.exact_numbers import Exact
from quintrig.enclosures.ball import Ball, Edges
from quintrig.support.arrays import FloatArray


class InexactError(ValueError):
    """A form with coefficients that are known only to within an error."""


@dataclass(frozen=True, eq=False)
class Whole:
    """Coefficients ``over`` / ``under``, whole numbers (n + 1, m + 1) over one positive one."""

    over: Exact
    under: int = 1

    @staticmethod
    def constant(value: object) -> "Whole":
        """Return the form of degree 0 of an exact number; InexactError for others."""
        return whole_form(np.array([[value]], dtype=object))

    @staticmethod
    def blend(u: Exact, net: Exact, v: Exact) -> list["Whole"]:
        """Return the coordinates of Σ u_i net_ij v_j; InexactError where a number has an error."""
        left, right = whole_form(u), whole_form(v)
        result: list[Whole] = []
        for k in range(net.shape[2]):
            middle = whole_form(net[:, :, k])
            over = left.over.dot(middle.over).dot(right.over.T)
            result.append(Whole(over, left.under * middle.under * right.under))
        return result

    @property
    def degree(self) -> tuple[int, int]:
        """The bidegree."""
        return self.over.shape[0] - 1, self.over.shape[1] - 1

    @property
    def vanishes(self) -> bool:
        """Whether all coefficients are 0."""
        return not self.over.any()

    def __add__(self, other: "Whole") -> "Whole":
        """Return the sum."""
        if self.under == other.under:
            return Whole(self.over + other.over, self.under)
        under = math.lcm(self.under, other.under)
        return Whole(self.over * (under // self.under) + other.over * (under // other.under), under)

    def __neg__(self) -> "Whole":
        """Return the form with the other sign."""
        return Whole(-self.over, self.under)

    def __sub__(self, other: "Whole") -> "Whole":
        """Return the difference."""
        return self + -other

    def __mul__(self, other: "Whole") -> "Whole":
        """Return the product."""
        return Whole(_product(self.over, other.over), self.under * other.under)

    def bracket(self, axis: int, unit: Exact) -> "Whole":
        """Return {σ, F} / 2 along u (``axis`` 0) or v (1); InexactError for a σ with an error."""
        if not all(isinstance(value, int) for value in unit):
            raise InexactError("σ is known only to within an error")
        a, b, c = unit
        form = self.over.T if axis else self.over
        n = len(form) - 1
        k = np.array(range(n + 1), dtype=object)[:, None]
        result = (2 * k - n) * b * form
        result[:-1] += 2 * a * k[1:] * form[1:]
        result[1:] -= 2 * c * k[:0:-1] * form[:-1]
        return Whole(result.T if axis else result, 2 * self.under)

    def edges(self) -> Edges:
        """Return how often u, 1 - u, v and 1 - v divide the form."""
        some = self.over.astype(bool)
        return Ball(some.astype(np.float64), np.zeros(some.shape)).edges()

    def divided(self, edges: Edges) -> "Whole":
        """Return the form without these powers of u, 1 - u, v and 1 - v, which must divide it."""
        n, m = self.over.shape
        return Whole(self.over[edges[0] : n - edges[1], edges[2] : m - edges[3]], self.under)

    def multiplied(self, edges: Edges) -> "Whole":
        """Return the form times these powers of u, 1 - u, v and 1 - v."""
        n, m = self.over.shape
        over: Exact = np.zeros((n + edges[0] + edges[1], m + edges[2] + edges[3]), dtype=object)
        over[edges[0] : edges[0] + n, edges[2] : edges[2] + m] = self.over
        return Whole(over, self.under)

    def halves(self, axis: int) -> "tuple[Whole, Whole]":
        """Return the form over both halves of the chart along u (``axis`` 0) or v, exactly."""
        form = self.over.T if axis else self.over
        n = len(form) - 1
        matrix: Exact = np.zeros((n + 1, n + 1), dtype=object)
        for j in range(n + 1):  # p becomes p + q / 2, q becomes q / 2
            for k in range(j + 1):
                matrix[j, k] = math.comb(n - k, j - k) << (n - j)
        parts = matrix.dot(form), matrix.dot(form[::-1])[::-1]
        first, second = (Whole(part.T if axis else part, self.under << n) for part in parts)
        return first, second

    def ball(self) -> Ball:
        """Return the form in doubles, each coefficient rounded once."""
        middle: FloatArray = np.zeros(self.over.shape)
        for index, value in np.ndenumerate(self.over):
            middle[index] = value / self.under if value else 0.0
        return Ball(middle, np.where(middle == 0.0, 0.0, 2.0**-52 * np.abs(middle)) + _tiny(self.over, middle))


def _tiny(over: Exact, middle: FloatArray) -> FloatArray:
    """Return a bound for coefficients that are below all doubles."""
    return np.where((middle == 0.0) & over.astype(bool), 5e-324, 0.0)


def whole_form(values: Exact) -> Whole:
    """Return exact numbers (n, m) over one denominator; InexactError where one has an error or a root."""
    under = 1
    for value in values.flat:
        if not isinstance(value, int | Fraction):
            raise InexactError("a coefficient is known only to within an error")
        under = math.lcm(under, value.denominator)
    over: Exact = np.empty(values.shape, dtype=object)
    for index, value in np.ndenumerate(values):
        over[index] = int(value * under)
    return Whole(over, under)


def _product(x: Exact, y: Exact) -> Exact:
    n, m = x.shape[0] + y.shape[0] - 1, x.shape[1] + y.shape[1] - 1
    result: Exact = np.zeros((n, m), dtype=object)
    if not (x.any() and y.any()):
        return result
    terms = min(x.shape[0], y.shape[0]) * min(x.shape[1], y.shape[1])
    size = 2 + (_bits(x) + _bits(y) + terms.bit_length()) // 8  # bytes, with room for the sign
    left, right = ([_packed(row, size) for row in form] for form in (x, y))
    rows: list[Any] = [0] * n
    for i, one in enumerate(left):
        if one:
            for k, other in enumerate(right):
                rows[i + k] += one * other
    for i, row in enumerate(rows):
        result[i] = _unpacked(row, m, size)
    return result


def _bits(form: Exact) -> int:
    return max(abs(value).bit_length() for value in form.flat)


def _half(count: int, size: int) -> int:
    """Return the whole number with the half of each place's range in it, which makes all digits positive."""
    return int.from_bytes((bytes(size - 1) + b"\x80") * count, "little")


def _packed(row: Exact, size: int) -> int:
    half = 1 << (8 * size - 1)
    return int.from_bytes(b"".join((v + half).to_bytes(size, "little") for v in row), "little") - _half(len(row), size)


def _unpacked(number: int, count: int, size: int) -> Exact:
    half = 1 << (8 * size - 1)
    text = (number + _half(count, size)).to_bytes(size * count, "little")
    result: Exact = np.empty(count, dtype=object)
    for j in range(count):
        result[j] = int.from_bytes(text[j * size : (j + 1) * size], "little") - half
    return result
