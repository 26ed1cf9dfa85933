"""The camera: an orthographic (parallel) projection, so lengths and angles in the plane of the picture are true."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.errors import ArgumentError
from quintrig.support.numerals import real


@dataclass(frozen=True)
class View:
    """A direction to look from, in degrees: ``azimuth`` about z from the x axis, ``elevation`` above the xy plane."""

    name: str
    azimuth: float
    elevation: float

    @property
    def axes(self) -> FloatArray:
        """Rows: the unit vectors to the right, upwards, and towards the camera, shape (3, 3)."""
        a, e = np.deg2rad(self.azimuth), np.deg2rad(self.elevation)
        right = [-np.sin(a), np.cos(a), 0.0]
        up = [-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)]
        towards = [np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)]
        axes = np.array([right, up, towards])
        axes[np.abs(axes) < 1e-12] = 0.0  # exact along the axes
        return axes

    def project(self, points: FloatArray) -> FloatArray:
        """Return (right, up, depth towards the camera) of points (..., 3), length¹."""
        return points @ self.axes.T


ISO = View("oblique view", -55.0, 26.0)
"""From the front right, above: x runs right, y away, z up."""

SIDE = View("side view, along +y", -90.0, 0.0)
"""Looking along +y: x to the right, z up."""

BACK = View("back view, along −x", 0.0, 0.0)
"""Looking along -x, from the far end of the x axis: y to the right, z up."""

TOP = View("top view, along −z", -90.0, 90.0)
"""Looking down along -z: x to the right, y up."""

ViewName = str | tuple[float, float]
"""A view by its name, or as azimuth and elevation in degrees."""

VIEWS: dict[str, View] = {"iso": ISO, "side": SIDE, "back": BACK, "top": TOP}
"""The standard views by name."""


def read_view(view: ViewName | View, others: Sequence[str] = ()) -> View:
    """Return a view by its name or as azimuth and elevation in degrees, a pair or text; ValueError for others.

    ``others`` are names of more than a view, which are seen obliquely.
    """
    if isinstance(view, View):
        return view
    if view in others:
        return ISO
    if isinstance(view, str) and view in VIEWS:
        return VIEWS[view]
    try:
        azimuth, elevation = map(real, view.split(",")) if isinstance(view, str) else view
    except (TypeError, ValueError):
        names = ", ".join([*VIEWS, *others])
        raise ArgumentError(
            f"expected {names} or AZIMUTH,ELEVATION in degrees, got {str(view)[:40]!r}", "view"
        ) from None
    if not (-360.0 <= azimuth <= 360.0 and -90.0 <= elevation <= 90.0):
        found = f"{azimuth:g},{elevation:g}"
        raise ArgumentError(f"expected an azimuth within ±360 and an elevation within ±90 degrees, got {found}", "view")
    return View(f"view from azimuth {azimuth:g}°, elevation {elevation:g}°", azimuth, elevation)


def hidden(points: FloatArray, mesh: list[FloatArray], bias: float) -> BoolArray:
    """Return which projected points (n, 3) lie more than ``bias`` behind a projected mesh of quads, each (k, l, 3)."""
    covered: BoolArray = np.zeros(len(points), dtype=np.bool_)
    for grid in mesh:
        a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
        for triangle in ((a, b, c), (a, c, d)):
            p, q, r = (corner.reshape(-1, 3) for corner in triangle)
            covered |= np.array([_covered(point, p, q, r, bias) for point in points], dtype=np.bool_)
    return covered


def _covered(point: FloatArray, p: FloatArray, q: FloatArray, r: FloatArray, bias: float) -> bool:
    first, second, to = q - p, r - p, point - p
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    area = np.where(area == 0.0, np.nan, area)  # seen edge-on
    s = (to[:, 0] * second[:, 1] - to[:, 1] * second[:, 0]) / area
    t = (first[:, 0] * to[:, 1] - first[:, 1] * to[:, 0]) / area
    depth = p[:, 2] + s * first[:, 2] + t * second[:, 2]
    return bool(np.any((s >= 0.0) & (t >= 0.0) & (s + t <= 1.0) & (depth > point[2] + bias)))
