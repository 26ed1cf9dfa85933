"""Curves joined with continuous tangent, curvature and slope of curvature; splines through points."""

import math
from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.trigonometric import Trigonometric
from quintrig.geometry.curve import Curve
from quintrig.support.arrays import FloatArray, frozen, number

Order = Literal["G0", "G1", "G2", "G3"]
_ORDERS: tuple[Order, ...] = ("G0", "G1", "G2", "G3")


def join_curves(first: Curve, second: Curve, order: Order = "G2", ratio: float = 1.0, free: float = 0.0) -> Curve:
    """Return ``second`` with its first control points moved so that it goes on from the end of ``first``.

    ``ratio`` κ > 0 is the speed at the start of the second over that at the end of the first; ``free`` is μ of a G2
    join, which G3 fixes at -(2π/3) κ (1 + κ). G0 moves one point, G1 two, G2 and G3 three; C1 and C2 are κ = 1, μ = 0.
    Raises ValueError for another order or basis, a ratio that is not positive, curves in plane and space, and a shape
    parameter of -4 at the join, where a curve stands still.
    """
    if order not in _ORDERS:
        raise ValueError(f"order: expected one of {', '.join(_ORDERS)}, found {order!r}")
    for name, curve in (("first", first), ("second", second)):
        if not isinstance(curve.functions, Trigonometric):
            raise ValueError(  # noqa: TRY004 — a wrong basis is a wrong value
                f"{name}: expected a curve in the quintic trigonometric basis, found {curve.basis!r}"
            )
    if first.points.shape[1] != second.points.shape[1]:
        raise ValueError("second: expected a curve in as many dimensions as the first; one is plane, one in space")
    kappa, mu = number(ratio, "ratio"), number(free, "free")
    if not kappa > 0.0:
        raise ValueError(f"ratio: expected a number greater than 0, found {kappa:g}")
    if order == "G3":
        mu = -2.0 * math.pi / 3.0 * kappa * (1.0 + kappa)
    points = np.array(second.points)
    points[0] = first.points[5]
    if order != "G0":
        end, start = 4.0 + first.zeta, 4.0 + second.alpha
        if not (end > 0.0 and start > 0.0):
            raise ValueError("first zeta, second alpha: expected more than -4, where a curve stands still")
        leg = first.points[5] - first.points[4]
        points[1] = first.points[5] + kappa * end / start * leg
        if order != "G1":
            share = 2.0 * kappa**2 * (3.0 + first.zeta) + 2.0 * kappa * (3.0 + second.alpha) * end / start
            share = (share + mu * end / (2.0 * math.pi)) / 3.0
            points[2] = first.points[5] + kappa**2 * (first.points[3] - first.points[5]) + share * leg
    return replace(second, points=points)


def interpolate(points: ArrayLike, closed: bool = False, alpha: float = 0.0, zeta: float = 0.0) -> tuple[Curve, ...]:
    """Return curves through points (n, 2 or 3), one from each to the next, that join with continuous curvature.

    Parameters are the chords' lengths to the power ½ (centripetal; Lee 1989); tangents and second derivatives at the
    points are those of the cubic C2 spline (natural, or periodic where ``closed``), each taken over by three control
    points at that end of a curve, so that neighbours share tangent and curvature vector: G2. Raises ValueError for
    fewer than 2 points (3 if closed), neighbours that coincide, and shape parameters of -4 or outside [-4, 1].
    """
    from scipy.interpolate import CubicSpline

    given = frozen(points, "points", (None, 2), (None, 3))
    least = 3 if closed else 2
    if len(given) < least:
        raise ValueError(f"points: expected {least} or more, found {len(given)}")
    Trigonometric(alpha, zeta)
    if not (alpha > -4.0 and zeta > -4.0):
        raise ValueError("alpha, zeta: expected more than -4, where a curve stands still and has no tangent to join by")
    size = float(np.ptp(given, axis=0).max())
    if closed and np.linalg.norm(given[0] - given[-1]) > 1e-12 * size:
        given = np.vstack([given, given[:1]])
    elif closed:  # the first point is given again as the last: these two are one
        given = np.vstack([given[:-1], given[:1]])
    chords = np.linalg.norm(np.diff(given, axis=0), axis=-1)
    if not (chords > 1e-12 * size).all():
        first = int(np.flatnonzero(~(chords > 1e-12 * size))[0])
        raise ValueError(f"points[{first + 1}]: expected another place than points[{first}]; leave one of them out")
    knots = np.concatenate([[0.0], np.cumsum(np.sqrt(chords))])
    spline = CubicSpline(knots, given, bc_type="periodic" if closed else "natural")
    slopes, bends = spline(knots, 1), spline(knots, 2)
    return tuple(
        Curve(_between(given[i : i + 2], h * slopes[i : i + 2], h * h * bends[i : i + 2], alpha, zeta), alpha, zeta)
        for i, h in enumerate(np.diff(knots))
    )


def _between(ends: FloatArray, slopes: FloatArray, bends: FloatArray, alpha: float, zeta: float) -> FloatArray:
    """Return the six control points with given ends and first and second derivatives by t there."""
    sides: list[list[FloatArray]] = []
    for place, slope, bend, shape in (
        (ends[0], slopes[0], bends[0], alpha),
        (ends[1], -slopes[1], bends[1], zeta),
    ):
        second = place + slope * (2.0 / math.pi) / (4.0 + shape)
        third = (bend / math.pi**2 - (3.0 + 2.0 * shape) * place + 2.0 * (3.0 + shape) * second) / 3.0
        sides.append([place, second, third])
    return np.array([*sides[0], *sides[1][::-1]])
