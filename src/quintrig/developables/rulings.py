"""The rulings of a developable strip: their frame along the strip, its rates of turning, and what forbids a pattern."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from quintrig.developables.regression import locate
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.legendre import legendre
from quintrig.support.tolerance import rounding

_STRAIGHT = 1e-10
"""Points of a ruling may be this far off its line, relative to the surface's size and beside rounding."""

_TOUCHING = 1e-9
"""The edge of regression may come this near to a boundary, as a share of the ruling, without being inside."""

Offset = Callable[[BoolArray], FloatArray]
"""From whether the strip bends towards its normal to the place of the neutral layer along the normal, length¹."""


@dataclass(frozen=True, eq=False)
class Frame:
    """What the neutral layer does at parameters (n,) along the strip, per unit of the parameter.

    ``length`` of the ruling; ``along`` and ``across`` (2, n), the boundaries' speeds along and across the ruling;
    ``turning`` of the ruling in the tangent plane; ``bend`` of the normal; ``upward`` where it bends towards the
    normal; ``speed`` (2, n) of the boundaries; ``area`` swept; ``areas`` (2, n, 3), the product of the
    boundaries' velocities and the ruling.
    """

    length: FloatArray
    along: FloatArray
    across: FloatArray
    turning: FloatArray
    bend: FloatArray
    upward: BoolArray
    speed: FloatArray
    area: FloatArray
    areas: FloatArray


@dataclass(frozen=True, eq=False)
class Rulings:
    """The strip between its two boundaries; ``along`` names the parameter across which the rulings lie.

    ``breaks`` (n,) cut it where derivatives may jump; ``twist`` is the largest angle between the normals at the two
    ends of a ruling, in radians, 0 for a developable.
    """

    surface: Surface
    along: str
    breaks: FloatArray
    twist: float
    offset: Offset

    def at(self, t: FloatArray) -> Frame:
        """Return the frame at parameters (n,)."""
        point, slope, bow = _boundaries(self.surface, self.along, t)
        ruling, ruling_slope = point[1] - point[0], slope[1] - slope[0]
        length = _norm(ruling)
        e = ruling / length[:, None]
        e_slope = (ruling_slope - (ruling_slope * e).sum(-1, keepdims=True) * e) / length[:, None]
        # The boundary that moves faster across the ruling tells the normal best.
        crossed = _cross(slope, ruling)
        faster = ((crossed**2).sum(-1).argmax(axis=0), np.arange(len(t)))
        sign = self.surface.sign * (1.0 if self.along == "u" else -1.0)
        size = _norm(crossed[faster])[:, None]
        n = _divided(sign * crossed[faster], size)
        g = _cross(n, e)
        change = _cross(bow[faster], ruling) + _cross(slope[faster], ruling_slope)
        bend = (_divided(sign * change, size) * g).sum(-1)
        across = (slope * g).sum(-1)
        upward = np.asarray(bend * across.sum(axis=0) < 0.0)
        # Moved by d along n, a boundary gains the speed d n', which is across the ruling.
        shift = self.offset(upward) * bend
        moved = slope + shift[:, None] * g
        return Frame(
            length,
            (slope * e).sum(-1),
            across + shift,
            (e_slope * g).sum(-1),
            bend,
            upward,
            _norm(moved),
            _swept(moved, ruling),
            _cross(moved, ruling),
        )


def rulings(surface: Surface, offset: Offset) -> Rulings:
    """Return the straight rulings of a surface.

    Raises ValueError where it has none, where one has no length, and where the edge of regression of the surface or of
    its neutral layer lies inside the strip.
    """
    along = _direction(surface)
    t: FloatArray = np.linspace(0.0, 1.0, 1025)
    point, slope, _ = _boundaries(surface, along, t)
    ruling = point[1] - point[0]
    lengths = _norm(ruling)
    if not lengths.min() > 1e-9 * surface.size:
        place = f"{along} = {t[lengths.argmin()]:.4g}"
        raise ValueError(f"the ruling at {place} has no length: the strip ends in a point there; cut it off before")
    crossed = _cross(slope, ruling)
    sizes = _norm(crossed)
    fair = sizes.min(axis=0) > 1e-6 * sizes.max()
    sine = _norm(_cross(crossed[0, fair], crossed[1, fair]))
    angle = np.arctan2(sine, np.abs((crossed[0, fair] * crossed[1, fair]).sum(-1)))
    strip = Rulings(surface, along, _breaks(surface, along), float(angle.max(initial=0.0)), offset)
    if strip.twist < 1e-3:  # else it is no developable, and has no such edge
        _refuse_regression(strip, t)
    return strip


