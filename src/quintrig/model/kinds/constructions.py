"""The kinds of the thesis: built from control points, or from planes."""

from collections.abc import Sequence
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from quintrig.basis.bernstein import Bernstein
from quintrig.basis.formulas import Basis
from quintrig.basis.functions import Functions
from quintrig.basis.joined import Joined
from quintrig.basis.registry import DEFAULT, Choice, bases, entry
from quintrig.geometry import constructions as construct
from quintrig.geometry import envelope
from quintrig.geometry.surface import Net, Surface
from quintrig.model.kinds.definition import Based, Bezier, Keys, Number, Outline, Plane, Polygon, Rows
from quintrig.model.own_bases import own_bases, table_of

_HILL = (0, 14, 38, 42, 18, 4)
_ARCH = (0, 10, 30, 30, 10, 0)
"""Heights of the starters' control points, lengths in mm."""

_U, _V = r"f_i(u;\alpha_1,\zeta_1)", r"f_j(v;\alpha_2,\zeta_2)"
_TENSOR = rf"\mathbf{{S}}(u,v)=\sum_{{i=0}}^{{5}}\sum_{{j=0}}^{{5}}\mathbf{{P}}_{{ij}}\,{_U}\,{_V}"


def basis_keys(families: Sequence[Functions]) -> Keys | None:
    """Return the keys that say the bases and shape parameters of families; None where one is of no basis."""
    if not families or not all(one.label for one in families):
        return None
    labels = list(dict.fromkeys(one.label for one in families))
    shape = [value for one in families for value in one.parameters.values()]
    keys: Keys = {"shape": shape} if shape else {}
    if labels != [DEFAULT]:
        keys["basis"] = labels[0] if len(labels) == 1 else [one.label for one in families]
    entries = {one.label: getattr(one, "basis", None) for one in families}
    own = {name: table_of(basis) for name, basis in entries.items() if isinstance(basis, Basis) and name not in bases()}
    keys |= {"bases": own} if own else {}
    keys |= {"unchecked_basis": True} if not all(one.partition for one in families) else {}
    return keys | ({"unchecked_shape": True} if any(one.outside for one in families) else {})


class Tensor(Bezier):
    """Tensor-product surface."""

    title = "Tensor-product surface"
    words = (
        "A net of control points, 6 × 6 for the quintic trigonometric basis, blended by the functions of the basis in "
        "u and in v. It starts and ends in the corner points of the net, and stays inside its convex hull where the "
        "functions are not negative."
    )
    formula = _TENSOR
    starter: ClassVar[Keys] = {
        "points": [[[20 * i, 20 * j, round(a * b / 36)] for j, b in enumerate(_HILL)] for i, a in enumerate(_HILL)]
    }
    nets = ("points",)
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"points": (6, 6)}
    kind: Literal["tensor"] = "tensor"
    points: Rows = Field(description="6 x 6 control points [x, y, z]; points[i][j] with i along u, j along v")

    def surface(self) -> Surface:
        """Build the surface."""
        return construct.tensor(self.points, self.shape, **self.options)

    @classmethod
    def recognised(cls, surface: Surface) -> Keys | None:
        """Return the keys of which this kind would build the surface, or None."""
        rows = surface.rows
        if not isinstance(rows, Net) or rows.dimension != 3:
            return None
        keys = basis_keys((rows.functions, surface.blend))
        return keys and {"points": (rows.points + surface.origin).tolist()} | keys


class Symmetric(Bezier):
    """Tensor-product surface that is its own mirror image."""

    title = "Symmetric surface"
    words = (
        "A tensor-product surface of which half of the rows of control points are given, three for the quintic "
        "trigonometric basis; the others are their images in a mirror plane."
    )
    formula = _TENSOR + r",\quad\mathbf{P}_{5-i,j}=\text{the mirror image of }\mathbf{P}_{ij}"
    starter: ClassVar[Keys] = {
        "points": [
            [[20 * i, 20 * j, a + round(0.6 * b)] for j, b in enumerate(_HILL)] for i, a in enumerate(_ARCH[:3])
        ],
        "mirror": [1, 0, 0, -50],
    }
    nets = ("points",)
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"points": (3, 6)}
    kind: Literal["symmetric"] = "symmetric"
    points: Rows = Field(description="3 x 6 control points, half of the net; the other three rows are mirrored")
    mirror: Plane = Field(description="Mirror plane [a, b, c, d]: a x + b y + c z + d = 0")

    @property
    def point_counts(self) -> tuple[int, ...]:
        """Number of control points along u and v, mirrored ones included."""
        return construct.mirrored(self._across, len(self.points)), len(self.points[0])

    @property
    def _across(self) -> Choice:
        return entry(self.basis if isinstance(self.basis, str) else self.basis[0], own_bases(self.bases))

    def surface(self) -> Surface:
        """Build the surface."""
        return construct.symmetric(self.points, self.mirror, self.shape, **self.options)


