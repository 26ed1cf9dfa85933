"""From a flat pattern to a drawing: bend lines, parts that fit a sheet with matching marks, dimensions and notes."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from quintrig.developables.unroll import Pattern
from quintrig.exchange.pattern.drawing import Dimension, Drawing, Line, Text, decimal
from quintrig.support.arrays import FloatArray

_MOST_PARTS = 200


@dataclass(frozen=True)
class PatternOptions:
    """Bend lines every ``step`` degrees, and the size of the stock a part must fit on, length¹, less a ``margin``."""

    step: float = 5.0
    stock: tuple[float, float] | None = None
    margin: float = 0.0

    def __post_init__(self) -> None:
        """Check once."""
        if not 0.1 <= self.step <= 180.0:
            raise ValueError(f"bend step: expected 0.1 to 180 degrees, found {self.step:g}")
        if self.stock is not None and not min(self.stock) - 2.0 * self.margin > 0.0:
            raise ValueError(
                f"sheet: expected a size greater than its margins, found {self.stock[0]:g} x {self.stock[1]:g}"
            )
        if not self.margin >= 0.0:
            raise ValueError(f"margin: expected a length of 0 or more, found {self.margin:g}")


@dataclass(frozen=True, eq=False)
class Bend:
    """One bend line, its ends (2, 2) and parameter t: there the sheet bends by ``angle`` degrees, up or down."""

    ends: FloatArray
    angle: float
    upward: bool
    t: float


@dataclass(frozen=True, eq=False)
class Part:
    """One part cut from a sheet: its boundaries (n, 2) turned and moved into place, its bends, and where it was cut.

    A trimmed face has ``loops``, its outline and holes.
    """

    first: FloatArray
    second: FloatArray
    bends: tuple[Bend, ...]
    start: float
    end: float
    loops: tuple[FloatArray, ...] = ()

    @property
    def cuts(self) -> tuple[FloatArray, ...]:
        """The closed lines (n, 2) to cut along."""
        return self.loops or (np.concatenate([self.first, self.second[::-1]]),)


def bends(pattern: Pattern, step: float) -> tuple[Bend, ...]:
    """Return bend lines, each amid an equal share, at most ``step`` degrees, of a stretch that bends one way."""
    result: list[Bend] = []
    bend = np.degrees(pattern.bend)
    start, stop = (float(np.interp(t, pattern.t, bend)) for t in pattern.span)
    turns = np.flatnonzero(np.diff(pattern.upward.astype(np.int8))) + 1
    for stretch in np.split(np.arange(len(bend)), turns):
        low, high = max(float(bend[stretch[0]]), start), min(float(bend[min(stretch[-1] + 1, len(bend) - 1)]), stop)
        if high - low < 1e-6:
            continue
        count = int(np.ceil((high - low) / step - 1e-9))
        for k in range(count):
            at = low + (k + 0.5) * (high - low) / count
            t = float(np.interp(at, bend, pattern.t))
            for ends in _held(_ruling(pattern, t), pattern.loops):
                result.append(Bend(ends, (high - low) / count, bool(pattern.upward[stretch[0]]), t))
    return tuple(result)


def _held(ends: FloatArray, loops: Sequence[FloatArray]) -> list[FloatArray]:
    """Return the pieces (2, 2) of a line that lie inside the loops, all of it where there are none."""
    if not loops:
        return [ends]
    start = np.concatenate(loops)
    along, sides = ends[1] - ends[0], np.concatenate([np.roll(loop, -1, axis=0) for loop in loops]) - start
    off = along[0] * (start - ends[0])[:, 1] - along[1] * (start - ends[0])[:, 0]
    rise = along[0] * sides[:, 1] - along[1] * sides[:, 0]
    met = (off > 0.0) != (off + rise > 0.0)
    points = start[met] - (off[met] / rise[met])[:, None] * sides[met]
    order = np.argsort((points - ends[0]) @ along)
    return [points[order[k : k + 2]] for k in range(0, len(order) - 1, 2)]


def parts(pattern: Pattern, lines: Sequence[Bend], options: PatternOptions) -> tuple[Part, ...]:
    """Cut a pattern along rulings into parts that fit the stock, turned to their smallest box; one part without stock.

    Raises ValueError where a ruling alone is too long for the sheet.
    """
    if options.stock is None:
        return (_part(pattern, lines, 0.0, 1.0),)
    room = tuple(sorted(side - 2.0 * options.margin for side in options.stock))
    if pattern.loops:
        if not _fits(pattern.loops, room):
            box = " x ".join(decimal(float(side)) for side in np.ptp(_part(pattern, lines, 0.0, 1.0).cuts[0], axis=0))
            raise ValueError(
                f"sheet: expected one that holds all of a trimmed face, {box}, found {options.stock[0]:g} x "
                f"{options.stock[1]:g} with a margin of {options.margin:g}; choose a larger sheet, or split the face "
                "in the CAD system"
            )
        return (_part(pattern, lines, 0.0, 1.0),)
    result: list[Part] = []
    start = 0.0
    while start < 1.0 - 1e-12:
        end = _furthest(pattern, start, room)
        if not end > start + 1e-9 or len(result) == _MOST_PARTS:
            longest = float(np.linalg.norm(pattern.second - pattern.first, axis=1).max())
            raise ValueError(
                f"sheet: expected one that holds a ruling of {decimal(longest)}, found {options.stock[0]:g} x "
                f"{options.stock[1]:g} with a margin of {options.margin:g}; choose a larger sheet"
            )
        result.append(_part(pattern, lines, start, end))
        start = end
    if len(result) > 1:  # equal shares look better than one small rest, where they fit too
        even = np.linspace(0.0, 1.0, len(result) + 1)
        spans = list(zip(even[:-1].tolist(), even[1:].tolist(), strict=True))
        if all(_fits(_cut(pattern, low, high), room) for low, high in spans):
            return tuple(_part(pattern, lines, low, high) for low, high in spans)
    return tuple(result)


def drawing(pattern: Pattern, title: str, unit: str, options: PatternOptions) -> Drawing:
    """Return the drawing of a pattern: every part on its sheet, side by side."""
    lines_of = bends(pattern, options.step)
    pieces = parts(pattern, lines_of, options)
    size = float(np.linalg.norm(np.ptp(pattern.outline, axis=0)))
    height = _round(size / 80.0)
    lines: list[Line] = []
    texts: list[Text] = []
    dimensions: list[Dimension] = []
    x = 0.0
    top = 0.0
    for k, piece in enumerate(pieces):
        name = chr(ord("A") + k) if k < 26 else f"P{k + 1}"
        loop = np.concatenate(piece.cuts)
        box = np.ptp(loop, axis=0)
        room = np.array(options.stock if options.stock else box + 0.0)
        if options.stock and (box > room - 2 * options.margin + 1e-9).any():
            room = room[::-1]
        shift = np.array([x, 0.0]) + 0.5 * (room - box) - loop.min(axis=0)
        moved = _moved(piece, shift)
        lines += [Line("OUTLINE", cut, True) for cut in moved.cuts]
        if options.stock:
            corner = np.array([x, 0.0])
            lines.append(Line("SHEET", corner + room * np.array([[0, 0], [1, 0], [1, 1], [0, 1]]), True))
        letters = _letters(moved.bends, height)
        for bend in moved.bends:
            lines.append(Line("BEND_UP" if bend.upward else "BEND_DOWN", bend.ends))
            texts.append(_bend_text(bend, letters))
        marks, words = _marks(moved, k, len(pieces), height)
        lines += marks
        texts += words
        dimensions += _dimensions(moved, height)
        if len(pieces) > 1:
            corner = shift + loop.min(axis=0) + np.array([0.0, box[1] + 1.5 * height])
            texts.append(Text("TEXT", corner, name, 3.0 * height))
        x += float(room[0]) + 12.0 * height
        top = max(top, float(room[1]))
    notes = _notes(pattern, title, unit, options, len(pieces), len(lines_of))
    texts += [Text("TEXT", np.array([0.0, -(8.0 + 1.9 * i) * height]), note, height) for i, note in enumerate(notes)]
    widest = max(x - 12.0 * height, 0.62 * height * max(len(note) for note in notes))
    low, high = (
        np.array([-8.0 * height, -(10.0 + 1.9 * len(notes)) * height]),
        np.array([widest + 8.0 * height, top + 6.0 * height]),
    )
    return Drawing(tuple(lines), tuple(texts), tuple(dimensions), low, high, unit, height, notes)


def _notes(pattern: Pattern, title: str, unit: str, options: PatternOptions, count: int, lines: int) -> tuple[str, ...]:
    sheet, check = pattern.sheet, pattern.isometry
    length = f" {unit}" if unit else ""
    fibre = (
        f"sheet {decimal(sheet.thickness)}{length}, k-factor {sheet.k_factor:g}, model is its {sheet.side}"
        if sheet.thickness
        else "no sheet thickness: the pattern is that of the surface itself"
    )
    total = float(np.degrees(np.ptp(np.interp(pattern.span, pattern.t, pattern.bend))))
    around = ", ".join(decimal(_length(loop)) for loop in pattern.loops)
    boundaries = (
        f"outline and holes {around}{length}"
        if pattern.loops
        else f"boundaries {decimal(check.first)} and {decimal(check.second)}{length}"
    )
    return (
        f"{title}: flat pattern, scale 1:1{', unit ' + unit if unit else ''}, seen from the side the normal points to",
        fibre,
        f"{lines} bend lines, {total:.2f}° in all; blue: towards you, orange: away from you",
        f"{boundaries}, area {decimal(check.area)}"
        f"{length + '²' if unit else ''}; lengths and area agree with the surface to {check.worst:.1e}",
        *([f"{count} parts, cut along rulings; equal marks go together"] if count > 1 else []),
    )


def _length(loop: FloatArray) -> float:
    return float(np.linalg.norm(loop - np.roll(loop, 1, axis=0), axis=1).sum())


def _ruling(pattern: Pattern, t: float) -> FloatArray:
    return np.stack([_on(pattern.t, side, t) for side in (pattern.first, pattern.second)])


def _on(t: FloatArray, points: FloatArray, at: float) -> FloatArray:
    return np.array([np.interp(at, t, points[:, axis]) for axis in (0, 1)])


def _cut(pattern: Pattern, start: float, end: float) -> tuple[FloatArray, FloatArray]:
    """Return both boundaries between two parameters."""
    inner = (pattern.t > start) & (pattern.t < end)
    low, high = _ruling(pattern, start), _ruling(pattern, end)
    first = np.concatenate([low[:1], pattern.first[inner], high[:1]])
    second = np.concatenate([low[1:], pattern.second[inner], high[1:]])
    return first, second


def _part(pattern: Pattern, lines: Sequence[Bend], start: float, end: float) -> Part:
    first, second = _cut(pattern, start, end)
    angle = _best_angle(np.concatenate(pattern.loops or (first, second)))
    onward = 0.5 * (first[-1] + second[-1] - first[0] - second[0])
    if onward[0] * np.cos(angle) - onward[1] * np.sin(angle) < 0.0:
        angle += np.pi  # parts run from left to right, in their order
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    own = [bend for bend in lines if start < bend.t < end]
    turned = tuple(Bend(bend.ends @ turn.T, bend.angle, bend.upward, bend.t) for bend in own)
    return Part(first @ turn.T, second @ turn.T, turned, start, end, tuple(loop @ turn.T for loop in pattern.loops))


def _moved(part: Part, shift: FloatArray) -> Part:
    moved = tuple(Bend(bend.ends + shift, bend.angle, bend.upward, bend.t) for bend in part.bends)
    loops = tuple(loop + shift for loop in part.loops)
    return Part(part.first + shift, part.second + shift, moved, part.start, part.end, loops)


def _best_angle(points: FloatArray) -> float:
    """Return the turn that makes the points' box smallest, longer side across: a side of the hull lies flat."""
    from scipy.spatial import ConvexHull

    hull = points[ConvexHull(points).vertices]
    sides = np.roll(hull, -1, axis=0) - hull
    best, smallest = 0.0, np.inf
    for angle in -np.arctan2(sides[:, 1], sides[:, 0]):
        c, s = np.cos(angle), np.sin(angle)
        width, height = np.ptp(hull @ np.array([[c, s], [-s, c]]), axis=0)
        if width * height < smallest * (1.0 - 1e-9):
            smallest, best = width * height, float(angle) + (0.0 if width >= height else 0.5 * np.pi)
    return best


