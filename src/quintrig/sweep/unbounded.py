"""Summaries of designs with singular points, which no quadrature sees: infinite where the truth has no bound.

Where curvature has no bound beside an edge, ∫(κ1² + κ2²) dA has none either, while the integrals of K, H and C have
one. The points of a quadrature stay away from there; so each edge of a singular design is looked at along two lines
close to it, as in ``beside``, and a developable is asked for its edge of regression.
"""

import numpy as np
from numpy.typing import NDArray

from quintrig.analysis.sample import analyse
from quintrig.analysis.singular_edges import NEAR, NEARER, across, along, has_no_bound
from quintrig.developables.regression import inner_regression
from quintrig.geometry.domain import grid
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import SINGULAR
from quintrig.sweep.measure import Measure
from quintrig.sweep.nodes import drawn_nodes, layer_classes
from quintrig.sweep.summarise import COLUMNS

_BESIDE = 1e-6  # of a ruling, from the edge of regression

_BENDING, _PLATE, _AREA, _SINGULAR = (
    COLUMNS.index(name) for name in ("bending_energy", "thin_plate_energy", "area", "singular")
)
_CURVED = COLUMNS.index("curvedness_max")
_ENDS = tuple(
    (COLUMNS.index(f"{key}_{end}"), sense, power)
    for key, power in (("gaussian", 2), ("mean", 1), ("curvedness", 1))
    for end, sense in (("min", -1.0), ("max", 1.0))
)
"""Column, sense and power of 1/length of each extreme."""


def true_summaries(measure: Measure, widths: FloatArray, points: int, surface: Surface) -> FloatArray:
    """Return the summaries (n, columns) of designs, from ``points`` a side and what lies beside singular edges.

    ``widths`` (n, 4) are those of layers at u = 0, u = 1, v = 0 and v = 1, which the points are drawn to.

    Where there is no bound extremes and bending energy are infinite; where a design has no regular point, or none
    beside an edge, they are NaN. ``surface`` is one of the designs.
    """
    classes, member = np.unique(layer_classes(widths), axis=0, return_inverse=True)
    result = np.empty((len(widths), len(COLUMNS)))
    for number, (a, b, c, d) in enumerate(classes.tolist()):
        which = np.flatnonzero(member.reshape(-1) == number)
        result[which] = measure(which, drawn_nodes(points, a, b), drawn_nodes(points, c, d))
    reach = float(np.abs(surface.local_partials(*grid(9, 9), 0)).max())  # which rounding is relative to
    nothing = result[:, _AREA] <= (SINGULAR * reach) ** 2
    singular = np.flatnonzero((result[:, _SINGULAR] > 0.0) & ~nothing)
    if singular.size:
        result[singular] = _seen_beside_edges(result[singular], measure, singular, reach)
    if len(widths) == 1:
        _mark_regression(result[0], surface)
    result[nothing] = np.where(np.arange(len(COLUMNS)) == _PLATE, result[nothing], np.nan)
    result[nothing, _AREA], result[nothing, _SINGULAR] = 0.0, points**2
    return result


def _seen_beside_edges(result: FloatArray, measure: Measure, which: NDArray[np.intp], reach: float) -> FloatArray:
    noise = reach / result[:, _AREA]
    near, nearer = _ring(measure, which, NEAR), _ring(measure, which, NEARER)
    told = result.copy()
    for column, sense, power in _ENDS:
        endless = has_no_bound(sense * near[:, column], sense * nearer[:, column], nearer[:, _CURVED], noise, power)
        told[endless, column] = sense * np.inf
    told[np.isinf(told[:, _CURVED]), _BENDING] = np.inf
    lost = nearer[:, _SINGULAR] > 0.0
    for column in (_BENDING, *(column for column, _, _ in _ENDS)):
        told[lost, column] = np.nan
    return told


def _ring(measure: Measure, which: NDArray[np.intp], octave: int) -> FloatArray:
    """Return the extremes on a ring's four lines together; of the rest only ``singular`` has meaning."""
    running, fixed = ((t, np.ones_like(t)) for t in (along(octave), across(octave)))
    first, second = measure(which, fixed, running), measure(which, running, fixed)
    both = first + second
    for column, sense, _ in _ENDS:
        both[:, column] = sense * np.fmax(sense * first[:, column], sense * second[:, column])
    return both


def _mark_regression(row: FloatArray, surface: Surface) -> None:
    """Write infinity over what has no bound at an edge of regression inside a developable; K stays 0 beside it."""
    found = inner_regression(surface)
    if found is None:
        return
    row[_BENDING] = row[_CURVED] = np.inf
    u, v = found.u[found.inside], found.v[found.inside]
    mean = analyse(surface, u, np.clip(v + np.where(v < 0.5, _BESIDE, -_BESIDE), 0.0, 1.0), ("mean",))["mean"]
    if (mean < 0.0).any():
        row[COLUMNS.index("mean_min")] = -np.inf
    if (mean > 0.0).any():
        row[COLUMNS.index("mean_max")] = np.inf
