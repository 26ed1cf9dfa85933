"""Curves through points in the plane or in space, by orthogonal distances; aerofoils as an upper and a lower one."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from quintrig.basis.formulas import Parameter
from quintrig.basis.functions import Functions
from quintrig.basis.pairs import families, parameters
from quintrig.basis.registry import entry
from quintrig.model.model import Model
from quintrig.scan.deviation import Deviation
from quintrig.scan.scan import Scan
from quintrig.shaping.fitting.forms import USUAL
from quintrig.shaping.fitting.intervals import profile, told
from quintrig.shaping.fitting.result import Fit, ShapeValue
from quintrig.support.arrays import BoolArray, FloatArray, frozen
from quintrig.support.scipy_inside import linalg_, shortest, tree_of

_Found = tuple[FloatArray, FloatArray]
"""Net and shape parameters of a fit."""

_MORE = 60  # rounds of a fit that begins from one near
_FINE = 401  # parameters at which the nearest place is looked for
_ROUNDS, _SETTLED = 150, 12  # rounds at most, and those before the shape parameters move
_WANDERING = 30.0  # sizes: a way through the points longer than this does not follow a curve


def fit_curve(
    scan: Scan,
    basis: str | Sequence[str],
    shape: str | Sequence[float],
    size: int | None,
    tolerance: float | None,
    robust: bool,
    name: str,
) -> Fit:
    """Return a model of a curve near points (n, 2 or 3), from the first to the last; ValueError for too few.

    Points that wander to and fro are put in the order of their longest extent first. Of an aerofoil, points in the
    plane from a trailing edge around and back to it, or two rows of them, there are two curves that meet in front.
    """
    if not isinstance(basis, str):
        raise ValueError(f"basis: expected one name for a curve, found {len(list(basis))}")  # noqa: TRY004
    choice = entry(basis)
    count = size or (USUAL if USUAL in choice.sizes else choice.usual)
    ranges = parameters(choice, count)
    free = shape == "free"
    start = np.array([float(one.start or 0.0) for one in ranges])
    if not isinstance(shape, str):
        start = frozen(list(shape), "shape", (len(ranges),))
    elif shape not in ("fixed", "free"):
        raise ValueError(f"shape: expected fixed, free or numbers, got {shape!r}")

    def functions(theta: FloatArray) -> Functions:
        return families((choice,), (count,), ("size",), theta.tolist() if len(theta) else None, False)[0]

    runs = _runs(scan)
    tables: list[dict[str, Any]] = []
    parts: list[Deviation] = []
    kept: list[BoolArray] = []
    values: list[ShapeValue] = []
    for label, points, held in runs:
        if len(points) < 3 or not float(np.ptp(points, axis=0).max()) > 0.0:
            raise ValueError(f"points: expected at least 3 points apart for a curve, found {len(points)}")
        net, theta, t, inside, off = _fitted(points, functions, start, ranges if free else (), held, robust)
        tables.append(
            {
                "kind": "curve",
                "name": label,
                "points": net.tolist(),
                **({"basis": basis} if basis != "trigonometric" else {}),
                **({"shape": theta.tolist()} if len(theta) else {}),
            }
        )
        parts.append(_measured(points, functions(theta), net, t, label, scan.unit, tolerance))
        kept.append(inside)
        if free:
            prefix = "" if len(runs) == 1 else f"{label} "
            values += _intervals(points, functions, (net, theta), inside, off, ranges, held, prefix)
    header: dict[str, Any] = {"name": name} | ({"unit": scan.unit} if scan.unit else {})
    if len(tables) == 1:
        tables[0].pop("name")
        model = Model.from_dict(header | tables[0])
    else:
        model = Model.from_dict(header | {"patch": tables})
    return Fit(model, "curve", _joined(parts), np.concatenate(kept), tuple(values), tolerance, {}, scan.notes)


def _intervals(
    points: FloatArray,
    functions: Any,
    found: _Found,
    kept: BoolArray,
    off: FloatArray,
    ranges: Sequence[Parameter],
    held: tuple[bool, bool],
    prefix: str,
) -> list[ShapeValue]:
    """Return the shape parameters of a fit, net and shape, with their intervals, by fits anew at other values."""
    points = points[kept]
    net, theta = found
    family = functions(theta)
    gap = points - family.derivatives(_nearest(points, family, net), 0)[0] @ net
    square = float((gap**2).sum())
    freedom = max(len(points) * (points.shape[1] - 1) - net.size - len(theta), 1)
    variance = max(square / freedom, 1e-30 * float(np.ptp(points, axis=0).max()) ** 2)
    profiles: list[tuple[FloatArray, FloatArray]] = []
    for k, one in enumerate(ranges):

        def fitted(wanted: float, near: _Found, k: int = k) -> tuple[float, _Found]:
            shape = near[1].copy()
            shape[k] = wanted
            own, shape, t, _, _ = _fitted(points, functions, shape, ranges, held, False, k, near[0])
            rest = points - functions(shape).derivatives(t, 0)[0] @ own
            return (float((rest**2).sum()) - square) / variance, (own, shape)

        values, grown, _ = profile(one, float(theta[k]), float(off[k]), fitted, found)
        profiles.append((values, grown))
    slack = max(0.0, -min(float(grown.min()) for _, grown in profiles))
    return [
        told(prefix + one.name, one, value, std, values, grown, slack)
        for one, value, std, (values, grown) in zip(ranges, theta.tolist(), off.tolist(), profiles, strict=True)
    ]


def _runs(scan: Scan) -> list[tuple[str, FloatArray, tuple[bool, bool]]]:
    """Return each curve's name, its points in turn, and which ends are held."""
    points = np.asarray(scan.points)
    if points.shape[1] == 2 and scan.outline:
        # Lednicer's files say first how many points the two rows have, each from the nose to the tail.
        x = points[:, 0]
        jump = int(np.argmin(np.diff(x))) + 1 if (np.diff(x) < -0.5 * np.ptp(x)).sum() == 1 else 0
        if jump and x[0] < x.min() + 0.1 * np.ptp(x):
            upper, lower = points[:jump], points[jump:]
        else:
            nose = int(np.argmin(x))
            upper, lower = points[nose::-1], points[nose:]
        return [("upper", upper, (True, True)), ("lower", lower, (True, True))]
    steps = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    if steps > _WANDERING * max(scan.size, 1e-300):
        centred = points - points.mean(axis=0)
        _, axes = np.linalg.eigh(centred.T @ centred)
        points = points[np.argsort(centred @ axes[:, -1], kind="stable")]
    return [("curve", points, (False, False))]


