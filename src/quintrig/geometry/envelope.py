"""The enveloping developable: the strip that a one-parameter family of planes touches (thesis §3.3)."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.bernstein import Bernstein, TangentBernstein
from quintrig.basis.functions import Functions
from quintrig.basis.pairs import families, pair
from quintrig.basis.rational import RIGHT_ANGLE, NotRationalError, TangentMap, wedge_points, without_factor
from quintrig.basis.registry import DEFAULT, Choice
from quintrig.geometry.origin import local_origin, moved_plane
from quintrig.geometry.surface import Net, Surface
from quintrig.support import taylor
from quintrig.support.arrays import BoolArray, FloatArray, frozen, parameter
from quintrig.support.pickled import Pickled

_FINE = 1e-10  # to which ends of intervals are bisected
_APART = 1e-9  # by which the zeros of S_u x S_v at both boundaries differ where the edge crosses between two samples
_WIDTHS = (1e-4, 1e-5, 1e-6)  # of the brackets around a zero: wide ones see its slope, narrow ones what lies near it
_NODES = np.array([-8.0, -7.0, -6.0, -5.0, -2.0, -1.5, 1.5, 2.0, 5.0, 6.0, 7.0, 8.0])  # in widths from its middle
_INNER = np.abs(_NODES) < 4.0
_PARALLEL = 1e-6  # sine between the normals at both ends of a ruling, above which a surface is not developable
_ALONG = 33  # rulings on which a surface must be developable, to rounding, for its edge of regression to be told
_TURNED = 1e-9  # the sine from rounding alone


def developable(
    planes: ArrayLike,
    bounds: ArrayLike,
    shape: Sequence[float] | None = None,
    *,
    basis: Choice = DEFAULT,
    flip: bool = False,
    unchecked_shape: bool = False,
) -> Surface:
    """Return the strip enveloped by Π(t) = Σ f_i(t; α, ζ) L_i between two bounding planes (thesis §3.3.2).

    ``planes`` (6, 4), or as many as another basis has functions, and ``bounds`` (2, 4) hold (a, b, c, d) of
    a x + b y + c z + d = 0; ``shape`` is (α, ζ). The ruling at u is Π ∩ Π'; v = 0 lies on the first bounding plane,
    v = 1 on the second. K = 0. The edge of regression may fall inside: ask ``regression``. Raises ValueError for wrong
    counts or values, and where the planes envelop no strip at all.
    """
    family = frozen(planes, "planes", (None, 4))
    cuts = frozen(bounds, "bounds", (2, 4))
    (functions,) = families(pair(basis)[:1], (len(family),), ("planes",), shape, unchecked_shape)
    for name, vectors in (("planes", family), ("bounds", cuts)):
        flat = np.flatnonzero(~(np.abs(vectors[:, :3]).max(axis=1) > 0.0))
        if len(flat):
            raise ValueError(f"{name}[{flat[0]}]: expected a plane [a, b, c, d], found one with a = b = c = 0")
    origin = _strip_origin(Envelope(family, cuts, functions))
    rows = Envelope(family, cuts, functions, origin)
    if not rows.meets():
        raise ValueError(
            "planes: the control planes envelop no strip that the bounding planes cut (they are equal, parallel, or "
            "all contain one line that a bounding plane contains too); change the planes or the bounds"
        )
    return Surface(rows, Bernstein(1), flip, origin=origin)


@dataclass(frozen=True, eq=False)
class Envelope(Pickled):
    """The two boundary curves of the strip: where the rulings Π ∩ Π' meet the bounding planes.

    With n and e the normals of Π and Π', and b that of a bounding plane, the boundary A satisfies n·A + d = 0 and
    n·A' = b·A' = 0, so A' = λ b x n with λ from the derivative of Π'. Worked out in this order, A' lies in the tangent
    plane whatever the rounding, and the strip keeps its accuracy near the edge of regression, where A' vanishes.
    Points are as seen from ``origin``, and so are the planes that they are worked out from.
    """

    planes: FloatArray
    bounds: FloatArray
    functions: Functions
    origin: FloatArray = field(default_factory=lambda: np.zeros(3))

    @property
    def size(self) -> int:
        """Number of rows: two."""
        return 2

    @property
    def dimension(self) -> int:
        """3: points."""
        return 3

    def derivatives(self, u: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by u, shape (order + 1, *u.shape, 2, 3), length¹.

        Not finite where a ruling is parallel to a bounding plane or Π' vanishes inside. Raises ValueError for u
        outside [0, 1].
        """
        plane, slope = self._dual(parameter(u, "u"), order)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            return taylor.derivatives(np.stack([_boundary(plane, slope, cut) for cut in self._local[1]], axis=-2))

    @property
    def homogeneous(self) -> Net:
        """The exact rational form: rows (w x, w y, w z, w), of degree 18 or less in tan(πu/4) for the quintic basis.

        There Π is of degree 10, so Π ∩ Π' is of degree 18, or 14 for α = ζ = 0. Polynomial bases give polynomials in u.
        Where the family of planes stands still at an end, the ruling has a factor that is divided out. Raises
        NotRationalError for a basis that has no such form.
        """
        planes, bounds = self._local
        form = self.functions.rational()
        if form.map not in (RIGHT_ANGLE, TangentMap()):
            raise NotRationalError("strips have an exact rational form over a right angle or in polynomials only")
        growth = 2.0 ** (0.5 * np.arange(form.degree + 1)) if form.map.angle else np.ones(form.degree + 1)
        rulings = wedge_points(growth[:, None] * (form.coefficients @ planes))
        rulings = without_factor(rulings, _stationary(rulings[0]), _stationary(rulings[-1]))
        points = np.stack([_meet(rulings, cut) for cut in bounds], axis=1)
        degree = len(points) - 1
        return Net(points, TangentBernstein(degree) if form.map.angle else Bernstein(degree))

    @cached_property
    def _local(self) -> tuple[FloatArray, FloatArray]:
        """Planes and bounds as seen from the origin."""
        return (
            np.array([moved_plane(plane, self.origin) for plane in self.planes]),
            np.array([moved_plane(plane, self.origin) for plane in self.bounds]),
        )

    def meets(self) -> bool:
        """Return whether some ruling exists and meets both bounding planes in a point."""
        plane, slope = (np.nan_to_num(series[0, :, :3]) for series in self._dual(np.linspace(0.0, 1.0, 33), 0))
        volumes = np.abs(np.cross(plane, slope) @ self.bounds[:, :3].T)
        lengths = [np.linalg.norm(vectors, axis=-1) for vectors in (plane, slope, self.bounds[:, :3])]
        return bool((volumes > 1e-12 * lengths[0].max() * lengths[1].max() * lengths[2]).any(axis=0).all())

    def _dual(self, u: FloatArray, order: int) -> tuple[FloatArray, FloatArray]:
        """Return the series of Π and of Π', the latter without the factors that vanish where Π stands still."""
        planes = self._local[0]
        edges = self.functions.split(planes)[1:]
        plane = self.functions.derivatives(u, order) @ planes
        _, functions = self.functions.hodograph(u, order, self.functions.standing(edges))
        slope = functions @ edges
        # Where the terms cancel to nothing the planes turn back, and rounding must not choose the ruling.
        terms = np.abs(functions[0]) @ np.abs(edges)
        slope[0, (np.abs(slope[0]) <= 64.0 * np.finfo(np.float64).eps * terms).all(axis=-1)] = np.nan
        return taylor.coefficients(plane), taylor.coefficients(slope)


