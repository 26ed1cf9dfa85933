"""What is drawn over a surface in space: control net, normal, labelled points. Parts that it covers are faint."""

from collections.abc import Sequence

import numpy as np
from matplotlib import patheffects
from matplotlib.collections import LineCollection

from quintrig.analysis.sample import analyse
from quintrig.figure.camera import hidden
from quintrig.figure.frame import Stage
from quintrig.figure.palette import INK
from quintrig.figure.scene import Mark
from quintrig.figure.shade import Paint, strokes
from quintrig.figure.sheet import drawable
from quintrig.figure.wording import point_text
from quintrig.geometry.domain import on_face
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

STROKE = 3.0
"""Length of a stroke of a line, in printer's points."""

_NET = "#3d3d3d"


def draw_net(net: FloatArray, stage: Stage, meshes: list[FloatArray]) -> list[Paint]:
    """Return the net's lines as strokes; where the surface covers them they stay visible as a faint dotted line."""
    lines = [*net, *net.transpose(1, 0, 2)]
    flat = [stage.view.project(line)[:, :2] for line in lines]
    stage.axes.add_collection(
        LineCollection(flat, colors=_NET, linewidths=0.6, linestyles=[(0, (1, 2))], alpha=0.45, zorder=3), autolim=False
    )
    draw_dots(stage, net.reshape(-1, 3), meshes, _NET)
    lift = 0.0025 * float(np.linalg.norm(stage.high - stage.low))
    return [strokes(line, stage.view, _NET, 0.75, STROKE * stage.point, lift) for line in lines]


def draw_dots(stage: Stage, points: FloatArray, meshes: list[FloatArray], colour: str) -> None:
    """Draw control points (n, 3) as small rings."""
    seen = stage.view.project(points)
    behind = hidden(seen, meshes, 4.0 * stage.point)
    for which, alpha, size in ((behind, 0.35, 5.0), (~behind, 1.0, 8.0)):
        stage.axes.scatter(
            seen[which, 0],
            seen[which, 1],
            s=size,
            facecolor="white",
            edgecolor=colour,
            linewidth=0.8,
            alpha=alpha,
            zorder=4,
        )


def draw_normal(stage: Stage, surface: Surface, meshes: list[FloatArray]) -> None:
    """Draw the normal near the middle of the patch, faint where the surface covers it."""
    for u, v in zip(*on_face(surface, *np.array([(0.5, 0.5), (0.37, 0.41), (0.61, 0.33)]).T), strict=True):
        sample = analyse(surface, u, v, ("point", "normal"))
        if np.isfinite(sample.normal).all():
            break
    else:
        return
    length = max(0.16 * float(np.linalg.norm(stage.high - stage.low)), 16.0 * stage.point)
    ends = stage.view.project(np.stack([sample.point, sample.point + length * sample.normal]))
    shown = 0.5 if hidden(ends[1:], meshes, 4.0 * stage.point)[0] else 1.0
    halo = [patheffects.withStroke(linewidth=2.2, foreground="white", alpha=0.8 * shown)]
    stage.axes.annotate(
        "",
        xy=ends[1, :2],
        xytext=ends[0, :2],
        arrowprops={
            "arrowstyle": "-|>",
            "color": INK,
            "linewidth": 1.2,
            "alpha": shown,
            "shrinkA": 0,
            "shrinkB": 0,
            "path_effects": halo,
        },
        annotation_clip=False,
        zorder=5,
    )
    _label(stage, ends[1, :2], "$\\mathbf{n}$", shown)


def draw_point(stage: Stage, point: FloatArray) -> None:
    """Draw the point (3,) that a whole surface shrinks to, with its coordinates."""
    place = stage.view.project(point)[:2]
    stage.axes.scatter(*place, s=22, facecolor=INK, edgecolor="white", linewidth=0.8, zorder=5)
    _label(stage, place, point_text(point), 1.0)


def draw_marks(stage: Stage, surface: Surface, marks: Sequence[Mark], meshes: list[FloatArray]) -> None:
    """Draw labelled points on the surface, hollow where they are on its far side."""
    points = surface(np.array([m.u for m in marks]), np.array([m.v for m in marks]))
    seen = stage.view.project(points)
    behind = hidden(seen, meshes, 0.02 * surface.size)
    for mark, place, covered in zip(marks, seen, behind, strict=True):
        shown = 0.55 if covered else 1.0
        fill = "white" if covered else INK
        stage.axes.scatter(*place[:2], s=13, facecolor=fill, edgecolor=INK, linewidth=0.8, alpha=shown, zorder=5)
        _label(stage, place[:2], mark.label, shown)


def _label(stage: Stage, place: FloatArray, text: str, shown: float) -> None:
    stage.axes.annotate(
        drawable(text),
        xy=place,
        xytext=(3.5, 3.5),
        textcoords="offset points",
        fontsize=8.5,
        color=INK,
        alpha=max(shown, 0.75),
        path_effects=[patheffects.withStroke(linewidth=2.0, foreground="white", alpha=0.85)],
        annotation_clip=False,
        zorder=6,
    )
