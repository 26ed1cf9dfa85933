"""Nodes and weights of Gauss and Legendre, which are eigenvalues of a matrix: found once a process."""

from functools import cache

import numpy as np

from quintrig.support.arrays import FloatArray


@cache
def legendre(count: int) -> tuple[FloatArray, FloatArray]:
    """Return nodes (count,) in (-1, 1) and their weights (count,), exact to degree 2 · count - 1; read only."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    nodes.flags.writeable = weights.flags.writeable = False
    return nodes, weights
