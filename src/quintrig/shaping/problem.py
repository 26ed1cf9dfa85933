"""A design as numbers to search: the unknowns, what is minimised, and the conditions."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.shaping.conditions import Condition, Integral
from quintrig.shaping.energies import quadratic
from quintrig.shaping.places import Near
from quintrig.shaping.unknowns import State, Unknowns
from quintrig.support.arrays import FloatArray


@dataclass(eq=False)
class Problem:
    """The unknowns, what is minimised (an integral, nearness, or None: the least change), and the conditions.

    Searched are y (q,), with unknowns ``start`` + ``basis`` y: one step of size 1 changes the objective by about 1.
    """

    space: Unknowns
    objective: Integral | Near | None
    conditions: Sequence[Condition]
    basis: FloatArray
    scale: float

    def unknowns(self, y: FloatArray) -> FloatArray:
        """Return the unknowns of a place in the search."""
        return self.space.start + self.basis @ y

    def state(self, y: FloatArray) -> State:
        """Return the patch there."""
        return self.space.at(self.unknowns(y))

    def least(self, state: State, y: FloatArray) -> tuple[float, FloatArray]:
        """Return the objective, scaled, and its gradient by y."""
        if self.objective is None:
            return float(y @ y), 2.0 * y
        if isinstance(self.objective, Near):
            value, gradient = self.objective.mean_square(state, self.scale)
            return value, gradient @ self.basis
        value, gradient = self.objective.value(state)
        return value / self.scale, gradient @ self.basis / self.scale


def search_basis(space: Unknowns, smooth: bool) -> FloatArray:
    """Return steps of the unknowns (n, q): free coordinates by the root of an energy's form, parameters by ranges.

    ``smooth``: the form is the thin-plate energy's, with a little of the mean square change; else that alone.
    """
    count, free = space.coordinates, space.directions.shape[1]
    width = space.high - space.low
    basis: FloatArray = np.zeros((len(space.start), free + len(space.start) - count))
    basis[count:, free:] = np.diag(0.25 * width[count:])
    if not count:
        return basis
    if space.of is None:
        basis[:count, :free] = space.directions * 0.25 * width[0]
        return basis
    choice = space.directions
    forms_of = [quadratic(space.of, order).form[np.ix_(space.chosen, space.chosen)] for order in (2, 0)]
    plate, mass = (choice.T @ form @ choice for form in forms_of)
    plate, mass = (form / (np.trace(form) / free or 1.0) for form in (plate, mass))
    sizes, vectors = np.linalg.eigh(plate + 1e-5 * mass if smooth else mass)
    kept = sizes > 1e-9 * sizes[-1]  # a swept surface stands still where its curves shift against each other
    root = vectors[:, kept] / np.sqrt(sizes[kept])
    moves = choice @ root
    moves *= 0.1 * width[0] / float(np.median(np.abs(moves).max(axis=0)))
    return np.block([[moves, np.zeros((count, len(width) - count))], [np.zeros((len(width) - count, moves.shape[1])),
                     basis[count:, free:]]])  # fmt: skip
