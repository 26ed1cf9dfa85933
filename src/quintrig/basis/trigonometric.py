"""The quintic trigonometric Bézier basis with two shape parameters, and its exact rational form."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quintrig.basis.elementary import sin_cos
from quintrig.basis.functions import MOVING, Functions, Still
from quintrig.basis.rational import RIGHT_ANGLE, TangentMap, circle_weights
from quintrig.support import taylor
from quintrig.support.arrays import BoolArray, FloatArray, number, parameter
from quintrig.support.memory import address

if TYPE_CHECKING:
    from quintrig.basis import exact_forms

SHAPE_RANGE = (-4.0, 1.0)
"""Shape parameters in this range keep the trigonometric basis non-negative (Misro et al. 2017)."""


@dataclass(frozen=True)
class Trigonometric(Functions):
    """The six quintic trigonometric Bézier functions (Misro, Ramli and Ali 2017; thesis eq. 2.2).

    ``alpha`` acts at t = 0, ``zeta`` at t = 1, both in [-4, 1]; outside, ValueError unless ``unchecked``, and then
    functions turn negative and the convex-hull property is lost.
    """

    alpha: float = 0.0
    zeta: float = 0.0
    unchecked: bool = False

    def __post_init__(self) -> None:
        """Check both parameters once, at birth."""
        for name in ("alpha", "zeta"):
            object.__setattr__(self, name, shape_parameter(getattr(self, name), name, self.unchecked))

    @property
    def size(self) -> int:
        """Number of functions: six."""
        return 6

    @property
    def label(self) -> str:
        """The name of the basis."""
        return "trigonometric"

    @property
    def outside(self) -> bool:
        """Whether α or ζ is outside [-4, 1]."""
        return not all(SHAPE_RANGE[0] <= x <= SHAPE_RANGE[1] for x in (self.alpha, self.zeta))

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1: they do."""
        return True

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, 6); ValueError for t outside [0, 1].

        Each value is a product of s = sin, c = cos, a = 1 - s and b = 1 - c, none of which cancels, and each derivative
        a difference of ``slopes``: so all keep their relative accuracy at the end points, where a Fourier sum does not.
        """
        t = parameter(t, "t")
        s, c, a, b = (series[0] for series in sines(t, 0))
        values: list[FloatArray] = [
            a**4 * np.where(t < 0.5, 1.0 - self.alpha * s, 1.0 - self.alpha + self.alpha * a),
            s * a**3 * np.where(t < 0.5, 4.0 + self.alpha - self.alpha * s, 4.0 + self.alpha * a),
            a**2 * b * (8.0 * s + 3.0 * c + 9.0),
            b**2 * a * (8.0 * c + 3.0 * s + 9.0),
            c * b**3 * np.where(t < 0.5, 4.0 + self.zeta * b, 4.0 + self.zeta - self.zeta * c),
            b**4 * np.where(t < 0.5, 1.0 - self.zeta + self.zeta * b, 1.0 - self.zeta * c),
        ]
        result: FloatArray = np.empty((order + 1, *t.shape, 6))
        result[0] = np.stack(values, axis=-1)
        if order:
            slopes = self.slopes(t, order - 1)
            result[1:, ..., 0] = -slopes[..., 0]
            result[1:, ..., 1:5] = slopes[..., :4] - slopes[..., 1:]
            result[1:, ..., 5] = slopes[..., 4]
        return result

    def slopes(self, t: ArrayLike, order: int, start: bool = False, end: bool = False) -> FloatArray:
        """Return the functions of the hodograph z'(t) = Σ G_i(t) (P_{i+1} - P_i) and their derivatives.

        The shape is (order + 1, *t.shape, 5). G_i = -(f0' + ... + fi') >= 0 for α, ζ in [-4, 1]:

            G0 = (π/2) c a³ (4 + α - 5α s)      G4 = (π/2) s b³ (4 + ζ - 5ζ c)
            G1 = (π/2) 12 a² s c                G3 = (π/2) 12 b² s c
            G2 = (π/2) a b s c (32 + 4 / (1 + s + c))

        With ``start`` (``end``) all are divided by s (c), and 4 + α (4 + ζ) is left out: what remains where the curve
        stands still at that end, because α (ζ) is -4 or two control points coincide there. Raises ValueError for t
        outside [0, 1].
        """
        t = parameter(t, "t")
        s, c, a, b = sines(t, order)
        near_start = t < 0.5
        one = taylor.constant(1.0, s)
        rising, falling = one if start else s, one if end else c
        first = -5.0 * self.alpha * one if start else _outer_factor(self.alpha, s, a, near_start)
        last = -5.0 * self.zeta * one if end else _outer_factor(self.zeta, c, b, ~near_start)
        both, a2, b2 = taylor.product(rising, falling), taylor.product(a, a), taylor.product(b, b)
        middle = 32.0 * one + 4.0 * taylor.quotient(one, one + s + c)
        functions: list[FloatArray] = [
            taylor.product(falling, taylor.product(taylor.product(a2, a), first)),
            12.0 * taylor.product(a2, both),
            taylor.product(taylor.product(a, b), taylor.product(both, middle)),
            12.0 * taylor.product(b2, both),
            taylor.product(rising, taylor.product(taylor.product(b2, b), last)),
        ]
        return 0.5 * np.pi * taylor.derivatives(np.stack(functions, axis=-1))

    @property
    def parameters(self) -> dict[str, float]:
        """The shape parameters ``alpha`` and ``zeta``."""
        return {"alpha": self.alpha, "zeta": self.zeta}

    def increments(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` of the F_i, shape (order + 1, *t.shape, 5); ValueError outside [0, 1].

        ``slopes`` are sums of the functions' derivatives without cancellation.
        """
        values = super().increments(t, 0)
        return np.concatenate([values, self.slopes(t, order - 1)]) if order else values

    def standing(self, steps: FloatArray) -> Still:
        """Return at which ends Σ F_i ΔP_i stands still, with increments ``steps`` (5, ...).

        It does where the shape parameter is -4 or the two control points there coincide.
        """
        return self.alpha == -4.0 or not steps[0].any(), self.zeta == -4.0 or not steps[-1].any()

    def hodograph(self, t: FloatArray, order: int, still: Still) -> tuple[FloatArray, FloatArray]:
        """Return f, sin(πt/2) for a still start times cos(πt/2) for a still end, and the series of ``slopes`` / f."""
        s, c = sin_cos(t)
        return np.where(still[0], s, 1.0) * np.where(still[1], c, 1.0), self.slopes(t, order, *still)

    def fill(self, t: FloatArray, out: FloatArray, still: Still = MOVING) -> None:
        """Write derivatives 0 to 2 of the F_i at blocks of BLOCK parameters (blocks, BLOCK) to ``out``, compiled.

        Beside ends that are ``still`` the second are f (F_i' / f)'.
        """
        from quintrig.basis.trigonometric_jit import across, fill

        whole = out if out.flags.c_contiguous else np.empty(out.shape)
        flat = whole.reshape(len(t), -1)
        places, count = np.ascontiguousarray(t), len(t)
        fill(address(places), count, self.alpha, self.zeta, address(flat))
        if any(still):
            across(address(places), count, self.alpha, self.zeta, *still, address(flat))
        if whole is not out:
            out[...] = whole

    def tangent_map(self) -> TangentMap:
        """Return the map of a right angle."""
        return RIGHT_ANGLE

    def rational_degree(self) -> int:
        """Return 10, or 8 without shape parameters."""
        return 8 if self.alpha == self.zeta == 0.0 else 10

    def numerators(self, to: TangentMap, degree: int) -> FloatArray:
        """Return the numerators' coefficients (n, 6) in degree 8 or 10 over the common weights of ``to``."""
        control = degree_eight(np.eye(6)) if degree == 8 else degree_ten(np.eye(6), self.alpha, self.zeta)
        return control * to.weights(degree)[:, None]

    def exact(self) -> "tuple[exact_forms.Span, ...]":
        """Return the functions span by span as forms with exact coefficients."""
        from quintrig.basis import exact_forms  # a proof asks, no small command

        return exact_forms.trigonometric(self.alpha, self.zeta)


