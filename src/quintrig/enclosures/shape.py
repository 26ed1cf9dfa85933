"""What curvature is made of, as forms: numerators and denominators over one chart.

With S_u = f X and S_v = g Y, f and g the powers of u, 1 - u, v, 1 - v that divide them (none as a rule; u where α = -4,
where control points coincide, and at a pole), let N = X x Y, D = N·N, λ = X_u·N, μ = X_v·N, ρ = Y_u·N, ν = Y_v·N. Then
N is the direction of the normal also where S_u or S_v vanishes, and

    K = P / (f g D²), P = λν - μρ,    H = Q / (2 f g D^1.5), Q = f (X·X) ν - (X·Y)(f μ + g ρ) + g (Y·Y) λ.

In homogeneous coordinates (A, w) it is w² S_u = w A_u - w_u A = f X that is divided: then w⁴ P and w² Q take the place
of P and Q. Subscripts of X and Y are brackets with σ (``basis.exact_forms``): derivatives up to a factor.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol, Self

import numpy as np

from quintrig.basis.exact_forms import POLYNOMIAL
from quintrig.basis.exact_numbers import Exact
from quintrig.enclosures.ball import Ball, Edges
from quintrig.enclosures.charts import Chart
from quintrig.enclosures.whole import InexactError, Whole


class Form(Protocol):
    """Forms in rounded or in exact arithmetic: ``Ball`` or ``Whole``."""

    @staticmethod
    def constant(value: object) -> "Form": ...  # noqa: D102
    @staticmethod
    def blend(u: Exact, net: Exact, v: Exact) -> "list[Form]": ...  # noqa: D102
    @property
    def degree(self) -> tuple[int, int]: ...  # noqa: D102
    @property
    def vanishes(self) -> bool: ...  # noqa: D102
    def __add__(self, other: Self) -> Self: ...
    def __sub__(self, other: Self) -> Self: ...
    def __neg__(self) -> Self: ...
    def __mul__(self, other: Self) -> Self: ...
    def bracket(self, axis: int, unit: Exact) -> Self: ...  # noqa: D102
    def edges(self) -> Edges: ...  # noqa: D102
    def divided(self, edges: Edges) -> Self: ...  # noqa: D102
    def multiplied(self, edges: Edges) -> Self: ...  # noqa: D102
    def halves(self, axis: int) -> "tuple[Form, Form]": ...  # noqa: D102
    def ball(self) -> Ball: ...  # noqa: D102


Vector = list[Form]
FREE: Edges = (0, 0, 0, 0)


def dot(x: Vector, y: Vector) -> Form:
    """Return the scalar product."""
    first, second, third = (a * b for a, b in zip(x, y, strict=True))
    return first + second + third


def cross(x: Vector, y: Vector) -> Vector:
    """Return the vector product."""
    return [x[i - 2] * y[i - 1] - x[i - 1] * y[i - 2] for i in range(3)]


@dataclass(frozen=True, eq=False)
class Shape:
    """The forms of one chart in one ``arithmetic``, ``Ball`` or ``Whole``, each worked out when first asked for."""

    chart: Chart
    arithmetic: Any  # the class, whose static methods build forms

    @cached_property
    def _tangents(self) -> tuple[Vector, Vector]:
        """w² S_u and w² S_v."""
        u, v, net = self.chart.u, self.chart.v, self.chart.net
        blend = self.arithmetic.blend
        along, across = blend(u.slopes, net, v.forms), blend(u.forms, net, v.slopes)
        if not self.chart.rational:
            return along, across
        point = blend(u.forms, net, v.forms)
        first, second = ([point[3] * slope[i] - slope[3] * point[i] for i in range(3)] for slope in (along, across))
        return first, second

    @cached_property
    def factors(self) -> tuple[Edges, Edges]:
        """The powers f and g, which exact arithmetic tells for rounded one where an edge may vanish."""
        first, second = self._tangents
        if self.arithmetic is Ball and any(_may_vanish(part) for part in (first, second)):
            try:
                return Shape(self.chart, Whole).factors
            except InexactError:
                pass
        return shared(first), shared(second)

    @cached_property
    def x(self) -> Vector:
        """S_u / f."""
        return [part.divided(self.factors[0]) for part in self._tangents[0]]

    @cached_property
    def y(self) -> Vector:
        """S_v / g."""
        return [part.divided(self.factors[1]) for part in self._tangents[1]]

    @cached_property
    def normal(self) -> Vector:
        """N = X x Y."""
        return cross(self.x, self.y)

    @cached_property
    def area(self) -> Form:
        """D = N·N."""
        return dot(self.normal, self.normal)

    def _second(self, vector: Vector, axis: int) -> Form:
        unit = (self.chart.u, self.chart.v)[axis].unit
        return dot([part.bracket(axis, unit) for part in vector], self.normal)

    @cached_property
    def second_form(self) -> tuple[Form, Form, Form, Form]:
        """λ, μ, ρ and ν."""
        return self._second(self.x, 0), self._second(self.x, 1), self._second(self.y, 0), self._second(self.y, 1)

    @cached_property
    def gauss(self) -> Form:
        """P, which has the sign of K."""
        lam, mu, rho, nu = self.second_form
        return lam * nu - mu * rho

    @cached_property
    def mean(self) -> Form:
        """Q, which has the sign of H along S_u x S_v."""
        lam, mu, rho, nu = self.second_form
        f, g = self.factors
        e, middle, last = dot(self.x, self.x), dot(self.x, self.y), dot(self.y, self.y)
        return (e * nu).multiplied(f) - middle * (mu.multiplied(f) + rho.multiplied(g)) + (last * lam).multiplied(g)

    @cached_property
    def weight(self) -> Form | None:
        """The weight w; None where it is 1."""
        if not self.chart.rational:
            return None
        return self.arithmetic.blend(self.chart.u.forms, self.chart.net[:, :, 3:], self.chart.v.forms)[0]

    def weighted(self, form: Form, power: int) -> Form:
        """Return a form times a power of the weight."""
        weight = self.weight
        if weight is not None:
            for _ in range(power):
                form = form * weight
        return form

    @property
    def hidden(self) -> bool:
        """Whether P may vanish where f g does, so that exact arithmetic is to say whether a factor is common."""
        ball = self.gauss.ball()
        none = np.abs(ball.middle) <= ball.radius
        sides = (none[0], none[-1], none[:, 0], none[:, -1])
        return any(power > 0 and bool(side.all()) for power, side in zip(self.both, sides, strict=True))

    @property
    def both(self) -> Edges:
        """The exponents of f g."""
        return _sum(*self.factors)

    @property
    def collapsing(self) -> Edges:
        """At which edges all of the edge is one point: where the tangent along it vanishes."""
        first, second = self.factors
        return (second[0], second[1], first[2], first[3])

    def even(self, mean: Form, below: Form, area: Form) -> tuple[Form, Form]:
        """Return Q and the D under the root, made of a degree whose powers of σ are whole."""
        for axis in (0, 1):
            if (mean.degree[axis] - below.degree[axis]) % 2:
                line = self._factor(np.array([1, 1], dtype=object), axis)
                mean, area = mean * line, area * line * line
        return mean, area

    def alike(self, form: Form, other: Form) -> Form:
        """Return a form times what is positive, so that its degrees are odd where those of another one are."""
        for axis in (0, 1):
            if (form.degree[axis] - other.degree[axis]) % 2:
                form = form * self._factor(np.array([1, 1], dtype=object), axis)
        return form

    def _factor(self, root: Exact, axis: int) -> Form:
        """Return a form along one axis as one of both."""
        one, plain = np.array([[1]], dtype=object), np.ones((1, 1, 1), dtype=object)
        column = root[:, None]
        return self.arithmetic.blend(one, plain, column)[0] if axis else self.arithmetic.blend(column, plain, one)[0]

    def raised(self, form: Form, to: tuple[int, int]) -> Form:
        """Return the same function as a form of bidegree ``to``, by powers of σ."""
        for axis, unit in ((0, self.chart.u.unit), (1, self.chart.v.unit)):
            factor = self._factor(np.array([1, 1], dtype=object) if unit is POLYNOMIAL else unit, axis)
            while form.degree[axis] < to[axis]:
                form = form * factor
        return form


def cancelled(numerator: Form, edges: Edges) -> tuple[Form, Edges]:
    """Return numerator and powers u, 1 - u, v, 1 - v of the denominator without what both have in common."""
    if not any(edges):
        return numerator, edges
    common = _least([numerator.edges(), edges])
    return numerator.divided(common), less(edges, common)


def shared(vector: Vector) -> Edges:
    """Return the powers of u, 1 - u, v and 1 - v that divide all of some forms."""
    return _least([part.edges() for part in vector if not part.vanishes])


def _may_vanish(vector: Vector) -> bool:
    """Return whether all of a vector may be 0 along an edge."""
    balls = [part.ball() for part in vector]
    near = np.logical_and.reduce([np.abs(ball.middle) <= ball.radius for ball in balls])
    return bool(near[0].all() or near[-1].all() or near[:, 0].all() or near[:, -1].all())


def _least(found: list[Edges]) -> Edges:
    a, b, c, d = (min(each) for each in zip(*found, strict=True)) if found else FREE
    return a, b, c, d


def joint(x: Edges, y: Edges) -> Edges:
    """Return the larger powers of both."""
    return max(x[0], y[0]), max(x[1], y[1]), max(x[2], y[2]), max(x[3], y[3])


def less(x: Edges, y: Edges) -> Edges:
    """Return the powers of a quotient."""
    return x[0] - y[0], x[1] - y[1], x[2] - y[2], x[3] - y[3]


def _sum(x: Edges, y: Edges) -> Edges:
    return x[0] + y[0], x[1] + y[1], x[2] + y[2], x[3] + y[3]
