"""The lines of constant u and v that cut a mesh, chosen from the curvature and checked against a tolerance."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.multipatch.edges import Link
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.tolerance import rounding

_ROUNDS = 40
_INSIDE = ((1 / 3, 1 / 3), (0.5, 0.5), (0.5, 0.0), (0.0, 0.5), (0.2, 0.2), (0.6, 0.2), (0.2, 0.6))
"""Where in a triangle its distance is measured: barycentric coordinates of its second and third corner."""


@dataclass(frozen=True, eq=False)
class Cut:
    """The lines of one patch, rising from 0 to 1: ``u`` (n,), ``v`` (m,)."""

    u: FloatArray
    v: FloatArray

    @property
    def size(self) -> int:
        """Number of points."""
        return len(self.u) * len(self.v)


def cut_by_tolerance(surfaces: Sequence[Surface], found: Sequence[Link], tolerance: float, most: int) -> list[Cut]:
    """Return lines for every patch, the same across linked sides, so that all triangles are within ``tolerance``.

    They start from the curvature along the parameter lines; then every interval that fails the check is halved. Raises
    ValueError where that takes more than ``most`` points.
    """
    cuts = _together([_first_guess(surface, tolerance) for surface in surfaces], found)
    for _ in range(_ROUNDS):
        _check(cuts, tolerance, most)
        marks = [_failing(surface, cut, tolerance) for surface, cut in zip(surfaces, cuts, strict=True)]
        if not any(mark.any() for pair in marks for mark in pair):
            return cuts
        halved = [Cut(_halved(c.u, m[0]), _halved(c.v, m[1])) for c, m in zip(cuts, marks, strict=True)]
        cuts = _together(halved, found)
    raise ValueError(
        f"mesh: a chordal tolerance of {tolerance:g} is not reached; is a surface singular? choose a larger one"
    )


def gap(surface: Surface, cut: Cut) -> float:
    """Return the largest distance measured between the triangles of a cut and the surface, length¹."""
    inside, along_u, along_v = _gaps(surface, cut)
    parts = (inside, along_u[:, [0, -1]], along_v[[0, -1], :])
    return float(max(np.nanmax(part, initial=0.0) for part in parts))


def _check(cuts: Sequence[Cut], tolerance: float, most: int) -> None:
    total = sum(cut.size for cut in cuts)
    if total > most:
        raise ValueError(
            f"mesh: a chordal tolerance of {tolerance:g} takes more than {most:,} points; choose a larger one or a grid"
        )


def _first_guess(surface: Surface, tolerance: float) -> Cut:
    """Spread lines so that the sagitta h²|S_uu|/8, tangential part left out, is about half the tolerance everywhere."""
    t = np.linspace(0.0, 1.0, 65)
    partials = surface.partials(t[:, None], t[None, :], 2)
    lines: list[FloatArray] = []
    for axis, (first, second) in enumerate(((partials[1, 0], partials[2, 0]), (partials[0, 1], partials[0, 2]))):
        square = (first**2).sum(-1, keepdims=True)
        bend = second - first * np.divide(
            (first * second).sum(-1, keepdims=True), square, where=square > 0, out=0 * square
        )
        size = np.sqrt(np.nan_to_num(bend**2).sum(-1)).max(axis=1 - axis)
        density = np.sqrt(size / (4.0 * tolerance))
        steps = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(t))])
        count = int(min(max(np.ceil(steps[-1]), 1.0), 20_000))
        even: FloatArray = np.linspace(0.0, 1.0, count + 1)
        line = np.asarray(np.interp(even * steps[-1], steps, t) if steps[-1] > 0.0 else even, dtype=np.float64)
        line[[0, -1]] = 0.0, 1.0
        lines.append(line)
    return Cut(np.unique(lines[0]), np.unique(lines[1]))


def _failing(surface: Surface, cut: Cut, tolerance: float) -> tuple[BoolArray, BoolArray]:
    """Return which intervals of u and of v hold a triangle that is too far from the surface."""
    inside, along_u, along_v = _gaps(surface, cut)
    bad = inside > tolerance
    # A cell is halved along the direction that bends more; a twisted one bends along neither, and is halved along both.
    u_bend = np.maximum(along_u[:, :-1], along_u[:, 1:])
    v_bend = np.maximum(along_v[:-1, :], along_v[1:, :])
    weak = np.maximum(u_bend, v_bend) <= 0.5 * tolerance
    u_marks = (bad & (weak | (u_bend >= 0.5 * v_bend))).any(axis=1)
    v_marks = (bad & (weak | (v_bend >= 0.5 * u_bend))).any(axis=0)
    # The borders' own chords count in full: there the mesh ends.
    u_ends = np.maximum(along_u[:, 0], along_u[:, -1]) > tolerance
    v_ends = np.maximum(along_v[0], along_v[-1]) > tolerance
    return np.asarray(u_marks | u_ends), np.asarray(v_marks | v_ends)


def _gaps(surface: Surface, cut: Cut) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the largest distance in each cell (n - 1, m - 1), of chords along u (n - 1, m) and along v (n, m - 1)."""
    n, m = len(cut.u), len(cut.v)
    inside: FloatArray = np.zeros((n - 1, m - 1))
    along_u: FloatArray = np.zeros((n - 1, m))
    along_v: FloatArray = np.zeros((n, m - 1))
    rows = max(1, 100_000 // m)
    for start in range(0, n - 1, rows):
        part = slice(start, min(start + rows, n - 1) + 1)
        inside[part.start : part.stop - 1] = _inside(surface, cut.u[part], cut.v)
        along_u[part.start : part.stop - 1] = _chords(surface, cut.u[part], cut.v)
    for start in range(0, n, rows):
        part = slice(start, min(start + rows, n))
        along_v[part] = _chords_v(surface, cut.u[part], cut.v)
    return inside, along_u, along_v


def _chords(surface: Surface, u: FloatArray, v: FloatArray) -> FloatArray:
    ends = surface(u[:, None], v[None, :])
    return np.max(
        [_off(surface((u[:-1] + s * np.diff(u))[:, None], v[None, :]), ends[:-1], ends[1:]) for s in _QUARTERS], 0
    )


def _chords_v(surface: Surface, u: FloatArray, v: FloatArray) -> FloatArray:
    ends = surface(u[:, None], v[None, :])
    points = [surface(u[:, None], (v[:-1] + s * np.diff(v))[None, :]) for s in _QUARTERS]
    return np.max([_off(p, ends[:, :-1], ends[:, 1:]) for p in points], 0)


_QUARTERS = (0.25, 0.5, 0.75)


def _off(points: FloatArray, start: FloatArray, end: FloatArray) -> FloatArray:
    """Return the distance of points from the lines through start and end."""
    along = end - start
    square = (along**2).sum(-1)
    away = points - start
    share = np.divide((away * along).sum(-1), square, out=np.zeros_like(square), where=square > 0.0)
    return np.sqrt(((away - share[..., None] * along) ** 2).sum(-1))


def _inside(surface: Surface, u: FloatArray, v: FloatArray) -> FloatArray:
    """Return the largest distance of surface points from the planes of a cell's two triangles, split as in the mesh."""
    p = surface(u[:, None], v[None, :])
    a, b, c, d = p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]
    along = (((c - a) ** 2).sum(-1) <= ((d - b) ** 2).sum(-1))[..., None]
    du, dv = np.diff(u)[:, None], np.diff(v)[None, :]
    result: FloatArray = np.zeros(a.shape[:2])
    rounded = rounding(p)
    corners = {"a": (a, 0, 0), "b": (b, 1, 0), "c": (c, 1, 1), "d": (d, 0, 1)}
    for split, used in ((("abc", "acd"), along), (("abd", "bcd"), ~along)):
        for name in split:
            (x, xs, xt), (y, ys, yt), (z, zs, zt) = (corners[letter] for letter in name)
            normal = np.cross(y - x, z - x)
            length = np.sqrt((normal**2).sum(-1))
            # A triangle at a pole has no plane: far from the origin rounding alone would give it one.
            longest = np.sqrt(np.maximum(((y - x) ** 2).sum(-1), ((z - x) ** 2).sum(-1)))
            flat = length <= rounded * longest
            unit = np.divide(normal, length[..., None], out=np.zeros_like(normal), where=~flat[..., None])
            for s, t in _INSIDE:
                r = 1.0 - s - t
                at = surface(
                    u[:-1, None] + (r * xs + s * ys + t * zs) * du, v[None, :-1] + (r * xt + s * yt + t * zt) * dv
                )
                result = np.fmax(result, np.where(used[..., 0], np.abs(((at - x) * unit).sum(-1)), 0.0))
    return result


