"""What a kind of surface is: keys, words, formula, starter and surface, all on one pydantic class.

The field descriptions become the published JSON Schema and the comments of starter models.
"""

from typing import Annotated, Any, ClassVar, cast

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from quintrig.basis.formulas import Basis, Parameter
from quintrig.basis.library import Entry
from quintrig.basis.pairs import names, parameters, symbol
from quintrig.basis.registry import DEFAULT, Choice, entry
from quintrig.geometry.constructions import SHAPE_NAMES, Options
from quintrig.geometry.surface import Surface
from quintrig.model.own_bases import own_bases
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
Shape = Annotated[
    list[Number],
    Field(
        max_length=128,
        description=(
            "Shape parameters of the basis, those in u, then those in v; for the quintic basis (α1, ζ1, α2, ζ2), or "
            "(α, ζ) for a developable, each in [-4, 1]"
        ),
    ),
]


def _names(value: object) -> object:
    """Check what stands for the basis, before the types are told apart."""
    names = cast(list[object], value) if isinstance(value, (list, tuple)) else [value]
    if not all(isinstance(one, str) for one in names):
        raise ValueError(f"expected the name of a basis, or a list of two for u and v, got {str(names)[:60]!r}")
    return cast(object, value)


BasisNames = Annotated[str | list[str], BeforeValidator(_names)]

Keys = dict[str, Any]
"""Keys of a patch in a model file, and their values."""


class Definition(BaseModel):
    """Keys that every kind has."""

    # Built when a model first has the kind: most models have one of sixteen.
    model_config = ConfigDict(extra="forbid", frozen=True, defer_build=True)
    title: ClassVar[str] = ""
    """What the kind is called at the head of a page."""
    words: ClassVar[str] = ""
    """What it is, in a sentence or two."""
    formula: ClassVar[str] = ""
    """Its formula in LaTeX, or nothing."""
    starter: ClassVar[Keys] = {}
    """Values of a good-looking starter model, lengths in mm; what is left out stays at its default."""
    shape_names: ClassVar[tuple[str, ...]] = ()
    """Names of the shape parameters of the quintic basis, in the order of ``shape``."""
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
        return {} if self.classical else dict(zip(self.ranges, self.shape_values, strict=True))

    @property
    def point_counts(self) -> tuple[int, ...]:
        """Number of control points for each basis; none for kinds that are built otherwise."""
        return ()

    @property
    def standard(self) -> bool:
        """Whether the functions are those of the quintic trigonometric basis, where there are any."""
        return True

    @property
    def ranges(self) -> dict[str, Parameter]:
        """The shape parameters by name, with their ranges."""
        return {}

    @property
    def shape_symbols(self) -> tuple[str, ...]:
        """The names of the shape parameters that act, as they are read: α1, ζ1, ..."""
        return () if self.classical else tuple(map(symbol, self.ranges))

    @property
    def bases_used(self) -> tuple[Basis, ...]:
        """The bases as formulas, each once; none for kinds that are built otherwise."""
        return ()

    @property
    def basis_words(self) -> str:
        """What is said of bases that are not the quintic one; else nothing."""
        return ""

    def check_basis(self) -> None:
        """Raise ValueError where a basis is not what a surface needs."""

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


