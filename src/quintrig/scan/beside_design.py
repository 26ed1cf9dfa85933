"""A scan beside its design in curvature, as the deviation compares them in distance."""

from typing import Any

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.quantities.table import quantity
from quintrig.scan.curvature import ScanCurvature
from quintrig.scan.deviation import Deviation

COMPARED = ("gaussian", "mean")


def curvature_gaps(result: Deviation, found: ScanCurvature) -> dict[str, Any]:
    """Return how the curvature of a scan's points differs from that of the model at their feet, for JSON.

    Of each quantity: the mean and rms of scan minus model, the median of the scan's errors, and the share of points
    whose difference is within its error. Normals are turned to the model's side. Points on the border of the scan, and
    those whose foot lies on an edge, do not count.
    """
    kept = ~result.edge & ~found.border
    told: dict[str, Any] = {"points": int(kept.sum())}
    model = {key: np.full(len(result), np.nan) for key in COMPARED}
    side = np.ones(len(result))
    for index, surface in enumerate(result.surfaces):
        mine = result.patch == index
        sample = analyse(surface, result.u[mine], result.v[mine], ("normal", *COMPARED))
        for key in COMPARED:
            model[key][mine] = sample[key]
        turned = np.einsum("ij,ij->i", sample["normal"], found["normal"][mine]) < 0.0
        side[mine] = np.where(turned, -1.0, 1.0)
    for key in COMPARED:
        values = found[key] * (side if quantity(key).parity == "odd" else 1.0)
        gap = values - model[key]
        fine = kept & np.isfinite(gap)
        if not fine.any():
            told[key] = None
            continue
        told[key] = {
            "mean": float(gap[fine].mean()),
            "rms": float(np.sqrt(np.mean(gap[fine] ** 2))),
            "max": float(np.abs(gap[fine]).max()),
            "error_median": float(np.median(found.errors[key][fine])),
            "within_error": float((np.abs(gap[fine]) <= found.errors[key][fine]).mean()),
            "unit": quantity(key).unit(result.unit),
        }
    return told
