"""Curves through points in the plane or in space, in turn along the curve or not."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from quintrig.basis.functions import Functions
from quintrig.basis.library import Entry
from quintrig.basis.pairs import families, parameters
from quintrig.basis.registry import Choice, entry
from quintrig.model.model import Model
from quintrig.scan.deviation import Deviation
from quintrig.scan.scan import Scan
from quintrig.shaping.fitting.result import Fit, ShapeValue
from quintrig.support.arrays import FloatArray

_FINE = 400  # parameters at which the nearest place is looked for


def fit_curve(
    scan: Scan,
    basis: str | Sequence[str],
    shape: str | Sequence[float],
    size: int | None,
    tolerance: float | None,
    robust: bool,
    name: str,
) -> Fit:
    """Return a model of a curve nearest to points (n, 2 or 3), from the first to the last; ValueError for too few."""
    raise NotImplementedError