def _fitted(
    points: FloatArray,
    functions: Any,
    theta: FloatArray,
    free: Sequence[Any],
    held: tuple[bool, bool],
    robust: bool,
    but: int | None = None,
    begun: FloatArray | None = None,
) -> tuple[FloatArray, FloatArray, FloatArray, BoolArray, FloatArray]:
    """Return net, shape parameters, parameters of the points, which count, and the shape's standard deviations.

    Of the ``free`` shape parameters the one ``but`` stays where it is; the net is ``begun`` with if given.
    """
    n, dimension = points.shape
    moves = functions(theta).partition
    centre, scale = (points.mean(axis=0) if moves else np.zeros(dimension)), float(np.linalg.norm(np.ptp(points, 0)))
    p = (points - centre) / scale
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))])
    t = length / length[-1]
    ends = {0: p[0]} if held[0] else {}
    ends |= {functions(theta).size - 1: p[-1]} if held[1] else {}
    kept = np.ones(n, dtype=np.bool_)
    weight = np.tile(np.eye(dimension), (n, 1, 1))
    if begun is None:
        net = _net(p, functions(theta).derivatives(t, 0)[0], weight, np.zeros((functions(theta).size, dimension)), ends)
    else:
        net = (begun - centre) / scale
    settled, rounds = (_SETTLED, _ROUNDS) if begun is None else (0, _MORE)
    best, least, slide = (net, theta), np.inf, 0.3
    stuck = 0
    off = np.zeros(len(theta))
    for k in range(rounds):
        family = functions(theta)
        t = _nearest(p, family, net)
        d = family.derivatives(t, 1)
        gap = p - d[0] @ net
        size = np.linalg.norm(gap, axis=1)
        if robust and n > 20:
            kept = size <= 6.0 * max(1.4826 * float(np.median(size)), 1e-9)
            kept = kept if kept.mean() > 0.7 else np.ones(n, dtype=np.bool_)
        rms = float(np.sqrt(np.mean(size[kept] ** 2)))
        if rms < 1e-14:
            best = (net, theta)
            break
        if rms < least * (1.0 - 1e-7):
            best, least, slide, stuck = (net, theta), rms, max(0.3 * slide, 1e-4), 0
        else:
            (net, theta), slide, stuck = best, min(10.0 * slide, 10.0), stuck + 1
            if stuck > 6:
                break
            t = _nearest(p, functions(theta), net)
            d = functions(theta).derivatives(t, 1)
            gap = p - d[0] @ net
        along = d[1] @ net
        along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-300)
        inner = ((t > 0.0) & (t < 1.0) & kept)[:, None, None]
        weight = np.eye(dimension) - np.where(inner, (1.0 - slide) * along[:, :, None] * along[:, None, :], 0.0)
        weight = weight * kept[:, None, None]
        shift, off = _shape_step(gap, d[0], weight, functions, theta, t, net, free if k >= settled else (), slide, but)
        theta = theta + shift
        net = net + _net(
            gap - _change(functions, theta - shift, theta, t, net), d[0], weight, net * 0.0, dict.fromkeys(ends)
        )
    net, theta = best
    t = _nearest(p, functions(theta), net)
    return net * scale + centre, theta, t, kept, off


