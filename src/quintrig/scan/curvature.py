"""The curvature of measured points themselves, by osculating jets, with an error for each value."""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.quantities.classify import POINT_TYPES, SHAPE_BREAKS, SHAPE_CLASSES
from quintrig.quantities.table import quantity
from quintrig.scan import jets_jit
from quintrig.scan.deviation import Target, target_of
from quintrig.scan.nearest import in_threads
from quintrig.scan.orient import LINKS, planes, rim, sides
from quintrig.scan.scan import Scan, refuse_no_surface
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.display import Shown
from quintrig.support.progress import Progress
from quintrig.support.scipy_inside import tree_of

VALUES = ("gaussian", "mean", "k1", "k2", "shape_index", "curvedness")
"""Quantities of a scan that have an error."""

VECTORS = ("point", "normal", "direction1", "direction2")
CLASSES = ("point_type", "hk_type", "shape_class")
KEYS = (*VECTORS, *VALUES, *CLASSES)
"""Every quantity that points by themselves have."""

_TRIED = ((2, 18), (2, 30), (4, 36), (4, 64), (2, 64), (4, 128), (2, 128), (4, 250), (2, 250), (4, 400))
"""Degrees and numbers of neighbours, of which the one with the smallest errors is taken where none is given."""

_SAMPLE = 400
_BLOCK = 50_000  # points whose neighbours are held at a time
_HIGHEST, _MOST = 5, 500
_WIDE = 0.6 * np.pi
"""Radians without a neighbour from which a point lies on the border of a cloud."""

_CAREFUL = 1.5  # times what the higher degree says otherwise: it is not the truth either
_SURE = 2.0
"""Standard deviations of an error: about 95 % of the values are nearer to the truth."""


@dataclass(frozen=True, eq=False)
class ScanCurvature(Shown):
    """Curvatures at the points of a scan, ``values`` by the keys of the table of quantities, ``errors`` by those too.

    An error is about what 95 of 100 values are nearer to the truth than: from the scatter of the neighbours, and from
    what a polynomial of a higher degree would say. A class counts as zero what is below its error. ``border`` (n,) is
    true where neighbours lie on one side only. ``noise`` is the typical scatter, length¹; ``side`` says in words which
    way the normals point.
    """

    scan: Scan
    values: Mapping[str, NDArray[Any]]
    errors: Mapping[str, FloatArray]
    border: BoolArray
    degree: int
    neighbours: int
    radius: float
    noise: float
    side: str

    def __getitem__(self, key: str) -> NDArray[Any]:
        """Return the values of a quantity by key, or symbol as in the table; ValueError where scans have none such."""
        known = quantity(key).key
        if known not in self.values:
            raise ValueError(f"quantities: a scan has {', '.join(self.values)}, got {key!r}")
        return self.values[known]

    def __repr__(self) -> str:
        """Return one line: points, degree and neighbours."""
        points = len(self.scan.points)
        return f"<Curvature of {points:,} points: degree {self.degree}, {self.neighbours} neighbours>"


def scan_curvature(
    scan: Target,
    *,
    degree: int | None = None,
    neighbours: int | None = None,
    most: int | None = None,
    progress: Progress | None = None,
) -> ScanCurvature:
    """Return curvatures of a scan's points, by polynomials of ``degree`` over so many ``neighbours`` of each.

    Both are chosen where none are given, for the smallest errors on a sample: more neighbours the more the points
    scatter. With degree d values converge with the (d - 1)th power of the distance of the points (Cazals and Pouget
    2005). Of a scan with more than ``most`` points it is that of so many, spread evenly through it, among the
    neighbours that they have in all of it. Raises ValueError for fewer than 10 points in space, for points on one line,
    and for too few neighbours for the degree.
    """
    found = target_of(scan)
    if found.points.shape[1] != 3:
        raise ValueError("points: expected points in space for curvature, three numbers each, found two")
    if len(found.points) < 10:
        raise ValueError(f"points: expected at least 10 in space for curvature, found {len(found.points)}")
    refuse_no_surface(found.points)
    if degree is not None and not 2 <= degree <= _HIGHEST:
        raise ValueError(f"degree: expected 2 to {_HIGHEST}, got {degree}")
    fewest = 1 if degree is None else _needed(degree)
    if neighbours is not None and not max(fewest, 6) <= neighbours <= _MOST:
        raise ValueError(f"neighbours: expected {max(fewest, 6)} to {_MOST} for degree {degree or 2}, got {neighbours}")
    tree = _tree(found.points)
    degree, neighbours = _chosen(found, tree, degree, neighbours)
    count = len(found.points)
    at = np.arange(count) if most is None or count <= most else np.linspace(0, count - 1, most).astype(np.int64)
    raw, near = _in_blocks(found.points, at, tree, min(neighbours, count), degree, progress)
    on = rim(found)
    if len(at) < count:
        near = _near(_tree(found.points[at]), found.points[at], LINKS + 1)
    turn, words = sides(found, raw.frames[:, 2], near, at)
    border = raw.gap > _WIDE if on is None else on[at] | (raw.gap > np.pi)
    shown = found if len(at) == count else found.within(at)
    return _told(shown, raw, near, turn, words, border, degree, neighbours)


