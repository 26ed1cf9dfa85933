"""How a surface and its parameters become arguments of the compiled driver, and how the work is spread over threads."""

import os
from collections.abc import Callable, Iterable
from itertools import pairwise
from threading import Thread
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from quintrig.arrays import CACHE_LINE, FloatArray, whole
from quintrig.blocks import BLOCK, increment_blocks, pad
from quintrig.increments import split, terms
from quintrig.kernel import driver
from quintrig.planes import CODE_PLANES, CODE_SLOTS, FLOAT_PLANES, FLOAT_SLOTS, Addresses, Settings, needs
from quintrig.quantity import BY_KEY
from quintrig.surface import Net, Surface

Planes = dict[str, NDArray[Any]]
"""Output arrays by key of the quantity, each (components, rows, columns)."""

_WORTH = 2**17  # points a thread
_FEW, _CACHES = 8, 2**23  # planes and bytes
_PIECE = 16384  # scattered points whose derivatives are held at once, so that memory stays with the outputs
_WIDEST = 24  # rows or functions over which a driver unrolls; beyond, the partials themselves are handed in
_NO_NET: FloatArray = np.empty(0)

_Piece = TypeVar("_Piece")


def workers(threads: int | None, points: int) -> int:
    """Return how many threads to use: ``threads``, or by default what the machine has and the work is worth."""
    if threads is None:
        return max(1, min(os.cpu_count() or 1, points // _WORTH))
    return whole(threads, "threads", 1)


def worth_streaming(planes: Planes) -> bool:
    """Tell whether to write the planes past the caches: many of them, too large for the caches, and all aligned.

    Streamed, 24 planes take 0.3 ns a number instead of 0.7; a few are faster through the caches.
    """
    floats = [plane for array in planes.values() if array.dtype == np.float64 for plane in array]
    return (
        len(floats) > _FEW
        and sum(plane.nbytes for plane in floats) > _CACHES
        and not any((plane.__array_interface__["data"][0] | plane.strides[0]) % CACHE_LINE for plane in floats)
    )


def fills_grid(surface: Surface) -> bool:
    """Tell whether grids of this surface have a driver of their own; otherwise they are scattered points."""
    return surface.rows.dimension == 3 and surface.rows.size <= _WIDEST


def on_grid(surface: Surface, u: FloatArray, v: FloatArray, planes: Planes, threads: int, at: Settings) -> None:
    """Fill planes of shape (components, nu, nv) at u (nu,) and v (nv,)."""
    if not (u.size and v.size):
        return
    rows = _flat(row_derivatives(surface, u))
    blend = _flat(increment_blocks(surface.blend, v))
    drive = driver(terms(surface.blend), 0)
    need, outputs = needs(planes), _addresses(planes, 0)
    # Several pieces a thread, so that one that starts late or is interrupted does not keep the others waiting.
    pieces = min(len(u), 8 * threads if threads > 1 else 1)
    edges: list[int] = np.linspace(0, len(u), pieces + 1).astype(int).tolist()

    def part(ends: tuple[int, int]) -> None:
        drive(rows, _NO_NET, blend, *ends, v.size, need, at, *outputs)

    _spread(part, list(pairwise(edges)), threads)


def scattered(surface: Surface, u: FloatArray, v: FloatArray, planes: Planes, threads: int, at: Settings) -> None:
    """Fill planes of shape (components, 1, n) at the n points u (n,), v (n,)."""
    need = needs(planes)

    def part(start: int) -> None:
        piece = slice(start, min(start + _PIECE, u.size))
        rows, net, blend, count, functions = _inputs(surface, u[piece], v[piece])
        drive = driver(count, functions)
        drive(rows, net, blend, 0, 1, piece.stop - start, need, at, *_addresses(planes, start))

    _spread(part, range(0, u.size, _PIECE), threads)


def row_derivatives(surface: Surface, u: FloatArray) -> FloatArray:
    """Return derivatives 0 to 2 of origin and row increments at u, shape (n, 3, 1 + terms, 3)."""
    rows = surface.rows
    if not isinstance(rows, Net):
        return split(rows.derivatives(u, 2).transpose(2, 1, 0, 3), surface.blend).transpose(1, 2, 0, 3)
    net = _net(surface, rows)
    blocks = increment_blocks(rows.functions, u).transpose(0, 3, 1, 2)  # (blocks, BLOCK, 3, increments)
    result = blocks.reshape(-1, len(net) - 1)[: 3 * u.size] @ net[1:]
    result = result.reshape(u.size, 3, -1)
    result[:, 0] += net[0]
    return result.reshape(u.size, 3, -1, 3)


def _net(surface: Surface, rows: Net) -> FloatArray:
    """Return origin and increments of the control points both ways, ((1 + increments), (1 + terms) 3)."""
    by_rows = split(rows.points, rows.functions).transpose(1, 0, 2)
    both = split(by_rows, surface.blend).transpose(1, 0, 2)
    return both.reshape(len(both), -1)


def _inputs(surface: Surface, u: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, int, int]:
    """Return rows, net and blend for scattered points, with the driver's numbers of terms and functions."""
    rows = surface.rows
    if rows.dimension == 4 or rows.size > _WIDEST:
        # The partials themselves are three rows, S, S_v, S_vv, that a constant blend hands through.
        partials = surface.partials(pad(u), pad(v), 2)  # (u order, v order, blocks, BLOCK, 3)
        partials = np.concatenate([np.zeros_like(partials[:, :1]), partials], axis=1)
        unit = np.broadcast_to(np.eye(3)[None, :, :, None], (partials.shape[2], 3, 3, BLOCK))
        return _flat(partials.transpose(2, 0, 1, 4, 3)), _NO_NET, _flat(unit), 3, -1
    blend, count = _flat(increment_blocks(surface.blend, v)), terms(surface.blend)
    if isinstance(rows, Net) and rows.functions.size <= _WIDEST:
        functions = _flat(increment_blocks(rows.functions, u))
        return functions, _net(surface, rows).reshape(-1), blend, count, terms(rows.functions)
    derivatives = row_derivatives(surface, pad(u).reshape(-1)).reshape(len(blend), BLOCK, -1)
    return _flat(derivatives.transpose(0, 2, 1)), _NO_NET, blend, count, -1


def _addresses(planes: Planes, start: int) -> tuple[Addresses, Addresses]:
    """Return the addresses of all planes from point ``start`` on, in the driver's order, 0 if not asked for."""
    floats, codes = np.zeros(FLOAT_PLANES, np.int64), np.zeros(CODE_PLANES, np.int64)
    for key, array in planes.items():
        to, slot = (codes, CODE_SLOTS[key]) if BY_KEY[key].colour == "classes" else (floats, FLOAT_SLOTS[key])
        for x, plane in enumerate(array):
            to[slot + x] = plane.__array_interface__["data"][0] + start * plane.itemsize
    return floats, codes


def _flat(blocks: FloatArray) -> FloatArray:
    return np.ascontiguousarray(blocks).reshape(len(blocks), -1)


def _spread(part: Callable[[_Piece], None], pieces: Iterable[_Piece], threads: int) -> None:
    """Run ``part`` on every piece; the drivers release the interpreter, so threads run side by side.

    The calling thread works too, so nothing waits for a thread to wake. (Plain threads: a pool takes longer to start
    and stop than K and H of fifty thousand points.)
    """
    queue = iter(pieces)
    failures: list[BaseException] = []

    def work() -> None:
        try:
            for piece in queue:
                part(piece)
        except BaseException as failure:
            failures.append(failure)

    others = [Thread(target=work) for _ in range(threads - 1)]
    for other in others:
        other.start()
    work()
    for other in others:
        other.join()
    if failures:
        raise failures[0]
