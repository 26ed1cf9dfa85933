"""The one surface type: rows Q_j(u), curves in u, blended by scalar functions D_j(v)."""

import math
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import Functions
from quintrig.geometry.trimmed import Inside
from quintrig.support.arrays import BoolArray, FloatArray, locked, parameter, whole
from quintrig.support.display import Shown
from quintrig.support.handed import Handed
from quintrig.support.pickled import Pickled


class Rows(Protocol):
    """The curves Q_j(u), j = 0, ..., size - 1, of a surface."""

    @property
    def size(self) -> int:
        """Number of rows."""
        ...

    @property
    def dimension(self) -> int:
        """3 for points, 4 for homogeneous coordinates (w x, w y, w z, w)."""
        ...

    def derivatives(self, u: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by u, shape (order + 1, *u.shape, size, dimension), length¹."""
        ...


@dataclass(frozen=True, eq=False)
class Net(Pickled):
    """Rows that share their functions: Q_j(u) = Σ_i f_i(u) P_ij, ``points`` of shape (i, j, 3 or 4), length¹.

    ``steps`` holds the increments of the points both ways, as ``Functions.split`` gives them, where the construction
    knows them better than differences of rounded points do.
    """

    points: FloatArray
    functions: Functions
    steps: FloatArray | None = None

    def __post_init__(self) -> None:
        """Keep a copy of points that might change."""
        object.__setattr__(self, "points", locked(self.points))

    def __repr__(self) -> str:
        """Return one line: points and functions."""
        count, rows, dimension = self.points.shape
        kind = "homogeneous points" if dimension == 4 else "points"
        return f"<Net of {count} x {rows} {kind}: {_called(self.functions)}>"

    @property
    def size(self) -> int:
        """Number of rows."""
        return self.points.shape[1]

    @property
    def dimension(self) -> int:
        """3 for points, 4 for homogeneous coordinates."""
        return self.points.shape[2]

    def derivatives(self, u: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by u, shape (order + 1, *u.shape, size, 3 or 4), length¹."""
        f = self.functions.derivatives(u, order)
        return (f @ self.points.reshape(len(self.points), -1)).reshape(*f.shape[:-1], *self.points.shape[1:])

    def increments(self, blend: Functions) -> FloatArray:
        """Return origin and increments of the points both ways, (1 + terms, 1 + terms of ``blend``, 3), length¹."""
        if self.steps is not None:
            return self.steps
        by_rows = self.functions.split(self.points).transpose(1, 0, 2)
        return blend.split(by_rows).transpose(1, 0, 2)


LARGEST_SIZE = 1e30
"""Largest size of a surface: verdicts multiply up to eight lengths, and must not overflow."""

SMALLEST_SIZE = 1.0 / LARGEST_SIZE
"""Smallest size of a surface that is no point: those products must not underflow either."""

STEPS_FOR_SIZE = 17
"""Parameters each way at which the size of a surface is taken."""

FAR_OFF = 1e6
"""Of the middle distance: points farther from the middle point lie as good as at infinity."""

SAME_POINT = 32 * np.finfo(np.float64).eps
"""Of the largest coordinate: what is left of a single point after rounding is no size."""

_SIZES = f"a surface from {SMALLEST_SIZE:g} to {LARGEST_SIZE:g} across, or a single point"
_REMEDY = "take another unit of length or other numbers"


@dataclass(frozen=True, eq=False)
class Surface(Pickled, Handed, Shown):
    """S(u, v) = Σ_j Q_j(u) D_j(v) over (u, v) in [0, 1]².

    The normal points along S_u x S_v, against it when ``flip``. ``net`` is the control net to draw, shape (n, m, 3),
    where the construction has one. Rows in homogeneous coordinates make a rational surface: the blended point is
    divided by its own w. ``trim`` holds the closed loops (n, 2) of (u, v) that bound a face cut from the surface;
    without any, all of it counts. Rows hold points as seen from ``origin`` (3,), length¹.
    """

    rows: Rows
    blend: Functions
    flip: bool = False
    net: FloatArray | None = None
    trim: tuple[FloatArray, ...] = ()
    origin: FloatArray = field(default_factory=lambda: np.zeros(3))

    def __post_init__(self) -> None:
        """Check once that rows and blend go together, and keep a copy of arrays that might change."""
        object.__setattr__(self, "origin", locked(self.origin))
        if self.net is not None:
            object.__setattr__(self, "net", locked(self.net))
        if self.rows.size != self.blend.size:
            raise ValueError(f"blend: expected {self.rows.size} functions, one for each row, found {self.blend.size}")

    def __repr__(self) -> str:
        """Return one line: rows, blend, and what is special about it."""
        special = [word for word, so in (("rational", self.rational), ("flipped", self.flip)) if so]
        special += [f"trimmed by {len(self.trim)} loops"] if self.trim else []
        families = f"{_called(getattr(self.rows, 'functions', self.rows))} by {_called(self.blend)}"
        return f"<Surface of {self.rows.size} rows: {', '.join([families, *special])}>"

    def __call__(self, u: ArrayLike, v: ArrayLike) -> FloatArray:
        """Return points, shape (*broadcast of u and v, 3), length¹; ValueError outside [0, 1]."""
        return self.partials(u, v, 0)[0, 0]

    def partials(self, u: ArrayLike, v: ArrayLike, order: int = 2) -> FloatArray:
        """Return all partial derivatives up to ``order`` in each parameter, length¹.

        The result has shape (order + 1, order + 1, *broadcast of u and v, 3); entry [i, j] is ∂^(i+j)S / ∂u^i ∂v^j, so
        [1, 0] is S_u and [1, 1] is S_uv. Raises ValueError for NaN, parameters outside [0, 1] or a negative order.
        """
        result = self.local_partials(u, v, order)
        result[0, 0] += self.origin
        return result

    def local_partials(self, u: ArrayLike, v: ArrayLike, order: int = 2) -> FloatArray:
        """Return the same as ``partials``, but points as seen from ``origin``."""
        order = whole(order, "order", 0)
        u, v = parameter(u, "u"), parameter(v, "v")
        if self.rational:
            return _projected(_blended(self.rows.derivatives(u, order), self.blend.derivatives(v, order)))
        point = _blended(self.rows.derivatives(u, 0), self.blend.derivatives(v, 0))
        if not order:
            return point
        # Derivatives see differences of neighbours only. (Points do not: edges meet those of neighbours exactly.)
        result = _blended(self._increments(u, order), _with_one(self.blend.increments(v, order)))
        result[0, 0] = point[0, 0]
        return result

    def _increments(self, u: FloatArray, order: int) -> FloatArray:
        """Return derivatives of origin and row increments, (order + 1, *u.shape, 1 + terms, 3), length¹."""
        if not isinstance(self.rows, Net):
            rows = np.moveaxis(self.rows.derivatives(u, order), -2, 0)
            return np.moveaxis(self.blend.split(rows), 0, -2)
        net, functions = self.rows.increments(self.blend), _with_one(self.rows.functions.increments(u, order))
        return (functions @ net.reshape(len(net), -1)).reshape(*functions.shape[:-1], *net.shape[1:])

    def inside(self, u: ArrayLike, v: ArrayLike) -> BoolArray:
        """Return which parameters lie inside the ``trim`` loops, shape of u and v broadcast; all where there are none.

        A point is inside where a line from it crosses the loops an odd number of times, and on a loop itself.
        """
        u, v = np.broadcast_arrays(parameter(u, "u"), parameter(v, "v"))
        if not self.trim:
            return np.ones(u.shape, dtype=np.bool_)
        return self._loops(u.ravel(), v.ravel()).reshape(u.shape)

    @cached_property
    def _loops(self) -> Inside:
        return Inside(self.trim)

    def breaks(self, axis: int) -> FloatArray:
        """Return the parameters from 0 to 1 in u (``axis`` 0) or v (1) between two of which the surface is smooth."""
        functions = self.blend if axis else getattr(self.rows, "functions", None)  # only a net's rows share some
        return np.array([0.0, 1.0]) if functions is None else functions.breaks

    @property
    def carrier(self) -> "Surface":
        """The whole surface that a trimmed face is cut from."""
        return replace(self, trim=()) if self.trim else self

    @property
    def rational(self) -> bool:
        """Whether the rows are homogeneous, so that points are quotients."""
        return self.rows.dimension == 4

    @property
    def sign(self) -> float:
        """+1 when the normal points along S_u x S_v, -1 when flipped."""
        return -1.0 if self.flip else 1.0

    @property
    def caveats(self) -> tuple[str, ...]:
        """What a reader must be warned of, of the functions that it is built on: one sentence each."""
        families = [self.rows.functions, self.blend] if isinstance(self.rows, Net) else [self.blend]
        return tuple(dict.fromkeys(line for one in families for line in one.caveats))

    @cached_property
    def size(self) -> float:
        """Diagonal of the bounding box of 17 x 17 points of the surface, length¹: the scale of all thresholds.

        Points that lie as good as at infinity, as where a ruling of a strip runs along a bounding plane, are left out.
        Raises ValueError where it is not in the range in which products of many lengths neither over- nor underflow.
        """
        t = np.linspace(0.0, 1.0, STEPS_FOR_SIZE)
        with np.errstate(over="ignore", invalid="ignore"):  # what that leaves is refused below
            points = self.local_partials(t[:, None], t[None, :], 0)[0, 0].reshape(-1, 3)
        finite = np.isfinite(points).all(axis=-1)
        if isinstance(self.rows, Net) and not finite.all():
            raise ValueError(f"size: expected {_SIZES}, found points that are not finite; {_REMEDY}")
        points = points[finite]
        if not len(points):
            return 0.0
        if not isinstance(self.rows, Net):
            away = np.abs(points - _middle(points)).max(axis=-1)
            points = points[away <= (FAR_OFF * _middle(away) or np.inf)]
        diagonal = math.hypot(*(points.max(axis=0) - points.min(axis=0)).tolist())
        if diagonal > LARGEST_SIZE or 0.0 < diagonal < SMALLEST_SIZE:
            raise ValueError(f"size: expected {_SIZES}, found {diagonal:.3g}; {_REMEDY}")
        reach = np.abs(points + self.origin).max()
        return diagonal if diagonal > SAME_POINT * reach else 0.0


def _with_one(functions: FloatArray) -> FloatArray:
    """Return derivatives (order + 1, ..., n) of functions with those of 1 before them: that is the origin's."""
    one = np.zeros((*functions.shape[:-1], 1))
    one[0] = 1.0
    return np.concatenate([one, functions], axis=-1)


def _blended(rows: FloatArray, blend: FloatArray) -> FloatArray:
    """Return Σ_m of row (p, *u.shape, m, x) times blend derivatives (q, *v.shape, m), (p, q, *broadcast, x)."""
    if rows.ndim == 5 and blend.ndim == 4 and rows.shape[2] == blend.shape[1] == 1:
        # Small matrix products, one for each u: in one large one the library's threads take ten times as long to meet.
        return blend[None, :, None, 0] @ rows[:, None, :, 0]
    return np.einsum("p...mx,q...m->pq...x", rows, blend)


def _called(functions: object) -> str:
    parts: tuple[object, ...] = getattr(functions, "parts", (functions,))
    return " + ".join(str(getattr(part, "name", type(part).__name__)) for part in parts)


def _middle(values: FloatArray) -> FloatArray:
    """Return the upper median along the first axis."""
    middle = len(values) // 2
    return np.partition(values, middle, axis=0)[middle]


def _projected(blended: FloatArray) -> FloatArray:
    """Divide homogeneous partials (p, q, ..., 4) by their last coordinate, by Leibniz's rule for w S."""
    numerator, weight = blended[..., :3], blended[..., 3:]
    result: FloatArray = np.empty_like(numerator)
    for i, j in np.ndindex(blended.shape[:2]):
        rest = numerator[i, j].copy()
        for a, b in np.ndindex(i + 1, j + 1):
            if (a, b) != (i, j):
                rest -= math.comb(i, a) * math.comb(j, b) * weight[i - a, j - b] * result[a, b]
        result[i, j] = rest / weight[0, 0]
    return result
