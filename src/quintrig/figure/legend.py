"""Keys: the colour bar of a real quantity and the list of a classification."""

import re
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator

from quintrig.figure.field import Field
from quintrig.figure.palette import CLASS_COLOURS, INK, UNDEFINED, Limits, colour_map
from quintrig.figure.sheet import Area, Axes, KeyPlace, drawable
from quintrig.figure.wording import exponent, number_text, quantity_label, tick_texts, with_unit
from quintrig.quantities.table import Quantity

_SIZE = 7.5
_LEAST = 2.2  # inches of a picture, below which its key stands, where too few would be left beside it
_MARKUP = re.compile(r"[${}^_\\]")
_SHAPES = {-1.0: "cup", -0.5: "rut", 0.0: "saddle", 0.5: "ridge", 1.0: "cap"}


def draw_key(area: Area, fields: Sequence[Field], stretch: Limits | None, unit: str = "") -> None:
    """Draw the key of one quantity into an area, upright where that is taller than wide."""
    q = fields[0].quantity
    if stretch is None:
        draw_class_list(area, q.name, *class_rows(fields))
    elif area.height > area.width:
        _upright_bar(area, q, stretch, unit)
    else:
        _level_bar(area, q, stretch, unit)


def class_rows(fields: Sequence[Field]) -> tuple[list[str], list[str]]:
    """Return names and colours of the classes that occur in the fields, the undefined one last."""
    q = fields[0].quantity
    found = np.unique(np.concatenate([f.values.reshape(-1) for f in fields])).tolist()
    codes = [code for code in found if code != 0] + [code for code in found if code == 0]
    return [q.classes[code] for code in codes], [CLASS_COLOURS[q.key][code] for code in codes]


def draw_class_list(area: Area, title: str, names: Sequence[str], colours: Sequence[str]) -> None:
    """Draw a list of colours and names into an area, in one column where it is upright, else in rows."""
    axes = area.axes()
    axes.set_axis_off()
    axes.set_xlim(0.0, 72.0 * area.width)
    axes.set_ylim(0.0, 72.0 * area.height)
    upright = area.height > area.width
    heading = title[:1].upper() + title[1:]
    if upright:
        top = 0.5 * 72.0 * area.height + 7.0 * (len(names) + 1)
        _write(axes, 4.0, top, heading, _SIZE + 1.0)
        for row, (name, colour) in enumerate(zip(names, colours, strict=True)):
            _swatch(axes, 4.0, top - 16.0 - 14.0 * row, name, colour)
        return
    widths = [25.0 + 0.56 * _SIZE * len(name) for name in names]
    lines: list[list[int]] = [[]]
    room = 72.0 * area.width - 8.0
    for i, width in enumerate(widths):
        if lines[-1] and sum(widths[j] for j in lines[-1]) + width > room:
            lines.append([])
        lines[-1].append(i)
    y = 72.0 * area.height - 8.0
    for line in lines:
        x = 0.5 * (72.0 * area.width - sum(widths[i] for i in line)) + 4.0
        for i in line:
            _swatch(axes, x, y, names[i], colours[i])
            x += widths[i]
        y -= 13.0


def key_width(fields: Sequence[Field]) -> float:
    """Return the width in inches that an upright key needs; 0 for no key."""
    return 0.0 if not fields else 1.45 if fields[0].quantity.kind == "class" else 0.95


def key_room(fields: Sequence[Field], width: float) -> tuple[KeyPlace, float]:
    """Return where the key of one picture stands on a page of this width in inches, and its size there."""
    if not fields:
        return "none", 0.0
    beside = key_width(fields)
    return ("right", beside) if width - beside - 0.2 >= _LEAST else ("below", key_height([fields], width - 0.2))


def key_height(every: Sequence[Sequence[Field]], width: float) -> float:
    """Return the height in inches that level keys of this width need, the tallest of several."""
    heights = [0.0]
    for fields in every:
        if fields and fields[0].quantity.kind == "class":
            heights.append(list_height(class_rows(fields)[0], width))
        elif fields:
            heights.append(0.62 if fields[0].quantity.key == "shape_index" else 0.5)
    return max(heights)


def list_height(names: Sequence[str], width: float) -> float:
    """Return the height in inches of a level list of names."""
    letters = sum(len(name) + 6 for name in names)
    return 0.2 + 0.185 * (1 + int(letters * 4.5 / (72.0 * width - 30.0)))


