"""The domain [0, 1]² of every surface, and grids over it."""

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.support.arrays import FloatArray, whole

_FINE = 201  # nodes a side among which points on a face are sought


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


def on_face(surface: Surface, u: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the parameters on a face nearest to u and v (n,), shares of the window of its loops; u and v of others."""
    if not surface.trim:
        return u, v
    low, high = window(surface.trim)
    nodes = np.stack([nodes.ravel() for nodes in np.broadcast_arrays(*face_grid(surface, _FINE, _FINE))])
    nodes = nodes[:, surface.inside(*nodes)]
    if not nodes.size:  # a sliver between the nodes: its vertices are on it
        nodes = np.concatenate(surface.trim).T
    shares = (nodes - low[:, None]) / (high - low)[:, None]
    nearest = [int(np.argmin((shares[0] - a) ** 2 + (shares[1] - b) ** 2)) for a, b in zip(u, v, strict=True)]
    return nodes[0, nearest], nodes[1, nearest]
