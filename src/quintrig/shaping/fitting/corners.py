"""Corners that a fit passes through: conditions on its unknowns that are solved once, so that fewer unknowns remain."""

from collections.abc import Iterable, Iterator, Sequence
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

_SAME = 1e-3  # of the size: ends of edges as near as that are one corner
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


def corners_of(sides: Sequence[FloatArray], points: FloatArray) -> FloatArray | None:
    """Return the corners (4, 3), in turn, of given edges, each (n, 3); None where they do not tell them.

    Where there are but three, of two edges that meet, the fourth is the point that lies nearest to the parallelogram.
    """
    if not 2 <= len(sides) <= 4:
        return None
    found: list[FloatArray] = []
    links: list[tuple[int, int]] = []
    size = float(np.linalg.norm(np.ptp(np.concatenate(list(sides)), axis=0)))
    for side in sides:
        ends: list[int] = []
        for end in (side[0], side[-1]):
            near = [k for k, one in enumerate(found) if np.linalg.norm(one - end) <= _SAME * size]
            if not near:
                found.append(end)
            ends.append(near[0] if near else len(found) - 1)
        links.append((ends[0], ends[1]))
    if len(found) == 3 and len(sides) == 2:
        middle = next((k for k in range(3) if sum(k in link for link in links) == 2), None)
        if middle is None:
            return None
        one, other = (found[k] for k in range(3) if k != middle)
        guess = one + other - found[middle]
        last = points[int(((points - guess) ** 2).sum(axis=1).argmin())]
        return np.array([found[middle], one, last, other])
    if len(found) != 4 or any(a == b for a, b in links):
        return None
    a, b = links[0]
    c, d = (k for k in range(4) if k not in (a, b))
    linked = {frozenset(link) for link in links}
    rounds = [(a, b, c, d), (a, b, d, c)]

    def cost(way: tuple[int, ...]) -> tuple[int, float]:
        """Edges that would be diagonals, then the length of the round."""
        across = sum(frozenset((way[k], way[k + 2])) in linked for k in (0, 1))
        return across, float(sum(np.linalg.norm(found[way[k]] - found[way[k - 1]]) for k in range(4)))

    return np.array([found[k] for k in min(rounds, key=cost)])


def on_sides(at: FloatArray, points: FloatArray, border: FloatArray, groups: Sequence[int]) -> FloatArray:
    """Return parameters (n, 2) of points and of border points after them, those on the nearest sides of the square.

    Border points in ``groups`` of so many are on one side each.
    """
    if not len(border):
        return at
    near = at[np.asarray(tree_of(points).query(border)[1])].copy()
    gaps = np.concatenate([near, 1.0 - near], axis=1)  # from u = 0, v = 0, u = 1, v = 1
    side = gaps.argmin(axis=1)
    start = 0
    for count in groups:
        part = slice(start, start + count)
        side[part] = gaps[part].mean(axis=0).argmin()
        start += count
    rows = np.arange(len(near))
    near[rows, side % 2] = (side >= 2).astype(np.float64)
    return np.concatenate([at, near])
