"""The turn of the principal directions along lines of parameters: an umbilic's index, and a boundary's rotation."""

from collections.abc import Sequence

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.local import Local
from quintrig.support.arrays import BoolArray, FloatArray

RIM = 1e-9
"""Of parameters, or of the size: on the boundary."""

_AROUND = 720
_INSET = 1e-3  # from a pole, where the rotation around it is taken


def index_about(surface: Surface, uv: FloatArray, others: Sequence[FloatArray]) -> float | None:
    """Return the index by turning once around an umbilic, at a distance where it is alone; None on an edge.

    Across the seam of a closed surface the ring goes on behind it.
    """
    alone = [float(np.abs(uv - other).max()) for other in others if other is not uv]
    reach = min(1e-2, *(0.3 * apart for apart in alone)) if alone else 1e-2
    seams = closed(surface)
    sides = [x for axis in (0, 1) if not seams[axis] for x in (uv[axis], 1.0 - uv[axis])]
    reach = min([reach, *(x for x in sides if x > 1e-6)])
    angle = np.linspace(0.0, 2.0 * np.pi, _AROUND + 1)
    ring = uv + reach * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    ring = np.where(seams & ((ring < 0.0) | (ring > 1.0)), ring % 1.0, ring)
    inside = ((ring >= 0.0) & (ring <= 1.0)).all(axis=1)
    if not inside.all():
        return None
    found = _rotation(surface, ring)
    return found if np.isfinite(found) else None


def closed(surface: Surface) -> BoolArray:
    """Return whether the surface closes smoothly in u and in v, (2,): ends and tangents across them are the same."""
    t = np.linspace(0.0, 1.0, 17)
    if surface.trim:
        return np.zeros(2, dtype=np.bool_)
    pairs = (
        (surface.partials(0.0, t, 1), surface.partials(1.0, t, 1)),
        (surface.partials(t, 0.0, 1), surface.partials(t, 1.0, 1)),
    )
    return np.array([np.abs(first - second).max() <= RIM * surface.size for first, second in pairs])


def _rotation(surface: Surface, ring: FloatArray) -> float:
    """Return the turns of the principal directions, against e1, along a closed line (n, 2) of parameters."""
    found = turned(surface, ring)
    return round(2.0 * found) / 2.0 if np.isfinite(found) else found


def turned(surface: Surface, line: FloatArray) -> float:
    """Return the turn of the principal directions against e1 along a line (n, 2); NaN where it cannot be told."""
    with np.errstate(divide="ignore", invalid="ignore"):
        a, b = Local.at(surface, *line.T).half
    turn = wrapped(np.diff(np.arctan2(b, a)))
    if not np.isfinite(turn).all() or np.abs(turn).max() > 2.5:
        return float("nan")
    return float(turn.sum()) / (4.0 * np.pi)


def along_boundary(surface: Surface, found: Sequence[FloatArray]) -> tuple[float, list[tuple[int, float]]]:
    """Return the rotation along the boundary of a face, and the sides (axis, end) of the domain that count.

    Beside a pole it is taken nearer to it than the umbilics found (2,) are.
    """
    return _along_loops(surface) if surface.trim else _along_sides(surface, found)


def _along_loops(surface: Surface) -> tuple[float, list[tuple[int, float]]]:
    """Return the rotation along the loops of a face, each with the face on its left."""
    loops = [_dense(loop) for loop in surface.trim]
    areas = [_area(loop) for loop in loops]
    outer = int(np.argmax(np.abs(areas)))
    senses = [(1.0 if area > 0.0 else -1.0) * (1.0 if k == outer else -1.0) for k, area in enumerate(areas)]
    return sum(sense * turned(surface, loop) for sense, loop in zip(senses, loops, strict=True)), []


def _along_sides(surface: Surface, found: Sequence[FloatArray]) -> tuple[float, list[tuple[int, float]]]:
    """Return the rotation along the sides of the domain, and the sides (axis, end) that count.

    The two sides of a seam, where a closed surface meets itself, cancel. Beside a pole the side is moved inwards.
    """
    t = np.linspace(0.0, 1.0, 2001)
    total, free = 0.0, list[tuple[int, float]]()
    ends = {(axis, end): _side(axis, end, t) for axis in (0, 1) for end in (0.0, 1.0)}
    points = {key: surface(*line.T) for key, line in ends.items()}
    poles = {key: bool(np.linalg.norm(np.ptp(p, axis=0)) <= RIM * surface.size) for key, p in points.items()}
    low, high = (
        np.array([_inset(found, axis, 0.0) if poles[axis, 0.0] else 0.0 for axis in (0, 1)]),
        np.array([1.0 - _inset(found, axis, 1.0) if poles[axis, 1.0] else 1.0 for axis in (0, 1)]),
    )
    for (axis, end), line in ends.items():
        if np.abs(points[axis, 0.0] - points[axis, 1.0]).max() <= RIM * surface.size and not poles[axis, end]:
            continue
        sense = 1.0 if (axis == 0) == (end == 1.0) else -1.0  # against the clock: up at u = 1, back at v = 1
        total += sense * turned(surface, low + line * (high - low))
        free.append((axis, end))
    return total, free


def _inset(found: Sequence[FloatArray], axis: int, end: float) -> float:
    return min([_INSET, *(0.5 * apart for uv in found if (apart := abs(float(uv[axis]) - end)) > RIM)])


def _side(axis: int, end: float, t: FloatArray) -> FloatArray:
    same = np.full(len(t), end)
    return np.stack([same, t] if axis == 0 else [t, same], axis=1)


def _dense(loop: FloatArray) -> FloatArray:
    closed = np.concatenate([loop, loop[:1]])
    share = np.linspace(0.0, 1.0, 33)[:-1]
    between = closed[:-1, None] + share[None, :, None] * np.diff(closed, axis=0)[:, None]
    return np.concatenate([between.reshape(-1, 2), closed[:1]])


def _area(loop: FloatArray) -> float:
    x, y = loop.T
    return 0.5 * float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))


def wrapped(angle: FloatArray) -> FloatArray:
    """Return angles moved by whole turns into [-π, π)."""
    return (angle + np.pi) % (2.0 * np.pi) - np.pi
