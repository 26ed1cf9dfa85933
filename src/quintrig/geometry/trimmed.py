"""The region of a trimmed face: nodes and weights to integrate over it, and where its parameters lie.

The domain is cut at the u of every vertex of the loops, so that between two cuts the loops are straight lines from side
to side. At the Gauss-Legendre nodes of each such slab the lines along v that lie inside are cut at the ends of the
panels, and each piece has Gauss-Legendre nodes of its own. No node lies outside, so whatever the carrier does there,
as a pole or an apex that was cut off, does no harm.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.legendre import legendre

_ON_LOOP = 1e-9  # parameters this near to a loop are on it
_SAME = 1e-13  # cuts this near are one
_CHUNK = 1 << 16  # nodes evaluated at once, so that memory stays small


@dataclass(frozen=True, eq=False)
class Nodes:
    """Parameters ``u`` and ``v`` (n,) inside the loops, and the share of the domain that each stands for (n,)."""

    u: FloatArray
    v: FloatArray
    weights: FloatArray

    @property
    def parts(self) -> list[slice]:
        """Slices of nodes that are evaluated at once."""
        return [slice(start, start + _CHUNK) for start in range(0, len(self.u), _CHUNK)]


def along(loop: FloatArray, t: FloatArray) -> FloatArray:
    """Return the points (..., 2) of a closed loop (n, 2) at ``t`` (...): a vertex at each whole number, modulo n."""
    first = np.floor(t).astype(np.intp)
    share = (t - first)[..., None]
    return (1.0 - share) * loop[first % len(loop)] + share * loop[(first + 1) % len(loop)]


def window(loops: Sequence[FloatArray]) -> FloatArray:
    """Return the least and the greatest (u, v) of the loops, (2, 2); those of the domain where there are none."""
    if not loops:
        return np.array([[0.0, 0.0], [1.0, 1.0]])
    points = np.concatenate(loops)
    return np.stack([points.min(axis=0), points.max(axis=0)])


class Inside:
    """Which parameters lie inside closed loops: sides sorted into bands of v, so that a point meets few of them."""

    def __init__(self, loops: Sequence[FloatArray]) -> None:
        """Sort the sides of the loops (n, 2)."""
        self._start: FloatArray = np.concatenate(loops)
        self._end: FloatArray = np.concatenate([np.roll(loop, -1, axis=0) for loop in loops])
        self._bands = min(len(self._start), 2048)
        first = self._band(np.minimum(self._start[:, 1], self._end[:, 1]) - _ON_LOOP)
        count = self._band(np.maximum(self._start[:, 1], self._end[:, 1]) + _ON_LOOP) - first + 1
        side, place = _spread(count)
        band = first[side] + place
        order = np.argsort(band, kind="stable")
        self._sides = side[order]
        self._offsets = np.searchsorted(band[order], np.arange(self._bands + 1))

    def __call__(self, u: FloatArray, v: FloatArray) -> BoolArray:
        """Return for parameters (n,) where a line from them crosses the loops an odd number of times, or on one."""
        parts = [slice(start, start + _CHUNK) for start in range(0, len(u), _CHUNK)]
        found: list[BoolArray] = [self._part(u[part], v[part]) for part in parts]
        return np.concatenate(found) if found else np.zeros(0, dtype=np.bool_)

    def _part(self, u: FloatArray, v: FloatArray) -> BoolArray:
        band = self._band(v)
        point, place = _spread(self._offsets[band + 1] - self._offsets[band])
        side = self._sides[self._offsets[band[point]] + place]
        (u0, v0), (u1, v1) = self._start[side].T, self._end[side].T
        du, dv, right, above = u1 - u0, v1 - v0, u[point] - u0, v[point] - v0
        off = du * above - dv * right
        crossed = ((v0 > v[point]) != (v1 > v[point])) & ((off > 0.0) == (dv > 0.0)) & (dv != 0.0)
        along, square = du * right + dv * above, du * du + dv * dv
        on = (np.abs(off) <= _ON_LOOP * np.sqrt(square)) & (along >= 0.0) & (along <= square) & (square > 0.0)
        odd = np.bincount(point[crossed], minlength=len(u)) % 2 == 1
        result: BoolArray = odd | (np.bincount(point[on], minlength=len(u)) > 0)
        return result

    def _band(self, v: FloatArray) -> NDArray[np.intp]:
        return np.clip(v * self._bands, 0, self._bands - 1).astype(np.intp)


def _spread(counts: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return index and place of as many items as each count says: (0, 0), (0, 1), ..., (1, 0), ..."""
    which = np.repeat(np.arange(len(counts)), counts)
    return which, np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)


