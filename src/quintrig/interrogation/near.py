"""Points that keep a distance free around them."""

import numpy as np

from quintrig.interrogation.near_jit import free, keep, lay, thin
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.memory import address

_CHAINS = 1 << 15


class Near:
    """Points (n, 3) that are kept, to ask whether others are nearer to one than up to ``farthest`` (length¹)."""

    def __init__(self, farthest: float) -> None:
        """Begin without points."""
        self._farthest = farthest
        self._count = 0
        self._points: FloatArray = np.empty((1024, 3))
        self._links = np.empty(1024, dtype=np.int64)
        self._heads = np.full(_CHAINS, -1, dtype=np.int64)

    def add(self, points: FloatArray) -> None:
        """Keep more points, all finite."""
        first, last = self._count, self._count + len(points)
        if last > len(self._points):
            size = max(2 * len(self._points), last)
            self._points = np.concatenate([self._points, np.empty((size - len(self._points), 3))])
            self._links = np.concatenate([self._links, np.empty(size - len(self._links), dtype=np.int64)])
        self._points[first:last] = points
        self._count = last
        keep(address(self._points), first, last, *self._table)

    def free(self, points: FloatArray, reach: float) -> BoolArray:
        """Return which points (n, 3) are finite and have none within ``reach`` (length¹), at most ``farthest``."""
        points, found = np.ascontiguousarray(points), np.empty(len(points), dtype=np.int8)
        free(address(points), len(points), address(self._points), *self._table, reach, address(found))
        return found.astype(np.bool_)

    @property
    def _table(self) -> tuple[float, int, int, int]:
        return self._farthest, address(self._heads), _CHAINS - 1, address(self._links)


def thinned(points: FloatArray, reach: float) -> BoolArray:
    """Return which points (n, 3) are finite and have none before them within ``reach`` (length¹) that is in too."""
    points, found = np.ascontiguousarray(points), np.empty(len(points), dtype=np.int8)
    heads, links = np.full(_CHAINS, -1, dtype=np.int64), np.empty(len(points), dtype=np.int64)
    thin(address(points), len(points), reach, address(heads), _CHAINS - 1, address(links), reach, address(found))
    return found.astype(np.bool_)


def clear_of_itself(points: FloatArray, reach: float, lag: float) -> BoolArray:
    """Return which points (n, 3) of a line have none of it within ``reach`` that is in and lies ``lag`` behind."""
    points, found = np.ascontiguousarray(points), np.empty(len(points), dtype=np.int8)
    arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    heads, links = np.full(_CHAINS, -1, dtype=np.int64), np.empty(len(points), dtype=np.int64)
    table = reach, address(heads), _CHAINS - 1, address(links)
    lay(address(points), address(arc), len(points), *table, reach, lag, address(found))
    return found.astype(np.bool_)
