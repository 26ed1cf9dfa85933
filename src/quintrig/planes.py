"""The output planes of an analysis, and the loops that fill them from a block's scratch rows.

Outputs are separate planes, one for each component; a plane of shape (0, 0) is a quantity that nobody asked for, and
costs nothing. Scratch holds ``SCRATCH_ROWS`` rows of BLOCK numbers: a few numbers a point, from which every quantity
follows.
"""

import numpy as np

from quintrig import classify, curvature, invariants
from quintrig.arrays import FloatArray, IntArray
from quintrig.blocks import BLOCK
from quintrig.compiled import loop, scalar
from quintrig.curvature import Three
from quintrig.quantity import QUANTITIES


def _slots() -> tuple[dict[str, int], dict[str, int]]:
    floats: dict[str, int] = {}
    codes: dict[str, int] = {}
    used = 0
    for q in QUANTITIES:
        if q.colour == "classes":
            codes[q.key] = len(codes)
        else:
            floats[q.key] = used
            used += q.components
    return floats, codes


FLOAT_SLOTS, CODE_SLOTS = _slots()
"""Index of the first output plane of each real quantity, and of the plane of each classification."""

FLOAT_PLANES = sum(q.components for q in QUANTITIES if q.colour != "classes")
CODE_PLANES = len(CODE_SLOTS)

_POINT, _NORMAL, _FORMS = FLOAT_SLOTS["point"], FLOAT_SLOTS["normal"], FLOAT_SLOTS["E"]
_GAUSSIAN, _MEAN = FLOAT_SLOTS["gaussian"], FLOAT_SLOTS["mean"]
_K1, _K2 = FLOAT_SLOTS["k1"], FLOAT_SLOTS["k2"]
_DIRECTION1, _DIRECTION2 = FLOAT_SLOTS["direction1"], FLOAT_SLOTS["direction2"]
_INDEX, _CURVEDNESS = FLOAT_SLOTS["shape_index"], FLOAT_SLOTS["curvedness"]
_PLANAR, _SURFACE = FLOAT_SLOTS["beta0"], FLOAT_SLOTS["beta0_surface"]
_POINT_TYPE, _HK = CODE_SLOTS["point_type"], CODE_SLOTS["hk_type"]
_SHAPE, _INVARIANT = CODE_SLOTS["shape_class"], CODE_SLOTS["invariant_type"]

# Scratch rows: a b c | normal | e1 | e2 | point | E F G L M N | H R K C | six invariants | Besl's number
_ROW_NORMAL, _ROW_E1, _ROW_E2, _ROW_POINT, _ROW_FORMS = 3, 6, 9, 12, 15
_ROW_H, _ROW_R, _ROW_K, _ROW_C, _ROW_INVARIANTS = 21, 22, 23, 24, 25
SCRATCH_ROWS = 31

FloatPlanes = tuple[FloatArray, ...]
CodePlanes = tuple[IntArray, ...]


@scalar
def _copy(s: FloatArray, row: int, n: int, out: FloatArray, j: int) -> None:
    for k in range(n):
        out[j + k] = s[row * BLOCK + k]