def _change(functions: Any, before: FloatArray, after: FloatArray, t: FloatArray, net: FloatArray) -> FloatArray:
    if np.array_equal(before, after):
        return np.zeros((len(t), net.shape[1]))
    found: FloatArray = (functions(after).derivatives(t, 0)[0] - functions(before).derivatives(t, 0)[0]) @ net
    return found


def _net(gap: FloatArray, f: FloatArray, weight: FloatArray, base: FloatArray, ends: dict[int, Any]) -> FloatArray:
    """Return the net (k, d) that least squares want, with the points at ``ends`` held where they are given."""
    k, d = f.shape[1], gap.shape[1]
    result = base.copy()
    for index, place in ends.items():
        if place is not None:
            result[index] = place
    right = gap - f @ result
    matrix = np.einsum("ni,nxy,nj->ixjy", f, weight, f, optimize=True)
    free = [i for i in range(k) if i not in ends]
    matrix = matrix[free][:, :, free].reshape(len(free) * d, -1)
    wanted = np.einsum("ni,nxy,ny->ix", f, weight, right, optimize=True)[free].ravel()
    tiny = 1e-11 * float(np.trace(matrix)) / max(len(matrix), 1)
    step: FloatArray = linalg_.solve(matrix + tiny * np.eye(len(matrix)), wanted)
    result[free] += step.reshape(len(free), d)
    return result