def _direction(surface: Surface) -> str:
    """Return the parameter across the rulings; ValueError with the bend of both families of lines."""
    t, s = np.linspace(0.0, 1.0, 33), np.linspace(0.0, 1.0, 9)
    off: dict[str, float] = {}
    for along in ("u", "v"):
        # (33, 9, 3): each line of the second axis should be straight.
        lines = surface(t[:, None], s[None, :]) if along == "u" else surface(s[None, :], t[:, None])
        chord = lines[:, -1:] - lines[:, :1]
        away = lines - lines[:, :1]
        share = _divided((away * chord).sum(-1, keepdims=True), (chord**2).sum(-1, keepdims=True))
        off[along] = float(_norm(away - share * chord).max()) / surface.size
        if off[along] <= _STRAIGHT + rounding(lines) / surface.size:
            return along
    raise ValueError(
        f"the surface has no straight rulings: its lines bend by {100 * off['u']:.2g} % of its size along v and by "
        f"{100 * off['v']:.2g} % along u; only ruled surfaces that are developable have a flat pattern"
    )


def _boundaries(surface: Surface, along: str, t: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return points and first and second derivatives of both boundaries, each (2, n, 3)."""
    ends = np.array([[0.0], [1.0]])
    if along == "u":
        p = surface.partials(t[None, :], ends, 2)
        return p[0, 0], p[1, 0], p[2, 0]
    p = surface.partials(ends, t[None, :], 2)
    return p[0, 0], p[0, 1], p[0, 2]


def _swept(slope: FloatArray, ruling: FloatArray) -> FloatArray:
    """Return the area swept per unit of the parameter, ∫ |S_t x (B - A)| dv, shape (n,)."""
    nodes, weights = legendre(8)
    result: FloatArray = np.zeros(len(ruling))
    for node, weight in zip(0.5 + 0.5 * nodes, 0.5 * weights, strict=True):
        result += weight * _norm(_cross((1.0 - node) * slope[0] + node * slope[1], ruling))
    return result


def _breaks(surface: Surface, along: str) -> FloatArray:
    return surface.breaks("uv".index(along))


def _refuse_regression(strip: Rulings, t: FloatArray) -> None:
    """Raise ValueError where the boundaries move to opposite sides of a ruling: between them the surface turns back."""

    def areas(t: FloatArray) -> tuple[FloatArray, FloatArray]:
        first, second = strip.at(t).areas
        return first, second

    # At an end the strip may stand still, and rounding would tell the direction.
    found = locate(areas, t[1:-1], _TOUCHING).intervals
    if not found:
        return
    spans = ", ".join(f"{low:.6g} to {high:.6g}" for low, high in found[:4])
    raise ValueError(
        f"the edge of regression lies inside the strip for {strip.along} = {spans}: there the sheet would "
        "fold back through itself; move a bounding plane or boundary to one side of that edge, or use a thinner sheet"
    )


def _cross(x: FloatArray, y: FloatArray) -> FloatArray:
    return np.asarray(np.cross(x, y), dtype=np.float64)


def _norm(vectors: FloatArray) -> FloatArray:
    return np.sqrt((vectors**2).sum(axis=-1))


def _divided(x: FloatArray, y: FloatArray) -> FloatArray:
    """Return x / y, 0 where y vanishes."""
    return np.divide(x, y, out=np.zeros(np.broadcast_shapes(x.shape, y.shape)), where=y != 0.0)
