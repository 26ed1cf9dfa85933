"""Corners that a fit passes through: conditions on its unknowns that are solved once, so that fewer unknowns remain."""

from collections.abc import Iterable, Iterator
from itertools import product
from typing import Any

import numpy as np

from quintrig.basis.bernstein import Bernstein
from quintrig.geometry.surface import Net, Surface
from quintrig.scan.nearest import Finder
from quintrig.support.arrays import FloatArray
from quintrig.support.scipy_inside import linalg_, sparse_, tree_of

ROUND = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
"""Parameters (u, v) of the corners, in the order in which they are given."""

_MET = 1e-9  # of the size: as near as corners must be met by a kind whose corners hang on each other


def through(
    corners: FloatArray,
    affine: tuple[Any, FloatArray],
    ends: tuple[FloatArray, FloatArray],
    grid: tuple[int, int],
    kind: str,
) -> tuple[Any, FloatArray]:
    """Return how nets follow from the unknowns that remain where the surface passes through ``corners`` (4, 3).

    ``affine`` is how they follow from all unknowns, ``ends`` the values (2, n) and (2, m) of the functions in u and v
    at 0 and 1. Raises ValueError for corners that the kind cannot have.
    """
    matrix, base = affine
    n, m = ends[0].shape[1], ends[1].shape[1]
    rows: list[FloatArray] = []
    nu, nv = grid
    for u, v in ROUND.astype(int):
        row = np.zeros((nu * nv, n, m))
        row[u * (nu - 1) * nv + v * (nv - 1)] = np.outer(ends[0][u], ends[1][v])
        rows.append(row.ravel())
    pick: Any = sparse_.csr_matrix(np.kron(np.array(rows), np.eye(3)))
    held = np.asarray((pick @ matrix).todense())
    wanted = corners.ravel() - np.asarray(pick @ base)
    upper, order = linalg_.qr(held, mode="r", pivoting=True)
    size = np.abs(np.diag(upper))
    rank = int((size > 1e-10 * size[0]).sum())
    settled, left = order[:rank], np.sort(order[rank:])
    inverse = np.linalg.pinv(held[:, settled])
    start = np.zeros(held.shape[1])
    start[settled] = inverse @ wanted
    off = float(np.linalg.norm((held @ start - wanted).reshape(4, 3), axis=1).max())
    if off > _MET:
        why = {"symmetric": "are not images of each other", "swept": "are no parallelogram"}.get(kind, "differ")
        raise ValueError(f"corners: a {kind} surface cannot pass through these, which {why}; take kind tensor")
    # What is settled follows from what is left; most of it from nothing.
    follow = -inverse @ held[:, left]
    follow[np.abs(follow) < 1e-14] = 0.0
    onto = np.zeros(held.shape[1], dtype=np.int64)
    onto[left] = np.arange(len(left))
    own: Any = sparse_.csr_matrix((np.ones(len(left)), (left, onto[left])), shape=(held.shape[1], len(left)))
    led: Any = sparse_.coo_matrix(follow)
    rest: Any = sparse_.csr_matrix((led.data, (settled[led.row], led.col)), shape=own.shape)
    return matrix @ (own + rest), np.asarray(base + matrix @ start)


def halfway(corners: FloatArray) -> FloatArray:
    """Return the plane (a, b, c, d) in the middle between the first and the last corners and the two others."""
    across = corners[[0, 3]].sum(axis=0) - corners[[1, 2]].sum(axis=0)
    normal = across / (float(np.linalg.norm(across)) or 1.0)
    return np.append(normal, -normal @ corners.mean(axis=0))


def ways_between(corners: FloatArray, points: FloatArray, ways: Iterable[FloatArray]) -> Iterator[FloatArray]:
    """Yield parameters (n, 2) of points by the bilinear surface of the corners, then ``ways``, turned to fit them."""
    a, b, c, d = corners
    feet = Finder([Surface(Net(np.array([[a, d], [b, c]]), Bernstein(1)), Bernstein(1))]).feet(points)
    yield np.stack([feet.u, feet.v], axis=1)
    near = np.asarray(tree_of(points).query(corners)[1])
    for at in ways:
        turned = [
            np.abs((at[:, ::-1] if swap else at) - np.array(flip))
            for swap, *flip in product((False, True), (0.0, 1.0), (0.0, 1.0))
        ]
        yield min(turned, key=lambda one: float(((one[near] - ROUND) ** 2).sum()))