def _in_blocks(
    points: FloatArray,
    at: NDArray[np.int64],
    tree: Any,
    neighbours: int,
    degree: int,
    progress: Progress | None,
) -> tuple["_Raw", NDArray[np.int64]]:
    """Return the fits at the points numbered ``at``, and their nearest neighbours; a block at a time, for memory."""
    parts: list[_Raw] = []
    links: list[NDArray[np.int64]] = []
    for start in range(0, len(at), _BLOCK):
        block = at[start : start + _BLOCK]
        near = _near(tree, points[block], neighbours)
        parts.append(_widened(points, block, tree, near, degree))
        links.append(near[:, : LINKS + 1].copy())
        if progress is not None and len(at) > _BLOCK:
            progress("points with their curvature", start + len(block), len(at))
    if len(parts) == 1:
        return parts[0], links[0]
    names = [one.name for one in fields(_Raw)]
    return _Raw(**{name: np.concatenate([getattr(part, name) for part in parts]) for name in names}), np.concatenate(
        links
    )


def _widened(points: FloatArray, at: NDArray[np.int64], tree: Any, near: NDArray[np.int64], degree: int) -> "_Raw":
    """Return fits, over more neighbours where those lie on few lines, as in a corner of a grid."""
    raw = _fitted(points, at, near, degree)
    for times in (2, 4, 8):
        bad = np.flatnonzero(~np.isfinite(raw.check).all(axis=1))
        if not len(bad):
            break
        more = min(times * near.shape[1], len(points))
        again = _fitted(points, at[bad], _near(tree, points[at[bad]], more), degree)
        for name in ("frames", "values", "check", "covariance", "residual", "gap"):
            getattr(raw, name)[bad] = getattr(again, name)
    return raw


@dataclass(frozen=True, eq=False)
class _Raw:
    frames: FloatArray
    values: FloatArray
    check: FloatArray
    covariance: FloatArray
    residual: FloatArray
    gap: FloatArray
    reach: FloatArray


def _needed(degree: int) -> int:
    """Return the fewest neighbours for a degree, so that a higher one can check it."""
    upper = _upper(degree)
    return (upper + 1) * (upper + 2) // 2 + 1


def _upper(degree: int) -> int:
    """Return the degree that checks another: the next even one, as odd terms say nothing of second derivatives."""
    return degree + 2 - degree % 2


def _tree(points: FloatArray) -> Any:
    return tree_of(points)


def _near(tree: Any, at: FloatArray, count: int) -> NDArray[np.int64]:
    return np.ascontiguousarray(tree.query(at, k=count, workers=-1)[1], dtype=np.int64)


def _fitted(points: FloatArray, chosen: NDArray[Any], near: NDArray[np.int64], degree: int) -> _Raw:
    at = np.ascontiguousarray(points[chosen])
    n = len(at)
    frames = planes(points, near)
    values, check = np.empty((n, 5)), np.empty((n, 5))
    covariance, residual, gap = np.empty((n, 5, 5)), np.empty(n), np.empty(n)

    def work(part: slice) -> None:
        arrays = (values, check, covariance, residual, gap)
        jets_jit.jets(
            points, at[part], near[part], frames[part], degree, _upper(degree), *(one[part] for one in arrays)
        )

    in_threads(work, n, 2000)
    reach = np.linalg.norm(points[near[:, -1]] - at, axis=1)
    return _Raw(frames, values, check, covariance, residual, gap, reach)


