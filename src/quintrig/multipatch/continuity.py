"""What two surfaces have in common at points of a common edge: angle, normal curvature across it, and its rate."""

from dataclasses import dataclass

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.multipatch.boundary import Edge
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.tolerance import SINGULAR


@dataclass(frozen=True, eq=False)
class Across:
    """A surface along an edge: the way across it and the section by the plane of that and the normal.

    ``tangent`` runs along the edge, ``across`` out of the patch or into it, ``normal`` is across x tangent, all of
    length 1, (n, 3). ``curvature`` of the section is positive where it bends towards ``normal`` (length⁻¹), ``rate`` is
    its derivative by arc length across (length⁻²). ``agrees`` tells where ``normal`` is the surface's own. NaN where
    the surface is singular.
    """

    tangent: FloatArray
    across: FloatArray
    normal: FloatArray
    curvature: FloatArray
    rate: FloatArray
    agrees: BoolArray


def across(edge: Edge, t: FloatArray, *, outward: bool, backwards: bool = False) -> Across:
    """Return how a surface runs across an edge at parameters t (n,): out of it or into it.

    ``backwards`` turns the edge's direction. The normal section has κ = n·S'' with S' = d, |d| = 1, and
    κ' = n·(S''' + 3 dII terms) with S'' free of a tangential part (do Carmo 1976, §3-2).
    """
    uv, step = edge.place(t)
    surface = edge.surface
    s = surface.partials(uv[:, 0], uv[:, 1], 3)
    su, sv = s[1, 0], s[0, 1]
    raw = np.cross(su, sv)
    area = np.linalg.norm(raw, axis=-1)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        n = np.where(area > SINGULAR * surface.size**2, 1.0, np.nan)[:, None] * raw / area[:, None]
        along = step * (-1.0 if backwards else 1.0)
        tangent = _unit(su * along[:, :1] + sv * along[:, 1:])
        # Left of the path in the parameters is n x tangent in space; the patch lies on the side ``left``.
        inward = np.cross(n, tangent) * (edge.left * (-1.0 if backwards else 1.0))
        d = -inward if outward else inward
        curvature, rate = _section(s, n, d, area)
        normal = np.cross(d, tangent)
        turn = np.sign((normal * n).sum(axis=-1))
    return Across(tangent, d, normal, turn * curvature, turn * rate, turn * surface.sign > 0.0)


def _section(s: FloatArray, n: FloatArray, d: FloatArray, area: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return κ and dκ/ds of the normal section along d (n, 3), |d| = 1, from partials up to order 3."""
    su, sv = s[1, 0], s[0, 1]
    e, f, g = (_dot(a, b) for a, b in ((su, su), (su, sv), (sv, sv)))

    def solve(vector: FloatArray) -> tuple[FloatArray, FloatArray]:
        a, b = _dot(vector, su), _dot(vector, sv)
        return (g * a - f * b) / area**2, (e * b - f * a) / area**2

    x, y = solve(d)
    second = _terms(s, (s[2, 0], 1, 2, 0), (s[1, 1], 2, 1, 1), (s[0, 2], 1, 0, 2), x=x, y=y)
    xx, yy = solve(-second)
    third = _terms(s, (s[3, 0], 1, 3, 0), (s[2, 1], 3, 2, 1), (s[1, 2], 3, 1, 2), (s[0, 3], 1, 0, 3), x=x, y=y)
    bend = s[2, 0] * (x * xx)[:, None] + s[1, 1] * (x * yy + y * xx)[:, None] + s[0, 2] * (y * yy)[:, None]
    return _dot(n, second), _dot(n, third + 3.0 * bend)


def _terms(s: FloatArray, *parts: tuple[FloatArray, int, int, int], x: FloatArray, y: FloatArray) -> FloatArray:
    return sum((part * (c * x**i * y**j)[:, None] for part, c, i, j in parts), np.zeros_like(s[0, 0]))


def angle(first: FloatArray, second: FloatArray) -> FloatArray:
    """Return the angles between unit vectors (n, 3), degrees, accurate near 0 and 180."""
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(first, second), axis=-1), _dot(first, second)))


def jump(first: FloatArray, second: FloatArray, floor: float) -> FloatArray:
    """Return |κ1 - κ2| / max(|κ1| + |κ2|, floor): 1 where one side is flat or bends the other way, 0 where equal."""
    return np.abs(first - second) / np.maximum(np.abs(first) + np.abs(second), floor)


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    return (a * b).sum(axis=-1)


def _unit(vectors: FloatArray) -> FloatArray:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def surface_distance(surface: Surface, uv: FloatArray, points: FloatArray, steps: int = 12) -> FloatArray:
    """Return the distances of points (n, 3) from a surface, sought by Gauss-Newton from ``uv`` (n, 2), length¹."""
    best = np.linalg.norm(surface(*uv.T) - points, axis=-1)
    for _ in range(steps):
        s = surface.partials(uv[:, 0], uv[:, 1], 1)
        away = points - s[0, 0]
        best = np.fmin(best, np.linalg.norm(away, axis=-1))
        e, f, g = (_dot(a, b) for a, b in ((s[1, 0], s[1, 0]), (s[1, 0], s[0, 1]), (s[0, 1], s[0, 1])))
        a, b = _dot(away, s[1, 0]), _dot(away, s[0, 1])
        with np.errstate(divide="ignore", invalid="ignore"):
            move = np.stack([g * a - f * b, e * b - f * a], axis=-1) / (e * g - f * f)[:, None]
        uv = np.clip(uv + np.nan_to_num(move), 0.0, 1.0)
    return best
