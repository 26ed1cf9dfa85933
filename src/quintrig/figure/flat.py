"""Maps over the (u, v) square: a quantity or a classification, its zero lines, labelled points."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib import patheffects

from quintrig.figure.edge import regression_parameters
from quintrig.figure.field import Field, facet_fields, level_lines, traced, zero_lines
from quintrig.figure.palette import INK, REGRESSION, UNDEFINED, Limits
from quintrig.figure.scene import Mark
from quintrig.figure.sheet import Area, Axes, drawable
from quintrig.figure.wording import zeros_note
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import quantity
from quintrig.support.arrays import FloatArray

_SIZE = 7.5
Zeros = Mapping[str, tuple[FloatArray, ...]]
"""Lines (n, 2) in (u, v) along which a quantity is zero, by its key."""

_COMPANIONS = {"gaussian": ("gaussian", "mean"), "mean": ("gaussian", "mean"), "shape_index": ("gaussian", "mean")}


def map_fields(
    surfaces: Sequence[Surface], key: str, cells: int = 240, thresholds: Thresholds | None = None
) -> list[Field]:
    """Return the quantity at the middle of every cell of the (u, v) square, for each surface."""
    return facet_fields(surfaces, key, cells, thresholds, square=True)


def draw_map(
    axes: Axes,
    surface: Surface,
    f: Field,
    stretch: Limits | None = None,
    marks: Sequence[Mark] = (),
    zeros: Zeros | None = None,
    levels: Sequence[float] = (),
) -> None:
    """Draw a quantity over (u, v): u to the right, v up, with thin contour lines at the ``levels``.

    ``zeros`` are the lines of ``zero_sets``, dashed for H; those of this field where None. Undefined cells are grey,
    single undefined points on the edge have a grey mark.
    """
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(0.0, 1.0)
    draw_colours(axes, f.colours(stretch))
    draw_trim(axes, surface)
    _undefined(axes, f)
    for key, lines in (zero_sets(surface, f) if zeros is None else zeros).items():
        for line in lines:
            style = (0, (4, 2)) if key == "mean" else "solid"
            axes.plot(line[:, 0], line[:, 1], color=INK, linewidth=0.9, linestyle=style, zorder=3)
    if levels:
        fine = traced(surface, f.quantity.key, 241)
        for line in (line for level in levels for line in level_lines(fine, level)):
            axes.plot(line[:, 0], line[:, 1], color=INK, linewidth=0.45, zorder=2.5)
    for line in regression_parameters(surface):
        axes.plot(line[:, 0], line[:, 1], color=REGRESSION, linewidth=1.5, zorder=4)
    draw_marks(axes, marks)
    dress(axes)


def map_axes(area: Area) -> Axes:
    """Return axes for a map in an area, with room for the numbers."""
    return area.inside(0.42, 0.32, area.width - 0.48, area.height - 0.38)


def lines_note(drawn: Sequence[Zeros]) -> str:
    """Return what the zero lines on maps mean, empty where there are none."""
    return zeros_note([quantity(key) for zeros in drawn for key in zeros])


def zero_sets(surface: Surface, f: Field, nodes: int = 481) -> Zeros:
    """Return the zero lines that belong on a map, by quantity, of those that have any, traced between so many nodes.

    K = 0 and H = 0 for maps of K, H and S, their own for others with a sign.
    """
    own = (f.quantity.key,) if f.quantity.colour == "diverging" else ()
    found = {key: tuple(zero_lines(traced(surface, key, nodes))) for key in _COMPANIONS.get(f.quantity.key, own)}
    return {key: lines for key, lines in found.items() if lines}


def draw_colours(axes: Axes, colours: FloatArray, over: FloatArray | None = None) -> None:
    """Draw cells (n, m, 3) of colours over the square, or from the first to the second (u, v) of ``over``."""
    (u0, v0), (u1, v1) = window(()) if over is None else over
    picture = np.ascontiguousarray(colours.transpose(1, 0, 2))
    axes.imshow(
        picture,
        origin="lower",
        extent=(u0, u1, v0, v1),
        interpolation="nearest",
        aspect="equal",
        zorder=1,
        rasterized=True,
    )
    axes.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))


def draw_trim(axes: Axes, surface: Surface) -> None:
    """Draw the loops of a trimmed face, and pale what is outside: it is on the carrier surface alone."""
    if not surface.trim:
        return
    middle = (np.arange(480) + 0.5) / 480
    veil = np.ones((480, 480, 4))
    veil[..., 3] = np.where(surface.inside(middle[None, :], middle[:, None]), 0.0, 0.72)
    axes.imshow(veil, origin="lower", extent=(0.0, 1.0, 0.0, 1.0), aspect="equal", zorder=2, rasterized=True)
    for loop in surface.trim:
        closed = np.concatenate([loop, loop[:1]])
        axes.plot(closed[:, 0], closed[:, 1], color=INK, linewidth=1.3, zorder=4)


def draw_marks(axes: Axes, marks: Sequence[Mark]) -> None:
    """Draw labelled points."""
    if marks:
        places = [[mark.u for mark in marks], [mark.v for mark in marks]]
        axes.scatter(*places, s=14, facecolor=INK, edgecolor="white", linewidth=0.7, zorder=5, clip_on=False)
    for mark in marks:
        right, up = mark.u < 0.85, mark.v < 0.85
        axes.annotate(
            drawable(mark.label),
            xy=(mark.u, mark.v),
            xytext=(4.0 if right else -4.0, 4.0 if up else -4.0),
            textcoords="offset points",
            ha="left" if right else "right",
            va="bottom" if up else "top",
            fontsize=8.5,
            color=INK,
            path_effects=[patheffects.withStroke(linewidth=2.0, foreground="white", alpha=0.85)],
            zorder=6,
        )


def dress(axes: Axes) -> None:
    """Give a map its ticks and the names u and v."""
    ticks = [0.0, 0.25, 0.5, 0.75, 1.0]
    axes.set_xticks(ticks, ["0", "", "0.5", "", "1"], fontsize=_SIZE, color=INK)
    axes.set_yticks(ticks, ["0", "", "0.5", "", "1"], fontsize=_SIZE, color=INK)
    axes.tick_params(length=2.5, width=0.5, color="#8a8a8a", pad=2.0)
    axes.set_xlabel("$u$", fontsize=_SIZE + 1.5, color=INK, labelpad=1.0)
    axes.set_ylabel("$v$", fontsize=_SIZE + 1.5, color=INK, labelpad=5.0, rotation=0, va="center")
    for spine in axes.spines.values():
        spine.set(linewidth=0.6, edgecolor="#8a8a8a")


def _undefined(axes: Axes, f: Field) -> None:
    """Mark undefined cells, so that a line of singular points on the edge is wide enough to be seen."""
    i, j = np.nonzero(f.undefined)
    if 0 < len(i) <= 4 * len(f.u):
        axes.scatter(f.u[i], f.v[j], s=4.0, marker="s", color=UNDEFINED, linewidth=0.0, zorder=2)
