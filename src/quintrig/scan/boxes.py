"""A tree of boxes around triangles, as arrays that compiled loops run through."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quintrig.support.arrays import FloatArray

LEAF = 4
"""Triangles of a leaf."""


@dataclass(frozen=True, eq=False)
class Boxes:
    """A heap of boxes (2 leaves, 6): node k has the children 2k and 2k + 1, the root is 1; ``order`` of the triangles.

    -1 in ``order`` stands for no triangle: leaves are filled up with those.
    """

    boxes: FloatArray
    order: NDArray[np.int64]


def boxed(corners: FloatArray, slack: FloatArray) -> Boxes:
    """Return the boxes of triangles (m, 3, 3), each grown by its slack (m,), length¹."""
    low, high = corners.min(axis=1) - slack[:, None], corners.max(axis=1) + slack[:, None]
    order = np.argsort(_along_curve(corners.mean(axis=1)), kind="stable")
    leaves = 1
    while leaves * LEAF < len(order):
        leaves *= 2
    # Spread evenly, so that the tree is balanced whatever the number of triangles.
    at = np.arange(leaves * LEAF) * len(order) // (leaves * LEAF)
    first = np.concatenate([[True], np.diff(at) > 0])
    filled = np.where(first, order[at], -1).astype(np.int64)
    gone = filled < 0
    lows, highs = low[filled], high[filled]
    lows[gone], highs[gone] = np.inf, -np.inf
    result = np.empty((2 * leaves, 6))
    result[leaves:, :3] = lows.reshape(leaves, LEAF, 3).min(axis=1)
    result[leaves:, 3:] = highs.reshape(leaves, LEAF, 3).max(axis=1)
    count = leaves
    while count > 1:
        count //= 2
        pair = result[2 * count : 4 * count].reshape(count, 2, 6)
        result[count : 2 * count, :3] = pair[:, :, :3].min(axis=1)
        result[count : 2 * count, 3:] = pair[:, :, 3:].max(axis=1)
    return Boxes(result, filled)


def _along_curve(points: FloatArray) -> NDArray[np.uint64]:
    """Return the places of points along Morton's curve, which keeps neighbours together."""
    low = points.min(axis=0)
    span = float((points.max(axis=0) - low).max()) or 1.0
    cells = np.clip((points - low) / span * 1023.0, 0, 1023).astype(np.uint64)
    code = np.zeros(len(points), dtype=np.uint64)
    for bit in range(10):
        for axis in range(3):
            code |= ((cells[:, axis] >> np.uint64(bit)) & np.uint64(1)) << np.uint64(3 * bit + axis)
    return code
