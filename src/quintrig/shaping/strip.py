"""Developable strips between two curves: rulings between points at which both curves have the same tangent plane.

On a developable the normals at the two ends of a ruling agree, det(A'(s), B'(t), B(t) - A(s)) = 0 (Aumann 1991). Of all
ways t(s) that rise from one end of the second curve to the other, the one with the least twist is taken: first on a
grid, by dynamic programming, then among polynomials in Bernstein form whose coefficients rise.
"""

from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.basis.bernstein import Bernstein
from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.model.kinds.constructions import basis_keys
from quintrig.model.model import Model
from quintrig.support.arrays import FloatArray

_GRID = 97  # rulings, and points of the second curve, in the first search
_STEEPEST = 5  # cells that t may rise by from one ruling to the next
_DEGREE = 14  # of t(s)
_SLOWEST = 0.1  # pace of t: where rulings fan out from one point, the patch would have no normal there
_MOST_POINTS = 32  # of the second curve anew
_FITS = 1e-7  # of its size: with so little deviation it has points enough
_SMOOTH = 1e-4  # of a smooth t(s), beside twist


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
            "largest_gaussian": self.largest_gaussian if np.isfinite(self.largest_gaussian) else None,
            "deviation": self.deviation,
            "rulings": [[float(a), float(b)] for a, b in zip(self.s[::8], self.t[::8], strict=True)],
        }


def strip(first: Curve, second: Curve, unit: str = "", name: str = "strip") -> Strip:
    """Return the best developable strip between two curves in space, from end to end of both.

    The second may run the other way. Raises ValueError for curves in the plane, and for curves that meet.
    """
    for word, curve in (("first", first), ("second", second)):
        if curve.points.shape[1] != 3:
            raise ValueError(f"{word}: expected a curve in space, found one in the plane; give its points a z")
    ends = [curve(np.array([0.0, 1.0])) for curve in (first, second)]
    ahead = np.linalg.norm(ends[0] - ends[1], axis=1).sum()
    back = np.linalg.norm(ends[0] - ends[1][::-1], axis=1).sum()
    turned = bool(back < ahead)
    s = np.linspace(0.0, 1.0, 257)
    t = _matched(first, second, s, turned)
    plain = 1.0 - s if turned else s
    way = -1.0 if turned else 1.0
    same = np.abs(_turns(first, second, s, plain, way)).max() <= 1e-9
    t = plain if same else t
    model, deviation = _patch(first, second, s, t, turned, unit, name, exact=same and not turned)
    surface = model.surface
    with np.errstate(invalid="ignore"):
        u, v = np.linspace(0.0, 1.0, 129)[:, None], np.linspace(0.0, 1.0, 17)
        gauss = np.abs(analyse(surface, u, v)["gaussian"])
    return Strip(model, s, t, _twist(surface), float(np.nanmax(gauss)), deviation)


def _turns(first: Curve, second: Curve, s: FloatArray, t: FloatArray, way: float) -> FloatArray:
    """Return by how much the normal turns along rulings, radians with sign; ``way`` -1 where the second runs back."""
    a, b = first.derivatives(s, 1), second.derivatives(t, 1)
    r, ahead = b[0] - a[0], way * b[1]
    length = np.linalg.norm(r, axis=-1)
    sine = length * (np.cross(a[1], ahead) * r).sum(axis=-1)
    cosine = (np.cross(a[1], r) * np.cross(ahead, r)).sum(axis=-1)
    return np.arctan2(sine, cosine)


