"""``quintrig.fit``: a surface or a curve through measured points, by least orthogonal distances."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from quintrig.geometry.curve import Curve
from quintrig.model.model import Model
from quintrig.scan.deviation import Deviation, Target, deviation, target_of
from quintrig.scan.nearest import Finder
from quintrig.scan.scan import Scan, refuse_no_surface
from quintrig.shaping.fitting import curves, solve
from quintrig.shaping.fitting.corners import corners_of, halfway, on_sides, ways_between
from quintrig.shaping.fitting.forms import KINDS, Form, form_of
from quintrig.shaping.fitting.intervals import intervals
from quintrig.shaping.fitting.mirror import mirror_of
from quintrig.shaping.fitting.primitives import PRIMITIVES, fit_primitive
from quintrig.shaping.fitting.result import Fit, ShapeValue
from quintrig.shaping.fitting.start import border, parametrisations
from quintrig.support.arrays import BoolArray, FloatArray, frozen, number
from quintrig.support.errors import nearest
from quintrig.support.progress import Progress, watched
from quintrig.support.scipy_inside import tree_of

ALL_KINDS = (*KINDS, *PRIMITIVES, "curve")
"""Every kind that can be fitted."""

HELD = ("tensor", "symmetric", "swept", "ruled")
"""Kinds that can be held at their corners."""

_GRIDS = ((1, 1), (2, 2), (3, 3), (4, 4), (6, 6), (8, 8))
"""Grids of patches that are tried in turn where a tolerance is asked for."""

_FIRST, _MAIN, _LAST = 600, 6000, 200_000
"""Points by which the start is chosen, by which it is refined, and at the end."""

_CLOSE, _WORSE = 1.05, 3.0
"""Times the rms of the best way to begin, between which the second is followed too: nearer it is as good."""

_FEW_OUTLIERS, _NEAR_OUTLIERS = 0.02, 0.01
"""Of the points, and of the size: with so few and so near it is tried whether they can be met after all."""

_DRAWN = 0.01  # weight of a border point's distance from the edge, beside that from the surface
_ON_CURVE = 200  # points of a given edge

_BETTER_FITS = 2  # times that profiles are taken, anew where they find a fit that is better by far
_PROFILE = 1500  # points by which it is tried how far a shape parameter may go


@watched
def fit(
    target: Target,
    kind: str = "tensor",
    *,
    basis: str | Sequence[str] = "trigonometric",
    shape: Literal["fixed", "free"] | Sequence[float] = "fixed",
    size: tuple[int, int] | None = None,
    patches: tuple[int, int] | None = None,
    join: Literal["G1", "G2"] = "G2",
    boundary: Literal["free", "curves"] | Sequence[Curve] = "free",
    smooth: float = 0.0,
    tolerance: float | None = None,
    robust: bool | None = None,
    mirror: ArrayLike | None = None,
    corners: ArrayLike | None = None,
    weights: ArrayLike | None = None,
    unit: str = "",
    name: str = "fit",
    progress: Progress | None = None,
) -> Fit:
    """Return a model of this kind whose surface is nearest to points in the sense of least squares.

    ``target`` is what ``deviation`` takes. ``kind`` is tensor, symmetric, swept, swung, ruled, plane, sphere, cylinder,
    cone, torus or curve. ``shape`` fixes the shape parameters of the ``basis`` where it starts, frees them, or gives
    their values; ``size`` is the number of control points each way. ``patches`` (n, m) are joined with G1 or G2;
    without them a ``tolerance``, length¹, may take as many as 8 x 8. ``boundary`` "curves" draws the edges to the
    border of the points, curves hold them there. ``smooth`` weighs thin-plate energy against the distances. Points
    farther than 6 standard deviations do not count where ``robust``, as it is for scans. ``mirror`` (a, b, c, d) is the
    plane of a symmetric surface, found where none is given. ``corners`` (4, 3), length¹ in the unit of the points, are
    passed through exactly, in turn at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1). ``progress`` is told of the rounds of a
    fit of a surface.
    Raises ValueError, ModelError or QuintrigError in one line.
    """
    if kind not in ALL_KINDS:
        raise ValueError(f"kind: expected one of {', '.join(ALL_KINDS)}, got {kind!r}{nearest(kind, ALL_KINDS)}")
    if tolerance is not None and not number(tolerance, "tolerance") > 0.0:
        raise ValueError(f"tolerance: expected a length greater than 0, found {tolerance:g}")
    if not number(smooth, "smooth") >= 0.0:
        raise ValueError(f"smooth: expected a weight not below 0, found {smooth:g}")
    if corners is not None and kind not in HELD:
        raise ValueError(f"corners: belong to {', '.join(HELD)}, found kind {kind}")
    scan = target_of(target, unit)
    if weights is not None:
        heavy = frozen(weights, "weights", (len(scan.points),))
        if (heavy < 0.0).any() or not heavy.any():
            raise ValueError("weights: expected numbers not below 0, not all 0")
        scan = replace(scan, weights=heavy)
    trusted = scan.noisy if robust is None else robust
    if kind == "curve":
        return curves.fit_curve(scan, basis, shape, None if size is None else size[0], tolerance, trusted, name)
    if scan.points.shape[1] != 3:
        raise ValueError("points: expected three numbers each for a surface, found two; take kind curve")
    _refuse_line(scan.points)
    if kind in PRIMITIVES:
        return _primitive(kind, scan, trusted, tolerance, name)
    ends = None if corners is None else frozen(corners, "corners", (4, 3))
    plane = _mirror(kind, mirror, scan, ends)
    work = _Work(
        scan, kind, basis, shape, size, join, boundary, smooth, tolerance, trusted, plane, ends, name, progress
    )
    if patches is not None or tolerance is None or kind != "tensor":
        return work.fitted(patches or (1, 1))
    return work.until_within(tolerance)


class _Work:
    """One run of a fit: what was asked for, and the points scaled to the size 1."""

    def __init__(
        self,
        scan: Scan,
        kind: str,
        basis: str | Sequence[str],
        shape: str | Sequence[float],
        size: tuple[int, int] | None,
        join: str,
        boundary: str | Sequence[Curve],
        smooth: float,
        tolerance: float | None,
        robust: bool,
        mirror: FloatArray | None,
        corners: FloatArray | None,
        name: str,
        progress: Progress | None,
    ) -> None:
        if join not in ("G1", "G2"):
            raise ValueError(f"join: expected G1 or G2, got {join!r}")
        if isinstance(shape, str) and shape not in ("fixed", "free"):
            raise ValueError(f"shape: expected fixed, free or numbers, got {shape!r}")
        self.scan, self.kind, self.basis, self.size, self.name = scan, kind, basis, size, name
        self.progress = progress
        self.join, self.tolerance, self.mirror = join, tolerance, mirror
        self.free = shape == "free"
        self.values = None if isinstance(shape, str) else frozen(list(shape), "shape", (None,))
        self.scale = scan.size
        self.corners: FloatArray | None = None
        form = self._form((1, 1))
        moves = all(one.partition for one in form.families(form.starts))
        self.centre = scan.points.mean(axis=0) if moves else np.zeros(3)
        if kind == "swung":
            self.centre = np.array([0.0, 0.0, self.centre[2]])
        if mirror is not None:
            self.mirror = np.append(mirror[:3], (mirror[3] + mirror[:3] @ self.centre) / self.scale)
        if corners is not None:
            self.corners = (corners - self.centre) / self.scale
        self.sides: list[FloatArray] = []
        self.data = self._data(boundary, smooth, robust)
        self._single: tuple[Form, solve.State] | None = None

    def _data(self, boundary: str | Sequence[Curve], smooth: float, robust: bool) -> solve.Data:
        local = (self.scan.points - self.centre) / self.scale
        weights = np.ones(len(local)) if self.scan.weights is None else self.scan.weights
        if isinstance(boundary, str):
            if boundary not in ("free", "curves"):
                raise ValueError(f"boundary: expected free or curves, or a model of curves, got {boundary!r}")
            on = np.zeros(len(local), dtype=np.bool_)
            if boundary == "curves":
                on = border_points(self.scan, local)
            # Points count as all others do, and draw the edges beside that: those inside a little, as a cloud has no
            # border but its outermost points.
            held, heavy = local[on], _DRAWN * weights[on]
        else:
            t = np.linspace(0.0, 1.0, _ON_CURVE)
            parts = [np.asarray(curve(t), dtype=np.float64) for curve in boundary]
            if any(part.shape[1] != 3 for part in parts):
                raise ValueError("boundary: expected curves in space, found curves in the plane")
            self.sides = [(part - self.centre) / self.scale for part in parts]
            held = np.concatenate(self.sides)
            heavy = np.full(len(held), 1e4 * float(weights.sum()) / len(held))
        border = np.arange(len(local) + len(held)) >= len(local)
        return solve.Data(
            np.concatenate([local, held]), np.concatenate([weights, heavy]), border, robust, smooth, self.progress
        )

    def _form(self, grid: tuple[int, int]) -> Form:
        form = form_of(self.kind, self.basis, self.size, grid, int(self.join[1]))
        form = replace(form, mirror=self.mirror, corners=self.corners)
        if self.values is not None:
            if len(self.values) != len(form.ranges):
                expected = f"{len(form.ranges)} numbers ({', '.join(form.ranges)})" if form.ranges else "none"
                raise ValueError(f"shape: expected {expected}, found {len(self.values)}")
            form = form.at(self.values)
        return form

    def fitted(self, grid: tuple[int, int]) -> Fit:
        """Return the fit by a grid of patches."""
        form, state = self._start()
        if grid != (1, 1):
            one = form
            finder = Finder(one.surfaces(state.q, state.theta))
            feet = finder.feet(self.data.some(_LAST).points)
            form = self._form(grid)
            data = self.data.some(_LAST)
            state = solve.begun(form, data, np.stack([feet.u, feet.v], axis=1))
            state = solve.refined(form, self.data.some(max(_MAIN, 80 * form.patches)), state, False, 25)
        if len(self.data.points) > _MAIN:
            state = solve.refined(form, self.data.some(_LAST), replace(state, rms=np.inf), self._freed, 8)
        return self._told(form, state)

    @property
    def _freed(self) -> bool:
        return self.free

    def _start(self) -> tuple[Form, solve.State]:
        """Return the fit by one patch, the best of all ways to begin."""
        if self._single is not None:
            return self._single
        form = self._form((1, 1))
        few, main = self.data.some(_FIRST), self.data.some(_MAIN)
        tried: list[solve.State] = []
        for at in self._ways():
            state = solve.begun(form, few, at[self.data.chosen(_FIRST)])
            tried.append(solve.refined(form, replace(few, smooth=max(few.smooth, 1e-7)), state, False, 10, 1e-3))
        ranked = sorted(tried, key=lambda one: one.rms)
        ranked = [one for one in ranked[:2] if one is ranked[0] or _CLOSE < one.rms / ranked[0].rms < _WORSE]
        done = [solve.refined(form, main, replace(one, rms=np.inf), False, 30, 1e-4) for one in ranked]
        best = min(done, key=lambda one: one.rms)
        best = solve.refined(form, main, best, self.free, 80)
        lost = solve.left_out(form, main, best)
        if 0 < len(lost) <= _FEW_OUTLIERS * len(main.points) and lost.max() < _NEAR_OUTLIERS:
            # They may be no outliers, but what a surface that curls up in a corner does not reach.
            other = solve.refined(form, replace(main, robust=False), best, self.free, 30)
            other = solve.refined(form, main, replace(other, rms=np.inf), self.free, 80)
            best = min(best, other, key=lambda one: one.rms)
        self._single = form, best
        return self._single

    def _ways(self) -> Iterator[FloatArray]:
        """Yield parameters (n, 2) of all points to begin from; those of border points are on the edges."""
        count = len(self.scan.points)
        points = self.data.points[:count]
        own = self.scan.parameters
        ways = parametrisations(self.scan, points, self.kind, self.mirror)
        if own is not None:
            ways = chain([own], ways) if self.scan.noisy else iter([own])
        corners = self.corners if self.corners is not None else corners_of(self.sides, points)
        if corners is not None:
            ways = ways_between(corners, points, ways)
        for at in ways:
            yield on_sides(at, points, self.data.points[count:], [len(side) for side in self.sides])

    def until_within(self, tolerance: float) -> Fit:
        """Return the first fit in a growing grid of patches that is within a tolerance, or the best of them."""
        best = self.fitted(_GRIDS[0])
        for grid in _GRIDS[1:]:
            if best.max <= tolerance or grid[0] * grid[1] * 12 > len(self.scan.points):
                break
            found = self.fitted(grid)
            if not found.max < best.max:
                break
            best = found
        if best.max > tolerance:
            note = f"the tolerance is not reached: the largest distance is {best.max:.3g}, allowed {tolerance:.3g}"
            best = replace(best, notes=(*best.notes, note))
        return best

    def _told(self, form: Form, state: solve.State) -> Fit:
        """Return the model of a state, measured anew against all points."""
        shape: tuple[ShapeValue, ...] = ()
        notes = list(self.scan.notes)
        if self.free and len(state.theta):
            for _ in range(_BETTER_FITS):
                shape, better = intervals(form, self.data.some(_PROFILE), self.data.some(_LAST), state)
                if better is None:
                    break
                state = solve.refined(form, self.data.some(_LAST), replace(better, rms=np.inf), True, 40)
            for one in shape:
                if not one.determined:
                    ends = f"95 % interval {one.low:.3g} to {one.high:.3g}"
                    notes.append(f"{one.name} is poorly determined by these points: {ends}")
                elif len(one.intervals) > 1:
                    notes.append(f"{one.name} has {len(one.intervals)} values that fit as well, each with others")
        dumps = form.keys(state.q, state.theta, self.scale, self.centre)
        model = model_of(dumps, form.grid, self.name, self.scan.unit)
        measured = deviation(model, self.scan, tolerance=self.tolerance)
        kept = inliers(measured.distance) if self.data.robust else np.ones(len(measured), dtype=np.bool_)
        if len(self.scan.points) * 3 < len(state.q):
            notes.append(f"{len(self.scan.points)} points do not determine {len(state.q)} numbers: the rest is smooth")
        facts: dict[str, Any] = {"grid": list(form.grid), "join": self.join if form.patches > 1 else None}
        if self.kind == "symmetric":
            facts["mirror"] = dumps[0]["mirror"]
        return Fit(model, self.kind, measured, kept, shape, self.tolerance, facts, tuple(notes))


def model_of(dumps: list[dict[str, Any]], grid: tuple[int, int], name: str, unit: str) -> Model:
    """Return a model of one patch, or of a grid of patches called by their places in it."""
    header: dict[str, Any] = {"name": name} | ({"unit": unit} if unit else {})
    if len(dumps) == 1:
        return Model.from_dict(header | dumps[0])
    places = [f"patch {i + 1},{j + 1}" for i in range(grid[0]) for j in range(grid[1])]
    return Model.from_dict(header | {"patch": [{"name": n} | d for n, d in zip(places, dumps, strict=True)]})


def inliers(distance: FloatArray) -> BoolArray:
    """Return which distances (n,) are within 6 standard deviations by the median, all where many are not."""
    off = np.abs(distance)
    usual = 1.4826 * float(np.median(off))
    kept = off <= 6.0 * max(usual, 1e-12 * float(off.max()))
    return kept if kept.mean() > 0.7 else np.ones(len(off), dtype=np.bool_)


def border_points(scan: Scan, points: FloatArray) -> BoolArray:
    """Return which points (n, 3) lie on the border of a mesh, or of a cloud: those with a wide empty angle around."""
    on = np.zeros(len(points), dtype=np.bool_)
    if scan.triangles is not None:
        loop = border(scan.triangles)
        if loop is not None:
            on[loop] = True
            return on
    near = np.asarray(tree_of(points).query(points, k=min(20, len(points)))[1])[:, 1:]
    local = points[near] - points[:, None]
    _, axes = np.linalg.eigh(np.einsum("nki,nkj->nij", local, local))
    x, y = (np.einsum("nki,ni->nk", local, axes[:, :, k]) for k in (2, 1))
    angle = np.sort(np.arctan2(y, x), axis=1)
    gaps = np.diff(np.concatenate([angle, angle[:, :1] + 2 * np.pi], axis=1), axis=1)
    found: BoolArray = gaps.max(axis=1) > 0.6 * np.pi
    return found


def _primitive(kind: str, scan: Scan, robust: bool, tolerance: float | None, name: str) -> Fit:
    found = fit_primitive(kind, scan.points, robust)
    model = model_of([found.keys], (1, 1), name, scan.unit)
    measured: Deviation = deviation(model, scan, tolerance=tolerance)
    kept = inliers(measured.distance) if robust else np.ones(len(measured), dtype=np.bool_)
    return Fit(model, kind, measured, kept, (), tolerance, {"form": found.to_dict()}, scan.notes)


def _mirror(kind: str, mirror: ArrayLike | None, scan: Scan, corners: FloatArray | None) -> FloatArray | None:
    if kind != "symmetric":
        if mirror is not None:
            raise ValueError(f"mirror: belongs to a symmetric surface, not to kind {kind}")
        return None
    if mirror is None and corners is not None:  # u runs across the plane, from two of the corners to their images
        mirror = halfway(corners)
    if mirror is None:
        free = fit(scan, "tensor")
        return mirror_of(Finder([free.model.surface]), scan.points[free.kept])
    plane = frozen(mirror, "mirror", (4,))
    length = float(np.linalg.norm(plane[:3]))
    if not length > 0.0:
        raise ValueError("mirror: expected [a, b, c, d] with (a, b, c) not all zero, found a zero normal")
    return plane / length


def _refuse_line(points: FloatArray) -> None:
    """Raise ValueError for points that no surface can be laid through: too few, all in one place, or on a line."""
    if len(points) < 4:
        raise ValueError(f"points: expected at least 4 for a surface, found {len(points)}")
    refuse_no_surface(points)
