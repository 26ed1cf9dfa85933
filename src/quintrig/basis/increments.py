"""Sums of functions times points, written as an origin plus increments: Σ f_i P_i = O + Σ F_i ΔP_i.

Where the functions sum to 1, O = P_0, ΔP_i = P_{i+1} - P_i and F_i = f_{i+1} + ... + f_n: a term less, and derivatives
of differences of neighbours only, as in a hodograph, so that none loses digits far from the coordinate origin. Other
functions keep their points, with O = 0.
"""

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import Functions, Joined, sin_cos
from quintrig.basis.trigonometric import Trigonometric
from quintrig.support.arrays import FloatArray

Still = tuple[bool, bool]
"""Whether a curve or surface stands still at t = 0, and at t = 1."""

MOVING: Still = (False, False)


def terms(functions: Functions) -> int:
    """Return the number of increments of a family."""
    if isinstance(functions, Joined):
        return sum(terms(part) for part in functions.parts)
    return functions.size - functions.partition


def increments(functions: Functions, t: ArrayLike, order: int) -> FloatArray:
    """Return derivatives 0 to ``order`` of the F_i, shape (order + 1, *t.shape, terms); ValueError outside [0, 1]."""
    if isinstance(functions, Joined):
        return np.concatenate([increments(part, t, order) for part in functions.parts], axis=-1)
    if order and isinstance(functions, Trigonometric):  # the same as sums of derivatives, without cancellation
        return np.concatenate([increments(functions, t, 0), functions.slopes(t, order - 1)])
    derivatives = functions.derivatives(t, order)
    return np.cumsum(derivatives[..., :0:-1], axis=-1)[..., ::-1] if functions.partition else derivatives


def split(points: FloatArray, functions: Functions) -> FloatArray:
    """Return origin and increments (1 + terms, ...) of points (size, ...), one for each function, length¹."""
    if isinstance(functions, Joined):
        ends = np.cumsum([part.size for part in functions.parts])[:-1]
        pieces = [split(p, part) for p, part in zip(np.split(points, ends), functions.parts, strict=True)]
        return np.concatenate([sum(piece[:1] for piece in pieces), *(piece[1:] for piece in pieces)])
    if functions.partition:
        return np.concatenate([points[:1], np.diff(points, axis=0)])
    return np.concatenate([np.zeros_like(points[:1]), points])


def standing(functions: Functions, steps: FloatArray) -> Still:
    """Return whether Σ F_i ΔP_i, with increments ``steps`` (terms, ...), stands still at either end.

    It does where the shape parameter is -4 or the two control points there coincide; both families of a ruled surface
    must.
    """
    if isinstance(functions, Joined):
        edges = np.cumsum([terms(part) for part in functions.parts])[:-1]
        pairs = zip(functions.parts, np.split(steps, edges), strict=True)
        parts = [standing(part, own) for part, own in pairs]
        return all(start for start, _ in parts), all(end for _, end in parts)
    if not isinstance(functions, Trigonometric):
        return MOVING
    return functions.alpha == -4.0 or not steps[0].any(), functions.zeta == -4.0 or not steps[-1].any()


def across(functions: Trigonometric, t: FloatArray, still: Still) -> FloatArray:
    """Return f (G/f)' for the functions G of the hodograph, shape (*t.shape, 5), with f = sin and cos at still ends.

    There S' = f R, and S'' = f' R + f R'. The first part runs along S' and drops out of every curvature, but as S'
    nearly vanishes it is by far the larger one, and its rounding would not drop out.
    """
    return still_factor(t, still)[..., None] * functions.slopes(t, 1, *still)[1]


def still_factor(t: FloatArray, still: Still) -> FloatArray:
    """Return f(t): sin(πt/2) for a still start, times cos(πt/2) for a still end, else 1; shape t.shape."""
    s, c = sin_cos(t)
    return np.where(still[0], s, 1.0) * np.where(still[1], c, 1.0)
