"""Lines and tables on the terminal."""

import os
import sys
from typing import TYPE_CHECKING

import typer

from quintrig.cli import session

if TYPE_CHECKING:
    from collections.abc import Iterator

    from quintrig.analysis.table import Column, Table


_LISTED = 2  # rows that are easier to read down the screen than across


def line(*parts: str | tuple[str, str]) -> None:
    """Print a line of texts, some with the name of a colour, bold or dim, which a terminal alone shows."""
    wanted = "NO_COLOR" not in os.environ and os.environ.get("TERM") != "dumb" and sys.stdout.isatty()
    typer.echo("".join(part if isinstance(part, str) else _styled(*part, wanted) for part in parts))


def _styled(text: str, how: str, wanted: bool) -> str:
    if not wanted:
        return text
    return typer.style(text, **{how: True}) if how in ("bold", "dim") else typer.style(text, fg=how)


def print_table(table: "Table") -> None:
    """Print a table with its notes: one or two rows as a list down the screen, more as a table across it.

    A table too wide for the screen is cut into parts below one another.
    """
    if 1 <= len(table.columns[0].values) <= _LISTED:
        for text in listed(table):
            line(text)
        return
    from rich.markup import escape

    screen = session.output()
    if table.title:
        screen.print(f"[bold]{escape(table.title)}[/bold]")
    for columns in _fitting(table, screen.width):
        screen.print(_drawn(columns, table.lead))
    for note in table.notes:
        screen.print(f"[dim]{escape(note)}[/dim]")


def listed(table: "Table") -> "Iterator[str]":
    """Return the lines of a table of few rows as a list: one quantity a line, one row of the table a column."""
    from quintrig.exchange.tables import shown

    if table.title:
        yield table.title
    cells = [[shown(value) for value in column.rounded] for column in table.columns]
    names = [column.symbol for column in table.columns]
    widths = [max(len(row[k]) for row in cells) for k in range(len(cells[0]))]
    for name, row, column in zip(names, cells, table.columns, strict=True):
        values = "   ".join(
            cell.ljust(width) if column.is_text else cell.rjust(width) for cell, width in zip(row, widths, strict=True)
        )
        unit = "" if column.unit == "" else f"   {column.unit}"
        yield f"  {name:<{max(map(len, names))}}   {values}{unit}".rstrip()
    yield from table.notes


def list_quantities(wanted: bool) -> None:
    """Print the table of quantities and stop, for the option --list."""
    if not wanted:
        return
    from rich import box
    from rich.table import Table as Drawn

    from quintrig.quantities.table import QUANTITIES

    drawn = Drawn(box=box.SIMPLE_HEAD, pad_edge=False)
    for heading in ("key", "symbol", "what it is", "unit (mm)"):
        drawn.add_column(heading, no_wrap=heading == "key", style="cyan" if heading == "key" else None)
    for q in QUANTITIES:
        meaning = f"{q.name}: {q.meaning}" if q.meaning != q.name else q.name
        drawn.add_row(q.key, q.symbol, meaning, q.unit("mm"))
    session.output().print(drawn)
    raise typer.Exit


def _fitting(table: "Table", width: int) -> "list[tuple[Column, ...]]":
    """Return the columns in the fewest parts of which each fits the screen."""
    names, rest = table.columns[: table.lead], table.columns[table.lead :]
    room = width - 1 - sum(map(_width, names))
    parts: list[tuple[Column, ...]] = []
    part: tuple[Column, ...] = ()
    for column in rest:
        if part and sum(map(_width, part)) + _width(column) > room:
            parts.append(names + part)
            part = ()
        part += (column,)
    return [*parts, names + part]


def _width(column: "Column") -> int:
    from quintrig.exchange.tables import shown

    # Two spaces between columns; a heading breaks between symbol and unit.
    words = max(len(column.symbol), len(column.unit) + 2 * bool(column.unit))
    return 2 + max(words, *(len(shown(value)) for value in column.rounded), 1)


def _drawn(columns: "tuple[Column, ...]", lead: int) -> object:
    from rich import box
    from rich.table import Table as Drawn
    from rich.text import Text

    from quintrig.exchange.tables import shown

    drawn = Drawn(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 1, 0, 0))
    for index, column in enumerate(columns):
        heading = f"{column.symbol}\n({column.unit})" if column.unit else column.symbol
        justify = "left" if column.is_text else "right"
        drawn.add_column(heading, justify=justify, no_wrap=True, style="cyan" if index < lead else None)
    for row in zip(*(column.rounded for column in columns), strict=True):
        drawn.add_row(*(Text(shown(value)) for value in row))
    return drawn
