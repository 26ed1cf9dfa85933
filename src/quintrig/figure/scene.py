"""What a picture in space shows: the view, what is drawn beside the surface, and the box that frames it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from quintrig.figure.camera import ISO, View
from quintrig.figure.palette import INK
from quintrig.figure.style import STANDARD, Style
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.errors import ArgumentError
from quintrig.support.tolerance import NOISE

MOST_SURFACES = 5000
"""Surfaces of one picture."""

_BESIDE = 84  # facets a side in each of several pictures
_FACETS = 400_000  # in all: more than the dots of a picture

Box = tuple[FloatArray, FloatArray]
"""Lower and upper corner (3,) of what is framed, length¹."""


@dataclass(frozen=True)
class Mark:
    """A labelled point at parameters u and v."""

    u: float
    v: float
    label: str = ""


@dataclass(frozen=True, eq=False)
class Trace:
    """A curve in space, (n, 3), drawn with the surface; ``polygon`` marks its points as control points."""

    points: FloatArray
    label: str = ""
    colour: str = INK
    width: float = 1.6
    dashed: bool = False
    polygon: bool = False


@dataclass(frozen=True)
class Scene:
    """What to draw beside the surface, and from where.

    ``cells`` is the number of facets a side (with 120 no facet's middle is at a simple fraction, where a symmetric
    surface may have zeros), ``isolines`` the number of parameter lines inside, each way. ``zeros`` draws where the
    quantity shown changes its sign, ``normal`` an arrow, ``regression`` the edge of regression where it lies inside,
    ``rims`` the edges of the patches.
    """

    view: View = ISO
    net: bool = False
    isolines: int = 0
    marks: tuple[Mark, ...] = ()
    traces: tuple[Trace, ...] = ()
    zeros: bool = True
    normal: bool = False
    regression: bool = True
    rims: bool = True
    frame: bool = True
    cells: int = 120


def thinned(scene: Scene, count: int) -> Scene:
    """Return a scene with fewer facets and lines on each of many surfaces, which are small in the picture.

    Raises ValueError for so many that each is hardly a dot.
    """
    if count > MOST_SURFACES:
        raise ArgumentError(
            f"{count:,} surfaces are more than the {MOST_SURFACES:,} that a picture shows",
            "subject",
            remedy="choose one by its name, or export a mesh of all",
            key="surfaces",
        )
    cells = _side(count, scene.cells)
    if cells == scene.cells:
        return scene
    return replace(scene, cells=cells, isolines=min(scene.isolines, cells // 16), normal=False)


def beside(scene: Scene, count: int) -> Scene:
    """Return a scene with facets as small to the eye where ``count`` pictures stand side by side."""
    return scene if count == 1 else replace(scene, cells=min(scene.cells, _BESIDE))


def _side(count: int, usual: int) -> int:
    """Return how many facets a side each of so many surfaces is given, an even number."""
    return min(usual, max(4, 2 * int(0.5 * (_FACETS / max(count, 1)) ** 0.5)))


def mesh_points(surface: Surface, cells: int) -> FloatArray:
    """Return points at the corners of cells x cells facets, shape (cells + 1, cells + 1, 3), length¹.

    Those of a trimmed face span its loops.
    """
    return surface(*face_grid(surface, cells + 1, cells + 1))


def rims(surface: Surface) -> list[FloatArray]:
    """Return the closed loops (n, 3) that bound a trimmed face, length¹; none of any other surface."""
    return [surface(*np.concatenate([loop, loop[:1]]).T) for loop in surface.trim]


def bounds(surfaces: Sequence[Surface], scene: Scene, style: Style = STANDARD) -> Box:
    """Return the corners (3,) of the box around everything drawn, or that of the style.

    A surface that runs off towards infinity, as a developable can, is cut: see ``share_outside``.
    """
    if style.box is not None:
        return settled(*np.array(style.box))
    clouds = [np.concatenate([*rims(surface), _on_face(surface, _side(len(surfaces), 60))]) for surface in surfaces]
    clouds = [_robust(cloud) for cloud in clouds]
    clouds += [surface.net.reshape(-1, 3) for surface in surfaces if scene.net and surface.net is not None]
    clouds += [trace.points for trace in scene.traces]
    if not clouds:
        return np.zeros(3), np.ones(3)
    cloud = np.concatenate(clouds)
    low, high = np.nanmin(cloud, axis=0), np.nanmax(cloud, axis=0)
    return settled(low, high)


def settled(low: FloatArray, high: FloatArray) -> Box:
    """Return the box, or one corner (3,) twice where it is a single point, to rounding."""
    largest = max(float(np.abs(low).max()), float(np.abs(high).max()))
    return (low, low.copy()) if np.linalg.norm(high - low) <= NOISE * largest else (low, high)


def single_point(surface: Surface) -> FloatArray | None:
    """Return the point (3,) to which the whole surface shrinks, to rounding; None for any other surface."""
    low, high = settled(*(end(mesh_points(surface, 12), axis=(0, 1)) for end in (np.nanmin, np.nanmax)))
    return low if np.array_equal(low, high) else None


def share_outside(surfaces: Sequence[Surface], box: Box) -> float:
    """Return the share of the (u, v) squares, of trimmed faces within loops, that lies outside the box, 0 to 1."""
    within = [inside(_on_face(surface, _side(len(surfaces), 60)), box) for surface in surfaces]
    return 1.0 - float(np.mean(np.concatenate(within))) if within else 0.0


def _on_face(surface: Surface, cells: int) -> FloatArray:
    """Return points (n, 3) of a surface, none of what is cut off a trimmed face."""
    return mesh_points(surface, cells)[surface.inside(*face_grid(surface, cells + 1, cells + 1))]


def _robust(points: FloatArray) -> FloatArray:
    """Return the corners (2, 3) of the box of the points, or of the bulk of them where a few lie far away."""
    low, high = np.nanmin(points, axis=0), np.nanmax(points, axis=0)
    first, last = np.nanpercentile(points, (10.0, 90.0), axis=0)
    if np.linalg.norm(high - low) <= 8.0 * np.linalg.norm(last - first):
        return np.stack([low, high])
    rim = 0.5 * (last - first)
    return np.stack([np.maximum(low, first - rim), np.minimum(high, last + rim)])


def inside(points: FloatArray, box: Box) -> BoolArray:
    """Return which points (..., 3) lie in the box, to a small tolerance."""
    # The box comes from fewer points.
    slack = 0.02 * float(np.linalg.norm(box[1] - box[0])) + NOISE * float(np.abs(box).max())
    fits: BoolArray = np.all((points >= box[0] - slack) & (points <= box[1] + slack), axis=-1)
    return fits
