"""How the derivatives of a patch depend on its free coordinates: they are affine in them, at every point."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import Functions
from quintrig.geometry.surface import Net
from quintrig.model.patch import Patch
from quintrig.multipatch.nets import Handle, handle, net_of
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError

FIRST_AND_SECOND = ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
"""The derivatives that curvature takes, S_u, S_v, S_uu, S_uv, S_vv, as (times by u, times by v)."""


@dataclass(frozen=True, eq=False)
class Affine:
    """A patch whose net (n, m, 3) is affine in free coordinates (p,), with the functions that the net is blended by."""

    patch: Patch
    handle: Handle
    matrix: FloatArray
    """(n, m, 3, p): the net's coordinates by the free ones."""

    along_u: Functions
    along_v: Functions

    @property
    def values(self) -> FloatArray:
        """The free coordinates as the patch has them, (p,), length¹."""
        return self.handle.values

    def functions(self, axis: int, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` of the functions in u (``axis`` 0) or v (1), (order + 1, *t.shape, n)."""
        return (self.along_v if axis else self.along_u).derivatives(t, order)

    def breaks(self, axis: int) -> FloatArray:
        """Return the parameters between which the functions are analytic."""
        return self.patch.surface.breaks(axis)

    def net(self, x: FloatArray) -> FloatArray:
        """Return the net (n, m, 3) of free coordinates, length¹."""
        return self.handle.net(x)

    def rebuilt(self, x: FloatArray) -> Patch:
        """Return the patch with these free coordinates."""
        return self.patch.rebuilt(**self.handle.keys(x))


def affine(patch: Patch) -> Affine:
    """Return what of a patch may move; ModelError for a kind whose control points are no coordinates of a net."""
    found, rows = handle(patch), patch.surface.rows
    if found is None or not isinstance(rows, Net) or patch.surface.rational:
        raise ModelError(
            f'patch "{patch.name}": the net of a {patch.kind} is not free to move; '
            + ("make it a tensor-product patch" if net_of(patch) is not None else "vary its shape parameters alone")
        )
    matrix = found.map().reshape(*found.net(found.values).shape, len(found.values))
    return Affine(patch, found, matrix, rows.functions, patch.surface.blend)


def at_grid(net: FloatArray, fu: FloatArray, fv: FloatArray) -> FloatArray:
    """Return the five derivatives (5, nu, nv, 3) of a net (n, m, 3) at a grid, from derivatives of its functions."""
    n, m, _ = net.shape
    rows = (fu.reshape(-1, n) @ net.reshape(n, -1)).reshape(*fu.shape[:2], m, 3)
    return np.stack([fv[b] @ rows[a] for a, b in FIRST_AND_SECOND])


def by_net(fu: FloatArray, fv: FloatArray, gradient: FloatArray) -> FloatArray:
    """Return the gradient (n, m, 3) by the net, from one by the five derivatives at a grid (5, nu, nv, 3)."""
    total = np.zeros((fu.shape[-1], fv.shape[-1], 3))
    for (a, b), part in zip(FIRST_AND_SECOND, gradient, strict=True):
        rows = fv[b].T @ part
        total += (fu[a].T @ rows.reshape(len(rows), -1)).reshape(total.shape)
    return total
