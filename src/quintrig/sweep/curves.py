"""Summaries of the designs of a curve, each built anew: what is a column, and its power of length."""

import numpy as np

from quintrig.analysis.curve_summary import summarise_curve
from quintrig.model.patch import NamedCurve
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError

CURVE_COLUMNS: dict[str, int] = {
    "length": 1,
    "curvature_min": -1,
    "curvature_max": -1,
    "torsion_min": -1,
    "torsion_max": -1,
    "bending_energy": -1,
    "inflections": 0,
    "singular": 0,
}
"""Columns of a curve's designs, with their powers of length; curvature is signed in the plane, left positive."""


def curve_summary(curve: NamedCurve, design: dict[str, float]) -> FloatArray:
    """Return the columns of one design; NaN where it cannot be built."""
    try:
        found = summarise_curve((curve.with_parameters(design) if design else curve).curve)
    except ModelError:
        return np.full(len(CURVE_COLUMNS), np.nan)
    values = {name: getattr(found, name) for name in CURVE_COLUMNS} | {"inflections": len(found.inflections)}
    return np.array([float(values[name]) for name in CURVE_COLUMNS])
