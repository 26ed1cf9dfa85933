"""The fields that lines follow, compiled: a surface at a point from polynomials over cells, and the direction there.

A surface is told by whole numbers (``SURFACE``) that ``cells`` makes: for u and for v the address of the cells' ends,
that of the coefficients (cell, power, function), how many cells and functions; then increments, coordinates, powers,
and the address of the normal's sign, the least area (length²) and 1/size. A state is u, v, their speeds where the field
is that of geodesics, and arc length.
"""

import numpy as np

from quintrig.kernel import contraction
from quintrig.kernel.contraction import DU, DUU, DUV, DV, DVV, three
from quintrig.quantities import curvature
from quintrig.support.compiled import part
from quintrig.support.memory import floats_at, words_at

U, V, TERMS, DIMENSION, POWERS, ABOUT, SURFACE = 0, 4, 8, 9, 10, 11, 12
"""Where a surface's numbers stand, and how many there are."""

GEODESIC, PRINCIPAL, ASYMPTOTIC = 0, 1, 2
"""Kinds of fields."""

STATE = 5
"""Numbers of a state: the last is arc length."""

PARTIALS = 24
"""Numbers that the partial derivatives take in scratch."""

_UMBILIC = 1e-6  # of C and 1 / size: a spread of κ1 and κ2 below which directions have no sense any more


@part
def _functions(axis: int, powers: int, wanted: int, t: float, out: int) -> None:
    """Write the first ``wanted`` functions of an axis at ``t`` to ``out``."""
    told = words_at(axis)
    ends, width = floats_at(told[0]), told[3]
    low, high = 0, told[2]
    while high - low > 1:
        middle = (low + high) >> 1
        if t < ends[middle]:
            high = middle
        else:
            low = middle
    half = 0.5 * (ends[low + 1] - ends[low])
    x = ((t - ends[low]) - half) / half
    c, value = floats_at(told[1] + 8 * low * powers * width), floats_at(out)
    for k in range(wanted):
        value[k] = c[(powers - 1) * width + k]
    for j in range(powers - 2, -1, -1):
        for k in range(wanted):
            value[k] = value[k] * x + c[j * width + k]


@part
def surface_at(surface: int, u: float, v: float, second: int, scratch: int) -> None:
    """Write S to ``scratch``, and with ``second`` S_u, S_v, S_uu, S_uv, S_vv after it."""
    told, s = words_at(surface), floats_at(scratch)
    terms, n, powers = told[TERMS], told[DIMENSION], told[POWERS]
    wide = n * (1 + terms)
    at = scratch + 8 * PARTIALS
    r, d = floats_at(at), floats_at(at + 24 * wide)
    _functions(surface + 8 * U, powers, 3 * wide if second else wide, u, at)
    _functions(surface + 8 * V, powers, 3 * terms if second else terms, v, at + 24 * wide)
    for x in range(n):
        value = r[x]
        for m in range(terms):
            value += r[(m + 1) * n + x] * d[m]
        s[x if x < 3 else 18] = value
    if second:
        for x in range(n):
            du, duu = r[wide + x], r[2 * wide + x]
            dv = duv = dvv = 0.0
            for m in range(terms):
                q = (m + 1) * n + x
                du += r[wide + q] * d[m]
                dv += r[q] * d[terms + m]
                duu += r[2 * wide + q] * d[m]
                duv += r[wide + q] * d[terms + m]
                dvv += r[q] * d[2 * terms + m]
            place, step = (x, 3) if x < 3 else (18, 1)
            s[place + step] = du
            s[place + 2 * step] = dv
            s[place + 3 * step] = duu
            s[place + 4 * step] = duv
            s[place + 5 * step] = dvv
    if n == 4:  # divided by w, by Leibniz's rule
        w, wu, wv, wuu, wuv, wvv = s[18], s[19], s[20], s[21], s[22], s[23]
        for x in range(3):
            value = s[x] / w
            s[x] = value
            if second:
                du, dv = (s[DU + x] - wu * value) / w, (s[DV + x] - wv * value) / w
                s[DU + x], s[DV + x] = du, dv
                s[DUU + x] = (s[DUU + x] - 2.0 * wu * du - wuu * value) / w
                s[DUV + x] = (s[DUV + x] - wu * dv - wv * du - wuv * value) / w
                s[DVV + x] = (s[DVV + x] - 2.0 * wv * dv - wvv * value) / w


