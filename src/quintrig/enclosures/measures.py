"""What a proof can be about: for each quantity the forms that it is made of, and how it is enclosed by them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from quintrig.basis.exact_numbers import fractions
from quintrig.enclosures import intervals
from quintrig.enclosures.boxes import Enclose
from quintrig.enclosures.intervals import Interval
from quintrig.enclosures.shape import Form, Shape, cancelled
from quintrig.support.arrays import FloatArray

Problem = tuple[list[Form], Enclose]
"""Forms of one bidegree over a chart, and what takes bounds of their coefficients to bounds of the quantity."""


@dataclass(frozen=True)
class Measure:
    """A quantity: ``unit`` as a power of length, or ``degrees``; ``problem`` of a chart, ``sign_only`` for its sign.

    Both take the chart's ``Shape``, the sign of the normal, and a direction.
    """

    key: str
    power: int
    problem: Callable[[Shape, float, FloatArray], Problem]
    sign_only: Callable[[Shape, float, FloatArray], Problem] | None = None
    degrees: bool = False


def regular(shape: Shape, sign: float, direction: FloatArray) -> Problem:
    """Return D, which is above 0 where there is a normal."""
    return [shape.area], intervals.sign


def gauss_sign(shape: Shape, sign: float, direction: FloatArray) -> Problem:
    """Return P, which has the sign of K."""
    return [cancelled(shape.gauss, shape.both)[0]], intervals.sign


def saddle_sign(shape: Shape, sign: float, direction: FloatArray) -> Problem:
    """Return λν, which is not below P = λν - μρ: f g μρ is the square of f μ = g ρ."""
    lam, _, _, nu = shape.second_form
    return [lam * nu], intervals.sign


def mean_sign(shape: Shape, sign: float, direction: FloatArray) -> Problem:
    """Return Q, which has the sign of H."""
    form = cancelled(shape.mean, shape.both)[0]
    return [form if sign > 0.0 else -form], intervals.sign


def gauss(shape: Shape, sign: float, direction: FloatArray) -> Problem:
    """Return P and f g D², whose quotient is K."""
    top, edges = cancelled(shape.gauss, shape.both)
    forms = [shape.weighted(top, 4), (shape.area * shape.area).multiplied(edges)]
    per = float(shape.chart.scale) ** -2

    def enclose(low: FloatArray, high: FloatArray) -> Interval:
        return _scaled(intervals.quotient((low[:, 0], high[:, 0]), (low[:, 1], high[:, 1])), per)

    return equal(shape, forms), enclose


def curvatures(
    shape: Shape, sign: float, direction: FloatArray, of: Callable[[Interval, Interval], Interval]
) -> Problem:
    """Return what K and H are quotients of, for a quantity of both.

    H = Q / (2 f g D √D), and 2d √D = (D + d²) / φ, where φ = (D + d²) / (2d √D) >= 1 for any d > 0. With d² from the
    range of D in a box, φ is 1 to second order in its size, and so is H = φ d Q / (f g D (D + d²)). Where Q is of odd
    degree, Q ℓ and D ℓ² under the root take their place, ℓ = 1 being a linear form.
    """
    top, edges = cancelled(shape.gauss, shape.both)
    mean, left = cancelled(shape.mean, shape.both)
    mean, area = shape.weighted(mean if sign > 0.0 else -mean, 2), shape.area
    below = area.multiplied(left)
    mean, under = shape.even(mean, below, area)
    squared = area * area
    forms = [shape.weighted(top, 4), squared.multiplied(edges), mean]
    plain = not any(edges) and not any(left) and under is area
    forms += [area] if plain else [below * under, below, under, shape.arithmetic.constant(1)]
    places = (1, 3, 1, 3) if plain else (3, 4, 5, 6)  # D is D² / D, or the D under the root over 1
    scale = float(shape.chart.scale)

    def enclose(low: FloatArray, high: FloatArray) -> Interval:
        k = intervals.quotient((low[:, 0], high[:, 0]), (low[:, 1], high[:, 1]))
        h = _mean((low[:, 2], high[:, 2]), *((low[:, place], high[:, place]) for place in places))
        return of(_scaled(h, 1.0 / scale), _scaled(k, scale**-2))

    return equal(shape, forms), enclose


def _mean(top: Interval, product: Interval, below: Interval, under: Interval, one: Interval) -> Interval:
    """Return bounds of H from those of Q, f g D², f g D, and two forms whose quotient is the D under the root."""
    least, most = intervals.quotient(under, one)
    known = np.isfinite(most) & (most > 0.0)
    square = np.where(known, 0.5 * (np.maximum(least, 0.0) + most), 1.0)  # any number above 0 will do
    d, wide = np.sqrt(square), square[:, None, None]
    slack = 2.0**-50 * (np.abs(product[0]) + np.abs(product[1]) + wide * (np.abs(below[0]) + np.abs(below[1])))
    low, high = product[0] + wide * below[0], product[1] + wide * below[1]
    low, high = intervals.quotient(top, (low - slack * (low != 0.0), high + slack * (high != 0.0)))
    low, high = intervals.outward(d * low, d * high)
    with np.errstate(divide="ignore", invalid="ignore"):
        grown = [np.where(least > 0.0, (end + square) / (2.0 * d * np.sqrt(end)), np.inf) for end in (least, most)]
        factor = np.maximum(*grown) * (1.0 + 2.0**-48)
        return np.where(low < 0.0, low * factor, low), np.where(high > 0.0, high * factor, high)


def slope(shape: Shape, sign: float, direction: FloatArray) -> Problem:
    """Return (N·d)² and D for the angle between the tangent plane and the plane across a unit ``direction``."""
    across = _across(shape, direction)
    length = fractions(direction)
    forms = [across * across, shape.area * shape.arithmetic.constant(sum(length * length))]

    def enclose(low: FloatArray, high: FloatArray) -> Interval:
        return tilt(*intervals.root(*intervals.quotient((low[:, 0], high[:, 0]), (low[:, 1], high[:, 1]))))

    return equal(shape, forms), enclose


def draft(shape: Shape, sign: float, direction: FloatArray) -> Problem:
    """Return N·d besides the two forms of ``slope``: the draft angle is the arc sine of n·d."""
    across = _across(shape, direction)
    forms, _ = slope(shape, sign, direction)

    def enclose(low: FloatArray, high: FloatArray) -> Interval:
        least, most = intervals.root(*intervals.quotient((low[:, 0], high[:, 0]), (low[:, 1], high[:, 1])))
        below, above = intervals.sign(low, high, 2)
        if sign < 0.0:
            below, above = -above, -below
        return elevation(np.where(below >= 0.0, least, -most), np.where(above <= 0.0, -least, most))

    return equal(shape, [*forms, across]), enclose


def draft_sign(shape: Shape, sign: float, direction: FloatArray) -> Problem:
    """Return N·d, which has the sign of the draft angle."""
    across = _across(shape, direction)
    return [across if sign > 0.0 else -across], intervals.sign


def _across(shape: Shape, direction: FloatArray) -> Form:
    parts = [
        part * shape.arithmetic.constant(value) for part, value in zip(shape.normal, fractions(direction), strict=True)
    ]
    return parts[0] + parts[1] + parts[2]


def tilt(low: FloatArray, high: FloatArray) -> Interval:
    """Return bounds of the angle of which the cosine is given, in degrees."""
    return _angle(np.arccos(np.clip(high, 0.0, 1.0)), np.arccos(np.clip(low, 0.0, 1.0)))


def elevation(low: FloatArray, high: FloatArray) -> Interval:
    """Return bounds of the angle of which the sine is given, in degrees."""
    return _angle(np.arcsin(np.clip(low, -1.0, 1.0)), np.arcsin(np.clip(high, -1.0, 1.0)))


def _angle(low: FloatArray, high: FloatArray) -> Interval:
    """Return bounds in degrees; the C library's arcs are good to a few units in the last place of a right angle."""
    slack = 1e-14
    return np.degrees(low) - slack * 90.0, np.degrees(high) + slack * 90.0