def nodes_inside(
    loops: Sequence[FloatArray], u_ends: FloatArray, v_ends: FloatArray, v_breaks: FloatArray, count: int
) -> Nodes:
    """Return the nodes inside the loops, ``count`` on each piece along v, as many along u on slabs as wide as a panel.

    ``u_ends`` and ``v_ends`` are those of the panels; the ``v_breaks`` among them are where integrands are not smooth.
    """
    start = np.concatenate(loops)
    end = np.concatenate([np.roll(loop, -1, axis=0) for loop in loops])
    steep = start[:, 0] == end[:, 0]
    start, end = start[~steep], end[~steep]
    turned = (start[:, 0] > end[:, 0])[:, None]
    start, end = np.where(turned, end, start), np.where(turned, start, end)
    cuts = _cuts(start, end, u_ends, v_breaks)
    widths = np.diff(cuts)
    panel = np.diff(u_ends)[np.clip(np.searchsorted(u_ends, cuts[:-1], side="right") - 1, 0, len(u_ends) - 2)]
    slab, low, high = _strips(start, end, cuts)
    found: list[tuple[FloatArray, FloatArray, FloatArray]] = []
    for nodes, chosen in _rules(widths / panel, count):
        here = chosen[slab]
        s, a = legendre(nodes)
        half = 0.5 * widths[slab[here]]
        u = (cuts[slab[here]] + half)[:, None] + half[:, None] * s
        below, above = (_at(start[e[here]], end[e[here]], u) for e in (low, high))
        found.append((u.ravel(), np.stack([below, above], axis=-1).reshape(-1, 2), (half[:, None] * a).ravel()))
    u, spans, weights = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return _along(u, spans, weights, v_ends, count)


def _cuts(start: FloatArray, end: FloatArray, u_ends: FloatArray, v_breaks: FloatArray) -> FloatArray:
    """Return where slabs end: at panels, at vertices, and where a side crosses a break in v."""
    inner = v_breaks[1:-1]
    rise = (end - start)[:, 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = (inner[:, None] - start[:, 1]) / rise
    crossing = (share > 0.0) & (share < 1.0)
    across = (start[:, 0] + share * (end - start)[:, 0])[crossing]
    cuts = np.unique(np.concatenate([u_ends, start[:, 0], end[:, 0], across]))
    return cuts[np.append(True, np.diff(cuts) > _SAME)]


def _strips(start: FloatArray, end: FloatArray, cuts: FloatArray) -> tuple[NDArray[np.intp], ...]:
    """Return slab, lower and upper side of every part of a slab inside the loops: from the first side to the second."""
    middle = 0.5 * (cuts[:-1] + cuts[1:])
    first, last = np.searchsorted(middle, start[:, 0]), np.searchsorted(middle, end[:, 0])
    side, place = _spread(last - first)
    slab = first[side] + place
    order = np.lexsort((_at(start[side], end[side], middle[slab][:, None])[:, 0], slab))
    side, slab = side[order], slab[order]
    return slab[::2], side[::2], side[1::2]  # every line across closed loops meets an even number of sides


def _rules(ratio: FloatArray, count: int) -> list[tuple[int, BoolArray]]:
    """Return numbers of nodes and the slabs that take them, by their width as a share of their panel's."""
    narrow, slight = ratio <= 1.0 / 64.0, ratio <= 0.25
    few, some = min(3, count), min(6, count)
    return [(few, narrow), (some, slight & ~narrow), (count, ~slight)]


def _at(start: FloatArray, end: FloatArray, u: FloatArray) -> FloatArray:
    """Return v of sides (n, 2) at u (n, m)."""
    share = (u - start[:, :1]) / (end - start)[:, :1]
    return start[:, 1:] + np.clip(share, 0.0, 1.0) * (end - start)[:, 1:]


def _along(u: FloatArray, spans: FloatArray, weights: FloatArray, v_ends: FloatArray, count: int) -> Nodes:
    """Return the nodes on lines along v at ``u`` (n,) over ``spans`` (n, 2), cut at the ends of the panels."""
    below, above = spans[:, 0], spans[:, 1]
    first = np.searchsorted(v_ends, below, side="right")
    last = np.maximum(np.searchsorted(v_ends, above, side="left"), first)
    line, place = _spread(last - first + 1)
    k = first[line] + place
    low = np.maximum(v_ends[np.maximum(k - 1, 0)], below[line])
    high = np.minimum(v_ends[np.minimum(k, len(v_ends) - 1)], above[line])
    half = 0.5 * np.maximum(high - low, 0.0)
    t, w = legendre(count)
    v = (low + half)[:, None] + half[:, None] * t
    every = np.broadcast_to(u[line][:, None], v.shape)
    return Nodes(every.ravel(), np.clip(v, 0.0, 1.0).ravel(), ((weights[line] * half)[:, None] * w).ravel())
