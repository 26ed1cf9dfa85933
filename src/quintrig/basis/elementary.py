"""The elementary functions that surfaces in closed form are made of: circular, hyperbolic, powers."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import Functions
from quintrig.basis.rational import TangentMap, arc_power, bernstein_product, elevated, shared
from quintrig.support import taylor
from quintrig.support.arrays import FloatArray, parameter

if TYPE_CHECKING:
    from quintrig.basis import exact_forms


@dataclass(frozen=True)
class Circular(Functions):
    """cos q and sin q, where the angle q runs from ``start`` to ``end``, counted in right angles.

    Whole right angles give exact zeros and ones, so poles and seams are exact.
    """

    start: float
    end: float

    @property
    def size(self) -> int:
        """Number of functions."""
        return 2

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, 2); ValueError for t outside [0, 1]."""
        t = parameter(t, "t")
        speed = self.end - self.start
        sine, cosine = sin_cos(self.start + speed * t)
        cycle = (cosine, -sine, -cosine, sine)
        rate = 0.5 * np.pi * speed
        return np.stack(
            [np.stack([rate**k * cycle[k % 4], rate**k * cycle[(k + 3) % 4]], axis=-1) for k in range(order + 1)]
        )

    def tangent_map(self) -> TangentMap:
        """Return the map of spans of at most a right angle."""
        turn = abs(self.end - self.start)
        spans = max(1, math.ceil(turn))
        return TangentMap(0.5 * math.pi * turn / spans, spans)

    def rational_degree(self) -> int:
        """Return the degree of the rational form of an arc: 2."""
        return 2

    def numerators(self, to: TangentMap, degree: int) -> FloatArray:
        """Return the numerators' coefficients (n, 2) in ``degree`` over the common weights of ``to``."""
        step = (self.end - self.start) / to.spans
        return shared([self._arc(self.start + k * step, step, degree) for k in range(to.spans)])

    @staticmethod
    def _arc(start: float, turn: float, degree: int) -> FloatArray:
        """Return the numerators (degree + 1, 2) over ``turn`` <= 1 right angles from ``start``."""
        quarter = Circular(start, start + turn).derivatives([0.0, 0.5, 1.0], 0)[0]
        rest = arc_power(math.cos(0.25 * math.pi * abs(turn)), degree - 2)
        return np.stack([bernstein_product(rest, quarter[:, i]) for i in range(2)], axis=-1)

    def exact(self) -> "tuple[exact_forms.Span, ...]":
        """Return the functions span by span as exact forms; NotRationalError for part of a right angle."""
        from quintrig.basis import exact_forms  # a proof asks, no small command

        return exact_forms.circular(self.start, self.end)


@dataclass(frozen=True)
class Hyperbolic(Functions):
    """cosh x and sinh x, x running from ``start`` to ``end``."""

    start: float
    end: float

    @property
    def size(self) -> int:
        """Number of functions."""
        return 2

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, 2); ValueError for t outside [0, 1]."""
        t = parameter(t, "t")
        rate = self.end - self.start
        x = self.start + rate * t
        cycle = (np.cosh(x), np.sinh(x))
        return np.stack(
            [np.stack([rate**k * cycle[k % 2], rate**k * cycle[(k + 1) % 2]], axis=-1) for k in range(order + 1)]
        )


@dataclass(frozen=True)
class Powers(Functions):
    """1, x, ..., x^degree, x running from ``start`` to ``end``."""

    start: float
    end: float
    degree: int

    @property
    def size(self) -> int:
        """Number of functions."""
        return self.degree + 1

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, size); ValueError for t outside [0, 1]."""
        t = parameter(t, "t")
        x: FloatArray = np.zeros((order + 1, *t.shape))
        x[0] = self.start + (self.end - self.start) * t
        x[1:2] = self.end - self.start
        return taylor.derivatives(np.stack(taylor.powers(x, self.degree), axis=-1))

    def tangent_map(self) -> TangentMap | None:
        """Return the identity, or None for the constant, which is rational in any parameter."""
        return None if self.size == 1 else TangentMap()

    def numerators(self, to: TangentMap, degree: int) -> FloatArray:
        """Return the Bernstein coefficients (n, size) in ``degree``; the common weights themselves for the constant."""
        if self.size == 1:
            return to.weights(degree)[:, None]
        return np.stack([self._power(k, degree) for k in range(self.size)], axis=-1)

    def exact(self) -> "tuple[exact_forms.Span, ...]":
        """Return the functions span by span as forms with exact coefficients."""
        from quintrig.basis import exact_forms  # a proof asks, no small command

        return exact_forms.powers(self.start, self.end, self.degree)

    def _power(self, k: int, degree: int) -> FloatArray:
        a, b = self.start, self.end
        return elevated(np.array([a ** (k - i) * b**i for i in range(k + 1)], dtype=np.float64), degree)


def sin_cos(turns: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return sine and cosine of ``turns`` right angles, exact at whole ones."""
    whole = np.rint(turns)
    rest = 0.5 * np.pi * (turns - whole)
    sine, cosine = np.sin(rest), np.cos(rest)
    # Adding 0.0 turns the -0.0 of the rotations into 0.0.
    quarter = whole.astype(np.int64) % 4
    choices = ([sine, cosine, -sine, -cosine], [cosine, -sine, -cosine, sine])
    return np.choose(quarter, choices[0]) + 0.0, np.choose(quarter, choices[1]) + 0.0
