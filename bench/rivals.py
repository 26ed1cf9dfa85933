"""The same formulas in NumPy, as well as we can write them: what the compiled driver is measured against."""

import numpy as np

from quintrig.basis.trigonometric import Trigonometric


def mixed_partials(net, u, v, shape, height, point=False, basis=Trigonometric):
    """Yield blocks of ``height`` rows: the first row and S_u, S_v, S_uu, S_uv, S_vv, each (3, rows, nv).

    With ``point``, S comes before them.
    """
    orders = ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
    rows = np.einsum("pui,ijx->puxj", basis(*shape[:2]).derivatives(u, 2), net)
    blend = np.ascontiguousarray(basis(*shape[2:]).derivatives(v, 2).transpose(0, 2, 1))
    for start in range(0, len(u), height):
        part = np.ascontiguousarray(rows[:, start : start + height])
        n, x = part.shape[1:3]
        products = [
            (part[p].reshape(n * x, -1) @ blend[q]).reshape(n, x, -1).transpose(1, 0, 2)
            for p, q in (((0, 0), *orders) if point else orders)
        ]
        yield start, products


def row_blocks(net, u, v, shape, height, gaussian, mean, basis=Trigonometric):
    """K and H on a grid, ``height`` rows of u at a time, so that every temporary stays in the cache."""
    for start, partials in mixed_partials(net, u, v, shape, height, basis=basis):
        part = slice(start, start + height)
        curvature(*partials, gaussian[part], mean[part])


def whole_grid(net, u, v, shape, gaussian, mean):
    """K and H on a grid in one piece: what a researcher writes first."""
    row_blocks(net, u, v, shape, len(u), gaussian, mean)


def scattered(net, u, v, shape, piece, gaussian, mean):
    """K and H at scattered points, ``piece`` points at a time: Fourier form of the basis and matrix products."""
    for start in range(0, u.size, piece):
        f = _basis(u[start : start + piece], *shape[:2])
        g = _basis(v[start : start + piece], *shape[2:])
        columns = [(f_p @ net.reshape(6, 18)).reshape(-1, 6, 3) for f_p in f]

        def mixed(p, q, columns=columns, g=g):
            return np.ascontiguousarray(np.einsum("njx,nj->xn", columns[p], g[q]))

        curvature(
            *(mixed(p, q) for p, q in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))),
            gaussian[start : start + piece],
            mean[start : start + piece],
        )


def _basis(t, alpha, zeta):
    """Values and two derivatives by t, each (n, 6), with one sine and one cosine a point."""
    rate = 0.5 * np.pi
    s, c = np.sin(rate * t), np.cos(rate * t)
    return _functions(s, c, rate * c, -rate * s, -rate * rate * s, -rate * rate * c, alpha, zeta)


def _functions(s, c, s1, c1, s2, c2, alpha, zeta):
    out = np.empty((3, s.size, 6))
    for i, (x, x1, x2, y, y1, y2, shape) in enumerate(((s, s1, s2, c, c1, c2, alpha), (c, c1, c2, s, s1, s2, zeta))):
        at = (lambda k: k) if i == 0 else (lambda k: 5 - k)
        a, b = 1.0 - x, 1.0 - y
        a2 = a * a
        a3 = a2 * a
        outer = (4.0 + shape) - 5.0 * shape * x
        slope = -a3 * outer
        bend = 3.0 * a2 * outer + 5.0 * shape * a3
        _put(out, at(0), a2 * a2 * (1.0 - shape * x), slope, bend, x1, x2)
        inner = 4.0 + shape * a
        slope = a2 * ((a - 3.0 * x) * inner - shape * x * a)
        bend = 2.0 * a * (3.0 * (x - a) * inner + shape * a * (3.0 * x - a))
        _put(out, at(1), x * a3 * inner, slope, bend, x1, x2)
        p, p1, p2 = a2 * b, -2.0 * a * x1 * b - a2 * y1, None
        p2 = (2.0 * x1 * x1 - 2.0 * a * x2) * b + 4.0 * a * x1 * y1 - a2 * y2
        q, q1, q2 = 8.0 * x + 3.0 * y + 9.0, 8.0 * x1 + 3.0 * y1, 8.0 * x2 + 3.0 * y2
        out[0, :, at(2)] = p * q
        out[1, :, at(2)] = p1 * q + p * q1
        out[2, :, at(2)] = p2 * q + 2.0 * p1 * q1 + p * q2
    return out


def _put(out, k, value, slope, bend, x1, x2):
    out[0, :, k] = value
    out[1, :, k] = slope * x1
    out[2, :, k] = bend * x1 * x1 + slope * x2


def curvature(su, sv, suu, suv, svv, gaussian, mean):
    """The formulas of ``quintrig.curvature`` on arrays with the coordinate first."""
    e = su[0] * su[0] + su[1] * su[1] + su[2] * su[2]
    f = su[0] * sv[0] + su[1] * sv[1] + su[2] * sv[2]
    nx = su[1] * sv[2] - su[2] * sv[1]
    ny = su[2] * sv[0] - su[0] * sv[2]
    nz = su[0] * sv[1] - su[1] * sv[0]
    over = 1.0 / np.sqrt(nx * nx + ny * ny + nz * nz)
    nx *= over
    ny *= over
    nz *= over
    second = [d[0] * nx + d[1] * ny + d[2] * nz for d in (suu, suv, svv)]
    ratio = f / e
    a = second[0] / e
    b = (second[1] - ratio * second[0]) * over
    c = (second[2] - 2.0 * ratio * second[1] + ratio * ratio * second[0]) * (e * over) * over
    np.multiply(a, c, out=gaussian)
    gaussian -= b * b
    np.add(a, c, out=mean)
    mean *= 0.5
