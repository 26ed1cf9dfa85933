"""Moving the rows of a patch, as little as needed, so that it joins another one to a wanted order.

With y the parameter out of the first patch and x that into the second, the second meets the first to order k where
S2(x) = S1(y(x)): S2' = κ S1', S2'' = κ² S1'' + μ S1', S2''' = κ³ S1''' + 3κμ S1'' + ν S1' along the whole edge, with
constants κ > 0, μ and ν (Farin 2002, §21). For a fixed κ these are linear in the control points of the second patch,
μ and ν, whatever the basis.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.multipatch.boundary import SIDES
from quintrig.multipatch.nets import Handle
from quintrig.support.arrays import FloatArray

_POINTS = 16
_EXACT = 1e-9  # residual, relative to the sizes, up to which the conditions count as met
_RATIOS = np.geomspace(0.1, 10.0, 13)
_SECTIONS = 16
_GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)
_ENDS = 30.0  # weight of the corners where not all conditions can be met


@dataclass(frozen=True, eq=False)
class Match:
    """What a join does: new free coordinates of the patches moved, the ratio κ, and how far the net moves, length¹.

    ``exact`` where all conditions are met to rounding, else they are met in the sense of least squares.
    """

    first: FloatArray | None
    second: FloatArray
    ratio: float
    moved: float
    exact: bool


@dataclass(frozen=True, eq=False)
class Strip:
    """Derivatives across an edge at points along it, by the points of the net, (order + 1, n, net).

    ``along`` (n, m) are the functions along the edge at these points.
    """

    matrix: FloatArray
    net: FloatArray
    along: FloatArray

    @property
    def values(self) -> FloatArray:
        """The derivatives, (4, n, 3)."""
        return np.einsum("kna,ax->knx", self.matrix, self.net.reshape(-1, 3))


def _along(count: int, reverse: bool) -> FloatArray:
    t = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, count))
    return t[::-1] if reverse else t


def derivatives_across(surface: Surface, side: str, t: FloatArray, order: int, outward: bool) -> FloatArray:
    """Return derivatives 0 to ``order`` across a side at t along it, (order + 1, n, 3): out of the patch or into it."""
    k = SIDES.index(side)
    fixed = np.full_like(t, float(k % 2))
    s = surface.partials(*((fixed, t) if k < 2 else (t, fixed)), order)
    result = s[:, 0] if k < 2 else s[0]
    return result * _signs(k, order, outward)[:, None, None]


def _signs(k: int, order: int, outward: bool) -> FloatArray:
    forward = (k % 2 == 1) == outward
    return np.array([1.0 if forward else (-1.0) ** i for i in range(order + 1)])


def strip_of(surface: Surface, net: FloatArray, side: str, t: FloatArray, order: int, outward: bool) -> Strip:
    """Return the derivatives across a side at t along it, as they depend on a net (n, m, 3)."""
    k = SIDES.index(side)
    functions = (getattr(surface.rows, "functions"), surface.blend)  # noqa: B009 - a net's rows share some
    cross = functions[0 if k < 2 else 1].derivatives(float(k % 2), order) * _signs(k, order, outward)[:, None]
    along = functions[1 if k < 2 else 0].derivatives(t, 0)[0]
    form = "ki,nj->knij" if k < 2 else "kj,ni->knij"
    return Strip(np.einsum(form, cross, along).reshape(order + 1, len(t), -1), net, along)


def layers(surface: Surface, side: str) -> int:
    """Return the number of rows of control points parallel to a side."""
    return surface.rows.functions.size if SIDES.index(side) < 2 else surface.blend.size  # pyright: ignore


def match(
    first: Surface,
    first_side: str,
    second: Surface,
    second_side: str,
    handle: Handle,
    order: int,
    *,
    reverse: bool,
    ratio: float | None = None,
    other: Handle | None = None,
) -> Match:
    """Return the least change of the second patch's free coordinates that joins it to the first, to ``order`` 0 to 3.

    ``ratio`` is κ; without, the one of least change. With ``other``, the first patch's, both move.
    """
    net = handle.net(handle.values)
    t = _along(max(_POINTS, 2 * max(net.shape[:2])), False)
    linear = handle.map()
    solver = _solver(first, first_side, second, second_side, net, linear, order, reverse)
    strip = solver.strip
    kappa = (1.0 if order == 0 else _least(solver)) if ratio is None else ratio
    moved, free = solver.solve(kappa)
    exact = solver.exact(kappa, moved, free)
    if other is None:
        return Match(None, handle.values + moved, kappa, float(np.linalg.norm(moved)), exact)
    own = strip_of(first, other.net(other.values), first_side, t, order, outward=True)
    shift, exact = _both(own, strip, other.map(), linear, kappa, free, order)
    one, two = other.values + shift[: len(other.values)], handle.values + shift[len(other.values) :]
    return Match(one, two, kappa, float(np.linalg.norm(shift)), exact)


@dataclass(frozen=True)
class Condition:
    """A side that the patch to be moved is held to: a surface and its side, the own side, order, sense and ratio κ."""

    surface: Surface
    side: str
    own_side: str
    order: int
    reverse: bool
    ratio: float


def match_all(surface: Surface, handle: Handle, conditions: Sequence[Condition]) -> tuple[FloatArray, tuple[bool, ...]]:
    """Return the free coordinates, changed least, that meet all conditions at once, and which are met to rounding."""
    net, linear = handle.net(handle.values), handle.map()
    solvers = [
        _solver(one.surface, one.side, surface, one.own_side, net, linear, one.order, one.reverse) for one in conditions
    ]
    parts = [solver.system(one.ratio) for solver, one in zip(solvers, conditions, strict=True)]
    cut = linear.shape[1]
    more = np.cumsum([0, *(part[0].shape[1] - cut for part in parts)])
    whole = np.zeros((sum(len(right) for _, right in parts), cut + int(more[-1])))
    row = 0
    for (block, _), start, end in zip(parts, more, more[1:], strict=False):
        whole[row : row + len(block), :cut] = block[:, :cut]
        whole[row : row + len(block), cut + start : cut + end] = block[:, cut:]
        row += len(block)
    x = least_change(whole, np.concatenate([right for _, right in parts]), cut)
    free = np.split(x[cut:], more[1:-1])
    met = tuple(
        solver.exact(one.ratio, x[:cut], own) for solver, one, own in zip(solvers, conditions, free, strict=True)
    )
    return handle.values + x[:cut], met


def _solver(
    first: Surface,
    first_side: str,
    second: Surface,
    second_side: str,
    net: FloatArray,
    linear: FloatArray,
    order: int,
    reverse: bool,
) -> "_Solver":
    count = max(_POINTS, 2 * max(net.shape[:2]))
    target = derivatives_across(first, first_side, _along(count, False), order, outward=True)
    strip = strip_of(second, net, second_side, _along(count, reverse), order, outward=False)
    return _Solver(target, strip, linear, order, first.size, second.size)


class _Solver:
    """The conditions of a join for one pair of edges, to be solved for several ratios."""

    def __init__(
        self, target: FloatArray, strip: Strip, linear: FloatArray, order: int, first: float, second: float
    ) -> None:
        """Lay out the conditions on derivative k, in terms of the functions along the edge."""
        weights = _weights(target.shape[1])[::3, None]
        fit = np.linalg.pinv(strip.along * weights) * weights.T
        self.full, self.strip, self.order = target, strip, order
        self.target, self.now = fit @ target, fit @ strip.values
        self.left = [rows_of(fit @ strip.matrix[k], linear) for k in range(order + 1)]
        self.linear, self.size = linear, max(first, second)

    def solve(self, kappa: float) -> tuple[FloatArray, FloatArray]:
        """Return the change of the coordinates, and (μ, ν) as far as the order has them."""
        cut = self.left[0].shape[1]
        x = least_change(*self.system(kappa), cut)
        return x[:cut], x[cut:]

    def system(self, kappa: float) -> tuple[FloatArray, FloatArray]:
        """Return the matrix of the conditions, by the change of the coordinates, μ and ν, and their right side."""
        wanted, free = chained(self.target, kappa)
        count = max(self.order - 1, 0)
        blocks, right = list[FloatArray](), list[FloatArray]()
        for k in range(self.order + 1):
            extra = [-free[k][i].reshape(-1, 1) for i in range(count)]
            blocks.append(np.concatenate([self.left[k], *extra], axis=-1) / np.pi**k)
            right.append((wanted[k] - self.now[k]).ravel() / np.pi**k)
        return np.concatenate(blocks), np.concatenate(right)

    def exact(self, kappa: float, moved: FloatArray, free: FloatArray) -> bool:
        """Return whether the conditions are met along the whole edge, to rounding."""
        wanted, more = chained(self.full, kappa)
        found = self.strip.values + self.strip.matrix @ (self.linear @ moved).reshape(-1, 3)
        miss = [
            np.abs(found[k] - wanted[k] - sum(x * part for x, part in zip(free, more[k], strict=False))).max()
            / np.pi**k
            for k in range(self.order + 1)
        ]
        return bool(max(miss) <= _EXACT * self.size)


def chained(target: FloatArray, kappa: float) -> tuple[list[FloatArray], list[tuple[FloatArray, FloatArray]]]:
    """Return the wanted derivatives for μ = ν = 0, and what μ and ν each add to them."""
    none = np.zeros_like(target[0])
    padded = [*target, none, none, none][:4]
    wanted = [padded[k] * kappa**k for k in range(4)]
    return wanted, [(none, none), (none, none), (padded[1], none), (3.0 * kappa * padded[2], padded[1])]


def rows_of(matrix: FloatArray, linear: FloatArray) -> FloatArray:
    """Return the derivatives (n 3) by the free coordinates: the matrix (n, net) on each of x, y, z."""
    net = linear.reshape(matrix.shape[1], 3, -1)
    return np.einsum("na,axp->nxp", matrix, net).reshape(3 * len(matrix), -1)


def _weights(points: int) -> FloatArray:
    weights = np.ones((points, 3))
    weights[[0, -1]] = _ENDS
    return weights.ravel()


def least_change(a: FloatArray, b: FloatArray, count: int) -> FloatArray:
    """Return x that solves a x = b as well as possible with the least first ``count`` coordinates."""
    touched = (a != 0.0).any(axis=0)
    if not touched.all():
        x = np.zeros(a.shape[1])
        x[touched] = least_change(a[:, touched], b, int(touched[:count].sum()))
        return x
    scale = np.linalg.norm(a, axis=0)
    scale = np.where(scale > 0.0, np.where(np.arange(len(scale)) < count, 1.0, scale), 1.0)
    u, s, vt = np.linalg.svd(a / scale, full_matrices=len(a) < a.shape[1])
    rank = int((s > 1e-11 * s[0]).sum()) if len(s) and s[0] > 0.0 else 0
    x = vt[:rank].T @ ((u[:, :rank].T @ b) / s[:rank])
    null = vt[rank:].T
    if null.size:
        x = x - null @ np.linalg.lstsq(null[:count], x[:count], rcond=1e-11)[0]
    return x / scale


def _least(solver: _Solver) -> float:
    """Return the ratio of least change: the best of a range, refined by golden sections."""

    def cost(log: float) -> float:
        return float(np.linalg.norm(solver.solve(float(np.exp(log)))[0]))

    logs = np.log(_RATIOS)
    best = int(np.argmin([cost(float(x)) for x in logs]))
    low, high = float(logs[max(best - 1, 0)]), float(logs[min(best + 1, len(logs) - 1)])
    a, b = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
    left, right = cost(a), cost(b)
    for _ in range(_SECTIONS):
        if left <= right:
            high, b, right = b, a, left
            a = high - _GOLDEN * (high - low)
            left = cost(a)
        else:
            low, a, left = a, b, right
            b = low + _GOLDEN * (high - low)
            right = cost(b)
    return float(np.exp(0.5 * (low + high)))


def _both(
    own: Strip,
    strip: Strip,
    first: FloatArray,
    second: FloatArray,
    kappa: float,
    free: FloatArray,
    order: int,
) -> tuple[FloatArray, bool]:
    """Return the least change of both patches' coordinates that meets the conditions with given κ, μ and ν."""
    mu, nu = (*free.tolist(), 0.0, 0.0)[:2]
    m = own.matrix
    chain = [m[0]]
    if order > 0:
        chain.append(kappa * m[1])
    if order > 1:
        chain.append(kappa**2 * m[2] + mu * m[1])
    if order > 2:
        chain.append(kappa**3 * m[3] + 3.0 * kappa * mu * m[2] + nu * m[1])
    weights = _weights(m.shape[1])
    blocks, right = list[FloatArray](), list[FloatArray]()
    for k, mine in enumerate(chain):
        scale = weights / np.pi**k
        pair = [-rows_of(mine, first), rows_of(strip.matrix[k], second)]
        blocks.append(np.concatenate(pair, axis=-1) * scale[:, None])
        gap = mine @ own.net.reshape(-1, 3) - strip.values[k]
        right.append(gap.ravel() * scale)
    a, b = np.concatenate(blocks), np.concatenate(right)
    x = least_change(a, b, a.shape[1])
    miss = np.abs(a @ x - b).max()
    size = float(np.linalg.norm(np.ptp(own.net.reshape(-1, 3), axis=0)))
    return x, bool(miss <= _EXACT * size)
