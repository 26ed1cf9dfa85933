"""Several families one after the other."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import MOVING, Functions, Still
from quintrig.basis.rational import RationalFunctions, assembled
from quintrig.support.arrays import FloatArray

if TYPE_CHECKING:
    from quintrig.basis import exact_forms


@dataclass(frozen=True)
class Joined(Functions):
    """The functions of several families one after the other."""

    parts: tuple[Functions, ...]

    @property
    def size(self) -> int:
        """Number of functions."""
        return sum(part.size for part in self.parts)

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, size); ValueError for t outside [0, 1]."""
        return np.concatenate([part.derivatives(t, order) for part in self.parts], axis=-1)

    @property
    def breaks(self) -> FloatArray:
        """Parameters from 0 to 1 between two of which every function is analytic."""
        return np.unique(np.concatenate([part.breaks for part in self.parts]))

    @property
    def caveats(self) -> tuple[str, ...]:
        """What a reader must be warned of, from all parts."""
        return tuple(line for part in self.parts for line in part.caveats)

    @property
    def terms(self) -> int:
        """Number of increments: those of all parts."""
        return sum(part.terms for part in self.parts)

    def increments(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` of all F_i, (order + 1, *t.shape, terms); ValueError outside [0, 1]."""
        return np.concatenate([part.increments(t, order) for part in self.parts], axis=-1)

    def split(self, points: FloatArray) -> FloatArray:
        """Return the sum of the parts' origins and all their increments (1 + terms, ...) of points (size, ...)."""
        ends = np.cumsum([part.size for part in self.parts])[:-1]
        pieces = [part.split(p) for p, part in zip(np.split(points, ends), self.parts, strict=True)]
        return np.concatenate([sum(piece[:1] for piece in pieces), *(piece[1:] for piece in pieces)])

    def standing(self, steps: FloatArray) -> Still:
        """Return at which ends all parts stand still, of increments ``steps`` (terms, ...)."""
        edges = np.cumsum([part.terms for part in self.parts])[:-1]
        ends = [part.standing(own) for part, own in zip(self.parts, np.split(steps, edges), strict=True)]
        return all(start for start, _ in ends), all(end for _, end in ends)

    def fill(self, t: FloatArray, out: FloatArray, still: Still = MOVING) -> None:
        """Write derivatives 0 to 2 of the F_i at blocks of parameters (blocks, n) to ``out`` (blocks, 3, terms, n)."""
        start = 0
        for part in self.parts:
            part.fill(t, out[:, :, start : start + part.terms], still)
            start += part.terms

    def rational(self) -> RationalFunctions:
        """Return the exact rational form over common weights; NotRationalError where the parts have none in common."""
        return assembled(self.parts)

    def exact(self) -> "tuple[exact_forms.Span, ...]":
        """Return the functions span by span as exact forms; NotRationalError without a common one."""
        from quintrig.basis import exact_forms  # a proof asks, no small command

        return exact_forms.joined([part.exact() for part in self.parts])
