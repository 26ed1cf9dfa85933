"""Developable strips between two curves: rulings between points at which both curves have the same tangent plane."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.basis.bernstein import Bernstein
from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.model.kinds.constructions import basis_keys
from quintrig.model.model import Model
from quintrig.shaping.matching import SITES, Pace, matched
from quintrig.shaping.rails import Rail, alike, rail
from quintrig.support.arrays import FloatArray
from quintrig.support.scipy_inside import shortest, tree_of

_MOST_POINTS = 32  # of a curve anew
_FITS = 1e-7  # of its size: with so little deviation it has points enough


@dataclass(frozen=True, eq=False)
class Strip:
    """A ruled patch that is nearly developable, and how nearly.

    ``t`` (n,) on the second curve belong to ``s`` (n,) on the first; ``twist`` is the largest angle between the normals
    at the ends of a ruling, degrees, ``largest_gaussian`` the largest |K|, length⁻², and ``deviation`` the farthest
    that the patch's second edge is from the second curve, length¹: the first edge is the first curve.
    """

    model: Model
    s: FloatArray
    t: FloatArray
    twist: float
    largest_gaussian: float
    deviation: float

    @property
    def surface(self) -> Surface:
        """The patch."""
        return self.model.surface

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, without the model."""
        return {
            "unit": self.model.unit,
            "twist": self.twist,
            "largest_gaussian": finite(self.largest_gaussian),
            "deviation": self.deviation,
            "rulings": [[float(a), float(b)] for a, b in zip(self.s[::8], self.t[::8], strict=True)],
        }


def strip(first: Curve, second: Curve, unit: str = "", name: str = "strip") -> Strip:
    """Return the best developable strip between two curves in space, from end to end of both.

    The second may run the other way. Raises ValueError for curves in the plane, and for curves that meet.
    """
    one, other = alike([rail(first, "first"), rail(second, "second")])
    pace = matched(one, other)
    keys, deviation = patch_keys(one, other, pace)
    header: dict[str, Any] = {"name": name} | ({"unit": unit} if unit else {})
    model = Model.from_dict(header | keys)
    t = 1.0 - pace.t if other.alone is None else pace.t
    return Strip(model, SITES, t, twist(model.surface), largest_gaussian(model.surface), deviation)


def finite(value: float) -> float | None:
    """Return a number for JSON, None for what is none."""
    return float(value) if np.isfinite(value) else None


def patch_keys(
    first: Rail, second: Rail, pace: Pace, start: float = 0.0, end: float = 1.0, most: float = _FITS
) -> tuple[dict[str, Any], float]:
    """Return the keys of the ruled patch between two rails from one ruling to another, and its edges' deviation.

    Edges are the curves themselves where the patch has all of them at their own pace, else they are laid along them,
    with their tangents at the ends. ``most`` is how far they may be off, as a share of their size.
    """
    whole = start == 0.0 and end == 1.0
    x = SITES
    s = start + (end - start) * x
    ends = np.array([start, end])
    made: list[tuple[FloatArray, Any]] = []
    off = 0.0
    for each, at, slope, own in (
        (first, s, np.ones(2), True),
        (second, pace(s), pace.slope(ends), pace.plain),
    ):
        curve = each.alone if whole and own else None
        if curve is not None:
            made.append((curve.points, curve.functions))
            continue
        d = np.stack([each.derivatives(at[:1])[1, 0], each.derivatives(at[-1:], left=True)[1, 0]])
        # Where a rail is one curve and the strip all of it, no neighbour asks for the tangents.
        tangents = None if whole else (end - start) * slope[:, None] * d
        points, far = laid(each(at), tangents, each, most)
        made.append((points, Bernstein(len(points) - 1)))
        off = max(off, far)
    keys = basis_keys([functions for _, functions in made])
    if keys is None:
        raise ValueError("first: expected a curve in a basis with a name")
    return {"kind": "ruled", "first": made[0][0].tolist(), "second": made[1][0].tolist()} | keys, off


def laid(wanted: FloatArray, tangents: FloatArray | None, onto: Rail, most: float = _FITS) -> tuple[FloatArray, float]:
    """Return Bernstein points (m, 3) through points (257, 3) at even parameters, and how far they are from a rail.

    They begin and end at the first and the last point, with derivatives ``tangents`` (2, 3) there if given.
    """
    size = float(np.linalg.norm(np.ptp(wanted, axis=0)))
    points, off = wanted[[0, -1]], np.inf
    for count in range(6, _MOST_POINTS + 1, 2):
        f = Bernstein(count - 1).derivatives(SITES, 0)[0]
        held = {0: wanted[0], count - 1: wanted[-1]}
        if tangents is not None:
            held |= {1: wanted[0] + tangents[0] / (count - 1), count - 2: wanted[-1] - tangents[1] / (count - 1)}
        at = sorted(held)
        fixed = np.array([held[k] for k in at])
        free = [k for k in range(count) if k not in held]
        tried = np.empty((count, 3))
        tried[at] = fixed
        tried[free] = shortest(f[:, free], wanted - f[:, at] @ fixed)
        far = away(f @ tried, onto)
        if far < off:
            points, off = tried, far
        if off <= most * size:
            break
    return points, off


def away(points: FloatArray, onto: Rail) -> float:
    """Return the largest distance of points from a rail, by Newton's steps from the nearest of 2049 points."""
    grid = np.linspace(0.0, 1.0, 2049)
    at = grid[np.asarray(tree_of(onto(grid)).query(points)[1])]
    for _ in range(4):
        d = onto.derivatives(at)
        at = np.clip(at + ((points - d[0]) * d[1]).sum(-1) / np.maximum((d[1] ** 2).sum(-1), 1e-300), 0.0, 1.0)
    return float(np.linalg.norm(onto(at) - points, axis=1).max())


def largest_gaussian(surface: Surface) -> float:
    """Return the largest |K| at 129 x 17 points, length⁻²."""
    u, v = np.linspace(0.0, 1.0, 129)[:, None], np.linspace(0.0, 1.0, 17)
    with np.errstate(invalid="ignore"):
        return float(np.nanmax(np.abs(analyse(surface, u, v)["gaussian"])))


def twist(surface: Surface) -> float:
    """Return the largest angle between the normals at the ends of a ruling, degrees."""
    u = np.linspace(0.0, 1.0, 513)
    ends = [surface.partials(u, np.full_like(u, v), 1) for v in (0.0, 1.0)]
    normals = [np.cross(p[1, 0], p[0, 1]) for p in ends]
    size = np.linalg.norm(normals, axis=-1)
    fair = size.min(axis=0) > 1e-9 * size.max()
    sine = np.linalg.norm(np.cross(normals[0], normals[1]), axis=-1)
    angle = np.degrees(np.arctan2(sine, (normals[0] * normals[1]).sum(axis=-1)))
    return float(angle[fair].max(initial=0.0))
