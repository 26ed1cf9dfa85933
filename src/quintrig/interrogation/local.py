"""A surface at points to third order: forms, shape operator, principal directions, and how curvature changes."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from quintrig.analysis.sample import analyse
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray


def dot(a: FloatArray, b: FloatArray) -> FloatArray:
    """Return a · b along the last axis."""
    return np.einsum("...k,...k->...", a, b)


@dataclass(frozen=True, eq=False)
class Forms:
    """First and second fundamental form (...) of a surface, and what follows from them.

    The frame is e1 along S_u and e2 = n0 × e1 with n0 along S_u × S_v. Singular points give NaN.
    """

    first: tuple[FloatArray, FloatArray, FloatArray]
    second: tuple[FloatArray, FloatArray, FloatArray]

    @staticmethod
    def of(surface: Surface, u: FloatArray, v: FloatArray) -> "Forms":
        """Return the forms by the compiled analysis."""
        s = analyse(surface, u, v, ("E", "F", "G", "L", "M", "N"), threads=1)
        return Forms((s["E"], s["F"], s["G"]), (s["L"], s["M"], s["N"]))

    @cached_property
    def area(self) -> FloatArray:
        """W = |S_u × S_v| (...), length²; NaN where it vanishes."""
        e, f, g = self.first
        square = e * g - f * f
        return np.sqrt(np.where(square > 0.0, square, np.nan))

    @cached_property
    def frame(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """p, q, r (...): e1 = (p, 0) and e2 = (q, r) in du and dv."""
        e, f, _ = self.first
        root = np.sqrt(e)
        with np.errstate(divide="ignore", invalid="ignore"):
            return 1.0 / root, -f / (self.area * root), root / self.area

    @cached_property
    def shape(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """M11, M12, M22 (...) of the shape operator in the frame, 1/length."""
        (ll, m, n), (p, q, r) = self.second, self.frame
        return p * p * ll, p * (q * ll + r * m), q * q * ll + 2.0 * q * r * m + r * r * n

    @cached_property
    def half(self) -> tuple[FloatArray, FloatArray]:
        """(M11 - M22)/2 and M12 (...): twice the angle of the direction of κ1 is that of this vector."""
        a, b, c = self.shape
        return 0.5 * (a - c), b

    @cached_property
    def spread(self) -> FloatArray:
        """(κ1 - κ2)/2 (...), 1/length."""
        return np.hypot(*self.half)

    @property
    def mean(self) -> FloatArray:
        """H (...), 1/length."""
        return 0.5 * (self.shape[0] + self.shape[2])

    @property
    def gaussian(self) -> FloatArray:
        """K (...), 1/length²."""
        a, b, c = self.shape
        return a * c - b * b

    def curvature(self, family: int) -> FloatArray:
        """κ1 (``family`` 1) or κ2 (...), 1/length."""
        return self.mean + (self.spread if family == 1 else -self.spread)

    @cached_property
    def angle(self) -> FloatArray:
        """Angle of the direction of κ1 from e1 (...), radians; NaN at exact umbilics."""
        a, b = self.half
        return np.where(self.spread > 0.0, 0.5 * np.arctan2(b, a), np.nan)

    def along(self, angle: FloatArray) -> FloatArray:
        """Return (du, dv) of unit length in space, (..., 2), at angles from e1."""
        p, q, r = self.frame
        c, s = np.cos(angle), np.sin(angle)
        return np.stack([c * p + s * q, s * r], axis=-1)


@dataclass(frozen=True, eq=False)
class Local(Forms):
    """Forms with the partial derivatives (order + 1, order + 1, ..., 3) that they are made of.

    ``sign`` turns the normal of all curvatures.
    """

    partials: FloatArray
    sign: float
    up: FloatArray

    @staticmethod
    def at(surface: Surface, u: ArrayLike, v: ArrayLike, order: int = 2) -> "Local":
        """Return the surface at parameters u and v that broadcast; without second form where ``order`` is 1."""
        p = surface.partials(u, v, order)
        su, sv = p[1, 0], p[0, 1]
        across = np.cross(su, sv)
        size = np.sqrt(dot(across, across))
        up = across / np.where(size > 0.0, size, np.nan)[..., None]
        n = surface.sign * up
        nothing = np.full(size.shape, np.nan)
        second = (dot(p[2, 0], n), dot(p[1, 1], n), dot(p[0, 2], n)) if order > 1 else (nothing, nothing, nothing)
        found = Local((dot(su, su), dot(su, sv), dot(sv, sv)), second, p, surface.sign, up)
        found.__dict__["area"] = np.where(size > 0.0, size, np.nan)  # with more digits than E G - F² has
        return found

    @property
    def point(self) -> FloatArray:
        """Points (..., 3), length¹."""
        return self.partials[0, 0]

    @property
    def su(self) -> FloatArray:
        """S_u (..., 3)."""
        return self.partials[1, 0]

    @property
    def sv(self) -> FloatArray:
        """S_v (..., 3)."""
        return self.partials[0, 1]

    @property
    def normal(self) -> FloatArray:
        """The surface's unit normal (..., 3)."""
        return self.sign * self.up

    def lifted(self, step: FloatArray) -> FloatArray:
        """Return the vector in space (..., 3) of (du, dv)."""
        return step[..., :1] * self.su + step[..., 1:2] * self.sv

    def lowered(self, vector: FloatArray) -> FloatArray:
        """Return (du, dv) of the part of a vector in space (..., 3) that is tangent."""
        e, f, g = self.first
        x, y = dot(vector, self.su), dot(vector, self.sv)
        return np.stack([g * x - f * y, e * y - f * x], axis=-1) / (self.area * self.area)[..., None]

    @cached_property
    def christoffel(self) -> FloatArray:
        """Γ (..., 2, 3): of u and v, for uu, uv and vv."""
        p = self.partials
        return np.stack([self.lowered(p[2, 0]), self.lowered(p[1, 1]), self.lowered(p[0, 2])], axis=-1)

    @cached_property
    def cubic(self) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """C111, C112, C122, C222 (...) in the frame, 1/length²: the covariant derivative of the second form.

        It is symmetric (Codazzi), and C(t, t, t) is the change of a principal curvature along its own direction t.
        Needs partials to third order.
        """
        p, n, gamma = self.partials, self.normal, self.christoffel
        h = ((self.second[0], self.second[1]), (self.second[1], self.second[2]))
        third = (p[3, 0], p[2, 1], p[1, 2], p[0, 3])
        found: list[FloatArray] = []
        for count, vector in enumerate(third):  # ``count`` of the three directions are v
            i, j, k = (0 if slot < 3 - count else 1 for slot in range(3))
            rest = np.zeros(vector.shape[:-1])
            for one, two, other in ((i, j, k), (k, i, j), (k, j, i)):
                rest = rest + gamma[..., 0, one + two] * h[0][other] + gamma[..., 1, one + two] * h[1][other]
            found.append(dot(vector, n) - rest)
        a, b, c, d = found
        p1, q, r = self.frame
        return (
            p1**3 * a,
            p1 * p1 * (q * a + r * b),
            p1 * (q * q * a + 2.0 * q * r * b + r * r * c),
            q**3 * a + 3.0 * q * q * r * b + 3.0 * q * r * r * c + r**3 * d,
        )

    def change(self, angle: FloatArray) -> FloatArray:
        """Return C(t, t, t) (...), 1/length², for unit tangents t at angles from e1."""
        a, b, c, d = self.cubic
        x, y = np.cos(angle), np.sin(angle)
        return a * x**3 + 3.0 * b * x * x * y + 3.0 * c * x * y * y + d * y**3
