"""A surface as polynomials over cells of u and of v: what compiled loops evaluate, whatever the basis.

Rows and blend are functions of one parameter each. Over every cell all of them and their first and second derivatives
are met in Chebyshev's points; a cell in which they are not met to rounding is halved.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from quintrig.basis.functions import MOVING
from quintrig.geometry.surface import Surface
from quintrig.interrogation.field_jit import PARTIALS, SURFACE
from quintrig.kernel.blocks import increment_blocks
from quintrig.kernel.evaluate import row_derivatives, standing
from quintrig.support.arrays import BoolArray, FloatArray, aligned
from quintrig.support.memory import address
from quintrig.support.tolerance import SINGULAR

_POWERS = 12
_GRADED = 8  # halvings towards the ends, where a surface may stand still and small values must keep their digits
_HALVINGS = 8
_MOST = 2000  # cells of an axis, after which none is halved
_MET = 2e-14  # of the largest value of a derivative in a cell
_NOISE, _FALLS = 1e-10, 1.0 / 16.0
_BETWEEN = np.array([-0.93, -0.31, 0.17, 0.71])

_NODES = np.cos(np.pi * (np.arange(_POWERS) + 0.5) / _POWERS)
_SERIES = np.cos(np.outer(np.arange(_POWERS), np.arccos(_NODES))) * (2.0 / _POWERS)
_SERIES[0] *= 0.5
_EXPANDED = np.eye(_POWERS)  # Chebyshev's polynomials by powers
for _k in range(2, _POWERS):
    _EXPANDED[_k] = 2.0 * np.roll(_EXPANDED[_k - 1], 1) - _EXPANDED[_k - 2]

Functions = Callable[[FloatArray], FloatArray]
"""What gives (n, 3, width): functions at parameters (n,), with their first and second derivatives."""


class Cells:
    """A surface for compiled loops: ``words`` tells them of it, and ``scratch`` numbers of 8 bytes is what they need.

    Points are as seen from the surface's own origin. Second derivatives are those of the analysis, without the part
    along the first beside ends where the surface stands still, unless ``whole``.
    """

    def __init__(self, surface: Surface, whole: bool = False) -> None:
        """Meet rows and blend."""
        rows, blend, wide = _parts(surface, whole)
        size = surface.size
        tiny = SINGULAR * size * size if size > 0.0 else np.inf
        about = np.array([surface.sign, tiny, 1.0 / size if size > 0.0 else np.inf])
        self._kept = [about]  # as long as their addresses are
        self.words = np.zeros(SURFACE, dtype=np.int64)
        terms = 0
        for axis, functions in enumerate((rows, blend)):
            ends, coefficients = _met(functions, surface.breaks(axis))
            self._kept += [ends, coefficients]
            width = coefficients.shape[2]
            self.words[4 * axis : 4 * axis + 4] = address(ends), address(coefficients), len(ends) - 1, width
            terms = width // 3
        self.words[8:] = terms, wide, _POWERS, address(about)
        self.scratch = PARTIALS + int(self.words[3]) + int(self.words[7])


class Compiled:
    """The surfaces of a model for compiled loops, each made when it is first needed; ``scratch`` is enough for all."""

    def __init__(self, surfaces: Sequence[Surface], whole: bool, more: int) -> None:
        """Take the surfaces; ``more`` is what loops need of scratch for themselves."""
        self.surfaces, self.scratch = surfaces, aligned((more,))
        self._whole, self._more = whole, more
        self._made: dict[int, Cells] = {}

    def address(self, patch: int) -> int:
        """Return where the numbers of a surface lie."""
        if patch not in self._made:
            self._made[patch] = made = Cells(self.surfaces[patch], self._whole)
            if len(self.scratch) < self._more + made.scratch:
                self.scratch = aligned((self._more + made.scratch,))
        return address(self._made[patch].words)


def _parts(surface: Surface, whole: bool) -> tuple[Functions, Functions, int]:
    """Return origin and increments of the rows as functions of u, those of the blend of v, and how many coordinates."""
    near, blend = replace(surface, origin=np.zeros(3)), surface.blend
    if surface.rational:

        def homogeneous(u: FloatArray) -> FloatArray:
            found = surface.rows.derivatives(u, 2).transpose(1, 0, 2, 3)
            return np.concatenate([np.zeros_like(found[:, :, :1]), found], axis=2).reshape(len(u), 3, -1)

        return homogeneous, lambda v: blend.derivatives(v, 2).transpose(1, 0, 2), 4
    along, across = (MOVING, MOVING) if whole else standing(surface)

    def increments(v: FloatArray) -> FloatArray:
        blocks = increment_blocks(blend, v, still=across)
        return blocks.transpose(0, 3, 1, 2).reshape(-1, 3, blend.terms)[: len(v)]

    return lambda u: row_derivatives(near, u, along).reshape(len(u), 3, -1), increments, 3


def _met(functions: Functions, breaks: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the ends of cells (n + 1,) and the coefficients over them (n, powers, width)."""
    finer = np.ldexp(1.0, -np.arange(1, _GRADED + 1))
    few = len(breaks) < 16  # spans that are many are short
    inner: list[FloatArray] = [np.linspace(a, b, 9 if few else 2) for a, b in pairwise(breaks.tolist())]
    ends: FloatArray = np.unique(np.concatenate([*inner, finer, 1.0 - finer]))
    low: FloatArray = ends[:-1]
    high: FloatArray = ends[1:]
    found: list[tuple[FloatArray, FloatArray]] = []
    before: FloatArray = np.full(len(low), np.inf)
    for halving in range(_HALVINGS + 1):
        coefficients, off = _over(functions, low, high)
        # What halving does not make much smaller is the rounding of the functions themselves.
        met: BoolArray = (off <= _MET) | ((off <= _NOISE) & (off > _FALLS * before))
        if halving == _HALVINGS or len(low) > _MOST:
            met[:] = True
        found.append((low[met], coefficients[met]))
        low, high, before = low[~met], high[~met], np.tile(off[~met], 2)
        if not len(low):
            break
        middle: FloatArray = np.asarray(0.5 * (low + high), dtype=np.float64)
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
    begins = np.concatenate([one for one, _ in found])
    order = np.argsort(begins)
    coefficients = np.concatenate([one for _, one in found])[order]
    return np.append(begins[order], 1.0), np.ascontiguousarray(coefficients)


def _over(functions: Functions, low: FloatArray, high: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return coefficients (n, powers, width) over cells, and how far they are off between their points, (n,).

    It is relative to the largest value of a derivative in the cell, and 0 where there is none.
    """
    half = 0.5 * (high - low)[:, None]
    places = np.concatenate([_NODES, _BETWEEN])
    t = np.clip((low[:, None] + half) + half * places, low[:, None], high[:, None])
    with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
        values = functions(t.ravel()).reshape(len(low), len(places), -1)
        # First the series, whose high terms are small: the powers of those are large.
        coefficients = _EXPANDED.T @ (_SERIES @ values[:, :_POWERS])
        powers = np.vander(_BETWEEN, _POWERS, increasing=True)
        off = np.abs(powers @ coefficients - values[:, _POWERS:]).reshape(len(low), len(_BETWEEN), 3, -1)
        size = np.abs(values.reshape(len(low), len(places), 3, -1)).max(axis=(1, 3))
        share = off.max(axis=(1, 3)) / np.where(size > 0.0, size, 1.0)
    return coefficients, np.where(np.isfinite(values).all(axis=(1, 2)), share.max(axis=1), 0.0)
