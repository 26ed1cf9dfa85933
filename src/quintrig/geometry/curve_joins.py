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
_STILL = 1e-12  # of the largest coefficient: below it, one is rounding
_ORDERS: tuple[Order, ...] = ("G0", "G1", "G2", "G3")


def join_curves(first: Curve, second: Curve, order: Order = "G2", ratio: float = 1.0, free: float = 0.0) -> Curve:
    """Return ``second`` with its first control points moved so that it goes on from the end of ``first``.

    Any two bases go together, whose derivatives at the ends give the points: Q' = κ P', Q'' = κ² P'' + μ P' and, for
    G3, Q⁽³⁾ = κ³ P⁽³⁾ + 3κμ P'' + ν P'. ``ratio`` κ > 0 is the speed at the start of the second over that at the end
    of the first; ``free`` is μ. G0 moves one point, G1 two, G2 three. G3 moves a fourth, with ν = 0, where the third
    derivative has it; where it has not, it fixes μ instead, for two quintic curves at -(2π/3) κ (1 + κ). C1 and C2
    are κ = 1, μ = 0. Raises ValueError for another order, a ratio that is not positive, curves in plane and space, a
    curve that stands still at the join, too few points, and where there is no G3 join.
    """
    if order not in _ORDERS:
        raise ValueError(f"order: expected one of {', '.join(_ORDERS)}, found {order!r}")
    if first.points.shape[1] != second.points.shape[1]:
        raise ValueError("second: expected a curve in as many dimensions as the first; one is plane, one in space")
    kappa, mu = number(ratio, "ratio"), number(free, "free")
    if not kappa > 0.0:
        raise ValueError(f"ratio: expected a number greater than 0, found {kappa:g}")
    points = np.array(second.points)
    points[0] = first.points[-1]
    moved = _ORDERS.index(order)
    if moved == 0:
        return replace(second, points=points)
    ends = first.functions.derivatives(np.array([1.0]), 3)[:, 0]
    starts = second.functions.derivatives(np.array([0.0]), 3)[:, 0]
    for name, rows in (("first", ends), ("second", starts)):
        if not np.abs(rows[1]).max() > _STILL * np.abs(rows).max():
            raise ValueError(
                f"{name}: expected a curve that moves at the join; its shape parameter there is at the end of the "
                "range (-4 in the quintic basis), where it stands still"
            )
    speed, bend, turn = ends[1:] @ (first.points - first.points[-1])
    if order == "G3" and not _reaches(starts, 3):
        mu, moved = _third(ends, starts, kappa, (speed, bend, turn)), 2
    wanted = [kappa * speed, kappa**2 * bend + mu * speed, kappa**3 * turn + 3.0 * kappa * mu * bend][:moved]
    if moved >= len(points):
        raise ValueError(f"second: expected more than {moved} control points for {order}, found {len(points)}")
    matrix = starts[1 : moved + 1, 1 : moved + 1]
    rest = points - points[0]
    known = starts[1 : moved + 1, moved + 1 :] @ rest[moved + 1 :]
    size = np.abs(matrix).max(axis=1, keepdims=True)
    if not (size > 0.0).all() or not np.linalg.cond(matrix / size) < 1e12:
        raise ValueError(f"second: this basis has no {order} join by its first {moved + 1} control points")
    points[1 : moved + 1] = points[0] + np.linalg.solve(matrix / size, (np.stack(wanted) - known) / size)
    return replace(second, points=points)


def _reaches(rows: FloatArray, order: int) -> bool:
    """Return whether a derivative at the start has a part of control point ``order``, or of one beyond it."""
    return bool(np.abs(rows[order, order:]).max(initial=0.0) > _STILL * np.abs(rows[order]).max())


def _third(ends: FloatArray, starts: FloatArray, kappa: float, path: tuple[FloatArray, ...]) -> float:
    """Return μ with which the third derivatives agree where they have no control point of their own.

    With Q⁽³⁾ = A Q'' + B Q' of every polygon, and P⁽³⁾ = C P'' + D P' of this one, μ = κ (A - κ C) / 3.
    """
    own = starts[3, 2] / starts[2, 2] if starts[2, 2] else 0.0
    speed, bend, turn = path
    if not _reaches(ends[:, ::-1], 3) and ends[2, -3]:
        other = ends[3, -3] / ends[2, -3]
    else:
        pair = np.stack([bend, speed], axis=-1)
        found = np.linalg.lstsq(pair, turn, rcond=None)[0]
        if np.linalg.norm(pair @ found - turn) > 1e-9 * np.linalg.norm(turn):
            raise ValueError("G3: no such join: the first curve has torsion at its end, which the second cannot have")
        other = float(found[0])
    return float(kappa * (own - kappa * other) / 3.0)


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
