"""Curvature and torsion along curves: over t, or over arc length across the joins of curves that go on end to end."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

import numpy as np
from matplotlib.figure import Figure

from quintrig.figure.curve import POLYGON, SAMPLES, automatic_labels, dress, family_colours, origin_note, plot_axes
from quintrig.figure.legend import draw_class_list, list_height
from quintrig.figure.sheet import Axes, KeyPlace, sheet
from quintrig.figure.style import STANDARD, Style
from quintrig.figure.wording import exponent, number_text, with_unit
from quintrig.geometry.curve import Curve
from quintrig.support.arrays import FloatArray

_PANELS = 200  # of arc length
_MEETING = 1e-9  # of the size: ends nearer than this are one


def joined(curves: Sequence[Curve]) -> bool:
    """Return whether two or more curves go on end to end, each from the last point of the one before it."""
    size = max((float(np.ptp(curve.points, axis=0).max()) for curve in curves), default=0.0)
    ends = [curve.points[[0, -1]] for curve in curves]
    gaps = [float(np.linalg.norm(a[1] - b[0])) for a, b in pairwise(ends)]
    return bool(gaps) and max(gaps) <= _MEETING * size


def curvature_plot(
    curves: Sequence[Curve],
    labels: Sequence[str] = (),
    *,
    title: str = "",
    unit: str = "",
    width: float = 5.0,
    style: Style = STANDARD,
    axes: Axes = None,
) -> Figure:
    """Return the curvature over t, or over arc length across joins where two or more curves go on end to end.

    Signed, positive where the curve turns left, if all are plane curves. With ``axes`` the picture
    alone is drawn there.
    """
    return _along(curves, labels, "curvature", title, unit, width, style, axes)


def torsion_plot(
    curves: Sequence[Curve],
    labels: Sequence[str] = (),
    *,
    title: str = "",
    unit: str = "",
    width: float = 5.0,
    style: Style = STANDARD,
    axes: Axes = None,
) -> Figure:
    """Return the torsion over t, or over arc length across joins; nought for plane curves."""
    return _along(curves, labels, "torsion", title, unit, width, style, axes)


def _along(
    curves: Sequence[Curve],
    labels: Sequence[str],
    what: Literal["curvature", "torsion"],
    title: str,
    unit: str,
    width: float,
    style: Style,
    axes: Axes,
) -> Figure:
    width = style.across(width)
    labels = labels or automatic_labels(curves)
    t = np.linspace(0.0, 1.0, SAMPLES)
    plane = all(curve.points.shape[1] == 2 for curve in curves)
    if what == "torsion":
        values = [np.zeros_like(t) if plane else curve.torsion(t) for curve in curves]
    else:
        values = [curve.signed_curvature(t) if plane else curve.curvature(t) for curve in curves]
    chained = joined(curves)
    places, ends = _arc_lengths(curves, t) if chained else ([t] * len(curves), [1.0])
    finite = np.concatenate([v[np.isfinite(v)] for v in values])
    largest = np.abs(finite if style.limits is None else style.limits).max(initial=0.0)
    power = exponent(float(largest))
    notes = ["Positive where the curve turns left"] if plane and what == "curvature" else []
    if what == "torsion":
        notes.append(
            "A plane curve has no torsion" if plane else "Positive where the curve winds as a right-hand screw"
        )
    if chained:
        notes.append(_jumps(values, unit))
    notes += [line for curve in curves[:1] for line in origin_note(curve)]
    page = None
    if axes is None:
        key: KeyPlace = "below" if labels else "none"
        size, key_size = (width - 0.2, 0.55 * width), list_height(labels, width)
        page = sheet(1, size, title=title, note=". ".join(notes), key=key, key_size=key_size, style=style)
        axes = plot_axes(page.panels[0])
    colours = family_colours(len(curves))
    for place, value, colour in zip(places, values, colours, strict=True):
        axes.plot(place, value, color=colour, linewidth=1.5, zorder=3)
    axes.axhline(0.0, color=POLYGON, linewidth=0.7, zorder=2)
    for end in ends[:-1]:
        axes.axvline(end, color=POLYGON, linewidth=0.8, linestyle=(0, (3, 3)), zorder=2)
    axes.set_xlim(0.0, ends[-1])
    if style.limits is not None:
        axes.set_ylim(*style.limits)
    name = "curvature $\\kappa$" if what == "curvature" else "torsion $\\tau$"
    far = exponent(ends[-1])
    dress(
        axes,
        with_unit("arc length $s$", unit, far) if chained else "$t$",
        with_unit(name, f"1/{unit}" if unit else "", power),
        far if chained else 0,
        power,
    )
    if page is None:
        return style.dress(axes)
    if labels:
        draw_class_list(page.keys[0], "", labels, colours)
    return style.finish(page.figure)


def _arc_lengths(curves: Sequence[Curve], t: FloatArray) -> tuple[list[FloatArray], list[float]]:
    """Return the arc length from the first point at parameters of each curve, and at the end of each."""
    places: list[FloatArray] = []
    ends: list[float] = []
    start = 0.0
    knots = np.linspace(0.0, 1.0, _PANELS + 1)
    for curve in curves:
        steps = [curve.length(a, b) for a, b in zip(knots[:-1].tolist(), knots[1:].tolist(), strict=True)]
        along = start + np.concatenate([[0.0], np.cumsum(steps)])
        places.append(np.interp(t, knots, along))
        start = float(along[-1])
        ends.append(start)
    return places, ends


def _jumps(values: Sequence[FloatArray], unit: str) -> str:
    """Say by how much the values jump at the joins, at most."""
    jumps = [abs(float(b[0] - a[-1])) for a, b in pairwise(values)]
    if not np.isfinite(jumps).all():
        return "Dashed: joins; at one of them it is not defined"
    largest = max(jumps)
    scale = max(float(np.nanmax(np.abs(v))) for v in values)
    jump = number_text(largest) if largest > 1e-9 * scale else "0"
    return f"Dashed: joins; the largest jump there is {jump}{f' 1/{unit}' if unit and jump != '0' else ''}"
