"""Tables of a scan's curvature: a row a point, and a column of errors beside each value that has one."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.analysis.table import Column, Table
from quintrig.quantities.table import BY_KEY, quantity
from quintrig.scan.curvature import CLASSES, VALUES, ScanCurvature
from quintrig.support.arrays import FloatArray

STANDARD = (*VALUES, *CLASSES)
"""Quantities of a table for which none are named."""


def tabulate_scan(
    found: ScanCurvature, quantities: Iterable[str] | None = None, chosen: NDArray[Any] | None = None, title: str = ""
) -> Table:
    """Return a table of a scan's points, or the ``chosen`` ones; ValueError for a quantity that scans have not."""
    keys = [quantity(key).key for key in (STANDARD if quantities is None else quantities)]
    at = np.arange(len(found.scan.points)) if chosen is None else chosen
    unit = found.scan.unit
    words = tuple("border" if on else "inside" for on in found.border[at].tolist())
    columns = [
        _numbers(axis, axis, axis, f"{axis} of the point", unit, found.scan.points[at, k])
        for k, axis in enumerate("xyz")
    ]
    columns.append(Column("border", "border", r"\mathrm{border}", "place of the point", "", words, words))
    for key in dict.fromkeys(keys):
        values, q = found[key][at], BY_KEY[key]
        if q.kind == "class":
            codes: list[int] = values.tolist()
            names = tuple(q.classes[code] for code in codes)
            columns.append(Column(key, q.symbol, q.latex, q.name, "", names, names))
        elif q.kind == "vector":
            if key != "point":
                columns += [
                    _numbers(
                        f"{key}_{axis}",
                        f"{q.symbol}_{axis}",
                        f"{{{q.latex}}}_{axis}",
                        f"{axis} of the {q.name}",
                        "",
                        values[:, k],
                    )
                    for k, axis in enumerate("xyz")
                ]
        else:
            columns.append(_numbers(key, q.symbol, q.latex, q.name, q.unit(unit), values))
            latex = rf"\Delta {q.latex}"
            columns.append(
                _numbers(
                    f"{key}_error", f"±{q.symbol}", latex, f"error of the {q.name}", q.unit(unit), found.errors[key][at]
                )
            )
    return Table(title, notes_of(found), tuple(columns), lead=3)


def notes_of(found: ScanCurvature) -> tuple[str, ...]:
    """Return what a reader of the values has to know, one sentence each."""
    unit = f" {found.scan.unit}" if found.scan.unit else ""
    notes = [
        f"Lengths in {found.scan.unit}." if unit else "Lengths are plain numbers: the scan states no unit.",
        f"The normal n points to {found.side}."
        if not found.side.startswith("up")
        else f"The normal n points {found.side}.",
        f"Polynomials of degree {found.degree} over {found.neighbours} neighbours, {found.radius:.3g}{unit} around; "
        f"they scatter by {found.noise:.3g}{unit}.",
        "About 95 of 100 values are nearer to the truth than their error; a class counts as zero what is below it.",
    ]
    count = int(found.border.sum())
    if count:
        notes.append(f"{count:,} of {len(found.border):,} points lie on the border, where values are worse.")
    return (*notes, *found.scan.notes)


def _numbers(key: str, symbol: str, latex: str, name: str, unit: str, values: FloatArray) -> Column:
    numbers = tuple(np.asarray(values, dtype=np.float64).tolist())
    return Column(key, symbol, latex, name, unit, numbers, numbers)
