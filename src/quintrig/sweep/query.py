"""Questions to a sweep: which designs meet a condition, and which of them are best."""

from typing import Any, cast

import numpy as np

from quintrig.arrays import FloatArray
from quintrig.errors import QuintrigError, nearest
from quintrig.files import require
from quintrig.sweep.part import columns
from quintrig.sweep.store import Sweep


def select(
    sweep: Sweep, where: str = "", best: str = "", descending: bool = False, limit: int | None = None
) -> dict[str, FloatArray]:
    """Return columns of the designs that meet ``where``, ordered by the column ``best``, the first ``limit`` of them.

    ``where`` is a condition in SQL on the columns, such as ``gaussian_min >= 0 AND area < 12``. Lengths are in the
    model's unit. Raises QuintrigError for a condition that cannot be read, an unknown column, or a sweep without
    parts.
    """
    require("polars", "sweep")
    import polars as pl

    known = columns(sweep.task.space)
    if best and best not in known:
        raise QuintrigError(f"--best {best}: unknown column{nearest(best, known)}; known are {', '.join(known)}")
    if len(sweep.missing()) == sweep.parts:
        raise QuintrigError(f"{sweep.folder}: holds no finished part yet; run the sweep first")
    table = pl.scan_parquet(str(sweep.folder / "part-*.parquet"))
    try:
        if where:
            table = table.filter(pl.sql_expr(where))
        if best:
            table = table.sort(best, descending=descending, nulls_last=True)
        found = (table.head(limit) if limit is not None else table).collect()
    except pl.exceptions.PolarsError as error:
        reason = (str(error).splitlines() or [""])[0][:120]
        raise QuintrigError(
            f"--where {where!r}: {reason}; expected a condition such as 'gaussian_min >= 0 AND singular = 0' "
            f"on the columns {', '.join(known)}"
        ) from None
    return {name: np.asarray(cast(Any, found[name]).to_numpy(), dtype=np.float64) for name in known}
