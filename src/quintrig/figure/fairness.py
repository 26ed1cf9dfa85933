"""Fairness in a picture: two surfaces side by side with curvature combs along their parameter lines, and in zebra."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from quintrig.figure.field import common_limits, facet_fields
from quintrig.figure.frame import panel_size
from quintrig.figure.legend import draw_key
from quintrig.figure.palette import SERIES
from quintrig.figure.scene import Scene, Trace, bounds
from quintrig.figure.sheet import sheet
from quintrig.figure.space import draw_space
from quintrig.figure.style import STANDARD, Style
from quintrig.figure.zebra import stripes
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

_AT = (0.0, 0.25, 0.5, 0.75, 1.0)  # parameter lines that carry a comb, each way
_TEETH = 60  # of a comb
_REACH = 0.12  # of the size: the longest tooth of all
_QUANTITY = "curvedness"


def fairness_picture(
    surfaces: Sequence[Surface],
    titles: Sequence[str],
    *,
    title: str = "",
    unit: str = "",
    width: float = 10.0,
    style: Style = STANDARD,
) -> Figure:
    """Return surfaces side by side on one scale: with combs, coloured by curvedness, above; with zebra stripes below.

    The teeth of a comb are as long as a parameter line is curved, away from its centre of curvature, all to one scale.
    """
    width, count = style.across(width), len(surfaces)
    bare = [combs(surface) for surface in surfaces]
    longest = max(float(np.linalg.norm(way, axis=-1).max()) for _, way in bare)
    size = max(surface.size for surface in surfaces)
    scale = _REACH * size / longest if longest > 0.0 else 0.0
    traces = [_drawn(points, scale * way) for points, way in bare]
    scene = Scene(cells=120)
    box = bounds(surfaces, Scene(traces=tuple(line for one in traces for line in one)), style)
    key_size = 0.7
    panel = panel_size(scene.view, *box, (width - key_size - 0.3) / count, scene.frame)
    note = (
        "Above: teeth as long as a parameter line is curved, away from its centre of curvature, all to one scale, on "
        f"the surface coloured by curvedness. Below: reflected stripes.{f' Lengths in {unit}.' if unit else ''}"
    )
    heads = [*titles, *(f"{one}, zebra" for one in titles)]
    page = sheet(
        2 * count,
        panel,
        columns=count,
        titles=heads,
        title=title,
        note=note,
        key="right",
        key_size=key_size,
        style=style,
    )
    fields = facet_fields(surfaces, _QUANTITY, scene.cells)
    stretch = common_limits(fields, style)
    for index, surface in enumerate(surfaces):
        own = Scene(cells=scene.cells, traces=tuple(traces[index]))
        draw_space(
            page.panels[index].axes(), [surface], own, fields=[fields[index]], stretch=stretch, unit=unit, box=box
        )
        tints = [stripes(surface, scene.view, 160)]
        below = Scene(cells=160, rims=False)
        draw_space(page.panels[count + index].axes(), [surface], below, tints=tints, unit=unit, box=box)
    draw_key(page.keys[0], fields, stretch, unit)
    return style.finish(page.figure)


def combs(surface: Surface) -> tuple[FloatArray, FloatArray]:
    """Return points (lines, teeth, 3) on parameter lines and their curvature vectors, turned about, length⁻¹."""
    t, at = np.linspace(0.0, 1.0, _TEETH + 1), np.array(_AT)
    points: list[FloatArray] = []
    ways: list[FloatArray] = []
    for along in (0, 1):
        s = surface.partials(t[None, :], at[:, None], 2) if along == 0 else surface.partials(at[:, None], t[None, :], 2)
        first, second = (s[1, 0], s[2, 0]) if along == 0 else (s[0, 1], s[0, 2])
        speed = np.sum(first * first, axis=-1, keepdims=True)
        with np.errstate(divide="ignore", invalid="ignore"):
            bend = (second - np.sum(second * first, axis=-1, keepdims=True) / speed * first) / speed
        points.append(np.broadcast_to(s[0, 0], bend.shape))
        ways.append(-np.nan_to_num(bend, nan=0.0, posinf=0.0, neginf=0.0))
    return np.concatenate(points), np.concatenate(ways)


def _drawn(points: FloatArray, ways: FloatArray) -> list[Trace]:
    """Return the combs as lines: their tips, and a tooth at every third point."""
    lines = [Trace(tips, colour=SERIES[1], width=0.9) for tips in points + ways]
    for line, way in zip(points, ways, strict=True):
        lines += [
            Trace(np.array([p, p + w]), colour=SERIES[1], width=0.4) for p, w in zip(line[::3], way[::3], strict=True)
        ]
    return lines