@part
def lifted(scratch: int, du: float, dv: float, out: int) -> float:
    """Write (du, dv) in space to ``out`` and return its length, from what ``surface_at`` wrote."""
    s, vector = floats_at(scratch), floats_at(out)
    square = 0.0
    for x in range(3):
        vector[x] = du * s[DU + x] + dv * s[DV + x]
        square += vector[x] * vector[x]
    return np.sqrt(square)


@part
def lowered(scratch: int, x: float, y: float, z: float) -> tuple[float, float]:
    """Return (du, dv) of the part of a vector in space that is tangent, from what ``surface_at`` wrote."""
    s, vector = floats_at(scratch), (x, y, z)
    su, sv = three(s, DU, 0, 1), three(s, DV, 0, 1)
    up = curvature.cross(su, sv)
    square = curvature.dot(up, up)
    # By dual vectors, which keep digits that E G - F² has lost.
    return (
        curvature.dot(vector, curvature.cross(sv, up)) / square,
        curvature.dot(vector, curvature.cross(up, su)) / square,
    )


@part
def slope(surface: int, kind: int, mode: int, state: int, aim_u: float, aim_v: float, out: int, scratch: int) -> int:
    """Write d(state)/ds by arc length, in the sense nearest to the aim, to ``out``; return 1 where the field ends.

    Beyond the edges the field is that at the edges. What is not known is NaN.
    """
    y, k = floats_at(state), floats_at(out)
    k[0] = k[1] = np.nan
    k[2] = k[3] = 0.0
    k[4] = 1.0
    if not (abs(y[0]) < 1e300 and abs(y[1]) < 1e300):
        return 1
    surface_at(surface, min(max(y[0], 0.0), 1.0), min(max(y[1], 0.0), 1.0), 1, scratch)
    s, about = floats_at(scratch), floats_at(words_at(surface)[ABOUT])
    if kind == GEODESIC:  # do Carmo 1976, §4.4
        p, q = y[2], y[3]
        pp, pq, qq = p * p, 2.0 * p * q, q * q
        bend = three(s, DUU, 0, 1), three(s, DUV, 0, 1), three(s, DVV, 0, 1)
        turn = (
            pp * bend[0][0] + pq * bend[1][0] + qq * bend[2][0],
            pp * bend[0][1] + pq * bend[1][1] + qq * bend[2][1],
            pp * bend[0][2] + pq * bend[1][2] + qq * bend[2][2],
        )
        back = lowered(scratch, turn[0], turn[1], turn[2])
        k[0], k[1], k[2], k[3] = p, q, -back[0], -back[1]
        return 0
    _, inverse, (a, b, c) = contraction.form(s, 0, about[0], about[1], 1)
    mean, spread = curvature.mean(a, c), curvature.half_difference(a, b, c)
    ended = not spread > _UMBILIC * (abs(mean) + spread + about[2])
    x, y1 = curvature.principal_direction(a, b, c, spread)
    if kind == ASYMPTOTIC:  # to one side and to the other of the direction of κ1
        over = 1.0 / (2.0 * spread)
        side, along = np.sqrt((mean + spread) * over), np.sqrt((spread - mean) * over)
        side = -side if mode == 2 else side
        x, y1 = x * along - y1 * side, x * side + y1 * along
        ended = ended or not curvature.gaussian(a, b, c) < 0.0
    elif mode == 2:
        x, y1 = -y1, x
    su, sv = three(s, DU, 0, 1), three(s, DV, 0, 1)
    e, f, g = curvature.dot(su, su), curvature.dot(su, sv), curvature.dot(sv, sv)
    root = np.sqrt(e)
    du, dv = x / root - y1 * (f * inverse / root), y1 * root * inverse
    sense = -1.0 if e * du * aim_u + f * (du * aim_v + dv * aim_u) + g * dv * aim_v < 0.0 else 1.0
    k[0], k[1] = sense * du, sense * dv
    return 1 if ended else 0