class Swept(Bezier):
    """Translational sweep of a section along a trajectory."""

    title = "Swept surface"
    words = (
        "A section curve, moved without turning along a trajectory curve. Every line u = const is a copy of the "
        "trajectory, every line v = const a copy of the section."
    )
    formula = r"\mathbf{S}(u,v)=\mathbf{C}(u;\alpha_1,\zeta_1)+\mathbf{T}(v;\alpha_2,\zeta_2)"
    starter: ClassVar[Keys] = {
        "section": [[20 * i, 0, z] for i, z in enumerate(_ARCH)],
        "trajectory": [[0, 20 * i, round(0.8 * z)] for i, z in enumerate(_HILL)],
    }
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

    title = "Swung surface"
    words = (
        "A profile curve (r, z), swung about the z axis along a trajectory curve (x, y) and scaled by λ. With a "
        "quarter circle for the trajectory, which the cubic basis holds exactly and the quintic does not, it is a "
        "surface of revolution."
    )
    formula = r"\mathbf{S}(u,v)=(\lambda\,r(u)\,x(v),\;\lambda\,r(u)\,y(v),\;z(u))"
    starter: ClassVar[Keys] = {
        "profile": [[20, 0], [60, 10], [80, 40], [50, 70], [30, 100], [40, 120]],
        "trajectory": [[1, 0], [1, 0.6], [0.7, 1], [-0.7, 1], [-1, 0.6], [-1, 0]],
        "scale": 1,
        "flip": True,
    }
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

    title = "Ruled surface"
    words = "Straight lines that join points of equal parameter u on two curves. K is nowhere positive."
    formula = r"\mathbf{S}(u,v)=(1-v)\,\mathbf{A}(u;\alpha_1,\zeta_1)+v\,\mathbf{B}(u;\alpha_2,\zeta_2)"
    starter: ClassVar[Keys] = {
        "first": [[20 * i, 0, z] for i, z in enumerate(_ARCH)],
        "second": [[20 * i, 100, round(z / 3)] for i, z in enumerate(_HILL)],
    }
    nets = ("first", "second")
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"first": (6,), "second": (6,)}
    kind: Literal["ruled"] = "ruled"
    first: Polygon = Field(description="6 points [x, y, z] of the curve at v = 0, with (α1, ζ1)")
    second: Polygon = Field(description="6 points [x, y, z] of the curve at v = 1, with (α2, ζ2)")

    def surface(self) -> Surface:
        """Build the surface."""
        return construct.ruled(self.first, self.second, self.shape, **self.options)

    @classmethod
    def recognised(cls, surface: Surface) -> Keys | None:
        """Return the keys of which this kind would build the surface, or None."""
        rows = surface.rows
        if not isinstance(rows, Net) or not isinstance(rows.functions, Joined) or surface.blend != Bernstein(1):
            return None
        first = rows.functions.parts[0].size
        keys = basis_keys(rows.functions.parts)
        ends = {"first": rows.points[:first, 0], "second": rows.points[first:, 1]}
        return keys and {name: (points + surface.origin).tolist() for name, points in ends.items()} | keys


class Developable(Based):
    """Strip enveloped by a family of planes."""

    title = "Enveloping developable surface"
    words = (
        "The strip that a family of planes touches, each along a straight line, cut off by two bounding planes. K"
        " = 0: clear of its edge of regression it unrolls into a plane without stretching."
    )
    formula = r"\Pi(u)=\sum_{i=0}^{5}f_i(u;\alpha,\zeta)\,L_i,\quad\text{rulings }\Pi(u)\cap\Pi'(u)"
    starter: ClassVar[Keys] = {
        "planes": [
            [-1, 0.2, 1, -110],
            [-0.8, 0.1, 1, -90],
            [-0.35, -0.05, 1, -60],
            [0.35, -0.05, 1, -60],
            [0.8, 0.1, 1, -90],
            [1, 0.2, 1, -110],
        ],
        "bounds": [[0, 1, 0, 0], [0, 1, 0, -100]],
    }
    nets = ("planes", "bounds")
    counts: ClassVar[dict[str, tuple[int, ...]]] = {"planes": (6,), "bounds": (2,)}
    shape_names: ClassVar[tuple[str, ...]] = ("alpha", "zeta")
    kind: Literal["developable"] = "developable"
    planes: Annotated[list[Plane], Field(min_length=2, max_length=64)] = Field(
        description="6 control planes [a, b, c, d]: a x + b y + c z + d = 0"
    )
    bounds: Annotated[list[Plane], Field(min_length=2, max_length=2)] = Field(
        description="2 planes [a, b, c, d] that cut the rulings at v = 0 and v = 1"
    )

    @property
    def point_counts(self) -> tuple[int, ...]:
        """Number of control planes."""
        return (len(self.planes),)

    def surface(self) -> Surface:
        """Build the surface."""
        return envelope.developable(
            self.planes,
            self.bounds,
            self.shape,
            basis=self.choices[0],
            flip=self.flip,
            unchecked_shape=self.unchecked_shape,
        )

    @classmethod
    def recognised(cls, surface: Surface) -> Keys | None:
        """Return the keys of which this kind would build the surface, or None."""
        rows = surface.rows
        if not isinstance(rows, envelope.Envelope):
            return None
        keys = basis_keys((rows.functions,))
        return keys and {"planes": rows.planes.tolist(), "bounds": rows.bounds.tolist()} | keys
