"""Flat patterns as SVG at true scale: millimetres on the page, whatever the model's unit."""

from xml.sax.saxutils import escape

from quintrig.exchange.pattern.drawing import LAYERS, Drawing, Text, decimal, dimension_strokes
from quintrig.exchange.units import stated
from quintrig.support.arrays import FloatArray


def svg(drawing: Drawing) -> str:
    """Return the text of an SVG file, a group for each layer."""
    scale = stated(drawing.unit).millimetres
    width, height = (scale * (drawing.high - drawing.low)).tolist()
    thin = 0.06 * drawing.text_height * scale

    def at(point: FloatArray) -> tuple[float, float]:
        x, y = scale * (point - drawing.low)
        return float(x), height - float(y)

    groups: dict[str, list[str]] = {name: [] for name in LAYERS}
    for line in drawing.lines:
        path = " ".join(f"{x:.6f},{y:.6f}" for x, y in map(at, line.points))
        shape = "polygon" if line.closed else "polyline"
        groups[line.layer].append(f'<{shape} points="{path}"/>')
    for text in drawing.texts:
        groups[text.layer].append(_text(text, at(text.at), scale))
    for dimension in drawing.dimensions:
        strokes, place = dimension_strokes(dimension, drawing.text_height)
        for stroke in strokes:
            path = " ".join(f"{x:.6f},{y:.6f}" for x, y in map(at, stroke))
            groups["DIMENSIONS"].append(f'<polyline points="{path}"/>')
        label = Text("DIMENSIONS", place, decimal(dimension.value), drawing.text_height, dimension.angle, "middle")
        groups["DIMENSIONS"].append(_text(label, at(place), scale))
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.6f}mm" height="{height:.6f}mm" '
        f'viewBox="0 0 {width:.6f} {height:.6f}" font-family="Helvetica, Arial, sans-serif">',
        f"<title>{escape(drawing.remarks[0] if drawing.remarks else 'flat pattern')}</title>",
        f'<rect width="{width:.6f}" height="{height:.6f}" fill="#ffffff"/>',
    ]
    for name, parts in groups.items():
        if not parts:
            continue
        colour, _, meaning = LAYERS[name]
        stroke = 2.0 * thin if name == "OUTLINE" else thin
        dashes = f' stroke-dasharray="{8 * thin:.4f} {3 * thin:.4f}"' if name.startswith("BEND") else ""
        lines.append(
            f'<g id="{name}" fill="none" stroke="{colour}" stroke-width="{stroke:.4f}" stroke-linejoin="round"{dashes}>'
            f"<desc>{escape(meaning)}</desc>"
        )
        lines += [f"  {part}" for part in parts]
        lines.append("</g>")
    return "\n".join([*lines, "</svg>"]) + "\n"


def _text(text: Text, at: tuple[float, float], scale: float) -> str:
    colour = LAYERS[text.layer][0]
    size = text.height * scale / 0.72  # the height of a drawing's text is that of its capitals
    # Lowered by half a capital, text is centred about its anchor whatever the viewer makes of baselines.
    drop = 0.5 * text.height * scale if text.align == "middle" else 0.0
    anchor = "middle" if text.align == "middle" else "start"
    turn = f"translate({at[0]:.4f} {at[1]:.4f}) rotate({-text.angle:.4f}) translate(0 {drop:.4f})"
    return (
        f'<text transform="{turn}" font-size="{size:.4f}" text-anchor="{anchor}" fill="{colour}" stroke="none">'
        f"{escape(text.text)}</text>"
    )
