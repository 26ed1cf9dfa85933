"""The edge of regression of a ruled developable: where it lies, and where inside the strip."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from quintrig.basis.bernstein import Bernstein
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import BoolArray, FloatArray, typical

_FINE = 1e-10  # to which ends of intervals are bisected
_APART = 1e-9  # by which the zeros of S_u x S_v at both boundaries differ where the edge crosses between two samples
_WIDTHS = (1e-4, 1e-5, 1e-6)  # of the brackets around a zero: wide ones see its slope, narrow ones what lies near it
_NODES = np.array([-8.0, -7.0, -6.0, -5.0, -2.0, -1.5, 1.5, 2.0, 5.0, 6.0, 7.0, 8.0])  # in widths from its middle
_INNER = np.abs(_NODES) < 4.0
_PARALLEL = 1e-6  # sine between the normals at both ends of a ruling, above which a surface is not developable
_ALONG = 33  # rulings on which a surface must be developable, to rounding, for its edge of regression to be told
_TURNED = 1e-9  # the sine from rounding alone


Areas = Callable[[FloatArray], tuple[FloatArray, FloatArray]]
"""From parameters (n,) along a strip to S_u x S_v at both boundaries, each (n, 3), length²."""


@dataclass(frozen=True, eq=False)
class Regression:
    """Where the edge of regression of a ruled developable lies.

    ``u`` (n,), ``v`` (n,) the parameter on each ruling where S_u x S_v vanishes (infinite on a cylinder), ``inside``
    (n,) where that is within [0, 1], and ``intervals`` the ranges of u where it is, to 1e-10. ``still`` holds the u of
    rulings that are singular as a whole: there the strip stands still, as at an end with shape parameter -4, or turns
    back.
    """

    u: FloatArray
    v: FloatArray
    inside: BoolArray
    intervals: tuple[tuple[float, float], ...]
    still: tuple[float, ...]

    def __repr__(self) -> str:
        """Return one line: where the edge lies inside."""
        spans = ", ".join(f"{low:.6g} to {high:.6g}" for low, high in self.intervals[:4])
        return f"<Regression on {len(self.u)} rulings: {f'inside for u from {spans}' if spans else 'outside'}>"


@dataclass(frozen=True)
class _Crossing:
    """The zeros of S_u x S_v at both boundaries between two samples, and whether they are apart, not one."""

    low: float
    high: float
    apart: bool


def regression(surface: Surface, samples: int = 513) -> Regression:
    """Locate the edge of regression of a ruled developable surface.

    On each ruling of a developable S_u x S_v is linear in v along one fixed normal, so it vanishes once:
    at v = j_A / (j_A - j_B), with j the component at the two boundaries; NaN where the whole ruling is singular.
    Raises ValueError for a surface that is not ruled in v, or whose tangent plane turns along a ruling.
    """
    if surface.blend != Bernstein(1):
        raise ValueError("regression: expected a surface with straight rulings in v")
    u = np.linspace(0.0, 1.0, samples)
    first, second = _areas(surface, u)
    square = np.maximum((first**2).sum(-1), (second**2).sum(-1))
    turning = (np.cross(first, second) ** 2).sum(-1) > (_PARALLEL * square) ** 2
    if turning.any():
        raise ValueError(
            f"regression: expected a developable, but the tangent plane turns along the ruling at u = {u[turning][0]:g}"
        )
    return locate(lambda t: _areas(surface, t), u)


def locate(areas: Areas, u: FloatArray, margin: float = 0.0) -> Regression:
    """Locate the edge of regression of a developable strip from its areas, looked at first at ``u`` (n,).

    The edge may come nearer to a boundary than the share ``margin`` of the ruling without being inside.
    """
    first, second = areas(u)
    squares: tuple[FloatArray, FloatArray] = (first**2).sum(-1), (second**2).sum(-1)
    # The larger one gives the direction of the normal; the other is parallel to it, or opposite.
    larger = np.where((squares[0] > squares[1])[:, None], first, second)
    square = np.maximum(*squares)
    # Where both vanish the whole ruling is singular: no edge crosses there.
    moves = square > 1e-24 * typical(square)

    def crosses(t: FloatArray) -> BoolArray:
        one, other = areas(t)
        most = np.maximum((one**2).sum(-1), (other**2).sum(-1))
        return np.asarray((one * other).sum(-1) <= -margin * most)

    opposite: FloatArray = (first * second).sum(-1)
    inside = crosses(u) & moves
    with np.errstate(divide="ignore", invalid="ignore"):
        from_first, from_second = squares[0] / (squares[0] - opposite), opposite / (opposite - squares[1])
    v = np.where(moves, np.where(squares[0] > squares[1], from_first, from_second), np.nan)
    narrow = _narrow(areas, u, larger, inside | ~moves)
    intervals = _wide(crosses, u, inside) + [(cross.low, cross.high) for cross in narrow if cross.apart]
    still = [float(x) for x in u[~moves]] + [0.5 * (cross.low + cross.high) for cross in narrow if not cross.apart]
    return Regression(u, v, inside, tuple(sorted(intervals)), tuple(sorted(still)))


@lru_cache(maxsize=4)  # asked by integrals and cautions of one surface
def inner_regression(surface: Surface) -> Regression | None:
    """Return the edge of regression where it lies inside the strip of a developable; None for all other surfaces."""
    if surface.blend != Bernstein(1):
        return None
    first, second = _areas(surface, np.linspace(0.0, 1.0, _ALONG))
    turned = np.linalg.norm(np.cross(first, second), axis=-1)
    if (turned > _TURNED * np.linalg.norm(first, axis=-1) * np.linalg.norm(second, axis=-1)).any():
        return None  # the tangent plane turns along a ruling
    found = regression(surface)
    return found if found.intervals else None


def _areas(surface: Surface, u: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return S_u x S_v at both boundaries, each (n, 3), length²."""
    point, slope = surface.rows.derivatives(u, 1)
    ruling = point[:, 1] - point[:, 0]
    areas: list[FloatArray] = [np.cross(slope[:, side], ruling) for side in (0, 1)]
    return areas[0], areas[1]


