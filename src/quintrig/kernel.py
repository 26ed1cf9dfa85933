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

from quintrig import curvature
from quintrig.arrays import FloatArray
from quintrig.blocks import BLOCK
from quintrig.compiled import loop, scalar
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
    # Along a row of a grid u is fixed, so all points of a block share one set of row derivatives.
    stride, step = (1, 0) if functions == 0 else (BLOCK, 1)
    terms = 3 * size

    @scalar
    def contract(f: FloatArray, net: FloatArray, r: FloatArray) -> None:
        """Form the row derivatives of a block from the functions and the control points."""
        for x in range(terms):
            for k in range(BLOCK):
                value = first = second = 0.0
                for i in range(functions):
                    p = net[i * terms + x]
                    value += f[i * BLOCK + k] * p
                    first += f[(functions + i) * BLOCK + k] * p
                    second += f[(2 * functions + i) * BLOCK + k] * p
                r[x * BLOCK + k] = value
                r[(terms + x) * BLOCK + k] = first
                r[(2 * terms + x) * BLOCK + k] = second

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
                    contract(r, net, contracted)
                    r = contracted
                for k in range(BLOCK):
                    px = py = pz = ux = uy = uz = vx = vy = vz = 0.0
                    uux = uuy = uuz = uvx = uvy = uvz = vvx = vvy = vvz = 0.0
                    for m in range(size):
                        d0, d1, d2 = d[m * BLOCK + k], d[(size + m) * BLOCK + k], d[(2 * size + m) * BLOCK + k]
                        q, t = 3 * m * stride, step * k
                        x, y, z = r[q + t], r[q + stride + t], r[q + 2 * stride + t]
                        q = (terms + 3 * m) * stride
                        xu, yu, zu = r[q + t], r[q + stride + t], r[q + 2 * stride + t]
                        q = (2 * terms + 3 * m) * stride
                        xuu, yuu, zuu = r[q + t], r[q + stride + t], r[q + 2 * stride + t]
                        if full:
                            px += x * d0
                            py += y * d0
                            pz += z * d0
                        ux += xu * d0
                        uy += yu * d0
                        uz += zu * d0
                        vx += x * d1
                        vy += y * d1
                        vz += z * d1
                        uux += xuu * d0
                        uuy += yuu * d0
                        uuz += zuu * d0
                        uvx += xu * d1
                        uvy += yu * d1
                        uvz += zu * d1
                        vvx += x * d2
                        vvy += y * d2
                        vvz += z * d2
                    e, f, g = curvature.first_form(ux, uy, uz, vx, vy, vz)
                    nx, ny, nz, inverse = curvature.unit_normal(ux, uy, uz, vx, vy, vz, sign, tiny)
                    el = uux * nx + uuy * ny + uuz * nz
                    em = uvx * nx + uvy * ny + uvz * nz
                    en = vvx * nx + vvy * ny + vvz * nz
                    a, b, c = curvature.second_form_in_frame(e, f, inverse, el, em, en)
                    s[k] = a
                    s[BLOCK + k] = b
                    s[2 * BLOCK + k] = c
                    if full:
                        store_frame(s, k, (px, py, pz), (ux, uy, uz), (nx, ny, nz), (e, f, g), (el, em, en), sign)
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
