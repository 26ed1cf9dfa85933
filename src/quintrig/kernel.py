"""The compiled driver behind every result: from rows and blend to curvature, in blocks of points.

For each block the partial derivatives are formed and reduced to a few numbers a point in a scratch array that stays
in the level-1 cache; ``planes`` turns those into the quantities asked for. Two things let the compiler vectorise the
loop over the points of a block: the number of rows is a constant of each compiled driver, so that the sums over rows
unroll, and all inputs of a block lie in one array at constant distances, so that one overlap check is enough. (Seen
in the machine code: fused multiply-adds on full-width registers, one packed square root, no scalar ones; without the
constant distances the loop stays scalar and takes four times as long.)
"""

from functools import cache
from typing import Protocol

import numpy as np

from quintrig import contraction, curvature
from quintrig.arrays import FloatArray
from quintrig.blocks import BLOCK
from quintrig.compiled import loop
from quintrig.planes import SCRATCH_ROWS, CodePlanes, FloatPlanes, fill_planes, store_frame

SIMPLE = frozenset({"gaussian", "mean"})
"""Quantities that are one expression in a, b, c: they are written at once, without scratch rows of their own."""

FORM_ONLY = SIMPLE | {"k1", "k2", "curvedness", "shape_index", "point_type", "hk_type", "shape_class"}
"""Quantities that follow from a, b, c alone, without point, normal or frame."""


class Driver(Protocol):
    """A compiled driver; see ``driver`` for the layout of the arguments."""

    def __call__(
        self,
        rows: FloatArray,
        net: FloatArray,
        blend: FloatArray,
        start: int,
        stop: int,
        count: int,
        sign: float,
        tiny: float,
        relative: float,
        flat: float,
        noise: float,
        gaussian: FloatArray,
        mean: FloatArray,
        floats: FloatPlanes,
        codes: CodePlanes,
    ) -> None:
        """Fill the planes."""
        ...


@cache
def driver(size: int, functions: int, full: bool, simple: bool) -> Driver:
    """Return the compiled driver for a surface of ``size`` rows.

    On a grid, ``functions`` is 0 and ``rows`` (nu, 9 size) holds the derivatives of the rows at each u, ordered
    (derivative, row, coordinate), and output rows ``start`` to ``stop`` are filled. For scattered points it is the
    number of functions that the rows share: ``rows`` (blocks, 3 functions BLOCK) holds those functions' derivatives,
    ``net`` (functions, 3 size) the control points, and output row 0 is filled; -1 says that ``rows`` (blocks, 9 size
    BLOCK) are row derivatives already. ``blend`` is (blocks, 3 size BLOCK), ``count`` the number of points in an
    output row. ``full`` also forms point, frame and fundamental forms, ``simple`` writes K and H only.
    """
    # Only whole numbers may be held in the closure: they are part of the key under which the cache finds the driver.
    stride, step = (1, 0) if functions == 0 else (BLOCK, 1)
    terms = 3 * size

    @loop
    def drive(
        rows: FloatArray,
        net: FloatArray,
        blend: FloatArray,
        start: int,
        stop: int,
        count: int,
        sign: float,
        tiny: float,
        relative: float,
        flat: float,
        noise: float,
        gaussian: FloatArray,
        mean: FloatArray,
        floats: FloatPlanes,
        codes: CodePlanes,
    ) -> None:
        s = np.empty(SCRATCH_ROWS * BLOCK)
        contracted = np.empty(3 * terms * BLOCK)
        for i in range(start, stop):
            for block in range(blend.shape[0]):
                d = blend[block]
                r = rows[i if functions == 0 else block]
                if functions > 0:
                    contraction.rows_of_net(r, net, contracted, functions, terms, BLOCK)
                    r = contracted
                for k in range(BLOCK):
                    point, du, dv, duu, duv, dvv = contraction.partials(r, d, k, size, BLOCK, stride, step)
                    frame = curvature.frame(du, dv, duu, duv, dvv, sign, tiny)
                    a, b, c = curvature.form_in_frame(frame)
                    s[k] = a
                    s[BLOCK + k] = b
                    s[2 * BLOCK + k] = c
                    if full:
                        store_frame(s, k, point, du, frame, sign)
                j = block * BLOCK
                n = min(BLOCK, count - j)
                if simple:
                    if gaussian.size:
                        out = gaussian[i]
                        for k in range(n):
                            out[j + k] = s[k] * s[2 * BLOCK + k] - s[BLOCK + k] * s[BLOCK + k]
                    if mean.size:
                        out = mean[i]
                        for k in range(n):
                            out[j + k] = 0.5 * (s[k] + s[2 * BLOCK + k])
                else:
                    fill_planes(s, n, i, j, sign, relative, flat, noise, floats, codes)

    return drive