def _wide(crosses: Callable[[FloatArray], BoolArray], u: FloatArray, inside: BoolArray) -> list[tuple[float, float]]:
    """Return the intervals that hold a sample, their ends bisected."""

    def lies_inside(middle: float) -> bool:
        return bool(crosses(np.array([middle]))[0])

    intervals: list[tuple[float, float]] = []
    edges = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]]).astype(np.int8)))
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        low = float(u[0]) if start == 0 else _bisected(lies_inside, float(u[start - 1]), float(u[start]))[1]
        high = float(u[-1]) if end == len(u) else _bisected(lies_inside, float(u[end]), float(u[end - 1]))[1]
        intervals.append((low, high))
    return intervals


def _narrow(areas: Areas, u: FloatArray, normal: FloatArray, known: BoolArray) -> list[_Crossing]:
    """Return the intervals between two samples: there S_u x S_v turns to the other side, and vanishes on the way."""
    turned = ((normal[:-1] * normal[1:]).sum(-1) < 0.0) & ~known[:-1] & ~known[1:]
    found = [_crossing(areas, float(u[k]), float(u[k + 1]), normal[k]) for k in np.flatnonzero(turned)]
    return [crossing for crossing in found if crossing is not None]


def _crossing(areas: Areas, low: float, high: float, normal: FloatArray) -> _Crossing | None:
    """Return where the heights of S_u x S_v over ``normal`` vanish at the two boundaries; None where they have a pole.

    Where the planes turn back, a boundary is a quotient of numbers that vanish, and what is found beside its zero is
    rounding. So the zero is told, and placed, by a cubic through points on both sides of it, at the distance where it
    is known best.
    """
    places: list[float] = []
    doubt = 0.0
    for side in (0, 1):

        def height(x: FloatArray, side: int = side) -> FloatArray:
            return (areas(x)[side] * normal).sum(-1)

        outside, inside, zeros = low, high, list[tuple[float, float]]()
        for width in _WIDTHS:
            outside, inside = _bisected(lambda x, h=height: bool(h(np.array([x]))[0] <= 0.0), outside, inside, width)
            zeros.append(_zero(height, 0.5 * (outside + inside), max(abs(inside - outside), 1e-9)))
        off, place = min((off, place) for place, off in zeros)
        if not math.isfinite(off):
            return None
        places.append(place)
        doubt = max(doubt, off)
    # Beyond what is found of both, with a margin, they are two zeros: the edge crosses between them.
    return _Crossing(min(places), max(places), abs(places[1] - places[0]) > max(_APART, 8.0 * doubt))


def _zero(height: Callable[[FloatArray], FloatArray], middle: float, width: float) -> tuple[float, float]:
    """Return where a height vanishes near ``middle``, within ``width``, and how far it may be off; infinite at a pole.

    A zero falls by three or more from the outer points to the inner ones, a pole grows by as much.
    """
    x = middle + width * _NODES
    held = (x >= 0.0) & (x <= 1.0)
    values = height(np.clip(x, 0.0, 1.0))
    held &= np.isfinite(values)
    inner, outer = (np.abs(values[held & part]) for part in (_INNER, ~_INNER))
    if held.sum() < 6 or not len(inner) or not len(outer) or not inner.max() < outer.max():
        return middle, math.inf
    fit = np.polynomial.Polynomial.fit(_NODES[held], values[held], 3)
    slope = abs(float(fit.deriv()(0.0)))
    rest = float(np.abs(fit(_NODES[held]) - values[held]).max())
    if not slope > 0.0:
        return middle, math.inf
    roots = fit.roots()
    real = np.real(roots[np.abs(np.imag(roots)) <= 1.0])
    at = float(real[np.abs(real).argmin()]) if len(real) else math.inf
    return (middle + width * at, width * rest / slope) if abs(at) <= 2.0 else (middle, math.inf)


def _bisected(
    holds: Callable[[float], bool], outside: float, inside: float, width: float = _FINE
) -> tuple[float, float]:
    """Return parameters ``width`` apart where ``holds`` is false and true, from two that lie further apart."""
    while abs(inside - outside) > width:
        middle = 0.5 * (outside + inside)
        outside, inside = (outside, middle) if holds(middle) else (middle, inside)
    return outside, inside
