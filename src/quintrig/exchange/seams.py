"""The seams of a model as DXF (R2010) through ezdxf: polylines in space, a layer for each order."""

import io

from quintrig.exchange.units import UNITS
from quintrig.multipatch.joins import ORDERS, Joins
from quintrig.support.extras import need

_COLOURS = {"open": 1, "G0": 30, "G1": 6, "G2": 5, "G3": 3}  # AutoCAD's numbers, near to those of the pictures


def seams_dxf(joins: Joins) -> str:
    """Return the text of a DXF file in the model's unit: layers SEAM_OPEN, SEAM_G0, ...; needs extra ``flat``."""
    ezdxf = need("ezdxf", "writing DXF")
    document = ezdxf.new("R2010", setup=True)
    document.header["$INSUNITS"] = UNITS[joins.unit].dxf if joins.unit else 0
    document.header["$MEASUREMENT"] = 0 if joins.unit in ("in", "ft") else 1
    for order in ORDERS:
        document.layers.add(layer(order), color=_COLOURS[order])
    space = document.modelspace()
    for one in joins.joins:
        space.add_polyline3d(one.points.tolist(), dxfattribs={"layer": layer(one.order)})
    text = io.StringIO()
    document.write(text)
    return text.getvalue()


def layer(order: str) -> str:
    """Return the name of the layer of an order."""
    return f"SEAM_{order.upper()}"