class Based(Definition):
    """Keys of the kinds whose functions come from a basis."""

    shape: Shape = []
    basis: BasisNames = Field(
        default=DEFAULT,
        description=(
            "Basis, by name, or two for u and v, such as ['cubic', 'quintic']; 'bernstein' gives the classical surface "
            "on the same points"
        ),
    )
    bases: dict[str, Any] = Field(
        default={},
        description=(
            "Bases of your own by name: [bases.NAME] with functions = [...] and parameters = { NAME = [low, high] }, "
            "or the name of a file of [basis.NAME] tables beside the model"
        ),
    )
    unchecked_shape: Annotated[bool, Field(strict=True)] = Field(
        default=False,
        description="Allow shape parameters outside their range, [-4, 1] for the quintic basis; the convex-hull "
        "property is then lost",
    )
    unchecked_basis: Annotated[bool, Field(strict=True)] = Field(
        default=False, description="Allow a basis whose functions do not sum to 1; the surface moves with the origin"
    )

    @property
    def point_counts(self) -> tuple[int, ...]:
        """Number of control points for each basis: along u and v of a net, or of each of two curves."""
        first = getattr(self, self.nets[0])
        if len(self.counts[self.nets[0]]) == 2:
            return len(first), len(first[0])
        return len(first), len(getattr(self, self.nets[-1]))

    @property
    def choices(self) -> tuple[Choice, ...]:
        """The bases, one for each of ``point_counts``; ValueError for names that are none."""
        own = own_bases(self.bases)
        names = [self.basis] * len(self.point_counts) if isinstance(self.basis, str) else self.basis
        if len(names) != len(self.point_counts):
            several = f", or {len(self.point_counts)}" if len(self.point_counts) > 1 else ""
            raise ValueError(f"basis: expected one basis{several}, found {len(names)}")
        return tuple(entry(name, own) for name in names)

    @property
    def standard(self) -> bool:
        """Whether all bases are the quintic trigonometric one."""
        return self._all("trigonometric", "quintic")

    @property
    def classical(self) -> bool:
        """Whether the classical Bernstein basis is used, on which shape parameters do not act."""
        return self._all("bernstein")

    @property
    def ranges(self) -> dict[str, Parameter]:
        """The shape parameters by name, with their ranges."""
        choices, counts = self.choices, self.point_counts
        own = [one for choice, n in zip(choices, counts, strict=True) for one in parameters(choice, n)]
        return dict(zip(names(choices, counts), own, strict=True))

    @property
    def shape_values(self) -> tuple[float, ...]:
        """Shape parameters, those that the bases start from where the file gives none."""
        if self.classical:
            return tuple(self.shape) or (0.0,) * len(type(self).shape_names)
        return tuple(self.shape) or tuple(float(one.start or 0.0) for one in self.ranges.values())

    @property
    def bases_used(self) -> tuple[Basis, ...]:
        """The bases as formulas, each once."""
        pairs = zip(self.choices, self.point_counts, strict=True)
        return tuple(dict.fromkeys(one.basis(points) for one, points in pairs if isinstance(one, Entry)))

    @property
    def basis_words(self) -> str:
        """What is said of bases that are not the quintic one, with the number of points for each; else nothing."""
        titles = [one.title for one in self.choices if isinstance(one, Entry)]
        counts = " and ".join(f"{n}" for n in self.point_counts)
        if self.standard:
            return ""
        if self.classical:
            return "classical Bernstein basis, on which shape parameters do not act"
        return f"basis {' and '.join(dict.fromkeys(titles))}, for {counts} points"

    def check_basis(self) -> None:
        """Raise ValueError where the functions of a basis do not sum to 1 and nobody said that this may be."""
        for choice, points in zip(self.choices, self.point_counts, strict=True) if not self.standard else ():
            basis = choice.basis(points) if isinstance(choice, Entry) else None
            if basis is not None and not basis.partition and not self.unchecked_basis:
                raise ValueError(
                    f"basis: the functions of {basis.name!r} do not sum to 1 ({basis.off_sum[1]}); correct the "
                    "formulas, or set unchecked_basis = true and have a surface that moves with the origin"
                )

    def _all(self, *known: str) -> bool:
        names = [self.basis] if isinstance(self.basis, str) else self.basis
        return all(name in known for name in names)


class Bezier(Based):
    """Keys of the kinds that are built from control points."""

    shape_names: ClassVar[tuple[str, ...]] = SHAPE_NAMES
    affine: ClassVar[bool] = True

    @property
    def options(self) -> "Options":
        """The keyword arguments that every construction takes."""
        return {"basis": self.choices, "flip": self.flip, "unchecked_shape": self.unchecked_shape}
