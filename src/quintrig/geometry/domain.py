"""The domain [0, 1]² of every surface, and grids over it."""

import numpy as np

from quintrig.support.arrays import FloatArray, whole


def grid(nu: int, nv: int) -> tuple[FloatArray, FloatArray]:
    """Return the open mesh of nu x nv parameters over the domain, shapes (nu, 1) and (1, nv), edges included."""
    return (
        np.linspace(0.0, 1.0, whole(nu, "nu", 2))[:, None],
        np.linspace(0.0, 1.0, whole(nv, "nv", 2))[None, :],
    )