def _chosen(scan: Scan, tree: Any, degree: int | None, neighbours: int | None) -> tuple[int, int]:
    """Return degree and number of neighbours: those given, else those with the smallest errors on a sample."""
    if degree is not None and neighbours is not None:
        return degree, neighbours
    points = scan.points
    sample = np.linspace(0, len(points) - 1, min(len(points), _SAMPLE)).astype(int)
    best, least = (degree or 2, neighbours or max(12, _needed(degree or 2))), np.inf
    for d, k in _TRIED:
        d, k = degree or d, neighbours or k  # noqa: PLW2901
        if not _needed(d) <= k <= len(points):
            continue
        raw = _fitted(points, sample, _near(tree, points[sample], k), d)
        inner = raw.gap < _WIDE
        off = _forms(raw)[2][inner if inner.any() else slice(None)]
        # The root mean square of the errors, without a few that are far off: their median alone is blind to what the
        # sample does not resolve in places.
        off = np.sort(off[np.isfinite(off)])
        mean = float(np.sqrt(np.mean(off[: max(1, int(0.98 * len(off)))] ** 2))) if len(off) else np.inf
        mean = mean if np.isfinite(raw.check).all(axis=1).mean() > 0.98 else np.inf
        if mean < least:
            best, least = (d, k), mean
    return best


def _around(gap: FloatArray, near: NDArray[np.int64], border: BoolArray) -> FloatArray:
    """Return the root mean square of gaps (n,) over neighbours: at one point alone noise may hide what is missed."""
    with np.errstate(over="ignore"):
        square = gap**2
    finite = np.isfinite(square[near])
    mean = np.where(finite, square[near], 0.0).sum(axis=1) / np.maximum(finite.sum(axis=1), 1)
    return np.sqrt(np.where(border, np.maximum(mean, square), np.where(np.isfinite(gap), mean, np.nan)))


