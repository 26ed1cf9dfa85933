"""The domain [0, 1]² of every surface, and grids over it."""

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.support.arrays import FloatArray, whole


def grid(nu: int, nv: int) -> tuple[FloatArray, FloatArray]:
    """Return the open mesh of nu x nv parameters over the domain, shapes (nu, 1) and (1, nv), edges included."""
    return (
        np.linspace(0.0, 1.0, whole(nu, "nu", 2))[:, None],
        np.linspace(0.0, 1.0, whole(nv, "nv", 2))[None, :],
    )


def face_grid(surface: Surface, nu: int, nv: int) -> tuple[FloatArray, FloatArray]:
    """Return ``grid`` over the parameters between the least and the greatest of a face's trim loops."""
    (u0, v0), (u1, v1) = window(surface.trim)
    u, v = grid(nu, nv)
    return u0 + (u1 - u0) * u, v0 + (v1 - v0) * v
