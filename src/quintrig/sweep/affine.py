"""The derivatives of rows and blend as functions of the design, at the points of a sweep.

A surface built from control points is affine in each shape parameter, so five evaluations give all designs by a
weighted sum (Misro et al. 2017, from the form of f0, f1, f4 and f5). They are taken at -4, where an edge stands still,
and with each parameter far outside its range: so neither the small derivatives of designs near -4 nor the differences
that the parameters are multiplied with suffer from cancellation.
"""

from dataclasses import dataclass

import numpy as np

from quintrig.arrays import FloatArray
from quintrig.definition import Bezier, Swung
from quintrig.evaluate import row_derivatives
from quintrig.increments import increments
from quintrig.model import Patch
from quintrig.surface import Surface
from quintrig.sweep.space import SHAPE_NAMES, DesignSpace, parameters

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
    trigonometric = isinstance(patch.definition, Bezier) and patch.definition.basis == "trigonometric"
    return trigonometric and set(space.names) <= set(SHAPE_NAMES)


def affine_parts(patch: Patch, u: FloatArray, v: FloatArray, block: int) -> Parts:
    """Return the parts for the weights of ``weights``."""
    shapes = _BASE + _STEP * np.vstack([np.zeros(4), np.eye(4)])
    rows, blends = zip(*(_derivatives(_at(patch, shape.tolist()), u, v, block) for shape in shapes), strict=True)
    return Parts(
        np.stack([rows[0], *((row - rows[0]) / _STEP for row in rows[1:])]),
        np.stack([blends[0], *((blend - blends[0]) / _STEP for blend in blends[1:])]),
    )


def single_part(surface: Surface, u: FloatArray, v: FloatArray, block: int) -> Parts:
    """Return the only part of one design, for parameters that are not affine."""
    rows, blend = _derivatives(surface, u, v, block)
    return Parts(rows[None], blend[None])


def with_parameters(patch: Patch, values: dict[str, float]) -> Patch:
    """Return the patch with some of its parameters replaced."""
    known = parameters(patch) | values
    if isinstance(patch.definition, Swung):
        scale = known.pop("scale")
        patch = patch.with_scale(scale)
    return patch.with_shape(list(known.values())) if known else patch


def weights(patch: Patch, space: DesignSpace, designs: FloatArray) -> FloatArray:
    """Return the weights (n, 4) of designs (n, axes), from (α1, ζ1, α2, ζ2); those not varied are the model's."""
    result = np.tile(np.array(patch.shape), (len(designs), 1))
    for column, name in enumerate(space.names):
        result[:, SHAPE_NAMES.index(name)] = designs[:, column]
    return result - _BASE


def _at(patch: Patch, shape: list[float]) -> Surface:
    """Return the surface of any shape parameters."""
    return patch.definition.model_copy(update={"shape": shape, "unchecked_shape": True}).surface()


def _derivatives(surface: Surface, u: FloatArray, v: FloatArray, block: int) -> tuple[FloatArray, FloatArray]:
    rows = row_derivatives(surface, u).reshape(len(u), -1)
    padded = np.concatenate([v, np.full(block - len(v), v[-1])])
    blend = increments(surface.blend, padded, 2).transpose(0, 2, 1).reshape(-1)
    return np.ascontiguousarray(rows), np.ascontiguousarray(blend)
