"""What a proof can be about: for each quantity the forms that it is made of, and how it is enclosed by them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from quintrig.basis.exact_numbers import fractions
from quintrig.enclosures import intervals
from quintrig.enclosures.ball import Edges
from quintrig.enclosures.boxes import Enclose
from quintrig.enclosures.intervals import Interval
from quintrig.enclosures.pairs import Pairs, both
from quintrig.enclosures.shape import Form, Shape, cancelled, joint, less
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


def mean(shape: Shape, sign: float, direction: FloatArray) -> Problem:
    """Return what H is a quotient of.

    H = Q / (2 f g D √D), and 2d √D = (D + d²) / φ, where φ = (D + d²) / (2d √D) >= 1 for any d > 0. With d² from the
    range of D in a box, φ is 1 to second order in its size, and so is H = φ d Q / (f g D (D + d²)). Where Q is of odd
    degree, Q ℓ and D ℓ² under the root take their place, ℓ = 1 being a linear form.
    """
    top, left = _mean_top(shape, sign)
    below = shape.area.multiplied(left)
    top, under = shape.even(top, below, shape.area)
    scale = float(shape.chart.scale)

    def enclose(low: FloatArray, high: FloatArray) -> Interval:
        top, product, below, under, one = ((low[:, form], high[:, form]) for form in (0, 1, 2, 3, 4))
        square, factor = _root_factor(intervals.quotient(under, one))
        d, wide = np.sqrt(square), square[:, None, None]
        least, most = intervals.quotient(top, _sum(product, below, wide))
        return _scaled(_grown(intervals.outward(d * least, d * most), factor), 1.0 / scale)

    return equal(shape, [top, below * under, below, under, shape.arithmetic.constant(1)]), enclose


def curvatures(
    shape: Shape, sign: float, direction: FloatArray, of: Callable[[Interval, Interval, Pairs], Interval]
) -> Problem:
    """Return what K and H are quotients of, with one denominator, for a quantity of both.

    With the Q, D and φ of ``mean``, H = (Q D + d² Q) / (4 d f g D² φ).
    """
    top, edges = cancelled(shape.gauss, shape.both)
    mean, left = _mean_top(shape, sign)
    most = joint(edges, left)
    below = shape.area.multiplied(left)
    gauss = shape.even(mean, below, shape.weighted(top, 4).multiplied(less(most, edges)))[1]
    mean, under = shape.even(mean, below, shape.area)
    mean = mean.multiplied(less(most, left))
    forms = [gauss, (shape.area * under).multiplied(most), mean * under, mean, under, shape.arithmetic.constant(1)]
    scale = float(shape.chart.scale)

    def enclose(low: FloatArray, high: FloatArray) -> Interval:
        gauss, below, first, second, under, one = ((low[:, form], high[:, form]) for form in range(6))
        square, factor = _root_factor(intervals.quotient(under, one))
        four = 4.0 * np.sqrt(square)[:, None, None]
        low, high = _sum(first, second, square[:, None, None])
        top = _scaled(intervals.outward(low / four, high / four), 1.0 / scale)
        gauss = _scaled(gauss, scale**-2)
        pairs = Pairs.of(top, gauss, below, factor)
        return of(_shrunk(intervals.quotient(top, below), factor), intervals.quotient(gauss, below), pairs)

    return equal(shape, forms), enclose


def _mean_top(shape: Shape, sign: float) -> tuple[Form, Edges]:
    """Return Q w², and the f g that is left below it."""
    mean, left = cancelled(shape.mean, shape.both)
    return shape.weighted(mean if sign > 0.0 else -mean, 2), left


def _root_factor(under: Interval) -> tuple[FloatArray, FloatArray]:
    """Return a d² for each box, and the largest φ, from the range of the D under the root; infinite where unknown."""
    least, most = under
    known = np.isfinite(most) & (most > 0.0)
    square = np.where(known, 0.5 * (np.maximum(least, 0.0) + most), 1.0)  # any number above 0 will do
    with np.errstate(divide="ignore", invalid="ignore"):
        d = np.sqrt(square)
        grown = [np.where(least > 0.0, (end + square) / (2.0 * d * np.sqrt(end)), np.inf) for end in (least, most)]
        return square, np.maximum(*grown) * (1.0 + 2.0**-48)


def _sum(x: Interval, y: Interval, factor: FloatArray) -> Interval:
    """Return x + factor y, factor > 0, rounded outwards; exactly 0 where both are."""
    slack = 2.0**-50 * (np.abs(x[0]) + np.abs(x[1]) + factor * (np.abs(y[0]) + np.abs(y[1])))
    low, high = x[0] + factor * y[0], x[1] + factor * y[1]
    return low - slack * (low != 0.0), high + slack * (high != 0.0)


def _grown(x: Interval, factor: FloatArray) -> Interval:
    """Return x times what lies between 1 and a factor."""
    with np.errstate(invalid="ignore"):
        return np.where(x[0] < 0.0, x[0] * factor, x[0]), np.where(x[1] > 0.0, x[1] * factor, x[1])


def _shrunk(x: Interval, factor: FloatArray) -> Interval:
    """Return x over what lies between 1 and a factor."""
    with np.errstate(invalid="ignore"):
        return np.where(x[0] > 0.0, x[0] / factor, x[0]), np.where(x[1] < 0.0, x[1] / factor, x[1])


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
    return _angle(np.arccos(np.clip(high, 0.0, 1.0)), np.arccos(np.clip(low, 0.0, 1.0)), 0.0)


def elevation(low: FloatArray, high: FloatArray) -> Interval:
    """Return bounds of the angle of which the sine is given, in degrees."""
    return _angle(np.arcsin(np.clip(low, -1.0, 1.0)), np.arcsin(np.clip(high, -1.0, 1.0)), -90.0)


def _angle(low: FloatArray, high: FloatArray, least: float) -> Interval:
    """Return bounds in degrees; the C library's arcs are good to a few units in the last place of a right angle."""
    slack = 1e-14
    return np.maximum(np.degrees(low) - slack * 90.0, least), np.minimum(np.degrees(high) + slack * 90.0, 90.0)


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


