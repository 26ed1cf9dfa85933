"""Quintic trigonometric (or classical) Bézier curves in the plane or in space."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import Functions
from quintrig.basis.pairs import check_count, families, pair, parameters
from quintrig.basis.registry import DEFAULT, Choice
from quintrig.geometry.curve_queries import Queries
from quintrig.geometry.origin import local_origin
from quintrig.support.arrays import FloatArray, frozen, number, parameter, whole
from quintrig.support.display import Shown
from quintrig.support.legendre import legendre
from quintrig.support.pickled import Pickled

_SINGULAR = 1e-13  # speed below this share of the polygon's length: the tangent is lost to rounding


@dataclass(frozen=True, eq=False)
class Curve(Queries, Pickled, Shown):
    """z(t) = Σ P_i f_i(t), t in [0, 1] (thesis eq. 2.1).

    ``points`` is (6, 2) or (6, 3), as many as another ``basis`` has functions; ``alpha`` and ``zeta`` are in [-4, 1]
    and act at t = 0 and t = 1. ``shape`` holds the shape parameters of any basis, in its order, in their place. Raises
    ValueError for wrong counts, values or shape parameters.
    """

    points: FloatArray
    alpha: float = 0.0
    zeta: float = 0.0
    basis: Choice = DEFAULT
    unchecked_shape: bool = False
    shape: tuple[float, ...] | None = None

    def __init__(
        self,
        points: ArrayLike,
        alpha: float = 0.0,
        zeta: float = 0.0,
        basis: Choice = DEFAULT,
        unchecked_shape: bool = False,
        shape: Sequence[float] | None = None,
    ) -> None:
        """Copy and check the points, then the basis that goes with them."""
        object.__setattr__(self, "points", frozen(points, "points", (None, 2), (None, 3)))
        object.__setattr__(self, "alpha", number(alpha, "alpha"))
        object.__setattr__(self, "zeta", number(zeta, "zeta"))
        object.__setattr__(self, "basis", basis)
        object.__setattr__(self, "unchecked_shape", unchecked_shape)
        object.__setattr__(self, "shape", None if shape is None else tuple(frozen(shape, "shape", (None,)).tolist()))
        _ = self.functions

    def __repr__(self) -> str:
        """Return one line: points and basis."""
        count, dimension = self.points.shape
        shape = f", alpha {self.alpha:g}, zeta {self.zeta:g}" if self.basis == "trigonometric" else ""
        return f"<Curve of {count} points in {dimension}D: {self.basis}{shape}>"

    @property
    def functions(self) -> Functions:
        """The basis functions f_i."""
        (choice, _), points, shape = pair(self.basis), len(self.points), self.shape
        check_count(choice, points, "points")
        names = [one.name for one in parameters(choice, points)]
        if shape is None and names == ["alpha", "zeta"]:
            shape = (self.alpha, self.zeta)
        elif (self.alpha or self.zeta) and names:
            raise ValueError(f"alpha, zeta: this basis has {', '.join(names)}; give their values as shape=[...]")
        return families((choice,), (points,), ("points",), shape, self.unchecked_shape)[0]

    @property
    def caveats(self) -> tuple[str, ...]:
        """What a reader must be warned of, of the basis: one sentence each."""
        return tuple(line.replace("the surface", "the curve") for line in self.functions.caveats)

    def __call__(self, t: ArrayLike) -> FloatArray:
        """Return points, shape (*t.shape, 2 or 3), length¹; ValueError for t outside [0, 1]."""
        return self.derivatives(t, 0)[0]

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order`` by t, shape (order + 1, *t.shape, 2 or 3), length¹."""
        family = self.functions
        functions = family.derivatives(parameter(t, "t"), whole(order, "order", 0))
        # The derivatives of a basis sum to 0, so that far from the origin they need not see how far.
        origin = local_origin(self.points) if family.partition else 0.0
        result = functions @ (self.points - origin)
        result[0] += origin
        return result

    def curvature(self, t: ArrayLike) -> FloatArray:
        """Return the curvature |z' x z''| / |z'|³ >= 0, shape t.shape, length⁻¹; NaN where the speed vanishes."""
        factor, first, second = self.hodograph(t, 2)
        return _norm(_cross(first, second)) / (factor * self._speed(first, factor) ** 3)

    def signed_curvature(self, t: ArrayLike) -> FloatArray:
        """Return the signed curvature of a plane curve, positive where it turns left, length⁻¹.

        Raises ValueError for a curve in space, where only ``curvature`` has a meaning.
        """
        if self.points.shape[1] != 2:
            raise ValueError("signed_curvature: expected a plane curve (n x 2 points); in space use curvature")
        factor, first, second = self.hodograph(t, 2)
        turn = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
        return turn / (factor * self._speed(first, factor) ** 3)

    def torsion(self, t: ArrayLike) -> FloatArray:
        """Return the torsion det(z', z'', z''') / |z' x z''|², length⁻¹; NaN where curvature or speed vanishes."""
        factor, first, second, third = self.hodograph(t, 3)
        factor = np.where(np.isnan(self._speed(first, factor)), np.nan, factor)
        normal = _cross(first, second)
        square = (normal**2).sum(axis=-1)
        # Rounding of a vanishing cross product is of this size; below it the quotient means nothing.
        noise = (1e-13 * _norm(first) * np.maximum(_norm(second), self._polygon())) ** 2
        square = np.where(square <= noise, np.nan, square)
        return (normal * _in_space(third)).sum(axis=-1) / (factor * square)

    def length(self, start: float = 0.0, end: float = 1.0, tolerance: float = 1e-12) -> float:
        """Return the arc length between two parameters (negative when they are reversed), length¹.

        Gauss-Legendre with 16 nodes a panel; a panel is halved until that changes it by no more than the relative
        ``tolerance`` of the whole, or than rounding, so that only the panels around a cusp grow small. Raises
        ValueError for parameters outside [0, 1] or a tolerance that is not positive.
        """
        if not number(tolerance, "tolerance") > 0.0:
            raise ValueError(f"tolerance: expected a number greater than 0, found {tolerance:g}")
        ends = parameter([start, end], "t")
        low, high = ends[:1], ends[1:]
        before = self._lengths(low, high)
        total = 0.0
        while low.size:
            middle = 0.5 * (low + high)
            first, second = self._lengths(low, middle), self._lengths(middle, high)
            now = first + second
            least = 0.1 * tolerance * max(abs(total + now.sum()), 1e-3 * self._polygon())
            done = np.abs(now - before) <= np.maximum(least, 8.0 * np.finfo(np.float64).eps * np.abs(now))
            total += float(now[done].sum())
            low, high = np.concatenate([low[~done], middle[~done]]), np.concatenate([middle[~done], high[~done]])
            before = np.concatenate([first[~done], second[~done]])
        return total

    def comb(self, t: ArrayLike, scale: float | Literal["auto"] = "auto") -> FloatArray:
        """Return the tips of the curvature comb, shape (*t.shape, 2 or 3), length¹.

        A tooth at z(t) points away from the centre of curvature and has length ``scale`` times the curvature, so
        ``scale`` is in length²; "auto" makes the longest tooth a quarter of the control polygon's length. NaN where the
        speed vanishes.
        """
        point, (factor, first, second) = self(t), self.hodograph(t, 2)
        speed = self._speed(first, factor)[..., None]
        bend = second / speed**2 - first * ((first * second).sum(axis=-1, keepdims=True) / speed**4)
        bend = bend / np.where(np.isnan(speed), np.nan, factor[..., None])
        if scale == "auto":
            longest = np.nanmax(_norm(bend), initial=0.0)
            straight = longest * self._polygon() <= 1e-10  # no teeth made of rounding
            scale = 0.0 if straight else 0.25 * self._polygon() / longest
        return point - number(scale, "scale") * bend

    def _polygon(self) -> float:
        return float(_norm(np.diff(self.points, axis=0)).sum())

    def hodograph(self, t: ArrayLike, order: int) -> tuple[FloatArray, ...]:
        """Return f, R and derivatives of R, ``order`` + 1 arrays, with z' = f R.

        f is sin or cos where the curve stands still at an end, else 1. Beside such an end the derivatives of z are
        nearly parallel, and their products cancel; those of R are not. By them z' x z" = f² R x R', and the product
        det(z', z", ...) of three is f³ det(R, R', R").
        """
        t = parameter(t, "t")
        steps = self.functions.split(self.points)[1:]
        factor, slopes = self.functions.hodograph(t, order - 1, self.functions.standing(steps))
        return factor, *(slopes @ steps)

    def _speed(self, first: FloatArray, factor: FloatArray) -> FloatArray:
        """Return |R|, NaN where the speed f |R| vanishes."""
        speed = _norm(first)
        return np.where(factor * speed <= _SINGULAR * self._polygon(), np.nan, speed)

    def _lengths(self, low: FloatArray, high: FloatArray) -> FloatArray:
        nodes, weights = legendre(16)
        half = 0.5 * (high - low)
        t = 0.5 * (low + high)[:, None] + half[:, None] * nodes
        return half * (_norm(self.derivatives(np.clip(t, 0.0, 1.0), 1)[1]) @ weights)


def _norm(vectors: FloatArray) -> FloatArray:
    return np.sqrt((vectors**2).sum(axis=-1))


def _in_space(vectors: FloatArray) -> FloatArray:
    missing = 3 - vectors.shape[-1]
    return np.pad(vectors, [(0, 0)] * (vectors.ndim - 1) + [(0, missing)])


def _cross(x: FloatArray, y: FloatArray) -> FloatArray:
    return np.cross(_in_space(x), _in_space(y))
