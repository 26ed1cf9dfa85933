"""B-spline curves in space as edges of OpenCASCADE, and as a STEP file."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from quintrig.exchange.cad import write
from quintrig.exchange.cad.occ import array_type, module, quiet
from quintrig.exchange.cad.shell import Shell
from quintrig.support.arrays import FloatArray

Spline = tuple[int, FloatArray, FloatArray]
"""Degree, full knot vector and poles (n, 3), length¹."""


def step_curves(curves: Sequence[Spline], name: str, names: Sequence[str], unit: str, remark: str) -> bytes:
    """Return a STEP file of curves, each with its name; needs the extra ``cad``."""
    with quiet():
        builder, compound = module("BRep").BRep_Builder(), module("TopoDS").TopoDS_Compound()
        builder.MakeCompound(compound)
        edges = [_edge(curve) for curve in curves]
        for edge in edges:
            builder.Add(compound, edge)
    return write.step(Shell(compound, tuple(edges), ()), name, names, unit, "ap242", remark)


def _edge(curve: Spline) -> Any:
    degree, knots, points = curve
    values, counts = np.unique(knots, return_counts=True)
    poles = array_type("Array1_gp_Pnt")(1, len(points))
    for k, point in enumerate(points.tolist()):
        poles.SetValue(k + 1, module("gp").gp_Pnt(*point))
    places, many = array_type("Array1_double")(1, len(values)), array_type("Array1_int")(1, len(values))
    for k, (value, count) in enumerate(zip(values.tolist(), counts.tolist(), strict=True)):
        places.SetValue(k + 1, value)
        many.SetValue(k + 1, count)
    spline = module("Geom").Geom_BSplineCurve(poles, places, many, degree, False)
    maker = module("BRepBuilderAPI").BRepBuilderAPI_MakeEdge(spline)
    if not maker.IsDone():
        raise ValueError("OpenCASCADE makes no edge of a line; is it shorter than 1e-7?")
    return maker.Edge()