def shape_parameter(value: float, name: str, unchecked: bool = False) -> float:
    """Return a shape parameter as float; ValueError outside [-4, 1] unless ``unchecked``."""
    value = number(value, name)
    low, high = SHAPE_RANGE
    if not unchecked and not low <= value <= high:
        raise ValueError(
            f"{name} = {value:g} is outside [-4, 1], where the basis is non-negative; choose a value in the range, or "
            "set unchecked_shape = true and lose the convex-hull property"
        )
    return value


def sines(t: FloatArray, order: int) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Return the series of sine and cosine of πt/2, 1 - sine and 1 - cosine; none cancels, the ends are exact."""
    sine, cosine = sin_cos(t)
    s, c = _rotation(sine, cosine, order), _rotation(cosine, -sine, order)
    a, b = -s, -c
    a[0] = np.where(t < 0.5, 1.0 - sine, 2.0 * np.sin(0.25 * np.pi * (1.0 - t)) ** 2)
    b[0] = np.where(t < 0.5, 2.0 * np.sin(0.25 * np.pi * t) ** 2, 1.0 - cosine)
    return s, c, a, b


def _outer_factor(alpha: float, s: FloatArray, a: FloatArray, near: BoolArray) -> FloatArray:
    """Return the series of 4 + α - 5α s; from a = 1 - s where not ``near`` the end where s = 0."""
    series = -5.0 * alpha * s
    series[0] = np.where(near, 4.0 + alpha - 5.0 * alpha * s[0], 4.0 - 4.0 * alpha + 5.0 * alpha * a[0])
    return series


def _rotation(value: FloatArray, slope: FloatArray, order: int) -> FloatArray:
    """Return the series of a function with f'' = -(π/2)² f, from f and f' / (π/2)."""
    cycle = (value, slope, -value, -slope)
    rate = 0.5 * np.pi
    return np.stack([rate**k / math.factorial(k) * cycle[k % 4] for k in range(order + 1)])


