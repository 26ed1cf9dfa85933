"""Extremes of the designs that a question returns, refined between the points of the sweep.

A sweep knows each design at its points only, so a design may pass ``gaussian_min >= 0`` and not be convex between them.
The designs that are shown are few, so each is looked at as ``quintrig check`` does, and one that meets the condition no
longer gives its place to the next.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from quintrig.analysis.extremes import find_ends
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError
from quintrig.sweep.query import Question, select
from quintrig.sweep.store import Sweep
from quintrig.sweep.summarise import EXTREMES

if TYPE_CHECKING:
    import polars as pl

_SPARE = 4  # times as many designs as are asked for are tried at most, and at least these more
_LEAST = 32


@dataclass(frozen=True, eq=False)
class Refined:
    """Columns (n,) of designs with refined extremes.

    ``dropped`` designs met the condition at the points of the sweep only, of ``tried`` that were refined; ``all_tried``
    says whether these are all that meet it there.
    """

    rows: dict[str, FloatArray]
    dropped: int
    tried: int
    all_tried: bool


def select_refined(sweep: Sweep, question: Question, limit: int) -> Refined:
    """Return the first ``limit`` designs asked for that still meet the condition with refined extremes, in its order.

    A least value only falls and a greatest only rises, by what lies between the points of the sweep. Raises
    QuintrigError as ``select`` does.
    """
    most = limit + max((_SPARE - 1) * limit, _LEAST)
    rows = {name: values.copy() for name, values in select(sweep, question, most + 1).items()}
    found = len(next(iter(rows.values())))
    candidates = min(found, most)
    tried = 0
    met = _met(question, rows, tried)
    while tried < candidates and len(met) < limit:
        start, tried = tried, min(tried + limit - len(met), candidates)
        for row in range(start, tried):
            _refine(sweep, rows, row)
        met = _met(question, rows, tried)
    shown = {name: np.asarray(met[name].to_numpy(), dtype=np.float64)[:limit] for name in sweep.task.columns}
    return Refined(shown, tried - len(met), tried, tried == found)


def _met(question: Question, rows: dict[str, FloatArray], tried: int) -> "pl.DataFrame":
    """Return the first ``tried`` rows that meet the condition, in the order asked for."""
    import polars as pl

    return question.on(pl.LazyFrame({name: values[:tried] for name, values in rows.items()})).collect()


def _refine(sweep: Sweep, rows: dict[str, FloatArray], row: int) -> None:
    """Write the refined extremes of one row; those without a bound, or without a value, stay. A curve's are refined."""
    if sweep.task.of_curve:
        return
    values = {name: float(rows[name][row]) for name in sweep.task.space.names}
    try:
        surfaces = sweep.task.family().surfaces(values)
    except ModelError:
        return
    ends = [(key, *pair) for surface in surfaces for key, pair in find_ends(surface, EXTREMES).items()]
    for key, least, greatest in ends:
        for name, end, sense in ((f"{key}_min", least, 1.0), (f"{key}_max", greatest, -1.0)):
            known = rows[name][row]
            if end.status == "unbounded":
                rows[name][row] = -sense * np.inf
            elif sense * end.value < sense * known:
                rows[name][row] = end.value
