"""``quintrig.plot``: one function for a picture of anything that has one."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from quintrig.analysis.sample import Sample
from quintrig.figure.along import curvature_plot, torsion_plot
from quintrig.figure.camera import ViewName, read_view
from quintrig.figure.compared import projections
from quintrig.figure.curve import plane_curves
from quintrig.figure.deviation import deviation_picture
from quintrig.figure.field import Field, common_limits, facet_fields, levels_of, natural_scale
from quintrig.figure.flat import draw_map, map_axes, map_fields
from quintrig.figure.legend import draw_key, key_room
from quintrig.figure.read_lines import staged, traces_of
from quintrig.figure.save import DPI, kind_of
from quintrig.figure.save import save as write
from quintrig.figure.scan import scan_picture
from quintrig.figure.scene import Scene, Trace, thinned
from quintrig.figure.sheet import sheet
from quintrig.figure.space import draw_space
from quintrig.figure.space_curves import curve_traces, space_curves
from quintrig.figure.style import Style, changed, style_named
from quintrig.figure.whole import flat_map, map_panels, panels, space_picture
from quintrig.figure.zebra import zebra_picture
from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.interrogation.line import Line, Lines
from quintrig.model.model import Model
from quintrig.model.patch import NamedCurve, Patch
from quintrig.quantities.drawn import read_quantities
from quintrig.quantities.table import quantity as row
from quintrig.scan.curvature import ScanCurvature, scan_curvature
from quintrig.scan.deviation import Deviation
from quintrig.scan.scan import Scan
from quintrig.support.errors import ArgumentError, nearest
from quintrig.support.tolerance import SAME_COLOUR

Subject = (
    Surface
    | Patch
    | Model
    | Curve
    | NamedCurve
    | Sequence[Curve | NamedCurve]
    | Sample
    | Lines
    | Line
    | Scan
    | ScanCurvature
    | Deviation
)

CURVE_PICTURES = ("curve", "comb", "hull", "curvature", "torsion")
"""What is drawn of curves."""

_SYMBOLS = {"κ": "curvature", "kappa": "curvature", "τ": "torsion", "tau": "torsion"}

_ARROWS = 8  # patches of which each shows its normal; of more the arrows would hide them


@dataclass(frozen=True)
class _Page:
    """What is the same whatever is drawn."""

    heading: str
    unit: str
    style: Style


def plot(
    subject: Subject,
    quantity: str | Sequence[str] = "surface",
    *,
    view: ViewName | None = None,
    net: bool | None = None,
    lines: int | str | Lines | None = None,
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
    """Return a picture of a surface, patch, model, curve, sample, lines, scan or deviation by matplotlib.

    ``quantity`` is a key or symbol of the table, several for pictures side by side, "surface" for the plain one,
    "zebra" for stripes that are reflected; for curves "curve", "comb", "hull", "curvature" or "torsion", the last two
    over arc length where the curves go on end to end. ``view`` is iso, side, back, top, all, flat (a map over u and v)
    or (azimuth, elevation) in degrees. ``net`` draws the control net, ``lines`` so many parameter lines each way, 7 if
    not said, or lines of a kind such as "curvature", or ``Lines`` that were found before. ``at`` marks parameters.
    ``unit`` and ``heading`` are those of a model where it is one. ``style`` is "standard", "journal" or a ``Style``, of
    which title, caption, limits, percentiles, colours, levels, font, size (points) and what stands before change what
    they name. ``width`` is in inches, or "84 mm", "column", "page". With ``axes`` of matplotlib the picture alone is
    drawn there. ``save`` writes a .png, .svg, .pdf or .eps. Raises ValueError for what cannot be drawn.
    """
    seen = None if view is None else read_view(view, ("all", "flat"))
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
        view=None if view in ("all", "flat") else seen,
        net=net,
        lines=None if isinstance(lines, Lines) else lines,
        at=tuple(at) or None,
        width=width,
    )
    if save is not None:
        kind_of(save)
    names = [quantity] if isinstance(quantity, str) else list(quantity)
    several = view if view in ("all", "flat") else ""
    figure = _figure(subject, names, str(several), lines, _page(subject, heading, unit, chosen), axes)
    if save is not None:
        write(figure, save, chosen.dpi or DPI)
    return figure


def _figure(
    subject: Subject, names: Sequence[str], several: str, lines: int | str | Lines | None, page: _Page, axes: Any
) -> Figure:
    """Draw what a subject is; ``several`` is "all" or "flat" where one view is not enough."""
    if isinstance(subject, Sample):
        return _of_sample(subject, names, page, axes)
    if isinstance(subject, Surface | Patch) or (isinstance(subject, Model) and subject.patches):
        return _of_surfaces(subject, names, several, lines, page, axes)
    if axes is not None:
        raise ArgumentError("expected a surface, patch, model of surfaces or sample to draw there", "axes")
    if several:
        raise ArgumentError(f"expected one view in space, got {several!r}: it belongs to surfaces", "view")
    if isinstance(subject, Deviation):
        return deviation_picture(subject, page.heading, style=page.style)
    if isinstance(subject, Scan | ScanCurvature):
        keys = [key for key in read_quantities(names) if key is not None]
        subject = scan_curvature(subject) if keys and isinstance(subject, Scan) else subject
        return scan_picture(subject, keys, title=page.heading, style=page.style)
    if isinstance(subject, Lines | Line):
        drawn = Lines(subject.label, (subject,), "", "", page.unit, 0.0) if isinstance(subject, Line) else subject
        if list(names) != ["surface"]:
            raise ArgumentError(f"expected nothing else for lines, got {','.join(names)[:40]!r}", "quantity")
        if not len(drawn):
            raise ArgumentError("expected at least one line, found none", "subject")
        scene = Scene(traces=traces_of(None, drawn))
        return space_picture([], None, scene, title=page.heading, unit=page.unit, style=page.style)
    return _of_curves(subject, names, page)


def _of_surfaces(
    subject: Surface | Patch | Model,
    names: Sequence[str],
    several: str,
    lines: int | str | Lines | None,
    page: _Page,
    axes: Any,
) -> Figure:
    style, surfaces = page.style, _surfaces(subject)
    _refuse_pictures_of_curves(subject, names)
    if list(names) == ["zebra"] and axes is None and not several:
        return zebra_picture(surfaces, title=page.heading, unit=page.unit, style=style)
    keys = read_quantities(names)
    wanted = style.lines if lines is None else lines
    # Lines run on from patch to patch of a model, which a style does not know.
    kinds = wanted if isinstance(wanted, str | Lines) else None
    scene = Scene(
        isolines=7 if wanted is None else 0,
        traces=(
            *(traces_of(subject, kinds) if kinds is not None else ()),
            *(_beside(subject) if several != "flat" else ()),
        ),
        normal=None in keys and several != "all" and len(surfaces) <= _ARROWS,
    )
    page = replace(page, style=replace(style, lines=None) if kinds is not None else style)
    if axes is not None:
        return _on_axes(axes, surfaces, keys, scene, several, page)
    if several == "flat":
        return _flat(surfaces, keys, page)
    return _space(surfaces, keys, several, scene, page)


def _refuse_pictures_of_curves(subject: Surface | Patch | Model, names: Sequence[str]) -> None:
    """Raise ValueError where surfaces are to be drawn as curves are, naming the curves that there are."""
    wrong = next((name for name in names if name in CURVE_PICTURES), None)
    if wrong is None:
        return
    curves = [one.name for one in subject.curves] if isinstance(subject, Model) else []
    shown = " or ".join(curves[:3])
    raise ArgumentError(
        f"{wrong!r} is drawn of curves, and {'the model has surfaces too' if curves else 'here are surfaces'}",
        "quantity",
        remedy=f"choose the curve {shown} alone" if curves else "draw a quantity, such as gaussian or mean",
    )


def _page(subject: Subject, heading: str, unit: str, style: Style) -> _Page:
    """Return what a page says, from the subject where nothing is said of it."""
    scan = subject.scan if isinstance(subject, ScanCurvature) else subject
    named = scan.name if isinstance(scan, Patch | NamedCurve | Model | Scan) else ""
    its = scan.unit if isinstance(scan, Model | Lines | Scan) else ""
    return _Page(heading or named, unit or its, style)


def _surfaces(subject: Surface | Patch | Model) -> list[Surface]:
    if isinstance(subject, Surface):
        return [subject]
    return [patch.surface for patch in (subject.patches if isinstance(subject, Model) else (subject,))]


def _beside(subject: Subject) -> tuple[Trace, ...]:
    """Return what is drawn of the curves that a model has beside its surfaces."""
    curves = subject.curves if isinstance(subject, Model) else ()
    return tuple(curve_traces([one.curve for one in curves], [one.name for one in curves]))


def _flat(surfaces: Sequence[Surface], keys: Sequence[str | None], page: _Page) -> Figure:
    wanted = [key for key in keys if key is not None]
    if not wanted:
        raise ArgumentError("a flat map needs a quantity, such as gaussian", "quantity")
    if len(surfaces) > 1:
        raise ArgumentError(f"a flat map shows one surface, found {len(surfaces)}; choose a patch", "subject")
    if len(wanted) == 1:
        return flat_map(surfaces[0], wanted[0], title=page.heading, unit=page.unit, style=page.style)
    return map_panels(surfaces[0], wanted, title=page.heading, unit=page.unit, style=page.style)


def _space(surfaces: Sequence[Surface], keys: Sequence[str | None], several: str, scene: Scene, page: _Page) -> Figure:
    title, unit, style = page.heading, page.unit, page.style
    if several == "all":
        if len(keys) > 1:
            raise ArgumentError("expected one for all views, got several", "quantity")
        return projections(surfaces, keys[0], scene, title=title, unit=unit, style=style)
    if len(keys) == 1:
        return space_picture(surfaces, keys[0], scene, title=title, unit=unit, style=style)
    return panels(surfaces, keys, scene, title=title, unit=unit, style=style)


def _on_axes(
    axes: Any, surfaces: Sequence[Surface], keys: Sequence[str | None], scene: Scene, several: str, page: _Page
) -> Figure:
    """Draw one picture on axes that are there."""
    if len(keys) != 1 or several == "all":
        raise ValueError("axes: expected one quantity and one view, got several")
    key, style = keys[0], page.style
    scene = thinned(staged(scene, style, surfaces), len(surfaces))
    if several == "flat":
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
    width = style.across(5.0)
    place, key_size = key_room([field], width)
    side = width - 0.2 - (key_size if place == "right" else 0.0)
    drawn = sheet(1, (side, side), title=page.heading, key=place, key_size=key_size, style=style)
    draw_map(map_axes(drawn.panels[0]), sample.surface, field, stretch, zeros={})
    draw_key(drawn.keys[0], [field], stretch, page.unit)
    return style.finish(drawn.figure)


def curve_picture(names: Sequence[str], known: Sequence[str] = CURVE_PICTURES, of: str = "curves") -> str:
    """Return which of the ``known`` pictures of curves a name or symbol asks for; ValueError for others."""
    found = ",".join(names)[:40]
    what = "curve" if list(names) == ["surface"] else _SYMBOLS.get(found, found)
    if what not in known:
        hint = nearest(found, known)
        raise ArgumentError(f"expected, for {of}, one of {', '.join(known)}, got {found!r}{hint}", "quantity")
    return what


def _of_curves(
    subject: Curve | NamedCurve | Sequence[Curve | NamedCurve] | Model, names: Sequence[str], page: _Page
) -> Figure:
    if isinstance(subject, Curve | NamedCurve):
        parts: list[Curve | NamedCurve] = [subject]
    else:
        parts = list(subject.curves) if isinstance(subject, Model) else list(subject)
    curves = [one.curve if isinstance(one, NamedCurve) else one for one in parts]
    named = [one for one in parts if isinstance(one, NamedCurve)]
    labels = [one.label if len(parts) == 1 else f"{one.name}: {one.label}" for one in named]
    labels = labels if len(named) == len(parts) else []
    if not curves:
        raise ArgumentError("expected at least one curve, found none", "subject")
    what = curve_picture(names)
    title, unit, style = page.heading, page.unit, page.style
    if what in ("curvature", "torsion"):
        along = curvature_plot if what == "curvature" else torsion_plot
        return along(curves, labels, title=title, unit=unit, style=style)
    draw = plane_curves if all(curve.points.shape[1] == 2 for curve in curves) else space_curves
    hull, comb = what == "hull", what == "comb"
    return draw(curves, labels, hull=hull, comb=comb, title=title, unit=unit, style=style)
