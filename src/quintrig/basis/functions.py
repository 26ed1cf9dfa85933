"""Scalar functions of one parameter: what the rows and the blend of every surface are made of.

A family is a frozen tuple of functions on [0, 1] that answers for itself: its derivatives of any order, what it sums
to, its knots, its exact rational form. Who uses it asks it, and never which one it is.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.rational import NotRationalError, RationalFunctions, TangentMap, assembled
from quintrig.support.arrays import FloatArray

if TYPE_CHECKING:
    from quintrig.basis.exact_forms import Span

Still = tuple[bool, bool]
"""Whether a curve or surface stands still at t = 0, and at t = 1."""

MOVING: Still = (False, False)


class Functions(Protocol):
    """A tuple of ``size`` scalar functions on [0, 1].

    A family inherits from this class, gives ``size`` and ``derivatives``, and overrides what else it knows better.

    Sums of functions times points are worked out as an origin plus increments: Σ f_i P_i = O + Σ F_i ΔP_i. Where the
    functions sum to 1, O = P_0, ΔP_i = P_{i+1} - P_i and F_i = f_{i+1} + ... + f_n: a term less, and derivatives of
    differences of neighbours only, as in a hodograph, so that none loses digits far from the coordinate origin. Other
    functions keep their points, with O = 0.
    """

    @property
    def size(self) -> int:
        """Number of functions."""
        ...

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, size).

        Raises ValueError for t outside [0, 1].
        """
        ...

    @property
    def label(self) -> str:
        """The name of the basis under which constructions and model files take it; none for other functions."""
        return ""

    @property
    def outside(self) -> bool:
        """Whether a shape parameter is outside the range that the basis warrants."""
        return False

    @property
    def caveats(self) -> tuple[str, ...]:
        """What a reader of a surface of these functions must be warned of, one sentence each."""
        return ()

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1."""
        return False

    @property
    def parameters(self) -> Mapping[str, float]:
        """Shape parameters by name; none where the family has none."""
        return {}

    @property
    def breaks(self) -> FloatArray:
        """Parameters from 0 to 1 between two of which every function is analytic."""
        return np.array([0.0, 1.0])

    @property
    def terms(self) -> int:
        """Number of increments."""
        return self.size - self.partition

    def increments(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` of the F_i, (order + 1, *t.shape, terms); ValueError outside [0, 1]."""
        derivatives = self.derivatives(t, order)
        return np.cumsum(derivatives[..., :0:-1], axis=-1)[..., ::-1] if self.partition else derivatives

    def split(self, points: FloatArray) -> FloatArray:
        """Return origin and increments (1 + terms, ...) of points (size, ...), one for each function, length¹."""
        if self.partition:
            return np.concatenate([points[:1], np.diff(points, axis=0)])
        return np.concatenate([np.zeros_like(points[:1]), points])

    def standing(self, steps: FloatArray) -> Still:
        """Return at which ends Σ F_i ΔP_i, of increments ``steps`` (terms, ...), stands still in a way known here."""
        return MOVING

    def hodograph(self, t: FloatArray, order: int, still: Still) -> tuple[FloatArray, FloatArray]:
        """Return a factor f(t), shape t.shape, and derivatives 0 to ``order`` of the F_i' / f, (order + 1, *t, terms).

        f vanishes at ends that are ``still``, as ``standing`` returns them, and is 1 where there are none.
        """
        return np.ones(np.shape(t)), self.increments(t, order + 1)[1:]

    def fill(self, t: FloatArray, out: FloatArray, still: Still = MOVING) -> None:
        """Write derivatives 0 to 2 of the F_i at blocks of parameters (blocks, n) to ``out`` (blocks, 3, terms, n).

        Beside ends that are ``still`` the second are f (F_i' / f)', f as ``hodograph`` gives it: there S' = f R and
        S'' = f' R + f R'. The first part runs along S' and drops out of every curvature, but as S' nearly vanishes it
        is by far the larger one, and its rounding would not drop out.
        """
        out[...] = self.increments(t, 2).transpose(1, 0, 3, 2)
        if any(still):
            factor, slopes = self.hodograph(t, 1, still)
            out[:, 2] = (factor[..., None] * slopes[1]).transpose(0, 2, 1)

    def rational(self) -> RationalFunctions:
        """Return the exact rational form; NotRationalError for functions that have none."""
        return assembled((self,))

    def tangent_map(self) -> TangentMap | None:
        """Return the change of parameter that the rational form needs, None where any will do; NotRationalError."""
        raise NotRationalError(f"{type(self).__name__.lower()} functions have no exact rational form")

    def rational_degree(self) -> int:
        """Return the lowest degree of the rational form; NotRationalError where there is none."""
        return self.size - 1

    def numerators(self, to: TangentMap, degree: int) -> FloatArray:
        """Return the numerators' coefficients (n, size) in ``degree`` over the common weights of ``to``."""
        raise NotRationalError(f"{type(self).__name__.lower()} functions have no exact rational form")

    def exact(self) -> "tuple[Span, ...]":
        """Return the functions span by span as forms with exact coefficients; NotRationalError where they are none."""
        raise NotRationalError(f"{self.label or type(self).__name__.lower()} functions are no exact forms")