def _shape_step(
    gap: FloatArray,
    f: FloatArray,
    weight: FloatArray,
    functions: Any,
    theta: FloatArray,
    t: FloatArray,
    net: FloatArray,
    free: Sequence[Any],
    slide: float,
    but: int | None,
) -> tuple[FloatArray, FloatArray]:
    """Return the step of the shape parameters with the net eliminated, within their ranges, and their deviations."""
    if not free:
        return np.zeros(len(theta)), np.zeros(len(theta))
    columns: list[FloatArray] = []
    for k, one in enumerate(free):
        step = 1e-3 * (one.high - one.low)
        if k == but:
            columns.append(np.zeros_like(gap))
            continue
        low, high = theta.copy(), theta.copy()
        low[k], high[k] = max(theta[k] - step, one.low + 1e-9), min(theta[k] + step, one.high - 1e-9)
        columns.append(_change(functions, low, high, t, net) / (high[k] - low[k]))
    rows = np.linalg.cholesky(weight + 1e-12 * np.eye(weight.shape[1])).transpose(0, 2, 1)
    big = np.einsum("nxy,ni->nxiy", rows, f).reshape(-1, f.shape[1] * gap.shape[1])
    moved = np.stack([np.einsum("nxy,ny->nx", rows, one).ravel() for one in columns], axis=1)
    left = np.einsum("nxy,ny->nx", rows, gap).ravel()
    q, _ = np.linalg.qr(big)
    moved = moved - q @ (q.T @ moved)
    left = left - q @ (q.T @ left)
    matrix = moved.T @ moved + 1e-12 * np.eye(len(theta))
    shift = shortest(matrix + slide * np.diag(np.diag(matrix)), moved.T @ left, rcond=1e-10)
    low, high = (np.array([getattr(one, end) for one in free]) for end in ("low", "high"))
    shift = np.clip(shift, -0.3 * (high - low), 0.3 * (high - low))
    variance = float((gap**2).sum()) / max(len(gap) - f.shape[1] - len(theta), 1)
    return np.clip(theta + shift, low, high) - theta, np.sqrt(np.diag(np.linalg.pinv(matrix)) * variance)


def _nearest(points: FloatArray, family: Functions, net: FloatArray) -> FloatArray:
    """Return the parameters (n,) of the nearest points of a curve: of a fine polygon, then Newton's steps."""
    s = np.linspace(0.0, 1.0, _FINE)
    t = s[np.asarray(tree_of(family.derivatives(s, 0)[0] @ net).query(points)[1])]
    low, high = np.maximum(t - 1.0 / (_FINE - 1), 0.0), np.minimum(t + 1.0 / (_FINE - 1), 1.0)
    for _ in range(8):
        d = family.derivatives(t, 2)
        r, first, second = d[0] @ net - points, d[1] @ net, d[2] @ net
        slope = np.einsum("nx,nx->n", r, first)
        bend = np.einsum("nx,nx->n", first, first)
        full = bend + np.einsum("nx,nx->n", r, second)
        t = np.clip(t - slope / np.maximum(np.where(full > 0.1 * bend, full, bend), 1e-300), low, high)
    return t


def _measured(
    points: FloatArray, family: Functions, net: FloatArray, t: FloatArray, name: str, unit: str, tolerance: float | None
) -> Deviation:
    """Return distances from a curve; in the plane positive to its left, in space without a sign."""
    d = family.derivatives(t, 1)
    foot, along = d[0] @ net, d[1] @ net
    away = points - foot
    distance = np.linalg.norm(away, axis=1)
    if points.shape[1] == 2:
        side = along[:, 0] * away[:, 1] - along[:, 1] * away[:, 0]
        distance = np.where(side < 0.0, -1.0, 1.0) * distance
    edge = (t <= 0.0) | (t >= 1.0)
    zero = np.zeros(len(points))
    which = np.zeros(len(points), dtype=np.int64)
    return Deviation(points, distance, foot, which, t, zero, edge, (), (name,), unit, tolerance)


def _joined(parts: Sequence[Deviation]) -> Deviation:
    """Return the deviations of several curves as one."""
    if len(parts) == 1:
        return parts[0]

    def of(name: str) -> Any:
        return np.concatenate([getattr(one, name) for one in parts])

    which = np.repeat(np.arange(len(parts)), [len(one) for one in parts])
    names = tuple(one.names[0] for one in parts)
    arrays = {name: of(name) for name in ("points", "distance", "foot", "u", "v", "edge")}
    return replace(parts[0], **arrays, patch=which, names=names)
