"""Flat patterns as PDF at true scale, one page of the drawing's size, through matplotlib."""

import io
from typing import Any

import numpy as np

from quintrig.exchange.pattern.drawing import LAYERS, Drawing, Text, decimal, dimension_strokes
from quintrig.exchange.units import stated
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError

_LONGEST = 5080.0
"""mm: PDF pages are at most 14,400 points wide."""


def pdf(drawing: Drawing) -> bytes:
    """Return a PDF file; QuintrigError for a drawing larger than a PDF page can be."""
    from matplotlib.backends.backend_pdf import FigureCanvasPdf
    from matplotlib.figure import Figure

    scale = stated(drawing.unit).millimetres
    size = scale * (drawing.high - drawing.low)
    if size.max() > _LONGEST:
        raise QuintrigError(
            f"the drawing is {size[0]:.0f} x {size[1]:.0f} mm, a PDF page at most {_LONGEST:.0f} mm; write DXF or SVG"
        )
    figure: Any = Figure(figsize=tuple(size / 25.4))
    FigureCanvasPdf(figure)
    axes: Any = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(drawing.low[0], drawing.high[0])
    axes.set_ylim(drawing.low[1], drawing.high[1])
    points = scale * drawing.text_height / 25.4 * 72.0
    thin = max(0.06 * points, 0.1)

    def stroke(layer: str, line: FloatArray) -> None:
        dashed = (0, (8, 3)) if layer.startswith("BEND") else "-"
        width = 2.0 * thin if layer == "OUTLINE" else thin
        axes.plot(line[:, 0], line[:, 1], color=LAYERS[layer][0], linewidth=width, linestyle=dashed)

    def write(text: Text) -> None:
        middle = text.align == "middle"
        axes.text(
            float(text.at[0]),
            float(text.at[1]),
            text.text,
            color=LAYERS[text.layer][0],
            fontsize=scale * text.height / 25.4 * 72.0 / 0.73,
            rotation=text.angle,
            rotation_mode="anchor",
            ha="center" if middle else "left",
            va="center" if middle else "baseline",
        )

    for line in drawing.lines:
        stroke(line.layer, np.concatenate([line.points, line.points[:1]]) if line.closed else line.points)
    for dimension in drawing.dimensions:
        strokes, place = dimension_strokes(dimension, drawing.text_height)
        for part in strokes:
            stroke("DIMENSIONS", part)
        write(Text("DIMENSIONS", place, decimal(dimension.value), drawing.text_height, dimension.angle, "middle"))
    for text in drawing.texts:
        write(text)
    stream = io.BytesIO()
    title = drawing.remarks[0] if drawing.remarks else "flat pattern"
    figure.savefig(stream, format="pdf", metadata={"Title": title, "Creator": "quintrig", "CreationDate": None})
    return stream.getvalue()
