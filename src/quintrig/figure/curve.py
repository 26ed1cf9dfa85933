"""Plane curves and basis functions: families with control polygon and convex hull, curvature combs."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from quintrig.basis.functions import Functions
from quintrig.basis.pairs import symbol
from quintrig.figure.legend import draw_class_list, list_height
from quintrig.figure.palette import INK, SEQUENTIAL, SERIES
from quintrig.figure.sheet import Area, Axes, KeyPlace, sheet
from quintrig.figure.style import STANDARD, Style
from quintrig.figure.wording import exponent, number_text, with_unit
from quintrig.geometry.curve import Curve
from quintrig.support.arrays import FloatArray

_SIZE = 8.0
POLYGON = "#8a8a8a"
"""Colour of control polygons."""
SAMPLES = 401
"""Points of a drawn curve."""
MARGIN = (0.62, 0.42, 0.08, 0.08)
"""Inches for numbers and names: left, bottom, right, top."""


def basis_functions(
    bases: Sequence[Functions],
    titles: Sequence[str] = (),
    *,
    title: str = "",
    columns: int = 2,
    width: float = 6.4,
    style: Style = STANDARD,
) -> Figure:
    """Return the basis functions f_0, f_1, ... over t, one panel for each basis, as the thesis's figure 2.1."""
    width = style.across(width)
    columns = max(1, min(columns, len(bases)))
    each = (width - 0.2 - 0.12 * (columns - 1)) / columns
    page = sheet(len(bases), (each, 0.68 * each), columns=columns, titles=titles, title=title, style=style)
    t = np.linspace(0.0, 1.0, SAMPLES)
    for area, basis in zip(page.panels, bases, strict=True):
        axes = plot_axes(area)
        values = basis.derivatives(t, 0)[0]
        for i in range(basis.size):
            colour = SERIES[i % len(SERIES)]
            axes.plot(t, values[:, i], color=colour, linewidth=1.6, zorder=3)
            top = int(np.argmax(values[:, i]))
            side, shift = ("left", 5.0) if top < 20 else ("right", -5.0) if top > SAMPLES - 21 else ("center", 0.0)
            axes.annotate(
                f"$f_{i}$",
                xy=(t[top], values[top, i]),
                xytext=(shift, 2.5),
                textcoords="offset points",
                color=colour,
                fontsize=_SIZE + 1.0,
                ha=side,
                va="bottom",
                annotation_clip=False,
            )
        axes.set_xlim(0.0, 1.0)
        axes.set_ylim(min(0.0, 1.1 * float(values.min())), 1.12 * float(values.max()))
        dress(axes, "$t$", "")
    return style.finish(page.figure)


def plane_curves(
    curves: Sequence[Curve],
    labels: Sequence[str] = (),
    *,
    polygon: bool = True,
    hull: bool = False,
    comb: bool = False,
    title: str = "",
    unit: str = "",
    width: float = 5.0,
    style: Style = STANDARD,
    axes: Axes = None,
) -> Figure:
    """Return plane curves in one picture, such as a family with varying α or ζ, as the thesis's figures 2.2 and 2.3.

    ``polygon`` draws each different control polygon with its points P_0, P_1, ..., ``hull`` their convex hull,
    ``comb`` the curvature combs, all to one scale. With ``axes`` the picture alone is drawn there. Raises ValueError
    for curves in space.
    """
    width = style.across(width)
    labels = labels or automatic_labels(curves)
    if any(curve.points.shape[1] != 2 for curve in curves):
        raise ValueError("plane_curves: expected plane curves (n x 2 points), found one in space; use space_curves")
    tips = combs(curves) if comb else []
    cloud = [curve(np.linspace(0.0, 1.0, SAMPLES)) for curve in curves] + tips
    cloud += [curve.points for curve in curves] if polygon or hull else []
    points = np.concatenate(cloud)
    low, high = np.nanmin(points, axis=0), np.nanmax(points, axis=0)
    if style.box is not None:
        low, high = np.array(style.box)
    spread = np.maximum(high - low, 1e-3 * max(float(np.max(high - low)), 1e-300))
    shape = float(np.clip(spread[1] / spread[0], 0.3, 1.3))
    inner = width - 0.2 - MARGIN[0] - MARGIN[2]
    panel = (width - 0.2, shape * inner + MARGIN[1] + MARGIN[3])
    text = f"Lengths in {unit}" if unit else "No unit of length given"
    if comb:
        text += "; teeth of the comb point away from the centre of curvature, all to one scale"
    text = ". ".join([text, *(line for curve in curves[:1] for line in origin_note(curve))])
    page = None
    if axes is None:
        key: KeyPlace = "below" if labels else "none"
        key_size = list_height(labels, width)
        page = sheet(1, panel, title=title, note=text, key=key, key_size=key_size, style=style)
        axes = plot_axes(page.panels[0])
    colours = family_colours(len(curves))
    if hull:
        for curve in different(curves):
            _hull(axes, curve.points)
    if polygon:
        for curve in different(curves):
            _polygon(axes, curve.points)
    for index, curve in enumerate(curves):
        draw_curve(axes, curve, colours[index], tips[index] if comb else None)
    _equal(axes, low, high)
    power = exponent(float(np.abs(points[np.isfinite(points)]).max()))
    dress(axes, with_unit("x", unit, power), with_unit("y", unit, power), power)
    if page is None:
        return style.dress(axes)
    if labels:
        draw_class_list(page.keys[0], "", labels, colours)
    return style.finish(page.figure)