def _forms(
    raw: _Raw, around: tuple[NDArray[np.int64], BoolArray] | None = None
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the second form (n, 3) in an orthonormal frame of the tangent plane, that of the check, and its error."""
    one, other = _form(raw.values), _form(raw.check)
    spread = np.sqrt(np.maximum(raw.covariance[:, 2, 2] + 2.0 * raw.covariance[:, 3, 3] + raw.covariance[:, 4, 4], 0.0))
    gap = other - one
    jump = np.sqrt(gap[:, 0] ** 2 + 2.0 * gap[:, 1] ** 2 + gap[:, 2] ** 2)
    jump = jump if around is None else _around(jump, *around)
    return one, other, np.hypot(_SURE * raw.residual * spread, _CAREFUL * jump)


def _form(d: FloatArray) -> FloatArray:
    """Return a, b, c of the second form in the frame along e1 + z_x n, from derivatives of the height (n, 5)."""
    p, q, r, s, t = d.T
    e, f, w = 1.0 + p * p, p * q, np.sqrt(1.0 + p * p + q * q)
    ratio = f / e
    el, em, en = r / w, s / w, t / w
    along = np.sqrt(e)
    across = w / along  # the length of what is left of e2 + z_y n
    a = el / e
    b = (em - ratio * el) / (along * across)
    c = (en - 2.0 * ratio * em + ratio * ratio * el) / (across * across)
    return np.stack([a, b, c], axis=1)


def _quantities(form: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    a, b, c = form.T
    return a * c - b * b, 0.5 * (a + c), np.hypot(0.5 * (a - c), b)


def _told(
    scan: Scan,
    raw: _Raw,
    near: NDArray[np.int64],
    turn: FloatArray,
    words: str,
    border: BoolArray,
    degree: int,
    neighbours: int,
) -> ScanCurvature:
    form, other, off = _forms(raw, (near, border))
    form, other = form * turn[:, None], other * turn[:, None]
    gaussian, mean, radius = _quantities(form)
    k_check, h_check, r_check = _quantities(other)
    k1, k2 = mean + radius, mean - radius
    curved = np.hypot(mean, radius)
    with np.errstate(invalid="ignore", divide="ignore"):
        index = np.where(curved > 0.0, -2.0 / np.pi * np.arctan2(mean, radius), np.nan)
        # First-order propagation of the covariance of z_xx, z_xy, z_yy; the slopes' part is smaller by the square.
        a, b, c = form.T
        second = raw.covariance[:, 2:, 2:] * raw.residual[:, None, None] ** 2
        h_std = 0.5 * np.sqrt(np.maximum(second[:, 0, 0] + 2.0 * second[:, 0, 2] + second[:, 2, 2], 0.0))
        slope = np.stack([c, -2.0 * b, a], axis=1)
        k_std = np.sqrt(np.maximum(np.einsum("ni,nij,nj->n", slope, second, slope), 0.0))
        trace = np.sqrt(np.maximum(second[:, 0, 0] + 2.0 * second[:, 1, 1] + second[:, 2, 2], 0.0))
        # Two factors that are both off: what the first order leaves out.
        errors = {
            "gaussian": np.hypot(_SURE * k_std, _CAREFUL * _around(k_check - gaussian, near, border))
            + (_SURE * trace) ** 2,
            "mean": np.hypot(_SURE * h_std, _CAREFUL * _around(h_check - mean, near, border)),
            "k1": np.hypot(_SURE * trace, _CAREFUL * _around(h_check + r_check - k1, near, border)),
            "k2": np.hypot(_SURE * trace, _CAREFUL * _around(h_check - r_check - k2, near, border)),
            "shape_index": np.minimum(2.0, 2.0 / np.pi * off / curved),
            "curvedness": off,
        }
    e1, e2, n = (raw.frames[:, k] for k in range(3))
    p, q = raw.values[:, :1], raw.values[:, 1:2]
    normal = n - p * e1 - q * e2
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    first = e1 + p * n
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second_axis = np.cross(normal, first)
    angle = 0.5 * np.arctan2(2.0 * form[:, 1], form[:, 0] - form[:, 2])[:, None]
    d1 = np.cos(angle) * first + np.sin(angle) * second_axis
    umbilic = radius <= off
    d2 = np.cross(normal * turn[:, None], d1)
    values: dict[str, NDArray[Any]] = {
        "point": scan.points,
        "normal": normal * turn[:, None],
        "direction1": np.where(umbilic[:, None], np.nan, d1),
        "direction2": np.where(umbilic[:, None], np.nan, d2),
        "gaussian": gaussian,
        "mean": mean,
        "k1": k1,
        "k2": k2,
        "shape_index": np.where(curved > off, index, np.nan),
        "curvedness": curved,
    }
    values |= _classes(gaussian, mean, radius, curved, index, errors, off)
    noise = float(np.nanmedian(raw.residual)) if np.isfinite(raw.residual).any() else float("nan")
    return ScanCurvature(scan, values, errors, border, degree, neighbours, float(np.median(raw.reach)), noise, words)


def _classes(
    gaussian: FloatArray,
    mean: FloatArray,
    radius: FloatArray,
    curved: FloatArray,
    index: FloatArray,
    errors: Mapping[str, FloatArray],
    off: FloatArray,
) -> dict[str, NDArray[Any]]:
    """Return the codes of the classes, with what is below its error counted as zero."""
    finite = np.isfinite(curved) & np.isfinite(off)
    flat = curved <= off
    k_sign = np.where(np.abs(gaussian) <= errors["gaussian"], 0, np.sign(gaussian))
    h_sign = np.where(np.abs(mean) <= errors["mean"], 0, np.sign(mean))
    hk = np.where(flat, 5, 1 + 3 * (1 + h_sign) + (1 - k_sign))
    hk = np.where(hk == 4, 5, hk)  # K > 0 with H = 0 is not possible, so both are as good as zero
    kind = np.where(gaussian > 0.0, np.where(radius <= off, POINT_TYPES.index("umbilic"), 1), 2)
    kind = np.where(k_sign == 0, 3, kind)
    kind = np.where(flat, 4, kind)
    ends = np.array([-b for b in SHAPE_BREAKS[::-1]] + list(SHAPE_BREAKS))
    shape = np.where(flat, len(SHAPE_CLASSES) - 1, 1 + np.searchsorted(ends, np.nan_to_num(index)))
    return {
        name: np.where(finite, codes, 0).astype(np.int8)
        for name, codes in (("point_type", kind), ("hk_type", hk), ("shape_class", shape))
    }
