"""Pieces and parallels of a curve: split at a parameter, offset in the plane."""

import math
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from quintrig.basis.rational import NotRationalError, TangentMap
from quintrig.geometry.curve import Curve
from quintrig.support.arrays import FloatArray, number

_CHECKED = 129  # points of a piece at which its error is measured
_MOST = 256  # pieces of an offset


@dataclass(frozen=True)
class Pieces:
    """Curves end to end, and how far they are at most from what they stand for, length¹, at the points checked."""

    curves: tuple[Curve, ...]
    error: float


def split_curve(curve: Curve, t: float) -> Pieces:
    """Return the two curves that ``curve`` is made of before and after ``t``.

    Exact, with error 0, where the functions span the polynomials of a degree, as Bernstein's do (de Casteljau). The
    trigonometric space holds no part of its own curves: there, and in others, the pieces are fitted by least squares
    with the ends kept, and the error says how far they are from the curve. Raises ValueError for t outside (0, 1).
    """
    if not 0.0 < number(t, "t") < 1.0:
        raise ValueError(f"t: expected a number between 0 and 1, found {t:g}")
    change = _polynomial(curve)
    if change is not None:
        parts = _casteljau(change @ curve.points, t)
        kept = [np.linalg.solve(change, part) for part in parts]
        return Pieces(tuple(replace(curve, points=points) for points in kept), 0.0)
    pieces = [_fitted(curve, low, high) for low, high in ((0.0, t), (t, 1.0))]
    return Pieces(tuple(piece for piece, _ in pieces), max(error for _, error in pieces))


def offset_curve(curve: Curve, distance: float, tolerance: float | None = None) -> Pieces:
    """Return curves that follow a plane curve at ``distance`` (length¹) to its left, negative to its right.

    An offset is no curve of the space: pieces are fitted and halved until each is within ``tolerance`` (1e-6 of the
    curve's size if not given) of the offset at 129 points, or there are 256: the error says what was reached. Raises
    ValueError in space, at a cusp, and where the offset
    turns back on itself because the distance reaches the radius of curvature.
    """
    if curve.points.shape[1] != 2:
        raise ValueError("offset_curve: expected a plane curve (n x 2 points), found one in space")
    by = number(distance, "distance")
    size = float(np.ptp(curve.points, axis=0).max())
    allowed = 1e-6 * size if tolerance is None else number(tolerance, "tolerance")
    if not allowed > 0.0:
        raise ValueError(f"tolerance: expected a number greater than 0, found {allowed:g}")
    at = np.concatenate([[0.0], curve.curvature_extremes(), [1.0]])
    bends = by * curve.signed_curvature(at)
    if np.isnan(bends).any():
        raise ValueError("offset_curve: expected a curve without cusps, found one that stands still")
    if bends.max() >= 1.0:
        worst = int(np.argmax(bends))
        radius = abs(by / bends[worst])
        raise ValueError(
            f"distance: expected less than {radius:.6g}, the radius of curvature at t = {at[worst]:.4g}, "
            f"found {abs(by):g}"
        )
    waiting, done, error = [(0.0, 1.0)], list[Curve](), 0.0
    while waiting:
        low, high = waiting.pop()
        piece, miss = _fitted(curve, low, high, by)
        if miss > allowed and len(waiting) + len(done) < _MOST:
            waiting += [(0.5 * (low + high), high), (low, 0.5 * (low + high))]
        else:
            done.append(piece)
            error = max(error, miss)
    return Pieces(tuple(done), error)


def _polynomial(curve: Curve) -> FloatArray | None:
    """Return the Bernstein coefficients of the functions where they span all polynomials of their degree, else None."""
    try:
        form = curve.functions.rational()
    except NotRationalError:
        return None
    square = form.coefficients.shape[0] == form.coefficients.shape[1]
    if form.map != TangentMap() or not square or form.degree != len(form.weights) - 1 or np.ptp(form.weights) > 0.0:
        return None
    return form.coefficients if np.linalg.cond(form.coefficients) < 1e8 else None


def _casteljau(points: FloatArray, t: float) -> tuple[FloatArray, FloatArray]:
    left, right, rest = [points[0]], [points[-1]], points
    while len(rest) > 1:
        rest = (1.0 - t) * rest[:-1] + t * rest[1:]
        left.append(rest[0])
        right.append(rest[-1])
    return np.array(left), np.array(right[::-1])


def _fitted(curve: Curve, low: float, high: float, by: float = 0.0) -> tuple[Curve, float]:
    """Return the curve closest to a part of another one, moved ``by`` to its left, and how far it is from that part.

    The ends are kept; a point of the part is compared with the one of the fit at the same share of t,
    corrected twice along the tangent.
    """
    shares = np.linspace(0.0, 1.0, _CHECKED)
    t = low + shares * (high - low)
    target = curve(t) + (by * curve.normal(t) if by else 0.0)
    at = shares
    fit = curve
    error = math.inf
    for _ in range(4):
        functions = curve.functions.derivatives(at, 0)[0]
        inner = functions[:, 1:-1]
        ends = functions[:, :1] * target[0] + functions[:, -1:] * target[-1]
        middle = cast(FloatArray, np.linalg.lstsq(inner, target - ends, rcond=None)[0])
        fit = replace(curve, points=np.vstack([target[:1], middle, target[-1:]]))
        for _ in range(3):
            place, tangent = fit.derivatives(at, 1)
            speed = np.maximum((tangent**2).sum(axis=-1), 1e-300)
            at = np.clip(at + ((target - place) * tangent).sum(axis=-1) / speed, 0.0, 1.0)
        error = float(np.linalg.norm(fit(at) - target, axis=-1).max())
    return fit, error
