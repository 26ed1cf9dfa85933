"""The Bernstein polynomials: classical Bézier forms, and the exact rational form of trigonometric ones."""

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import MOVING, Functions, Still
from quintrig.basis.rational import TangentMap, elevated
from quintrig.support import taylor
from quintrig.support.arrays import FloatArray, parameter, whole

if TYPE_CHECKING:
    from quintrig.basis import exact_forms

if TYPE_CHECKING:
    from quintrig.basis.tape import Tape

_COMPILED = 63  # degrees that the compiled loop takes; the grammar's powers end there


@dataclass(frozen=True)
class Bernstein(Functions):
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
    def label(self) -> str:
        """The name of the basis."""
        return "bernstein"

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

    def fill(self, t: FloatArray, out: FloatArray, still: Still = MOVING) -> None:
        """Write derivatives 0 to 2 of the F_i at blocks of BLOCK parameters (blocks, BLOCK) to ``out``, compiled."""
        if not 1 <= self.degree <= _COMPILED:
            super().fill(t, out, still)
            return
        _tape(self.degree).fill(t, True, out)

    def tangent_map(self) -> TangentMap | None:
        """Return the identity, or None for the constant, which is rational in any parameter."""
        return None if self.size == 1 else TangentMap()

    def numerators(self, to: TangentMap, degree: int) -> FloatArray:
        """Return the coefficients (n, size) in ``degree``; the common weights themselves for the constant."""
        return to.weights(degree)[:, None] if self.size == 1 else elevated(np.eye(self.size), degree)

    def exact(self) -> "tuple[exact_forms.Span, ...]":
        """Return the functions span by span as forms with exact coefficients."""
        from quintrig.basis import exact_forms  # a proof asks, no small command

        return exact_forms.bernstein(self.degree)


@dataclass(frozen=True)
class TangentBernstein(Functions):
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


def bernstein_series(x: FloatArray, rest: FloatArray, degree: int) -> FloatArray:
    """Return the series of C(n, i) x^i (1 - x)^(n - i), shape (*x.shape, degree + 1), given x and 1 - x apart."""
    up, down = taylor.powers(x, degree), taylor.powers(rest, degree)
    terms = [math.comb(degree, i) * taylor.product(up[i], down[degree - i]) for i in range(degree + 1)]
    return np.stack(terms, axis=-1)


@lru_cache(maxsize=_COMPILED)
def _tape(degree: int) -> "Tape":
    """Return the polynomials as operations for the compiled loop."""
    from quintrig.basis.grammar import parse
    from quintrig.basis.tape import tape

    return tape([parse(f"{math.comb(degree, i)}*t^{i}*r^{degree - i}") for i in range(degree + 1)], {})
