"""How a surface and its parameters become arguments of the compiled driver, and how the work is spread over threads."""

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from quintrig.arrays import FloatArray, IntArray, whole
from quintrig.blocks import BLOCK, derivative_blocks, pad
from quintrig.kernel import FORM_ONLY, SIMPLE, Driver, driver
from quintrig.planes import CODE_PLANES, CODE_SLOTS, FLOAT_PLANES, FLOAT_SLOTS, CodePlanes, FloatPlanes
from quintrig.quantity import QUANTITIES
from quintrig.surface import Net, Rows, Surface

Planes = dict[str, NDArray[Any]]
"""Output arrays by key of the quantity, each (components, rows, columns)."""

Settings = tuple[float, float, float, float, float]
"""Sign of the normal, smallest regular |S_u x S_v|, relative threshold, flat and noise curvedness."""

_PIECE = 16384  # scattered points whose derivatives are held at once, so that memory stays with the outputs
_WIDEST = 24  # rows or functions over which a driver unrolls; beyond, the partials themselves are handed in
_NO_NET: FloatArray = np.empty(0)

_Piece = TypeVar("_Piece")


def workers(threads: int | None, points: int) -> int:
    """Return how many threads to use: ``threads``, or by default what the machine has and the work is worth."""
    if threads is None:
        return max(1, min(os.cpu_count() or 1, points // 32768))
    return whole(threads, "threads", 1)


def fills_grid(surface: Surface) -> bool:
    """Tell whether grids of this surface have a driver of their own; otherwise they are scattered points."""
    return surface.rows.dimension == 3 and surface.rows.size <= _WIDEST


def on_grid(surface: Surface, u: FloatArray, v: FloatArray, planes: Planes, threads: int, settings: Settings) -> None:
    """Fill planes of shape (components, nu, nv) at u (nu,) and v (nv,)."""
    if not (u.size and v.size):
        return
    rows = _row_derivatives(surface.rows, u)
    blend = _flat(derivative_blocks(surface.blend, v))
    drive = _driver(surface.rows.size, 0, planes)
    outputs = _outputs(planes, slice(None))
    edges: list[int] = np.linspace(0, len(u), min(threads, len(u)) + 1).astype(int).tolist()

    def part(ends: tuple[int, int]) -> None:
        drive(rows, _NO_NET, blend, *ends, v.size, *settings, *outputs)

    _spread(part, list(pairwise(edges)), threads)


def scattered(surface: Surface, u: FloatArray, v: FloatArray, planes: Planes, threads: int, settings: Settings) -> None:
    """Fill planes of shape (components, 1, n) at the n points u (n,), v (n,)."""

    def part(start: int) -> None:
        piece = slice(start, min(start + _PIECE, u.size))
        rows, net, blend, size, functions = _inputs(surface, u[piece], v[piece])
        drive = _driver(size, functions, planes)
        drive(rows, net, blend, 0, 1, piece.stop - start, *settings, *_outputs(planes, piece))

    _spread(part, range(0, u.size, _PIECE), threads)


def _row_derivatives(rows: Rows, u: FloatArray) -> FloatArray:
    """Return derivatives 0 to 2 of the rows at u (nu,), shape (nu, 9 rows)."""
    if isinstance(rows, Net):
        functions = derivative_blocks(rows.functions, u).transpose(0, 3, 1, 2)  # (blocks, BLOCK, 3, functions)
        each = functions.reshape(-1, rows.functions.size)[: 3 * u.size]
        return (each @ rows.points.reshape(rows.functions.size, -1)).reshape(u.size, -1)
    return np.ascontiguousarray(rows.derivatives(u, 2).transpose(1, 0, 2, 3)).reshape(u.size, -1)


def _inputs(surface: Surface, u: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, int, int]:
    """Return rows, net and blend for scattered points, with the driver's numbers of rows and functions."""
    rows = surface.rows
    if rows.dimension == 4 or rows.size > _WIDEST:
        # The partials themselves are three rows, S, S_v, S_vv, that a constant blend hands through.
        partials = surface.partials(pad(u), pad(v), 2)  # (u order, v order, blocks, BLOCK, 3)
        unit = np.broadcast_to(np.eye(3)[None, :, :, None], (partials.shape[2], 3, 3, BLOCK))
        return _flat(partials.transpose(2, 0, 1, 4, 3)), _NO_NET, _flat(unit), 3, -1
    blend = _flat(derivative_blocks(surface.blend, v))
    if isinstance(rows, Net) and rows.functions.size <= _WIDEST:
        functions = _flat(derivative_blocks(rows.functions, u))
        return functions, rows.points.reshape(-1), blend, rows.size, rows.functions.size
    derivatives = rows.derivatives(pad(u), 2)  # (3, blocks, BLOCK, rows, 3)
    return _flat(derivatives.transpose(1, 0, 3, 4, 2)), _NO_NET, blend, rows.size, -1


def _driver(size: int, functions: int, planes: Planes) -> Driver:
    return driver(size, functions, not FORM_ONLY.issuperset(planes), SIMPLE.issuperset(planes))


def _outputs(planes: Planes, part: slice) -> tuple[FloatArray, FloatArray, FloatPlanes, CodePlanes]:
    """Return the planes of K and H, then all in the driver's order, limited to some columns; empty if not asked for."""
    floats: list[FloatArray] = [np.empty((0, 0))] * FLOAT_PLANES
    codes: list[IntArray] = [np.empty((0, 0), dtype=np.int8)] * CODE_PLANES
    for q in QUANTITIES:
        for x, plane in enumerate(planes.get(q.key, ())):
            if q.colour == "classes":
                codes[CODE_SLOTS[q.key]] = plane[:, part]
            else:
                floats[FLOAT_SLOTS[q.key] + x] = plane[:, part]
    return floats[FLOAT_SLOTS["gaussian"]], floats[FLOAT_SLOTS["mean"]], tuple(floats), tuple(codes)


def _flat(blocks: FloatArray) -> FloatArray:
    return np.ascontiguousarray(blocks).reshape(len(blocks), -1)


def _spread(part: Callable[[_Piece], None], pieces: Sequence[_Piece], threads: int) -> None:
    """Run ``part`` on every piece; the drivers release the interpreter, so threads run side by side."""
    if threads == 1 or len(pieces) <= 1:
        for piece in pieces:
            part(piece)
        return
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(part, pieces))
