"""How far a file that was written is from the model: read it back and compare point by point."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.basis.bspline import normalised
from quintrig.basis.rational import TangentMap
from quintrig.exchange.cad.curve_forms import CurveCarrier, in_space
from quintrig.exchange.cad.faces import Contents, SpaceCurve
from quintrig.exchange.cad.forms import Carrier
from quintrig.geometry.domain import grid
from quintrig.geometry.exact import ExactCurve
from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import rounding


@dataclass(frozen=True)
class Deviation:
    """The largest distance over one patch, length¹, and the same over the patch's size.

    ``rounding`` is what that distance may be where both are right, length¹: coordinates have 16 digits.
    """

    name: str
    distance: float
    relative: float
    rounding: float


def deviations(parts: Sequence[Carrier], contents: Contents, points: int = 100) -> tuple[Deviation, ...]:
    """Compare each patch with the nearest face that was read back, on ``points`` squared points at mapped parameters.

    Raises ValueError where the file holds another number of faces than the model has patches.
    """
    surfaces = [_surface(face.keys) for face in contents.faces if not face.problem]
    if len(surfaces) != len(parts):
        raise ValueError(f"reading back: expected {len(parts)} faces, found {len(surfaces)}")
    u, v = grid(points, points)
    few = grid(3, 3)
    result: list[Deviation] = []
    for part in parts:
        nearest = min(surfaces, key=lambda other: _distance(part, other, *few))
        distance = _distance(part, nearest, u, v)
        result.append(Deviation(part.name, distance, distance / part.surface.size, rounding(part.surface(*few))))
    return tuple(result)


def curve_deviations(parts: Sequence[CurveCarrier], contents: Contents, points: int = 1000) -> tuple[Deviation, ...]:
    """Compare each curve with the nearest curve that was read back, on ``points`` points at mapped parameters.

    Raises ValueError where the file holds another number of curves than the model has.
    """
    if len(contents.curves) != len(parts):
        raise ValueError(f"reading back: expected {len(parts)} curves, found {len(contents.curves)}")
    t = np.linspace(0.0, 1.0, points)
    read = [_curve(one) for one in contents.curves]
    result: list[Deviation] = []
    for part in parts:
        x, place = part.form.map.forward(t), in_space(part.curve(t))
        away = min(float(np.linalg.norm(one(x) - place, axis=-1).max()) for one in read)
        result.append(Deviation(part.name, away, away / part.size, rounding(place)))
    return tuple(result)


def _curve(read: SpaceCurve) -> ExactCurve:
    basis = normalised(read.knots, read.degree)
    return ExactCurve(basis, np.array(read.points), np.array(read.weights), TangentMap())


def _distance(part: Carrier, other: Surface, u: FloatArray, v: FloatArray) -> float:
    x, y = np.broadcast_arrays(*part.form.to_exact(u, v))
    return float(np.sqrt(((other(x, y) - part.surface(u, v)) ** 2).sum(axis=-1)).max())


def _surface(keys: dict[str, object]) -> Surface:
    return Model.from_dict({"kind": "nurbs", **keys}).surface
