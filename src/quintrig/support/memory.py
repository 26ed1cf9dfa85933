"""What compiled loops do with memory, as they name it; ``numba_inside`` gives each its meaning.

Whoever gives an address keeps the array alive.
"""

from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from quintrig.support.arrays import FloatArray


def address(array: NDArray[Any]) -> int:
    """Return where the memory of an array without gaps begins; ValueError for one with gaps."""
    if not array.flags.c_contiguous:
        raise ValueError("array: expected one without gaps, rows first")
    return int(array.__array_interface__["data"][0])


def floats_at(_start: int) -> FloatArray:
    """Return the memory at an address as real numbers."""
    return _only_compiled()


def words_at(_start: int) -> NDArray[np.int64]:
    """Return the memory at an address as whole numbers of 8 bytes."""
    return _only_compiled()


def codes_at(_start: int) -> NDArray[np.int8]:
    """Return the memory at an address as whole numbers of 1 byte."""
    return _only_compiled()


def table_at(_start: int, _rows: int, _columns: int) -> FloatArray:
    """Return the memory at an address as an array of real numbers (rows, columns)."""
    return _only_compiled()


def whole_table_at(_start: int, _rows: int, _columns: int) -> NDArray[np.int64]:
    """Return the memory at an address as an array of whole numbers (rows, columns)."""
    return _only_compiled()


def stack_at(_start: int, _layers: int, _rows: int, _columns: int) -> FloatArray:
    """Return the memory at an address as an array of real numbers (layers, rows, columns)."""
    return _only_compiled()


def call(_function: int, _a: int, _b: int, _c: int, _d: int, _e: int, _f: int, _g: int) -> None:
    """Call the compiled function at an address with seven whole numbers."""
    _only_compiled()


def stream_line(_target: int, _source: int) -> None:
    """Copy eight numbers to an address at the start of a cache line, past the cache: the line is not read first."""
    _only_compiled()


def fence() -> None:
    """Make all streamed lines visible to other threads."""
    _only_compiled()


def _only_compiled() -> NoReturn:
    raise NotImplementedError("only compiled loops reach into memory")
