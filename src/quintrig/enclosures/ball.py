"""Forms in two pairs of variables with rounded coefficients, each beside a bound of its error: balls.

A form of bidegree (n, m) is Σ s_kl p^(n-k) q^k r^(m-l) t^l, as in ``basis.exact_forms``; so a product is a convolution.
A sum of so many products in doubles, in whatever order and with or without fused multiplication, is off by at most
γ = so many units of roundoff of the sum of the absolute values (Higham 2002, §3.1). That and the errors of the operands
make the new bound, which is rounded up.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.basis.exact_numbers import Exact, doubles
from quintrig.support.arrays import FloatArray

UNIT = 2.0**-53
"""The largest relative error of one rounding to the nearest double."""

UP = 1.0 + 2.0**-40
"""More than the rounding of a sum of some hundred products of positive numbers."""

LEAST = 1e-300
"""More than what is lost to underflow in a sum of products, while the numbers themselves are far above it."""

Edges = tuple[int, int, int, int]
"""How often u, 1 - u, v and 1 - v divide a form."""


def bound(terms: int) -> float:
    """Return a bound of the relative error of a sum of so many products."""
    return (terms + 2) * UNIT * UP


@dataclass(frozen=True, eq=False)
class Ball:
    """Coefficients ``middle`` (n + 1, m + 1), each off by at most ``radius``."""

    middle: FloatArray
    radius: FloatArray

    @staticmethod
    def constant(value: object) -> "Ball":
        """Return the form of degree 0 of an exact number."""
        return Ball(*doubles(np.array([[value]], dtype=object)))

    @staticmethod
    def blend(u: Exact, net: Exact, v: Exact) -> list["Ball"]:
        """Return the coordinates of Σ u_i net_ij v_j, forms u (n + 1, a), v (m + 1, b) and net (a, b, d)."""
        left, right = doubles(u), doubles(v)
        result: list[Ball] = []
        for k in range(net.shape[2]):
            middle = doubles(net[:, :, k])
            result.append(Ball(*matrix_product(matrix_product(left, middle), (right[0].T, right[1].T))))
        return result

    @property
    def degree(self) -> tuple[int, int]:
        """The bidegree."""
        return self.middle.shape[0] - 1, self.middle.shape[1] - 1

    @property
    def vanishes(self) -> bool:
        """Whether all coefficients are exactly 0."""
        return not (self.middle.any() or self.radius.any())

    def __add__(self, other: "Ball") -> "Ball":
        """Return the sum."""
        middle = self.middle + other.middle
        return Ball(middle, (self.radius + other.radius + UNIT * np.abs(middle)) * UP)

    def __neg__(self) -> "Ball":
        """Return the form with the other sign."""
        return Ball(-self.middle, self.radius)

    def __sub__(self, other: "Ball") -> "Ball":
        """Return the difference."""
        return self + -other

    def __mul__(self, other: "Ball") -> "Ball":
        """Return the product."""
        x, y = (self, other) if self.middle.size <= other.middle.size else (other, self)
        middle = convolution(x.middle, y.middle)
        if x.vanishes or y.vanishes:
            return Ball(middle, np.zeros_like(middle))
        far, near = np.abs(y.middle), np.abs(x.middle)
        rounding = bound(sum(x.middle.shape))
        radius = convolution(near, y.radius + rounding * far)
        if x.radius.any():
            radius = radius + convolution(x.radius, far + y.radius)
        return Ball(middle, (radius + LEAST * (radius > 0.0)) * UP)

    def bracket(self, axis: int, unit: Exact) -> "Ball":
        """Return {σ, F} / 2 along u (``axis`` 0) or v (1)."""
        sigma, off = doubles(unit)
        middle, radius = (_along(array, axis) for array in (self.middle, self.radius))
        n = len(middle) - 1
        k = np.arange(n + 1.0)[:, None]
        factors = ((0.5 * (2.0 * k - n), 1), (k[:-1] + 1.0, 0), (k[1:] - n - 1.0, 2))
        result, error = np.zeros_like(middle), np.zeros_like(middle)
        for (factor, which), (to, of) in zip(factors, (_SAME, _NEXT, _LAST), strict=True):
            part = factor * middle[of]
            result[to] += sigma[which] * part
            size = np.abs(factor)
            error[to] += size * (radius[of] * (abs(sigma[which]) + off[which]) + off[which] * np.abs(middle[of]))
            error[to] += bound(4) * np.abs(sigma[which] * part)
        return Ball(_along(result, axis), _along(error * UP, axis))

    def edges(self) -> Edges:
        """Return how often u, 1 - u, v and 1 - v divide the form, to the last bit."""
        some = (self.middle != 0.0) | (self.radius != 0.0)
        rows, columns = np.flatnonzero(some.any(axis=1)), np.flatnonzero(some.any(axis=0))
        if not len(rows):
            return (0, 0, 0, 0)
        n, m = self.degree
        return int(rows[0]), int(n - rows[-1]), int(columns[0]), int(m - columns[-1])

    def divided(self, edges: Edges) -> "Ball":
        """Return the form without these powers of u, 1 - u, v and 1 - v, which must divide it."""
        n, m = self.middle.shape
        part = (slice(edges[0], n - edges[1]), slice(edges[2], m - edges[3]))
        return Ball(self.middle[part], self.radius[part])

    def multiplied(self, edges: Edges) -> "Ball":
        """Return the form times these powers of u, 1 - u, v and 1 - v."""
        wide = (edges[:2], edges[2:])
        return Ball(np.pad(self.middle, wide), np.pad(self.radius, wide))

    def ball(self) -> "Ball":
        """Return the form itself."""
        return self


_SAME = (slice(None), slice(None))
_NEXT = (slice(None, -1), slice(1, None))
_LAST = (slice(1, None), slice(None, -1))


def _along(array: FloatArray, axis: int) -> FloatArray:
    return array.T if axis else array


def convolution(x: FloatArray, y: FloatArray) -> FloatArray:
    """Return the convolution of two arrays; ``x`` the smaller one.

    A coefficient is a sum of at most as many products as x has rows and columns, in two stages.
    """
    n, m = x.shape
    rows, columns = y.shape
    wide = np.zeros((rows, columns + 2 * (m - 1)))
    wide[:, m - 1 : m - 1 + columns] = y
    shifted = np.lib.stride_tricks.sliding_window_view(wide, columns + m - 1, axis=1)[
        :, ::-1
    ]  # [k, j, l] is y[k, l - j]
    lines = x @ np.ascontiguousarray(
        shifted
    )  # row by row: products so small take no threads, which wait for each other
    result: FloatArray = np.zeros((n + rows - 1, columns + m - 1))
    for k in range(rows):
        result[k : k + n] += lines[k]
    return result


_ALONE = 1 << 18
"""Multiplications below which a library of linear algebra takes no threads."""


def product(x: FloatArray, y: FloatArray) -> FloatArray:
    """Return the matrix product, over blocks of rows: threads for products so small would only wait for each other."""
    rows = max(1, _ALONE // (y.shape[-2] * y.shape[-1]))
    if x.shape[-2] <= rows:
        return x @ y
    return np.concatenate([x[..., i : i + rows, :] @ y for i in range(0, x.shape[-2], rows)], axis=-2)


Pair = tuple[FloatArray, FloatArray]


def matrix_product(x: Pair, y: Pair) -> Pair:
    """Return the product of two matrices of middles and radii."""
    middle = x[0] @ y[0]
    far = np.abs(y[0])
    radius = np.abs(x[0]) @ (y[1] + bound(len(far)) * far) + x[1] @ (far + y[1])
    return middle, (radius + LEAST * (radius > 0.0)) * UP


def total(parts: Sequence[Ball]) -> Ball:
    """Return a sum of forms of one degree."""
    result = parts[0]
    for part in parts[1:]:
        result = result + part
    return result
