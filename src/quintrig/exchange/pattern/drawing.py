"""A flat drawing at true scale: lines, texts and dimensions on named layers, for every drawing format alike."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from quintrig.support.arrays import FloatArray

LAYERS: dict[str, tuple[str, int, str]] = {
    "OUTLINE": ("#000000", 7, "cut here"),
    "BEND_UP": ("#0072b2", 5, "bend towards you"),
    "BEND_DOWN": ("#d55e00", 30, "bend away from you"),
    "MARKS": ("#009e73", 3, "parts match here"),
    "DIMENSIONS": ("#666666", 8, "dimensions"),
    "TEXT": ("#444444", 8, "notes"),
    "SHEET": ("#bbbbbb", 9, "edge of the sheet"),
}
"""Colour on screen, colour number in DXF, and meaning of each layer."""


@dataclass(frozen=True, eq=False)
class Line:
    """A polygon (n, 2) on a layer, closed or open."""

    layer: str
    points: FloatArray
    closed: bool = False


@dataclass(frozen=True, eq=False)
class Text:
    """One line of text, its anchor (2,), height, angle in degrees; ``align`` is left or middle (about the anchor)."""

    layer: str
    at: FloatArray
    text: str
    height: float
    angle: float = 0.0
    align: str = "left"


@dataclass(frozen=True, eq=False)
class Dimension:
    """A linear dimension from ``start`` to ``end`` (2,) along ``angle`` degrees, its line through ``place`` (2,)."""

    start: FloatArray
    end: FloatArray
    place: FloatArray
    angle: float
    value: float


@dataclass(frozen=True, eq=False)
class Drawing:
    """Everything on one page, in the model's unit: ``low`` and ``high`` (2,) are its corners."""

    lines: tuple[Line, ...]
    texts: tuple[Text, ...]
    dimensions: tuple[Dimension, ...]
    low: FloatArray
    high: FloatArray
    unit: str
    text_height: float
    remarks: tuple[str, ...] = field(default=())


def together(drawings: Sequence[Drawing], gap: float = 6.0) -> Drawing:
    """Return several drawings on one page, one above the other, ``gap`` text heights apart; the first is on top."""
    height = max(one.text_height for one in drawings)
    lines: list[Line] = []
    texts: list[Text] = []
    dimensions: list[Dimension] = []
    level = 0.0
    for one in drawings[::-1]:
        shift = np.array([-one.low[0], level - one.low[1]])
        lines += [replace(line, points=line.points + shift) for line in one.lines]
        texts += [replace(text, at=text.at + shift) for text in one.texts]
        dimensions += [
            replace(own, start=own.start + shift, end=own.end + shift, place=own.place + shift)
            for own in one.dimensions
        ]
        level += float(one.high[1] - one.low[1]) + gap * height
    widest = max(float(one.high[0] - one.low[0]) for one in drawings)
    remarks = tuple(remark for one in drawings for remark in one.remarks)
    low, high = np.zeros(2), np.array([widest, level - gap * height])
    return Drawing(tuple(lines), tuple(texts), tuple(dimensions), low, high, drawings[0].unit, height, remarks)


def dimension_strokes(dimension: Dimension, height: float) -> tuple[list[FloatArray], FloatArray]:
    """Return the strokes of a dimension, for formats that have none of their own, and the place of its text (2,)."""
    angle = np.radians(dimension.angle)
    along, across = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    level = dimension.place @ across
    feet = [point + (level - point @ across) * across for point in (dimension.start, dimension.end)]
    if (feet[1] - feet[0]) @ along < 0.0:
        feet.reverse()
    strokes = [np.stack(feet)]
    for point, foot in zip(
        (dimension.start, dimension.end), sorted(feet, key=lambda f: abs((f - dimension.start) @ along)), strict=True
    ):
        away = np.sign((foot - point) @ across) * across
        strokes.append(np.stack([point + 0.4 * height * away, foot + 0.6 * height * away]))
    for foot, sense in ((feet[0], 1.0), (feet[1], -1.0)):
        tip = [foot + 0.9 * height * sense * along + 0.22 * height * side * across for side in (1.0, -1.0)]
        strokes.append(np.stack([tip[0], foot, tip[1]]))
    return strokes, 0.5 * (feet[0] + feet[1]) + 0.9 * height * across


def decimal(value: float) -> str:
    """Return a length for a person: enough digits for the workshop."""
    return f"{value:.2f}" if abs(value) >= 10.0 else f"{value:.4g}"
