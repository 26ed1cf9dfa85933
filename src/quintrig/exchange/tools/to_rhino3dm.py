"""Surfaces as the NURBS surfaces of rhino3dm, which Rhino, Grasshopper and Rhino.Compute read."""

from typing import Any

from quintrig.exchange.cad.forms import written_carriers
from quintrig.exchange.cad.rhino import to_rhino
from quintrig.exchange.origin import refuse_point
from quintrig.exchange.tools.whole import Given, alone, whole
from quintrig.support.extras import need


def to_rhino3dm(value: Given) -> Any:
    """Return a rhino3dm.NurbsSurface, of several patches a dict of them by name; see ``Handed.to_rhino3dm``."""
    rhino = need("rhino3dm", "to_rhino3dm")
    model = whole(value)
    refuse_point(model)
    parts = {part.name: to_rhino(rhino, part.form) for part in written_carriers(model)}
    return next(iter(parts.values())) if alone(value) else parts
