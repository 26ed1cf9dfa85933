"""Analysis of a surface at points: ``analyse`` gives a ``Sample``, arrays by the key of the quantity."""

import os
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quintrig import kernel
from quintrig.arrays import BoolArray, FloatArray, IntArray, parameter
from quintrig.classify import Thresholds
from quintrig.kernel import BLOCK
from quintrig.quantity import BY_KEY, QUANTITIES, quantity
from quintrig.surface import Surface

SINGULAR = 4096 * np.finfo(np.float64).eps
"""A point is singular where |S_u x S_v| <= SINGULAR size²: three digits above rounding, so the normal still means something."""

_NOISE = 1e-12  # curvedness times size at or below this is rounding of a plane: its shape index is undefined
_PIECE = 16384  # scattered points whose row derivatives are held at once, so that memory stays with the outputs

Planes = dict[str, NDArray[Any]]


@dataclass(frozen=True, eq=False)
class Sample:
    """Quantities of a surface at parameters u and v.

    ``sample["gaussian"]`` has the broadcast shape of u and v, vectors have a last axis of 3, classes are int8 codes. ``size`` is the
    surface's bounding-box diagonal, length¹, to which the thresholds refer.
    """

    surface: Surface
    u: FloatArray
    v: FloatArray
    values: Mapping[str, NDArray[Any]]
    thresholds: Thresholds
    size: float

    def __getitem__(self, key: str) -> NDArray[Any]:
        """Return the array of a quantity; KeyError where it was not asked for, ValueError where there is none."""
        quantity(key)
        if key not in self.values:
            raise KeyError(f"{key!r} was not computed; ask analyse for it (computed are {', '.join(self.values)})")
        return self.values[key]

    @property
    def shape(self) -> tuple[int, ...]:
        """Broadcast shape of u and v."""
        return np.broadcast_shapes(self.u.shape, self.v.shape)

    @property
    def point(self) -> FloatArray:
        """Points, shape (*shape, 3), length¹."""
        return self["point"]

    @property
    def normal(self) -> FloatArray:
        """Unit normals, shape (*shape, 3); NaN at singular points."""
        return self["normal"]

    @property
    def singular(self) -> BoolArray:
        """True where the surface has no tangent plane and every curvature is NaN."""
        for key in ("gaussian", "mean"):
            if key in self.values:
                return np.isnan(self.values[key])
        return np.isnan(analyse(self.surface, self.u, self.v, ("mean",))["mean"])


def grid(nu: int, nv: int) -> tuple[FloatArray, FloatArray]:
    """Return the open mesh of nu x nv parameters over the domain, shapes (nu, 1) and (1, nv), edges included."""
    for name, count in (("nu", nu), ("nv", nv)):
        if count < 2:
            raise ValueError(f"{name}: expected 2 or more points a side, found {count}")
    return np.linspace(0.0, 1.0, nu)[:, None], np.linspace(0.0, 1.0, nv)[None, :]


def analyse(
    surface: Surface,
    u: ArrayLike,
    v: ArrayLike,
    quantities: Iterable[str] | str | None = None,
    *,
    thresholds: Thresholds | None = None,
    threads: int | None = None,
    out: Mapping[str, NDArray[Any]] | None = None,
) -> Sample:
    """Compute quantities of the surface at parameters that broadcast as in NumPy.

    u of shape (nu, 1) and v of shape (1, nv) are a grid and take the fast path; the results are the same, to rounding. ``quantities``
    are keys of the table in ``quantity`` (None: all). ``threads`` defaults to the machine's cores for large work. ``out`` gives C-contiguous
    arrays of the result's shape to write scalar quantities into. Singular points give NaN and code 0. Raises ValueError for
    NaN or parameters outside [0, 1], unknown keys and unfit arrays.
    """
    u, v = parameter(u, "u"), parameter(v, "v")
    keys = _keys(quantities)
    thresholds = thresholds or Thresholds()
    size = surface.size
    shape = np.broadcast_shapes(u.shape, v.shape)
    on_grid = u.ndim == 2 and v.ndim == 2 and u.shape[1] == 1 and v.shape[0] == 1
    rows, columns = shape if on_grid else (1, int(np.prod(shape)))
    planes = {key: _planes(key, rows, columns, shape, out) for key in keys}
    per_size = 1.0 / size if size > 0.0 else np.inf
    settings = (
        surface.sign,
        SINGULAR * size * size,
        thresholds.relative,
        thresholds.flat * per_size,
        _NOISE * per_size,
    )
    run = _on_grid if on_grid else _scattered
    run(surface, u, v, planes, _workers(threads, rows * columns), settings)
    values = {key: _shaped(key, plane, shape) for key, plane in planes.items()}
    if out is not None:
        values |= {key: out[key] for key in keys if key in out}
    return Sample(surface, u, v, MappingProxyType(values), thresholds, size)


def _keys(quantities: Iterable[str] | str | None) -> tuple[str, ...]:
    if quantities is None:
        return tuple(BY_KEY)
    return tuple(quantity(key).key for key in ([quantities] if isinstance(quantities, str) else quantities))


