"""A scan beside its design in curvature, as the deviation compares them in distance."""

from typing import Any

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.quantities.table import quantity
from quintrig.scan.curvature import ScanCurvature
from quintrig.scan.deviation import Deviation
from quintrig.support.arrays import FloatArray

COMPARED = ("gaussian", "mean")


def curvature_columns(result: Deviation, found: ScanCurvature) -> dict[str, FloatArray]:
    """Return K and H of the scan, their errors, and those of the model at the feet, (n,) each: of length⁻², length⁻¹.

    The scan's normals are turned to the model's side. Points on the border of the scan, and those whose foot lies on an
    edge, have none (NaN).
    """
    gone = result.edge | found.border
    model = {key: np.full(len(result), np.nan) for key in COMPARED}
    side = np.ones(len(result))
    for index, surface in enumerate(result.surfaces):
        mine = result.patch == index
        sample = analyse(surface, result.u[mine], result.v[mine], ("normal", *COMPARED))
        for key in COMPARED:
            model[key][mine] = sample[key]
        turned = np.einsum("ij,ij->i", sample["normal"], found["normal"][mine]) < 0.0
        side[mine] = np.where(turned, -1.0, 1.0)
    columns: dict[str, FloatArray] = {}
    for key in COMPARED:
        values = found[key] * (side if quantity(key).parity == "odd" else 1.0)
        one = {key: values, f"{key}_error": found.errors[key], f"{key}_model": model[key]}
        columns |= {name: np.where(gone, np.nan, column) for name, column in one.items()}
    return columns


def curvature_gaps(columns: dict[str, FloatArray], unit: str = "") -> dict[str, Any]:
    """Return how curvature differs in ``curvature_columns``, for JSON.

    Of each quantity: the mean, rms and largest of scan minus model, the median of the scan's errors, and the share of
    points whose difference is within its error.
    """
    told: dict[str, Any] = {"points": 0}
    for key in COMPARED:
        gap, error = columns[key] - columns[f"{key}_model"], columns[f"{key}_error"]
        fine = np.isfinite(gap)
        told["points"] = max(told["points"], int(fine.sum()))
        if not fine.any():
            told[key] = None
            continue
        told[key] = {
            "mean": float(gap[fine].mean()),
            "rms": float(np.sqrt(np.mean(gap[fine] ** 2))),
            "max": float(np.abs(gap[fine]).max()),
            "error_median": float(np.median(error[fine])),
            "within_error": float((np.abs(gap[fine]) <= error[fine]).mean()),
            "unit": quantity(key).unit(unit),
        }
    return told
