"""Scalar functions of one parameter: what the rows and the blend of every surface are made of.

Each class is a frozen tuple of functions on [0, 1] that knows its derivatives of any order. The Bézier bases
are in ``basis``; here are the elementary ones that the closed-form reference surfaces need.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from quintrig.support import taylor
from quintrig.support.arrays import FloatArray, parameter


class Functions(Protocol):
    """A tuple of ``size`` scalar functions on [0, 1]."""

    @property
    def size(self) -> int:
        """Number of functions."""
        ...

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1."""
        ...

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, size).

        Raises ValueError for t outside [0, 1].
        """
        ...


@dataclass(frozen=True)
class Circular:
    """cos q and sin q, where the angle q runs from ``start`` to ``end``, counted in right angles.

    Whole right angles give exact zeros and ones, so poles and seams are exact.
    """

    start: float
    end: float

    @property
    def size(self) -> int:
        """Number of functions."""
        return 2

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1: they do not."""
        return False

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


@dataclass(frozen=True)
class Hyperbolic:
    """cosh x and sinh x, x running from ``start`` to ``end``."""

    start: float
    end: float

    @property
    def size(self) -> int:
        """Number of functions."""
        return 2

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1: they do not."""
        return False

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
class Powers:
    """1, x, ..., x^degree, x running from ``start`` to ``end``."""

    start: float
    end: float
    degree: int

    @property
    def size(self) -> int:
        """Number of functions."""
        return self.degree + 1

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1: they do not."""
        return False

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, size); ValueError for t outside [0, 1]."""
        t = parameter(t, "t")
        x: FloatArray = np.zeros((order + 1, *t.shape))
        x[0] = self.start + (self.end - self.start) * t
        x[1:2] = self.end - self.start
        return taylor.derivatives(np.stack(taylor.powers(x, self.degree), axis=-1))


@dataclass(frozen=True)
class Joined:
    """The functions of several families one after the other."""

    parts: tuple[Functions, ...]

    @property
    def size(self) -> int:
        """Number of functions."""
        return sum(part.size for part in self.parts)

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1: they do not."""
        return False

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, size); ValueError for t outside [0, 1]."""
        return np.concatenate([part.derivatives(t, order) for part in self.parts], axis=-1)


def sin_cos(turns: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return sine and cosine of ``turns`` right angles, exact at whole ones."""
    whole = np.rint(turns)
    rest = 0.5 * np.pi * (turns - whole)
    sine, cosine = np.sin(rest), np.cos(rest)
    # Adding 0.0 turns the -0.0 of the rotations into 0.0.
    quarter = whole.astype(np.int64) % 4
    choices = ([sine, cosine, -sine, -cosine], [cosine, -sine, -cosine, sine])
    return np.choose(quarter, choices[0]) + 0.0, np.choose(quarter, choices[1]) + 0.0
