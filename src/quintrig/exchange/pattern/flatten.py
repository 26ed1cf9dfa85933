"""A developable patch as a flat pattern file for the workshop."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from quintrig.developables.unroll import ALLOWED, Pattern, Sheet, unroll
from quintrig.exchange.formats import suffixes
from quintrig.exchange.origin import far, is_far
from quintrig.exchange.pattern.drawing import Drawing, together
from quintrig.exchange.pattern.layout import PatternOptions, drawing
from quintrig.model.patch import Patch
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.errors import Note, QuintrigError
from quintrig.support.files import write_whole

PATTERN_SUFFIXES = suffixes("pattern")
"""Endings of the pattern files that can be written."""

_TOUCHING = 1e-9
"""Of the pattern's size: sides this near touch, and do not cross."""

_INSIDE = 1e-6
"""Of the pattern's size: how far inside a side it is asked whether another part of the pattern lies there too."""

_MOST_TRIED = 400


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


def export_pattern(
    patch: Patch | Sequence[Patch], unit: str, path: Path, options: FlattenOptions | None = None
) -> tuple[str, ...]:
    """Write the flat pattern of a patch, or of several on one page, as DXF, SVG or PDF, and return what to tell.

    Raises ValueError where a patch has none, with the reason measured, and QuintrigError for an unwritable target,
    another suffix or a missing extra.
    """
    options = options or FlattenOptions()
    suffix = path.suffix.lower()
    if suffix not in PATTERN_SUFFIXES:
        raise QuintrigError(f"{path}: expected a file ending in {', '.join(PATTERN_SUFFIXES)}")
    patches = tuple(patch) if isinstance(patch, Sequence) else (patch,)
    pages: list[Drawing] = []
    told: list[str] = []
    for one in patches:
        try:
            pattern = unroll(one.surface, options.sheet, chord=options.chord, allowed=options.allowed)
            page = drawing(pattern, one.name, unit, options.drawing)
        except ValueError as error:
            raise ValueError(f'patch "{one.name}": {error}') from None
        pages.append(page)
        told += [remark for remark in page.remarks if not remark.startswith(("boundaries ", "outline "))]
        told += _checks(pattern, unit)
        told += [f"{far(one.surface)}; move the model nearer for more digits"] if is_far(one.surface) else []
        told += _cautions(page)
    page = pages[0] if len(pages) == 1 else together(pages)
    if suffix == ".dxf":
        from quintrig.exchange.pattern.dxf import dxf

        write_whole(path, dxf(page))
    elif suffix == ".svg":
        from quintrig.exchange.pattern.svg import svg

        write_whole(path, svg(page))
    else:
        from quintrig.exchange.pattern.pdf import pdf

        write_whole(path, pdf(page))
    return tuple(told)


def _checks(pattern: Pattern, unit: str) -> tuple[str, ...]:
    check = pattern.isometry
    length = f" {unit}" if unit else ""
    loops = [f"{float(_norm(loop - np.roll(loop, 1, axis=0)).sum()):.6g}{length}" for loop in pattern.loops]
    if loops:
        return (
            f"trimmed face, outline and holes: {', '.join(loops)}",
            f"boundaries of its surface: changed by {max(check.first_change, check.second_change):.1e}",
            f"rulings: changed by at most {check.ruling_change:.1e}",
            f"area: {check.area:.12g}{length + '²' if unit else ''}, as polygons changed by {check.area_change:.1e}",
        )
    return (
        f"boundary 1: {check.first:.12g}{length}, changed by {check.first_change:.1e}",
        f"boundary 2: {check.second:.12g}{length}, changed by {check.second_change:.1e}",
        f"rulings: changed by at most {check.ruling_change:.1e}",
        f"area: {check.area:.12g}{length + '²' if unit else ''}, changed by {check.area_change:.1e}",
    )


def _cautions(page: Drawing) -> tuple[str, ...]:
    """Tell where a part of the pattern lies over itself: it cannot be cut from one sheet then."""
    outlines = [line.points for line in page.lines if line.layer == "OUTLINE"]
    if not any(overlaps(outline) for outline in outlines):
        return ()
    key = "smaller sheet" if len(outlines) > 1 else "sheet"
    return (Note("the pattern overlaps itself", remedy=f"split it to fit a {key}", key=key),)


def overlaps(outline: FloatArray) -> bool:
    """Return whether a closed polygon (n, 2) crosses itself or covers a part of the plane twice.

    Sides shorter than rounding, as at the apex of a cone, and sides that only touch, as a full turn's, are none.
    """
    reach = _TOUCHING * float(np.linalg.norm(np.ptp(outline, axis=0)))
    start = outline[_norm(outline - np.roll(outline, 1, axis=0)) > reach]
    if len(start) < 3:
        return False
    end = np.roll(start, -1, axis=0)
    if (start[:, 0] * end[:, 1] - end[:, 0] * start[:, 1]).sum() < 0.0:
        start, end = end[::-1], start[::-1]  # counter-clockwise
    return _crosses(start, end, reach) or _doubled(start, end)


def _crosses(start: FloatArray, end: FloatArray, reach: float) -> bool:
    """Return whether two sides that are no neighbours cross, each with both ends farther than ``reach`` off."""
    n = len(start)
    lengths = _norm(end - start)
    for i in range(n - 2):
        others = slice(i + 2, n - 1 if i == 0 else n)
        a, b, c, d = start[i], end[i], start[others], end[others]
        here = _side(a, b, c) / lengths[i], _side(a, b, d) / lengths[i]
        there = _side(c, d, a) / lengths[others], _side(c, d, b) / lengths[others]
        if (_parted(*here, reach) & _parted(*there, reach)).any():
            return True
    return False


def _parted(one: FloatArray, other: FloatArray, reach: float) -> BoolArray:
    return np.asarray((one * other < 0.0) & (np.minimum(np.abs(one), np.abs(other)) > reach))


def _doubled(start: FloatArray, end: FloatArray) -> bool:
    """Return whether the outline runs twice around a point just inside one of its sides, as more than a full turn."""
    along = end - start
    inward = np.stack([-along[:, 1], along[:, 0]], axis=-1) / _norm(along)[:, None]
    size = float(np.linalg.norm(np.ptp(start, axis=0)))
    inside = 0.5 * (start + end) + _INSIDE * size * inward
    for point in inside[:: max(1, len(inside) // _MOST_TRIED)]:
        left = _side(start, end, point)
        rising = (start[:, 1] <= point[1]) & (end[:, 1] > point[1]) & (left > 0.0)
        falling = (start[:, 1] > point[1]) & (end[:, 1] <= point[1]) & (left < 0.0)
        if int(rising.sum()) - int(falling.sum()) > 1:
            return True
    return False


def _norm(vectors: FloatArray) -> FloatArray:
    return np.sqrt((vectors**2).sum(axis=-1))


def _side(a: FloatArray, b: FloatArray, p: FloatArray) -> FloatArray:
    """Return on which side of the line from a to b a point is, by sign."""
    first, second = b - a, p - a
    return np.asarray(first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0])
