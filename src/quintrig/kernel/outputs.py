"""The output planes of an analysis, and the loops that fill them, block by block.

A plane is one component of a quantity at all points. The compiled code gets the addresses of the planes: an array of
them is one argument, whatever arrays they lie in, and no reference is counted where threads work side by side.

Between partial derivatives and planes lies scratch, ``SCRATCH_ROWS`` rows of BLOCK numbers in one array: all rows at
constant distances, so that the compiler sees that they do not overlap and vectorises every loop over a block. (Seen in
the machine code: fused multiply-adds on full-width registers, packed roots and divisions, no calls.)
"""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quintrig.kernel.contraction import DU, DUU, DUV, DV, DVV, PARTIALS, form, three
from quintrig.kernel.stores import LINE, write, write_past_caches
from quintrig.quantities import classify, curvature, invariants
from quintrig.quantities.curvature import Three
from quintrig.quantities.table import QUANTITIES
from quintrig.support.arrays import FloatArray
from quintrig.support.compiled import BLOCK, loop, part, scalar
from quintrig.support.memory import codes_at, floats_at, words_at

Addresses = NDArray[np.int64]
"""Where each plane starts, 0 for one that nobody asked for."""


class Settings(NamedTuple):
    """What the quantities depend on beside the surface's derivatives."""

    sign: float  # of the normal against S_u x S_v
    tiny: float  # largest |S_u x S_v| of a singular point, length²
    relative: float  # thresholds: see classify.Thresholds
    flat: float  # curvedness, length⁻¹
    noise: float  # curvedness that is rounding of a plane, length⁻¹
    stream: bool  # whether to write past the caches; then a row of the planes is longer than a block


def _slots() -> tuple[dict[str, int], dict[str, int]]:
    floats: dict[str, int] = {}
    codes: dict[str, int] = {}
    used = 0
    for q in QUANTITIES:
        if q.kind == "class":
            codes[q.key] = len(codes)
        else:
            floats[q.key] = used
            used += q.components
    return floats, codes


FLOAT_SLOTS, CODE_SLOTS = _slots()
"""Index of the first plane of each real quantity, and of the plane of each classification."""

FLOAT_COUNT = sum(q.components for q in QUANTITIES if q.kind != "class")
CODE_COUNT = len(CODE_SLOTS)


def _run(*keys: str) -> int:
    """Return the first plane of quantities that are written together, so must stand together in the table."""
    order = list(FLOAT_SLOTS)
    start = order.index(keys[0])
    found = order[start : start + len(keys)]
    if found != list(keys):
        raise RuntimeError(f"QUANTITIES: expected {', '.join(keys)} one after the other, found {', '.join(found)}")
    return FLOAT_SLOTS[keys[0]]


_SIX = ("beta0", "beta1", "beta2", "gamma1", "gamma2", "gamma3")
_POINT, _NORMAL, _FORMS = _run("point"), _run("normal"), _run("E", "F", "G", "L", "M", "N")
_GAUSSIAN, _DIRECTIONS = _run("gaussian", "mean", "k1", "k2"), _run("direction1", "direction2")
_INDEX, _PLANAR, _SURFACE = _run("shape_index", "curvedness"), _run(*_SIX), _run(*(f"{key}_surface" for key in _SIX))
_POINT_TYPE, _HK = CODE_SLOTS["point_type"], CODE_SLOTS["hk_type"]
_SHAPE, _INVARIANT = CODE_SLOTS["shape_class"], CODE_SLOTS["invariant_type"]

KH, FORM, FULL = range(3)
"""How much the planes need: K and H alone; what follows from a, b, c; point, normal and frame too."""

_OF_FORM = {"gaussian", "mean", "k1", "k2", "curvedness", "shape_index", "point_type", "hk_type", "shape_class"}

# Scratch rows after the partial derivatives, neighbours in the order of their planes
_K, _H, _K1, _K2, _S, _CURVED, _A, _B, _C, _R, _CODE = range(PARTIALS, PARTIALS + 11)
_N, _E1, _E2, SCRATCH_ROWS = range(_CODE + 1, _CODE + 11, 3)
# After the rows, a cache line for each plane
_KEPT = SCRATCH_ROWS * BLOCK
SCRATCH = _KEPT + LINE * FLOAT_COUNT
"""Numbers in scratch."""
# The partial derivatives' rows are free again once the frame is known.
_OUT = DU


def needs(keys: Iterable[str]) -> int:
    """Return ``KH``, ``FORM`` or ``FULL`` for the keys of some quantities."""
    wanted = set(keys)
    if wanted <= {"gaussian", "mean"}:
        return KH
    return FORM if wanted <= _OF_FORM else FULL


def finish(need: int) -> int:
    """Return the address of the compiled function that turns partial derivatives into planes.

    It takes, as addresses or numbers: scratch, how many points of the block to write, how many points after the
    planes' starts, marks, settings, ``floats`` and ``codes``.
    """
    return (_gaussian_and_mean, _form_planes, _all_planes)[need].address


