"""Questions to a sweep: which designs meet a condition, and which of them are best."""

import re
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from quintrig.basis.pairs import key_of
from quintrig.quantities.table import quantity
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ArgumentError, QuintrigError, nearest
from quintrig.support.extras import need
from quintrig.sweep.part import Task
from quintrig.sweep.store import Sweep

if TYPE_CHECKING:
    import polars as pl


@dataclass(frozen=True)
class Question:
    """Which designs, in which order: those that meet ``where``, by the column ``best``, least first.

    ``where`` is a condition in SQL on the columns, such as ``gaussian_min >= 0 AND area < 12``. Lengths are in the
    model's unit. A design where a column is undefined meets no condition on it, and comes last in its order. Columns
    may be called by symbols too: ``K_min``, ``κ1_max``, ``α1``.
    """

    where: str = ""
    best: str = ""
    descending: bool = False

    def __post_init__(self) -> None:
        """Replace symbols by the names of columns."""
        object.__setattr__(self, "where", re.sub(r"[^\W\d]\w*", lambda word: _column(word[0]), self.where))
        object.__setattr__(self, "best", _column(self.best))

    def check(self, task: Task) -> None:
        """Raise QuintrigError for a condition that cannot be read or an unknown column, before anything is computed."""
        need("polars", "a sweep")
        import polars as pl

        known = task.columns
        if self.best and self.best not in known:
            hint = nearest(self.best, known) or f"; known are {', '.join(known)}"
            raise QuintrigError(f"unknown column{hint}", "best", self.best)
        if self.descending and not self.best:
            raise QuintrigError("says the order of a column", "descending", remedy="give it as best", key="best")
        try:
            self.on(pl.LazyFrame(schema=dict.fromkeys(known, pl.Float64))).collect()
        except (pl.exceptions.PolarsError, pl.exceptions.PanicException) as error:
            reason = (str(error).splitlines() or [""])[0].partition("; valid columns")[0][:120]
            raise QuintrigError(
                f"{reason}; expected a condition such as 'gaussian_min >= 0 AND singular = 0' on the columns "
                f"{', '.join(known)}",
                "where",
                repr(self.where),
            ) from None

    def on(self, table: "pl.LazyFrame") -> "pl.LazyFrame":
        """Return the rows asked for, in order."""
        import polars as pl

        # Polars takes NaN for the greatest of numbers; as null, an undefined value meets no condition.
        table = table.fill_nan(None)
        if self.where.strip():
            table = table.filter(pl.sql_expr(self.where))
        if self.best:
            table = table.sort(self.best, descending=self.descending, nulls_last=True, maintain_order=True)
        return table


def _column(word: str) -> str:
    """Return the column that a word with a symbol in it means, or the word."""
    what, _, end = word.rpartition("_")
    if end not in ("min", "max", "mean"):
        return key_of(word)
    with suppress(ArgumentError):
        return f"{quantity(what).key}_{end}"
    return word


def count(sweep: Sweep, question: Question) -> int:
    """Return how many designs meet the condition; QuintrigError as for ``select``."""
    import polars as pl

    question.check(sweep.task)
    unordered = Question(question.where)
    return int(_collected(sweep, unordered, lambda table: table.select(pl.len()))["len"][0])


def select(sweep: Sweep, question: Question, limit: int | None = None) -> dict[str, FloatArray]:
    """Return the columns of the designs asked for, the first ``limit`` of them, each of shape (n,).

    Raises QuintrigError for a condition that cannot be read, an unknown column, a sweep without parts or a part that
    cannot be read.
    """
    found = _collected(sweep, question, lambda table: table if limit is None else table.head(limit))
    return {name: np.asarray(found[name].to_numpy(), dtype=np.float64) for name in sweep.task.columns}


def _collected(sweep: Sweep, question: Question, last: "Callable[[pl.LazyFrame], pl.LazyFrame]") -> "pl.DataFrame":
    """Return the table that ``last`` makes of the rows asked for."""
    question.check(sweep.task)
    import polars as pl

    files = sweep.files()
    if not files:
        raise QuintrigError(f"{sweep.folder}: holds no finished part yet; run the sweep first")
    try:
        return last(question.on(pl.scan_parquet(files, glob=False))).collect()
    except (pl.exceptions.PolarsError, pl.exceptions.PanicException, OSError) as error:
        reason = (str(error).splitlines() or [""])[0][:200]
        raise QuintrigError(
            f"{sweep.folder}: cannot be read ({reason}); give the command that began the sweep again, which repairs it"
        ) from None
