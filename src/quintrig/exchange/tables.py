"""The CSV, JSON, Markdown and LaTeX forms of tables.

CSV and JSON keep every digit (a number read back is the same number); Markdown and LaTeX show six significant figures.
"""

import csv
import io
import json
import math
import re
from collections.abc import Callable

from quintrig.analysis.table import Table
from quintrig.support.csv_rows import guarded

_WIDEST = 8
"""Columns of a LaTeX table that fit on a page beside each other."""


def to_csv(table: Table) -> str:
    """Return comma-separated values headed by the keys, after notes on lines with ``#``; NaN is left empty."""
    stream = io.StringIO()
    units = ", ".join(f"{column.key} in {column.unit}" for column in table.columns if column.unit)
    for note in (_guarded(table.title), *table.notes, units and f"Units: {units}"):
        if note:
            stream.write(f"# {' '.join(note.split())}\n")
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([column.key for column in table.columns])
    writer.writerows([_exact(value) for value in row] for row in table.rows)
    return stream.getvalue()


def to_json(table: Table) -> str:
    """Return a JSON object: title, notes, columns (key, symbol, name, unit) and one object a row.

    Of a trimmed face also its region, trimmed or whole. NaN becomes null; an infinite value, for which JSON has no
    number, the text "inf" or "-inf".
    """
    keys = [column.key for column in table.columns]
    document = {
        "title": table.title,
        "notes": table.notes,
        **({"region": table.region} if table.region else {}),
        "columns": [
            {"key": column.key, "symbol": column.symbol, "name": column.name, "unit": column.unit}
            for column in table.columns
        ],
        "rows": [dict(zip(keys, map(_json_value, row), strict=True)) for row in table.rows],
    }
    return json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def to_markdown(table: Table) -> str:
    """Return a Markdown table with six significant figures, after its title and notes."""
    lines = [f"**{_escape(' '.join(table.title.split()))}**", ""] if table.title else []
    for note in table.notes:
        lines += [_escape(note), ""]
    lines.append("| " + " | ".join(_escape(column.heading) for column in table.columns) + " |")
    rules = ("---" if column.is_text else "---:" for column in table.columns)
    lines.append("| " + " | ".join(rules) + " |")
    rows = zip(*(column.rounded for column in table.columns), strict=True)
    lines += ["| " + " | ".join(_escape(shown(value)) for value in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def _latex(table: Table) -> str:
    from quintrig.exchange.latex import to_latex  # read where it is asked for alone

    return to_latex(table)


WRITERS: dict[str, Callable[[Table], str]] = {
    "csv": to_csv,
    "json": to_json,
    "md": to_markdown,
    "latex": _latex,
}
"""Writer by format."""

TABLE_FORMATS: dict[str, str] = {".csv": "csv", ".json": "json", ".md": "md", ".tex": "latex"}
"""Format by the ending of a file's name."""


def shown(value: float | str, figures: int = 6) -> str:
    """Return a value as people read it: so many significant figures, a dash where it is undefined."""
    if isinstance(value, str):
        return value
    if math.isnan(value):
        return "–"
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    mantissa, _, exponent = f"{value:.{figures}g}".partition("e")
    return f"{mantissa}e{int(exponent)}" if exponent else mantissa


def _exact(value: float | str) -> str:
    if isinstance(value, str):
        return guarded(value)
    return "" if math.isnan(value) else repr(value)


def _guarded(text: str) -> str:
    """Return a title, whose commas a spreadsheet takes for the ends of cells, without a formula in a cell."""
    return "".join(part if part in ",;" else guarded(part) for part in re.split("([,;])", text))


def _json_value(value: float | str) -> float | str | None:
    if isinstance(value, str) or math.isfinite(value):
        return value
    return None if math.isnan(value) else repr(value)


def _escape(text: str) -> str:
    r"""Return text without what Markdown takes for its own: emphasis, code, links, entities, tags, cells, formulas."""
    return "".join(f"\\{c}" if c in "\\`*_[]<>&|$~" else c for c in text)
