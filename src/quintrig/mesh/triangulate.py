"""Triangle meshes of models: to a verified chordal tolerance or of a given grid, watertight along shared edges.

Every patch is cut along lines of constant u and v. Patches that share an edge, and closed ones with themselves, take
the same lines across it, so that their points coincide and are kept once; so are the points of an edge collapsed to a
pole.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.analysis.sample import analyse
from quintrig.geometry.surface import Surface
from quintrig.mesh.cuts import Cut, cut_by_tolerance, gap
from quintrig.multipatch.edges import Link, links
from quintrig.quantities.table import BY_KEY
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import NOISE, rounding

MOST_POINTS = 4_000_000
"""Points of the largest mesh."""

Triangles = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Mesh:
    """Points (n, 3), length¹, and triangles (m, 3) of their indices, counter-clockwise on the side of the normals.

    ``normals`` (n, 3) are the surface's own; ``values`` hold quantities by key, (n,). ``patch``, ``u`` and ``v`` (n,)
    tell where each point comes from; on an edge shared by patches it is the first one. ``chord`` is the largest
    distance measured between the triangles and the surfaces, length¹, ``open_edges`` the number of triangle sides with
    one triangle. ``notes`` say what the user should know.
    """

    points: FloatArray
    triangles: Triangles
    normals: FloatArray
    values: Mapping[str, NDArray[Any]]
    patch: Triangles
    u: FloatArray
    v: FloatArray
    chord: float
    open_edges: int
    notes: tuple[str, ...] = ()


def mesh(
    surfaces: Sequence[Surface],
    *,
    tolerance: float | None = None,
    grid: tuple[int, int] | None = None,
    quantities: Sequence[str] = (),
) -> Mesh:
    """Return one mesh of all surfaces.

    ``grid`` gives the numbers of points along u and v; otherwise ``tolerance`` (length¹, by default 1e-3 of the size of
    the smallest surface) bounds the distance between triangles and surface, measured inside every triangle and along
    every border. Raises ValueError where that takes more than 4,000,000 points.
    """
    if not surfaces:
        raise ValueError("mesh: expected one surface or more, found none")
    found = links(surfaces)
    if grid is not None:
        cuts = _gridded(surfaces, grid)
        tolerance = None
    else:
        if tolerance is None:
            tolerance = 1e-3 * min(surface.size for surface in surfaces)
            if not tolerance > 0.0:
                raise ValueError("mesh: all of a surface is a single point; are its control points equal?")
        if not tolerance > 0.0:
            raise ValueError(f"mesh: expected a chordal tolerance greater than 0, found {tolerance:g}")
        cuts = cut_by_tolerance(surfaces, found, tolerance, MOST_POINTS)
    return _assembled(surfaces, cuts, found, quantities)


def _gridded(surfaces: Sequence[Surface], grid: tuple[int, int]) -> list[Cut]:
    nu, nv = grid
    if nu < 2 or nv < 2 or nu * nv * len(surfaces) > MOST_POINTS:
        raise ValueError(
            f"mesh: expected a grid of 2 x 2 to {MOST_POINTS:,} points in all, found {nu} x {nv} for each patch"
        )
    return [Cut(np.linspace(0.0, 1.0, nu), np.linspace(0.0, 1.0, nv)) for _ in surfaces]


def _assembled(surfaces: Sequence[Surface], cuts: Sequence[Cut], found: Sequence[Link], keys: Sequence[str]) -> Mesh:
    starts = np.cumsum([0, *(cut.size for cut in cuts)])
    total = int(starts[-1])
    points, normals = np.empty((total, 3)), np.empty((total, 3))
    u, v = np.empty(total), np.empty(total)
    patch = np.empty(total, dtype=np.int64)
    kinds = {key: np.int8 if BY_KEY[key].kind == "class" else np.float64 for key in keys}
    values: dict[str, NDArray[Any]] = {key: np.empty(total, dtype=kind) for key, kind in kinds.items()}
    triangles: list[Triangles] = []
    chord, notes = 0.0, list[str]()
    for k, (surface, cut) in enumerate(zip(surfaces, cuts, strict=True)):
        part = slice(int(starts[k]), int(starts[k + 1]))
        sample = analyse(surface, cut.u[:, None], cut.v[None, :], ("point", "normal", *keys))
        points[part], normals[part] = sample.point.reshape(-1, 3), sample.normal.reshape(-1, 3)
        u[part], v[part] = (a.ravel() for a in np.meshgrid(cut.u, cut.v, indexing="ij"))
        patch[part] = k
        for key in keys:
            values[key][part] = sample[key].ravel()
        triangles.append(_triangles(sample.point, surface.sign) + part.start)
        chord = max(chord, gap(surface, cut))
    corners, kept = _welded(np.concatenate(triangles), _same_points(points, cuts, starts, found, surfaces), total)
    missing = ~np.isfinite(normals[kept]).all(axis=1)
    normals = normals[kept]
    normals[missing] = _from_triangles(points[kept], corners)[missing]
    opposite = [link for link in found if link.opposed]
    if opposite:
        pairs = ", ".join(f"{link.first[0] + 1} and {link.second[0] + 1}" for link in opposite)
        notes.append(f"normals of patches {pairs} look to opposite sides of their shared edge; set flip = true in one")
    if any(surface.trim for surface in surfaces):
        notes.append("trimmed faces are meshed as their whole surfaces")
    kept_values = {key: array[kept] for key, array in values.items()}
    return Mesh(
        points[kept], corners, normals, kept_values, patch[kept], u[kept], v[kept], chord, _open(corners), tuple(notes)
    )


def _triangles(points: FloatArray, sign: float) -> Triangles:
    """Return two triangles for each cell of a grid of points (n, m, 3), split along the shorter diagonal."""
    n, m = points.shape[:2]
    index: Triangles = np.arange(n * m, dtype=np.int64).reshape(n, m)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    first = ((points[1:, 1:] - points[:-1, :-1]) ** 2).sum(-1)
    second = ((points[:-1, 1:] - points[1:, :-1]) ** 2).sum(-1)
    along = (first <= second)[..., None, None]
    split = np.where(
        along,
        np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)], -2),
        np.stack([np.stack([a, b, d], -1), np.stack([b, c, d], -1)], -2),
    ).reshape(-1, 3)
    return split if sign > 0.0 else split[:, ::-1]


def _same_points(
    points: FloatArray, cuts: Sequence[Cut], starts: Triangles, found: Sequence[Link], surfaces: Sequence[Surface]
) -> list[tuple[Triangles, Triangles]]:
    """Return pairs of index arrays of points that are one: along shared edges and at collapsed ones."""
    pairs: list[tuple[Triangles, Triangles]] = []
    for link in found:
        first, second = (_edge(cuts, starts, *end) for end in (link.first, link.second))
        second = second[::-1] if link.reversed else second
        if len(first) == len(second):  # a given grid may cut them differently
            pairs.append((first, second))
    for k, surface in enumerate(surfaces):
        for side in range(4):
            line = _edge(cuts, starts, k, side)
            if np.ptp(points[line], axis=0).max() <= NOISE * surface.size + rounding(points[line]):
                pairs.append((np.full_like(line, line[0]), line))
    return pairs


def _edge(cuts: Sequence[Cut], starts: Triangles, k: int, side: int) -> Triangles:
    """Return the indices of the points on one side of a patch: 0, 1 are u = 0, 1 and 2, 3 are v = 0, 1."""
    nu, nv = len(cuts[k].u), len(cuts[k].v)
    index = np.arange(nu * nv).reshape(nu, nv) + int(starts[k])
    return (index[0], index[-1], index[:, 0], index[:, -1])[side]


def _welded(
    triangles: Triangles, pairs: Sequence[tuple[Triangles, Triangles]], total: int
) -> tuple[Triangles, Triangles]:
    """Return triangles of the points that are kept, without collapsed ones, and the indices of those points."""
    none: Triangles = np.zeros(0, dtype=np.int64)
    first = np.concatenate([none, *(pair[0] for pair in pairs)])
    second = np.concatenate([none, *(pair[1] for pair in pairs)])
    corners = _smallest_of_group(first, second, total)[triangles]
    proper = (corners[:, 0] != corners[:, 1]) & (corners[:, 1] != corners[:, 2]) & (corners[:, 2] != corners[:, 0])
    corners = corners[proper]
    kept = np.unique(corners)
    return np.searchsorted(kept, corners), kept


def _smallest_of_group(first: Triangles, second: Triangles, total: int) -> Triangles:
    """Return for each of ``total`` points the smallest index among those that pairs connect it with."""
    smallest: Triangles = np.arange(total, dtype=np.int64)
    while True:
        before = smallest.copy()
        low = np.minimum(smallest[first], smallest[second])
        np.minimum.at(smallest, first, low)
        np.minimum.at(smallest, second, low)
        if (smallest == before).all():
            return smallest


def _from_triangles(points: FloatArray, triangles: Triangles) -> FloatArray:
    """Return the mean normal of the triangles around each point, weighted by area: the surface has none at a pole."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    result: FloatArray = np.zeros_like(points)
    for k in range(3):
        np.add.at(result, triangles[:, k], normal)
    length = np.sqrt((result**2).sum(axis=1, keepdims=True))
    return np.divide(result, length, out=np.zeros_like(result), where=length > 0.0)


def _open(triangles: Triangles) -> int:
    """Return the number of sides that belong to one triangle alone."""
    sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    _, counts = np.unique(sides, axis=0, return_counts=True)
    return int((counts == 1).sum())