def _scaled(interval: Interval, factor: float) -> Interval:
    if factor == 1.0:
        return interval
    return interval[0] * factor, interval[1] * factor  # a power of 2: exact


def equal(shape: Shape, forms: Sequence[Form]) -> list[Form]:
    """Return the forms in one bidegree.

    Those of a quotient have degrees that are odd together, or even; the others' are made so by a positive factor.
    """
    alike = [shape.alike(form, forms[0]) for form in forms]
    to = max(form.degree[0] for form in alike), max(form.degree[1] for form in alike)
    return [shape.raised(form, to) for form in alike]


def _of_both(pick: Callable[[Interval, Interval], Interval]) -> Callable[[Shape, float, FloatArray], Problem]:
    return partial(curvatures, of=pick)


def _mean_of(mean: Interval, gauss: Interval) -> Interval:
    return mean


def _k1(mean: Interval, gauss: Interval) -> Interval:
    return intervals.principal(mean, gauss)[0]


def _k2(mean: Interval, gauss: Interval) -> Interval:
    return intervals.principal(mean, gauss)[1]


def _radius(mean: Interval, gauss: Interval) -> Interval:
    return intervals.inverse(*intervals.largest(*intervals.principal(mean, gauss)))


MEASURES: dict[str, Measure] = {
    measure.key: measure
    for measure in (
        Measure("gaussian", -2, gauss, gauss_sign),
        Measure("mean", -1, _of_both(_mean_of), mean_sign),
        Measure("k1", -1, _of_both(_k1)),
        Measure("k2", -1, _of_both(_k2)),
        Measure("curvedness", -1, _of_both(intervals.curvedness)),
        Measure("curvature_radius", 1, _of_both(_radius)),
        Measure("slope", 0, slope, degrees=True),
        Measure("draft", 0, draft, draft_sign, degrees=True),
    )
}
"""The quantities that have a proof."""

REGULAR = Measure("regular", 0, regular)
UPRIGHT = np.array([0.0, 0.0, 1.0])
