"""Regions of umbilics in a part of a face, such as flat spans of a B-spline surface, by the cells of a grid."""

from dataclasses import dataclass, field

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.local import Local
from quintrig.interrogation.umbilic import Region
from quintrig.support.arrays import BoolArray, FloatArray

_ROUND = 1e-12  # of the scale: a spread of κ1 and κ2 that is rounding, also where both part very slowly
_FEWEST = 16  # cells: what is smaller is a point around which they do

Cell = tuple[int, int]


@dataclass(frozen=True, eq=False)
class Parts:
    """The regions, and a grid u (n,), v (m,) with the cells (n - 1, m - 1) that lie in one or beside one."""

    regions: list[Region] = field(default_factory=list[Region])
    u: FloatArray = field(default_factory=lambda: np.zeros(2))
    v: FloatArray = field(default_factory=lambda: np.zeros(2))
    cells: BoolArray = field(default_factory=lambda: np.zeros((1, 1), dtype=np.bool_))

    @property
    def nodes(self) -> BoolArray:
        """The nodes (n, m) of these cells."""
        wide = np.pad(self.cells, 1)
        return wide[:-1, :-1] | wide[1:, :-1] | wide[:-1, 1:] | wide[1:, 1:]

    def hold(self, uv: FloatArray) -> bool:
        """Return whether a place (2,) is in a region or beside one."""
        i, j = (sum((t <= x).tolist()) - 1 for t, x in zip((self.u, self.v), uv.tolist(), strict=True))
        n, m = self.cells.shape
        return bool(self.cells[min(max(i, 0), n - 1), min(max(j, 0), m - 1)])


def parts_of(name: str, surface: Surface, u: FloatArray, v: FloatArray, local: Local, scale: FloatArray) -> Parts:
    """Return the regions of a patch that are wide enough on a grid of nodes u (n,), v (m,)."""
    with np.errstate(invalid="ignore"):
        node = local.spread <= _ROUND * scale
    cells = node[:-1, :-1] & node[1:, :-1] & node[1:, 1:] & node[:-1, 1:]
    left = {(int(i), int(j)) for i, j in np.argwhere(cells)}
    found: list[Region] = []
    taken: BoolArray = np.zeros(np.add(cells.shape, 2), dtype=np.bool_)
    while left:
        part = _connected(left)
        if len(part) < _FEWEST:
            continue
        outline = np.array([[u[i], v[j]] for i, j in _outline(part)])
        curvature = float(np.median([local.mean[cell] for cell in part]))
        found.append(Region(name, "region", curvature, outline, surface(*outline.T)))
        for i, j in part:
            taken[i : i + 3, j : j + 3] = True
    return Parts(found, u, v, taken[1:-1, 1:-1])


def _connected(left: set[Cell]) -> set[Cell]:
    """Take the cells that hang together with one of them."""
    here = [left.pop()]
    for i, j in here:
        for cell in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
            if cell in left:
                left.discard(cell)
                here.append(cell)
    return set(here)


def _outline(cells: set[Cell]) -> list[Cell]:
    """Return the nodes along the longest boundary of cells, against the clock."""
    sides: set[tuple[Cell, Cell]] = set()
    for i, j in cells:
        ring = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
        for side in zip(ring, [*ring[1:], ring[0]], strict=True):
            if side[::-1] in sides:
                sides.discard(side[::-1])
            else:
                sides.add(side)
    best: list[Cell] = []
    after = dict(sorted(sides))
    while after:
        start, at = after.popitem()
        loop = [start]
        while at in after:
            loop.append(at)
            at = after.pop(at)
        best = max(best, loop, key=len)
    return best
