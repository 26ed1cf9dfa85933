"""Sums of functions times points, written as an origin plus increments: Σ f_i P_i = O + Σ F_i ΔP_i.

Where the functions sum to 1, O = P_0, ΔP_i = P_{i+1} - P_i and F_i = f_{i+1} + ... + f_n: a term less, and derivatives
of differences of neighbours only, as in a hodograph, so that none loses digits far from the coordinate origin. Other
functions keep their points, with O = 0.
"""

import numpy as np
from numpy.typing import ArrayLike

from quintrig.arrays import FloatArray
from quintrig.basis import Trigonometric
from quintrig.functions import Functions, Joined


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
