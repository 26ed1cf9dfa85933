"""Array types, and the checks that turn what a caller hands in into frozen arrays."""

import math
from operator import index
from typing import Any, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int8]
BoolArray = NDArray[np.bool_]

LARGEST = 1e50
"""Largest coordinate: the curvature formula multiplies up to five of them, and must not overflow."""

SMALLEST = 1.0 / LARGEST
"""Smallest radius or other length that must be positive: the curvature formula must not underflow either."""

CACHE_LINE, HUGE_PAGE = 64, 2**21
"""Bytes of the usual sizes."""

_NUMBERS = (int, float, np.integer, np.floating)


def frozen(values: ArrayLike, name: str, *shapes: tuple[int | None, ...]) -> FloatArray:
    """Copy ``values`` to a read-only float64 array of one of ``shapes`` (None: any length).

    Raises ValueError, naming ``name``, for a wrong shape, a value that is no number, NaN or infinity.
    """
    raw = _numbers(values, name, "real numbers")
    if shapes and not any(_fits(raw.shape, shape) for shape in shapes):
        expected = " or ".join(_spell(shape) for shape in shapes)
        raise ValueError(f"{name}: expected {expected}, found {_spell(raw.shape)}")
    array: FloatArray = np.array(raw, dtype=np.float64, order="C")
    fits = np.abs(array) <= LARGEST
    if not fits.all():
        first = np.argwhere(~fits)[0]
        place = "".join(f"[{i}]" for i in first)
        found = array[tuple(first)]
        raise ValueError(f"{name}{place}: expected a finite number of size at most {LARGEST:g}, found {found:g}")
    array.setflags(write=False)
    return array


def locked(array: FloatArray) -> FloatArray:
    """Return ``array`` itself if it is read-only, else a read-only copy."""
    if array.flags.writeable:
        array = array.copy()
        array.setflags(write=False)
    return array


def aligned(shape: tuple[int, ...], dtype: DTypeLike = np.float64) -> NDArray[Any]:
    """Return an empty array that starts on a cache line, and one that fills several huge pages on such a page.

    So no full-width access crosses two lines, and the first touch of a large result costs half.
    """
    size = math.prod(shape) * np.dtype(dtype).itemsize
    # Of the last page a part may be touched in vain: at most a third of the array.
    step = HUGE_PAGE if size >= 3 * HUGE_PAGE else CACHE_LINE
    memory = np.empty(size + step, np.uint8)
    start = -memory.__array_interface__["data"][0] % step
    return memory[start : start + size].view(dtype).reshape(shape)


def number(value: float, name: str) -> float:
    """Return ``value`` as a finite float; raises ValueError naming ``name``."""
    return float(frozen(value, name, ()))


def parameter(values: ArrayLike, name: str) -> FloatArray:
    """Return parameters as float64, all inside the domain [0, 1].

    Raises ValueError, naming ``name``, the domain, the first offender and its place.
    """
    raw = _numbers(values, name, "real numbers in the domain [0, 1]")
    array: FloatArray = np.asarray(raw, dtype=np.float64)
    # One comparison each way also catches NaN, since every comparison with it is false.
    if array.size and not (array.min() >= 0.0 and array.max() <= 1.0):
        wrong = np.argwhere(~((array >= 0.0) & (array <= 1.0)))
        place = "".join(f"[{i}]" for i in wrong[0])
        found = float(array[tuple(wrong[0])])
        told = f"{found:g}" if float(f"{found:g}") == found or np.isnan(found) else repr(found)
        raise ValueError(
            f"{name}{place} = {told} is outside the domain [0, 1] ({len(wrong)} such); "
            "surfaces and curves are not extended beyond it: clip or leave out these parameters"
        )
    return array


def whole(value: SupportsIndex, name: str, least: int) -> int:
    """Return ``value`` as an int of at least ``least``; raises ValueError naming ``name``."""
    try:
        found = index(value)
    except TypeError:
        found = least - 1
    if found < least or isinstance(value, bool):
        raise ValueError(f"{name}: expected {least} or more in whole numbers, found {value!r}")
    return found


def typical(values: FloatArray) -> float:
    """Return the middle one of finite values, 0 of none: near ``np.median``, which takes masked arrays in with it."""
    finite = values[np.isfinite(values)]
    return float(np.partition(finite, finite.size // 2)[finite.size // 2]) if finite.size else 0.0


def _numbers(values: ArrayLike, name: str, expected: str) -> NDArray[Any]:
    """Return ``values`` as an array of numbers; ValueError where they are ragged, or something else than numbers."""
    try:
        raw: NDArray[Any] = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name}: expected rows of equal length, found ragged ones") from None
    if not isinstance(values, np.ndarray) and raw.dtype.kind in "iufO":
        # NumPy would take true for 1 beside a number, and keeps integers beyond 64 bits as objects.
        parts: list[Any] = np.asarray(values, dtype=object).ravel().tolist()
        strange = [part for part in parts if isinstance(part, bool) or not isinstance(part, _NUMBERS)]
        if strange:
            raise ValueError(f"{name}: expected {expected}, found {strange[0]!r}")
        if raw.dtype.kind == "O":
            bounded = [float(part) if abs(part) <= LARGEST else np.inf for part in parts]
            raw = np.array(bounded).reshape(raw.shape)
    if raw.dtype.kind not in "iuf":
        raise ValueError(f"{name}: expected {expected}, found {_kind(raw)}")
    return raw


def _fits(found: tuple[int, ...], wanted: tuple[int | None, ...]) -> bool:
    return len(found) == len(wanted) and all(w in (None, f) for f, w in zip(found, wanted, strict=True))


def _spell(shape: tuple[int | None, ...]) -> str:
    return " x ".join("n" if n is None else str(n) for n in shape) + " numbers" if shape else "a single number"


def _kind(raw: NDArray[Any]) -> str:
    names = {"b": "true/false values", "U": "text", "S": "text", "c": "complex numbers"}
    return names.get(raw.dtype.kind, f"values of type {raw.dtype}")
