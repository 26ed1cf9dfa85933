"""The convex-hull property, checked: how far points of a curve or surface leave the convex hull of its control points.

The distance of a point from the hull of P_1, ..., P_n is found as a non-negative least-squares problem: minimise |Σ μ_i
(P_i - x)|² + (Σ μ_i - 1)² over μ >= 0. With μ = s λ, Σ λ_i = 1, the best s leaves |d|² / (1 + |d|²), d = Σ λ_i P_i - x,
so the minimum belongs to the nearest point of the hull. Flat, collinear or coincident control points need no special
treatment.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from quintrig.geometry.curve import Curve
from quintrig.geometry.domain import grid
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray, frozen
from quintrig.support.tolerance import NOISE

ROUNDING = NOISE
"""A point this share of the control points' extent outside the hull, or less, counts as inside."""


@dataclass(frozen=True)
class HullCheck:
    """The largest distance by which samples leave the hull, length¹, and the parameters where: (t,) or (u, v).

    0 and no parameters where all are inside, to rounding. ``outside`` of the ``samples`` are outside.
    """

    distance: float
    at: tuple[float, ...]
    outside: int
    samples: int

    @property
    def inside(self) -> bool:
        """True where no sample leaves the hull."""
        return self.outside == 0


def hull_distances(points: ArrayLike, control: ArrayLike) -> FloatArray:
    """Return the distances of ``points`` (..., d) from the convex hull of ``control`` (n, d), shape (...), length¹.

    0 inside, to rounding. Raises ValueError for wrong shapes, NaN or infinity, or no control points.
    """
    hull = frozen(control, "control", (None, None))
    if not len(hull):
        raise ValueError("control: expected 1 or more control points, found none")
    places: FloatArray = np.asarray(points, dtype=np.float64)
    if places.shape[-1:] != hull.shape[1:]:
        raise ValueError(f"points: expected {hull.shape[1]} coordinates each, found an array of shape {places.shape}")
    if not np.isfinite(places).all():
        raise ValueError("points: expected finite numbers, found NaN or infinity")
    centre = hull.mean(axis=0)
    # To unit size: the weights then do not depend on the unit of length.
    extent = float(np.abs(hull - centre).max())
    scale = extent if extent > 0.0 else 1.0
    corners = ((hull - centre) / scale).T
    flat = ((places - centre) / scale).reshape(-1, hull.shape[1])
    distances = np.array([_distance(corners, x) for x in flat]).reshape(places.shape[:-1])
    return scale * np.where(distances <= ROUNDING, 0.0, distances)


def check_curve_hull(curve: Curve, samples: int = 257) -> HullCheck:
    """Check a curve against the hull of its control points at equal steps of t; ValueError for fewer than 2 samples."""
    if samples < 2:
        raise ValueError(f"samples: expected 2 or more, found {samples}")
    t = np.linspace(0.0, 1.0, samples)
    return _check(hull_distances(curve(t), curve.points), (t,))


def check_hull(surface: Surface, nu: int = 33, nv: int = 33) -> HullCheck:
    """Check a surface against the hull of its net at nu x nv points; ValueError for a surface without a net."""
    if surface.net is None:
        raise ValueError("hull: the surface has no control net, so there is no hull to check it against")
    u, v = grid(nu, nv)
    return _check(hull_distances(surface(u, v), surface.net.reshape(-1, 3)), (u[:, 0], v[0]))


def _check(distances: FloatArray, parameters: tuple[FloatArray, ...]) -> HullCheck:
    largest = float(distances.max())
    place = np.unravel_index(int(distances.argmax()), distances.shape)
    at = tuple(float(t[i]) for t, i in zip(parameters, place, strict=True)) if largest > 0.0 else ()
    return HullCheck(largest, at, int((distances > 0.0).sum()), distances.size)


def _distance(corners: FloatArray, x: FloatArray) -> float:
    """Return the distance of x (d,) from the hull of the columns of ``corners`` (d, n), all of size about 1."""
    from scipy.optimize import nnls  # pyright: ignore[reportUnknownVariableType]  # takes long to import

    # The scale of d is free in the formula above: this one keeps the system well conditioned far away.
    scale = max(1.0, float(np.abs(x).max()))
    system = np.vstack([(corners - x[:, None]) / scale, np.ones(corners.shape[1])])
    weights = np.asarray(nnls(system, np.append(np.zeros(len(x)), 1.0))[0], dtype=np.float64)
    return scale * float(np.linalg.norm(system[:-1] @ (weights / weights.sum())))
