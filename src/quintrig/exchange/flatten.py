"""A developable patch as a flat pattern file for the workshop."""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from quintrig.arrays import FloatArray
from quintrig.errors import QuintrigError
from quintrig.exchange.formats import suffixes
from quintrig.exchange.pattern import PatternOptions, drawing
from quintrig.files import write_whole
from quintrig.model import Patch
from quintrig.unroll import ALLOWED, Pattern, Sheet, unroll

SUFFIXES = suffixes("pattern")
"""Endings of the pattern files that can be written."""


@dataclass(frozen=True)
class FlattenOptions:
    """Sheet, drawing, the polygons' largest distance from the true outline, length¹, and the allowed distortion."""

    sheet: Sheet = field(default_factory=Sheet)
    drawing: PatternOptions = field(default_factory=PatternOptions)
    chord: float | None = None
    allowed: float = ALLOWED

    def __post_init__(self) -> None:
        """Check once."""
        if self.chord is not None and not self.chord > 0.0:
            raise ValueError(f"chord: expected a length greater than 0, found {self.chord:g}")
        if not 0.0 < self.allowed < 1.0:
            raise ValueError(f"allowed distortion: expected a share between 0 and 1, found {self.allowed:g}")


def export_pattern(patch: Patch, unit: str, path: Path, options: FlattenOptions | None = None) -> tuple[str, ...]:
    """Write the flat pattern of a patch as DXF, SVG or PDF, and return what to tell about it, one line each.

    Raises ValueError where the patch has none, with the reason measured, and QuintrigError for an unwritable target,
    another suffix or a missing extra.
    """
    options = options or FlattenOptions()
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise QuintrigError(f"{path}: expected a file ending in {', '.join(SUFFIXES)}")
    try:
        pattern = unroll(patch.surface, options.sheet, chord=options.chord, allowed=options.allowed)
        page = drawing(pattern, patch.name, unit, options.drawing)
    except ValueError as error:
        raise ValueError(f'patch "{patch.name}": {error}') from None
    if suffix == ".dxf":
        from quintrig.exchange.pattern_dxf import dxf

        write_whole(path, dxf(page))
    elif suffix == ".svg":
        from quintrig.exchange.pattern_svg import svg

        write_whole(path, svg(page))
    else:
        from quintrig.exchange.pattern_pdf import pdf

        write_whole(path, pdf(page))
    drawn = [remark for remark in page.remarks if not remark.startswith("boundaries ")]
    return (*drawn, *_checks(pattern, unit), *_cautions(pattern))


def _checks(pattern: Pattern, unit: str) -> tuple[str, ...]:
    check = pattern.isometry
    length = f" {unit}" if unit else ""
    return (
        f"boundary 1: {check.first:.12g}{length}, changed by {check.first_change:.1e}",
        f"boundary 2: {check.second:.12g}{length}, changed by {check.second_change:.1e}",
        f"rulings: changed by at most {check.ruling_change:.1e}",
        f"area: {check.area:.12g}{length + '²' if unit else ''}, changed by {check.area_change:.1e}",
    )


def _cautions(pattern: Pattern) -> tuple[str, ...]:
    """Tell where the pattern lies over itself: it cannot be cut from one sheet then."""
    return ("the pattern overlaps itself: split it with a sheet size",) if overlaps(pattern.outline) else ()


def overlaps(outline: FloatArray) -> bool:
    """Return whether two sides of a closed polygon (n, 2) that are no neighbours cross."""
    start, end = outline, np.roll(outline, -1, axis=0)
    n = len(outline)
    for i in range(n - 2):
        others = slice(i + 2, n - 1 if i == 0 else n)
        a, b, c, d = start[i], end[i], start[others], end[others]
        if ((_side(a, b, c) * _side(a, b, d) < 0.0) & (_side(c, d, a) * _side(c, d, b) < 0.0)).any():
            return True
    return False


def _side(a: FloatArray, b: FloatArray, p: FloatArray) -> FloatArray:
    """Return on which side of the line from a to b a point is, by sign."""
    first, second = b - a, p - a
    return np.asarray(first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0])
