"""The nearest points of surfaces to many points: nothing missed at folds and edges, a million points in seconds.

Each surface is held as polynomial pieces that meet it within 1e-11 of its size, and as triangles with a bound on how
far the surface is from each. The search in ``nearest_jit`` needs nothing else, whatever the surface is made of; the
points that it finds are then taken on the surface itself.
"""

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.analysis.sample import analyse
from quintrig.geometry.surface import Surface
from quintrig.scan import nearest_jit
from quintrig.scan.boxes import LEAF, boxed
from quintrig.support.arrays import FloatArray
from quintrig.support.progress import Progress
from quintrig.support.scipy_inside import tree_of

_TWIN = 1e-11  # of the size: how near the polynomial pieces come to the surface
_FEWEST, _FINEST = 8, 64  # pieces along a parameter between two breaks
_TRIANGLES = 32  # cells of triangles along a parameter, at least
_SAFETY = 1.5  # on the bound of second derivatives, which is taken at some points of a cell
_SLICE = 250_000  # points between two words of progress
_ON_BORDER = 1e-9


@dataclass(frozen=True, eq=False)
class Feet:
    """Of each of n points: the nearest surface ``which`` (n,), its ``u``, ``v`` (n,), ``point`` and ``normal`` there.

    ``away`` (n, 3) leads from the foot to the point, length¹. ``edge`` (n,) is true where the foot lies on the border
    and ``away`` is not along the normal: there the distance is not orthogonal to the surface.
    """

    which: NDArray[np.int64]
    u: FloatArray
    v: FloatArray
    point: FloatArray
    normal: FloatArray
    away: FloatArray
    edge: NDArray[np.bool_]

    @cached_property
    def distance(self) -> FloatArray:
        """Distances (n,), length¹, positive on the side that the normal points to."""
        side = np.einsum("ij,ij->i", self.away, self.normal)
        return np.where(side < 0.0, -1.0, 1.0) * np.linalg.norm(self.away, axis=1)


class Finder:
    """Finds nearest points on one or more surfaces, all of each, or the trimmed face of those that have loops."""

    def __init__(self, surfaces: Sequence[Surface]) -> None:
        """Take the surfaces apart; ValueError where one of them has no size."""
        self.surfaces = tuple(surfaces)
        if not self.surfaces:
            raise ValueError("surfaces: expected at least one, found none")
        heads: list[list[int]] = []
        edges: list[FloatArray] = []
        pieces: list[FloatArray] = []
        at_edges = at_pieces = 0
        triangles: list[tuple[FloatArray, FloatArray, FloatArray]] = []
        for surface in self.surfaces:
            us, vs, coefficients = _twin(surface)
            heads.append([len(us) - 1, len(vs) - 1, at_edges, at_edges + len(us), at_pieces])
            edges += [us, vs]
            pieces.append(coefficients)
            at_edges += len(us) + len(vs)
            at_pieces += len(coefficients)
            triangles.append(_triangles(surface, us, vs))
        self._heads = np.array(heads, dtype=np.int64)
        self._edges = np.concatenate(edges)
        self._pieces = np.ascontiguousarray(np.concatenate(pieces))
        corners, places, slack = (np.concatenate(part) for part in zip(*triangles, strict=True))
        owners = np.repeat(np.arange(len(triangles)), [len(part[0]) for part in triangles])
        tree = boxed(corners, slack)
        order, gone = np.maximum(tree.order, 0), tree.order < 0
        self._tree = (
            tree.boxes,
            corners[order].reshape(-1, 9),
            places[order].reshape(-1, 6),
            np.where(gone, np.inf, slack[order]),
            owners[order].astype(np.int64),
            LEAF,
        )

    def feet(self, points: FloatArray, progress: Progress | None = None) -> Feet:
        """Return the nearest points to points (n, 3), length¹; of a trimmed face those inside or on its loops."""
        points = np.ascontiguousarray(points)
        found, which = np.empty((len(points), 3)), np.zeros(len(points), dtype=np.int64)

        def work(part: slice) -> None:
            nearest_jit.nearest(
                points[part], *self._tree, self._heads, self._edges, self._pieces, found[part], which[part]
            )

        in_threads(work, len(points), progress=progress)
        return self.at(points, which, found[:, 1], found[:, 2])

    def at(self, points: FloatArray, which: NDArray[np.int64], u: FloatArray, v: FloatArray) -> Feet:
        """Return the feet at parameters that are known."""
        u, v = np.clip(u, 0.0, 1.0), np.clip(v, 0.0, 1.0)
        foot, normal = np.empty((len(points), 3)), np.empty((len(points), 3))
        trimmed = np.zeros(len(points), dtype=np.bool_)
        for index, surface in enumerate(self.surfaces):
            mine = which == index if len(self.surfaces) > 1 else slice(None)
            if surface.trim:
                u[mine], v[mine], trimmed[mine] = _within(surface, points[mine], u[mine], v[mine])
            foot[mine], normal[mine] = _on(surface, u[mine], v[mine])
        away = points - foot
        border = trimmed | (np.minimum(u, 1.0 - u) <= _ON_BORDER) | (np.minimum(v, 1.0 - v) <= _ON_BORDER)
        along = np.einsum("ij,ij->i", away, normal)
        slip = np.linalg.norm(away - along[:, None] * normal, axis=1)
        far = np.linalg.norm(away, axis=1)
        size = np.array([surface.size for surface in self.surfaces])[which]
        edge = border & (slip > 1e-6 * far) & (far > 1e-10 * size)
        return Feet(which, u, v, foot, normal, away, edge)


