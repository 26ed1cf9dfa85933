"""Every quantity of the table in row-blocked NumPy: the same formulas as ``quintrig``, written as well as we can.

Blocks of rows keep the temporaries in the cache; the partial derivatives are matrix products, as in ``rivals``; nothing
is worked out twice.
"""

import numpy as np

from bench.rivals import mixed_partials
from quintrig.quantities.classify import Thresholds

KEYS = (
    *("point", "normal", "gaussian", "mean", "k1", "k2", "direction1", "direction2", "shape_index", "curvedness"),
    *("point_type", "hk_type", "shape_class", "invariant_type"),
    *("beta0", "beta1", "beta2", "gamma1", "gamma2", "gamma3"),
)
VECTORS = ("point", "normal", "direction1", "direction2")
CODES = ("point_type", "hk_type", "shape_class", "invariant_type")


def fresh(nu, nv):
    """Return an array for each quantity, vectors with the coordinate first."""
    return {
        key: np.empty((3, nu, nv)) if key in VECTORS else np.empty((nu, nv), np.int8 if key in CODES else np.float64)
        for key in KEYS
    }


def every_quantity(net, u, v, shape, height, size, out):
    """Fill ``out`` with all quantities on a grid."""
    thresholds = Thresholds()
    for start, partials in mixed_partials(net, u, v, shape, height, point=True):
        part = slice(start, start + partials[0].shape[1])
        _fill({key: array[..., part, :] for key, array in out.items()}, partials, thresholds, size)


def _fill(out, partials, thresholds, size):
    s, su, sv, suu, suv, svv = partials
    out["point"][...] = s
    e, f = _dot(su, su), _dot(su, sv)
    n = out["normal"]
    np.multiply(su[1], sv[2], out=n[0])
    n[0] -= su[2] * sv[1]
    np.multiply(su[2], sv[0], out=n[1])
    n[1] -= su[0] * sv[2]
    np.multiply(su[0], sv[1], out=n[2])
    n[2] -= su[1] * sv[0]
    over = 1.0 / np.sqrt(_dot(n, n))
    n *= over
    second, mixed, third = _dot(suu, n), _dot(suv, n), _dot(svv, n)
    ratio = f / e
    a = second / e
    b = (mixed - ratio * second) * over
    c = (third - ratio * (2.0 * mixed - ratio * second)) * (e * over) * over
    d = 0.5 * (a - c)
    h, r, k = out["mean"], np.sqrt(d * d + b * b), out["gaussian"]
    np.add(a, c, out=h)
    h *= 0.5
    np.multiply(a, c, out=k)
    k -= b * b
    np.add(h, r, out=out["k1"])
    np.subtract(h, r, out=out["k2"])
    curved = out["curvedness"]
    np.sqrt(h * h + r * r, out=curved)
    np.arctan2(h, r, out=out["shape_index"])
    out["shape_index"] *= -2.0 / np.pi
    scale = 1.0 / np.sqrt(e)
    e1 = su * scale
    e2 = np.empty_like(e1)
    np.subtract(n[1] * e1[2], n[2] * e1[1], out=e2[0])
    np.subtract(n[2] * e1[0], n[0] * e1[2], out=e2[1])
    np.subtract(n[0] * e1[1], n[1] * e1[0], out=e2[2])
    _directions(out, e1, e2, b, d, r, curved, thresholds.relative)
    flat = thresholds.flat / size
    hk = _besl(k, h, curved, thresholds.relative, flat)
    out["hk_type"][...] = hk
    column = (hk - 1) % 3
    kind = np.where(column == 1, 3, 2)
    kind = np.where(column == 0, np.where(r <= thresholds.relative * curved, 5, 1), kind)
    out["point_type"][...] = np.where(hk == 5, 4, np.where(hk == 0, 0, kind))
    breaks = np.searchsorted((-0.875, -0.625, -0.375, -0.125, 0.125, 0.375, 0.625, 0.875), out["shape_index"]) + 1
    out["shape_class"][...] = np.where(hk == 5, 10, np.where(hk == 0, 0, breaks))
    _invariants(out, n[2], e1[2], e2[2], a, b, c, thresholds.relative, flat)


def _directions(out, e1, e2, b, d, r, curved, relative):
    positive = d >= 0.0
    x, y = np.where(positive, r + d, b), np.where(positive, b, r - d)
    with np.errstate(invalid="ignore", divide="ignore"):
        length = np.where(r > relative * curved, 1.0 / np.sqrt(x * x + y * y), np.nan)
    x *= length
    y *= length
    np.multiply(x, e1, out=out["direction1"])
    out["direction1"] += y * e2
    np.multiply(x, e2, out=out["direction2"])
    out["direction2"] -= y * e1


def _invariants(out, nz, z1, z2, a, b, c, relative, flat):
    square1, square2, product = z1 * z1, z2 * z2, z1 * z2
    cross = 2.0 * b * product
    first = a * square1 + cross + c * square2
    third = a * square2 - cross + c * square1
    second = (c - a) * product + b * (square1 - square2)
    i = 1.0 / nz
    i2 = i * i
    i3, i4 = i2 * i, i2 * i2
    np.multiply(square1 + square2, i2, out=out["beta0"])
    np.multiply(first + 2.0 * out["mean"] * nz * nz, i3, out=out["beta1"])
    np.multiply(out["gaussian"], i4, out=out["beta2"])
    np.multiply(first, i3 * i2, out=out["gamma1"])
    np.multiply(second, i4, out=out["gamma2"])
    np.multiply(third, i3, out=out["gamma3"])
    half, det = 0.5 * out["beta1"], out["beta2"]
    bend = np.sqrt(np.maximum(2.0 * half * half - det, 0.0))
    out["invariant_type"][...] = _besl(det, half, bend, relative, flat)


def _besl(gaussian, mean, curved, relative, flat):
    zero = relative * curved
    k_sign = np.sign(gaussian) * (np.abs(gaussian) > zero * curved)
    h_sign = np.sign(mean) * (np.abs(mean) > zero)
    code = (5.0 + 3.0 * h_sign - k_sign).astype(np.int8)
    code[curved <= flat] = 5
    code[~np.isfinite(curved)] = 0
    return code


def _dot(x, y):
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]
