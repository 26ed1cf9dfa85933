"""Integration over the domain [0, 1]² by Gauss-Legendre panels that are doubled until two results agree.

The error stated is the difference of the last two results, which is that of the coarser one, so the value is better
than it says.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from quintrig.arrays import BoolArray, FloatArray, number

Status = Literal["converged", "not converged", "grows without bound", "undefined"]

NODES = 16
_ROWS = 64  # rows of nodes evaluated at once, so that memory stays small

Density = Callable[[FloatArray, FloatArray], FloatArray]
"""Integrands (k, nu, nv) at parameters (nu, 1) and (1, nv)."""
Measure = Callable[[int], tuple[FloatArray, FloatArray, FloatArray]]
"""Values (k,), the sizes (k,) that a relative tolerance refers to, and rounding (k,), for this many panels a side."""


@dataclass(frozen=True)
class Integral:
    """A value with its error, the difference of the last two resolutions, and what is to be said of it.

    The unit is that of the ``INTEGRALS`` row. NaN where the status is "undefined".
    """

    value: float
    error: float
    status: Status

    @property
    def converged(self) -> bool:
        """True where two resolutions agree to the tolerance."""
        return self.status == "converged"


def checked_tolerance(value: float) -> float:
    """Return a relative tolerance; ValueError outside [1e-13, 0.1]."""
    value = number(value, "tolerance")
    if not 1e-13 <= value <= 0.1:
        raise ValueError(f"tolerance: expected a number from 1e-13 to 0.1, found {value:g}")
    return value


def panel_sums(density: Density, panels: int) -> FloatArray:
    """Return the integrals (k,) over [0, 1]² with panels x panels Gauss-Legendre panels of 16 x 16 nodes."""
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    t = ((np.arange(panels)[:, None] + 0.5 * (nodes + 1.0)) / panels).reshape(-1)
    w = np.tile(weights, panels) * (0.5 / panels)
    parts = [slice(start, start + _ROWS) for start in range(0, len(t), _ROWS)]
    return np.sum([(density(t[part, None], t[None, :]) @ w) @ w[part] for part in parts], axis=0)


def converge(measure: Measure, tolerance: float, panels: int) -> tuple[list[Integral], int]:
    """Double the panels until all values agree, or ``panels`` a side are reached, or the others grow without bound.

    Returns the results and the number of panels of the last one. Raises ValueError for fewer than 2 panels.
    """
    if panels < 2:
        raise ValueError(f"panels: expected 2 or more, found {panels}")
    count = 1
    values, scales, noise = measure(count)
    history = [values]
    while True:
        count *= 2
        values, scales, noise = measure(count)
        history.append(values)
        steps = np.abs(np.diff(history, axis=0))
        agree = ~(steps[-1] > tolerance * scales + noise)
        growing = ~agree & _grows(np.array(history))
        # A narrow peak that is only just being resolved grows too, so a verdict before 16 panels would be rash.
        if agree.all() or 2 * count > panels or (count >= 16 and (agree | growing).all()):
            break
    results: list[Integral] = []
    for value, step, scale, good, grown in zip(values, steps[-1], scales, agree, growing, strict=True):
        status: Status = "converged" if good else "grows without bound" if grown else "not converged"
        if np.isnan(value):
            status = "undefined"
        error = step + 4.0 * np.finfo(np.float64).eps * scale
        results.append(Integral(float(value), float(error), status))
    return results, count


def _grows(history: FloatArray) -> BoolArray:
    """Return where the last three steps have one sign and do not shrink, as those of a divergent integral."""
    grows: BoolArray = np.zeros(history.shape[1:], dtype=np.bool_)
    if len(history) >= 4:
        first, second, third = np.diff(history[-4:], axis=0)
        same = (first * second > 0.0) & (second * third > 0.0)
        grows[...] = same & (np.abs(third) >= 0.9 * np.abs(second)) & (np.abs(second) >= 0.9 * np.abs(first))
    return grows
