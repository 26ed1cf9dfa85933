"""The sum at the heart of every surface: row derivatives times blend derivatives give the partial derivatives.

The sizes are arguments that every driver gives as constants: inlined, they unroll the sums. (They cannot be constants
of a function made for them: a compiled function that holds another in its closure is never found in the disk cache.)
"""

from quintrig.arrays import FloatArray
from quintrig.compiled import scalar
from quintrig.curvature import Three

Partials = tuple[Three, Three, Three, Three, Three, Three]


@scalar
def partials(r: FloatArray, d: FloatArray, k: int, size: int, block: int, stride: int, step: int) -> Partials:
    """Return S, S_u, S_v, S_uu, S_uv, S_vv of point k of a block, for a surface of ``size`` rows.

    ``r`` holds the row derivatives, ordered (derivative, row, coordinate): with ``stride`` 1 and ``step`` 0 one number
    each for the whole block, as along a row of a grid, where u is fixed; with ``stride`` ``block`` and ``step`` 1 one
    for each point. ``d`` holds the blend derivatives, ordered (derivative, row, point).
    """
    px = py = pz = ux = uy = uz = vx = vy = vz = 0.0
    uux = uuy = uuz = uvx = uvy = uvz = vvx = vvy = vvz = 0.0
    t = step * k
    for m in range(size):
        d0, d1, d2 = d[m * block + k], d[(size + m) * block + k], d[(2 * size + m) * block + k]
        q = 3 * m * stride + t
        x, y, z = r[q], r[q + stride], r[q + 2 * stride]
        q += 3 * size * stride
        xu, yu, zu = r[q], r[q + stride], r[q + 2 * stride]
        q += 3 * size * stride
        xuu, yuu, zuu = r[q], r[q + stride], r[q + 2 * stride]
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
    return (px, py, pz), (ux, uy, uz), (vx, vy, vz), (uux, uuy, uuz), (uvx, uvy, uvz), (vvx, vvy, vvz)


@scalar
def rows_of_net(f: FloatArray, net: FloatArray, r: FloatArray, functions: int, terms: int, block: int) -> None:
    """Fill ``r`` with the row derivatives of a block from shared functions and control points.

    ``f`` is ordered (derivative, function, point), ``net`` (function, row and coordinate), ``terms`` 3 times the rows.
    """
    for x in range(terms):
        for k in range(block):
            value = first = second = 0.0
            for i in range(functions):
                p = net[i * terms + x]
                value += f[i * block + k] * p
                first += f[(functions + i) * block + k] * p
                second += f[(2 * functions + i) * block + k] * p
            r[x * block + k] = value
            r[(terms + x) * block + k] = first
            r[(2 * terms + x) * block + k] = second
