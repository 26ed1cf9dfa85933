"""The one surface type: rows Q_j(u), curves in u, blended by scalar functions D_j(v)."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from quintrig import taylor
from quintrig.arrays import FloatArray, parameter
from quintrig.functions import Functions


class Rows(Protocol):
    """The curves Q_j(u), j = 0, ..., size - 1, of a surface."""

    @property
    def size(self) -> int:
        """Number of rows."""
        ...

    def derivatives(self, u: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by u, shape (order + 1, *u.shape, size, 3), length¹."""
        ...


@dataclass(frozen=True, eq=False)
class Net:
    """Rows that share their functions: Q_j(u) = Σ_i f_i(u) P_ij, ``points`` of shape (i, j, 3), length¹."""

    points: FloatArray
    functions: Functions

    @property
    def size(self) -> int:
        """Number of rows."""
        return self.points.shape[1]

    def derivatives(self, u: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by u, shape (order + 1, *u.shape, size, 3 or 4), length¹."""
        f = self.functions.derivatives(u, order)
        return (f @ self.points.reshape(len(self.points), -1)).reshape(*f.shape[:-1], *self.points.shape[1:])


@dataclass(frozen=True)
class Projected:
    """Rows given in homogeneous coordinates (x, y, z, w), each divided by its own w by the quotient rule."""

    homogeneous: Net

    @property
    def size(self) -> int:
        """Number of rows."""
        return self.homogeneous.size

    def derivatives(self, u: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by u, shape (order + 1, *u.shape, size, 3), length¹."""
        series = taylor.coefficients(self.homogeneous.derivatives(u, order))
        return taylor.derivatives(taylor.quotient(series[..., :3], series[..., 3:]))


@dataclass(frozen=True, eq=False)
class Surface:
    """S(u, v) = Σ_j Q_j(u) D_j(v) over (u, v) in [0, 1]².

    The normal points along S_u x S_v, against it when ``flip``. ``net`` is the control net to draw, shape (n, m, 3),
    where the construction has one.
    """

    rows: Rows
    blend: Functions
    flip: bool = False
    net: FloatArray | None = None

    def __post_init__(self) -> None:
        """Check once that rows and blend go together."""
        if self.rows.size != self.blend.size:
            raise ValueError(f"blend: expected {self.rows.size} functions, one for each row, found {self.blend.size}")

    def __call__(self, u: ArrayLike, v: ArrayLike) -> FloatArray:
        """Return points, shape (*broadcast of u and v, 3), length¹; ValueError outside [0, 1]."""
        return self.partials(u, v, 0)[0, 0]

    def partials(self, u: ArrayLike, v: ArrayLike, order: int = 2) -> FloatArray:
        """Return all partial derivatives up to ``order`` in each parameter, length¹.

        The result has shape (order + 1, order + 1, *broadcast of u and v, 3); entry [i, j] is ∂^(i+j)S / ∂u^i ∂v^j, so
        [1, 0] is S_u and [1, 1] is S_uv. Raises ValueError for NaN or parameters outside [0, 1].
        """
        rows = self.rows.derivatives(parameter(u, "u"), order)
        blend = self.blend.derivatives(parameter(v, "v"), order)
        return np.einsum("p...mx,q...m->pq...x", rows, blend)

    @property
    def sign(self) -> float:
        """+1 when the normal points along S_u x S_v, -1 when flipped."""
        return -1.0 if self.flip else 1.0

    @property
    def size(self) -> float:
        """Diagonal of the bounding box of 17 x 17 points of the surface, length¹: the scale of all thresholds."""
        t = np.linspace(0.0, 1.0, 17)
        points = self(t[:, None], t[None, :])
        return float(np.linalg.norm(np.ptp(points, axis=(0, 1))))
