"""Summaries of designs with singular points, which no quadrature sees: infinite where the truth has no bound.

With α = -4 (or two coinciding rows of points) an edge stands still: S = P + x² A + x³ B + ... at the distance x, so the
curvature across it grows as det(A, B, S_v) / x. ∫(κ1² + κ2²) dA then has no bound, while the integrals of K, H and C
have one. A singular corner of a ruled surface, the apex of a cone and an edge of regression do the same. The points of
a quadrature stay away from all of these; so each edge of a singular design is looked at along two lines close to it,
and a developable is asked for its edge of regression.
"""

import numpy as np
from numpy.typing import NDArray

from quintrig.arrays import FloatArray
from quintrig.envelope import inner_regression
from quintrig.sample import SINGULAR, analyse, grid
from quintrig.surface import Surface
from quintrig.sweep.measure import Measure
from quintrig.sweep.summarise import COLUMNS, clenshaw_curtis

_NEAR, _NEARER = 14, 18  # octaves: rings of lines at these powers of 1/2 from the edges
_POINTS = 32  # on a line
_ROUNDING = 64.0 * np.finfo(np.float64).eps * 4.0**_NEARER  # that of S_uu·n beside |S_u|², which vanishes as x²
_CANCELLED = 1e-10  # share of C or C² that is rounding of zero, as in ``extremes``
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


def true_summaries(measure: Measure, count: int, points: int, surface: Surface) -> FloatArray:
    """Return the summaries (count, columns) of designs, from ``points`` a side and what lies beside singular edges.

    Where there is no bound extremes and bending energy are infinite; where a design has no regular point, or none
    beside an edge, they are NaN. ``surface`` is one of the designs.
    """
    nodes = clenshaw_curtis(points)
    result = measure(np.arange(count), nodes, nodes)
    reach = float(np.abs(surface(*grid(9, 9))).max())  # which rounding is relative to
    nothing = result[:, _AREA] <= (SINGULAR * reach) ** 2
    singular = np.flatnonzero((result[:, _SINGULAR] > 0.0) & ~nothing)
    if singular.size:
        result[singular] = _seen_beside_edges(result[singular], measure, singular, reach)
    if count == 1:
        _mark_regression(result[0], surface)
    result[nothing] = np.where(np.arange(len(COLUMNS)) == _PLATE, result[nothing], np.nan)
    result[nothing, _AREA], result[nothing, _SINGULAR] = 0.0, points**2
    return result


def _seen_beside_edges(result: FloatArray, measure: Measure, which: NDArray[np.intp], reach: float) -> FloatArray:
    rounding = _ROUNDING * reach / result[:, _AREA]
    near, nearer = _ring(measure, which, _NEAR), _ring(measure, which, _NEARER)
    curved = nearer[:, _CURVED]
    told = result.copy()
    with np.errstate(invalid="ignore"):
        for column, sense, power in _ENDS:
            now, then = sense * nearer[:, column], sense * near[:, column]
            floor = rounding * curved ** (power - 1) + _CANCELLED * curved**power
            told[(now - then > 0.5 * now) & (now > floor), column] = sense * np.inf
    told[np.isinf(told[:, _CURVED]), _BENDING] = np.inf
    lost = nearer[:, _SINGULAR] > 0.0
    for column in (_BENDING, *(column for column, _, _ in _ENDS)):
        told[lost, column] = np.nan
    return told


def _ring(measure: Measure, which: NDArray[np.intp], octave: int) -> FloatArray:
    """Return the extremes on four lines together, 2^-octave from the edges; of the rest only ``singular`` has meaning.

    Points are as dense near their ends as the ends are near the edges: about one in each octave of t / (1 - t).
    """
    t = 1.0 / (1.0 + 2.0 ** np.linspace(0.5 - octave, octave - 0.5, _POINTS))
    along = (t, np.ones_like(t))
    across = (np.array([0.5**octave, 1.0 - 0.5**octave]), np.ones(2))
    first, second = measure(which, across, along), measure(which, along, across)
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