def _halved(lines: FloatArray, marks: BoolArray) -> FloatArray:
    middle = 0.5 * (lines[1:] + lines[:-1])
    return np.sort(np.concatenate([lines, middle[marks]]))


def _together(cuts: Sequence[Cut], found: Sequence[Link]) -> list[Cut]:
    """Give linked sides the same lines: all of either, until nothing changes."""
    lines = {(k, axis): line for k, cut in enumerate(cuts) for axis, line in enumerate((cut.u, cut.v))}
    changed = True
    while changed:
        changed = False
        for link in found:
            # Along a side of constant u runs v, and the other way round.
            one, other = ((k, 1 if side < 2 else 0) for k, side in (link.first, link.second))
            there = 1.0 - lines[other][::-1] if link.reversed else lines[other]
            union = _union(lines[one], there)
            back = 1.0 - union[::-1] if link.reversed else union
            if len(union) != len(lines[one]) or len(back) != len(lines[other]):
                changed = True
            lines[one], lines[other] = union, _union(back, lines[other]) if one == other else back
    return [Cut(lines[k, 0], lines[k, 1]) for k in range(len(cuts))]


def _union(first: FloatArray, second: FloatArray) -> FloatArray:
    """Return the lines of both, those that differ by rounding once."""
    both = np.sort(np.concatenate([first, second]))
    return both[np.concatenate([[True], np.diff(both) > 1e-12])]