@loop
def fill_planes(
    s: FloatArray,
    n: int,
    i: int,
    j: int,
    sign: float,
    relative: float,
    flat: float,
    noise: float,
    floats: FloatPlanes,
    codes: CodePlanes,
) -> None:
    """Write the requested quantities of ``n`` points from scratch ``s`` to row i, columns j onwards."""
    for k in range(n):
        a, b, c = s[k], s[BLOCK + k], s[2 * BLOCK + k]
        mean, radius = curvature.mean_and_radius(a, b, c)
        s[_ROW_H * BLOCK + k] = mean
        s[_ROW_R * BLOCK + k] = radius
        s[_ROW_K * BLOCK + k] = a * c - b * b
        s[_ROW_C * BLOCK + k] = np.sqrt(mean * mean + radius * radius)
    if floats[_GAUSSIAN].size:
        _copy(s, _ROW_K, n, floats[_GAUSSIAN][i], j)
    if floats[_MEAN].size:
        _copy(s, _ROW_H, n, floats[_MEAN][i], j)
    if floats[_CURVEDNESS].size:
        _copy(s, _ROW_C, n, floats[_CURVEDNESS][i], j)
    if floats[_K1].size:
        out = floats[_K1][i]
        for k in range(n):
            out[j + k] = s[_ROW_H * BLOCK + k] + s[_ROW_R * BLOCK + k]
    if floats[_K2].size:
        out = floats[_K2][i]
        for k in range(n):
            out[j + k] = s[_ROW_H * BLOCK + k] - s[_ROW_R * BLOCK + k]
    if floats[_POINT].size:
        for x in range(3):
            _copy(s, _ROW_POINT + x, n, floats[_POINT + x][i], j)
    if floats[_NORMAL].size:
        for x in range(3):
            _copy(s, _ROW_NORMAL + x, n, floats[_NORMAL + x][i], j)
    for x in range(6):
        if floats[_FORMS + x].size:
            _copy(s, _ROW_FORMS + x, n, floats[_FORMS + x][i], j)
    if floats[_DIRECTION1].size or floats[_DIRECTION2].size:
        _directions(s, n, i, j, relative, noise, floats)
    if floats[_INDEX].size or codes[_SHAPE].size:
        _indices(s, n, i, j, relative, flat, noise, floats, codes)
    if codes[_HK].size:
        out = codes[_HK][i]
        for k in range(n):
            out[j + k] = classify.besl(
                s[_ROW_K * BLOCK + k], s[_ROW_H * BLOCK + k], s[_ROW_C * BLOCK + k], relative, flat
            )
    if codes[_POINT_TYPE].size:
        out = codes[_POINT_TYPE][i]
        for k in range(n):
            h, r, c = s[_ROW_H * BLOCK + k], s[_ROW_R * BLOCK + k], s[_ROW_C * BLOCK + k]
            code = classify.besl(s[_ROW_K * BLOCK + k], h, c, relative, flat)
            out[j + k] = classify.point_type(code, r, c, relative)
    wanted = codes[_INVARIANT].size
    for x in range(6):
        wanted += floats[_PLANAR + x].size + floats[_SURFACE + x].size
    if wanted:
        _six_invariants(s, n, i, j, sign, relative, flat, floats, codes)


@loop
def _directions(s: FloatArray, n: int, i: int, j: int, relative: float, noise: float, floats: FloatPlanes) -> None:
    for x in range(3):
        for second in range(2):
            out = floats[(_DIRECTION2 if second else _DIRECTION1) + x]
            if out.size:
                row = out[i]
                for k in range(n):
                    a, b, c = s[k], s[BLOCK + k], s[2 * BLOCK + k]
                    r = s[_ROW_R * BLOCK + k]
                    p, q = curvature.principal_direction(a, b, c, r)
                    e1, e2 = s[(_ROW_E1 + x) * BLOCK + k], s[(_ROW_E2 + x) * BLOCK + k]
                    value = p * e2 - q * e1 if second else p * e1 + q * e2
                    c = s[_ROW_C * BLOCK + k]
                    row[j + k] = value if r > relative * c and c > noise else np.nan


@loop
def _indices(
    s: FloatArray,
    n: int,
    i: int,
    j: int,
    relative: float,
    flat: float,
    noise: float,
    floats: FloatPlanes,
    codes: CodePlanes,
) -> None:
    for k in range(n):
        h, r, c = s[_ROW_H * BLOCK + k], s[_ROW_R * BLOCK + k], s[_ROW_C * BLOCK + k]
        index = curvature.shape_index(h, r, c, noise)
        if floats[_INDEX].size:
            floats[_INDEX][i, j + k] = index
        if codes[_SHAPE].size:
            code = classify.besl(s[_ROW_K * BLOCK + k], h, c, relative, flat)
            codes[_SHAPE][i, j + k] = classify.shape_class(index, code)


