"""Surfaces in space: shaded, coloured by a quantity, with net, iso-lines, labelled points and curves, on given axes."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.path import Path

from quintrig.figure.edge import regression_lines
from quintrig.figure.field import Field, level_lines, traced, zero_lines
from quintrig.figure.frame import Stage, box_outline, draw_frame, set_stage
from quintrig.figure.markup import STROKE, draw_dots, draw_marks, draw_net, draw_normal, draw_point
from quintrig.figure.palette import INK, REGRESSION, Limits
from quintrig.figure.scene import Box, Scene, bounds, inside, mesh_points, rims, single_point
from quintrig.figure.shade import Paint, facets, joined, strokes
from quintrig.figure.sheet import Axes
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import BoolArray, FloatArray

_RIM = "#3a3a3a"
_OVER = 0.2  # points that a facet reaches over its edges
_LEVELS = 2  # nodes of each facet's side at which contours are traced
_ZEROS = 4  # and zeros: where two lines cross they miss each other by half a cell


def draw_space(
    axes: Axes,
    surfaces: Sequence[Surface],
    scene: Scene | None = None,
    *,
    fields: Sequence[Field] = (),
    stretch: Limits | None = None,
    colours: Sequence[str] = (),
    tints: Sequence[FloatArray] = (),
    opacity: float = 1.0,
    unit: str = "",
    box: Box | None = None,
    point: float | None = None,
    levels: Sequence[float] = (),
) -> Stage:
    """Draw surfaces on axes, seen in parallel projection at one scale in all directions.

    ``fields`` (from ``facet_fields``) colour them by a quantity, ``colours`` each in one colour, ``tints``
    (cells, cells, 3) facet by facet; without any, the side of the normal and the back have two colours. ``box``
    fixes what is framed and ``point`` the length¹ of a printer's point, for pictures side by
    side. Thin contour lines run along the ``levels`` of what is shown.
    """
    scene = scene or Scene()
    low, high = box or bounds(surfaces, scene)
    stage = set_stage(axes, scene.view, low, high, scene.frame, point)
    if scene.frame:
        draw_frame(stage, unit)
    paints: list[Paint] = []
    meshes: list[FloatArray] = []
    for index, surface in enumerate(surfaces):
        f = fields[index] if fields else None
        colour = colours[index] if colours else ""
        cells = f.values.shape[0] if f else scene.cells
        mesh = mesh_points(surface, cells)
        meshes.append(scene.view.project(mesh))
        rgb = f.colours(stretch) if f else np.tile(to_rgb(colour), (cells, cells, 1)) if colour else None
        within = inside(mesh, (low, high))
        rgb = tints[index] if tints else rgb
        kept, plain = _face(surface, cells), f is not None or bool(tints)
        layer = [
            facets(mesh, scene.view, rgb, surface.sign, within, readable=plain, face=kept, rim=_OVER * stage.point)
        ]
        lines = _lines_on(surface, mesh, scene, stage, f, colour if opacity < 1.0 else _RIM, levels)
        if opacity < 1.0:
            _paint(stage, joined(layer), opacity)
            paints += lines
        else:
            paints += layer + lines
    # A curve on the surface lies over its edges too.
    lift = 1.8 * max((_facet_size(mesh) for mesh in meshes), default=0.0)
    step = STROKE * stage.point
    for trace in scene.traces:
        paints.append(strokes(trace.points, scene.view, trace.colour, trace.width, step, lift, trace.dashed))
        if trace.polygon:
            draw_dots(stage, trace.points, meshes, trace.colour)
    if scene.net:
        for surface in surfaces:
            if surface.net is not None:
                paints += draw_net(surface.net, stage, meshes)
    _paint(stage, joined(paints))
    for whole in map(single_point, surfaces):
        if whole is not None:
            draw_point(stage, whole)
    for surface in surfaces if scene.normal else ():
        draw_normal(stage, surface, meshes)
    if scene.marks and surfaces:
        draw_marks(stage, surfaces[0], scene.marks, meshes)
    return stage


def _lines_on(
    surface: Surface, mesh: FloatArray, scene: Scene, stage: Stage, f: Field | None, rim: str, levels: Sequence[float]
) -> list[Paint]:
    """Return boundary, iso-lines, zero lines, contours and edge of regression, lifted just clear of the facets."""
    lift = 1.2 * _facet_size(mesh)
    step = STROKE * stage.point
    box = (stage.low, stage.high)
    u, v = (nodes.ravel() for nodes in face_grid(surface, len(mesh), len(mesh)))
    across, up = (nodes.ravel()[1:-1] for nodes in face_grid(surface, scene.isolines + 2, scene.isolines + 2))
    thin = [_on_face(surface, np.full_like(v, x), v) for x in across]
    thin += [_on_face(surface, u, np.full_like(u, x)) for x in up]
    paints = [strokes(_cut(line, box), scene.view, "#6e6e6e", 0.4, step, lift) for line in thin]
    paints += [strokes(_cut(line, box), scene.view, rim, 0.9, step, lift) for line in _rims(surface, mesh, scene)]
    if scene.zeros and f is not None and f.quantity.colour == "diverging":
        dashed = f.quantity.key == "mean"
        for line in zero_lines(traced(surface, f.quantity.key, _ZEROS * scene.cells + 1)):
            path = _cut(surface(line[:, 0], line[:, 1]), box)
            paints.append(strokes(path, scene.view, INK, 1.1, step, lift, dashed))
    if levels and f is not None:
        fine = traced(surface, f.quantity.key, _LEVELS * scene.cells + 1)
        for line in (line for level in levels for line in level_lines(fine, level)):
            paints.append(strokes(_cut(surface(line[:, 0], line[:, 1]), box), scene.view, INK, 0.5, step, lift))
    if scene.regression:
        for line in regression_lines(surface):
            paints.append(strokes(_cut(line, box), scene.view, REGRESSION, 1.8, step, lift))
    return paints


def _rims(surface: Surface, mesh: FloatArray, scene: Scene) -> list[FloatArray]:
    return (rims(surface) or _rim(mesh)) if scene.rims else []


def _face(surface: Surface, cells: int) -> BoolArray | None:
    """Return which facets (cells, cells) lie on a trimmed face; None where all do."""
    if not surface.trim:
        return None
    u, v = (nodes.ravel() for nodes in face_grid(surface, cells + 1, cells + 1))
    return surface.inside(0.5 * (u[:-1] + u[1:])[:, None], 0.5 * (v[:-1] + v[1:])[None, :])


def _on_face(surface: Surface, u: FloatArray, v: FloatArray) -> FloatArray:
    """Return a line (n, 3) on the surface with NaN outside a trimmed face."""
    return np.where(surface.inside(u, v)[:, None], surface(u, v), np.nan)


def _cut(line: FloatArray, box: Box) -> FloatArray:
    """Return a line (n, 3) with NaN outside the box, where it is not drawn, save for the first point beyond."""
    within = inside(line, box)
    keep = within.copy()
    keep[1:] |= within[:-1]
    keep[:-1] |= within[1:]
    return np.where(keep[:, None], line, np.nan)


def _rim(mesh: FloatArray) -> list[FloatArray]:
    """Return the edges of the patch, without seams where it closes and points where an edge collapses."""
    size = float(np.linalg.norm(np.ptp(mesh, axis=(0, 1))))
    edges: list[FloatArray] = []
    for first, second in ((mesh[0], mesh[-1]), (mesh[:, 0], mesh[:, -1])):
        closed = np.abs(first - second).max() <= 1e-9 * size
        edges += [e for e in (first, second) if not closed and np.ptp(e, axis=0).max() > 1e-9 * size]
    return edges


def _facet_size(mesh: FloatArray) -> float:
    diagonals = np.sqrt(((mesh[1:, 1:] - mesh[:-1, :-1]) ** 2).sum(axis=-1))
    return float(np.median(diagonals))


class _Quad(Path):
    """A closed quad: plain attributes, for what would be worked out anew each time it is drawn."""

    vertices: Any = None
    codes: Any = np.array([Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY], dtype=Path.code_type)
    should_simplify: Any = False
    simplify_threshold: Any = 0.0

    def __init__(self, corners: FloatArray) -> None:
        """Keep the corners (5, 2), the first again at the end."""
        self.vertices = corners


class _Quads(PolyCollection):
    """Quads with an edge width each: matplotlib scales a dash pattern for every one of them, a fifth of its work."""

    def set_verts(self, verts: Any, closed: bool = True) -> None:
        """Take corners (n, 4, 2)."""
        self._paths = [_Quad(corners) for corners in np.concatenate([verts, verts[:, :1]], axis=1)]
        self.stale = True

    def set_linewidth(self, lw: Any) -> None:
        """Keep the widths; lines are solid."""
        self._us_lw = self._linewidths = np.atleast_1d(lw)
        self.stale = True

    def set_linestyle(self, ls: Any) -> None:
        """Keep to solid lines."""
        self._us_linestyles = self._linestyles = [(0, None)]
        self.stale = True


def _paint(stage: Stage, paint: Paint, opacity: float = 1.0) -> None:
    collection = _Quads(
        paint.corners,  # pyright: ignore[reportArgumentType]
        facecolors=paint.fill,
        edgecolors=paint.edge,
        linewidths=paint.width,
        joinstyle="round",
        capstyle="round",
        zorder=2,
        rasterized=True,
    )
    if opacity < 1.0:

        def thin(image: Any, dpi: float) -> tuple[Any, int, int]:
            return image * [1.0, 1.0, 1.0, opacity], 0, 0

        # A whole opaque picture made translucent: facets that are translucent one by one show their seams.
        collection.set_agg_filter(thin)
    stage.axes.add_collection(collection, autolim=False)
    outline = box_outline(stage)
    if np.any(paint.corners < outline.min(axis=0)) or np.any(paint.corners > outline.max(axis=0)):
        collection.set_clip_path(Path(outline), stage.axes.transData)
