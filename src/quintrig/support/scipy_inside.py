"""What SciPy and NumPy do without saying of which type, said here once."""

from typing import Any, cast

import numpy as np
from scipy import linalg, optimize, sparse, spatial
from scipy.sparse import csgraph
from scipy.sparse import linalg as sparse_linalg

from quintrig.support.arrays import FloatArray

csgraph_: Any = csgraph
linalg_: Any = linalg
optimize_: Any = optimize
sparse_: Any = sparse
sparse_linalg_: Any = sparse_linalg


def tree_of(points: FloatArray) -> Any:
    """Return the KD-tree of points (n, d)."""
    return cast(Any, spatial).cKDTree(points)


def shortest(matrix: Any, right: Any, rcond: float | None = None) -> FloatArray:
    """Return the shortest least-squares solution of linear equations."""
    return cast(FloatArray, np.linalg.lstsq(matrix, right, rcond=rcond)[0])
