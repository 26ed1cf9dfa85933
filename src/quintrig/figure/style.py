"""How figures look: texts, fonts, sizes, colours and levels, asked for by the one who publishes them."""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

import matplotlib
from matplotlib.figure import Figure
from matplotlib.font_manager import get_font_names
from matplotlib.text import Text

from quintrig.figure.camera import View, ViewName, read_view
from quintrig.figure.palette import Limits
from quintrig.support.errors import ArgumentError, nearest

POINTS = 7.5
"""Size in points of the numbers on figures; titles and names are in proportion."""

COLUMNS = {"column": 84.0, "page": 174.0}
"""Widths in millimetres of one and of two columns, as most journals set them."""

NARROWEST = 2.0
"""Inches in which letters of ``POINTS`` leave room for a picture: the narrowest page, larger with larger letters."""

MOST_LINES = 100
"""Parameter lines each way."""

LEAST_DPI, MOST_DPI = 30, 600
"""Dots per inch of PNG files."""

_SERIF = {"serif", "times", "times new roman", "stixgeneral"}


@dataclass(frozen=True)
class Style:
    """What is the same in every figure of a paper.

    ``title`` and ``caption`` say whether titles and the note below are drawn. ``font`` is a family, empty for the usual
    one; ``size`` that of numbers in points. ``limits`` are the ends of colour scales, or ``percentiles`` of the values
    to stretch them between; ``colours`` names a matplotlib colour map for quantities that are numbers. ``levels`` are
    contour lines: how many, or at which values. Pictures that follow each other have ``scales``, by the key of a
    quantity, and a ``box``, two corners, in common.

    What follows takes the place of a picture's own where it is given: ``view`` as ``plot`` takes it, ``net``, ``lines``
    (so many parameter lines each way, or lines of a kind), ``at``, parameters (u, v) that are marked besides, ``width``
    in inches or words, ``dpi`` dots per inch of PNG files, and on pages of several pictures the ``quantities``.
    """

    title: bool = True
    caption: bool = True
    font: str = ""
    size: float = POINTS
    limits: tuple[float, float] | None = None
    percentiles: tuple[float, float] | None = None
    colours: str = ""
    levels: int | tuple[float, ...] = 0
    scales: Mapping[str, Limits] = field(default_factory=dict[str, Limits])
    box: tuple[tuple[float, ...], tuple[float, ...]] | None = None
    view: View | ViewName | None = None
    net: bool | None = None
    lines: int | str | None = None
    at: tuple[tuple[float, float], ...] = ()
    width: float | str | None = None
    dpi: int | None = None
    quantities: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        """Check once, at birth; ValueError in one line."""
        if self.limits is not None and not -math.inf < self.limits[0] < self.limits[1] < math.inf:
            raise ArgumentError(
                f"expected two rising finite numbers, found {self.limits[0]:g} and {self.limits[1]:g}", "limits"
            )
        if self.percentiles is not None and not 0.0 <= self.percentiles[0] < self.percentiles[1] <= 100.0:
            low, high = self.percentiles
            raise ArgumentError(f"expected two rising numbers from 0 to 100, found {low:g} and {high:g}", "percentiles")
        if self.limits is not None and self.percentiles is not None:
            raise ValueError("limits and percentiles: expected one of them, found both")
        if not 4.0 <= self.size <= 24.0:
            raise ArgumentError(f"expected 4 to 24 points, found {self.size:g}", "size")
        if self.colours and self.colours not in matplotlib.colormaps:
            known = nearest(self.colours, matplotlib.colormaps) or "; such as viridis, cividis, magma or coolwarm"
            raise ArgumentError(f"no colour map of matplotlib is called {self.colours!r}{known}", "colours")
        if isinstance(self.levels, int):
            if not 0 <= self.levels <= 100:
                raise ArgumentError(f"expected 0 to 100 lines, found {self.levels}", "levels")
        elif any(not a < b for a, b in pairwise((-math.inf, *self.levels, math.inf))):
            raise ArgumentError(
                f"expected rising finite values, found {', '.join(f'{x:g}' for x in self.levels)}", "levels"
            )
        if self.view is not None:
            object.__setattr__(self, "view", read_view(self.view))
        if self.width is not None:
            object.__setattr__(self, "width", inches(self.width))
            self._require_room()
        if isinstance(self.lines, int) and not 0 <= self.lines <= MOST_LINES:
            raise ArgumentError(f"expected 0 to {MOST_LINES}, or a kind of lines, found {self.lines}", "lines")
        if isinstance(self.lines, str):
            from quintrig.interrogation.find import ALIASES, KINDS

            if ALIASES.get(self.lines, self.lines) not in KINDS:
                known = nearest(self.lines, [*KINDS, *ALIASES]) or f"; such as {', '.join([*KINDS][:4])}"
                raise ArgumentError(f"{self.lines[:40]!r} is no kind of lines{known}", "lines")
        if self.dpi is not None and not LEAST_DPI <= self.dpi <= MOST_DPI:
            raise ArgumentError(f"expected {LEAST_DPI} to {MOST_DPI} dots per inch, found {self.dpi}", "dpi")

    @property
    def factor(self) -> float:
        """How much larger than usual letters and lines are."""
        return self.size / POINTS

    def across(self, usual: float) -> float:
        """Return the width in inches to lay a figure out in, which ``finish`` then enlarges by ``factor``."""
        return max((usual if self.width is None else inches(self.width)) / self.factor, NARROWEST)

    def _require_room(self) -> None:
        """Raise ValueError where the letters leave no room for a picture."""
        width = 0.0 if self.width is None else inches(self.width)
        if width < NARROWEST * self.factor - 1e-9:
            least = math.ceil(25.4 * NARROWEST * self.factor)
            raise ArgumentError(
                f"expected at least {least} mm for numbers of {self.size:g} points, found {25.4 * width:.3g} mm",
                "width",
                remedy="widen it, or take smaller letters",
            )

    def finish(self, figure: Figure) -> Figure:
        """Set the fonts of a figure, and enlarge it with all that is on it by ``factor``."""
        if self.font:
            family = [self.font, "DejaVu Sans"]
            formulas = "stix" if self.font.lower() in _SERIF else "dejavusans"
            for text in _texts(figure):
                text.set_fontfamily(family)
                text.set_math_fontfamily(formulas)
        if self.factor != 1.0:
            _enlarge(figure, self.factor)
        return figure


