"""How each kind of table of the inventory is made: plain rows of text for the page, and files with every digit."""

import csv
import io
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.analysis.table import Column, Table, tabulate
from quintrig.exchange.latex import to_latex
from quintrig.exchange.tables import shown
from quintrig.geometry.domain import grid
from quintrig.geometry.surface import Surface
from quintrig.quantities.signs import SIGN_TABLES
from quintrig.quantities.table import BY_KEY
from quintrig.reproduce.inventory import Item, labelled_points, model
from quintrig.support.csv_rows import guarded

KEYS = (
    "gaussian",
    "mean",
    "k1",
    "k2",
    "shape_index",
    "curvedness",
    "beta0",
    "beta1",
    "beta2",
    "gamma1",
    "gamma2",
    "gamma3",
    "hk_type",
    "shape_class",
    "point_type",
    "invariant_type",
)
"""What a data table of chapter 4 lists at each corresponding point."""


@dataclass(frozen=True)
class PrintedTable:
    """A table for people: ``title`` of this part, heads and rows as text, remarks; ``files`` hold it by suffix."""

    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    notes: tuple[str, ...] = ()
    files: tuple[tuple[str, str], ...] = ()


def tables(item: Item) -> tuple[PrintedTable, ...]:
    """Return the parts of a table: one, or one for each set of shape parameters."""
    if item.draw == "signs":
        return (_signs(item.number),)
    if item.draw == "validation":
        return (_validation(item),)
    return tuple(_data(item))


def _signs(number: str) -> PrintedTable:
    table = next(table for table in SIGN_TABLES if table.number == number)
    notes = (f"Source: {table.source}.",)
    files = (
        (".csv", _csv([table.columns, *table.rows])),
        (".tex", _latex(table.title, table.columns, table.rows, notes)),
    )
    return PrintedTable(table.title, table.columns, table.rows, notes, files)


def _validation(item: Item) -> PrintedTable:
    """Compare computed with closed-form curvature of the sphere and the cylinder, over a grid and at its worst."""
    heads = (
        "surface",
        "quantity",
        "unit",
        "closed form",
        "computed, least",
        "computed, greatest",
        "largest difference",
    )
    rows: list[tuple[str, ...]] = []
    for name in item.models:
        patch = model(name).patch()
        radius = float(getattr(patch.definition, "radius", 1.0))
        exact = {"gaussian": radius**-2, "mean": -1.0 / radius, "k1": -1.0 / radius, "k2": -1.0 / radius}
        exact |= {"curvedness": 1.0 / radius, "shape_index": 1.0}
        if name == "cylinder":
            exact = {"gaussian": 0.0, "mean": -0.5 / radius, "k1": 0.0, "k2": -1.0 / radius}
            exact |= {"curvedness": 0.5**0.5 / radius, "shape_index": 0.5}
        sample = analyse(patch.surface, *grid(129, 129), tuple(exact))
        for key, value in exact.items():
            found = sample[key]
            worst = float(np.nanmax(np.abs(found - value)))
            unit = BY_KEY[key].unit(model(name).unit)
            numbers = (value, float(np.nanmin(found)), float(np.nanmax(found)))
            cells = [f"{number + 0.0:.15g}" for number in numbers]
            rows.append(
                (f"{name}, r = {radius:g} {model(name).unit}", BY_KEY[key].symbol, unit, *cells, f"{worst:.1e}")
            )
    note = (
        "Over 129 x 129 points, without the poles of the sphere, where this parametrisation has no tangent plane. "
        "The normal points outwards, so that H, κ1 and κ2 are negative."
    )
    title = "Computed against closed form"
    files = ((".csv", _csv([heads, *rows])), (".tex", _latex(title, heads, rows, (note,))))
    return PrintedTable(title, heads, tuple(rows), (note,), files)


def _data(item: Item) -> Iterator[PrintedTable]:
    """Tabulate the corresponding points, once for each set of shape parameters."""
    base = model(item.models[0])
    points = labelled_points()
    u, v = np.array(list(points.values())).T
    for shape in item.shapes or (None,):
        surface: Surface = base.patch().surface if shape is None else base.patch().with_shape(shape).surface
        spelt = "" if shape is None else "(" + ", ".join(f"{value:g}" for value in shape) + ")"
        title = f"{item.name}: {base.name}{f', shape parameters {spelt}' if spelt else ''}"
        table = tabulate(surface, u, v, KEYS, unit=base.unit, title=title)
        columns = table.columns
        heads = ("point", *(column.heading for column in columns))
        rows = [(label, *(shown(column.rounded[i]) for column in columns)) for i, label in enumerate(points)]
        named = replace(table, columns=(_column("point", tuple(points)), *columns), lead=table.lead + 1)
        exact = [heads, *((label, *map(str, row)) for label, row in zip(points, table.rows, strict=True))]
        yield PrintedTable(
            f"Shape parameters {spelt}" if spelt else base.name,
            heads,
            tuple(rows),
            table.notes,
            ((".csv", _csv(exact)), (".tex", to_latex(named))),
        )


def _latex(title: str, heads: Sequence[str], rows: Sequence[tuple[str, ...]], notes: tuple[str, ...]) -> str:
    columns = (_column(head, cells) for head, cells in zip(heads, zip(*rows, strict=True), strict=True))
    return to_latex(Table(title, notes, tuple(columns), lead=1))


def _column(head: str, cells: tuple[str, ...]) -> Column:
    """Return a column of numbers where all cells are, else of text."""
    try:
        values: tuple[float, ...] | tuple[str, ...] = tuple(float(cell) for cell in cells)
    except ValueError:
        values = cells
    return Column(head, head, rf"\mathrm{{{head.replace(' ', '~')}}}", head, "", values, values)


def _csv(rows: Sequence[Sequence[str]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([guarded(cell) for cell in row] for row in rows)
    return text.getvalue()
