"""The one surface type: rows Q_j(u), curves in u, blended by scalar functions D_j(v)."""

import math
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike

from quintrig.arrays import BoolArray, FloatArray, locked, parameter, whole
from quintrig.functions import Functions


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
class Net:
    """Rows that share their functions: Q_j(u) = Σ_i f_i(u) P_ij, ``points`` of shape (i, j, 3 or 4), length¹."""

    points: FloatArray
    functions: Functions

    def __post_init__(self) -> None:
        """Keep a copy of points that might change."""
        object.__setattr__(self, "points", locked(self.points))

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


LARGEST_SIZE = 1e30
"""Largest size of a surface: verdicts multiply up to eight lengths, and must not overflow."""

SMALLEST_SIZE = 1.0 / LARGEST_SIZE
"""Smallest size of a surface that is no point: those products must not underflow either."""

_SIZES = f"a surface from {SMALLEST_SIZE:g} to {LARGEST_SIZE:g} across, or a single point"
_REMEDY = "take another unit of length or other numbers"
_ON_LOOP = 1e-9  # parameters this near to a trim loop are on it


@dataclass(frozen=True, eq=False)
class Surface:
    """S(u, v) = Σ_j Q_j(u) D_j(v) over (u, v) in [0, 1]².

    The normal points along S_u x S_v, against it when ``flip``. ``net`` is the control net to draw, shape (n, m, 3),
    where the construction has one. Rows in homogeneous coordinates make a rational surface: the blended point is
    divided by its own w. ``trim`` holds the closed loops (n, 2) of (u, v) that bound a face cut from the surface;
    without any, all of it counts.
    """

    rows: Rows
    blend: Functions
    flip: bool = False
    net: FloatArray | None = None
    trim: tuple[FloatArray, ...] = ()

    def __post_init__(self) -> None:
        """Check once that rows and blend go together, and keep a copy of a net that might change."""
        if self.net is not None:
            object.__setattr__(self, "net", locked(self.net))
        if self.rows.size != self.blend.size:
            raise ValueError(f"blend: expected {self.rows.size} functions, one for each row, found {self.blend.size}")

    def __call__(self, u: ArrayLike, v: ArrayLike) -> FloatArray:
        """Return points, shape (*broadcast of u and v, 3), length¹; ValueError outside [0, 1]."""
        return self.partials(u, v, 0)[0, 0]

    def partials(self, u: ArrayLike, v: ArrayLike, order: int = 2) -> FloatArray:
        """Return all partial derivatives up to ``order`` in each parameter, length¹.

        The result has shape (order + 1, order + 1, *broadcast of u and v, 3); entry [i, j] is ∂^(i+j)S / ∂u^i ∂v^j, so
        [1, 0] is S_u and [1, 1] is S_uv. Raises ValueError for NaN, parameters outside [0, 1] or a negative order.
        """
        order = whole(order, "order", 0)
        u, v = parameter(u, "u"), parameter(v, "v")
        rows, blend = self.rows.derivatives(u, order), self.blend.derivatives(v, order)
        if u.ndim == v.ndim == 2 and u.shape[1] == v.shape[0] == 1:
            blended = np.einsum("pimx,qjm->pqijx", rows[:, :, 0], blend[:, 0], optimize=True)  # a matrix product
        else:
            blended = np.einsum("p...mx,q...m->pq...x", rows, blend)
        return _projected(blended) if self.rational else blended

    def inside(self, u: ArrayLike, v: ArrayLike) -> BoolArray:
        """Return which parameters lie inside the ``trim`` loops, shape of u and v broadcast; all where there are none.

        A point is inside where a line from it crosses the loops an odd number of times, and on a loop itself.
        """
        u, v = np.broadcast_arrays(parameter(u, "u"), parameter(v, "v"))
        if not self.trim:
            return np.ones(u.shape, dtype=np.bool_)
        result: BoolArray = np.zeros(u.shape, dtype=np.bool_)
        border: BoolArray = np.zeros(u.shape, dtype=np.bool_)
        for loop in self.trim:
            for (u0, v0), (u1, v1) in zip(loop, np.roll(loop, -1, axis=0), strict=True):
                du, dv = u1 - u0, v1 - v0
                side = du * (v - v0) - dv * (u - u0)
                result ^= ((v0 > v) != (v1 > v)) & ((side > 0.0) == (dv > 0.0)) & (dv != 0.0)
                along, square = du * (u - u0) + dv * (v - v0), du * du + dv * dv
                border |= (np.abs(side) <= _ON_LOOP * math.sqrt(square)) & (along >= 0.0) & (along <= square)
        return result | border

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> Any:
        """Return the interactive view that a notebook shows; only the text where the extra ``jupyter`` is missing."""
        return import_module("quintrig.studio.notebook").bundle(self)

    @property
    def rational(self) -> bool:
        """Whether the rows are homogeneous, so that points are quotients."""
        return self.rows.dimension == 4

    @property
    def sign(self) -> float:
        """+1 when the normal points along S_u x S_v, -1 when flipped."""
        return -1.0 if self.flip else 1.0

    @cached_property
    def size(self) -> float:
        """Diagonal of the bounding box of 17 x 17 points of the surface, length¹: the scale of all thresholds.

        Points that lie as good as at infinity, as where a ruling of a strip runs along a bounding plane, are left out.
        Raises ValueError where it is not in the range in which products of many lengths neither over- nor underflow.
        """
        t = np.linspace(0.0, 1.0, 17)
        with np.errstate(over="ignore", invalid="ignore"):  # what that leaves is refused below
            points = self(t[:, None], t[None, :]).reshape(-1, 3)
        finite = np.isfinite(points).all(axis=-1)
        if isinstance(self.rows, Net) and not finite.all():
            raise ValueError(f"size: expected {_SIZES}, found points that are not finite; {_REMEDY}")
        points = points[finite]
        if not len(points):
            return 0.0
        if not isinstance(self.rows, Net):
            away = np.abs(points - _middle(points)).max(axis=-1)
            points = points[away <= (1e6 * _middle(away) or np.inf)]
        diagonal = math.hypot(*(points.max(axis=0) - points.min(axis=0)).tolist())
        if diagonal > LARGEST_SIZE or 0.0 < diagonal < SMALLEST_SIZE:
            raise ValueError(f"size: expected {_SIZES}, found {diagonal:.3g}; {_REMEDY}")
        # What is left of a single point after rounding is no size.
        return diagonal if diagonal > 32 * np.finfo(np.float64).eps * np.abs(points).max() else 0.0


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
