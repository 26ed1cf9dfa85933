"""A polynomial B-spline of chosen degree near a surface, for systems that refuse the exact form, and how near it is."""

from dataclasses import dataclass

import numpy as np

from quintrig.basis.bspline import HIGHEST_DEGREE, BSpline, clamped
from quintrig.basis.rational import TangentMap
from quintrig.geometry.exact import ExactSurface
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

MOST_SPANS = 256
"""Spans of a fit in one direction, at most."""


@dataclass(frozen=True)
class FitOptions:
    """Degree in both directions, order of continuity at the knots, and the largest deviation allowed, length¹.

    ``continuity`` None means degree - 1, as smooth as it gets. Without ``tolerance`` it is 1e-6 of the surface's size.
    """

    degree: int = 3
    continuity: int | None = None
    tolerance: float | None = None

    def __post_init__(self) -> None:
        """Check once that they go together."""
        if not 1 <= self.degree <= HIGHEST_DEGREE:
            raise ValueError(f"degree of the fit: expected 1 to {HIGHEST_DEGREE}, found {self.degree}")
        if self.continuity is not None and not 0 <= self.continuity < self.degree:
            raise ValueError(
                f"continuity of the fit: expected 0 to {self.degree - 1} for degree {self.degree}, "
                f"found {self.continuity}"
            )
        if self.tolerance is not None and not self.tolerance > 0.0:
            raise ValueError(f"tolerance of the fit: expected a length greater than 0, found {self.tolerance:g}")

    @property
    def smoothness(self) -> int:
        """Order of continuity at the knots."""
        return self.degree - 1 if self.continuity is None else self.continuity


@dataclass(frozen=True, eq=False)
class Fit:
    """A fitted surface over the same (u, v), and the largest distance measured at equal parameters, length¹."""

    form: ExactSurface
    deviation: float
    tolerance: float
    spans: tuple[int, int]


def fit(surface: Surface, options: FitOptions) -> Fit:
    """Return a least-squares fit that keeps the four edges' ends, refined until it is within the tolerance.

    The deviation is measured between the points of equal parameters on a grid four times as fine as the fit's own, so
    it is an upper bound of the distance of the surfaces there. Raises ValueError where 256 spans a side are not enough.
    """
    tolerance = options.tolerance or 1e-6 * surface.size
    spans = [_spans_along(surface, axis, options, 0.5 * tolerance) for axis in (0, 1)]
    while True:
        form = _fitted(surface, options, spans[0], spans[1])
        deviation = _deviation(surface, form)
        if deviation <= tolerance:
            return Fit(form, deviation, tolerance, (spans[0], spans[1]))
        if max(spans) * 2 > MOST_SPANS:
            raise ValueError(
                f"the fit of degree {options.degree} deviates by {deviation:.3g} with {spans[0]} x {spans[1]} spans, "
                f"more than {tolerance:.3g}; choose a larger tolerance or a higher degree"
            )
        spans = [2 * count for count in spans]


def _spans_along(surface: Surface, axis: int, options: FitOptions, tolerance: float) -> int:
    """Return the number of spans that fits the curves along one direction."""
    across = np.linspace(0.0, 1.0, 17)
    spans = 1
    while spans < MOST_SPANS:
        basis = _basis(spans, options)
        sites, fine = fit_sites(basis, 2), fit_sites(basis, 5)
        points = _curves(surface, sites, across, axis)
        found = basis.derivatives(fine, 0)[0] @ solved(basis, sites, points.reshape(len(sites), -1))
        if np.abs(found - _curves(surface, fine, across, axis).reshape(len(fine), -1)).max() <= tolerance:
            break
        spans *= 2
    return spans


def _curves(surface: Surface, along: FloatArray, across: FloatArray, axis: int) -> FloatArray:
    points = surface(along[:, None], across[None, :]) if axis == 0 else surface(across[:, None], along[None, :])
    return points if axis == 0 else points.transpose(1, 0, 2)


def _basis(spans: int, options: FitOptions) -> BSpline:
    return clamped(np.linspace(0.0, 1.0, spans + 1), options.degree, options.degree - options.smoothness)


def fit_sites(basis: BSpline, density: int) -> FloatArray:
    """Return parameters, the ends and ``density`` (degree + 1) Chebyshev points in every span."""
    count = density * (basis.degree + 1)
    local = 0.5 - 0.5 * np.cos(np.pi * (np.arange(count) + 0.5) / count)
    breaks = basis.breaks
    inner = (breaks[:-1, None] + np.diff(breaks)[:, None] * local).ravel()
    return np.concatenate([[0.0], inner, [1.0]])


def solved(basis: BSpline, sites: FloatArray, values: FloatArray) -> FloatArray:
    """Return coefficients (n, k) nearest to values (sites, k), exact at both ends."""
    matrix = basis.derivatives(sites, 0)[0]
    ends = np.outer(matrix[:, 0], values[0]) + np.outer(matrix[:, -1], values[-1])
    result: FloatArray = np.empty((basis.size, values.shape[1]))
    result[0], result[-1] = values[0], values[-1]
    if basis.size > 2:
        result[1:-1] = np.linalg.lstsq(matrix[1:-1, 1:-1], (values - ends)[1:-1], rcond=None)[0]
    return result


def _fitted(surface: Surface, options: FitOptions, u_spans: int, v_spans: int) -> ExactSurface:
    u, v = _basis(u_spans, options), _basis(v_spans, options)
    s, t = fit_sites(u, 2), fit_sites(v, 2)
    points = surface(s[:, None], t[None, :])
    half = solved(u, s, points.reshape(len(s), -1)).reshape(u.size, len(t), 3)
    whole = solved(v, t, half.transpose(1, 0, 2).reshape(len(t), -1)).reshape(v.size, u.size, 3)
    control = np.ascontiguousarray(whole.transpose(1, 0, 2))
    identity = (TangentMap(), TangentMap())
    return ExactSurface(u, v, control, np.ones(control.shape[:2]), identity, flip=surface.flip)


def _deviation(surface: Surface, form: ExactSurface) -> float:
    s, t = fit_sites(form.u, 4), fit_sites(form.v, 4)
    blend = form.v.derivatives(t, 0)[0]
    largest = 0.0
    for part in np.array_split(s, max(1, s.size * t.size // 200_000)):
        rows = np.einsum("ai,ijx->ajx", form.u.derivatives(part, 0)[0], form.points)
        gap = np.einsum("ajx,bj->abx", rows, blend) - surface(part[:, None], t[None, :])
        largest = max(largest, float(np.sqrt((gap**2).sum(axis=-1)).max()))
    return largest
