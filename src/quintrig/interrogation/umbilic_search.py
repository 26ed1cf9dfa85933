"""Where umbilics are: seeds on a grid, Newton's iteration from them, and curves of them followed."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.local import Local
from quintrig.interrogation.rotation import wrapped
from quintrig.support.arrays import FloatArray

_STEPS = 60
_STRIDES = 600  # along a curve of umbilics, each a hundredth of the size
_MET = 1e-8  # of the scale: what is left of the spread of κ1 and κ2 at an umbilic
_POLE = 1e-6  # of the square of the size: |S_u × S_v| at which a point counts as a pole
_ONE = 1e-6  # of the size: umbilics this near are one


def seeds_of(
    u: FloatArray, v: FloatArray, a: FloatArray, b: FloatArray, scale: FloatArray, inside: np.ndarray[Any, Any]
) -> list[FloatArray]:
    """Return where to begin: cells around which the vector turns, and where its length is least among neighbours."""
    angle = np.arctan2(b, a)
    ring = [angle[:-1, :-1], angle[1:, :-1], angle[1:, 1:], angle[:-1, 1:]]
    turn = sum(wrapped(ring[(k + 1) % 4] - ring[k]) for k in range(4))
    near = inside[:-1, :-1] | inside[1:, :-1] | inside[1:, 1:] | inside[:-1, 1:]
    found = [
        np.array([0.5 * (u[i] + u[i + 1]), 0.5 * (v[j] + v[j + 1])])
        for i, j in np.argwhere((np.abs(turn) > 1.0) & near).tolist()
    ]
    share = np.pad(np.where(np.isfinite(a), np.hypot(a, b) / scale, np.inf), 1, constant_values=np.inf)
    middle: FloatArray = share[1:-1, 1:-1]
    least = np.isfinite(middle) & (middle < 0.3) & inside
    for di in (-1, 0, 1):
        for dj in (-1, 0, 1):
            if di or dj:
                least &= middle <= share[1 + di : share.shape[0] - 1 + di, 1 + dj : share.shape[1] - 1 + dj]
    order = sorted(np.argwhere(least).tolist(), key=lambda place: middle[place[0], place[1]])
    return found + [np.array([u[i], v[j]]) for i, j in order[:200]]


def umbilics_near(surface: Surface, seeds: FloatArray, typical: float) -> list[FloatArray]:
    """Return the umbilics (2,) near seeds (n, 2) that lie on the face and not at a pole; NaN (2,) where none is met."""
    uv = seeds.copy()
    best, least = uv.copy(), np.full(len(uv), np.inf)
    for _ in range(_STEPS):
        with np.errstate(divide="ignore", invalid="ignore"):
            local = Local.at(surface, *uv.T, order=3)
            value = np.stack(local.half, axis=-1)
            size = np.hypot(*value.T)
            better = size < least
            best, least = np.where(better[:, None], uv, best), np.where(better, size, least)
            matrix = _derivative(local)
            usable = np.isfinite(matrix).all(axis=(1, 2)) & np.isfinite(size)
            u, s, vt = np.linalg.svd(np.where(usable[:, None, None], matrix, 0.0))
            inverse = np.where(s > 1e-7 * s[:, :1], 1.0 / s, 0.0)
            step = -np.einsum("nji,nj,nkj,nk->ni", vt, inverse, u.transpose(0, 2, 1), value)
            p, q, r = local.frame
            move = np.stack([p * step[:, 0] + q * step[:, 1], r * step[:, 1]], axis=1)
            reach = np.abs(move).max(axis=1)
            move *= np.where(reach > 0.05, 0.05 / reach, 1.0)[:, None]
        going = np.asarray(np.isfinite(move).all(axis=1)) & np.asarray(size > 1e-15 * typical)
        move = np.where(going[:, None], move, 0.0)
        moved = np.clip(uv + move, 0.0, 1.0)
        if np.abs(moved - uv).max(initial=0.0) <= 1e-16:
            break
        uv = moved
    with np.errstate(divide="ignore", invalid="ignore"):
        local = Local.at(surface, *best.T)
        met = least <= _MET * np.maximum(np.abs(local.mean) + 1.0 / surface.size, typical)
        met &= (local.area > _POLE * surface.size**2) & surface.inside(*best.T)
    return [one if good else np.full(2, np.nan) for one, good in zip(best, met.tolist(), strict=True)]


def _derivative(local: Local) -> FloatArray:
    """Return the derivatives of ((M11 - M22)/2, M12) along e1 and e2, (..., 2, 2), 1/length²; true at umbilics."""
    a, b, c, d = local.cubic
    return np.stack([np.stack([0.5 * (a - c), 0.5 * (b - d)], axis=-1), np.stack([b, c], axis=-1)], axis=-2)


def is_flat(surface: Surface, uv: FloatArray) -> bool:
    """Return whether the derivative at an umbilic is singular: it is then no simple one, or one of a curve."""
    local = Local.at(surface, *uv, order=3)
    singular = np.linalg.svd(_derivative(local), compute_uv=False)
    scale = max(abs(float(local.mean)), 1.0 / surface.size) / surface.size
    return bool(singular[1] <= 1e-4 * max(float(singular[0]), scale))


def apart(surface: Surface, found: Sequence[FloatArray]) -> list[FloatArray]:
    """Return the parameters (2,) whose points are not the same."""
    kept: list[FloatArray] = []
    points: list[FloatArray] = []
    for uv in found:
        point = surface(*uv)
        if not any(np.linalg.norm(point - other) <= _ONE * surface.size for other in points):
            kept.append(uv)
            points.append(point)
    return kept


def beside(surface: Surface, uv: FloatArray, points: FloatArray) -> bool:
    """Return whether a point lies on a line of points (n, 3), as near as these are to each other."""
    apart = np.linalg.norm(points - surface(*uv), axis=1)
    step = np.linalg.norm(np.diff(points, axis=0), axis=1).max(initial=0.0)
    return bool(apart.min() <= max(step, _ONE * surface.size))


def clearest(surface: Surface, places: Sequence[FloatArray], typical: float) -> FloatArray:
    """Return the middle of where κ1 and κ2 differ least amid places (2,) at which they differ by rounding.

    It is that of ever smaller sets, each where they differ by less than a tenth as much.
    """
    cloud = np.array(places)
    low, high = cloud.min(axis=0), cloud.max(axis=0)
    here, least = cloud.mean(axis=0), 10.0 * _MET * typical
    t = np.linspace(-0.1, 1.1, 41)
    share = np.stack(np.meshgrid(t, t, indexing="ij"), axis=-1).reshape(-1, 2)
    for _ in range(12):
        wide = np.maximum(high - low, 1e-9)
        grid = np.clip(0.5 * (low + high) + (share - 0.5) * wide, 0.0, 1.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            kept = grid[np.asarray(Local.at(surface, *grid.T).spread <= least)]
        if len(kept) < 3:
            break
        low, high = kept.min(axis=0), kept.max(axis=0)
        here, least = 0.5 * (low + high), 0.1 * least
    return here


def curve_through(
    surface: Surface, uv: FloatArray, typical: float, stops: Callable[[FloatArray], bool]
) -> tuple[FloatArray | None, bool]:
    """Return the curve of umbilics (n, 2) through one whose derivative is singular, None where there is none.

    Whether it closes, or ends where the face does or something ``stops`` it, comes with it: one that ends inside is
    none, but an umbilic around which κ1 and κ2 part slowly.
    """
    halves: list[list[FloatArray]] = []
    stride = 0.01 * surface.size
    for sense in (1.0, -1.0):
        here, before, line = uv, None, [uv]
        for _ in range(_STRIDES):
            local = Local.at(surface, *here, order=3)
            _, s, vt = np.linalg.svd(_derivative(local))
            if not s[0] > 0.0:
                break
            p, q, r = (float(x) for x in local.frame)
            way = np.array([p * vt[1, 0] + q * vt[1, 1], r * vt[1, 1]])
            space = local.lifted(way)
            turned = sense if before is None else np.sign(float(space @ before)) or 1.0
            following = umbilics_near(surface, np.clip(here + turned * stride * way, 0.0, 1.0)[None, :], typical)[0]
            if not np.isfinite(following).all():
                break
            if not 0.2 * stride < np.linalg.norm(surface(*following) - surface(*here)) < 3.0 * stride:
                break
            line.append(following)
            here, before = following, turned * space
            if len(line) > 8 and np.linalg.norm(surface(*here) - surface(*uv)) < stride:
                line.append(uv)
                return np.array(line), True
        halves.append(line)
    whole = np.array([*reversed(halves[1]), *halves[0][1:]])
    if len(whole) < 6:
        return None, False
    return whole, all(_ends(surface, half[-1], half[-2], stops) for half in halves if len(half) > 1)


def _ends(surface: Surface, last: FloatArray, before: FloatArray, stops: Callable[[FloatArray], bool]) -> bool:
    """Return whether a line that goes on as it does would leave the face, or comes to a singular point."""
    ahead = last + 3.0 * (last - before)
    if not ((ahead >= 0.0) & (ahead <= 1.0)).all() or not surface.inside(*ahead) or stops(ahead):
        return True
    with np.errstate(divide="ignore", invalid="ignore"):
        return not float(Local.at(surface, *ahead, order=1).area) > _POLE * surface.size**2