STANDARD = Style()
"""The usual look, for the screen."""

JOURNAL = Style(title=False, caption=False, font="STIXGeneral", size=8.0)
"""A serif face that goes with Times, no titles and no notes: the caption in the text says it all."""

STYLES = {"standard": STANDARD, "journal": JOURNAL}


def style_named(name: str) -> Style:
    """Return a style by its name; ValueError naming those there are."""
    if name not in STYLES:
        raise ArgumentError(f"expected {' or '.join(STYLES)}, found {name!r}", "style")
    return STYLES[name]


def changed(style: Style, **changes: Any) -> Style:
    """Return a style with those changes that are not None; ValueError also for a font that is not installed."""
    found = replace(style, **{name: value for name, value in changes.items() if value is not None})
    if found.font:
        _require(found.font)
    return found


def inches(width: float | str) -> float:
    """Return a width in inches: a number of inches, ``84 mm``, ``8.4 cm``, ``3.3 in``, ``column`` or ``page``.

    Raises ValueError for other words, and for what is not between 1 and 20 inches.
    """
    found = re.fullmatch(r"\s*([0-9]+(?:\.[0-9]*)?)\s*(mm|cm|in|pt|)\s*", str(width))
    if isinstance(width, str) and width in COLUMNS:
        value = COLUMNS[width] / 25.4
    elif found:
        value = float(found[1]) / {"mm": 25.4, "cm": 2.54, "in": 1.0, "pt": 72.0, "": 1.0}[found[2]]
    else:
        raise ArgumentError(
            f"expected a length such as 84mm or 6.4in, {' or '.join(COLUMNS)}, found {width!r}", "width"
        )
    if not 1.0 <= value <= 20.0:
        raise ArgumentError(f"expected 1 to 20 inches (25 to 508 mm), found {value:.3g} inches", "width")
    return value


def _require(font: str) -> None:
    names = sorted(set(get_font_names()))
    if font.lower() not in {*(name.lower() for name in names), "serif", "sans-serif", "monospace"}:
        hint = nearest(font, names) or f"; there are {', '.join(names[:8])} and {len(names) - 8} more"
        raise ArgumentError(f"{font!r} is not installed{hint}", "font")


def _texts(figure: Any) -> Sequence[Any]:
    return figure.findobj(Text)


def _enlarge(figure: Figure, factor: float) -> None:
    """Make a figure larger with its letters, lines and marks; axes keep their places on it."""
    drawn: Any = figure
    for text in _texts(figure):
        text.set_fontsize(text.get_fontsize() * factor)
    for axes in drawn.axes:
        for axis in (axes.xaxis, axes.yaxis):
            ticks = axis.get_major_ticks()
            if ticks:
                size = ticks[0].label1.get_fontsize()
                length, pad = ticks[0].tick1line.get_markersize(), ticks[0].get_pad()
                axis.set_tick_params(labelsize=size, length=length * factor, pad=pad * factor)
            axis.labelpad *= factor
        for spine in axes.spines.values():
            spine.set_linewidth(spine.get_linewidth() * factor)
        for line in axes.lines:
            line.set_linewidth(line.get_linewidth() * factor)
            line.set_markersize(line.get_markersize() * factor)
        for collection in axes.collections:
            collection.set_linewidths([width * factor for width in collection.get_linewidths()])
            if hasattr(collection, "set_sizes"):
                collection.set_sizes([size * factor**2 for size in collection.get_sizes()])
    drawn.set_size_inches(*(factor * side for side in drawn.get_size_inches()))