@loop
def _gaussian_and_mean(scratch: int, n: int, offset: int, end: int, settings: int, floats: int, codes: int) -> None:
    s, at = floats_at(scratch), _settings(settings)
    # Straight to the planes; one that is not asked for stays in scratch.
    first, second = words_at(floats)[_GAUSSIAN], words_at(floats)[_GAUSSIAN + 1]
    gaussian = floats_at(first + 8 * offset if first else scratch + 8 * _K * BLOCK)
    mean = floats_at(second + 8 * offset if second else scratch + 8 * _H * BLOCK)
    for k in range(n):
        _, _, (a, b, c) = form(s, k, at.sign, at.tiny, BLOCK)
        gaussian[k] = curvature.gaussian(a, b, c)
        mean[k] = curvature.mean(a, c)


@loop
def _form_planes(scratch: int, n: int, offset: int, end: int, settings: int, floats: int, codes: int) -> None:
    s, at = floats_at(scratch), _settings(settings)
    _forms(s, False, at)
    _write_forms(scratch, n, offset, end, at, words_at(floats), words_at(codes))


@loop
def _all_planes(scratch: int, n: int, offset: int, end: int, settings: int, floats: int, codes: int) -> None:
    s, at = floats_at(scratch), _settings(settings)
    _forms(s, True, at)
    _write_forms(scratch, n, offset, end, at, words_at(floats), words_at(codes))
    _write_frames(scratch, n, offset, end, at, words_at(floats), words_at(codes))


@scalar
def _settings(start: int) -> Settings:
    p = floats_at(start)
    return Settings(p[0], p[1], p[2], p[3], p[4], p[5] != 0.0)


@scalar
def _write_forms(
    scratch: int, n: int, offset: int, end: int, at: Settings, floats: Addresses, codes: Addresses
) -> None:
    """Write what follows from a, b, c."""
    s = floats_at(scratch)
    _write(scratch, _K, 4, n, offset, end, floats, _GAUSSIAN, at.stream)
    if codes[_HK] or codes[_SHAPE] or codes[_POINT_TYPE]:
        for k in range(BLOCK):
            gauss, h, c = s[_K * BLOCK + k], s[_H * BLOCK + k], s[_CURVED * BLOCK + k]
            s[_CODE * BLOCK + k] = classify.besl(gauss, h, c, at.relative, at.flat)
    if codes[_HK]:
        out = codes_at(codes[_HK] + offset)
        for k in range(n):
            out[k] = np.int8(s[_CODE * BLOCK + k])
    if codes[_POINT_TYPE]:
        out = codes_at(codes[_POINT_TYPE] + offset)
        for k in range(n):
            gauss, r, c = s[_K * BLOCK + k], s[_R * BLOCK + k], s[_CURVED * BLOCK + k]
            out[k] = np.int8(classify.point_type(s[_CODE * BLOCK + k], gauss, r, c, at.relative))
    if floats[_INDEX] or codes[_SHAPE]:
        for k in range(BLOCK):
            h, r, c = s[_H * BLOCK + k], s[_R * BLOCK + k], s[_CURVED * BLOCK + k]
            s[_S * BLOCK + k] = curvature.shape_index(h, r, c, at.noise)
    if codes[_SHAPE]:
        out = codes_at(codes[_SHAPE] + offset)
        for k in range(n):
            out[k] = np.int8(classify.shape_class(s[_S * BLOCK + k], s[_CODE * BLOCK + k]))
    _write(scratch, _S, 2, n, offset, end, floats, _INDEX, at.stream)


@scalar
def _forms(s: FloatArray, full: bool, at: Settings) -> None:
    """Fill the scratch rows that follow from the partial derivatives; normal and frame only if ``full``."""
    for k in range(BLOCK):
        normal, inverse, (a, b, c) = form(s, k, at.sign, at.tiny, BLOCK)
        mean, half_difference = curvature.mean(a, c), curvature.half_difference(a, b, c)
        s[_A * BLOCK + k] = a
        s[_B * BLOCK + k] = b
        s[_C * BLOCK + k] = c
        s[_R * BLOCK + k] = half_difference
        s[_K * BLOCK + k] = curvature.gaussian(a, b, c)
        s[_H * BLOCK + k] = mean
        s[_K1 * BLOCK + k] = mean + half_difference
        s[_K2 * BLOCK + k] = mean - half_difference
        s[_CURVED * BLOCK + k] = np.sqrt(mean * mean + half_difference * half_difference)
        if full:
            du, side = three(s, DU, k, BLOCK), at.sign * inverse
            along = 1.0 / np.sqrt(curvature.dot(du, du))
            n = normal[0] * side, normal[1] * side, normal[2] * side
            e1 = du[0] * along, du[1] * along, du[2] * along
            e2 = curvature.cross(n, e1)
            _store(s, _N, k, n)
            _store(s, _E1, k, e1)
            _store(s, _E2, k, (at.sign * e2[0], at.sign * e2[1], at.sign * e2[2]))


