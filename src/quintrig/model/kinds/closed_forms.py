"""Kinds with curvature in closed form."""

from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from quintrig.basis.elementary import Circular, Hyperbolic, Powers
from quintrig.basis.joined import Joined
from quintrig.geometry import closed_forms as reference
from quintrig.geometry.surface import Net, Surface
from quintrig.model.kinds.definition import Definition, Keys, Number, Positive

_ALIKE = 1e-12  # of the size: closer than this, two surfaces are one


class ClosedForm(Definition):
    """Keys of a surface with curvature in closed form."""

    @classmethod
    def sizes(cls, rows: Net) -> dict[str, float] | None:
        """Return the sizes that the coefficients of rows would say, were the surface of this kind; None if it is not.

        What they build is compared with the surface afterwards.
        """
        return None

    @classmethod
    def recognised(cls, surface: Surface) -> Keys | None:
        """Return the keys of which this kind would build the surface, or None."""
        rows = surface.rows
        sizes = cls.sizes(rows) if isinstance(rows, Net) and rows.dimension == 3 else None
        if not sizes or not all(0.0 < abs(value) < np.inf for value in sizes.values()):
            return None
        try:
            plain = cls.model_validate(sizes).surface()
        except ValueError:  # a radius below zero, say
            return None
        return {**sizes, "flip": plain.flip != surface.flip} if _alike(plain, surface) else None


class Sphere(ClosedForm):
    """Sphere."""

    title = "Sphere"
    words = "A sphere of radius r; its poles are singular points."
    formula = r"x^2+y^2+z^2=r^2"
    starter: ClassVar[Keys] = {"radius": 20}
    kind: Literal["sphere"] = "sphere"
    radius: Positive = Field(default=1.0, description="Radius")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.sphere(self.radius, flip=self.flip)

    @classmethod
    def sizes(cls, rows: Net) -> dict[str, float] | None:
        """Return the sizes that the coefficients would say, or None."""
        fits = isinstance(rows.functions, Circular) and rows.points.shape[:2] == (2, 3)
        return {"radius": float(rows.points[0, 0, 0])} if fits else None


class Ellipsoid(ClosedForm):
    """Ellipsoid x²/a² + y²/b² + z²/c² = 1."""

    title = "Ellipsoid"
    words = "An ellipsoid with half axes a, b and c; its poles are singular points."
    formula = r"\frac{x^2}{a^2}+\frac{y^2}{b^2}+\frac{z^2}{c^2}=1"
    starter: ClassVar[Keys] = {"a": 30, "b": 20, "c": 10}
    kind: Literal["ellipsoid"] = "ellipsoid"
    a: Positive = Field(default=3.0, description="Half axis along x")
    b: Positive = Field(default=2.0, description="Half axis along y")
    c: Positive = Field(default=1.0, description="Half axis along z")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.ellipsoid(self.a, self.b, self.c, flip=self.flip)

    @classmethod
    def sizes(cls, rows: Net) -> dict[str, float] | None:
        """Return the sizes that the coefficients would say, or None."""
        fits = isinstance(rows.functions, Circular) and rows.points.shape[:2] == (2, 3)
        return (
            {"a": float(rows.points[0, 0, 0]), "b": float(rows.points[0, 1, 1]), "c": float(rows.points[1, 2, 2])}
            if fits
            else None
        )


class Cylinder(ClosedForm):
    """Circular cylinder."""

    title = "Circular cylinder"
    words = "A cylinder of radius r and height h."
    formula = r"x^2+y^2=r^2,\quad 0\le z\le h"
    starter: ClassVar[Keys] = {"radius": 10, "height": 40}
    kind: Literal["cylinder"] = "cylinder"
    radius: Positive = Field(default=1.0, description="Radius")
    height: Positive = Field(default=2.0, description="Height along z")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.cylinder(self.radius, self.height, flip=self.flip)

    @classmethod
    def sizes(cls, rows: Net) -> dict[str, float] | None:
        """Return the sizes that the coefficients would say, or None."""
        fits = isinstance(rows.functions, Powers) and rows.points.shape[:2] == (2, 3)
        return {"radius": float(rows.points[0, 0, 0]), "height": float(rows.points[1, 2, 2])} if fits else None


class Cone(ClosedForm):
    """Cone with its apex up."""

    title = "Circular cone"
    words = "A cone from its base, of radius r, to its apex at height h, a singular point."
    formula = r"\sqrt{x^2+y^2}=r\,(1-z/h),\quad 0\le z\le h"
    starter: ClassVar[Keys] = {"radius": 10, "height": 20}
    kind: Literal["cone"] = "cone"
    radius: Positive = Field(default=1.0, description="Radius of the base")
    height: Positive = Field(default=2.0, description="Height along z")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.cone(self.radius, self.height, flip=self.flip)

    @classmethod
    def sizes(cls, rows: Net) -> dict[str, float] | None:
        """Return the sizes that the coefficients would say, or None."""
        fits = isinstance(rows.functions, Powers) and rows.points.shape[:2] == (2, 3)
        return {"radius": float(rows.points[0, 0, 0]), "height": float(rows.points[1, 2, 2])} if fits else None


