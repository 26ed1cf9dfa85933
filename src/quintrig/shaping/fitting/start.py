"""First parameters of points that are to be fitted: where in the square each may lie."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from quintrig.scan.scan import Scan, Triangles
from quintrig.support.arrays import FloatArray
from quintrig.support.scipy_inside import sparse_, sparse_linalg_

_MOST_HULL = 48


def parametrisations(scan: Scan, points: FloatArray, kind: str, mirror: FloatArray | None) -> Iterator[FloatArray]:
    """Yield parameters (n, 2) of points (n, 3), each a way to begin; the best fit tells which was right.

    ``points`` are those of the scan, scaled.
    """
    if kind == "swung":
        yield _turned(points)
        return
    if kind == "symmetric" and mirror is not None:
        yield _beside_mirror(points, mirror)
        return
    flat = _principal(points)
    plane = flat[:, :2]
    frames = [_quadrilateral(plane), _rectangle(plane)]
    if scan.triangles is not None and len(scan.triangles) > 20 and kind == "tensor":
        frames.insert(0, _harmonic(scan, plane))
    unrolled = _unrolled(points)
    if unrolled is not None:
        frames.append(_rectangle(unrolled))
    for one in frames:
        if one is None:
            continue
        yield one
        if kind in ("ruled", "swept"):
            yield one[:, ::-1]


def _principal(points: FloatArray) -> FloatArray:
    centred = points - points.mean(axis=0)
    _, axes = np.linalg.eigh(centred.T @ centred)
    return centred @ axes[:, ::-1]


def _unit(values: FloatArray) -> FloatArray:
    low, span = values.min(axis=0), np.ptp(values, axis=0)
    return (values - low) / np.where(span > 0.0, span, 1.0)


def _hull(plane: FloatArray) -> FloatArray | None:
    try:
        return plane[ConvexHull(plane).vertices]
    except QhullError:  # all on a line
        return None


def _rectangle(plane: FloatArray) -> FloatArray:
    """Return parameters by the smallest rectangle around points in a plane (n, 2)."""
    hull = _hull(plane)
    if hull is None:
        return _unit(plane)
    sides = np.diff(np.concatenate([hull, hull[:1]]), axis=0)
    best, area = plane, np.inf
    turns: list[float] = np.unique(np.round(np.arctan2(sides[:, 1], sides[:, 0]) % (0.5 * np.pi), 4)).tolist()
    for angle in turns:
        c, s = np.cos(angle), np.sin(angle)
        turn: FloatArray = np.array([[c, -s], [s, c]], dtype=np.float64)
        wide, high = ((hull @ turn).max(axis=0) - (hull @ turn).min(axis=0)).tolist()
        here = wide * high
        if here < area:
            best, area = plane @ turn, here
    return _unit(best)


def _quadrilateral(plane: FloatArray) -> FloatArray | None:
    """Return parameters by the largest quadrilateral in the hull of points in a plane, its map inverted."""
    corners = _corners(plane)
    if corners is None:
        return None
    at = np.full(plane.shape, 0.5)
    a, b, c, d = corners
    for _ in range(12):  # Newton, on a map that is one to one inside
        u, v = at[:, :1], at[:, 1:]
        place = (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d
        du, dv = (1 - v) * (b - a) + v * (c - d), (1 - u) * (d - a) + u * (c - b)
        gap = plane - place
        det = du[:, 0] * dv[:, 1] - du[:, 1] * dv[:, 0]
        det = np.where(np.abs(det) > 1e-9, det, 1e-9)
        step = np.stack([gap[:, 0] * dv[:, 1] - gap[:, 1] * dv[:, 0], du[:, 0] * gap[:, 1] - du[:, 1] * gap[:, 0]], 1)
        at = np.clip(at + step / det[:, None], -0.3, 1.3)
    return np.clip(at, 0.0, 1.0)


def _corners(plane: FloatArray) -> FloatArray | None:
    """Return the four points (4, 2) of the hull that span the largest quadrilateral, in turn."""
    hull = _hull(plane)
    if hull is None or len(hull) < 4:
        return None
    if len(hull) > _MOST_HULL:
        hull = hull[np.linspace(0, len(hull) - 1, _MOST_HULL).astype(int)]
    best, area = None, 0.0
    count = len(hull)
    for i in range(count - 2):
        for k in range(i + 2, count):
            way = hull[k] - hull[i]
            off = way[0] * (hull[:, 1] - hull[i, 1]) - way[1] * (hull[:, 0] - hull[i, 0])
            right, left = off[i + 1 : k], np.concatenate([off[k + 1 :], off[:i]])
            if not len(right) or not len(left):
                continue
            j, m = int(np.argmin(right)), int(np.argmax(left))
            here = float(left[m] - right[j])
            if here > area:
                area = here
                best = [i, i + 1 + j, k, (k + 1 + m) % count]
    return None if best is None else hull[best]


def _turned(points: FloatArray) -> FloatArray:
    """Return parameters around the z axis: v by the angle, u along z or the radius."""
    angle = np.arctan2(points[:, 1], points[:, 0])
    ordered = np.sort(angle)
    gaps = np.diff(np.concatenate([ordered, ordered[:1] + 2 * np.pi]))
    start = ordered[(int(np.argmax(gaps)) + 1) % len(ordered)]
    around = (angle - start) % (2 * np.pi)
    radius = np.hypot(points[:, 0], points[:, 1])
    profile = np.stack([radius, points[:, 2]], axis=1)
    along = _principal(profile)[:, 0]
    return np.stack([_unit(along), _unit(around)], axis=1)


def _beside_mirror(points: FloatArray, mirror: FloatArray) -> FloatArray:
    """Return parameters with u across a mirror plane, whose points have u = 1/2."""
    normal = mirror[:3] / np.linalg.norm(mirror[:3])
    away = points @ normal + mirror[3] / np.linalg.norm(mirror[:3])
    within = points - away[:, None] * normal
    along = _principal(within)[:, 0]
    reach = float(np.abs(away).max()) or 1.0
    return np.stack([0.5 - 0.5 * away / reach, _unit(along)], axis=1)


def _unrolled(points: FloatArray) -> FloatArray | None:
    """Return points (n, 2) rolled off the cylinder that is nearest to them, where they go round it."""
    from quintrig.shaping.fitting.primitives import rough_cylinder

    found = rough_cylinder(points)
    if found is None:
        return None
    centre, axis, radius = found
    helper = np.eye(3)[int(np.argmin(np.abs(axis)))]
    e1 = np.cross(axis, helper)
    e1 /= np.linalg.norm(e1)
    e2 = np.cross(axis, e1)
    local = points - centre
    angle = np.arctan2(local @ e2, local @ e1)
    ordered = np.sort(angle)
    gaps = np.diff(np.concatenate([ordered, ordered[:1] + 2 * np.pi]))
    start = ordered[(int(np.argmax(gaps)) + 1) % len(ordered)]
    turned = (angle - start) % (2 * np.pi)
    if np.ptp(turned) < 0.8:
        return None
    return np.stack([radius * turned, local @ axis], axis=1)


def _harmonic(scan: Scan, plane: FloatArray) -> FloatArray | None:
    """Return parameters of a disc of triangles: its border on the sides of the square, the inside by Tutte (1963)."""
    triangles = scan.triangles
    if triangles is None:
        return None
    loop = border(triangles)
    if loop is None or len(loop) < 8 or len(np.unique(triangles)) != len(scan.points):
        return None
    corners = _corners(plane[loop])
    if corners is None:
        return None
    at = sorted({int(np.argmin(((plane[loop] - c) ** 2).sum(axis=1))) for c in corners})
    if len(at) < 4:
        return None
    loop = np.roll(loop, -at[0])
    at = [k - at[0] for k in at] + [len(loop)]
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]])
    closed = np.concatenate([loop, loop[:1]])
    result = np.zeros((len(scan.points), 2))
    for side in range(4):
        part = closed[at[side] : at[side + 1] + 1]
        length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(scan.points[part], axis=0), axis=1))])
        share = (length / (length[-1] or 1.0))[:, None]
        result[part] = (1.0 - share) * square[side] + share * square[side + 1]
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    sides = np.concatenate([sides, sides[:, ::-1]])
    weight = 1.0 / np.maximum(np.linalg.norm(scan.points[sides[:, 0]] - scan.points[sides[:, 1]], axis=1), 1e-300)
    count = len(scan.points)
    links: Any = sparse_.csr_matrix((weight, (sides[:, 0], sides[:, 1])), shape=(count, count))
    full: Any = sparse_.diags(np.asarray(links.sum(axis=1)).ravel()) - links
    inner = np.setdiff1d(np.arange(count), loop)
    if len(inner):
        right = -full[inner][:, loop] @ result[loop]
        result[inner] = sparse_linalg_.splu(full[inner][:, inner].tocsc()).solve(np.asarray(right))
    return np.clip(result, 0.0, 1.0) if np.isfinite(result).all() else None


def border(triangles: Triangles) -> Triangles | None:
    """Return the points of the only border of a mesh, in turn; None where there is none, or several."""
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    _, back, count = np.unique(np.sort(sides, axis=1), axis=0, return_inverse=True, return_counts=True)
    free = sides[count[back.reshape(-1)] == 1]
    following = dict(free.tolist())
    if not following or len(following) != len(free):
        return None
    start = int(free[0, 0])
    loop = [start]
    while (following_one := following.get(loop[-1])) is not None and following_one != start:
        loop.append(following_one)
        if len(loop) > len(free):
            return None
    return np.array(loop) if len(loop) == len(free) else None
