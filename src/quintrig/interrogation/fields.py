"""The scalars whose level sets are lines on a surface."""

from collections.abc import Callable
from typing import Any, cast

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.geometry.surface import Surface
from quintrig.interrogation.levels import Parts, Scalar
from quintrig.interrogation.local import Local, dot
from quintrig.support.arrays import FloatArray

_ONE = 1.0


def quantity_scalar(surface: Surface, key: str) -> Scalar:
    """Return a scalar quantity of the table."""

    def parts(u: FloatArray, v: FloatArray) -> Parts:
        return analyse(surface, u, v, (key,), threads=1)[key], _ONE, None

    return parts


def normal_scalar(surface: Surface, direction: FloatArray) -> Scalar:
    """Return n · d of the unit normal with a unit vector (3,): isophotes, silhouettes from afar, draft angles."""

    def parts(u: FloatArray, v: FloatArray) -> Parts:
        return dot(analyse(surface, u, v, ("normal",), threads=1).normal, direction), _ONE, None

    return parts


def facing_scalar(surface: Surface, eye: FloatArray) -> Scalar:
    """Return n · (eye - S) / |eye - S|: the silhouette as seen from a point (3,)."""

    def parts(u: FloatArray, v: FloatArray) -> Parts:
        sample = analyse(surface, u, v, ("point", "normal"), threads=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            ray = eye - sample.point
            return dot(sample.normal, ray) / np.linalg.norm(ray, axis=-1), _ONE, None

    return parts


def plane_scalar(surface: Surface, normal: FloatArray) -> Scalar:
    """Return n · S (length¹) with the unit normal (3,) of planes."""

    def parts(u: FloatArray, v: FloatArray) -> Parts:
        return dot(surface(u, v), normal), _ONE, None

    return parts


def lights_scalar(
    surface: Surface,
    light: FloatArray,
    along: FloatArray,
    across: FloatArray,
    eye: Callable[[FloatArray], FloatArray] | None,
) -> Scalar:
    """Return f and g of parallel lights: f = level g where the ray meets the light moved by ``level`` sideways.

    The lights run along the unit vector ``along`` through ``light`` (3,), and are moved along ``across``. The ray is
    the normal (highlight lines; Beier and Chen 1994, eq. 3), or with an ``eye``, which gives unit vectors from points
    towards it, what is reflected (reflection lines; Klass 1980).
    """

    def parts(u: FloatArray, v: FloatArray) -> Parts:
        sample = analyse(surface, u, v, ("point", "normal"), threads=1)
        ray = sample.normal
        if eye is not None:
            view = eye(sample.point)
            ray = 2.0 * dot(ray, view)[..., None] * ray - view
        plane = np.cross(along, ray)
        return dot(plane, sample.point - light), dot(plane, across), None

    return parts


def sideways(centre: FloatArray, extent: float, light: FloatArray, along: FloatArray) -> FloatArray:
    """Return the unit vector (3,) in which lights are moved: across them, and across the way to the model's centre."""
    across: FloatArray = np.asarray(np.cross(along, centre - light))
    size = float(np.linalg.norm(across))
    if not size > 1e-12 * (extent + float(np.linalg.norm(light))):
        across = np.cross(along, np.asarray(np.eye(3)[int(np.abs(along).argmin())], dtype=np.float64))
        size = float(np.linalg.norm(across))
    return np.asarray(across / size, dtype=np.float64)


def ridge_scalar(surface: Surface, family: int) -> Scalar:
    """Return the change of κ1 or κ2 along its own direction (1/length²), which is the axis."""

    def parts(u: FloatArray, v: FloatArray) -> Parts:
        with np.errstate(divide="ignore", invalid="ignore"):
            local = Local.at(surface, u, v, 3)
            angle = local.angle + (0.5 * np.pi if family == 2 else 0.0)
            return local.change(angle), _ONE, local.lifted(local.along(angle))

    return parts


def other_scalar(surface: Surface, other: Surface) -> Scalar:
    """Return the distance (length¹) to another surface, with a sign by its side; NaN where its foot is on an edge."""
    near = Feet(other)

    def parts(u: FloatArray, v: FloatArray) -> Parts:
        points = surface(u, v)
        flat = points.reshape(-1, 3)
        feet = near(flat)
        with np.errstate(divide="ignore", invalid="ignore"):
            local = Local.at(other, *feet.T, order=1)
            gap = flat - local.point
            up = dot(gap, local.up)
        aside = np.linalg.norm(gap - up[:, None] * local.up, axis=1)
        rim = (((feet == 0.0) | (feet == 1.0)) & ~near.closed).any(axis=1)
        beyond = rim & (aside > 1e-9 * other.size)
        values = np.where(beyond | ~other.inside(*feet.T), np.nan, up)
        return values.reshape(points.shape[:-1]), _ONE, None

    return parts


class Feet:
    """The nearest points of a surface: from the nearest of a grid, by Gauss and Newton, across its own seams too."""

    def __init__(self, surface: Surface, density: int = 65) -> None:
        """Sort the grid."""
        from scipy import spatial

        self.surface = surface
        t = np.linspace(0.0, 1.0, density)
        cloud = surface(t[:, None], t[None, :])
        rims = (cloud[0] - cloud[-1], cloud[:, 0] - cloud[:, -1])
        self.closed = np.array([np.abs(rim).max() <= 1e-9 * surface.size for rim in rims])
        self._grid = np.stack(np.meshgrid(t, t, indexing="ij"), axis=-1).reshape(-1, 2)
        self._tree: Any = cast(Any, spatial).KDTree(cloud.reshape(-1, 3))

    def __call__(self, points: FloatArray) -> FloatArray:
        """Return parameters (n, 2) of the feet of points (n, 3)."""
        at = self._grid[np.asarray(self._tree.query(points)[1], dtype=np.intp)]
        for _ in range(30):
            with np.errstate(divide="ignore", invalid="ignore"):
                local = Local.at(self.surface, *at.T, order=1)
                step = np.nan_to_num(local.lowered(points - local.point))
            moved = at + step
            moved = np.where(self.closed & ((moved < 0.0) | (moved > 1.0)), moved % 1.0, np.clip(moved, 0.0, 1.0))
            if np.abs(step).max(initial=0.0) <= 1e-14:
                return moved
            at = moved
        return at


def normal_curvature(surface: Surface, uv: FloatArray) -> FloatArray:
    """Return the normal curvature along a polyline of parameters (n, 2), (n,), 1/length."""
    step = np.gradient(uv, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        local = Local.at(surface, *uv.T)
        (e, f, g), (ll, m, n) = local.first, local.second
        du, dv = step.T
        return (ll * du * du + 2.0 * m * du * dv + n * dv * dv) / (e * du * du + 2.0 * f * du * dv + g * dv * dv)
