"""Rows of numbers in CSV text, and cells of text that a spreadsheet does not take for formulas."""

import csv
import re

from quintrig.support.errors import ModelError
from quintrig.support.numerals import real

_LINE_END = re.compile(r"\r\n?|\n")
_FORMULA = ("=", "+", "-", "@", "\t", "\r")
_LOOKALIKES = str.maketrans("OoIl", "0011")


def rows_of(text: str) -> dict[int, list[float]]:
    """Return the rows of numbers, comma or semicolon separated, by their numbers in the text, which count every line.

    Lines with ``#`` are skipped, and so is a first row of words. Raises ModelError for a row that is not numbers, be
    it the first with a number misspelt.
    """
    lines = {
        number: line
        for number, line in enumerate(_LINE_END.split(text), 1)
        if line.strip() and not line.lstrip().startswith("#")
    }
    first = next(iter(lines), 0)
    delimiter = ";" if ";" in lines.get(first, "") else ","
    rows: dict[int, list[float]] = {}
    for number, line in lines.items():
        try:
            cells = next(csv.reader([line], delimiter=delimiter))
            rows[number] = [real(cell) for cell in cells]
        except (ValueError, csv.Error):
            cells = [cell.strip() for cell in line.split(delimiter)]
            if number == first and all(map(_is_word, cells)):
                continue
            hint = "" if len(cells) > 1 else "; put commas or semicolons between them"
            raise ModelError(f"row {number}: expected numbers, got {', '.join(cells)[:60]!r}{hint}") from None
    return rows


def guarded(cell: str) -> str:
    """Return a cell of text behind an apostrophe where a spreadsheet would take it for a formula.

    Numbers are no text: a minus in front of one is left as it is.
    """
    return f"'{cell}" if cell.lstrip(" ").startswith(_FORMULA) and not _is_number(cell) else cell


def _is_word(cell: str) -> bool:
    """Tell whether a cell may stand in a heading: a word or nothing, not a number with a slip of the pen in it."""
    text = cell.strip().strip("\"'").strip()
    if not text:
        return True
    if len(text) > 1 and _is_number(text.translate(_LOOKALIKES)):  # O.5, l0
        return False
    return text.isprintable() and not (text[0].isdigit() or text[0] in "+-.") and not _is_number(text)


def _is_number(cell: str) -> bool:
    try:
        real(cell)
    except ValueError:
        return False
    return True
