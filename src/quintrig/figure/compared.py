"""Whole figures that compare: surfaces side by side on one scale, three projections, surfaces laid over each other."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from numpy.typing import NDArray

from quintrig.figure.camera import BACK, SIDE, TOP
from quintrig.figure.field import common_limits, facet_fields, levels_of
from quintrig.figure.flat import (
    draw_colours,
    draw_map,
    draw_marks,
    draw_trim,
    dress,
    lines_note,
    map_axes,
    map_fields,
    zero_sets,
)
from quintrig.figure.frame import equal_scale, panel_size, stacked_scale
from quintrig.figure.legend import draw_class_list, draw_key, key_height, list_height
from quintrig.figure.palette import SERIES
from quintrig.figure.read_lines import marks_at, staged
from quintrig.figure.scene import Box, Mark, Scene, beside, bounds, settled, share_outside, thinned
from quintrig.figure.sheet import columns_for, sheet
from quintrig.figure.space import draw_space
from quintrig.figure.style import STANDARD, Style
from quintrig.figure.whole import panel_title, several
from quintrig.figure.wording import note
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import window
from quintrig.quantities.classify import Thresholds

_NODES = 241  # between which lines are traced on maps side by side, each about as many pixels wide


def comparison(
    surfaces: Sequence[Surface],
    titles: Sequence[str],
    key: str | None = "gaussian",
    scene: Scene | None = None,
    *,
    title: str = "",
    unit: str = "",
    thresholds: Thresholds | None = None,
    columns: int = 0,
    width: float = 9.0,
    style: Style = STANDARD,
) -> Figure:
    """Return several surfaces side by side, such as one with several shape parameters, coloured by a quantity or plain.

    All have one scale of length and one of colour. ``columns`` 0 chooses: 2 for four surfaces, else up to 3.
    """
    width = style.across(width)
    scene = beside(staged(scene or Scene(), replace(style, lines=None), surfaces), len(surfaces))
    each_scene = [staged(scene, Style(lines=style.lines), [surface]) for surface in surfaces]
    columns = columns_for(width, len(surfaces), columns or (2 if len(surfaces) == 4 else 3))
    fields = facet_fields(surfaces, key, scene.cells, thresholds)
    stretch = common_limits(fields, style)
    levels = levels_of(style, stretch)
    box = _union([bounds([surface], scene) for surface in surfaces])
    each = (width - 0.2 - 0.12 * (columns - 1)) / columns
    page = sheet(
        len(surfaces),
        panel_size(scene.view, *box, each, scene.frame),
        columns=columns,
        titles=titles,
        title=title or panel_title(key),
        note=note(surfaces, fields, unit, thresholds, share_outside(surfaces, box), zeros=scene.zeros),
        key="below" if fields else "none",
        key_size=key_height([fields], width - 0.2),
        style=style,
    )
    for index, surface in enumerate(surfaces):
        here = fields[index : index + 1]
        draw_space(
            page.panels[index].axes(),
            [surface],
            each_scene[index],
            fields=here,
            stretch=stretch,
            unit=unit,
            box=box,
            levels=levels,
        )
    if fields:
        draw_key(page.keys[0], fields, stretch, unit)
    return style.finish(page.figure)


def map_comparison(
    surfaces: Sequence[Surface],
    titles: Sequence[str],
    key: str = "gaussian",
    *,
    marks: Sequence[Mark] = (),
    title: str = "",
    unit: str = "",
    thresholds: Thresholds | None = None,
    columns: int = 4,
    width: float = 9.0,
    style: Style = STANDARD,
) -> Figure:
    """Return maps over (u, v) of one quantity on several surfaces, side by side on one scale of colour."""
    width, marks = style.across(width), (*marks, *marks_at(style.at))
    columns = columns_for(width, len(surfaces), columns)
    fields = map_fields(surfaces, key, thresholds=thresholds)
    stretch = common_limits(fields, style)
    levels = levels_of(style, stretch)
    zeros = [zero_sets(surface, f, _NODES) for surface, f in zip(surfaces, fields, strict=True)]
    side = (width - 0.2 - 0.12 * (columns - 1)) / columns
    page = sheet(
        len(surfaces),
        (side, side),
        columns=columns,
        titles=titles,
        title=title or panel_title(key),
        note="; ".join(part for part in (note(surfaces, fields, unit, thresholds), lines_note(zeros)) if part),
        key="below",
        key_size=key_height([fields], width - 0.2),
        style=style,
    )
    for area, surface, f, lines in zip(page.panels, surfaces, fields, zeros, strict=True):
        draw_map(map_axes(area), surface, f, stretch, marks, lines, levels)
    draw_key(page.keys[0], fields, stretch, unit)
    return style.finish(page.figure)


def code_map(
    codes: NDArray[np.integer],
    names: Sequence[str],
    colours: Sequence[str],
    *,
    face: Surface | None = None,
    marks: Sequence[Mark] = (),
    title: str = "",
    note: str = "",
    width: float = 5.0,
    style: Style = STANDARD,
) -> Figure:
    """Return a map over (u, v) of any codes 0, 1, ... (n, m), first index along u, at the middles of equal cells.

    It serves where the codes are no quantity of the table, such as where two classifications agree. Where they are of a
    trimmed ``face``, they span its loops.
    """
    width = style.across(width)
    rgb = np.array([to_rgb(colour) for colour in colours])
    side = width - 0.2
    trim = face.trim if face else ()
    counted = codes[face.inside(*face_grid(face, *codes.shape))] if face and trim else codes
    seen = sorted({int(code) for code in np.unique(counted)})
    shown = [names[code] for code in seen]
    page = sheet(1, (side, side), title=title, note=note, key="below", key_size=list_height(shown, side), style=style)
    axes = map_axes(page.panels[0])
    draw_colours(axes, rgb[np.asarray(codes, dtype=np.intp)], window(trim))
    if face:
        draw_trim(axes, face)
    draw_marks(axes, marks)
    dress(axes)
    draw_class_list(page.keys[0], "", shown, [colours[code] for code in seen])
    return style.finish(page.figure)


def projections(
    surfaces: Surface | Sequence[Surface],
    key: str | None = None,
    scene: Scene | None = None,
    *,
    title: str = "",
    unit: str = "",
    thresholds: Thresholds | None = None,
    width: float = 9.0,
    style: Style = STANDARD,
) -> Figure:
    """Return the side, back and top views of a surface at one scale, as the thesis's figures 4.35 to 4.38.

    The side view looks along +y, the back view along -x, the top view along -z.
    """
    width = style.across(width)
    patches = several(surfaces)
    scene = staged(scene or Scene(isolines=7), replace(style, view=None), patches)
    scene = beside(thinned(scene, len(patches)), 3)
    fields = facet_fields(patches, key, scene.cells, thresholds)
    stretch = common_limits(fields, style)
    levels = levels_of(style, stretch)
    views = [replace(scene, view=view) for view in (SIDE, BACK, TOP)]
    box = bounds(patches, scene, style)
    columns = 3 if columns_for(width, 3, 3) == 3 else 1
    arrange, room = (equal_scale, width - 0.44) if columns == 3 else (stacked_scale, width - 0.2)
    sizes, point = arrange([view.view for view in views], *box, room, scene.frame)
    page = sheet(
        3,
        (0.0, max(height for _, height in sizes)),
        columns=columns,
        widths=[across for across, _ in sizes[:columns]],
        titles=[view.view.name[:1].upper() + view.view.name[1:] for view in views],
        title=title,
        note=note(patches, fields, unit, thresholds, share_outside(patches, box), zeros=scene.zeros),
        key="below" if fields else "none",
        key_size=key_height([fields], width),
        style=style,
    )
    for area, view in zip(page.panels, views, strict=True):
        draw_space(
            area.axes(),
            patches,
            view,
            fields=fields,
            stretch=stretch,
            unit=unit,
            box=box,
            point=point,
            levels=levels,
        )
    if fields:
        draw_key(page.keys[0], fields, stretch, unit)
    return style.finish(page.figure)


def overlay(
    surfaces: Sequence[Surface],
    labels: Sequence[str],
    scene: Scene | None = None,
    *,
    title: str = "",
    unit: str = "",
    width: float = 5.0,
    style: Style = STANDARD,
) -> Figure:
    """Return several surfaces in one space, each translucent in its own colour, as the thesis's figures 2.4 and 2.5.

    The net of the scene is the first surface's.
    """
    width = style.across(width)
    scene = staged(scene or Scene(), style, surfaces)
    colours = [SERIES[i % len(SERIES)] for i in range(len(surfaces))]
    box = bounds(surfaces, scene)
    panel = panel_size(scene.view, *box, width - 0.2, scene.frame)
    text = note(surfaces, (), unit, None, share_outside(surfaces, box))
    page = sheet(1, panel, title=title, note=text, key="below", key_size=list_height(labels, width), style=style)
    draw_space(page.panels[0].axes(), surfaces, scene, colours=colours, opacity=0.6, unit=unit, box=box)
    draw_class_list(page.keys[0], "", labels, colours)
    return style.finish(page.figure)


def _union(boxes: Sequence[Box]) -> Box:
    lows, highs = zip(*boxes, strict=True)
    return settled(np.min(lows, axis=0), np.max(highs, axis=0))
