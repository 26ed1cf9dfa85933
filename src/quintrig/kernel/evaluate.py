"""How a surface and its parameters become arguments of the compiled driver, and how the work is spread over threads."""

import os
from collections.abc import Callable, Iterable
from itertools import pairwise
from threading import Thread
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from quintrig.basis.functions import MOVING, Functions, Still
from quintrig.geometry.surface import Net, Surface
from quintrig.kernel.blocks import increment_blocks, pad
from quintrig.kernel.driver import GRID, ROWS, driver
from quintrig.kernel.outputs import (
    CODE_COUNT,
    CODE_SLOTS,
    FLOAT_COUNT,
    FLOAT_SLOTS,
    FULL,
    Addresses,
    Settings,
    finish,
    needs,
)
from quintrig.quantities.table import BY_KEY
from quintrig.support.arrays import FloatArray, aligned, whole
from quintrig.support.compiled import BLOCK

Planes = dict[str, NDArray[Any]]
"""Output arrays by key of the quantity, each (components, rows, columns)."""

_WORTH = 2**17  # points a thread
_FEW, _CACHES = 8, 2**23  # planes and bytes
_PIECE = 16384  # scattered points whose derivatives are held at once, so that memory stays with the outputs
_WIDEST = 12  # rows or functions over which a driver unrolls: more would take seconds to compile, for each number anew
_NO_NET: FloatArray = np.empty(0)

_HANDED = (3, ROWS)
"""The driver's numbers for partial derivatives that are handed through."""

_Inputs = tuple[FloatArray, FloatArray, FloatArray]
_Piece = TypeVar("_Piece")


