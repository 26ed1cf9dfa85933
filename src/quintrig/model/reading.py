"""Small text files and tables of numbers, read whole or refused in one line."""

from pathlib import Path
from typing import Any

from quintrig.support.csv_rows import rows_of
from quintrig.support.errors import ModelError
from quintrig.support.files import open_regular
from quintrig.support.parsing import LARGEST_FILE


def read_text(path: Path, what: str = "a model") -> str:
    """Return the text of a small UTF-8 file; ModelError where it is missing, a folder, too large or not text.

    ``what`` is what the file should be, in words.
    """
    try:
        if path.is_dir():
            raise ModelError(f"{path}: expected a file, found a folder")
        size = path.stat().st_size
        if size > LARGEST_FILE:
            raise ModelError(
                f"{path}: expected at most {LARGEST_FILE >> 20} MB, found {size >> 20} MB; is this {what}?"
            )
        with open_regular(path) as file:
            # It may grow meanwhile.
            raw = file.read(LARGEST_FILE + 1)
    except ModelError:
        raise
    except FileNotFoundError:
        raise ModelError(f"{path}: no such file; check the path") from None
    except (OSError, ValueError) as error:
        raise ModelError(f"{path}: cannot be read ({_first_line(error)})") from None
    if len(raw) > LARGEST_FILE:
        raise ModelError(f"{path}: expected at most {LARGEST_FILE >> 20} MB, found more; is this {what}?")
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise ModelError(
            f"{path}: expected text in UTF-8, found the byte 0x{raw[error.start]:02x} in line {line}; is this {what}?"
        ) from None


def read_net(path: Path) -> list[list[float]]:
    """Return the rows of numbers of a CSV file, comma or semicolon separated; a heading and ``#`` lines are skipped.

    Raises ModelError, naming file and row, for anything else.
    """
    return list(read_rows(path).values())


def read_rows(path: Path) -> dict[int, list[float]]:
    """Return the rows that ``read_net`` does, by their numbers in the file, which count every line from 1."""
    text = read_text(path, "a table of numbers")
    try:
        return rows_of(text)
    except ModelError as error:
        raise ModelError(f"{path}: {error}") from None


def in_rows(points: list[Any], columns: int, place: str) -> list[Any]:
    """Return points listed row by row in rows of ``columns``; ValueError, naming ``place``, if one is not full."""
    if len(points) % columns:
        raise ValueError(f"{place}: expected a multiple of {columns} rows, got {len(points)}")
    return [points[i : i + columns] for i in range(0, len(points), columns)]


def _first_line(error: Exception) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0][:200]
