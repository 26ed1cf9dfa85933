"""The nearest points of a triangle mesh to many points."""

import numpy as np
from numpy.typing import NDArray

from quintrig.scan import nearest_jit
from quintrig.scan.boxes import LEAF, boxed
from quintrig.scan.nearest import in_threads
from quintrig.scan.scan import Scan
from quintrig.support.arrays import FloatArray


class MeshFinder:
    """Finds nearest points on the triangles of a scan."""

    def __init__(self, scan: Scan) -> None:
        """Take a scan that has triangles."""
        triangles = scan.triangles
        if triangles is None:
            raise ValueError("scan: expected a mesh, found points without triangles")
        corners = scan.points[triangles]
        tree = boxed(corners, np.zeros(len(corners)))
        order = np.maximum(tree.order, 0)
        self._corners = np.ascontiguousarray(corners[order].reshape(-1, 9))
        self._boxes = tree.boxes
        sides = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1), axis=-1).reshape(-1, 2)
        _, back, count = np.unique(sides, axis=0, return_inverse=True, return_counts=True)
        self._border: NDArray[np.bool_] = (count[back.reshape(-1)] == 1).reshape(-1, 3)[order]

    def nearest(self, points: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
        """Return the nearest points (n, 3) to points (n, 3), length¹, and which of them lie on the mesh's border."""
        points = np.ascontiguousarray(points)
        found, which = np.empty((len(points), 3)), np.zeros(len(points), dtype=np.int64)

        def work(part: slice) -> None:
            nearest_jit.nearest_triangle(points[part], self._boxes, self._corners, LEAF, found[part], which[part])

        in_threads(work, len(points))
        corners = self._corners[which].reshape(-1, 3, 3)
        s, t = found[:, 1], found[:, 2]
        shares = np.stack([1.0 - s - t, s, t], axis=1)
        foot = np.einsum("ni,nix->nx", shares, corners)
        # Side k runs from corner k to the next: the third corner has no share in its points.
        on = np.roll(shares, -2, axis=1) <= 1e-12
        border: NDArray[np.bool_] = np.asarray((on & self._border[which]).any(axis=1))
        return foot, border
