"""Curves and surfaces in exact rational form, which CAD systems read: NURBS that are the same point sets.

Tensor-product, symmetric, swept and swung surfaces are of bidegree (10, 10), ruled ones (10, 1), enveloping
developables (18, 1), all lower where the shape parameters allow (8 and 14 for α = ζ = 0). The parameters differ:
``to_exact`` and ``from_exact`` of each form go from one to the other.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.bernstein import Bernstein, TangentBernstein
from quintrig.basis.bspline import BSpline, clamped
from quintrig.basis.rational import RIGHT_ANGLE, NotRationalError, TangentMap
from quintrig.geometry.curve import Curve
from quintrig.geometry.envelope import Envelope
from quintrig.geometry.nurbs import nurbs
from quintrig.geometry.surface import Net, Surface
from quintrig.support.arrays import FloatArray, parameter

LARGEST_RATIO = 1e6
"""Largest ratio of weights that is handed to CAD systems; beyond, interior knots are added."""

_MOST_KNOTS = 255


@dataclass(frozen=True, eq=False)
class ExactCurve:
    """A rational B-spline curve: ``points`` (n, 2 or 3), length¹, positive ``weights`` (n,), x = ``map``.forward(t)."""

    basis: BSpline
    points: FloatArray
    weights: FloatArray
    map: TangentMap

    def __call__(self, x: ArrayLike) -> FloatArray:
        """Return points at the exact form's own parameter x in [0, 1], shape (*x.shape, 2 or 3), length¹."""
        blend = self.basis.derivatives(x, 0)[0] * self.weights
        return blend @ self.points / blend.sum(axis=-1, keepdims=True)


