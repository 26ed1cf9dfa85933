"""The fit itself: orthogonal distances made least, over the net and the shape parameters together.

Each round takes the feet of the points on the surface and makes the distances along their normals least, to first order
(Blake and Isard's tangent distances; Wang, Pottmann and Liu 2006). The net is solved for exactly at each step of the
shape parameters, which is Kaufman's (1975) form of Golub and Pereyra's variable projection.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.scan.nearest import Feet, Finder
from quintrig.shaping.fitting.equations import System, points_on, system_of
from quintrig.shaping.fitting.feet import Sheet
from quintrig.shaping.fitting.forms import Form
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.progress import Progress
from quintrig.support.scipy_inside import linalg_, optimize_, shortest, tree_of

_OUTLIER = 6.0
"""Standard deviations, by the median, beyond which a point of a scan counts no more."""


_LEAST_SLIDE = 1e-9
"""Of the weight of distances across the surface: that of sliding along it, where a fit is nearly there."""

_BROUGHT_BACK, _BEYOND, _ASTRAY = 3, 1.001, 1e3
"""How often a step is brought back onto the points, and from how many times the rms before it, at least and at most."""

_SEARCHES, _FOUND = 4, 1e-6
"""How often feet are looked for on all of the surface, and what share of the rms that must take off to go on."""

_TOLD = 0.1
"""Over the number of points: the share of the rms below which a change is lost in their noise."""

_EDGE = 101
"""Places along an edge from which the feet of border points are followed."""

_RIM = 0.03
"""Of a patch: points nearer to an edge may come to lie beyond it, where distances are no smooth function of the fit."""

_FINE = 1e-5
"""Of the size: noise of points below which they tell all of a surface, as exact ones do."""

_UNREACHED = 0.05
"""Of the size: as far beyond the border of a surface a point still draws it."""


@dataclass(frozen=True, eq=False)
class Data:
    """Points (n, 3), scaled, with weights (n,); ``border`` (n,) is true for those that belong on the edges.

    ``progress`` is told of the rounds of a fit.
    """

    points: FloatArray
    weights: FloatArray
    border: BoolArray
    robust: bool = True
    smooth: float = 0.0
    progress: Progress | None = None

    def chosen(self, most: int) -> NDArray[np.int64]:
        """Return the places of at most so many of the points, the same ones each time."""
        count = len(self.points)
        if count <= most:
            return np.arange(count)
        return np.sort(np.random.default_rng(0).permutation(count)[:most])

    def some(self, most: int) -> "Data":
        """Return at most so many of the points, the same ones each time."""
        if len(self.points) <= most:
            return self
        kept = self.chosen(most)
        return replace(self, points=self.points[kept], weights=self.weights[kept], border=self.border[kept])


@dataclass(frozen=True, eq=False)
class State:
    """Unknowns of the net, shape parameters, and the rms of the weighted distances that they leave."""

    q: FloatArray
    theta: FloatArray
    rms: float = np.inf


def begun(form: Form, data: Data, at: FloatArray) -> State:
    """Return the linear least-squares fit at given parameters (n, 2)."""
    theta = form.starts
    cells = np.array(form.grid)
    scaled = np.clip(at, 0.0, 1.0) * cells
    index = np.minimum(scaled.astype(int), cells - 1)
    local = scaled - index
    which = index[:, 0] * form.grid[1] + index[:, 1]
    if form.kind == "swung":
        return State(_swung_start(form, data, local), theta)
    zero = np.zeros(form.affine[0].shape[1])
    weight = data.weights[:, None, None] * np.eye(3)
    base = form.nets(zero)
    u, v = form.families(theta)
    away = data.points - points_on(base, which, u, v, local)
    made = system_of(form, zero, theta, which, local, weight, away, max(data.smooth, 1e-6), free=False)
    return State(_solved(made.net, made.to_net), theta)


def refined(
    form: Form, data: Data, state: State, free: bool, rounds: int, exact: float = 1e-5, but: int | None = None
) -> State:
    """Return the fit that distances cannot be made less from; ``free`` lets the shape parameters move, ``but`` one.

    Feet are followed from round to round, and looked for on all of the surface where that comes to rest.
    """
    here = _at(form, state, data)
    for _ in range(_SEARCHES):
        best, used = _descended(form, data, here, free, rounds, exact, but)
        rounds -= used
        if best is here:
            break
        here = _at(form, best.state, data)
        if rounds <= 0 or not here.rms < (1.0 - _FOUND) * best.rms:
            break
    return replace(here.state, rms=here.rms)


def _descended(
    form: Form, data: Data, here: "_Step", free: bool, rounds: int, exact: float, but: int | None
) -> tuple["_Step", int]:
    """Return the best step of so many rounds, and how many there were."""
    slide, stuck, number = 0.3, 0, 0
    exact = max(exact, _TOLD / len(data.points)) if data.robust else exact
    for number in range(rounds):
        if data.progress:
            data.progress(f"fitting {form.patches or 1} patch{'es' if form.patches > 1 else ''}", number, rounds)
        if stuck >= 4 or here.rms < 1e-13:
            return here, number
        there = _at(form, _stepped(form, here, data, slide, free, but), data, here)
        # The surface slid along itself, and a straight step leaves it by the square of that: it is brought back.
        for _ in range(_BROUGHT_BACK):
            if not _BEYOND * here.rms < there.rms < _ASTRAY * here.rms:
                break
            back = _at(form, _stepped(form, there, data, 10.0 * slide, free, but), data, there)
            if not back.rms < there.rms:
                break
            there = back
        if there.rms < here.rms:
            little = here.rms - there.rms < exact * here.rms
            stuck = stuck + 1 if little else 0
            here = _judged(there.state, there.feet, data)
            slide = max((0.01 if little else 0.2) * slide, _LEAST_SLIDE)
        else:
            slide = min(10.0 * slide, 10.0)
            stuck += 1
    return here, rounds


@dataclass(frozen=True, eq=False)
class _Step:
    """A state with the feet of the points on it, the weights of those that are trusted, and the rms that they leave.

    ``usual`` is the distance by which it is told which are trusted.
    """

    state: State
    feet: Feet
    weights: FloatArray
    rms: float
    usual: float


def _at(form: Form, state: State, data: Data, near: _Step | None = None) -> _Step:
    """Return a state with its feet, followed from those of a step near to it, and judged by its usual distance."""
    if near is None:
        return _judged(state, _feet(form, state, data), data)
    return _judged(state, _feet(form, state, data, near.feet), data, near.usual)


def _judged(state: State, feet: Feet, data: Data, usual: float | None = None) -> _Step:
    """Return a state without the trust in points far beyond what the others' distances let expect.

    Those count as if they were as far as their limit, so that nothing is gained by losing them.
    """
    gap = np.linalg.norm(feet.away, axis=1)
    own, weights, limit = ~data.border, data.weights, np.full(len(gap), np.inf)
    if data.robust and own.any():
        usual = 1.4826 * float(np.median(gap[own])) if usual is None else usual
        # What the surface does not reach yet is no outlier: it is to reach it.
        most = _OUTLIER * max(usual, 1e-9)
        limit[own] = np.where(feet.edge[own], max(_UNREACHED, most), most)
        far = gap > limit
        if far.sum() < 0.3 * own.sum():
            weights = np.where(far, 0.0, weights)
        else:
            limit = gap
    total = float(data.weights.sum())
    square = float((data.weights * np.minimum(gap, limit) ** 2).sum())
    return _Step(state, feet, weights, float(np.sqrt(square / total)) if total > 0.0 else np.inf, usual or 0.0)


def left_out(form: Form, data: Data, state: State) -> FloatArray:
    """Return the distances (n,) of the points that a fit does not trust."""
    here = _at(form, state, data)
    return np.linalg.norm(here.feet.away[(here.weights == 0.0) & (data.weights > 0.0)], axis=1)


def inner(form: Form, data: Data, state: State) -> Data:
    """Return the points that are no outliers and have their feet away from the edges, and all border points."""
    here = _at(form, state, data)
    at = Sheet(form, state.q, state.theta).together(here.feet.which, here.feet.u, here.feet.v)
    within = ((at > _RIM) & (at < np.array(form.grid) - _RIM)).all(axis=1)
    kept = (here.weights > 0.0) & (within | data.border)
    return replace(data, points=data.points[kept], weights=data.weights[kept], border=data.border[kept], robust=False)


def variance(form: Form, data: Data, state: State) -> float:
    """Return the variance of the weighted distances of points other than border points, never 0."""
    here = _at(form, state, data)
    own = (here.weights > 0.0) & ~data.border
    freedom = max(int(own.sum()) - len(state.q) - len(state.theta), 1)
    return max(float((here.weights * (here.feet.away**2).sum(axis=1))[own].sum()) / freedom, 1e-28)


def spread(form: Form, data: Data, state: State) -> tuple[FloatArray, FloatArray]:
    """Return the standard deviations of the shape parameters, and the residual's, from the last normal equations."""
    here = _at(form, state, data)
    feet, weights = here.feet, here.weights
    made = _made(form, here, data, 1e-4, free=True)
    count = int((weights > 0.0).sum())
    freedom = max(count - len(state.q) - len(state.theta), 1)
    variance = float((weights * (feet.away**2).sum(axis=1)).sum()) / freedom
    schur = made.shape - made.mixed.T @ _solved(made.net, made.mixed)
    values, vectors = np.linalg.eigh(0.5 * (schur + schur.T))
    tiny = 1e-12 * max(float(np.trace(made.shape)), 1e-300)
    covariance = (vectors / np.maximum(values, tiny)) @ vectors.T * variance
    return np.sqrt(np.maximum(np.diag(covariance), 0.0)), np.array(np.sqrt(variance))