@loop
def _six_invariants(
    s: FloatArray,
    n: int,
    i: int,
    j: int,
    sign: float,
    relative: float,
    flat: float,
    floats: FloatPlanes,
    codes: CodePlanes,
) -> None:
    for metric in range(2):
        for k in range(n):
            z1, z2 = s[(_ROW_E1 + 2) * BLOCK + k], s[(_ROW_E2 + 2) * BLOCK + k]
            nz = s[(_ROW_NORMAL + 2) * BLOCK + k]
            g1, g2, g3 = invariants.slope_forms(s[k], s[BLOCK + k], s[2 * BLOCK + k], z1, z2, sign)
            slope = z1 * z1 + z2 * z2
            h, gauss = s[_ROW_H * BLOCK + k], s[_ROW_K * BLOCK + k]
            if metric == 0:
                values = invariants.planar(g1, g2, g3, slope, h, gauss, nz)
            else:
                values = invariants.surface(g1, g2, g3, slope, h, gauss, nz)
            s[_ROW_INVARIANTS * BLOCK + k] = values[0]
            s[(_ROW_INVARIANTS + 1) * BLOCK + k] = values[1]
            s[(_ROW_INVARIANTS + 2) * BLOCK + k] = values[2]
            s[(_ROW_INVARIANTS + 3) * BLOCK + k] = values[3]
            s[(_ROW_INVARIANTS + 4) * BLOCK + k] = values[4]
            s[(_ROW_INVARIANTS + 5) * BLOCK + k] = values[5]
        for x in range(6):
            out = floats[(_SURFACE if metric else _PLANAR) + x]
            if out.size:
                _copy(s, _ROW_INVARIANTS + x, n, out[i], j)
        if metric == 0 and codes[_INVARIANT].size:
            row = codes[_INVARIANT][i]
            for k in range(n):
                half = 0.5 * s[(_ROW_INVARIANTS + 1) * BLOCK + k]
                det = s[(_ROW_INVARIANTS + 2) * BLOCK + k]
                # max keeps rounding from a negative root; written so that NaN stays NaN.
                square = 2.0 * half * half - det
                row[j + k] = classify.besl(det, half, np.sqrt(square if not square < 0.0 else 0.0), relative, flat)


@scalar
def store_frame(s: FloatArray, k: int, point: Three, tangent: Three, at: curvature.Frame, sign: float) -> None:
    """Store point, normal, frame and fundamental forms of point k in scratch; ``tangent`` is S_u."""
    normal, _, first, second = at
    nx, ny, nz = normal
    scale = 1.0 / np.sqrt(first[0])
    x, y, z = tangent[0] * scale, tangent[1] * scale, tangent[2] * scale
    s[_ROW_E1 * BLOCK + k] = x
    s[(_ROW_E1 + 1) * BLOCK + k] = y
    s[(_ROW_E1 + 2) * BLOCK + k] = z
    s[_ROW_E2 * BLOCK + k] = sign * (ny * z - nz * y)
    s[(_ROW_E2 + 1) * BLOCK + k] = sign * (nz * x - nx * z)
    s[(_ROW_E2 + 2) * BLOCK + k] = sign * (nx * y - ny * x)
    _store(s, _ROW_NORMAL, k, normal)
    _store(s, _ROW_POINT, k, point)
    _store(s, _ROW_FORMS, k, first)
    _store(s, _ROW_FORMS + 3, k, second)


@scalar
def _store(s: FloatArray, row: int, k: int, values: Three) -> None:
    s[row * BLOCK + k] = values[0]
    s[(row + 1) * BLOCK + k] = values[1]
    s[(row + 2) * BLOCK + k] = values[2]
