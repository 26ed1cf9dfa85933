"""The B-spline functions: rows and blend of surfaces that come from CAD files."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import Functions
from quintrig.basis.rational import HIGHEST_DEGREE, NotRationalError, RationalFunctions, TangentMap, clamped_knots
from quintrig.support.arrays import FloatArray, frozen, parameter

if TYPE_CHECKING:
    from quintrig.basis import exact_forms

CLOSEST = 1e-14
"""Least distance of two knots that are not equal, the domain being 1: nearer ones leave a parameter no digits."""


@dataclass(frozen=True)
class BSpline(Functions):
    """The B-spline functions N_i of a knot vector whose domain, knots[degree] to knots[-degree - 1], is [0, 1].

    At an interior knot of full multiplicity, where derivatives jump, those from the right are given. Build one with
    ``normalised`` from any other knots. Raises ValueError for knots that decrease or coincide too often.
    """

    knots: tuple[float, ...]
    degree: int

    def __post_init__(self) -> None:
        """Check the knots once, at birth."""
        p, count = self.degree, len(self.knots)
        if not 1 <= p <= HIGHEST_DEGREE:
            raise ValueError(f"degree: expected 1 to {HIGHEST_DEGREE}, found {p}")
        if count < 2 * p + 2:
            raise ValueError(f"knots: expected {2 * p + 2} or more for degree {p}, found {count}")
        knots = frozen(self.knots, "knots", (None,))
        _check_rising(knots)
        if knots[p] != 0.0 or knots[-p - 1] != 1.0:
            raise ValueError(f"knots: expected the domain [0, 1], found [{knots[p]:g}, {knots[-p - 1]:g}]")
        close = np.flatnonzero((np.diff(knots) > 0.0) & (np.diff(knots) < CLOSEST))
        if len(close):
            i = int(close[0]) + 1
            raise ValueError(
                f"knots[{i}]: expected neighbouring knots that are equal or at least {CLOSEST:g} of the domain apart, "
                f"found {knots[i] - knots[i - 1]:.3g}"
            )
        wide = knots[p + 1 :] - knots[: -p - 1]
        inner = knots[1:-1]
        if not (wide > 0.0).all() or (p < len(inner) and not (inner[p:] - inner[:-p] > 0.0).all()):
            raise ValueError(f"knots: expected no interior knot more than {p} times and no end knot more than {p + 1}")

    @property
    def size(self) -> int:
        """Number of functions."""
        return len(self.knots) - self.degree - 1

    @property
    def breaks(self) -> FloatArray:
        """The distinct knots of the domain, from 0 to 1: between two of them every function is one polynomial."""
        return np.unique(np.asarray(self.knots[self.degree : len(self.knots) - self.degree]))

    @property
    def partition(self) -> bool:
        """Whether the functions sum to 1: they do."""
        return True

    def derivatives(self, t: ArrayLike, order: int) -> FloatArray:
        """Return derivatives 0 to ``order``, shape (order + 1, *t.shape, size); ValueError for t outside [0, 1].

        Cox and de Boor's recursion for the values; a derivative is a difference of functions one degree lower
        (Piegl and Tiller 1997, eq. 2.5 and 2.7).
        """
        t = parameter(t, "t")
        knots = np.asarray(self.knots)
        last = self.size - 1
        span = np.clip(np.searchsorted(knots, t, side="right") - 1, self.degree, last)
        levels: list[FloatArray] = [np.zeros((*t.shape, len(knots) - 1))]
        np.put_along_axis(levels[0], span[..., None], 1.0, axis=-1)
        for degree in range(1, self.degree + 1):
            lower = levels[-1]
            per_width = _inverse(knots[degree:] - knots[:-degree])
            up = (t[..., None] - knots[:-degree]) * per_width * lower
            levels.append(up[..., :-1] + lower[..., 1:] - up[..., 1:])
        result: FloatArray = np.zeros((order + 1, *t.shape, self.size))
        for k in range(min(order, self.degree) + 1):
            values = levels[self.degree - k]
            for degree in range(self.degree - k + 1, self.degree + 1):
                slope = degree * _inverse(knots[degree:] - knots[:-degree]) * values
                values = slope[..., :-1] - slope[..., 1:]
            result[k] = values
        return result

    def rational(self) -> RationalFunctions:
        """Return the functions themselves, which are polynomials span by span."""
        return RationalFunctions(self.knots, self.degree, TangentMap(), np.ones(self.size), np.eye(self.size))

    def exact(self) -> "tuple[exact_forms.Span, ...]":
        """Return the functions span by span as forms with exact coefficients."""
        from quintrig.basis import exact_forms  # a proof asks, no small command

        return exact_forms.bspline(self.knots, self.degree)

    def rational_degree(self) -> int:
        """Refuse to be one part of several, whose spans would differ: NotRationalError."""
        raise NotRationalError("B-spline functions joined with others have no rational form here")

    def tangent_map(self) -> TangentMap:
        """Return the identity."""
        return TangentMap()


def normalised(knots: ArrayLike, degree: int) -> BSpline:
    """Return the B-spline functions over [0, 1] of knots over any interval; ValueError where they are not knots."""
    array = frozen(knots, "knots", (None,))
    if not 1 <= degree <= HIGHEST_DEGREE or len(array) < 2 * degree + 2:
        return BSpline(tuple(array.tolist()), degree)  # which says what is wrong
    _check_rising(array)  # in the user's numbers
    start, end = array[degree], array[-degree - 1]
    if not end > start:
        raise ValueError(f"knots: expected them to rise from {start:g} over the domain, found them to end at {end:g}")
    scaled = (array - start) / (end - start)
    # The ends must be 0 and 1 to the last bit, and equal knots stay equal.
    scaled = np.where(array == end, 1.0, scaled)
    return BSpline(tuple(scaled.tolist()), degree)


def clamped(breaks: ArrayLike, degree: int, multiplicity: int) -> BSpline:
    """Return the functions with end knots of full multiplicity and interior ``breaks`` of the given multiplicity."""
    array = frozen(breaks, "breaks", (None,))
    return normalised(clamped_knots(array, degree, multiplicity), degree)


def _check_rising(knots: FloatArray) -> None:
    falling = np.flatnonzero(np.diff(knots) < 0.0)
    if len(falling):
        i = int(falling[0]) + 1
        raise ValueError(
            f"knots[{i}]: expected at least {knots[i - 1]:.17g}, the knot before it, found {knots[i]:.17g}"
        )


def _inverse(width: FloatArray) -> FloatArray:
    """Return 1 / width, and 0 where knots coincide: those functions vanish."""
    return np.divide(1.0, width, out=np.zeros_like(width), where=width > 0.0)
