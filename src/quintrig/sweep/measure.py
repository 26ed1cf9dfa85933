"""Summaries of designs on any grid of nodes: all designs at once where they are affine, else each for itself."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quintrig.geometry.surface import Surface
from quintrig.model.patch import Patch
from quintrig.quantities.classify import Thresholds
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import SINGULAR
from quintrig.sweep.affine import Parts, affine_blend, affine_rows, single_part, weights
from quintrig.sweep.space import DesignSpace
from quintrig.sweep.summarise import COLUMNS, summariser

Nodes = tuple[FloatArray, FloatArray]
"""Parameters (n,) and their weights in a quadrature (n,)."""

_LANES = 8  # the blend is worked out for this many points at once


class Measure(Protocol):
    """Summaries of some designs of a family."""

    def __call__(self, which: NDArray[np.intp], u: Nodes, v: Nodes) -> FloatArray:
        """Return the summaries (n, columns) of the designs numbered ``which`` (n,) on the grid u x v."""
        ...


def affine_measure(patch: Patch, space: DesignSpace, designs: FloatArray, thresholds: Thresholds) -> Measure:
    """Return the measure of designs (n, axes) of a surface that is affine in all that varies."""
    amounts = weights(patch, space, designs)
    # Designs of many classes share the nodes of few, so each is worked out once.
    rows: dict[bytes, FloatArray] = {}
    blends: dict[bytes, FloatArray] = {}

    def measure(which: NDArray[np.intp], u: Nodes, v: Nodes) -> FloatArray:
        along, across = u[0].tobytes(), v[0].tobytes()
        if along not in rows:
            rows[along] = affine_rows(patch, u[0])
        if across not in blends:
            blends[across] = affine_blend(patch, v[0], _block(v))
        return _summarised(patch.surface, Parts(rows[along], blends[across]), amounts[which], u, v, thresholds)

    return measure


def single_measure(surface: Surface, thresholds: Thresholds) -> Measure:
    """Return the measure of one design, numbered 0."""

    def measure(which: NDArray[np.intp], u: Nodes, v: Nodes) -> FloatArray:
        parts = single_part(surface, u[0], v[0], _block(v))
        return _summarised(surface, parts, np.empty((len(which), 0)), u, v, thresholds)

    return measure


def _summarised(
    surface: Surface, parts: Parts, amounts: FloatArray, u: Nodes, v: Nodes, thresholds: Thresholds
) -> FloatArray:
    result = np.empty((len(amounts), len(COLUMNS)))
    block = _block(v)
    padded = np.concatenate([v[1], np.zeros(block - len(v[1]))])
    run = summariser(surface.blend.terms, block)
    settings = (surface.sign, SINGULAR, thresholds.relative, thresholds.flat)
    run(parts.rows, parts.blend, amounts, u[1], padded, *settings, result)
    return result


def _block(v: Nodes) -> int:
    return -(-len(v[0]) // _LANES) * _LANES
