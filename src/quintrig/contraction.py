"""The sum at the heart of every surface: row derivatives times blend derivatives give the partial derivatives."""

from collections.abc import Callable

from quintrig.arrays import FloatArray
from quintrig.compiled import scalar

Three = tuple[float, float, float]
Partials = tuple[Three, Three, Three, Three, Three, Three]


def partials(size: int, block: int, scattered: bool) -> Callable[[FloatArray, FloatArray, int], Partials]:
    """Return the scalar formula for S, S_u, S_v, S_uu, S_uv, S_vv of point k of a block, for a surface of ``size`` rows.

    Its arguments are the row derivatives, ordered (derivative, row, coordinate), each one number for the whole block or,
    when ``scattered``, one for each of the block's points; the blend derivatives, ordered (derivative, row, point); and k.
    """
    # Along a row of a grid u is fixed, so all points of a block share one set of row derivatives.
    stride, step = (block, 1) if scattered else (1, 0)

    @scalar
    def formula(r: FloatArray, d: FloatArray, k: int) -> Partials:
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

    return formula
