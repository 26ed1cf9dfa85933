"""Parallel coordinates of a sweep: one vertical axis a column, one line a design (Inselberg 1985)."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from quintrig.figure.palette import INK
from quintrig.figure.picture import Picture
from quintrig.figure.wording import exponent, normal_note, number_text, plain, with_unit
from quintrig.geometry.surface import Surface
from quintrig.quantities.table import BY_KEY
from quintrig.support.arrays import FloatArray
from quintrig.sweep.part import column_unit

_MOST = 2000  # lines: more are one dark mass
_SHOWN = (
    "gaussian_min",
    "gaussian_max",
    "mean_min",
    "mean_max",
    "curvedness_max",
    "area",
    "bending_energy",
    "thin_plate_energy",
    "length",
    "curvature_min",
    "curvature_max",
)
_NAMES = {
    "alpha": r"$\alpha$",
    "zeta": r"$\zeta$",
    **{f"{name}{i}": rf"$\{name}_{i}$" for name in ("alpha", "zeta") for i in (1, 2)},
    "scale": r"$\lambda$",
    "area": "area",
    "bending_energy": "bending\nenergy",
    "thin_plate_energy": "thin-plate\nenergy",
    "length": "length",
    "curvature_min": "least\n$\\kappa$",
    "curvature_max": "greatest\n$\\kappa$",
}


def parallel_coordinates(
    rows: Mapping[str, FloatArray],
    parameters: Sequence[str],
    surface: Surface | None,
    *,
    best: str = "",
    unit: str = "",
) -> Figure:
    """Return parallel coordinates of designs, coloured by the column ``best`` or else by the bending energy.

    ``rows`` holds columns (n,) by name, the varied ``parameters`` among them; ``surface`` is any of the designs, for
    the side of the normal, None for those of a curve, and ``unit`` that of length. Of more than 2000 designs, evenly
    spaced ones of the given order are drawn, and the title says so. Raises ValueError where there are no designs.
    """
    total = len(next(iter(rows.values())))
    if total == 0:
        raise ValueError("no design meets the condition, so there is nothing to draw; relax it")
    chosen = np.unique(np.linspace(0, total - 1, min(total, _MOST)).astype(int))
    colour = best or "bending_energy"
    shown = dict.fromkeys((*_SHOWN, colour))

    def measure(name: str) -> str:
        return column_unit(name, unit, surface is None)

    names = [*parameters, *(name for name in shown if name in rows and name not in parameters)]
    heights: list[FloatArray] = []
    figure = Picture(figsize=(1.0 + 1.0 * len(names), 4.6))
    FigureCanvasAgg(figure)
    page: Any = figure  # matplotlib leaves the types of keyword arguments open
    axes: Any = page.add_axes((0.06, 0.16, 0.82, 0.6))
    for place, name in enumerate(names):
        low, high, height = _scaled(rows[name][chosen])
        heights.append(height)
        axes.axvline(place, color=INK, lw=0.8, zorder=3)
        power = _power(low, high)
        for y, value, side in ((0.0, low, "top"), (1.0, high, "bottom")):
            offset = -0.02 if side == "top" else 0.02
            axes.text(place, y + offset, number_text(value, power), ha="center", va=side, fontsize=7.5, color=INK)
        axes.text(place, 1.11, _label(name, measure(name), power), ha="center", va="bottom", fontsize=8.5, color=INK)
    lines = np.stack(
        [np.tile(np.arange(len(names), dtype=float), (len(chosen), 1)), np.stack(heights, axis=1)], axis=-1
    )
    whole = np.isfinite(lines).all(axis=(1, 2))
    scale = np.nan_to_num(heights[names.index(colour)], nan=1.0)
    # The best are drawn last, on top, and darkest.
    order = np.argsort(-scale[whole], kind="stable")
    shades = colormaps["viridis"](0.92 * scale[whole][order])
    opacity = float(np.clip(60.0 / max(1, whole.sum()), 0.08, 0.8))
    axes.add_collection(
        LineCollection(list(lines[whole][order]), colors=shades, linewidths=0.9, alpha=opacity, zorder=2)
    )
    axes.set(xlim=(-0.3, len(names) - 0.7), ylim=(-0.02, 1.02))
    axes.axis("off")
    _colour_key(page, colour, rows[colour][chosen], measure(colour))
    page.text(0.06, 0.955, _title(total, len(chosen), int((~whole).sum())), fontsize=11, color=INK, va="center")
    page.text(0.06, 0.045, _note(surface, unit), fontsize=8, color=INK, va="center")
    return figure


def _scaled(values: FloatArray) -> tuple[float, float, FloatArray]:
    """Return the least and greatest value, and all of them from 0 to 1."""
    finite = values[np.isfinite(values)]
    if not finite.size:
        return np.nan, np.nan, np.full_like(values, np.nan)
    low, high = float(finite.min()), float(finite.max())
    return low, high, (values - low) / (high - low) if high > low else np.where(np.isfinite(values), 0.5, np.nan)


def _power(low: float, high: float) -> int:
    """Return the power of ten that both ends of an axis are told in."""
    return exponent(max(abs(low), abs(high)))


def _label(name: str, unit: str, power: int) -> str:
    """Return the heading of an axis, with power of ten and unit in brackets."""
    key, _, what = name.rpartition("_")
    if key in BY_KEY:
        text = f"{ {'min': 'least', 'max': 'greatest', 'mean': 'mean'}[what] }\n${BY_KEY[key].latex}$"
    else:
        text = _NAMES.get(name, name.replace("_", " "))
    measure = with_unit("", unit, power).strip()
    return f"{text}\n{measure}" if measure else text


def _colour_key(page: Any, name: str, values: FloatArray, unit: str) -> None:
    """Draw the colour bar at the right."""
    low, high, _ = _scaled(values)
    power = _power(low, high)
    bar: Any = page.add_axes((0.915, 0.16, 0.012, 0.6))
    bar.imshow(np.linspace(0, 0.92, 128)[:, None], aspect="auto", origin="lower", cmap="viridis", vmin=0, vmax=1)
    bar.set_xticks([])
    bar.yaxis.tick_right()
    bar.set_yticks([0, 127], [number_text(low, power), number_text(high, power)], fontsize=7.5)
    bar.set_title(_label(name, unit, power), fontsize=8.5, color=INK)


def _title(total: int, drawn: int, left_out: int) -> str:
    text = f"{total:,} designs" if drawn == total else f"{drawn:,} of {total:,} designs, evenly chosen"
    return text + (f"; {left_out:,} with an infinite or undefined value left out" if left_out else "")


def _note(surface: Surface | None, unit: str) -> str:
    lengths = f"lengths in {plain(unit)}" if unit else "no unit of length given"
    if surface is None:
        return f"Curvature is positive where a plane curve turns left; {lengths}"
    normal = normal_note(surface)
    return f"{normal[0].upper()}{normal[1:]}, which gives $H$ its sign; {lengths}"