def in_threads(
    work: Callable[[slice], None], count: int, least: int = 20_000, progress: Progress | None = None
) -> None:
    """Do work that releases the interpreter on slices of ``count`` things, on all cores where there are many."""
    cores = min(os.cpu_count() or 1, 1 + count // least)
    if cores == 1:
        work(slice(0, count))
        return
    ends = np.linspace(0, count, max(4 * cores, count // _SLICE) + 1).astype(int).tolist()
    with ThreadPoolExecutor(cores) as pool:
        for end, done in [(b, pool.submit(work, slice(a, b))) for a, b in pairwise(ends)]:
            done.result()
            if progress is not None:
                progress("points with their distance", end, count)


def _on(surface: Surface, u: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return points and unit normals; at singular points the normal beside them."""
    sample = analyse(surface, u, v, ("point", "normal"))
    point, normal = np.array(sample.point), np.array(sample.normal)
    bad = np.isnan(normal).any(axis=1)
    if bad.any():
        inward = [np.clip(t[bad], 1e-6, 1.0 - 1e-6) for t in (u, v)]
        beside = np.array(analyse(surface, inward[0], inward[1], ("normal",)).normal)
        normal[bad] = np.where(np.isnan(beside), np.array([0.0, 0.0, 1.0]), beside)
    return point, normal


def _twin(surface: Surface) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the ends of the pieces in u and v, and their coefficients (pieces, t power, coordinate, s power)."""
    n = nearest_jit.DEGREE + 1
    nodes = -np.cos(np.pi * np.arange(n) / (n - 1))
    to_powers = np.linalg.inv(np.vander(nodes, n, increasing=True))
    between = 0.5 * (nodes[1:] + nodes[:-1])
    count = _FEWEST
    while True:
        edges = [_subdivided(surface.breaks(axis), count) for axis in (0, 1)]
        at = [_inside(ends, nodes) for ends in edges]
        values = surface(at[0].reshape(-1, 1), at[1].reshape(1, -1))
        values = values.reshape(len(edges[0]) - 1, n, len(edges[1]) - 1, n, 3)
        coefficients = np.einsum("ai,uivjx,bj->uvbxa", to_powers, values, to_powers, optimize=True)
        powers = np.vander(between, n, increasing=True)
        off = np.inf
        with np.errstate(invalid="ignore", over="ignore"):
            checks = [_inside(ends, between) for ends in edges]
            wanted = surface(checks[0].reshape(-1, 1), checks[1].reshape(1, -1))
            wanted = wanted.reshape(len(edges[0]) - 1, n - 1, len(edges[1]) - 1, n - 1, 3)
            near = np.einsum("ia,uvbxa,jb->uivjx", powers, coefficients, powers, optimize=True)
            gap = np.abs(near - wanted)
        fine = np.isfinite(gap)
        off = float(gap[fine].max(initial=0.0))
        reach = float(np.abs(wanted[np.isfinite(wanted)]).max(initial=0.0))
        if off <= _TWIN * surface.size + 64.0 * np.finfo(np.float64).eps * reach or count * 2 > _FINEST:
            return edges[0], edges[1], coefficients.reshape(-1, n, 3, n)
        count *= 2


def _subdivided(breaks: FloatArray, count: int) -> FloatArray:
    each = max(1, -(-count // (len(breaks) - 1)))
    parts: list[FloatArray] = [np.linspace(a, b, each + 1)[:-1] for a, b in pairwise(breaks.tolist())]
    return np.concatenate([*parts, breaks[-1:]])


def _inside(edges: FloatArray, nodes: FloatArray) -> FloatArray:
    """Return parameters (intervals, nodes) at local places from -1 to 1."""
    middle, half = 0.5 * (edges[1:] + edges[:-1]), 0.5 * np.diff(edges)
    return np.clip(middle[:, None] + half[:, None] * nodes, edges[:-1, None], edges[1:, None])


def _triangles(surface: Surface, us: FloatArray, vs: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return corners (m, 3, 3), their parameters (m, 3, 2) and how far the surface may be from each (m,), length¹."""
    u, v = (_subdivided(ends, max(_TRIANGLES, len(ends) - 1)) for ends in (us, vs))
    with np.errstate(invalid="ignore", over="ignore"):
        p = surface(u[:, None], v[None, :])
        bends: list[FloatArray] = []
        for share in (0.0, 0.5, 1.0):  # in the cell, not across a break between two
            across = [(1.0 - share) * t[:-1] + share * t[1:] for t in (u, v)]
            inner = [
                np.clip(a, t[:-1] + 1e-9 * np.diff(t), t[1:] - 1e-9 * np.diff(t))
                for a, t in zip(across, (u, v), strict=True)
            ]
            d = surface.local_partials(inner[0][:, None], inner[1][None, :], 2)
            hu, hv = np.diff(u)[:, None], np.diff(v)[None, :]
            second = [np.linalg.norm(d[i, j], axis=-1) for i, j in ((2, 0), (1, 1), (0, 2))]
            bends.append(second[0] * hu * hu + 2.0 * second[1] * hu * hv + second[2] * hv * hv)
        slack = _SAFETY / 8.0 * np.max(bends, axis=0) + 1e-10 * surface.size
    place = np.stack(np.broadcast_arrays(u[:, None], v[None, :]), axis=-1)

    def two(grid: FloatArray) -> FloatArray:
        a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
        return np.stack([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)], axis=2).reshape(
            -1, 3, grid.shape[-1]
        )

    corners, places, slacks = two(p), two(place), np.repeat(slack.ravel(), 2)
    kept = np.isfinite(corners).all(axis=(1, 2)) & np.isfinite(slacks) & _reached(surface, u, v)
    return corners[kept], places[kept], slacks[kept]


def _reached(surface: Surface, u: FloatArray, v: FloatArray) -> NDArray[np.bool_]:
    """Return which triangles of the cells a trimmed face reaches into, with a cell's margin."""
    shape = (len(u) - 1, len(v) - 1)
    if not surface.trim:
        return np.ones(2 * shape[0] * shape[1], dtype=np.bool_)
    inner = surface.inside(u[:, None], v[None, :])
    near = inner[:-1, :-1] | inner[1:, :-1] | inner[1:, 1:] | inner[:-1, 1:]
    loops = np.concatenate([_dense(loop)[0] for loop in surface.trim])
    i = np.clip(np.searchsorted(u, loops[:, 0], "right") - 1, 0, shape[0] - 1)
    j = np.clip(np.searchsorted(v, loops[:, 1], "right") - 1, 0, shape[1] - 1)
    near[i, j] = True
    return np.repeat(near.ravel(), 2)


def _dense(loop: FloatArray, count: int = 2000) -> tuple[FloatArray, FloatArray]:
    """Return parameters along a closed loop, (n, 2), and the step from each to the next."""
    closed = np.concatenate([loop, loop[:1]])
    length = np.linalg.norm(np.diff(closed, axis=0), axis=1)
    each = np.maximum(1, np.ceil(length / max(float(length.sum()), 1e-300) * count)).astype(int)
    parts: list[FloatArray] = [
        np.linspace(a, b, k + 1)[:-1] for a, b, k in zip(closed[:-1], closed[1:], each.tolist(), strict=True)
    ]
    result = np.concatenate(parts)
    return result, np.roll(result, -1, axis=0) - result


def _within(
    surface: Surface, points: FloatArray, u: FloatArray, v: FloatArray
) -> tuple[FloatArray, FloatArray, NDArray[np.bool_]]:
    """Return feet with those outside the loops moved to the nearest point of a loop, and which were."""
    out = ~surface.inside(u, v)
    if not out.any():
        return u, v, out
    starts, steps = (np.concatenate(part) for part in zip(*(_dense(loop) for loop in surface.trim), strict=True))
    tree: Any = tree_of(surface(starts[:, 0], starts[:, 1]))
    _, near = tree.query(points[out], k=min(4, len(starts)))
    near = np.asarray(near).reshape(int(out.sum()), -1)
    best = np.full(len(near), np.inf)
    u, v = u.copy(), v.copy()
    found = np.stack([u[out], v[out]], axis=1)
    for candidate in near.T:
        for which in (candidate, (candidate - 1) % len(starts)):
            share = _along(surface, points[out], starts[which], steps[which])
            at = np.clip(starts[which] + share[:, None] * steps[which], 0.0, 1.0)
            gap = np.linalg.norm(points[out] - surface(at[:, 0], at[:, 1]), axis=1)
            better = gap < best
            best[better], found[better] = gap[better], at[better]
    u[out], v[out] = found[:, 0], found[:, 1]
    return u, v, out


def _along(surface: Surface, points: FloatArray, start: FloatArray, step: FloatArray) -> FloatArray:
    """Return where on short straight steps over the parameters the surface is nearest: golden section."""
    golden = 0.5 * (np.sqrt(5.0) - 1.0)
    low, high = np.zeros(len(points)), np.ones(len(points))

    def gap(share: FloatArray) -> FloatArray:
        at = np.clip(start + share[:, None] * step, 0.0, 1.0)
        return ((points - surface(at[:, 0], at[:, 1])) ** 2).sum(axis=1)

    for _ in range(36):
        a, b = high - golden * (high - low), low + golden * (high - low)
        left = gap(a) < gap(b)
        low, high = np.where(left, low, a), np.where(left, b, high)
    return 0.5 * (low + high)
