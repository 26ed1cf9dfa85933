"""Closed loops of sides: which follows which, and which way each is run through."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError

_OPEN = 0.1  # of the shorter of two edges: farther apart, their ends are no corner


@dataclass(frozen=True, eq=False)
class Bound:
    """One edge of a loop: what it is called, and its points (n, 3) as it runs itself."""

    text: str
    points: FloatArray

    @property
    def ends(self) -> FloatArray:
        """First and last point, (2, 3)."""
        return self.points[[0, -1]]

    @property
    def length(self) -> float:
        """Length of the polygon, length¹."""
        return float(np.linalg.norm(np.diff(self.points, axis=0), axis=-1).sum())


def in_a_loop(bounds: Sequence[Bound]) -> list[tuple[int, bool]]:
    """Return the edges in the order of the loop, the first one forwards, each with whether it is run backwards.

    Raises ModelError where their ends do not meet.
    """
    first = bounds[0]
    found, here = [(0, False)], first.ends[1]
    left = list(range(1, len(bounds)))
    while left:
        away, index, back = min(
            (float(np.linalg.norm(bounds[k].ends[int(back)] - here)), k, back) for k in left for back in (False, True)
        )
        _check(away, bounds[found[-1][0]], bounds[index])
        found.append((index, back))
        left.remove(index)
        here = bounds[index].ends[int(not back)]
    _check(float(np.linalg.norm(here - first.ends[0])), bounds[found[-1][0]], first)
    return found


def _check(away: float, one: Bound, two: Bound) -> None:
    if away > _OPEN * min(one.length, two.length):
        if one is two:
            raise ModelError(
                f"{one.text}: expected a closed edge, found ends {away:.3g} apart; name all the sides of the loop"
            )
        raise ModelError(
            f"{one.text} and {two.text}: expected sides that meet at a corner, found ends {away:.3g} apart"
        )
