"""The derivatives of rows and blend as functions of the design, at the points of a sweep.

A surface built from control points is affine in each shape parameter, so five evaluations give all designs by a
weighted sum (Misro et al. 2017, from the form of f0, f1, f4 and f5). They are taken at -4, where an edge stands still,
and with each parameter far outside its range: so neither the small derivatives of designs near -4 nor the differences
that the parameters are multiplied with suffer from cancellation.
"""

from dataclasses import dataclass

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.kernel.evaluate import row_derivatives
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray
from quintrig.sweep.space import DesignSpace

_BASE = -4.0
_STEP = 2.0**20  # a power of two, so that dividing by it rounds nothing


@dataclass(frozen=True, eq=False)
class Parts:
    """Derivatives of origin and row increments (1 + p, nu, 9 (1 + terms)) and of the blend's (1 + p, 3 terms block).

    The first part plus each other times its weight gives a design.
    """

    rows: FloatArray
    blend: FloatArray


def is_affine(patch: Patch, space: DesignSpace) -> bool:
    """Tell whether every varied parameter is a shape parameter of a surface built from control points."""
    definition = patch.definition
    return definition.affine and definition.standard and set(space.names) <= set(definition.acting)


def affine_rows(patch: Patch, u: FloatArray) -> FloatArray:
    """Return the ``rows`` of ``Parts`` at u (nu,), for the weights of ``weights``; in powers of length¹."""
    return _parts([_rows(surface, u) for surface in _corners(patch)])


def affine_blend(patch: Patch, v: FloatArray, block: int) -> FloatArray:
    """Return the ``blend`` of ``Parts`` at v (n,) for ``block`` >= n points, for the weights of ``weights``."""
    return _parts([_blend(surface, v, block) for surface in _corners(patch)])


def single_part(surface: Surface, u: FloatArray, v: FloatArray, block: int) -> Parts:
    """Return the only part of one design, for parameters that are not affine."""
    return Parts(_rows(surface, u)[None], _blend(surface, v, block)[None])


def weights(patch: Patch, space: DesignSpace, designs: FloatArray) -> FloatArray:
    """Return the weights (n, 4) of designs (n, axes), from (α1, ζ1, α2, ζ2); those not varied are the model's."""
    result = np.tile(np.array(patch.shape), (len(designs), 1))
    for column, name in enumerate(space.names):
        result[:, patch.definition.shape_names.index(name)] = designs[:, column]
    return result - _BASE


def amounts_above(amounts: FloatArray, ruled: bool) -> FloatArray:
    """Return how far from standing still a design is across each edge, (n, 4), from 4 + (α1, ζ1, α2, ζ2).

    Across the sides of a ruled surface nothing stands still, but near a corner where one boundary nearly does and the
    other does not the curvature changes as fast along u = 0 or u = 1.
    """
    if not ruled:
        return amounts
    first, second = amounts[:, :2], amounts[:, 2:]
    with np.errstate(divide="ignore", invalid="ignore"):
        sides = [np.nan_to_num(a / b, nan=0.0, posinf=0.0).clip(0.0) for a, b in ((first, second), (second, first))]
    ends = np.minimum(first, second)
    return np.column_stack([ends, *(_least(side) for side in sides)])


def _least(side: FloatArray) -> FloatArray:
    """Return the least positive number of each row, 0 where there is none."""
    least = np.where(side > 0.0, side, np.inf).min(axis=1)
    return np.where(np.isfinite(least), least, 0.0)


def _corners(patch: Patch) -> list[Surface]:
    """Return the surfaces that span all designs: at the base, and a step from it in each parameter."""
    shapes = _BASE + _STEP * np.vstack([np.zeros(4), np.eye(4)])
    definition = patch.definition
    return [
        definition.model_copy(update={"shape": shape, "unchecked_shape": True}).surface() for shape in shapes.tolist()
    ]


def _parts(found: list[FloatArray]) -> FloatArray:
    return np.stack([found[0], *((part - found[0]) / _STEP for part in found[1:])])


def _rows(surface: Surface, u: FloatArray) -> FloatArray:
    return np.ascontiguousarray(row_derivatives(surface, u).reshape(len(u), -1))


def _blend(surface: Surface, v: FloatArray, block: int) -> FloatArray:
    padded = np.concatenate([v, np.full(block - len(v), v[-1])])
    return np.ascontiguousarray(surface.blend.increments(padded, 2).transpose(0, 2, 1).reshape(-1))