def draw_curve(axes: Axes, curve: Curve, colour: str = SERIES[0], comb: FloatArray | None = None) -> None:
    """Draw a plane curve, and its comb where the tips of the teeth (201, 2) are given."""
    line = curve(np.linspace(0.0, 1.0, SAMPLES))
    axes.plot(line[:, 0], line[:, 1], color=colour, linewidth=1.7, zorder=4, solid_capstyle="round")
    if comb is None:
        return
    feet = curve(np.linspace(0.0, 1.0, len(comb)))
    for foot, tip in zip(feet[::2], comb[::2], strict=True):
        axes.plot([foot[0], tip[0]], [foot[1], tip[1]], color=colour, linewidth=0.4, alpha=0.7, zorder=2)
    axes.plot(comb[:, 0], comb[:, 1], color=colour, linewidth=0.9, zorder=3)


def family_colours(count: int) -> list[str]:
    """Return distinct colours for up to three curves, else ones from light to dark in the order of the family."""
    if count <= 3:
        return list(SERIES[:count])
    shades: Any = SEQUENTIAL(np.linspace(0.3, 1.0, count))
    return [to_hex(shade) for shade in shades]


def automatic_labels(curves: Sequence[Curve]) -> list[str]:
    """Return the shape parameters of curves by their letters, to tell them apart; none where no curve has any."""
    found = [dict(curve.functions.parameters) for curve in curves]
    labels = [", ".join(f"{symbol(name)} = {value:g}" for name, value in one.items()) for one in found]
    return labels if any(labels) else []


def origin_note(curve: Curve) -> list[str]:
    """Return what a reader of a picture of a curve must be warned of, of its basis."""
    return [line.rstrip(".") for line in curve.caveats]


def combs(curves: Sequence[Curve]) -> list[FloatArray]:
    """Return the tips (201, 2 or 3) of the combs of curves, all to one scale."""
    t = np.linspace(0.0, 1.0, 201)
    bends = [float(np.nanmax(curve.curvature(t), initial=0.0)) for curve in curves]
    size = max(float(np.linalg.norm(np.ptp(curve.points, axis=0))) for curve in curves)
    scale = 0.22 * size / max(bends) if max(bends) > 0.0 else 0.0
    return [curve.comb(t, scale) for curve in curves]


def different(curves: Sequence[Curve]) -> list[Curve]:
    """Return one curve for each different set of control points."""
    kept: list[Curve] = []
    for curve in curves:
        if not any(np.array_equal(curve.points, other.points) for other in kept):
            kept.append(curve)
    return kept


def _polygon(axes: Axes, points: FloatArray) -> None:
    axes.plot(points[:, 0], points[:, 1], color=POLYGON, linewidth=0.9, zorder=2.5)
    axes.scatter(points[:, 0], points[:, 1], s=15, facecolor="white", edgecolor=INK, linewidth=0.8, zorder=5)
    middle = points.mean(axis=0)
    for i, point in enumerate(points):
        away = point - middle
        away = away / max(float(np.linalg.norm(away)), 1e-300)
        axes.annotate(
            f"$P_{{{i}}}$",
            xy=point,
            xytext=8.0 * away,
            textcoords="offset points",
            fontsize=_SIZE,
            color=INK,
            ha="center",
            va="center",
            annotation_clip=False,
            zorder=6,
        )


def _hull(axes: Axes, points: FloatArray) -> None:
    from scipy.spatial import ConvexHull, QhullError  # takes long to import

    try:
        outline = points[ConvexHull(points).vertices]
    except QhullError:  # all points on one line: the polygon is the hull
        return
    axes.fill(outline[:, 0], outline[:, 1], facecolor="#e9eef3", edgecolor="#b9c4cf", linewidth=0.6, zorder=1)


def plot_axes(area: Area) -> Axes:
    """Return axes on an area with room for their numbers and names."""
    left, bottom, right, top = MARGIN
    return area.inside(left, bottom, area.width - left - right, area.height - bottom - top)


def _equal(axes: Axes, low: FloatArray, high: FloatArray) -> None:
    """Set limits around a box with equal scales, with a rim for labels."""
    box = axes.get_position(original=True)
    wide, tall = axes.figure.get_size_inches() * [box.width, box.height]
    scale = 1.14 * max(float(high[0] - low[0]) / wide, float(high[1] - low[1]) / tall)
    scale = scale if scale > 0.0 else 1.0
    x, y = 0.5 * (low + high)
    axes.set_xlim(x - 0.5 * scale * wide, x + 0.5 * scale * wide)
    axes.set_ylim(y - 0.5 * scale * tall, y + 0.5 * scale * tall)


def dress(axes: Axes, x: str, y: str, power_x: int = 0, power_y: int | None = None) -> None:
    """Set the names, numbers and lines of a diagram's axes, given the power of ten of each."""
    axes.xaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 2.5, 5, 10]))
    axes.yaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 2.5, 5, 10]))
    axes.xaxis.set_major_formatter(_numbers(power_x))
    axes.yaxis.set_major_formatter(_numbers(power_x if power_y is None else power_y))
    axes.tick_params(labelsize=_SIZE - 0.5, labelcolor=INK, length=2.5, width=0.5, color="#8a8a8a", pad=2.5)
    axes.set_xlabel(x, fontsize=_SIZE + 0.5, color=INK, labelpad=2.0)
    axes.set_ylabel(y, fontsize=_SIZE + 0.5, color=INK, labelpad=3.0)
    axes.grid(visible=True, color="#ececec", linewidth=0.6, zorder=0)
    axes.set_axisbelow(True)
    for spine in axes.spines.values():
        spine.set(linewidth=0.6, edgecolor="#8a8a8a")


def _numbers(power: int) -> Callable[[float, int], str]:
    def text(value: float, place: int) -> str:
        return number_text(value, power)

    return text
