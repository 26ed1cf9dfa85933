"""Integration over the domain [0, 1]² by Gauss-Legendre panels that are doubled until two results agree.

Panels never reach over a knot, where derivatives may jump. Those next to an edge are graded: each a quarter of the one
before, down to the width of the layer there in which the
integrand changes (``layers`` measures it). Doubling shifts the graded panels too, so that their error is seen as well.
The error stated is the difference of the last two results, which is that of the coarser one, so the value is better
than it says. A trimmed face has nodes inside its loops only (``trimmed``).
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np

from quintrig.geometry.trimmed import Nodes
from quintrig.support.arrays import BoolArray, FloatArray, number
from quintrig.support.legendre import legendre

Status = Literal["converged", "not converged", "grows without bound", "undefined"]

NODES = 16
MOST_NODES = NODES**2 * 64**2
"""Nodes of the last resolution: a few seconds of work."""

_GRADING = 0.25  # 16 nodes see a pole at the near end of such a panel's neighbour to 1e-15
_WHOLE: FloatArray = np.array([0.0, 1.0])
_ROWS = 64  # rows of nodes evaluated at once, so that memory stays small

Density = Callable[[FloatArray, FloatArray], FloatArray]
"""Integrands (k, nu, nv) at parameters (nu, 1) and (1, nv), or (k, n) at (n,) and (n,)."""
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


def graded(panels: int, first: float, last: float, breaks: FloatArray = _WHOLE) -> FloatArray:
    """Return the ends of panels of [0, 1], those at its ends graded to layers of these widths.

    Each part between two ``breaks``, where the integrand is not smooth, has ``panels`` equal ones.
    """
    start, end = _grades(panels, first) * breaks[1], _grades(panels, last) * (1.0 - breaks[-2])
    pieces: list[FloatArray] = [np.linspace(a, b, panels + 1)[1:] for a, b in pairwise(breaks)]
    inner = np.concatenate([breaks[:1], *pieces])
    return np.concatenate([inner[:1], start, inner[1:-1], 1.0 - end[::-1], inner[-1:]])


def nodes_for(parts: int) -> int:
    """Return how many nodes a panel has where the domain has so many ``parts`` a side: fewer where parts are many."""
    return NODES if parts <= 8 else NODES // 2 if parts <= 64 else NODES // 4


def _grades(panels: int, layer: float) -> FloatArray:
    """Return where to cut the first panel, from the edge on, so that the piece at the edge is no wider than a layer.

    It is cut as often as [0, 1] would be: so doubling halves all panels, and an integral without bound keeps growing.
    """
    count = 0 if layer >= 1.0 else int(np.ceil(np.log(layer) / np.log(_GRADING)))
    return _GRADING ** np.arange(count, 0, -1) / panels


@dataclass(frozen=True, eq=False)
class Panels:
    """The ends of panels in u and in v, and the number of Gauss-Legendre nodes a side on each panel."""

    u: FloatArray
    v: FloatArray
    nodes: int = NODES

    @property
    def points(self) -> int:
        """Number of nodes in all."""
        return self.nodes**2 * (len(self.u) - 1) * (len(self.v) - 1)


def panel_sums(density: Density, panels: Panels) -> FloatArray:
    """Return the integrals (k,) by the nodes of all panels."""
    (s, a), (t, w) = gauss(panels.u, panels.nodes), gauss(panels.v, panels.nodes)
    parts = [slice(start, start + _ROWS) for start in range(0, len(s), _ROWS)]
    return np.sum([(density(s[part, None], t[None, :]) @ w) @ a[part] for part in parts], axis=0)


def node_sums(density: Density, nodes: Nodes) -> FloatArray:
    """Return the integrals (k,) by given nodes."""
    return np.sum([density(nodes.u[part], nodes.v[part]) @ nodes.weights[part] for part in nodes.parts], axis=0)


def gauss(ends: FloatArray, count: int = NODES) -> tuple[FloatArray, FloatArray]:
    """Return the Gauss-Legendre nodes and weights, ``count`` on each panel between two ``ends``."""
    nodes, weights = legendre(count)
    half = 0.5 * np.diff(ends)
    return (ends[:-1, None] + half[:, None] * (nodes + 1.0)).reshape(-1), (half[:, None] * weights).reshape(-1)


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