def _feet(form: Form, state: State, data: Data, near: Feet | None = None) -> Feet:
    """Return the feet of the points, found anew or followed from where they were; of border points on the edges."""
    sheet = Sheet(form, state.q, state.theta)
    if near is None:
        near = Finder(form.surfaces(state.q, state.theta)).feet(data.points)
        if not data.border.any():
            return near
    at = sheet.together(near.which, near.u, near.v)
    low, high = np.zeros_like(at), np.broadcast_to(np.array(form.grid, dtype=np.float64), at.shape).copy()
    on = data.border
    if on.any():
        at[on], low[on], high[on] = _sides(form, sheet, data.points[on])
    at = sheet.followed(data.points, at, low, high)
    found = sheet.feet(data.points, at)
    return replace(found, edge=found.edge | on) if on.any() else found


def _sides(form: Form, sheet: Sheet, points: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return parameters (n, 2) on the outer edges near to points (n, 3), and the ends of the edge that they lie on."""
    nu, nv = form.grid
    ends = np.array([[[0, 0], [nu, 0]], [[0, nv], [nu, nv]], [[0, 0], [0, nv]], [[nu, 0], [nu, nv]]], dtype=np.float64)
    t = np.linspace(0.0, 1.0, _EDGE)[:, None]
    cloud = np.concatenate([(1.0 - t) * low + t * high for low, high in ends])
    nearest = np.asarray(tree_of(sheet.jet(cloud, 0)[0, 0]).query(points)[1])
    side = ends[nearest // _EDGE]
    return cloud[nearest], side[:, 0], side[:, 1]


def _made(form: Form, here: _Step, data: Data, slide: float, free: bool) -> System:
    state, feet, weights, rms = here.state, here.feet, here.weights, here.rms
    normal = feet.normal
    along = normal[:, :, None] * normal[:, None, :]
    # Where the distance is not along the normal, the foot may slide along the border alone.
    if feet.edge.any():
        beside = np.cross(normal[feet.edge], feet.away[feet.edge])
        beside /= np.maximum(np.linalg.norm(beside, axis=1, keepdims=True), 1e-300)
        along[feet.edge] = np.eye(3) - beside[:, :, None] * beside[:, None, :]
    weight = weights[:, None, None] * (slide * np.eye(3) + (1.0 - slide) * along)
    at = np.stack([feet.u, feet.v], axis=1)
    noise = float(np.mean(weights)) * rms**2 if data.robust and rms > _FINE else 0.0
    return system_of(form, state.q, state.theta, feet.which, at, weight, feet.away, data.smooth, free, noise)


def _stepped(form: Form, here: _Step, data: Data, slide: float, free: bool, but: int | None) -> State:
    """Return the state one step on; ``slide`` is how much points may not slide along the surface meanwhile."""
    state = here.state
    free = free and len(state.theta) > 0
    made = _made(form, here, data, slide, free)
    theta = state.theta
    shift = np.zeros(len(theta))
    low = np.array([one.low + (1e-6 if one.open[0] else 0.0) for one in form.ranges.values()])
    high = np.array([one.high - (1e-6 if one.open[1] else 0.0) for one in form.ranges.values()])
    if free:
        # The net's part of the equations is eliminated: what remains is in the shape parameters alone.
        schur = made.shape - made.mixed.T @ _solved(made.net, made.mixed)
        right = made.to_shape - made.mixed.T @ _solved(made.net, made.to_net)
        schur = schur + slide * np.diag(np.abs(np.diag(schur))) + 1e-9 * np.diag(np.diag(made.shape))
        lowest, highest = low - theta, high - theta
        if but is not None:
            lowest[but] = highest[but] = 0.0
        shift = _bounded(schur, right, lowest, highest, 0.5 * (high - low))
        shift = np.clip(shift, lowest, highest)
    net = _solved(made.net, made.to_net - made.mixed @ shift if free else made.to_net)
    return State(state.q + net, np.clip(theta + shift, low, high) if free else theta)


def _bounded(matrix: FloatArray, right: FloatArray, low: FloatArray, high: FloatArray, most: FloatArray) -> FloatArray:
    """Return the least of ½ xᵀ A x - bᵀ x between bounds, no step larger than ``most``."""
    scale = np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    values, vectors = np.linalg.eigh(matrix / np.outer(scale, scale))
    root = np.sqrt(np.maximum(values, 1e-12))[:, None] * vectors.T
    target = (vectors.T @ (right / scale)) / np.sqrt(np.maximum(values, 1e-12))
    least, greatest = np.maximum(low, -most), np.minimum(high, most)
    greatest = np.maximum(greatest, least + 1e-12)
    return np.asarray(optimize_.lsq_linear(root * scale, target, (least, greatest)).x)


def _solved(matrix: FloatArray, right: FloatArray) -> FloatArray:
    """Return the solution of symmetric equations, scaled, by Cholesky; of singular ones the shortest."""
    scale = 1.0 / np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    scaled = matrix * scale[:, None] * scale[None, :]
    wide = right if right.ndim == 2 else right[:, None]
    try:
        found = linalg_.cho_solve(linalg_.cho_factor(scaled + 1e-14 * np.eye(len(matrix))), wide * scale[:, None])
    except np.linalg.LinAlgError:
        found = shortest(scaled, wide * scale[:, None], rcond=1e-12)
    return (found * scale[:, None]).reshape(right.shape)


def _swung_start(form: Form, data: Data, at: FloatArray) -> FloatArray:
    """Return unknowns of a swung surface: radius and height along u, the direction along v."""
    u, v = form.families(form.starts)
    along, around = u.derivatives(at[:, 0], 0)[0], v.derivatives(at[:, 1], 0)[0]
    p = data.points
    radius = np.hypot(p[:, 0], p[:, 1])

    def least(matrix: FloatArray, values: FloatArray) -> FloatArray:
        tiny = 1e-6 * float(np.trace(matrix.T @ matrix)) / matrix.shape[1]
        found: Any = linalg_.solve(matrix.T @ matrix + tiny * np.eye(matrix.shape[1]), matrix.T @ values)
        return np.asarray(found)

    r, z = least(along, radius), least(along, p[:, 2])
    near = (along @ r)[:, None] * around
    return np.concatenate([r, z, least(near, p[:, 0]), least(near, p[:, 1])])
