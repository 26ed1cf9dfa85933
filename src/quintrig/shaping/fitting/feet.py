"""Feet of points followed from one round of a fit to the next: Newton's steps from where they were, over all patches.

Patches of a grid join with equal derivatives, so that they are one surface over [0, n] x [0, m]; a foot may cross from
one to the next. A search of the whole surface, as in ``scan.nearest``, is needed at the start and at the end alone.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quintrig.basis.functions import Functions
from quintrig.scan.nearest import Feet
from quintrig.shaping.fitting.forms import Form
from quintrig.support.arrays import FloatArray

_ROUNDS = 4
_MOVED = 1e-6  # of a patch's parameter: feet that move by less have arrived
_FARTHEST = 0.25  # of a patch, in one step
_ON_BORDER = 1e-9


@dataclass(frozen=True, eq=False)
class Sheet:
    """The patches of a form at given unknowns: one surface, parameters (n, 2) up to the numbers of patches."""

    form: Form
    q: FloatArray
    theta: FloatArray

    @cached_property
    def _nets(self) -> FloatArray:
        return self.form.nets(self.q)

    @cached_property
    def _families(self) -> tuple[Functions, Functions]:
        return self.form.families(self.theta)

    def split(self, at: FloatArray) -> tuple[NDArray[np.int64], FloatArray]:
        """Return the patches (n,) that parameters lie in, and those of the patch (n, 2)."""
        cells = np.array(self.form.grid)
        index = np.clip(at.astype(np.int64), 0, cells - 1)
        return index[:, 0] * cells[1] + index[:, 1], at - index

    def together(self, which: NDArray[np.int64], u: FloatArray, v: FloatArray) -> FloatArray:
        """Return parameters (n, 2) of all from those of patches."""
        rows, columns = np.divmod(which, self.form.grid[1])
        return np.stack([rows + u, columns + v], axis=1)

    def jet(self, at: FloatArray, order: int) -> dict[tuple[int, int], FloatArray]:
        """Return the partial derivatives up to an order, each (n, 3), by how often by u and by v."""
        which, local = self.split(at)
        u, v = self._families
        one = u.derivatives(np.clip(local[:, 0], 0.0, 1.0), order)
        other = v.derivatives(np.clip(local[:, 1], 0.0, 1.0), order)
        result = {(i, j): np.empty((len(at), 3)) for i in range(order + 1) for j in range(order + 1 - i)}
        for index, net in enumerate(self._nets):
            mine = which == index if len(self._nets) > 1 else slice(None)
            rows = net.reshape(len(net), -1)
            for i in range(order + 1):
                across = (one[i][mine] @ rows).reshape(-1, *net.shape[1:])
                for j in range(order + 1 - i):
                    result[i, j][mine] = np.einsum("njx,nj->nx", across, other[j][mine])
        return result

    def followed(self, points: FloatArray, at: FloatArray, low: FloatArray, high: FloatArray) -> FloatArray:
        """Return the parameters (n, 2) from ``low`` to ``high`` of the feet nearest to where they were, ``at``."""
        at = np.clip(at, low, high)
        best, least = at.copy(), np.full(len(at), np.inf)
        step = np.zeros_like(at)
        active = np.arange(len(at))
        for _ in range(_ROUNDS):
            d = self.jet(at[active], 2)
            r = d[0, 0] - points[active]
            gap = (r * r).sum(axis=1)
            nearer = gap <= least[active]
            better = active[nearer]
            least[better], best[better] = gap[nearer], at[better]
            new = _newton(d, r, at[active], low[active], high[active])
            # A step that led away is halved.
            new = np.where(nearer[:, None], new, 0.5 * step[active])
            step[active] = new
            at[active] = np.clip(best[active] + new, low[active], high[active])
            active = active[np.abs(at[active] - best[active]).max(axis=1) > _MOVED]
            if not len(active):
                return at
        if len(active):
            r = self.jet(at[active], 0)[0, 0] - points[active]
            worse = active[(r * r).sum(axis=1) > least[active]]
            at[worse] = best[worse]
        return at

    def feet(self, points: FloatArray, at: FloatArray) -> Feet:
        """Return the feet at parameters (n, 2)."""
        which, local = self.split(at)
        d = self.jet(at, 1)
        away = points - d[0, 0]
        across: FloatArray = np.asarray(np.cross(d[1, 0], d[0, 1]), dtype=np.float64)
        size, far = np.sqrt(_dot(across, across)), np.sqrt(_dot(away, away))
        plain = size > 1e-12 * np.sqrt(_dot(d[1, 0], d[1, 0]) * _dot(d[0, 1], d[0, 1])) + 1e-300
        normal: FloatArray = np.empty_like(away)
        normal[plain] = across[plain] / size[plain, None]
        normal[~plain] = away[~plain] / np.maximum(far[~plain], 1e-300)[:, None]
        ends = np.array(self.form.grid)
        border = ((at <= _ON_BORDER) | (at >= ends - _ON_BORDER)).any(axis=1)
        aside = away - _dot(away, normal)[:, None] * normal
        slip = np.sqrt(_dot(aside, aside))
        edge = border & (slip > 1e-6 * far) & (far > 1e-10)
        return Feet(which, local[:, 0], local[:, 1], d[0, 0], normal, away, edge)


def _newton(
    d: dict[tuple[int, int], FloatArray], r: FloatArray, at: FloatArray, low: FloatArray, high: FloatArray
) -> FloatArray:
    """Return Newton's steps (n, 2) towards the feet, along a border where one would leave it."""
    g = np.stack([_dot(d[1, 0], r), _dot(d[0, 1], r)], axis=1)
    e, f, h = _dot(d[1, 0], d[1, 0]), _dot(d[1, 0], d[0, 1]), _dot(d[0, 1], d[0, 1])
    a, b, c = e + _dot(d[2, 0], r), f + _dot(d[1, 1], r), h + _dot(d[0, 2], r)
    # Where the distance is no minimum to second order, the first order leads on.
    convex = (a > 1e-3 * e) & (c > 1e-3 * h) & (a * c - b * b > 1e-3 * (e * h - f * f))
    a, b, c = np.where(convex, a, e), np.where(convex, b, f), np.where(convex, c, h)
    held = ((at <= low) & (g > 0.0)) | ((at >= high) & (g < 0.0))
    b = np.where(held.any(axis=1), 0.0, b)
    det = np.maximum(a * c - b * b, 1e-300)
    step = np.stack([(b * g[:, 1] - c * g[:, 0]) / det, (b * g[:, 0] - a * g[:, 1]) / det], axis=1)
    return np.clip(np.where(held, 0.0, step), -_FARTHEST, _FARTHEST)


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    return np.einsum("ni,ni->n", a, b)