def _strip_origin(rows: Envelope) -> FloatArray:
    """Return an origin near most of a strip: some of its points may lie as good as at infinity."""
    points = rows.derivatives(np.linspace(0.0, 1.0, 17), 0)[0].reshape(-1, 3)
    points = points[np.isfinite(points).all(axis=-1)]
    if not len(points):
        return np.zeros(3)
    quarter, middle = len(points) // 4, len(points) // 2
    ordered: FloatArray = np.sort(points, axis=0)
    return local_origin(ordered[[quarter, middle + quarter]])


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
    squares: tuple[FloatArray, FloatArray] = (first**2).sum(-1), (second**2).sum(-1)
    # The larger one gives the direction of the normal; the other is parallel to it, or opposite.
    larger = np.where((squares[0] > squares[1])[:, None], first, second)
    square = np.maximum(*squares)
    turning = (np.cross(first, second) ** 2).sum(-1) > (_PARALLEL * square) ** 2
    if turning.any():
        raise ValueError(
            f"regression: expected a developable, but the tangent plane turns along the ruling at u = {u[turning][0]:g}"
        )
    # Where both vanish the whole ruling is singular: no edge crosses there.
    moves = square > 1e-24 * np.nanmedian(square)
    opposite: FloatArray = (first * second).sum(-1)
    inside = (opposite <= 0.0) & moves
    with np.errstate(divide="ignore", invalid="ignore"):
        from_first, from_second = squares[0] / (squares[0] - opposite), opposite / (opposite - squares[1])
    v = np.where(moves, np.where(squares[0] > squares[1], from_first, from_second), np.nan)
    narrow = _narrow(surface, u, larger, inside | ~moves)
    intervals = _wide(surface, u, inside) + [(cross.low, cross.high) for cross in narrow if cross.apart]
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