def _fits(sides: Sequence[FloatArray], room: Sequence[float]) -> bool:
    points = np.concatenate(sides)
    angle = _best_angle(points)
    c, s = np.cos(angle), np.sin(angle)
    box = np.sort(np.ptp(points @ np.array([[c, s], [-s, c]]), axis=0))
    return bool((box <= np.array(room) + 1e-9).all())


def _furthest(pattern: Pattern, start: float, room: Sequence[float]) -> float:
    """Return how far a part from ``start`` reaches on one sheet."""
    if _fits(_cut(pattern, start, 1.0), room):
        return 1.0
    low, high = start, 1.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        if _fits(_cut(pattern, start, middle), room):
            low = middle
        else:
            high = middle
    return low


def _letters(lines: Sequence[Bend], height: float) -> float:
    """Return the height of the words at bend lines, small enough to stand between them."""
    gaps = [height]
    for one, other in pairwise(lines):
        along = (other.ends[1] - other.ends[0]) / np.linalg.norm(other.ends[1] - other.ends[0])
        step = other.ends.mean(axis=0) - one.ends.mean(axis=0)
        gaps.append(float(abs(step[0] * along[1] - step[1] * along[0])))
    return min(0.7 * height, 0.5 * min(gaps))


def _bend_text(bend: Bend, height: float) -> Text:
    along = bend.ends[1] - bend.ends[0]
    angle = float(np.degrees(np.arctan2(along[1], along[0])))
    # Words read from the left or from below; nearly upright lines all the same way.
    angle = angle - 180.0 if angle > 100.0 else angle + 180.0 if angle <= -80.0 else angle
    lift = np.array([-np.sin(np.radians(angle)), np.cos(np.radians(angle))])
    word = f"{'up' if bend.upward else 'down'} {bend.angle:.2f}°"
    return Text(
        "BEND_UP" if bend.upward else "BEND_DOWN",
        bend.ends.mean(axis=0) + 1.05 * height * lift,
        word,
        height,
        angle,
        "middle",
    )


