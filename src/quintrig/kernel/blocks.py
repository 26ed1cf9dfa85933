"""Increments in the layout that the compiled driver reads: blocks of points, one row of a block an increment.

Each family fills the blocks itself: by its increments of any order, or by what it has compiled.
"""

import math

import numpy as np

from quintrig.basis.functions import MOVING, Functions, Still
from quintrig.support.arrays import FloatArray, aligned
from quintrig.support.compiled import BLOCK


def increment_blocks(
    functions: Functions, t: FloatArray, room: FloatArray | None = None, still: Still = MOVING
) -> FloatArray:
    """Return derivatives 0 to 2 of all increments at ``t`` (n,), shape (blocks, 3, terms, BLOCK).

    The last block is filled up with the last point. The result lies in the flat array ``room`` where one is given.
    Beside ends that are ``still`` second derivatives are those across the first, as ``Functions.fill`` says.
    """
    padded = pad(t)
    shape = (len(padded), 3, functions.terms, BLOCK)
    result: FloatArray = aligned(shape) if room is None else room[: math.prod(shape)].reshape(shape)
    functions.fill(padded, result, still)
    return result


def pad(t: FloatArray) -> FloatArray:
    """Return (n,) parameters as (blocks, BLOCK), the last block filled up with the last point."""
    count = -(-t.size // BLOCK)
    result: FloatArray = np.empty(count * BLOCK)
    result[: t.size] = t
    result[t.size :] = t[-1]
    return result.reshape(count, BLOCK)