def _planes(
    key: str, rows: int, columns: int, shape: tuple[int, ...], out: Mapping[str, NDArray[Any]] | None
) -> NDArray[Any]:
    """Return the output of one quantity as (components, rows, columns)."""
    q = BY_KEY[key]
    kind = np.int8 if q.colour == "classes" else np.float64
    if out is None or key not in out:
        return np.empty((q.components, rows, columns), dtype=kind)
    array = out[key]
    fits = array.shape == shape and array.dtype == kind and array.flags.c_contiguous and array.flags.writeable
    if not fits or q.components != 1:
        raise ValueError(
            f"out[{key!r}]: expected a writable C-contiguous {np.dtype(kind)} array of shape {shape} for a scalar quantity, "
            f"found {array.dtype} of shape {array.shape}"
        )
    return array.reshape(1, rows, columns)


def _shaped(key: str, plane: NDArray[Any], shape: tuple[int, ...]) -> NDArray[Any]:
    if BY_KEY[key].components == 1:
        return plane.reshape(shape)
    return np.moveaxis(plane.reshape(-1, *shape), 0, -1)


def _workers(threads: int | None, points: int) -> int:
    if threads is not None:
        if threads < 1:
            raise ValueError(f"threads: expected 1 or more, found {threads}")
        return threads
    return max(1, min(os.cpu_count() or 1, points // 32768))


def _tuples(planes: Planes, part: slice) -> tuple[kernel.FloatPlanes, kernel.CodePlanes]:
    """Return the output planes in the kernel's order, empty where not asked for, limited to some columns."""
    floats: list[FloatArray] = [np.empty((0, 0))] * kernel.FLOAT_PLANES
    codes: list[IntArray] = [np.empty((0, 0), dtype=np.int8)] * kernel.CODE_PLANES
    for q in QUANTITIES:
        if q.key in planes:
            for x, plane in enumerate(planes[q.key]):
                if q.colour == "classes":
                    codes[kernel.CODE_SLOTS[q.key]] = plane[:, part]
                else:
                    floats[kernel.FLOAT_SLOTS[q.key] + x] = plane[:, part]
    return tuple(floats), tuple(codes)


def _blocks(values: FloatArray) -> FloatArray:
    """Lay (..., n) out as (blocks, ... BLOCK), the last block filled up with the last point."""
    n = values.shape[-1]
    count = -(-n // BLOCK)
    padded = np.pad(values, [(0, 0)] * (values.ndim - 1) + [(0, count * BLOCK - n)], mode="edge")
    apart = padded.reshape(-1, count, BLOCK).transpose(1, 0, 2)
    return np.ascontiguousarray(apart).reshape(count, -1)


def _on_grid(
    surface: Surface, u: FloatArray, v: FloatArray, planes: Planes, workers: int, settings: tuple[float, ...]
) -> None:
    if not (u.size and v.size):
        return
    rows = surface.rows.derivatives(u[:, 0], 2)  # (3, nu, m, 3)
    r = np.ascontiguousarray(rows.transpose(1, 0, 2, 3)).reshape(len(u), -1)
    d = _blocks(surface.blend.derivatives(v[0], 2).transpose(0, 2, 1))
    drive = kernel.driver(surface.rows.size, _needs_frame(planes), False)
    floats, codes = _tuples(planes, slice(None))
    edges = np.linspace(0, len(u), min(workers, len(u)) + 1).astype(int).tolist()

    def part(ends: tuple[int, int]) -> None:
        drive(r, d, ends[0], ends[1], v.size, *settings, floats, codes)

    _spread(part, list(zip(edges[:-1], edges[1:], strict=True)), workers)


def _scattered(
    surface: Surface, u: FloatArray, v: FloatArray, planes: Planes, workers: int, settings: tuple[float, ...]
) -> None:
    u, v = (a.reshape(-1) for a in np.broadcast_arrays(u, v))
    drive = kernel.driver(surface.rows.size, _needs_frame(planes), True)

    def part(start: int) -> None:
        piece = slice(start, min(start + _PIECE, u.size))
        rows = surface.rows.derivatives(u[piece], 2)  # (3, n, m, 3)
        r = _blocks(rows.transpose(0, 2, 3, 1))
        d = _blocks(surface.blend.derivatives(v[piece], 2).transpose(0, 2, 1))
        floats, codes = _tuples(planes, piece)
        drive(r, d, 0, 1, piece.stop - start, *settings, floats, codes)

    _spread(part, list(range(0, u.size, _PIECE)), workers)


def _needs_frame(planes: Planes) -> bool:
    return not kernel.NEEDS_ONLY_FORM.issuperset(planes)


def _spread(part: Any, pieces: list[Any], workers: int) -> None:
    """Run ``part`` on every piece; the kernels release the interpreter, so threads run side by side."""
    if workers == 1 or len(pieces) <= 1:
        for piece in pieces:
            part(piece)
        return
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(part, pieces))
