"""Tables of points as programs and instruments write them: what separates, which column is what, which unit."""

import codecs
import csv
import io
import re
from array import array
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from quintrig.exchange.point_columns import Columns, named, unnamed
from quintrig.exchange.units import stated_unit
from quintrig.scan.scan import Scan, scan_of
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError, printable

_HEAD = 65536  # bytes in which the layout shows
_REMARK = re.compile(r"(?:#(?!N/?[AV]|VALUE)|//|%|!).*")  # Excel's #N/A is none
_COMMA = re.compile(r"[-+]?\d*,\d+(?:[eEdD][-+]?\d+)?")  # a number with a decimal comma
_WHOLE = re.compile(r"[-+]?\d+")
_GROUPED = re.compile(r"[-+]?\d{1,3}(?:(?:,\d{3})+\.\d*|(?:,\d{3}){2,})")  # one with commas between thousands
_MISSING = {"", "nan", "na", "n/a", "#n/a", "null", "none", "-", "--", "inf", "-inf", "+inf", "#value!", "#nv"}


@dataclass(frozen=True)
class Layout:
    """How a table is written: what separates its cells, None for blanks, and where the numbers begin."""

    delimiter: str | None
    skip: int
    columns: Columns


def read_table(raw: bytes) -> Scan:
    """Return the points of a table, one a line, as ``read_scan`` says; ModelError with the row and what is wrong."""
    raw = _as_text(raw)
    layout = _layout(raw[:_HEAD].decode("utf-8", "ignore"))
    rows = _quick(raw, layout)
    if rows is None:
        rows = _slow(raw.decode("utf-8"), layout)
    if not rows.size:
        raise ModelError("expected points, found no line of numbers")
    columns = layout.columns
    notes: tuple[str, ...] = ()
    if not columns.by_name:
        columns, notes = unnamed(rows)
    found = scan_of(
        rows[:, columns.axes],
        rows[:, columns.normals] if columns.normals and len(columns.axes) == 3 else None,
        weights=None if columns.weight is None else rows[:, columns.weight],
    )
    return replace(found, unit=layout.columns.unit, notes=(*notes, *found.notes))


def _as_text(raw: bytes) -> bytes:
    """Return a text in UTF-8 with plain ends of lines; ModelError for what is no text."""
    if raw.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        raw = raw.decode("utf-16", "replace").encode()
    raw = raw.removeprefix(codecs.BOM_UTF8)
    odd = re.search(rb"[\x00-\x08\x0e-\x1f\x7f]", raw)
    if odd:
        line = raw.count(b"\n", 0, odd.start()) + 1
        raise ModelError(f"expected text, found the byte 0x{raw[odd.start()]:02x} in line {line}")
    try:
        raw.decode("utf-8")
    except UnicodeDecodeError:
        raw = raw.decode("cp1252", "replace").encode()
    return raw.replace(b"\r", b"\n") if b"\r" in raw and b"\n" not in raw else raw


def _layout(head: str) -> Layout:
    """Find out how a table is laid out from its first lines."""
    lines = head.splitlines()
    last_words: list[str] = []
    unit = ""
    for index, line in enumerate(lines):
        bare = line.strip()
        remark = bool(_REMARK.match(bare))
        bare = bare.lstrip("#/%! ") if remark else bare
        delimiter = _separated(bare)
        cells = _cells(bare, delimiter)
        numbers = [column for column, cell in enumerate(cells) if number(cell, delimiter) is not None]
        if remark or len(numbers) < 2 or (len(numbers) < 0.5 * len(cells) and not named(last_words).by_name):
            unit = stated_unit(bare) or unit
            if len(cells) > 1 and not numbers and (not remark or named(cells).by_name):
                last_words = cells
            continue
        columns = named(last_words) if len(last_words) >= len(cells) else Columns()
        if not columns.by_name:
            _refuse_other_names(last_words, cells, numbers)
            columns = replace(columns, used=numbers)
        return Layout(delimiter, index, replace(columns, unit=columns.unit or unit))
    raise ModelError("expected points, found no line of numbers")


def _refuse_other_names(words: list[str], cells: list[str], numbers: list[int]) -> None:
    """Refuse a heading of as many words as there are columns, more than three, that names no x and y."""
    if len(words) == len(cells) and len(numbers) > 3:
        names = ", ".join(printable(word) for word in words)[:80]
        raise ModelError(f"expected columns with the names x, y and z, found {names}; name them in the heading")


def _separated(line: str) -> str | None:
    """Return what separates the cells of a line, None for blanks; where it is not the comma, commas are decimal."""
    for mark in (";", "|", "\t"):
        if mark in line:
            return None if mark == "\t" and "" not in line.split(mark) else mark
    words = line.split()
    decimal = len(words) > 1 and all(_COMMA.fullmatch(word) or _WHOLE.fullmatch(word) for word in words)
    return "," if "," in line and not decimal else None


def _cells(line: str, delimiter: str | None) -> list[str]:
    if delimiter is None:
        return line.split()
    return [cell.strip() for row in csv.reader([line], delimiter=delimiter, skipinitialspace=True) for cell in row]


def number(cell: str, delimiter: str | None) -> float | None:
    """Return the number in a cell, NaN for what says that there is none, None for other words."""
    cell = cell.strip(" \"'")
    if cell.lower() in _MISSING:
        return float("nan")
    if delimiter != ",":
        cell = (cell.replace(".", "") if re.search(r"\.\d{3},", cell) else cell).replace(",", ".")
    elif _GROUPED.fullmatch(cell):
        cell = cell.replace(",", "")
    elif _COMMA.fullmatch(cell) and not re.search(r",\d{3}$", cell):  # 1,234 may be either
        cell = cell.replace(",", ".")
    try:
        return float(cell)
    except ValueError:
        try:
            return float(re.sub("[dD]", "e", cell, count=1))  # Fortran's exponents
        except ValueError:
            return None


def _quick(raw: bytes, layout: Layout) -> FloatArray | None:
    """Return the numbers of the columns as NumPy reads them, None for what it does not."""
    if b'"' in raw or re.search(rb"#N/?[AV]|#VALUE", raw):
        return None
    if layout.delimiter != "," and b"," in raw:
        if re.search(rb"\d\.\d{3},\d", raw):
            return None
        raw = raw.replace(b",", b".")
    for remark in (b"//", b"%", b"!"):  # may stand anywhere in the file
        raw = raw.replace(remark, b"#")
    try:
        return np.loadtxt(
            io.TextIOWrapper(io.BytesIO(raw), "latin-1"),
            delimiter=layout.delimiter,
            comments="#",
            skiprows=layout.skip,
            ndmin=2,
            usecols=layout.columns.used,
        )
    except ValueError:
        return None


def _slow(text: str, layout: Layout) -> FloatArray:
    """Return the numbers of the columns, row by row: with cells that are missing, and telling where one is wrong."""
    used, found = layout.columns.used, array("d")
    rows: Any = text.split("\n")
    width = 0
    for row, line in enumerate(rows, 1):
        bare = line.strip("\r ")
        if row <= layout.skip or not bare or _REMARK.match(bare):
            continue
        cells = _cells(_REMARK.sub("", bare), layout.delimiter)
        width = width or len(cells)
        if len(cells) <= max(used):
            raise ModelError(f"row {row}: expected {width} numbers as in the rows before, got {len(cells)}")
        for column in used:
            value = number(cells[column], layout.delimiter)
            if value is None:
                raise ModelError(f"row {row}: expected a number, got {printable(cells[column])[:40]!r}")
            found.append(value)
    return np.frombuffer(found, dtype=np.float64).reshape(-1, len(used)).copy()
