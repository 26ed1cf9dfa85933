"""The sum at the heart of every surface: row derivatives times increments of the blend give the partial derivatives.

A row of partial derivatives is one coordinate of one of them at the points of a block, in scratch that stays in the
level-1 cache: S in rows 0 to 2, then S_u, S_v, S_uu, S_uv, S_vv. Sizes are arguments that every driver gives as
constants: inlined, they unroll the sums. (They cannot be constants of a function made for them: a compiled function
that holds another in its closure is never found in the disk cache.)
"""

from quintrig.quantities import curvature
from quintrig.quantities.curvature import Three
from quintrig.support.arrays import FloatArray
from quintrig.support.compiled import scalar, unrolled

PARTIALS = 18
"""Rows of partial derivatives."""

DU, DV, DUU, DUV, DVV = 3, 6, 9, 12, 15


@unrolled
def partials(
    r: FloatArray, d: FloatArray, s: FloatArray, point: bool, terms: int, block: int, stride: int, step: int
) -> None:
    """Fill the rows of partial derivatives; those of S only with ``point``.

    ``r`` holds the derivatives of origin and ``terms`` row increments, ordered (derivative, term, coordinate): with
    ``stride`` 1 and ``step`` 0 one number each for the whole block, as along a row of a grid, where u is fixed; with
    ``stride`` ``block`` and ``step`` 1 one for each point. ``d`` holds the increments of the blend, ordered
    (derivative, term, point).
    """
    order = 3 * (1 + terms) * stride
    # One coordinate a loop: its 3 (1 + terms) numbers then stay in registers for a whole block.
    for x in range(3):
        at = x * stride
        for k in range(block):
            q = at + step * k
            u, uu = r[q + order], r[q + 2 * order]
            v = uv = vv = 0.0
            for m in range(terms):
                d0, d1, d2 = d[m * block + k], d[(terms + m) * block + k], d[(2 * terms + m) * block + k]
                q += 3 * stride
                u += r[q + order] * d0
                v += r[q] * d1
                uu += r[q + 2 * order] * d0
                uv += r[q + order] * d1
                vv += r[q] * d2
            s[(DU + x) * block + k] = u
            s[(DV + x) * block + k] = v
            s[(DUU + x) * block + k] = uu
            s[(DUV + x) * block + k] = uv
            s[(DVV + x) * block + k] = vv
        if point:
            for k in range(block):
                q = at + step * k
                value = r[q]
                for m in range(terms):
                    q += 3 * stride
                    value += r[q] * d[m * block + k]
                s[x * block + k] = value


@scalar
def three(s: FloatArray, row: int, k: int, block: int) -> Three:
    """Return three neighbouring rows of scratch at point k."""
    return s[row * block + k], s[(row + 1) * block + k], s[(row + 2) * block + k]


@scalar
def form(s: FloatArray, k: int, sign: float, tiny: float, block: int) -> tuple[Three, float, Three]:
    """Return S_u x S_v (length²), 1/W (length⁻²) and a, b, c (length⁻¹) of point k from its partial derivatives."""
    du, dv = three(s, DU, k, block), three(s, DV, k, block)
    normal = curvature.cross(du, dv)
    inverse = curvature.inverse_area(normal, tiny)
    duu, duv, dvv = three(s, DUU, k, block), three(s, DUV, k, block), three(s, DVV, k, block)
    return normal, inverse, curvature.form_in_frame(du, dv, duu, duv, dvv, normal, inverse, sign)


@unrolled
def rows_of_net(f: FloatArray, net: FloatArray, r: FloatArray, functions: int, terms: int, block: int) -> None:
    """Fill ``r`` with the row derivatives of a block from the increments of shared functions and of control points.

    ``f`` is ordered (derivative, increment, point), ``net`` (origin and increments, row and coordinate), ``terms``
    3 times origin and row increments.
    """
    for x in range(terms):
        for k in range(block):
            value, first, second = net[x], 0.0, 0.0
            for i in range(functions):
                p = net[(i + 1) * terms + x]
                value += f[i * block + k] * p
                first += f[(functions + i) * block + k] * p
                second += f[(2 * functions + i) * block + k] * p
            r[x * block + k] = value
            r[(terms + x) * block + k] = first
            r[(2 * terms + x) * block + k] = second