def _matched(first: Curve, second: Curve, s: FloatArray, turned: bool) -> FloatArray:
    """Return t at parameters s."""
    grid = np.linspace(0.0, 1.0, _GRID)
    way = grid[::-1] if turned else grid
    a, b = np.meshgrid(grid, way, indexing="ij")
    points = first(np.array([0.0, 0.5, 1.0])), second(np.array([0.0, 0.5, 1.0]))
    span = max(float(np.ptp(part, axis=0).max()) for part in points)
    if np.linalg.norm(first(grid)[:, None] - second(way), axis=-1).min() <= 1e-9 * span:
        raise ValueError("first, second: the curves meet, and rulings there have no length; cut them off before")
    cost = _turns(first, second, a.ravel(), b.ravel(), -1.0 if turned else 1.0).reshape(_GRID, _GRID) ** 2
    total: FloatArray = np.full((_GRID, _GRID), np.inf)
    came = np.zeros((_GRID, _GRID), dtype=np.int64)
    total[0, 0] = cost[0, 0]
    for i in range(1, _GRID):
        for step in range(_STEEPEST + 1):
            before = np.full(_GRID, np.inf)
            before[step:] = total[i - 1, : _GRID - step] + _SMOOTH * (step - 1) ** 2
            better = before < total[i]
            total[i][better], came[i][better] = before[better], step
        total[i] += cost[i]
    path = np.zeros(_GRID)
    j = _GRID - 1
    for i in range(_GRID - 1, -1, -1):
        path[i] = j
        j -= came[i, j]
    family = Bernstein(_DEGREE)
    functions = family.derivatives(s, 0)[0]
    rough = np.interp(np.linspace(0.0, 1.0, _DEGREE + 1), grid, path / (_GRID - 1))
    rises = np.maximum(np.diff(rough), 1e-3)

    def rising(x: FloatArray) -> FloatArray:
        steps = np.exp(x - x.max())
        rise = _SLOWEST / _DEGREE + (1.0 - _SLOWEST) * steps / steps.sum()
        share = functions @ np.concatenate([[0.0], np.cumsum(rise)])
        return np.clip(1.0 - share if turned else share, 0.0, 1.0)

    def residual(x: FloatArray) -> FloatArray:
        return np.concatenate([_turns(first, second, s, rising(x), -1.0 if turned else 1.0), 1e-5 * np.diff(x)])

    best: Any = None
    for start in (np.log(rises), np.zeros(_DEGREE)):  # a constant is taken out by the sum
        done = import_module("scipy.optimize").least_squares(residual, start, xtol=1e-12, ftol=1e-12, max_nfev=200)
        best = done if best is None or done.cost < best.cost else best
    return rising(np.asarray(best.x, dtype=np.float64))


def _patch(
    first: Curve, second: Curve, s: FloatArray, t: FloatArray, turned: bool, unit: str, name: str, *, exact: bool
) -> tuple[Model, float]:
    """Return the ruled patch, and how far its second edge is from the second curve."""
    header: dict[str, Any] = {"name": name} | ({"unit": unit} if unit else {})
    header |= {"kind": "ruled", "first": first.points.tolist()}
    if exact:
        keys = basis_keys((first.functions, second.functions))
        if keys is not None:
            return Model.from_dict(header | {"second": second.points.tolist()} | keys), 0.0
    wanted = second(t)
    size = float(np.linalg.norm(np.ptp(wanted, axis=0)))
    points, off = wanted[[0, -1]], np.inf
    for count in range(6, _MOST_POINTS + 1, 2):
        f = Bernstein(count - 1).derivatives(s, 0)[0]
        ends = wanted[[0, -1]]
        inner: FloatArray = np.asarray(
            np.linalg.lstsq(f[:, 1:-1], wanted - f[:, [0, -1]] @ ends, rcond=None)[0], dtype=np.float64
        )
        tried: FloatArray = np.vstack([ends[:1], inner, ends[1:]])
        far = _off(f @ tried, second)
        if far < off:
            points, off = tried, far
        if off <= _FITS * size:
            break
    keys = basis_keys((first.functions, Bernstein(len(points) - 1)))
    if keys is None:
        raise ValueError("first: expected a curve in a basis with a name")
    return Model.from_dict(header | {"second": points.tolist()} | keys), off


def _off(points: FloatArray, curve: Curve) -> float:
    """Return the largest distance of points from a curve, by Newton's steps from the nearest of 2049 points."""
    grid = np.linspace(0.0, 1.0, 2049)
    cloud = curve(grid)
    at = np.array([grid[((cloud - point) ** 2).sum(axis=1).argmin()] for point in points])
    for _ in range(4):
        d = curve.derivatives(at, 1)
        at = np.clip(at + ((points - d[0]) * d[1]).sum(-1) / np.maximum((d[1] ** 2).sum(-1), 1e-300), 0.0, 1.0)
    return float(np.linalg.norm(curve(at) - points, axis=1).max())


def _twist(surface: Surface) -> float:
    """Return the largest angle between the normals at the ends of a ruling, degrees."""
    u = np.linspace(0.0, 1.0, 513)
    ends = [surface.partials(u, np.full_like(u, v), 1) for v in (0.0, 1.0)]
    normals = [np.cross(p[1, 0], p[0, 1]) for p in ends]
    size = np.linalg.norm(normals, axis=-1)
    fair = size.min(axis=0) > 1e-9 * size.max()
    sine = np.linalg.norm(np.cross(normals[0], normals[1]), axis=-1)
    angle = np.degrees(np.arctan2(sine, (normals[0] * normals[1]).sum(axis=-1)))
    return float(angle[fair].max(initial=0.0))