class Torus(ClosedForm):
    """Torus."""

    title = "Torus"
    words = "A tube of radius r around a circle of radius R."
    formula = r"(\sqrt{x^2+y^2}-R)^2+z^2=r^2"
    starter: ClassVar[Keys] = {"major": 30, "minor": 10}
    kind: Literal["torus"] = "torus"
    major: Positive = Field(default=3.0, description="Radius of the circle of centres")
    minor: Positive = Field(default=1.0, description="Radius of the tube")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.torus(self.major, self.minor, flip=self.flip)

    @classmethod
    def sizes(cls, rows: Net) -> dict[str, float] | None:
        """Return the sizes that the coefficients would say, or None."""
        fits = isinstance(rows.functions, Joined) and rows.points.shape[:2] == (3, 3)
        return {"major": float(rows.points[2, 0, 0]), "minor": float(rows.points[0, 0, 0])} if fits else None


class Catenoid(ClosedForm):
    """Catenoid, a minimal surface."""

    title = "Catenoid"
    words = "The minimal surface of revolution, with a waist of radius a: H = 0."
    formula = r"\sqrt{x^2+y^2}=a\,\cosh(z/a)"
    starter: ClassVar[Keys] = {"waist": 10, "height": 20}
    kind: Literal["catenoid"] = "catenoid"
    waist: Positive = Field(default=1.0, description="Radius of the waist")
    height: Positive = Field(default=2.0, description="Height along z")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.catenoid(self.waist, self.height, flip=self.flip)

    @classmethod
    def sizes(cls, rows: Net) -> dict[str, float] | None:
        """Return the sizes that the coefficients would say, or None."""
        profile = rows.functions.parts[0] if isinstance(rows.functions, Joined) else None
        if not isinstance(profile, Hyperbolic) or rows.points.shape[:2] != (4, 3):
            return None
        waist = float(rows.points[0, 0, 0])
        return {"waist": waist, "height": 2.0 * profile.end * waist}


class Helicoid(ClosedForm):
    """One turn of a helicoid, a minimal surface."""

    title = "Helicoid"
    words = "One turn of a screw surface, a minimal surface: H = 0."
    formula = r"\mathbf{S}=(\rho\,\cos\theta,\;\rho\,\sin\theta,\;c\,\theta)"
    starter: ClassVar[Keys] = {"radius": 10, "pitch": 20}
    kind: Literal["helicoid"] = "helicoid"
    radius: Positive = Field(default=1.0, description="Half length of the rulings")
    pitch: Number = Field(default=2.0, description="Rise in one turn")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.helicoid(self.radius, self.pitch, flip=self.flip)

    @classmethod
    def sizes(cls, rows: Net) -> dict[str, float] | None:
        """Return the sizes that the coefficients would say, or None."""
        if not isinstance(rows.functions, Powers) or rows.points.shape[:2] != (2, 4):
            return None
        return {"radius": rows.functions.end, "pitch": 2.0 * np.pi * float(rows.points[0, 3, 2])}


class Graph(ClosedForm):
    """Keys of the polynomial reference surfaces over a square."""

    size: Positive = Field(default=1.0, description="Half side of the square of parameters")

    @classmethod
    def sizes(cls, rows: Net) -> dict[str, float] | None:
        """Return the sizes that the coefficients would say, or None."""
        return {"size": rows.functions.end} if isinstance(rows.functions, Powers) else None


class HyperbolicParaboloid(Graph):
    """z = x y."""

    title = "Hyperbolic paraboloid"
    words = "A saddle over a square."
    formula = r"z=x\,y"
    kind: Literal["hyperbolic_paraboloid"] = "hyperbolic_paraboloid"

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.hyperbolic_paraboloid(self.size, flip=self.flip)


class MonkeySaddle(Graph):
    """z = x³ - 3 x y²."""

    title = "Monkey saddle"
    words = "A saddle with three valleys, flat at the origin."
    formula = r"z=x^3-3\,x\,y^2"
    kind: Literal["monkey_saddle"] = "monkey_saddle"

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.monkey_saddle(self.size, flip=self.flip)


class Enneper(Graph):
    """Enneper's minimal surface."""

    title = "Enneper's surface"
    words = "A minimal surface over a square of parameters p and q: H = 0."
    formula = r"\mathbf{S}=(p-\frac{p^3}{3}+p\,q^2,\;q-\frac{q^3}{3}+q\,p^2,\;p^2-q^2)"
    kind: Literal["enneper"] = "enneper"

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.enneper(self.size, flip=self.flip)


def _alike(one: Surface, other: Surface) -> bool:
    """Return whether two surfaces of like rows are the same: 81 points are more than any closed form has freedom."""
    t = np.linspace(0.0, 1.0, 9)
    gap = np.abs(one(t[:, None], t[None, :]) - other(t[:, None], t[None, :])).max()
    return bool(gap <= _ALIKE * one.size)
