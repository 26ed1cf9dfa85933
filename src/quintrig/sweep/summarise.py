"""The compiled summary of designs: one pass over the points of each, in lanes, without arrays of points.

Points are Clenshaw-Curtis nodes: they include the edges, where extremes often lie, and carry the weights of a
quadrature that converges as fast as Gauss's on smooth integrands (Trefethen 2008).
"""

from functools import cache
from typing import Protocol

import numpy as np

from quintrig.kernel import contraction
from quintrig.kernel.contraction import DUU, DUV, DVV, PARTIALS, three
from quintrig.quantities import classify, curvature
from quintrig.quantities.classify import HK_TYPES
from quintrig.support.arrays import FloatArray, aligned
from quintrig.support.compiled import loop, scalar
from quintrig.support.memory import address, floats_at, stack_at, table_at
from quintrig.support.tolerance import NOISE

EXTREMES = ("gaussian", "mean", "curvedness")
"""Keys of the quantities whose least and greatest values are columns."""

COLUMNS: tuple[str, ...] = (
    *(f"{key}_{what}" for key in EXTREMES for what in ("min", "max")),
    "area",
    *(f"{key}_mean" for key in EXTREMES),
    "bending_energy",
    "thin_plate_energy",
    *(f"share_{name.replace(' ', '_')}" for name in HK_TYPES[1:]),
    "singular",
)
"""Columns of a summary. Means and shares are by area; energies as in ``integrate``; ``singular`` counts points."""

_SUMS, _SHARES, _SINGULAR = 6, 12, 21
_ACCUMULATORS = 22
# Scratch rows after the partial derivatives
_K, _H, _C, _W, _THIN, _CODE = range(PARTIALS, PARTIALS + 6)
_SCRATCH = PARTIALS + 6


class Summariser(Protocol):
    """A compiled summary; see ``summariser``."""

    def __call__(
        self,
        rows: FloatArray,
        blend: FloatArray,
        weights: FloatArray,
        wu: FloatArray,
        wv: FloatArray,
        sign: float,
        singular: float,
        relative: float,
        flat: float,
        out: FloatArray,
    ) -> None:
        """Fill one row of ``out`` for each row of ``weights``."""
        ...


def clenshaw_curtis(count: int) -> tuple[FloatArray, FloatArray]:
    """Return ``count`` nodes on [0, 1], ends included, and weights that sum to 1 (Clenshaw and Curtis 1960)."""
    angle = np.pi * np.arange(count) / (count - 1)
    degree = np.arange(count)
    # Integrals of the Chebyshev polynomials over [-1, 1]: 2 / (1 - k²) for even k.
    integral = np.where(degree % 2 == 0, 2.0 / (1.0 - np.where(degree == 1, 0, degree).astype(float) ** 2), 0.0)
    weights = np.linalg.solve(np.cos(np.outer(degree, angle)), integral)
    # sin² keeps the nodes near 0 accurate, and symmetric to those near 1.
    nodes = np.sin(0.5 * angle) ** 2
    nodes[-1] = 1.0
    return nodes, 0.5 * weights


@scalar
def _extent(r: FloatArray, d: FloatArray, s: FloatArray, terms: int, block: int) -> float:
    """Return the diagonal of the bounding box of every fourth row of points and the last."""
    square = 0.0
    for axis in range(3):
        low, high = np.inf, -np.inf
        for i in range(0, r.shape[0] + 3, 4):
            row = r[min(i, r.shape[0] - 1)]
            for k in range(block):
                value = row[axis]
                for m in range(terms):
                    value += row[3 * (m + 1) + axis] * d[m * block + k]
                s[k] = value
            for k in range(block):
                low = min(low, s[k])
                high = max(high, s[k])
        square += (high - low) ** 2
    return np.sqrt(square)


@scalar
def _points(s: FloatArray, sign: float, tiny: float, least: float, block: int) -> None:
    """Write K, H, C, W and the thin-plate integrand of one row of points to scratch, from their partial derivatives.

    K and H that are only rounding, as in ``noise``, are 0; ``least`` is 1 / size.
    """
    for k in range(block):
        _, inverse, (a, b, c) = contraction.form(s, k, sign, tiny, block)
        mean, half_difference = curvature.mean(a, c), curvature.half_difference(a, b, c)
        gauss, curved = curvature.gaussian(a, b, c), np.sqrt(mean * mean + half_difference * half_difference)
        bend = least if curved < least else curved
        s[_K * block + k] = 0.0 if abs(gauss) <= NOISE * bend * bend else gauss
        s[_H * block + k] = 0.0 if abs(mean) <= NOISE * bend else mean
        s[_C * block + k] = curved
        s[_W * block + k] = 1.0 / inverse
        dot = curvature.dot
        duu, duv, dvv = three(s, DUU, k, block), three(s, DUV, k, block), three(s, DVV, k, block)
        s[_THIN * block + k] = dot(duu, duu) + 2.0 * dot(duv, duv) + dot(dvv, dvv)