def workers(threads: int | None, points: int) -> int:
    """Return how many threads to use: ``threads``, or by default what the machine has and the work is worth."""
    if threads is None:
        return max(1, min(os.cpu_count() or 1, points // _WORTH))
    return whole(threads, "threads", 1)


def worth_streaming(planes: Planes) -> bool:
    """Tell whether to write the planes past the caches: many of them, and together too large for the caches.

    Streamed, 24 planes take 0.3 ns a number instead of 0.7; a few are faster through the caches.
    """
    floats = [plane for array in planes.values() if array.dtype == np.float64 for plane in array]
    return len(floats) > _FEW and floats[0].shape[-1] > BLOCK and sum(plane.nbytes for plane in floats) > _CACHES


def on_grid(surface: Surface, u: FloatArray, v: FloatArray, planes: Planes, threads: int, at: Settings) -> None:
    """Fill planes of shape (components, nu, nv) at u (nu,) and v (nv,)."""
    if not (u.size and v.size):
        return
    if _is_wide(surface):
        _wide_grid(surface, u, v, planes, threads, at)
        return
    along, across = standing(surface)
    rows = _flat(row_derivatives(surface, u, along))
    blend = _flat(increment_blocks(surface.blend, v, still=across))
    drive, outputs = driver(surface.blend.terms, GRID), _outputs(planes, at)
    # Several pieces a thread, so that one that starts late or is interrupted does not keep the others waiting.
    pieces = min(len(u), 8 * threads if threads > 1 else 1)
    edges = [len(u) * i // pieces for i in range(pieces + 1)]

    def part(ends: tuple[int, int]) -> None:
        drive(rows, _NO_NET, blend, *ends, v.size, 0, *outputs.arguments)

    _spread(lambda: part, list(pairwise(edges)), threads)


def scattered(surface: Surface, u: FloatArray, v: FloatArray, planes: Planes, threads: int, at: Settings) -> None:
    """Fill planes of shape (components, 1, n) at the n points u (n,), v (n,)."""
    outputs = _outputs(planes, at)

    def worker() -> Callable[[int], None]:
        sizes, inputs = _inputs(surface, min(_PIECE, u.size))
        drive = driver(*sizes)

        def part(start: int) -> None:
            piece = slice(start, min(start + _PIECE, u.size))
            drive(*inputs(u[piece], v[piece]), 0, 1, piece.stop - start, start, *outputs.arguments)

        return part

    _spread(worker, range(0, u.size, _PIECE), threads)


def _is_wide(surface: Surface) -> bool:
    """Tell whether no driver unrolls over this surface's rows: it is rational or has too many."""
    return surface.rational or surface.rows.size > _WIDEST


def _wide_grid(surface: Surface, u: FloatArray, v: FloatArray, planes: Planes, threads: int, at: Settings) -> None:
    drive, outputs = driver(*_HANDED), _outputs(planes, at)
    step = max(1, _PIECE // v.size)

    def part(start: int) -> None:
        piece = u[start : start + step, None]
        inputs = _handed_through(surface.partials(piece, v[None, :], 2).reshape(3, 3, -1, 3))
        drive(*inputs, 0, 1, piece.size * v.size, start * v.size, *outputs.arguments)

    _spread(lambda: part, range(0, u.size, step), threads)


def row_derivatives(surface: Surface, u: FloatArray, still: Still = MOVING) -> FloatArray:
    """Return derivatives 0 to 2 of origin and row increments at u, shape (n, 3, 1 + terms, 3).

    Beside ends that are ``still`` second derivatives are those across the first.
    """
    rows = surface.rows
    if not isinstance(rows, Net):
        result = surface.blend.split(rows.derivatives(u, 2).transpose(2, 1, 0, 3)).transpose(1, 2, 0, 3)
        result[:, 0, 0] += surface.origin
        return result
    net = _net(surface, rows)
    blocks = increment_blocks(rows.functions, u, still=still)
    factors: FloatArray = np.zeros((len(blocks), BLOCK, 3, len(net)))
    factors[:, :, 0, 0] = 1.0  # of the origin
    factors[..., 1:] = blocks.transpose(0, 3, 1, 2)
    return (factors.reshape(-1, len(net))[: 3 * u.size] @ net).reshape(u.size, 3, -1, 3)


def standing(surface: Surface) -> tuple[Still, Still]:
    """Return at which ends all of the surface stands still, in u and in v."""
    if not isinstance(surface.rows, Net):
        return MOVING, MOVING
    steps = surface.rows.increments(surface.blend)
    return surface.rows.functions.standing(steps[1:]), surface.blend.standing(steps[:, 1:].swapaxes(0, 1))


def _net(surface: Surface, rows: Net) -> FloatArray:
    """Return origin and increments of the control points both ways, ((1 + increments), (1 + terms) 3)."""
    both = rows.increments(surface.blend).copy()
    both[0, 0] += surface.origin
    return both.reshape(len(both), -1)


def _inputs(surface: Surface, most: int) -> tuple[tuple[int, int], Callable[[FloatArray, FloatArray], _Inputs]]:
    """Return the driver's numbers for scattered points, and what gives rows, net and blend at up to ``most`` of them.

    It uses the same memory each time: fresh memory for every piece costs more than the work itself.
    """
    rows, blend = surface.rows, surface.blend
    if _is_wide(surface):
        # In whole blocks, since NumPy sums a single point in another order.
        return _HANDED, lambda u, v: _handed_through(surface.partials(pad(u), pad(v), 2).reshape(3, 3, -1, 3))
    across = _room(blend, most)
    still = standing(surface)
    if isinstance(rows, Net) and rows.functions.size <= _WIDEST:
        net, functions, along = _net(surface, rows).reshape(-1), rows.functions, _room(rows.functions, most)
        return (blend.terms, functions.terms), lambda u, v: (
            _flat(increment_blocks(functions, u, along, still[0])),
            net,
            _flat(increment_blocks(blend, v, across, still[1])),
        )

    def apart(u: FloatArray, v: FloatArray) -> _Inputs:
        blends = _flat(increment_blocks(blend, v, across, still[1]))
        derivatives = row_derivatives(surface, pad(u).reshape(-1), still[0]).reshape(len(blends), BLOCK, -1)
        return _flat(derivatives.transpose(0, 2, 1)), _NO_NET, blends

    return (blend.terms, ROWS), apart


def _room(functions: Functions, most: int) -> FloatArray:
    """Return memory for the increments at up to ``most`` points."""
    return aligned((-(-most // BLOCK) * BLOCK * 3 * functions.terms,))


def _handed_through(partials: FloatArray) -> _Inputs:
    """Return rows, net and blend that hand partial derivatives (u order, v order, n, 3) to a driver as they are.

    S, S_v and S_vv are three rows, and their derivatives by u, under a constant blend.
    """
    count = -(-partials.shape[2] // BLOCK)
    rows: FloatArray = np.zeros((count, 3, 4, 3, BLOCK))  # blocks, u order, origin and v order, coordinate
    filled = np.empty((3, 3, 3, count * BLOCK))
    filled[..., : partials.shape[2]] = partials.transpose(0, 1, 3, 2)
    filled[..., partials.shape[2] :] = partials[:, :, -1, :, None]
    rows[:, :, 1:] = filled.reshape(3, 3, 3, count, BLOCK).transpose(3, 0, 1, 2, 4)
    unit = np.broadcast_to(np.eye(3)[None, :, :, None], (count, 3, 3, BLOCK))
    return _flat(rows), _NO_NET, _flat(unit)


class _Outputs(NamedTuple):
    """What a driver needs to know of the planes: its last arguments, and the arrays that these are addresses of."""

    arguments: tuple[bool, int, int, int, int]
    arrays: tuple[NDArray[Any], ...]


def _outputs(planes: Planes, at: Settings) -> _Outputs:
    floats: Addresses = np.zeros(FLOAT_COUNT, np.int64)
    codes: Addresses = np.zeros(CODE_COUNT, np.int64)
    for key, array in planes.items():
        to, slot = (codes, CODE_SLOTS[key]) if BY_KEY[key].kind == "class" else (floats, FLOAT_SLOTS[key])
        for x, plane in enumerate(array):
            to[slot + x] = plane.__array_interface__["data"][0]
    need, settings = needs(planes), np.array(at, np.float64)
    addresses = settings.ctypes.data, floats.ctypes.data, codes.ctypes.data
    return _Outputs((need == FULL, finish(need), *addresses), (settings, floats, codes))


def _flat(blocks: FloatArray) -> FloatArray:
    return np.ascontiguousarray(blocks).reshape(len(blocks), -1)


def _spread(worker: Callable[[], Callable[[_Piece], None]], pieces: Iterable[_Piece], threads: int) -> None:
    """Work on every piece with what ``worker`` gives each thread; drivers release the interpreter, so all run at once.

    The calling thread works too, so nothing waits for a thread to wake. (Plain threads: a pool takes longer to start
    and stop than K and H of fifty thousand points.)
    """
    queue = iter(pieces)
    failures: list[BaseException] = []

    def work() -> None:
        try:
            part = worker()
            for piece in queue:
                if failures:  # of another thread: what is left is in vain
                    break
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