@dataclass(frozen=True, eq=False)
class ExactSurface:
    """A NURBS surface equal to a quintrig surface: ``points`` (n, m, 3), length¹, and positive ``weights`` (n, m).

    ``maps`` turn (u, v) into its own parameters (x, y), all in [0, 1]. With ``projective`` rulings, y depends on x
    too: the boundaries of a developable strip whose bounding planes are not parallel have different weights.
    """

    u: BSpline
    v: BSpline
    points: FloatArray
    weights: FloatArray
    maps: tuple[TangentMap, TangentMap]
    projective: bool = False
    flip: bool = False

    @property
    def degrees(self) -> tuple[int, int]:
        """The bidegree."""
        return self.u.degree, self.v.degree

    @property
    def rational(self) -> bool:
        """Whether the weights differ."""
        return bool((self.weights != self.weights[0, 0]).any())

    def to_exact(self, u: ArrayLike, v: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return x, y of the point that the surface has at u, v; ValueError outside [0, 1]."""
        x, y = self.maps[0].forward(u), self.maps[1].forward(v)
        if not self.projective:
            return x, y
        first, second = self._boundary_weights(x)
        return x, y * first / (y * first + (1.0 - y) * second)

    def from_exact(self, x: ArrayLike, y: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return u, v of the point that the exact form has at x, y; ValueError outside [0, 1]."""
        x, y = parameter(x, "x"), parameter(y, "y")
        if self.projective:
            first, second = self._boundary_weights(x)
            y = y * second / (y * second + (1.0 - y) * first)
        return self.maps[0].backward(x), self.maps[1].backward(y)

    def surface(self) -> Surface:
        """Return the exact form as a surface of its own, over (x, y)."""
        return nurbs(self.points, self.weights, self.degrees, (self.u.knots, self.v.knots), flip=self.flip)

    def _boundary_weights(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        weights = self.u.derivatives(x, 0)[0] @ self.weights
        return weights[..., 0], weights[..., 1]


def exact_curve(curve: Curve) -> ExactCurve:
    """Return the exact rational form of a curve, of degree 10 (8 for α = ζ = 0) or its own degree if classical."""
    form = curve.functions.rational()
    points = (form.coefficients @ curve.points) / form.weights[:, None]
    return ExactCurve(BSpline(form.knots, form.degree), points, form.weights, form.map)


def exact_surface(surface: Surface) -> ExactSurface:
    """Return the exact rational form of a surface.

    Raises NotRationalError for a catenoid, a helicoid and whatever else has none, and ValueError where a developable
    strip reaches infinity.
    """
    if isinstance(surface.rows, Envelope):
        return _strip(surface, surface.rows)
    if not isinstance(surface.rows, Net):
        raise NotRationalError(f"rows of type {type(surface.rows).__name__} have no exact rational form")
    rows, blend = surface.rows.functions.rational(), surface.blend.rational()
    control = np.einsum("ki,lj,ijx->klx", rows.coefficients, blend.coefficients, surface.rows.points)
    weights = np.outer(rows.weights, blend.weights)
    if surface.rational:
        control, weights = control[..., :3], control[..., 3]
    u, v = BSpline(rows.knots, rows.degree), BSpline(blend.knots, blend.degree)
    points = control / weights[..., None] + surface.origin
    return ExactSurface(u, v, points, weights, (rows.map, blend.map), flip=surface.flip)


def _strip(surface: Surface, rows: Envelope) -> ExactSurface:
    """Return the form of a strip between two rational boundaries, in as many spans as positive weights need."""
    net = rows.homogeneous
    if surface.blend != Bernstein(1):
        raise NotRationalError("only a strip with straight rulings has an exact rational form here")
    degree = net.functions.size - 1
    turned = isinstance(net.functions, TangentBernstein)
    change = RIGHT_ANGLE if turned else TangentMap()
    control = net.points * (2.0 ** (-0.5 * np.arange(degree + 1)) if turned else np.ones(degree + 1))[:, None, None]
    weights = control[..., 3]
    _check_finite(weights, change)
    # Each boundary may be scaled: positive, and both of weight 1 in the middle of the ruling's weight.
    middle = Bernstein(degree).derivatives(0.5, 0)[0] @ weights
    control = control / middle[:, None]
    parallel = np.abs(control[:, 0, 3] - control[:, 1, 3]).max() <= 1e-14 * np.abs(control[..., 3]).max()
    if parallel:
        control[:, 1, 3] = control[:, 0, 3]
    basis, control = _positive(control)
    points, weights = control[..., :3] / control[..., 3:] + surface.origin, control[..., 3]
    across = clamped([0.0, 1.0], 1, 1)
    return ExactSurface(
        basis, across, points, weights, (change, TangentMap()), projective=not parallel, flip=surface.flip
    )


def _check_finite(weights: FloatArray, change: TangentMap) -> None:
    """Refuse a strip where a weight function vanishes: a ruling is parallel to its bounding plane there."""
    x = np.linspace(0.0, 1.0, 1025)
    values = Bernstein(len(weights) - 1).derivatives(x, 0)[0] @ weights
    small = np.abs(values) <= 1e-9 * np.abs(values).max(axis=0)
    turns = np.sign(values[1:]) != np.sign(values[:-1])
    bad = np.argwhere(small[1:] | small[:-1] | turns)
    if len(bad):
        at = float(change.backward(x[bad[0][0]]))
        raise ValueError(
            f"the strip reaches infinity near u = {at:.4g}, where a ruling does not meet bounding plane {bad[0][1]}: "
            "it has no form with positive weights; move that plane"
        )


def _positive(control: FloatArray) -> tuple[BSpline, FloatArray]:
    """Insert equally spaced simple knots into a Bézier form (n + 1, 2, 4) until all weights are positive and near."""
    degree = len(control) - 1
    pieces = 1
    while True:
        basis = clamped(np.linspace(0.0, 1.0, pieces + 1), degree, 1)
        refined = blossomed(control, basis)
        weights = refined[..., 3]
        if weights.min() > 0.0 and weights.max() <= LARGEST_RATIO * weights.min():
            return basis, refined
        if pieces > _MOST_KNOTS:
            if weights.min() > 0.0:
                return basis, refined
            raise ValueError(f"no form with positive weights was found with {pieces} spans; move the bounding planes")
        pieces *= 2


def blossomed(control: FloatArray, basis: BSpline) -> FloatArray:
    """Return the coefficients over ``basis`` of a polynomial given in Bernstein form (n + 1, ...) of the same degree.

    Coefficient i is the blossom at the knots i + 1, ..., i + degree (Ramshaw 1989): de Casteljau with another knot in
    every step.
    """
    degree = basis.degree
    result: list[FloatArray] = []
    for i in range(basis.size):
        values = control
        for knot in basis.knots[i + 1 : i + degree + 1]:
            values = (1.0 - knot) * values[:-1] + knot * values[1:]
        result.append(values[0])
    return np.stack(result)


def weight_ratio(form: ExactSurface | ExactCurve) -> float:
    """Return the largest weight over the smallest."""
    return float(form.weights.max() / form.weights.min()) if form.weights.size else math.nan