@scalar
def _write_frames(
    scratch: int, n: int, offset: int, end: int, at: Settings, floats: Addresses, codes: Addresses
) -> None:
    """Write what needs point, normal or frame."""
    s = floats_at(scratch)
    _write(scratch, 0, 3, n, offset, end, floats, _POINT, at.stream)
    _write(scratch, _N, 3, n, offset, end, floats, _NORMAL, at.stream)
    if _any(floats, _FORMS, 6):
        for k in range(BLOCK):
            du, dv, normal = three(s, DU, k, BLOCK), three(s, DV, k, BLOCK), three(s, _N, k, BLOCK)
            second = (
                curvature.dot(three(s, DUU, k, BLOCK), normal),
                curvature.dot(three(s, DUV, k, BLOCK), normal),
                curvature.dot(three(s, DVV, k, BLOCK), normal),
            )
            _store(s, _OUT, k, (curvature.dot(du, du), curvature.dot(du, dv), curvature.dot(dv, dv)))
            _store(s, _OUT + 3, k, second)
        _write(scratch, _OUT, 6, n, offset, end, floats, _FORMS, at.stream)
    if _any(floats, _DIRECTIONS, 6):
        _directions(s, at)
        _write(scratch, _OUT, 6, n, offset, end, floats, _DIRECTIONS, at.stream)
    if _any(floats, _SURFACE, 6):
        _invariants(s, True, at.sign)
        _write(scratch, _OUT, 6, n, offset, end, floats, _SURFACE, at.stream)
    if codes[_INVARIANT] or _any(floats, _PLANAR, 6):
        _invariants(s, False, at.sign)
        _write(scratch, _OUT, 6, n, offset, end, floats, _PLANAR, at.stream)
    if codes[_INVARIANT]:
        out = codes_at(codes[_INVARIANT] + offset)
        for k in range(n):
            half, det = 0.5 * s[(_OUT + 1) * BLOCK + k], s[(_OUT + 2) * BLOCK + k]
            # max keeps rounding from a negative root; written so that NaN stays NaN.
            square = 2.0 * half * half - det
            bend = np.sqrt(square if not square < 0.0 else 0.0)
            out[k] = np.int8(classify.besl(det, half, bend, at.relative, at.flat))


@scalar
def _directions(s: FloatArray, at: Settings) -> None:
    """Fill six rows with the directions of κ1 and κ2."""
    for k in range(BLOCK):
        a, b, c = s[_A * BLOCK + k], s[_B * BLOCK + k], s[_C * BLOCK + k]
        r, curved = s[_R * BLOCK + k], s[_CURVED * BLOCK + k]
        p, q = curvature.principal_direction(a, b, c, r)
        p = p if r > at.relative * curved and curved > at.noise else np.nan
        e1, e2 = three(s, _E1, k, BLOCK), three(s, _E2, k, BLOCK)
        _store(s, _OUT, k, (p * e1[0] + q * e2[0], p * e1[1] + q * e2[1], p * e1[2] + q * e2[2]))
        _store(s, _OUT + 3, k, (p * e2[0] - q * e1[0], p * e2[1] - q * e1[1], p * e2[2] - q * e1[2]))


@scalar
def _invariants(s: FloatArray, surface: bool, sign: float) -> None:
    """Fill six rows with the invariants in one of the two metrics."""
    for k in range(BLOCK):
        z1, z2, nz = s[(_E1 + 2) * BLOCK + k], s[(_E2 + 2) * BLOCK + k], s[(_N + 2) * BLOCK + k]
        g1, g2, g3 = invariants.slope_forms(s[_A * BLOCK + k], s[_B * BLOCK + k], s[_C * BLOCK + k], z1, z2, sign)
        slope = z1 * z1 + z2 * z2
        h, gauss = s[_H * BLOCK + k], s[_K * BLOCK + k]
        if surface:
            six = invariants.surface(g1, g2, g3, slope, h, gauss, nz)
        else:
            six = invariants.planar(g1, g2, g3, slope, h, gauss, nz)
        _store(s, _OUT, k, (six[0], six[1], six[2]))
        _store(s, _OUT + 3, k, (six[3], six[4], six[5]))


@part
def _write(
    scratch: int, row: int, rows: int, n: int, offset: int, end: int, floats: Addresses, slot: int, stream: bool
) -> None:
    """Copy ``n`` numbers of each of ``rows`` scratch rows to the planes from ``slot`` on that are asked for."""
    for x in range(rows):
        if floats[slot + x]:
            source, target = scratch + 8 * (row + x) * BLOCK, floats[slot + x] + 8 * offset
            if stream:
                write_past_caches(source, target, n, end, scratch + 8 * (_KEPT + LINE * (slot + x)))
            else:
                write(source, target, n)


@scalar
def _any(floats: Addresses, slot: int, count: int) -> bool:
    wanted = 0
    for x in range(count):
        wanted |= floats[slot + x]
    return wanted != 0


@scalar
def _store(s: FloatArray, row: int, k: int, values: Three) -> None:
    s[row * BLOCK + k] = values[0]
    s[(row + 1) * BLOCK + k] = values[1]
    s[(row + 2) * BLOCK + k] = values[2]