def _of_both(pick: Callable[[Interval, Interval, Pairs], Interval]) -> Callable[[Shape, float, FloatArray], Problem]:
    return partial(curvatures, of=pick)


def _principal(mean: Interval, gauss: Interval, pairs: Pairs) -> tuple[Interval, Interval]:
    first, second = zip(intervals.principal(mean, gauss), pairs.principal(), strict=True)
    return both(*first), both(*second)


def _k1(mean: Interval, gauss: Interval, pairs: Pairs) -> Interval:
    return _principal(mean, gauss, pairs)[0]


def _k2(mean: Interval, gauss: Interval, pairs: Pairs) -> Interval:
    return _principal(mean, gauss, pairs)[1]


def _curvedness(mean: Interval, gauss: Interval, pairs: Pairs) -> Interval:
    return both(intervals.curvedness(mean, gauss), pairs.curvedness())


def _radius(mean: Interval, gauss: Interval, pairs: Pairs) -> Interval:
    return intervals.inverse(*intervals.largest(*_principal(mean, gauss, pairs)))


MEASURES: dict[str, Measure] = {
    measure.key: measure
    for measure in (
        Measure("gaussian", -2, gauss, gauss_sign),
        Measure("mean", -1, mean, mean_sign),
        Measure("k1", -1, _of_both(_k1)),
        Measure("k2", -1, _of_both(_k2)),
        Measure("curvedness", -1, _of_both(_curvedness)),
        Measure("curvature_radius", 1, _of_both(_radius)),
        Measure("slope", 0, slope, degrees=True),
        Measure("draft", 0, draft, draft_sign, degrees=True),
    )
}
"""The quantities that have a proof."""

REGULAR = Measure("regular", 0, regular)
UPRIGHT = np.array([0.0, 0.0, 1.0])
