"""Flat patterns as DXF (R2010) through ezdxf: layers, real dimensions, and the unit in $INSUNITS."""

import io

from quintrig.exchange.pattern.drawing import LAYERS, Drawing
from quintrig.exchange.units import UNITS
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import need


def dxf(drawing: Drawing) -> str:
    """Return the text of a DXF file in the model's unit; needs extra ``flat``; QuintrigError if its audit fails."""
    ezdxf = need("ezdxf", "writing DXF")
    document = ezdxf.new("R2010", setup=True)
    document.header["$INSUNITS"] = UNITS[drawing.unit].dxf if drawing.unit else 0
    document.header["$MEASUREMENT"] = 0 if drawing.unit in ("in", "ft") else 1
    for name, (_, colour, meaning) in LAYERS.items():
        layer = document.layers.add(name, color=colour, linetype="CENTER" if name.startswith("BEND") else "CONTINUOUS")
        layer.description = meaning
    document.header["$LTSCALE"] = 0.15 * drawing.text_height
    space = document.modelspace()
    for line in drawing.lines:
        points = [(float(x), float(y)) for x, y in line.points]
        space.add_lwpolyline(points, close=line.closed, dxfattribs={"layer": line.layer})
    for text in drawing.texts:
        settings = {"layer": text.layer, "height": text.height, "rotation": text.angle, "style": "OpenSans"}
        placed = space.add_text(text.text, dxfattribs=settings)
        where = "MIDDLE_CENTER" if text.align == "middle" else "LEFT"
        placed.set_placement(_point(text.at), align=ezdxf.enums.TextEntityAlignment[where])
    style = {
        "dimtxt": drawing.text_height,
        "dimasz": 0.9 * drawing.text_height,
        "dimexe": 0.6 * drawing.text_height,
        "dimexo": 0.4 * drawing.text_height,
        "dimgap": 0.4 * drawing.text_height,
        "dimtad": 1,
        "dimdec": 3,
        "dimlfac": 1.0,
        "dimscale": 1.0,
        "dimclrd": 8,
        "dimclre": 8,
        "dimclrt": 8,
    }
    for dimension in drawing.dimensions:
        space.add_linear_dim(
            base=_point(dimension.place),
            p1=_point(dimension.start),
            p2=_point(dimension.end),
            angle=dimension.angle,
            override=style,
            dxfattribs={"layer": "DIMENSIONS"},
        ).render()
    problems = document.audit()
    if problems.errors:
        raise QuintrigError(
            f"the DXF file is not valid ({problems.errors[0].message}); please report this with the model"
        )
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue()


def _point(values: object) -> tuple[float, float]:
    x, y = values  # pyright: ignore[reportGeneralTypeIssues, reportUnknownVariableType]
    return float(x), float(y)  # pyright: ignore[reportUnknownArgumentType]