def _marks(part: Part, k: int, count: int, height: float) -> tuple[list[Line], list[Text]]:
    """Return ticks across the cut sides of a part, at a third and two thirds, each numbered like its counterpart's."""
    lines: list[Line] = []
    texts: list[Text] = []
    middle = 0.5 * (part.first.mean(axis=0) + part.second.mean(axis=0))
    for index, joint in ((0, k), (-1, k + 1)):
        if joint in (0, count):
            continue
        start, end = part.first[index], part.second[index]
        along = (end - start) / np.linalg.norm(end - start)
        across = np.array([-along[1], along[0]])
        across = across if (middle - start) @ across > 0.0 else -across
        for tick, share in enumerate((1 / 3, 2 / 3)):
            foot = start + share * (end - start)
            # One tick is single, the other double, so that no part goes on the wrong way round.
            for offset in (0.0,) if tick == 0 else (-0.25, 0.25):
                at = foot + offset * height * along
                lines.append(Line("MARKS", np.stack([at, at + 1.2 * height * across])))
            texts.append(Text("MARKS", foot + 2.0 * height * across, f"{joint}", 0.9 * height, align="middle"))
    return lines, texts


def _dimensions(part: Part, height: float) -> list[Dimension]:
    """Return the overall width and height of a part."""
    loop = np.concatenate(part.cuts)
    low, high = loop.min(axis=0), loop.max(axis=0)
    left, right = loop[loop[:, 0].argmin()], loop[loop[:, 0].argmax()]
    bottom, top = loop[loop[:, 1].argmin()], loop[loop[:, 1].argmax()]
    below, beside = np.array([0.0, low[1] - 3.5 * height]), np.array([high[0] + 3.5 * height, 0.0])
    return [
        Dimension(left, right, below, 0.0, float(high[0] - low[0])),
        Dimension(bottom, top, beside, 90.0, float(high[1] - low[1])),
    ]


def _round(value: float) -> float:
    """Return the nearest of 1, 2, 2.5, 5 times a power of ten below a value: text heights that drawing offices use."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(max(step * power for step in (1.0, 1.8, 2.5, 3.5, 5.0, 7.0) if step * power <= value))
