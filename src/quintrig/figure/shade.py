"""From surfaces and lines to flat pieces of paint, sorted by depth so that near ones cover far ones."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.colors import to_rgb

from quintrig.figure.camera import View
from quintrig.figure.palette import BACK, FRONT
from quintrig.support.arrays import BoolArray, FloatArray

_LIGHT = np.array([-0.42, 0.55, 0.72]) / np.linalg.norm([-0.42, 0.55, 0.72])  # from the upper left, before the picture
_HALFWAY = _LIGHT + np.array([0.0, 0.0, 1.0])
_GLOSS = _HALFWAY / np.linalg.norm(_HALFWAY)
_LAMP = np.array([-0.3, 0.4, 1.0]) / np.linalg.norm([-0.3, 0.4, 1.0])  # softer, for colours that are read off a key
_DIMMEST = 0.9


@dataclass(frozen=True, eq=False)
class Paint:
    """Quads of the picture: corners (n, 4, 2), fill and edge RGBA (n, 4), edge widths (n,) in points, depths (n,)."""

    corners: FloatArray
    fill: FloatArray
    edge: FloatArray
    width: FloatArray
    depth: FloatArray


def joined(paints: Sequence[Paint]) -> Paint:
    """Return all pieces in one, the farthest first."""
    parts = [p for p in paints if len(p.depth)] or [nothing()]
    order = np.argsort(np.concatenate([p.depth for p in parts]), kind="stable")
    return Paint(
        np.concatenate([p.corners for p in parts])[order],
        np.concatenate([p.fill for p in parts])[order],
        np.concatenate([p.edge for p in parts])[order],
        np.concatenate([p.width for p in parts])[order],
        np.concatenate([p.depth for p in parts])[order],
    )


def facets(
    points: FloatArray,
    view: View,
    colours: FloatArray | None,
    sign: float,
    inside: BoolArray,
    *,
    readable: bool = False,
    face: BoolArray | None = None,
    rim: float = 0.0,
) -> Paint:
    """Return the quads of a grid of points (n + 1, m + 1, 3), lit from the upper left.

    ``colours`` (n, m, 3) are dimmed where the light grazes; None paints the side of the normal and the back in two
    colours. ``readable`` colours keep to those of a key: they are hardly dimmed, never brightened, and keep their hue.
    ``sign`` is the surface's; facets with no corner ``inside`` (n + 1, m + 1) are left out, and those outside the
    ``face`` (n, m). Each reaches ``rim`` (length¹) over its edges, which closes the hairlines between neighbours.
    """
    seen = view.project(points)
    corners = np.stack([seen[:-1, :-1], seen[1:, :-1], seen[1:, 1:], seen[:-1, 1:]], axis=2)
    normal = np.cross(corners[:, :, 2] - corners[:, :, 0], corners[:, :, 3] - corners[:, :, 1])
    length = np.sqrt((normal**2).sum(axis=-1, keepdims=True))
    normal = np.where(length > 0.0, normal / np.where(length > 0.0, length, 1.0), [0.0, 0.0, 1.0])
    facing = np.where(normal[..., 2:] < 0.0, -1.0, 1.0)
    if colours is None:
        front = sign * facing > 0.0
        colours = np.where(front, np.array(to_rgb(FRONT)), np.array(to_rgb(BACK)))
    lit = _dimmed(colours, facing * normal) if readable else _lit(colours, facing * normal)
    keep = inside[:-1, :-1] | inside[1:, :-1] | inside[1:, 1:] | inside[:-1, 1:]
    keep = keep if face is None else keep & face
    rgba = np.concatenate([lit, np.ones((*lit.shape[:2], 1))], axis=-1)[keep]
    flat = corners[keep]
    # To draw the edges in the colour of the face would do the same, and take almost twice as long.
    return Paint(_widened(flat[..., :2], rim), rgba, rgba, np.zeros(len(flat)), flat[..., 2].mean(axis=1))


def _widened(quads: FloatArray, rim: float) -> FloatArray:
    """Return quads (n, 4, 2) with every side moved outwards by ``rim``, no corner by more than twice that."""
    sides = np.roll(quads, -1, axis=1) - quads
    across = quads[:, 2:] - quads[:, :2]
    turn = np.where(across[:, 0, 0] * across[:, 1, 1] < across[:, 0, 1] * across[:, 1, 0], -1.0, 1.0)
    lengths = np.hypot(sides[..., 0], sides[..., 1])
    outwards = np.stack([sides[..., 1], -sides[..., 0]], axis=-1) * turn[:, None, None]
    outwards /= np.where(lengths > 0.0, lengths, 1.0)[..., None]
    before = np.roll(outwards, 1, axis=1)
    both = outwards + before
    return quads + rim * both / np.maximum(1.0 + (outwards * before).sum(axis=-1), 0.5)[..., None]


def _lit(colours: FloatArray, normal: FloatArray) -> FloatArray:
    """Return the colours as of a glossy body, for its form alone."""
    light = np.clip(normal @ _LIGHT, 0.0, 1.0)[..., None]
    lit = np.clip(colours * (0.62 + 0.43 * light), 0.0, 1.0)
    gloss = 0.13 * np.clip(normal @ _GLOSS, 0.0, 1.0)[..., None] ** 24
    return lit + gloss * (1.0 - lit)


def _dimmed(colours: FloatArray, normal: FloatArray) -> FloatArray:
    """Return the colours a little darker where the surface slants away, so that they still read off a key."""
    light = np.clip(normal @ _LAMP, 0.0, 1.0)[..., None]
    return colours * (_DIMMEST + (1.0 - _DIMMEST) * light)


def strokes(
    line: FloatArray, view: View, colour: str, width: float, step: float, bias: float, dashed: bool = False
) -> Paint:
    """Return a line (n, 3), broken at NaN, as strokes of about ``step``, moved ``bias`` towards the camera.

    Dashes are two steps long, with one left out between.
    """
    seen = view.project(line)
    starts, ends = seen[:-1], seen[1:]
    whole = np.isfinite(starts).all(axis=1) & np.isfinite(ends).all(axis=1)
    starts, ends = starts[whole], ends[whole]
    lengths = np.sqrt(((ends - starts)[:, :2] ** 2).sum(axis=1))
    if not lengths.sum() > 0.0:
        return nothing()
    # Long segments are cut in equal parts; short ones stay whole, so that every given point is kept.
    parts = np.maximum(np.rint(lengths / step), 1).astype(np.intp)
    which = np.repeat(np.arange(len(parts)), parts)
    first = (np.arange(len(which)) - np.repeat(np.cumsum(parts) - parts, parts)) / parts[which]
    last = first + 1.0 / parts[which]
    a = starts[which] + first[:, None] * (ends - starts)[which]
    b = starts[which] + last[:, None] * (ends - starts)[which]
    if dashed:
        along = (np.cumsum(lengths) - lengths)[which] + 0.5 * (first + last) * lengths[which]
        keep = (along / step) % 3.0 < 2.0
        a, b = a[keep], b[keep]
    corners = np.stack([a, b, b, a], axis=1)
    rgba = np.tile([*to_rgb(colour), 1.0], (len(corners), 1))
    depth = 0.5 * (a[:, 2] + b[:, 2]) + bias
    return Paint(corners[..., :2], np.zeros_like(rgba), rgba, np.full(len(corners), width), depth)


def nothing() -> Paint:
    """Return no paint."""
    return Paint(np.zeros((0, 4, 2)), np.zeros((0, 4)), np.zeros((0, 4)), np.zeros(0), np.zeros(0))
