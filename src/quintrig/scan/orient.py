"""Normals of points, and the side they point to: that of triangles, of given normals, or of neighbours in turn."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.scan.scan import Scan
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.scipy_inside import csgraph_, sparse_

LINKS = 8  # neighbours over which the side is handed on


def planes(points: FloatArray, near: NDArray[np.int64]) -> FloatArray:
    """Return frames (n, 3, 3), rows e1, e2, n, of the planes through the neighbours ``near`` (n, k) of points."""
    result = np.empty((len(near), 3, 3))
    for start in range(0, len(near), 100_000):
        part = slice(start, start + 100_000)
        local = points[near[part]]
        local = local - local.mean(axis=1, keepdims=True)
        _, vectors = np.linalg.eigh(np.einsum("nki,nkj->nij", local, local))
        result[part] = np.swapaxes(vectors, 1, 2)[:, ::-1]
    return result


def sides(scan: Scan, normals: FloatArray, near: NDArray[np.int64], at: NDArray[np.int64]) -> tuple[FloatArray, str]:
    """Return +1 or -1 for each normal (n, 3) at the points ``at``, and in words which side they then point to.

    ``near`` numbers the neighbours among those points, themselves first.
    """
    given = scan.normals if scan.normals is not None else corner_normals(scan)
    if given is not None:
        along = np.einsum("ij,ij->i", normals, given[at])
        words = "the normals that the file gives" if scan.normals is not None else "the triangles' side"
        return np.where(along < 0.0, -1.0, 1.0), words
    links = near[:, 1 : 1 + LINKS]
    rows = np.repeat(np.arange(len(near)), links.shape[1])
    columns = links.ravel()
    like = np.abs(np.einsum("ij,ij->i", normals[rows], normals[columns]))
    graph = sparse_.csr_matrix((1.0 + 1e-6 - np.minimum(like, 1.0), (rows, columns)), shape=(len(near), len(near)))
    tree: Any = csgraph_.minimum_spanning_tree(graph.maximum(graph.T))
    count, label = csgraph_.connected_components(tree, directed=False)
    result = np.ones(len(near))
    top = scan.points[at, 2]
    for part in range(count):
        mine = np.flatnonzero(label == part) if count > 1 else np.arange(len(near))
        start = int(mine[np.argmax(top[mine])])
        order, before = csgraph_.breadth_first_order(tree, start, directed=False)
        result[start] = 1.0 if normals[start, 2] >= 0.0 else -1.0
        turn = np.where(np.einsum("ij,ij->i", normals[order[1:]], normals[before[order[1:]]]) < 0.0, -1.0, 1.0)
        for index, one in zip(order[1:].tolist(), turn.tolist(), strict=True):
            result[index] = result[before[index]] * one
    return result, "upwards at the highest point, and to the same side from there"


def corner_normals(scan: Scan) -> FloatArray | None:
    """Return the normals of a mesh's points, means of their triangles' by area; None without triangles."""
    if scan.triangles is None:
        return None
    a, b, c = (scan.points[scan.triangles[:, k]] for k in range(3))
    face = np.cross(b - a, c - a)
    result = np.zeros_like(scan.points)
    for k in range(3):
        np.add.at(result, scan.triangles[:, k], face)
    length = np.linalg.norm(result, axis=1, keepdims=True)
    return result / np.where(length > 0.0, length, 1.0)


def rim(scan: Scan) -> BoolArray | None:
    """Return which points of a mesh lie on its border; None without triangles."""
    if scan.triangles is None:
        return None
    t = scan.triangles
    ends = np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1)
    found, count = np.unique(ends, axis=0, return_counts=True)
    result = np.zeros(len(scan.points), dtype=np.bool_)
    result[found[count == 1].ravel()] = True
    return result
