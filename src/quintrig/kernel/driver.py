"""The compiled driver behind every result: from rows and blend to curvature, in blocks of points.

For each block the partial derivatives are formed in scratch that stays in the level-1 cache; ``planes`` turns them
into the quantities asked for. The number of increments is a constant of each compiled driver, so that the sums over
them unroll.
"""

from collections.abc import Callable
from functools import cache

from quintrig.kernel import contraction
from quintrig.kernel.outputs import SCRATCH
from quintrig.kernel.stores import FIRST, LAST
from quintrig.support.arrays import FloatArray, aligned
from quintrig.support.compiled import BLOCK, loop
from quintrig.support.memory import address, call, fence, floats_at, table_at

GRID, ROWS = -2, -1
"""What ``rows`` holds instead of functions that the rows share; see ``driver``."""


Driver = Callable[[FloatArray, FloatArray, FloatArray, int, int, int, int, bool, int, int, int, int], None]
"""A compiled driver of rows, net, blend, start, stop, count, first, point, finish, settings, floats, codes."""


@cache
def driver(terms: int, functions: int) -> Driver:
    """Return the compiled driver for a surface of an origin and ``terms`` row increments.

    On a grid, ``functions`` is ``GRID`` and ``rows`` (nu, 9 (1 + terms)) holds the derivatives of origin and
    increments at each u, ordered (derivative, term, coordinate), and output rows ``start`` to ``stop`` are filled. For
    scattered points it is the number of increments of the functions that the rows share: ``rows`` (blocks, 3 functions
    BLOCK) holds those, ``net`` ((1 + functions) 3 (1 + terms),) origin and increments of the control points, and output
    row 0 is filled; ``ROWS`` says that ``rows`` (blocks, 9 (1 + terms) BLOCK) are row derivatives already. ``blend``
    is (blocks, 3 terms BLOCK), ``count`` the number of points in an output row, ``first`` that of the first
    point of row 0; ``point`` asks for S itself, and
    ``finish`` is the address of what ``planes`` does with each block, the rest those of what it needs.
    """
    # Only whole numbers may be held in the closure: they are part of the name under which the driver is found on disk.
    stride, step = (1, 0) if functions == GRID else (BLOCK, 1)
    coordinates = 3 * (1 + terms)
    width = 3 * functions * BLOCK if functions >= 0 else 3 * coordinates * stride

    @loop
    def drive(
        rows: int,
        net: int,
        blend: int,
        blocks: int,
        scratch: int,
        start: int,
        stop: int,
        count: int,
        first: int,
        point: int,
        finish: int,
        settings: int,
        floats: int,
        codes: int,
    ) -> None:
        s = floats_at(scratch)
        contracted = floats_at(scratch + 8 * SCRATCH)
        increments = table_at(blend, blocks, 3 * terms * BLOCK)
        for i in range(start, stop):
            for block in range(blocks):
                d = increments[block]
                r = floats_at(rows + 8 * width * (i if functions == GRID else block))
                if functions >= 0:
                    contraction.rows_of_net(r, floats_at(net), contracted, functions, coordinates, BLOCK)
                    r = contracted
                contraction.partials(r, d, s, point != 0, terms, BLOCK, stride, step)
                j = block * BLOCK
                end = (FIRST if j == 0 and i == start else 0) + (LAST if j + BLOCK >= count and i + 1 == stop else 0)
                call(finish, scratch, min(BLOCK, count - j), first + i * count + j, end, settings, floats, codes)
        fence()

    def run(rows: FloatArray, net: FloatArray, blend: FloatArray, *rest: int) -> None:
        scratch = aligned((SCRATCH + (3 * coordinates * BLOCK if functions >= 0 else 0),))
        drive(address(rows), address(net), address(blend), len(blend), address(scratch), *rest)

    return run