def _wide(surface: Surface, u: FloatArray, inside: BoolArray) -> list[tuple[float, float]]:
    """Return the intervals that hold a sample, their ends bisected."""

    def lies_inside(middle: float) -> bool:
        first, second = _areas(surface, np.array([middle]))
        return bool((first * second).sum() <= 0.0)

    intervals: list[tuple[float, float]] = []
    edges = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]]).astype(np.int8)))
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        low = float(u[0]) if start == 0 else _bisected(lies_inside, float(u[start - 1]), float(u[start]))[1]
        high = float(u[-1]) if end == len(u) else _bisected(lies_inside, float(u[end]), float(u[end - 1]))[1]
        intervals.append((low, high))
    return intervals


def _narrow(surface: Surface, u: FloatArray, normal: FloatArray, known: BoolArray) -> list[_Crossing]:
    """Return the intervals between two samples: there S_u x S_v turns to the other side, and vanishes on the way."""
    turned = ((normal[:-1] * normal[1:]).sum(-1) < 0.0) & ~known[:-1] & ~known[1:]
    found = [_crossing(surface, float(u[k]), float(u[k + 1]), normal[k]) for k in np.flatnonzero(turned)]
    return [crossing for crossing in found if crossing is not None]


def _crossing(surface: Surface, low: float, high: float, normal: FloatArray) -> _Crossing | None:
    """Return where the heights of S_u x S_v over ``normal`` vanish at the two boundaries; None where they have a pole.

    Where the planes turn back, a boundary is a quotient of numbers that vanish, and what is found beside its zero is
    rounding. So the zero is told, and placed, by a cubic through points on both sides of it, at the distance where it
    is known best.
    """
    places: list[float] = []
    doubt = 0.0
    for side in (0, 1):

        def height(x: FloatArray, side: int = side) -> FloatArray:
            return (_areas(surface, x)[side] * normal).sum(-1)

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


def _boundary(plane: FloatArray, slope: FloatArray, cut: FloatArray) -> FloatArray:
    """Return the series of the point common to Π, Π' and ``cut``, from those of the first two (order + 1, ..., 4)."""
    n, e, b = plane[..., :3], slope[..., :3], cut[:3]
    along = np.cross(b, n)
    volume = _dot(e, along)
    result: FloatArray = np.empty_like(along)
    pencil = plane[0, ..., 3:] * np.cross(e[0], b) + slope[0, ..., 3:] * along[0] + cut[3] * np.cross(n[0], e[0])
    result[0] = -pencil / volume[0][..., None]
    rate: FloatArray = np.empty_like(volume)
    for k in range(len(plane) - 1):
        # The derivative of e·A + d = 0 gives λ e·(b x n) = -(e'·A + d').
        rest = -(k + 1) * slope[k + 1, ..., 3]
        for i in range(k + 1):
            rest = rest - (i + 1) * (e[i + 1] * result[k - i]).sum(axis=-1)
        for i in range(k):
            rest = rest - rate[i] * volume[k - i]
        rate[k] = rest / volume[0]
        result[k + 1] = taylor.product(rate[: k + 1, ..., None], along[: k + 1])[k] / (k + 1)
    return result


def _dot(x: FloatArray, y: FloatArray) -> FloatArray:
    """Return the series of the scalar product of two vector series (order + 1, ..., 3)."""
    return taylor.product(x, y).sum(axis=-1)


def _stationary(ruling: FloatArray) -> bool:
    """Return whether U ⊗ V (4, 4) is one plane twice, to rounding: there the family of planes stands still."""
    return bool(np.abs(ruling - ruling.T).max() <= 4.0 * np.finfo(np.float64).eps * np.abs(ruling).max())


def _meet(rulings: FloatArray, plane: FloatArray) -> FloatArray:
    """Return the homogeneous points (n, 4) where the rulings meet a plane.

    ``rulings`` are tensor products U ⊗ V of two planes, (n, 4, 4); the point common to three planes is their
    alternating product. It is linear in U ⊗ V, so it acts on each Bernstein coefficient.
    """
    p = rulings - rulings.transpose(0, 2, 1)  # Plücker coordinates u_i v_j - u_j v_i
    a, b, c, d = plane

    # The 3 x 3 minors of (U, V, plane), expanded along the plane: det over columns i, j, k.
    def minor(i: int, j: int, k: int) -> FloatArray:
        e = (a, b, c, d)
        return p[:, i, j] * e[k] - p[:, i, k] * e[j] + p[:, j, k] * e[i]

    return np.stack([minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)], axis=-1)
