"""What a patch of a model file may say: one pydantic class a kind, which also builds the surface.

The field descriptions become the published JSON Schema and the comments of starter models.
"""

from typing import Annotated, Any, ClassVar, Literal

from pydantic import BaseModel, ConfigDict, Field

from quintrig.basis.trigonometric import BasisName
from quintrig.geometry import closed_forms as reference
from quintrig.geometry import constructions as construct
from quintrig.geometry import envelope
from quintrig.geometry.nurbs import nurbs
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import LARGEST, SMALLEST

Number = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-LARGEST, le=LARGEST)]
Positive = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, ge=SMALLEST, le=LARGEST)]
Pair = Annotated[list[Number], Field(min_length=2, max_length=2)]
Point = Annotated[list[Number], Field(min_length=3, max_length=3)]
Plane = Annotated[list[Number], Field(min_length=4, max_length=4)]
Polygon = Annotated[list[Point], Field(min_length=2, max_length=64)]
Outline = Annotated[list[Pair], Field(min_length=2, max_length=64)]
Rows = Annotated[list[Polygon], Field(min_length=2, max_length=64)]
Four = Annotated[
    list[Number],
    Field(
        min_length=4, max_length=4, description="Shape parameters (α1, ζ1, α2, ζ2), each in [-4, 1]; first pair in u"
    ),
]
Two = Annotated[list[Number], Field(min_length=2, max_length=2, description="Shape parameters (α, ζ), each in [-4, 1]")]


