"""A basis from formulas at samples of [0, 1] and of the range of its parameters: what its checks look at."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from quintrig.basis.expression import series
from quintrig.basis.formula_checks import corners
from quintrig.basis.formulas import Basis
from quintrig.support.arrays import FloatArray

TIMES: FloatArray = 0.5 - 0.5 * np.cos(np.pi * np.linspace(0.0, 1.0, 201))
"""Parameters t, denser at the ends; symmetric about 1/2."""

_HIGHEST = 16  # order of a derivative at the ends
_NOUGHT = 1e-9  # of the functions' largest Taylor coefficient there
_BETWEEN = 120  # random values of the parameters, beside the corners of the range


@dataclass(frozen=True)
class Finding:
    """Whether a property holds, by how much it is missed at worst, and where: t and the parameters by name."""

    holds: bool
    worst: float
    at: dict[str, float]
    how: str = "sampled"


@dataclass(frozen=True)
class Samples:
    """A basis, and ``values`` (n, parameters): the starting ones first, then the range's corners and its inside."""

    basis: Basis

    @cached_property
    def values(self) -> FloatArray:
        """The samples of the parameters (n, parameters)."""
        ends = corners(self.basis.parameters)
        first = np.array(self.basis.starts).reshape(1, -1)
        low, high = ends.min(axis=0), ends.max(axis=0)
        count = _BETWEEN if ends.shape[1] else 0
        inside = low + (high - low) * np.random.default_rng(5).random((count, ends.shape[1]))
        return np.concatenate([first, ends, inside])

    @cached_property
    def functions(self) -> FloatArray:
        """The functions (n, times, size)."""
        return self.derivatives(self.values, TIMES, 0)[0]

    def derivatives(self, values: FloatArray, t: FloatArray, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, (order + 1, len(values), len(t), size), of any values."""
        columns = {one.name: values[:, i, None] for i, one in enumerate(self.basis.parameters)}
        found = series(self.basis.trees, t[None, :], order, columns)
        factorials = np.cumprod(np.maximum(np.arange(order + 1.0), 1.0))
        shape = (order + 1, len(values), len(t), self.basis.size)
        return np.broadcast_to(found * factorials[:, None, None, None], shape)

    def below(self, values: FloatArray) -> FloatArray:
        """Return where functions leave 0 downwards at t = 0 or 1, (len(values), 2), by too little for samples to see.

        The first derivative that is not 0 tells, at t = 1 with the sign of its order.
        """
        order = min(2 * self.basis.size, _HIGHEST)
        terms = self.derivatives(values, np.array([0.0, 1.0]), order)
        terms = terms / np.cumprod(np.maximum(np.arange(order + 1.0), 1.0))[:, None, None, None]
        terms = terms * np.array([np.ones(order + 1), (-1.0) ** np.arange(order + 1)]).T[:, None, :, None]
        there = np.abs(terms) > _NOUGHT * np.abs(terms).max(axis=(0, 3), keepdims=True)[0]
        first = np.take_along_axis(terms, there.argmax(axis=0)[None], axis=0)[0]
        return (there.any(axis=0) & (first < 0.0)).any(axis=-1)

    def worst(self, amount: FloatArray, limit: float, t: FloatArray = TIMES) -> Finding:
        """Return the largest of amounts (n, times), or (n,) where t has no part, against a limit."""
        amount = np.where(np.isnan(amount), np.inf, amount)
        place = np.unravel_index(int(amount.argmax()), amount.shape)
        at = {"t": float(t[place[1]])} if amount.ndim == 2 else {}
        value = float(amount[place])
        return Finding(value <= limit, value, at | self.named(int(place[0])))

    def named(self, row: int) -> dict[str, float]:
        """Return one sample of the parameters by name."""
        return {one.name: float(self.values[row, i]) for i, one in enumerate(self.basis.parameters)}
