"""The page of a figure: panels in rows, room for titles, keys and the note, all in inches so that nothing overlaps."""

import re
import textwrap
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.mathtext import MathTextParser

from quintrig.figure.palette import INK
from quintrig.figure.picture import Picture
from quintrig.figure.style import STANDARD, Style

_FORMULA = re.compile(r"(?<!\\)\$[^$\n]+(?<!\\)\$")
_HOLD = "\x1f"  # stands for a space at which no line may end

Axes = Any
"""matplotlib's axes. Its own type leaves keyword arguments untyped, which strict checking refuses."""

ONE_AT_A_TIME = threading.Lock()
"""Held while texts are set: matplotlib's setting of formulas goes wrong when two threads enter it at once."""

KeyPlace = Literal["none", "right", "below", "each"]

_EDGE = 0.1
_TITLE, _PANEL_TITLE, _NOTE = 11.0, 9.0, 7.5  # font sizes


@dataclass(frozen=True)
class Area:
    """A rectangle of the page, in inches from its lower left corner."""

    figure: Figure
    left: float
    bottom: float
    width: float
    height: float

    def axes(self) -> Axes:
        """Return new axes that fill the area."""
        return self.inside(0.0, 0.0, self.width, self.height)

    def inside(self, left: float, bottom: float, width: float, height: float) -> Axes:
        """Return new axes on a part of the area, in inches from its lower left corner."""
        wide, high = self.figure.get_size_inches()
        figure: Any = self.figure
        return figure.add_axes(((self.left + left) / wide, (self.bottom + bottom) / high, width / wide, height / high))


@dataclass(frozen=True)
class Page:
    """A figure with its ``panels`` in reading order and the areas for their ``keys``."""

    figure: Figure
    panels: tuple[Area, ...]
    keys: tuple[Area, ...]


def sheet(
    count: int,
    panel: tuple[float, float],
    *,
    widths: Sequence[float] = (),
    columns: int = 3,
    titles: Sequence[str] = (),
    title: str = "",
    note: str = "",
    key: KeyPlace = "none",
    key_size: float = 0.55,
    style: Style = STANDARD,
) -> Page:
    """Lay out ``count`` panels of ``panel`` inches; ``widths`` gives each column its own width.

    The ``style`` says whether the title and the note are set; titles of panels stay, which tell them apart.

    ``key`` puts one key to the right or below, or one below each panel; ``key_size`` is its width or height in inches.
    """
    columns = max(1, min(columns, count))
    title, note = title if style.title else "", note if style.caption else ""
    rows = -(-count // columns)
    gap = 0.12
    head = 0.24 if any(titles) else 0.0
    foot = key_size if key == "each" else 0.0
    across = list(widths) or [panel[0]] * columns
    width = sum(across) + (columns - 1) * gap + 2 * _EDGE + (key_size if key == "right" else 0.0)
    titled, noted = _wrapped(title, width, _TITLE), _wrapped(note, width, _NOTE)
    top = _EDGE + 0.22 * len(titled) * (_TITLE / 11.0) + (0.05 if titled else 0.0)
    bottom = _EDGE + 0.145 * len(noted) + (0.05 if noted else 0.0)
    under = key_size if key == "below" else 0.0
    height = top + rows * (head + panel[1] + foot) + (rows - 1) * gap + under + bottom
    figure = new_figure(width, height)
    _text(figure, _EDGE / width, 1.0 - _EDGE / height, "\n".join(titled), _TITLE, "top", "bold")
    _text(figure, _EDGE / width, _EDGE / height, "\n".join(noted), _NOTE, "bottom", "normal")
    panels: list[Area] = []
    keys: list[Area] = []
    for index in range(count):
        row, column = divmod(index, columns)
        left = _EDGE + sum(across[:column]) + column * gap
        ceiling = height - top - row * (head + panel[1] + foot + gap)
        panels.append(Area(figure, left, ceiling - head - panel[1], across[column], panel[1]))
        if key == "each":
            keys.append(Area(figure, left, ceiling - head - panel[1] - foot, across[column], foot))
        if index < len(titles):
            x = (left + 0.5 * across[column]) / width
            _text(figure, x, (ceiling - 0.03) / height, titles[index], _PANEL_TITLE, "top", "normal", "center")
    if key == "right":
        keys.append(Area(figure, width - _EDGE - key_size, bottom, key_size, height - top - bottom))
    if key == "below":
        keys.append(Area(figure, _EDGE, bottom, width - 2 * _EDGE, key_size))
    return Page(figure, tuple(panels), tuple(keys))


def columns_for(width: float, count: int, wanted: int) -> int:
    """Return how many columns to lay out: those wanted, but each at least two inches wide."""
    return max(1, min(wanted, count, int(width / 2.0)))


def new_figure(width: float, height: float) -> Figure:
    """Return a blank white figure of this size in inches, drawn by Agg, known to no window system."""
    figure = Picture(figsize=(width, height), dpi=100, facecolor="white")
    FigureCanvasAgg(figure)
    return figure


def points_wide(axes: Axes) -> tuple[float, float]:
    """Return the size of axes in printer's points."""
    width, height = axes.figure.get_size_inches()
    place = axes.get_position(original=True)
    return 72.0 * width * place.width, 72.0 * height * place.height


def _wrapped(text: str, width: float, size: float) -> list[str]:
    """Return the lines of a text; a formula is never broken, which would leave its dollar signs standing."""
    letters = int((width - 2 * _EDGE) * 72.0 / (0.53 * size))
    kept = _FORMULA.sub(lambda formula: formula[0].replace(" ", _HOLD), text)
    lines = [line for part in kept.splitlines() for line in textwrap.wrap(part, max(letters, 20))]
    return [line.replace(_HOLD, " ") for line in lines]


def _text(
    figure: Any, x: float, y: float, text: str, size: float, anchor: str, weight: str, side: str = "left"
) -> None:
    text = drawable(text)
    if text:
        figure.text(x, y, text, fontsize=size, color=INK, va=anchor, ha=side, fontweight=weight, linespacing=1.25)


def drawable(text: str) -> str:
    """Return a text that matplotlib can draw: where its dollar signs enclose no formula they are plain letters."""
    clean = "".join(c for c in text if c == "\n" or c.isprintable())
    return clean if all("$" not in line or _sets(line) for line in clean.splitlines()) else clean.replace("$", "\\$")


@lru_cache(1000)
def _sets(line: str) -> bool:
    """Tell whether matplotlib sets a line; pictures of one page have many in common."""
    try:
        with ONE_AT_A_TIME:
            MathTextParser("path").parse(line)
    except ValueError:
        return False
    return True
