"""What each kind of surface is: in words, as a formula, and by the parameters that its file gives."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, cast

from markupsafe import Markup

from quintrig.model.definition import Bezier
from quintrig.model.model import Patch
from quintrig.report.mathml import mathml
from quintrig.report.wording import number

MOST_POINTS = 400
"""Control points that the page lists of each net; the rest are in the model file."""


@dataclass(frozen=True)
class Kind:
    """A kind in words: what it is called, what it is, and its formula in LaTeX."""

    title: str
    words: str
    formula: str


@dataclass(frozen=True)
class Net:
    """Control points or planes as the file gives them: a row for each, named by its indices, ``left_out`` not shown."""

    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, tuple[float, ...]], ...]
    left_out: int


_U, _V = r"f_i(u;\alpha_1,\zeta_1)", r"f_j(v;\alpha_2,\zeta_2)"
_TENSOR = rf"\mathbf{{S}}(u,v)=\sum_{{i=0}}^{{5}}\sum_{{j=0}}^{{5}}\mathbf{{P}}_{{ij}}\,{_U}\,{_V}"

KINDS: Mapping[str, Kind] = MappingProxyType(
    {
        "tensor": Kind(
            "Tensor-product surface",
            "A net of 6 × 6 control points, blended by the quintic trigonometric functions in u and in v. It starts "
            "and ends in the corner points of the net and stays inside the convex hull of all 36.",
            _TENSOR,
        ),
        "symmetric": Kind(
            "Symmetric surface",
            "A tensor-product surface of which three rows of control points are given; the other three are their "
            "images in a mirror plane.",
            _TENSOR + r",\quad\mathbf{P}_{5-i,j}=\text{the mirror image of }\mathbf{P}_{ij}",
        ),
        "swept": Kind(
            "Swept surface",
            "A section curve, moved without turning along a trajectory curve. Every line u = const is a copy of the "
            "trajectory, every line v = const a copy of the section.",
            r"\mathbf{S}(u,v)=\mathbf{C}(u;\alpha_1,\zeta_1)+\mathbf{T}(v;\alpha_2,\zeta_2)",
        ),
        "swung": Kind(
            "Swung surface",
            "A profile curve (r, z), swung about the z axis along a trajectory curve (x, y) and scaled by λ. With a "
            "circle for the trajectory it would be a surface of revolution.",
            r"\mathbf{S}(u,v)=(\lambda\,r(u)\,x(v),\;\lambda\,r(u)\,y(v),\;z(u))",
        ),
        "ruled": Kind(
            "Ruled surface",
            "Straight lines that join points of equal parameter u on two curves. K is nowhere positive.",
            r"\mathbf{S}(u,v)=(1-v)\,\mathbf{A}(u;\alpha_1,\zeta_1)+v\,\mathbf{B}(u;\alpha_2,\zeta_2)",
        ),
        "developable": Kind(
            "Enveloping developable surface",
            "The strip that a family of planes touches, each along a straight line, cut off by two bounding planes. "
            "K = 0: clear of its edge of regression it unrolls into a plane without stretching.",
            r"\Pi(u)=\sum_{i=0}^{5}f_i(u;\alpha,\zeta)\,L_i,\quad\text{rulings }\Pi(u)\cap\Pi'(u)",
        ),
        "nurbs": Kind(
            "NURBS surface",
            "A rational B-spline surface, such as a face read from a CAD file.",
            r"\mathbf{S}(u,v)=\frac{\sum_{i,j}w_{ij}\,N_i(u)\,N_j(v)\,\mathbf{P}_{ij}}{\sum_{i,j}w_{ij}\,N_i(u)\,N_j(v)}",
        ),
        "sphere": Kind("Sphere", "A sphere of radius r; its poles are singular points.", r"x^2+y^2+z^2=r^2"),
        "ellipsoid": Kind(
            "Ellipsoid",
            "An ellipsoid with half axes a, b and c; its poles are singular points.",
            r"\frac{x^2}{a^2}+\frac{y^2}{b^2}+\frac{z^2}{c^2}=1",
        ),
        "cylinder": Kind("Circular cylinder", "A cylinder of radius r and height h.", r"x^2+y^2=r^2,\quad 0\le z\le h"),
        "cone": Kind(
            "Circular cone",
            "A cone from its base, of radius r, to its apex at height h, a singular point.",
            r"\sqrt{x^2+y^2}=r\,(1-z/h),\quad 0\le z\le h",
        ),
        "torus": Kind(
            "Torus", "A tube of radius r around a circle of radius R.", r"(\sqrt{x^2+y^2}-R)^2+z^2=r^2"
        ),
        "catenoid": Kind(
            "Catenoid",
            "The minimal surface of revolution, with a waist of radius a: H = 0.",
            r"\sqrt{x^2+y^2}=a\,\cosh(z/a)",
        ),
        "helicoid": Kind(
            "Helicoid",
            "One turn of a screw surface, a minimal surface: H = 0.",
            r"\mathbf{S}=(\rho\,\cos\theta,\;\rho\,\sin\theta,\;c\,\theta)",
        ),
        "hyperbolic_paraboloid": Kind("Hyperbolic paraboloid", "A saddle over a square.", r"z=x\,y"),
        "monkey_saddle": Kind(
            "Monkey saddle", "A saddle with three valleys, flat at the origin.", r"z=x^3-3\,x\,y^2"
        ),
        "enneper": Kind(
            "Enneper's surface",
            "A minimal surface over a square of parameters p and q: H = 0.",
            r"\mathbf{S}=(p-\frac{p^3}{3}+p\,q^2,\;q-\frac{q^3}{3}+q\,p^2,\;p^2-q^2)",
        ),
    }
)  # fmt: skip
"""What the page says of each kind of model file."""

BASIS: tuple[str, ...] = (
    r"f_0(t)=(1-s)^4\,(1-\alpha s)",
    r"f_1(t)=s\,(1-s)^3\,(4+\alpha-\alpha s)",
    r"f_2(t)=(1-s)^2\,(1-c)\,(8s+3c+9)",
    r"f_3(t)=(1-c)^2\,(1-s)\,(8c+3s+9)",
    r"f_4(t)=c\,(1-c)^3\,(4+\zeta-\zeta c)",
    r"f_5(t)=(1-c)^4\,(1-\zeta c)",
    r"s=\sin\frac{\pi t}{2},\quad c=\cos\frac{\pi t}{2}",
)
"""The basis functions (Misro, Ramli and Ali 2017; thesis eq. 2.2)."""


_OTHER = ("shape", "trim", "knots", "weights", "degrees")


def kind_of(patch: Patch) -> Kind:
    """Return what a patch is."""
    return KINDS[patch.kind]


def formula(patch: Patch) -> Markup:
    """Return the formula of a patch as MathML."""
    latex = kind_of(patch).formula
    if is_classical(patch):
        for name in ("u", "v"):
            number_ = "1" if name == "u" else "2"
            latex = latex.replace(rf"({name};\alpha_{number_},\zeta_{number_})", f"({name})")
        latex = latex.replace("f_i(", "B_i(").replace("f_j(", "B_j(")
    return mathml(latex, block=True)


def is_classical(patch: Patch) -> bool:
    """Tell whether a patch is built from the classical Bernstein basis."""
    return isinstance(patch.definition, Bezier) and patch.definition.basis == "bernstein"


def shape_text(patch: Patch) -> Markup:
    """Return the shape parameters with their names; empty where none act."""
    if not patch.shape or is_classical(patch):
        return Markup("")
    names = ("α", "ζ") if len(patch.shape) == 2 else ("α1", "ζ1", "α2", "ζ2")
    parts = [
        Markup("<i>{}</i>{} = {}").format(
            name[0], Markup("<sub>{}</sub>").format(name[1]) if name[1:] else "", number(x)
        )
        for name, x in zip(names, patch.shape, strict=True)
    ]
    return Markup(", ").join(parts)


def parameters(patch: Patch) -> tuple[tuple[str, float, bool], ...]:
    """Return the numbers other than control points and shape parameters that the file gives.

    Each comes with what it is, before it, and whether it is a length, after it.
    """
    found: list[tuple[str, float, bool]] = []
    for name, field in type(patch.definition).model_fields.items():
        value: Any = getattr(patch.definition, name)
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            found.append((field.description or name, float(value), name != "scale"))
    return tuple(found)


def nets(patch: Patch) -> Iterator[Net]:
    """Return the control points and planes of a patch, at most ``MOST_POINTS`` of each."""
    for name, field in type(patch.definition).model_fields.items():
        value: Any = getattr(patch.definition, name)
        if name in _OTHER or not isinstance(value, list):
            continue
        rows = list(_flat(cast(list[Any], value)))
        width = len(rows[0][1])
        letters = "abcd" if width == 4 else {"profile": "rz"}.get(name, "xyz"[:width])
        title = (field.description or name).split(";")[0]
        yield Net(title, tuple(letters), tuple(rows[:MOST_POINTS]), max(len(rows) - MOST_POINTS, 0))


def _flat(value: list[Any]) -> Iterator[tuple[str, tuple[float, ...]]]:
    """Walk nested lists of numbers down to the points, each with its indices."""
    if not isinstance(value[0], list):
        yield "", tuple(float(x) for x in value)
        return
    for index, item in enumerate(value):
        if isinstance(item[0], list):
            for rest, point in _flat(cast(list[Any], item)):
                yield f"{index}, {rest}", point
        else:
            yield str(index), tuple(float(x) for x in item)