def _swatch(axes: Axes, x: float, y: float, name: str, colour: str) -> None:
    axes.fill(
        [x, x + 10.0, x + 10.0, x],
        [y - 4.5, y - 4.5, y + 4.5, y + 4.5],
        facecolor=colour,
        edgecolor=UNDEFINED,
        linewidth=0.4,
    )
    _write(axes, x + 14.0, y, name, _SIZE)


def _write(axes: Axes, x: float, y: float, text: str, size: float) -> None:
    axes.text(x, y, drawable(text), fontsize=size, color=INK, ha="left", va="center_baseline")


def _upright_bar(area: Area, q: Quantity, stretch: Limits, unit: str) -> None:
    height = min(area.height * 0.72, 3.2)
    axes = area.inside(0.14, 0.5 * (area.height - height), 0.13, height)
    power = _bar(axes, q, stretch, "vertical")
    label = quantity_label(q, unit, power)
    axes.set_ylabel(label, fontsize=_SIZE + 1.0, color=INK, labelpad=5.0)
    axes.yaxis.set_label_position("right")
    if stretch.clipped_share > 0.0:
        # Below the end of a name that is longer than the bar.
        longer = max(0.5 * (0.5 * (_SIZE + 1.0) * len(label.replace("$", "")) / (72.0 * height) - 1.0), 0.0)
        axes.text(
            0.5,
            -0.09 - longer,
            beyond(stretch),
            transform=axes.transAxes,
            fontsize=_SIZE - 0.5,
            color=INK,
            ha="left",
            va="top",
        )


def _level_bar(area: Area, q: Quantity, stretch: Limits, unit: str) -> None:
    width = min(area.width * 0.82, 3.4)
    left = 0.5 * (area.width - width)
    axes = area.inside(left, area.height - 0.17, width, 0.11)
    power = _bar(axes, q, stretch, "horizontal")
    rest = f"; {beyond(stretch)}" if stretch.clipped_share > 0.0 else ""
    label = quantity_label(q, unit, power) + rest
    # A name that would run into the next key gives way: the panel's title or the caption has it.
    if 0.5 * (_SIZE + 0.5) * len(_MARKUP.sub("", label)) > 72.0 * (area.width + 0.2):
        label = with_unit(f"${q.latex}$", q.unit(unit), power) + rest
    axes.set_xlabel(label, fontsize=_SIZE + 0.5, color=INK, labelpad=2.5)


def beyond(stretch: Limits) -> str:
    """Return the clipped share in words, such as ``1.3 % beyond``."""
    share = 100.0 * stretch.clipped_share
    return f"{share:.0f} % beyond" if share >= 9.95 else f"{share:.2g} % beyond"


def _bar(axes: Any, q: Quantity, stretch: Limits, orientation: str) -> int:
    """Draw the bar with pointed ends where values lie beyond, and return the power of ten taken out of its numbers."""
    ends = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}
    bar = axes.figure.colorbar(
        ScalarMappable(Normalize(stretch.low, stretch.high), colour_map(q, stretch.colours)),
        cax=axes,
        orientation=orientation,
        extend=ends[stretch.below > 0.0, stretch.above > 0.0],
        extendfrac=0.045,
    )
    bar.outline.set_linewidth(0.5)
    bar.outline.set_edgecolor("#8a8a8a")
    power = exponent(max(abs(stretch.low), abs(stretch.high)))
    named = q.key == "shape_index"
    values = (
        [*_SHAPES] if named else MaxNLocator(nbins=5, steps=[1, 2, 2.5, 5, 10]).tick_values(stretch.low, stretch.high)
    )
    slack = 1e-9 * (stretch.high - stretch.low)
    ticks = [float(t) for t in values if stretch.low - slack <= t <= stretch.high + slack]
    texts = tick_texts(ticks, power)
    if named:
        joint = "\n" if orientation == "horizontal" else "  "
        texts = [f"{number_text(s)}{joint}{_SHAPES[s]}" for s in ticks]
    bar.set_ticks(ticks, labels=texts)
    bar.ax.tick_params(labelsize=_SIZE, labelcolor=INK, length=2.5, width=0.5, color="#8a8a8a", pad=2.0)
    bar.ax.minorticks_off()
    return power