class Definition(BaseModel):
    """Keys that every kind has."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    nets: ClassVar[tuple[str, ...]] = ()
    """Keys that hold control points or planes, which may come from a CSV file."""
    counts: ClassVar[dict[str, tuple[int, ...]]] = {}
    """Numbers of control points that the trigonometric basis needs, by key."""

    name: Annotated[str, Field(min_length=1, max_length=200, strict=True)] | None = Field(
        default=None, description="Name of the patch"
    )
    flip: Annotated[bool, Field(strict=True)] = Field(default=False, description="Turn the normal to the other side")

    def surface(self) -> Surface:
        """Build the surface; ValueError where values that are each allowed do not go together."""
        raise TypeError("a definition without a kind builds nothing")

    @property
    def shape_values(self) -> tuple[float, ...]:
        """Shape parameters, empty for kinds that have none."""
        return tuple(getattr(self, "shape", ()))


class Bezier(Definition):
    """Keys of the kinds that are built from control points."""

    shape: Four = [0.0, 0.0, 0.0, 0.0]
    basis: BasisName = Field(
        default="trigonometric", description="'bernstein' gives the classical surface on the same points"
    )
    unchecked_shape: Annotated[bool, Field(strict=True)] = Field(
        default=False, description="Allow shape parameters outside [-4, 1]; the convex-hull property is then lost"
    )

    @property
    def options(self) -> "construct.Options":
        """The keyword arguments that every construction takes."""
        return {"basis": self.basis, "flip": self.flip, "unchecked_shape": self.unchecked_shape}


class Tensor(Bezier):
    """Tensor-product surface."""

    nets = ("points",)
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"points": (6, 6)}
    kind: Literal["tensor"] = "tensor"
    points: Rows = Field(description="6 x 6 control points [x, y, z]; points[i][j] with i along u, j along v")

    def surface(self) -> Surface:
        """Build the surface."""
        return construct.tensor(self.points, self.shape, **self.options)


class Symmetric(Bezier):
    """Tensor-product surface that is its own mirror image."""

    nets = ("points",)
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"points": (3, 6)}
    kind: Literal["symmetric"] = "symmetric"
    points: Rows = Field(description="3 x 6 control points, half of the net; the other three rows are mirrored")
    mirror: Plane = Field(description="Mirror plane [a, b, c, d]: a x + b y + c z + d = 0")

    def surface(self) -> Surface:
        """Build the surface."""
        return construct.symmetric(self.points, self.mirror, self.shape, **self.options)


class Swept(Bezier):
    """Translational sweep of a section along a trajectory."""

    nets = ("section", "trajectory")
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"section": (6,), "trajectory": (6,)}
    kind: Literal["swept"] = "swept"
    section: Polygon = Field(description="6 points [x, y, z] of the section curve, along u")
    trajectory: Polygon = Field(description="6 points [x, y, z] of the trajectory curve, along v")

    def surface(self) -> Surface:
        """Build the surface."""
        return construct.swept(self.section, self.trajectory, self.shape, **self.options)


class Swung(Bezier):
    """Profile swung along a plane trajectory."""

    nets = ("profile", "trajectory")
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"profile": (6,), "trajectory": (6,)}
    kind: Literal["swung"] = "swung"
    profile: Outline = Field(description="6 pairs [r, z] of the profile curve, along u")
    trajectory: Outline = Field(description="6 pairs [x, y] of the trajectory curve, along v")
    scale: Number = Field(default=1.0, description="Scale factor λ of the trajectory")

    def surface(self) -> Surface:
        """Build the surface."""
        return construct.swung(self.profile, self.trajectory, self.shape, self.scale, **self.options)


class Ruled(Bezier):
    """Straight lines between two curves."""

    nets = ("first", "second")
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"first": (6,), "second": (6,)}
    kind: Literal["ruled"] = "ruled"
    first: Polygon = Field(description="6 points [x, y, z] of the curve at v = 0, with (α1, ζ1)")
    second: Polygon = Field(description="6 points [x, y, z] of the curve at v = 1, with (α2, ζ2)")

    def surface(self) -> Surface:
        """Build the surface."""
        return construct.ruled(self.first, self.second, self.shape, **self.options)


class Developable(Definition):
    """Strip enveloped by a family of planes."""

    nets = ("planes", "bounds")
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"planes": (6,), "bounds": (2,)}
    kind: Literal["developable"] = "developable"
    shape: Two = [0.0, 0.0]
    planes: Annotated[list[Plane], Field(min_length=6, max_length=6)] = Field(
        description="6 control planes [a, b, c, d]: a x + b y + c z + d = 0"
    )
    bounds: Annotated[list[Plane], Field(min_length=2, max_length=2)] = Field(
        description="2 planes [a, b, c, d] that cut the rulings at v = 0 and v = 1"
    )
    unchecked_shape: Annotated[bool, Field(strict=True)] = Field(
        default=False, description="Allow shape parameters outside [-4, 1]"
    )

    def surface(self) -> Surface:
        """Build the surface."""
        return envelope.developable(
            self.planes, self.bounds, self.shape, flip=self.flip, unchecked_shape=self.unchecked_shape
        )


Degree = Annotated[int, Field(strict=True, ge=1, le=25)]
Knots = Annotated[list[Number], Field(min_length=4, max_length=2048)]


class Nurbs(Definition):
    """Rational B-spline surface (NURBS), such as a face read from a CAD file."""

    kind: Literal["nurbs"] = "nurbs"
    degrees: Annotated[list[Degree], Field(min_length=2, max_length=2)] = Field(description="Degrees (p, q) in u and v")
    knots: Annotated[list[Knots], Field(min_length=2, max_length=2)] = Field(
        description="Full knot vectors in u and v: control points + degree + 1 numbers each; u, v in [0, 1] span them"
    )
    points: Annotated[list[Annotated[list[Point], Field(min_length=2, max_length=2048)]], Field(max_length=2048)] = (
        Field(min_length=2, description="Control points [x, y, z]; points[i][j] with i along u, j along v")
    )
    weights: Annotated[list[list[Positive]], Field(max_length=2048)] | None = Field(
        default=None, description="Weights of the control points, all 1 when left out"
    )
    trim: list[Annotated[list[Pair], Field(min_length=3)]] = Field(
        default=[], description="Closed loops of [u, v] that bound the face on its surface"
    )

    def surface(self) -> Surface:
        """Build the surface."""
        return nurbs(self.points, self.weights, self.degrees, self.knots, flip=self.flip, trim=self.trim)


class Sphere(Definition):
    """Sphere."""

    kind: Literal["sphere"] = "sphere"
    radius: Positive = Field(default=1.0, description="Radius")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.sphere(self.radius, flip=self.flip)


class Ellipsoid(Definition):
    """Ellipsoid x²/a² + y²/b² + z²/c² = 1."""

    kind: Literal["ellipsoid"] = "ellipsoid"
    a: Positive = Field(default=3.0, description="Half axis along x")
    b: Positive = Field(default=2.0, description="Half axis along y")
    c: Positive = Field(default=1.0, description="Half axis along z")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.ellipsoid(self.a, self.b, self.c, flip=self.flip)


class Cylinder(Definition):
    """Circular cylinder."""

    kind: Literal["cylinder"] = "cylinder"
    radius: Positive = Field(default=1.0, description="Radius")
    height: Positive = Field(default=2.0, description="Height along z")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.cylinder(self.radius, self.height, flip=self.flip)


class Cone(Definition):
    """Cone with its apex up."""

    kind: Literal["cone"] = "cone"
    radius: Positive = Field(default=1.0, description="Radius of the base")
    height: Positive = Field(default=2.0, description="Height along z")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.cone(self.radius, self.height, flip=self.flip)


class Torus(Definition):
    """Torus."""

    kind: Literal["torus"] = "torus"
    major: Positive = Field(default=3.0, description="Radius of the circle of centres")
    minor: Positive = Field(default=1.0, description="Radius of the tube")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.torus(self.major, self.minor, flip=self.flip)


class Catenoid(Definition):
    """Catenoid, a minimal surface."""

    kind: Literal["catenoid"] = "catenoid"
    waist: Positive = Field(default=1.0, description="Radius of the waist")
    height: Positive = Field(default=2.0, description="Height along z")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.catenoid(self.waist, self.height, flip=self.flip)


class Helicoid(Definition):
    """One turn of a helicoid, a minimal surface."""

    kind: Literal["helicoid"] = "helicoid"
    radius: Positive = Field(default=1.0, description="Half length of the rulings")
    pitch: Number = Field(default=2.0, description="Rise in one turn")

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.helicoid(self.radius, self.pitch, flip=self.flip)


class Graph(Definition):
    """Keys of the polynomial reference surfaces over a square."""

    size: Positive = Field(default=1.0, description="Half side of the square of parameters")


class HyperbolicParaboloid(Graph):
    """z = x y."""

    kind: Literal["hyperbolic_paraboloid"] = "hyperbolic_paraboloid"

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.hyperbolic_paraboloid(self.size, flip=self.flip)


class MonkeySaddle(Graph):
    """z = x³ - 3 x y²."""

    kind: Literal["monkey_saddle"] = "monkey_saddle"

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.monkey_saddle(self.size, flip=self.flip)


class Enneper(Graph):
    """Enneper's minimal surface."""

    kind: Literal["enneper"] = "enneper"

    def surface(self) -> Surface:
        """Build the surface."""
        return reference.enneper(self.size, flip=self.flip)


CONSTRUCTIONS: tuple[type[Definition], ...] = (Tensor, Symmetric, Swept, Swung, Ruled, Developable)
"""Kinds of the thesis, built from control points or planes."""

REFERENCES: tuple[type[Definition], ...] = (
    Sphere,
    Ellipsoid,
    Cylinder,
    Cone,
    Torus,
    Catenoid,
    Helicoid,
    HyperbolicParaboloid,
    MonkeySaddle,
    Enneper,
)
"""Kinds with curvature in closed form."""

KINDS: dict[str, type[Definition]] = {
    _kind.model_fields["kind"].default: _kind for _kind in (*CONSTRUCTIONS, Nurbs, *REFERENCES)
}
"""Definition class by kind."""

Keys = dict[str, Any]