@scalar
def _gather(
    s: FloatArray, weight: float, wv: FloatArray, lanes: FloatArray, relative: float, plane: float, block: int
) -> None:
    """Add one row of points to the lanes. A comparison with NaN is false, so singular points change no extreme."""
    for q in range(3):
        low, high = lanes[2 * q], lanes[2 * q + 1]
        for k in range(block):
            value = s[(_K + q) * block + k]
            low[k] = value if value < low[k] else low[k]
            high[k] = -value if -value < high[k] else high[k]
    for k in range(block):
        gauss, mean, curved = s[_K * block + k], s[_H * block + k], s[_C * block + k]
        regular = gauss == gauss  # noqa: PLR0124 (false for NaN alone)
        area = weight * wv[k] * s[_W * block + k] if regular else 0.0
        lanes[_SUMS, k] += area
        lanes[_SUMS + 1, k] += area * gauss if regular else 0.0
        lanes[_SUMS + 2, k] += area * mean if regular else 0.0
        lanes[_SUMS + 3, k] += area * curved if regular else 0.0
        lanes[_SUMS + 4, k] += 2.0 * area * curved * curved if regular else 0.0
        lanes[_SUMS + 5, k] += weight * wv[k] * s[_THIN * block + k]
        lanes[_SINGULAR, k] += 0.0 if regular or wv[k] == 0.0 else 1.0
        s[_W * block + k] = area
        s[_CODE * block + k] = classify.besl(gauss, mean, curved, relative, plane)
    for code in range(1, 10):
        share = lanes[_SHARES + code - 1]
        for k in range(block):
            share[k] += s[_W * block + k] if s[_CODE * block + k] == code else 0.0


@scalar
def _least(values: FloatArray) -> float:
    least = np.inf
    for k in range(values.size):
        least = min(least, values[k])
    return least


@scalar
def _total(values: FloatArray) -> float:
    total = 0.0
    for k in range(values.size):
        total += values[k]
    return total


@scalar
def _reduce(lanes: FloatArray, row: FloatArray) -> None:
    """Turn the lanes into the columns of a summary."""
    for q in range(3):
        low, high = _least(lanes[2 * q]), -_least(lanes[2 * q + 1])
        row[2 * q] = low if low < np.inf else np.nan
        row[2 * q + 1] = high if high > -np.inf else np.nan
    area = _total(lanes[_SUMS])
    row[_SUMS] = area
    for q in range(1, 4):
        row[_SUMS + q] = _total(lanes[_SUMS + q]) / area
    row[_SUMS + 4] = _total(lanes[_SUMS + 4])
    row[_SUMS + 5] = _total(lanes[_SUMS + 5])
    for code in range(9):
        row[_SHARES + code] = _total(lanes[_SHARES + code]) / area
    row[_SINGULAR] = _total(lanes[_SINGULAR])


@cache
def summariser(terms: int, block: int) -> Summariser:
    """Return the compiled summary for surfaces of ``terms`` row increments and at most ``block`` points in v.

    ``rows`` (1 + p, nu, 9 (1 + terms)) and ``blend`` (1 + p, 3 terms block) are those of ``affine.Parts``,
    ``weights`` (n, p); ``wu`` (nu,) and ``wv`` (block,) quadrature weights, zero where v is padding; ``singular`` and
    ``flat`` as shares of the size; ``out`` (n, columns).
    """
    width, increments, columns = 9 * (1 + terms), 3 * terms * block, len(COLUMNS)

    @loop
    def summarise(
        all_rows: int,
        all_blends: int,
        all_weights: int,
        designs: int,
        parts: int,
        count: int,
        weights_u: int,
        weights_v: int,
        sign: float,
        singular: float,
        relative: float,
        flat: float,
        scratch: int,
        result: int,
    ) -> None:
        rows, blend = stack_at(all_rows, 1 + parts, count, width), table_at(all_blends, 1 + parts, increments)
        weights, out = table_at(all_weights, designs, parts), table_at(result, designs, columns)
        wu, wv = floats_at(weights_u), floats_at(weights_v)
        s = table_at(scratch, 1, _SCRATCH * block)[0]
        lanes = table_at(scratch + 8 * _SCRATCH * block, _ACCUMULATORS, block)
        d = table_at(scratch + 8 * (_SCRATCH + _ACCUMULATORS) * block, 1, increments)[0]
        r = table_at(scratch + 8 * ((_SCRATCH + _ACCUMULATORS) * block + increments), count, width)
        for n in range(designs):
            # Number by number: Numba copies a row that it cannot tell apart from its target, in memory of its own.
            for x in range(increments):
                d[x] = blend[0, x]
            for i in range(count):
                for x in range(width):
                    r[i, x] = rows[0, i, x]
            for p in range(parts):
                value = weights[n, p]
                for x in range(increments):
                    d[x] += value * blend[p + 1, x]
                for i in range(count):
                    for x in range(width):
                        r[i, x] += value * rows[p + 1, i, x]
            extent = _extent(r, d, s, terms, block)
            tiny = singular * extent * extent
            least = 1.0 / extent if extent > 0.0 else np.inf
            plane = flat * least
            for x in range(_ACCUMULATORS):
                for k in range(block):
                    lanes[x, k] = np.inf if x < _SUMS else 0.0
            for i in range(r.shape[0]):
                contraction.partials(r[i], d, s, False, terms, block, 1, 0)
                _points(s, sign, tiny, least, block)
                _gather(s, wu[i], wv, lanes, relative, plane, block)
            _reduce(lanes, out[n])

    def run(
        rows: FloatArray,
        blend: FloatArray,
        weights: FloatArray,
        wu: FloatArray,
        wv: FloatArray,
        sign: float,
        singular: float,
        relative: float,
        flat: float,
        out: FloatArray,
    ) -> None:
        count = rows.shape[1]
        scratch = aligned(((_SCRATCH + _ACCUMULATORS) * block + increments + count * width,))
        parts = tuple(np.ascontiguousarray(array) for array in (rows, blend, weights, wu, wv))
        r, b, w, u, v = (address(array) for array in parts)
        settings = sign, singular, relative, flat
        summarise(r, b, w, *weights.shape, count, u, v, *settings, address(scratch), address(out))

    return run
