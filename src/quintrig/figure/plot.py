"""``quintrig.plot``: one function for a picture of anything that has one."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from quintrig.analysis.sample import Sample
from quintrig.figure.along import curvature_plot, torsion_plot
from quintrig.figure.beside import projections
from quintrig.figure.camera import ISO, VIEWS, View
from quintrig.figure.curve import plane_curves
from quintrig.figure.deviation import deviation_picture
from quintrig.figure.field import Field, common_limits, facet_fields, levels_of, natural_scale
from quintrig.figure.flat import draw_map, map_axes, map_fields
from quintrig.figure.legend import draw_key, key_width
from quintrig.figure.read_lines import traces_of
from quintrig.figure.save import save as write
from quintrig.figure.scan import scan_picture
from quintrig.figure.scene import Mark, Scene, Trace, thinned
from quintrig.figure.sheet import sheet
from quintrig.figure.space import draw_space
from quintrig.figure.space_curves import curve_traces, space_curves
from quintrig.figure.style import Style, changed, inches, style_named
from quintrig.figure.whole import flat_map, map_panels, panels, space_picture
from quintrig.figure.zebra import zebra_picture
from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.interrogation.line import Lines
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.quantities.table import quantity as row
from quintrig.scan.curvature import ScanCurvature, scan_curvature
from quintrig.scan.deviation import Deviation
from quintrig.scan.scan import Scan
from quintrig.support.arrays import parameter
from quintrig.support.errors import ArgumentError
from quintrig.support.numerals import real
from quintrig.support.tolerance import SAME_COLOUR

Subject = Surface | Patch | Model | Curve | Sample | Scan | ScanCurvature | Deviation | Sequence[Curve]
ViewName = str | tuple[float, float]

CURVE_PICTURES = ("curve", "comb", "hull", "curvature", "torsion")
"""What is drawn of curves."""


_ARROWS = 8  # patches of which each shows its normal; of more the arrows would hide them


@dataclass(frozen=True)
class _Page:
    """What is the same whatever is drawn; ``width`` in inches, None for the usual one."""

    heading: str
    unit: str
    style: Style
    width: float | None


def plot(
    subject: Subject,
    quantity: str | Sequence[str] = "surface",
    *,
    view: ViewName = "iso",
    net: bool = False,
    lines: int | str | Lines = 7,
    at: Sequence[tuple[float, float]] = (),
    unit: str = "",
    heading: str = "",
    style: str | Style = "standard",
    title: bool | None = None,
    caption: bool | None = None,
    limits: tuple[float, float] | None = None,
    percentiles: tuple[float, float] | None = None,
    colours: str | None = None,
    levels: int | Sequence[float] | None = None,
    font: str | None = None,
    size: float | None = None,
    width: float | str | None = None,
    axes: Any = None,
    save: str | Path | None = None,
) -> Figure:
    """Return a picture of a surface, patch, model, curve, several curves, sample, scan or deviation, by matplotlib.

    ``quantity`` is a key or symbol of the table, several for pictures side by side, "surface" for the plain one,
    "zebra" for stripes that are reflected; for curves "curve", "comb", "hull", "curvature" or "torsion", the last two
    over arc length where the curves go on end to end. ``view`` is iso, side, back, top, all, flat (a map over u and v)
    or (azimuth, elevation) in degrees. ``net`` draws the control net, ``lines`` so many parameter lines each way, or
    lines of a kind such as "curvature", or ``Lines`` that were found before. ``at`` marks parameters. ``unit`` and
    ``heading`` are those of a model where it is one. ``style`` is "standard", "journal" or a ``Style``, of which title,
    caption, limits, percentiles, colours, levels, font and size (points) change what they name. ``width`` is in inches,
    or "84 mm", "column", "page". With ``axes`` of matplotlib the picture alone is drawn there. ``save`` writes a .png,
    .svg, .pdf or .eps. Raises ValueError for what cannot be drawn.
    """
    chosen = changed(
        style_named(style) if isinstance(style, str) else style,
        title=title,
        caption=caption,
        limits=limits,
        percentiles=percentiles,
        colours=colours,
        levels=levels if levels is None or isinstance(levels, int) else tuple(levels),
        font=font,
        size=size,
    )
    names = [quantity] if isinstance(quantity, str) else list(quantity)
    page = _page(subject, heading, unit, chosen, None if width is None else inches(width))
    if isinstance(subject, Sample):
        figure = _of_sample(subject, names, page, axes)
    elif isinstance(subject, Scan | ScanCurvature | Deviation):
        figure = _of_points(subject, names, view, page, axes)
    elif isinstance(subject, Surface | Patch) or (isinstance(subject, Model) and subject.patches):
        surfaces = _surfaces(subject)
        if names == ["zebra"] and axes is None and view not in ("all", "flat"):
            seen, across = read_view(view), page.width or 6.4
            figure = zebra_picture(
                surfaces, view=seen, title=page.heading, unit=page.unit, width=across, style=page.style
            )
            if save is not None:
                write(figure, save)
            return figure
        keys = read_quantities(names)
        scene = Scene(
            read_view(view, ("all", "flat")),
            net=net,
            isolines=lines if isinstance(lines, int) else 0,
            traces=(
                *(() if isinstance(lines, int) else traces_of(subject, lines)),
                *(_beside(subject) if view != "flat" else ()),
            ),
            marks=_marks(at),
            normal=None in keys and view != "all" and len(surfaces) <= _ARROWS,
        )
        if axes is not None:
            figure = _on_axes(axes, surfaces, keys, thinned(scene, len(surfaces)), view, page)
        elif view == "flat":
            figure = _flat(surfaces, keys, scene.marks, page)
        else:
            figure = _space(surfaces, keys, view, scene, page)
    else:
        figure = _of_curves(subject, names, page)
    if save is not None:
        write(figure, save)
    return figure


def read_quantities(names: Sequence[str]) -> list[str | None]:
    """Return the keys of quantities, None for the plain surface; ValueError for what no colour shows."""
    if "zebra" in names:
        raise ArgumentError("zebra stripes are drawn alone, in one view in space", "quantity")
    keys = [None if name == "surface" else row(name).key for name in names]
    for key in keys:
        if key is not None and row(key).kind == "vector":
            raise ArgumentError(f"{key!r} is a vector, which no colour shows", "quantity")
    return keys


def read_view(view: ViewName, others: Sequence[str] = ()) -> View:
    """Return a view by its name or as azimuth and elevation in degrees, a pair or text; ValueError for others.

    ``others`` are names of more than a view, which are seen obliquely.
    """
    if view in others:
        return ISO
    if isinstance(view, str) and view in VIEWS:
        return VIEWS[view]
    try:
        azimuth, elevation = map(real, view.split(",")) if isinstance(view, str) else view
    except ValueError:
        names = ", ".join([*VIEWS, *others])
        raise ArgumentError(
            f"expected {names} or AZIMUTH,ELEVATION in degrees, got {str(view)[:40]!r}", "view"
        ) from None
    if not (-360.0 <= azimuth <= 360.0 and -90.0 <= elevation <= 90.0):
        found = f"{azimuth:g},{elevation:g}"
        raise ArgumentError(f"expected an azimuth within ±360 and an elevation within ±90 degrees, got {found}", "view")
    return View(f"view from azimuth {azimuth:g}°, elevation {elevation:g}°", azimuth, elevation)


def _page(subject: Subject, heading: str, unit: str, style: Style, width: float | None) -> _Page:
    """Return what a page says, from the subject where nothing is said of it."""
    named = subject.name if isinstance(subject, Patch | Model | Scan) else ""
    of_model = subject.unit if isinstance(subject, Model) else ""
    return _Page(heading or named, unit or of_model, style, width)


def _of_points(
    subject: Scan | ScanCurvature | Deviation, names: Sequence[str], view: ViewName, page: _Page, axes: Any
) -> Figure:
    """Return a scan, coloured by its curvature where quantities are named, or a deviation."""
    if axes is not None:
        raise ArgumentError("a scan and a deviation have a figure of their own; leave the axes out", "axes")
    width = page.width or 8.0
    if isinstance(subject, Deviation):
        return deviation_picture(subject, page.heading, width, style=page.style)
    keys = [key for key in read_quantities(names) if key is not None]
    found = scan_curvature(subject) if keys and isinstance(subject, Scan) else subject
    return page.style.finish(scan_picture(found, keys, view=read_view(view), title=page.heading, width=width))


def _surfaces(subject: Surface | Patch | Model) -> list[Surface]:
    if isinstance(subject, Surface):
        return [subject]
    return [patch.surface for patch in (subject.patches if isinstance(subject, Model) else (subject,))]


def _beside(subject: Subject) -> tuple[Trace, ...]:
    """Return what is drawn of the curves that a model has beside its surfaces."""
    curves = subject.curves if isinstance(subject, Model) else ()
    return tuple(curve_traces([one.curve for one in curves], [one.name for one in curves]))


def _marks(at: Sequence[tuple[float, float]]) -> tuple[Mark, ...]:
    for u, v in at:
        parameter(u, "u")
        parameter(v, "v")
    return tuple(Mark(u, v, f"P{i + 1}" if len(at) > 1 else "P") for i, (u, v) in enumerate(at))


def _flat(surfaces: Sequence[Surface], keys: Sequence[str | None], marks: tuple[Mark, ...], page: _Page) -> Figure:
    wanted = [key for key in keys if key is not None]
    if not wanted:
        raise ArgumentError("a flat map needs a quantity, such as gaussian", "quantity")
    if len(surfaces) > 1:
        raise ArgumentError(f"a flat map shows one surface, found {len(surfaces)}; choose a patch", "subject")
    surface, width, title, style = surfaces[0], page.width, page.heading, page.style
    if len(wanted) == 1:
        return flat_map(surface, wanted[0], marks=marks, title=title, unit=page.unit, width=width or 5.0, style=style)
    return map_panels(surface, wanted, marks=marks, title=title, unit=page.unit, width=width or 9.0, style=style)


def _space(
    surfaces: Sequence[Surface], keys: Sequence[str | None], view: ViewName, scene: Scene, page: _Page
) -> Figure:
    title, unit, style = page.heading, page.unit, page.style
    if view == "all":
        if len(keys) > 1:
            raise ArgumentError("expected one for all views, got several", "quantity")
        return projections(surfaces, keys[0], scene, title=title, unit=unit, width=page.width or 9.0, style=style)
    if len(keys) == 1:
        return space_picture(surfaces, keys[0], scene, title=title, unit=unit, width=page.width or 6.4, style=style)
    return panels(surfaces, keys, scene, title=title, unit=unit, width=page.width or 9.0, style=style)


def _on_axes(
    axes: Any, surfaces: Sequence[Surface], keys: Sequence[str | None], scene: Scene, view: ViewName, page: _Page
) -> Figure:
    """Draw one picture on axes that are there."""
    if len(keys) != 1 or view == "all":
        raise ValueError("axes: expected one quantity and one view, got several")
    key, style = keys[0], page.style
    if view == "flat":
        if key is None or len(surfaces) != 1:
            raise ValueError("axes: a flat map shows one quantity of one surface")
        fields = map_fields(surfaces, key)
        stretch = common_limits(fields, style)
        draw_map(axes, surfaces[0], fields[0], stretch, scene.marks, levels=levels_of(style, stretch))
        return axes.figure
    fields = facet_fields(surfaces, key, scene.cells)
    stretch = common_limits(fields, style)
    levels = levels_of(style, stretch)
    draw_space(axes, surfaces, scene, fields=fields, stretch=stretch, unit=page.unit, levels=levels)
    return axes.figure


def _of_sample(sample: Sample, names: Sequence[str], page: _Page, axes: Any) -> Figure:
    """Draw the values of a sample on a grid as a map over the parameters, with nothing computed anew."""
    u, v, style = sample.u, sample.v, page.style
    on_grid = u.ndim == v.ndim == 2 and u.shape[1] == v.shape[0] == 1
    if not on_grid or len(names) != 1 or names[0] == "surface":
        raise ValueError(
            "a sample is drawn as a map of one quantity on a grid, such as plot(analyse(surface, *grid(60, 60)), "
            "'gaussian'); plot(surface, ...) draws the others"
        )
    _ = read_quantities(names)
    q = row(names[0])
    values = sample[q.key]
    finite = np.abs(values[np.isfinite(values)].astype(np.float64))
    scale = natural_scale(sample, q) if "curvedness" in sample.values else float(finite.max(initial=0.0))
    inside = np.broadcast_to(sample.surface.inside(u, v), sample.shape)
    field = Field(q, u[:, 0], v[0], values, scale, np.full(sample.shape, SAME_COLOUR * scale), inside)
    stretch = common_limits([field], style)
    if axes is not None:
        draw_map(axes, sample.surface, field, stretch, zeros={})
        return axes.figure
    key_size = key_width([field])
    side = (page.width or 5.0) / style.factor - key_size - 0.2
    drawn = sheet(1, (side, side), title=page.heading, key="right", key_size=key_size, style=style)
    draw_map(map_axes(drawn.panels[0]), sample.surface, field, stretch, zeros={})
    draw_key(drawn.keys[0], [field], stretch, page.unit)
    return style.finish(drawn.figure)


def _of_curves(subject: Curve | Sequence[Curve] | Model, names: Sequence[str], page: _Page) -> Figure:
    if isinstance(subject, Model):
        curves, labels = [one.curve for one in subject.curves], [one.label for one in subject.curves]
        labels = [f"{one.name}: {one.label}" for one in subject.curves] if len(curves) > 1 else labels
    else:
        curves = [subject] if isinstance(subject, Curve) else list(subject)
        labels: list[str] = []
    if not curves:
        raise ArgumentError("expected at least one curve, found none", "subject")
    what = "curve" if list(names) == ["surface"] else names[0]
    if len(names) > 1 or what not in CURVE_PICTURES:
        found = ",".join(names)[:40]
        raise ArgumentError(f"expected, for curves, one of {', '.join(CURVE_PICTURES)}, got {found!r}", "quantity")
    width, title, unit, style = page.width or 5.0, page.heading, page.unit, page.style
    if what in ("curvature", "torsion"):
        along = curvature_plot if what == "curvature" else torsion_plot
        return along(curves, labels, title=title, unit=unit, width=width, style=style)
    draw = plane_curves if all(curve.points.shape[1] == 2 for curve in curves) else space_curves
    hull, comb = what == "hull", what == "comb"
    return draw(curves, labels, hull=hull, comb=comb, title=title, unit=unit, width=width, style=style)
