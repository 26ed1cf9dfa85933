"""Whole figures of one surface, with title, key and note: one picture, one map, panels of several quantities."""

from collections.abc import Sequence
from dataclasses import replace

from matplotlib.figure import Figure

from quintrig.figure.field import common_limits, facet_fields, levels_of
from quintrig.figure.flat import draw_map, lines_note, map_axes, map_fields, zero_sets
from quintrig.figure.frame import panel_size
from quintrig.figure.legend import draw_class_list, draw_key, key_height, key_room
from quintrig.figure.read_lines import marks_at, staged
from quintrig.figure.scene import Mark, Scene, beside, bounds, share_outside, thinned
from quintrig.figure.sheet import columns_for, sheet
from quintrig.figure.space import draw_space
from quintrig.figure.style import STANDARD, Style
from quintrig.figure.wording import note, quantity_label
from quintrig.geometry.surface import Surface
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import quantity


def space_picture(
    surfaces: Surface | Sequence[Surface],
    key: str | None = None,
    scene: Scene | None = None,
    *,
    title: str = "",
    unit: str = "",
    thresholds: Thresholds | None = None,
    width: float = 6.4,
    style: Style = STANDARD,
    remark: str = "",
) -> Figure:
    """Return one picture in space of a surface, or of several patches, coloured by a quantity or plain.

    On a plain one, the labels of the scene's traces are listed below; ``remark`` ends the note.
    """
    width = style.across(width)
    patches = several(surfaces)
    scene = thinned(staged(scene or Scene(normal=key is None), style, patches), len(patches))
    fields = facet_fields(patches, key, scene.cells, thresholds)
    stretch = common_limits(fields, style)
    levels = levels_of(style, stretch)
    named = [trace for trace in scene.traces if trace.label]
    place, key_size = ("below", 0.4) if named and not fields else key_room(fields, width)
    box = bounds(patches, scene, style)
    panel = panel_size(scene.view, *box, width - 0.2 - (key_size if place == "right" else 0.0), scene.frame)
    text = note(patches, fields, unit, thresholds, share_outside(patches, box), zeros=scene.zeros)
    text = ". ".join(part for part in (text, remark) if part)
    page = sheet(1, panel, title=title, note=text, key=place, key_size=key_size, style=style)
    draw_space(
        page.panels[0].axes(),
        patches,
        scene,
        fields=fields,
        stretch=stretch,
        unit=unit,
        box=box,
        levels=levels,
    )
    if fields:
        draw_key(page.keys[0], fields, stretch, unit)
    elif named:
        draw_class_list(page.keys[0], "", [trace.label for trace in named], [trace.colour for trace in named])
    return style.finish(page.figure)


def flat_map(
    surface: Surface,
    key: str,
    *,
    marks: Sequence[Mark] = (),
    title: str = "",
    unit: str = "",
    thresholds: Thresholds | None = None,
    width: float = 5.0,
    style: Style = STANDARD,
) -> Figure:
    """Return one map of a quantity over (u, v)."""
    width, marks = style.across(width), (*marks, *marks_at(style.at))
    fields = map_fields([surface], key, thresholds=thresholds)
    stretch = common_limits(fields, style)
    levels = levels_of(style, stretch)
    place, key_size = key_room(fields, width)
    side = width - 0.2 - (key_size if place == "right" else 0.0)
    zeros = zero_sets(surface, fields[0])
    text = _sentence(note([surface], fields, unit, thresholds), lines_note([zeros]))
    page = sheet(1, (side, side), title=title, note=text, key=place, key_size=key_size, style=style)
    draw_map(map_axes(page.panels[0]), surface, fields[0], stretch, marks, zeros, levels)
    draw_key(page.keys[0], fields, stretch, unit)
    return style.finish(page.figure)


def panels(
    surfaces: Surface | Sequence[Surface],
    keys: Sequence[str | None] = (None, "gaussian", "mean"),
    scene: Scene | None = None,
    *,
    title: str = "",
    unit: str = "",
    thresholds: Thresholds | None = None,
    columns: int = 3,
    width: float = 9.0,
    style: Style = STANDARD,
) -> Figure:
    """Return one surface coloured by several quantities, each with its own key; None is the plain surface.

    Without ``keys`` it is the triptych surface, K, H of the thesis's figures 4.3 to 4.32. Net, marks, traces and
    normal of the scene are drawn on the plain panel only, or on every panel where there is no plain one.
    """
    width = style.across(width)
    patches = several(surfaces)
    scene = beside(thinned(staged(scene or Scene(normal=None in keys), style, patches), len(patches)), len(keys))
    columns = columns_for(width, len(keys), columns)
    box = bounds(patches, scene, style)
    panel = panel_size(scene.view, *box, (width - 0.2 - 0.12 * (columns - 1)) / columns, scene.frame)
    every = [facet_fields(patches, key, scene.cells, thresholds) for key in keys]
    drawn = [f for fields in every for f in fields]
    page = sheet(
        len(keys),
        panel,
        columns=columns,
        titles=[panel_title(key) for key in keys],
        title=title,
        note=note(patches, drawn, unit, thresholds, share_outside(patches, box), zeros=scene.zeros),
        key="each" if drawn else "none",
        key_size=key_height(every, panel[0]),
        style=style,
    )
    bare = replace(scene, net=False, marks=(), traces=(), normal=False) if None in keys else scene
    for index, (key, fields) in enumerate(zip(keys, every, strict=True)):
        stretch = common_limits(fields, style)
        levels = levels_of(style, stretch)
        here = scene if key is None else bare
        draw_space(
            page.panels[index].axes(),
            patches,
            here,
            fields=fields,
            stretch=stretch,
            unit=unit,
            box=box,
            levels=levels,
        )
        if fields:
            draw_key(page.keys[index], fields, stretch, unit)
    return style.finish(page.figure)


def map_panels(
    surface: Surface,
    keys: Sequence[str],
    *,
    marks: Sequence[Mark] = (),
    title: str = "",
    unit: str = "",
    thresholds: Thresholds | None = None,
    columns: int = 3,
    width: float = 9.0,
    style: Style = STANDARD,
) -> Figure:
    """Return maps of several quantities over (u, v), each with its own key."""
    width, marks = style.across(width), (*marks, *marks_at(style.at))
    every = [map_fields([surface], key, thresholds=thresholds) for key in keys]
    columns = columns_for(width, len(keys), columns)
    side = (width - 0.2 - 0.12 * (columns - 1)) / columns
    drawn = [fields[0] for fields in every]
    zeros = [zero_sets(surface, f) for f in drawn]
    page = sheet(
        len(keys),
        (side, side),
        columns=columns,
        titles=[panel_title(key) for key in keys],
        title=title,
        note=_sentence(note([surface], drawn, unit, thresholds), lines_note(zeros)),
        key="each",
        key_size=key_height(every, side),
        style=style,
    )
    for index, fields in enumerate(every):
        stretch = common_limits(fields, style)
        levels = levels_of(style, stretch)
        draw_map(map_axes(page.panels[index]), surface, fields[0], stretch, marks, zeros[index], levels)
        draw_key(page.keys[index], fields, stretch, unit)
    return style.finish(page.figure)


def several(surfaces: Surface | Sequence[Surface]) -> list[Surface]:
    """Return one surface or several as a list."""
    return [surfaces] if isinstance(surfaces, Surface) else list(surfaces)


def panel_title(key: str | None) -> str:
    """Return the title of a panel: the quantity's name and symbol, or that it is the plain surface."""
    return "Surface" if key is None else quantity_label(quantity(key))


def _sentence(*parts: str) -> str:
    return "; ".join(part for part in parts if part)