WEIGHTS: FloatArray = circle_weights(10)
"""Weights of the eleven control points, which do not depend on the shape parameters: 1, 1, 10/9, ..., 32."""


def degree_ten(points: NDArray[Any], alpha: Any, zeta: Any) -> NDArray[Any]:
    """Return the eleven control points of the rational form, from six of shape (6, ...); length¹.

    With ``WEIGHTS`` they give the same curve in w = tan(πt/4), w in [0, 1] (Sánchez-Reyes 1998 for the principle).
    Exact arithmetic, such as arrays of fractions, passes through.
    """
    start = _half(points, alpha)
    end = _half(points[::-1], zeta)
    middle = (points[2] + points[3]) / 2
    return np.stack([*start, middle, *end[::-1]])


def degree_eight(points: NDArray[Any]) -> NDArray[Any]:
    """Return the nine control points for α = ζ = 0, which go with ``circle_weights(8)``; length¹."""
    p = points
    first, last = p[1] + 3 * (p[2] - p[1]) / 4, p[4] + 3 * (p[3] - p[4]) / 4
    return np.stack([p[0], p[1], first, p[2], (p[2] + p[3]) / 2, p[3], last, p[4], p[5]])


def homogeneous(points: FloatArray, alpha: float, zeta: float) -> FloatArray:
    """Return weight times control point in the lowest degree that α and ζ allow, 10 or 8: shape (11 or 9, ...)."""
    control = degree_eight(points) if alpha == zeta == 0.0 else degree_ten(points, alpha, zeta)
    return control * circle_weights(len(control) - 1).reshape(-1, *([1] * (control.ndim - 1)))


def _half(p: NDArray[Any], alpha: Any) -> list[NDArray[Any]]:
    """Return b_0 to b_4; written in differences, so that α = -4 gives b_1 = b_0 to the last bit."""
    return [
        p[0],
        p[0] + (4 + alpha) * (p[1] - p[0]) / 5,
        p[0] + ((12 + alpha) * (p[1] - p[0]) + 12 * (p[2] - p[0])) / 25,
        p[1] + 4 * (p[2] - p[1]) / 5,
        p[2] + (4 * (p[1] - p[2]) + 17 * (p[3] - p[2])) / 90,
    ]
