"""What a kind of surface is: keys, words, formula, starter and surface, all on one pydantic class.

The field descriptions become the published JSON Schema and the comments of starter models.
"""

from typing import Annotated, Any, ClassVar

from pydantic import BaseModel, ConfigDict, Field

from quintrig.basis.registry import BasisName
from quintrig.geometry.constructions import SHAPE_NAMES, Options
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import LARGEST, SMALLEST

LARGEST_POLYGON = 64
"""Most control points in one direction."""

Number = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-LARGEST, le=LARGEST)]
Positive = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, ge=SMALLEST, le=LARGEST)]
Pair = Annotated[list[Number], Field(min_length=2, max_length=2)]
Point = Annotated[list[Number], Field(min_length=3, max_length=3)]
Plane = Annotated[list[Number], Field(min_length=4, max_length=4)]
Polygon = Annotated[list[Point], Field(min_length=2, max_length=LARGEST_POLYGON)]
Outline = Annotated[list[Pair], Field(min_length=2, max_length=LARGEST_POLYGON)]
Rows = Annotated[list[Polygon], Field(min_length=2, max_length=LARGEST_POLYGON)]
Four = Annotated[
    list[Number],
    Field(
        min_length=4, max_length=4, description="Shape parameters (α1, ζ1, α2, ζ2), each in [-4, 1]; first pair in u"
    ),
]
Two = Annotated[list[Number], Field(min_length=2, max_length=2, description="Shape parameters (α, ζ), each in [-4, 1]")]


Keys = dict[str, Any]
"""Keys of a patch in a model file, and their values."""


class Definition(BaseModel):
    """Keys that every kind has."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    title: ClassVar[str] = ""
    """What the kind is called at the head of a page."""
    words: ClassVar[str] = ""
    """What it is, in a sentence or two."""
    formula: ClassVar[str] = ""
    """Its formula in LaTeX, or nothing."""
    starter: ClassVar[Keys] = {}
    """Values of a good-looking starter model, lengths in mm; what is left out stays at its default."""
    shape_names: ClassVar[tuple[str, ...]] = ()
    """Names of the shape parameters, in the order of ``shape``."""
    affine: ClassVar[bool] = False
    """Whether the surface's points are affine in each shape parameter, in its own direction: sweeps are then fast."""
    nets: ClassVar[tuple[str, ...]] = ()
    """Keys that hold control points or planes, which may come from a CSV file."""
    counts: ClassVar[dict[str, tuple[int, ...]]] = {}
    """Numbers of control points that the trigonometric basis needs, by key."""

    name: Annotated[str, Field(min_length=1, max_length=200, strict=True)] | None = Field(
        default=None, description="Name of the patch"
    )
    flip: Annotated[bool, Field(strict=True)] = Field(default=False, description="Turn the normal to the other side")

    @classmethod
    def __pydantic_init_subclass__(cls, **kwargs: Any) -> None:
        """Let a kind that says no more than its docstring be called by its first line."""
        summary = (cls.__doc__ or cls.__name__).strip().splitlines()[0]
        if "title" not in vars(cls):
            cls.title = summary.rstrip(".")
        if "words" not in vars(cls):
            cls.words = summary

    def surface(self) -> Surface:
        """Build the surface; ValueError where values that are each allowed do not go together."""
        raise TypeError("a definition without a kind builds nothing")

    @classmethod
    def recognised(cls, surface: Surface) -> Keys | None:
        """Return the keys, ``flip`` apart, of which this kind would build the surface; None where it would not."""
        return None

    @property
    def classical(self) -> bool:
        """Whether the classical Bernstein basis is used, on which shape parameters do not act."""
        return False

    @property
    def acting(self) -> dict[str, float]:
        """The shape parameters that act on the surface, by name."""
        names = () if self.classical else self.shape_names
        return dict(zip(names, self.shape_values, strict=True)) if names else {}

    @property
    def parameters(self) -> dict[str, float]:
        """The numbers that may be varied, by name: shape parameters, then sizes and scales."""
        fields = type(self).model_fields
        values = {key: getattr(self, key) for key in fields}
        return self.acting | {key: float(x) for key, x in values.items() if isinstance(x, float)}

    @property
    def shape_values(self) -> tuple[float, ...]:
        """Shape parameters, empty for kinds that have none."""
        return tuple(getattr(self, "shape", ()))


class Bezier(Definition):
    """Keys of the kinds that are built from control points."""

    shape_names: ClassVar[tuple[str, ...]] = SHAPE_NAMES
    affine: ClassVar[bool] = True
    shape: Four = [0.0, 0.0, 0.0, 0.0]
    basis: BasisName = Field(
        default="trigonometric", description="'bernstein' gives the classical surface on the same points"
    )
    unchecked_shape: Annotated[bool, Field(strict=True)] = Field(
        default=False, description="Allow shape parameters outside [-4, 1]; the convex-hull property is then lost"
    )

    @property
    def classical(self) -> bool:
        """Whether the classical Bernstein basis is used, on which shape parameters do not act."""
        return self.basis == "bernstein"

    @property
    def options(self) -> "Options":
        """The keyword arguments that every construction takes."""
        return {"basis": self.basis, "flip": self.flip, "unchecked_shape": self.unchecked_shape}
