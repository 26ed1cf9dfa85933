"""What each kind of surface is: in words, as a formula, and by the parameters that its file gives."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, cast

from markupsafe import Markup

from quintrig.basis.formulas import Basis
from quintrig.model.patch import NamedCurve, Patch
from quintrig.report.mathml import mathml
from quintrig.report.wording import digits_of

MOST_POINTS = 400
"""Control points that the page lists of each net; the rest are in the model file."""


@dataclass(frozen=True)
class Net:
    """Control points or planes as the file gives them: a row for each, named by its indices, ``left_out`` not shown."""

    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, tuple[float, ...]], ...]
    left_out: int


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


_OTHER = ("shape", "basis", "trim", "knots", "weights", "degrees")


def formula(patch: Patch | NamedCurve) -> Markup:
    """Return the formula of a patch or curve as MathML."""
    latex = patch.definition.formula
    if not latex:
        return Markup("")
    if not patch.definition.standard:
        latex = re.sub(r";\\alpha(_\d)?,\\zeta(_\d)?", "", latex)
        for letter, points in zip("ij", (*patch.definition.point_counts, 0), strict=False):
            latex = latex.replace(rf"\sum_{{{letter}=0}}^{{5}}", rf"\sum_{{{letter}=0}}^{{{points - 1}}}")
    if patch.definition.classical:
        latex = latex.replace("f_i(", "B_i(").replace("f_j(", "B_j(")
    return mathml(latex, block=True)


def other_bases(patches: Sequence[Patch]) -> tuple[Basis, ...]:
    """Return the bases of patches that are not the quintic one, each once."""
    used = (basis for patch in patches if not patch.definition.standard for basis in patch.definition.bases_used)
    return tuple(basis for basis in dict.fromkeys(used) if basis.name not in ("trigonometric", "quintic"))


def shape_text(patch: Patch) -> Markup:
    """Return the shape parameters with their names; empty where none act."""
    names = patch.definition.shape_symbols
    if not names:
        return Markup("")
    parts = [
        Markup("<i>{}</i>{} = {}").format(
            name[0], Markup("<sub>{}</sub>").format(name[1]) if name[1:] else "", digits_of(x)
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
        value: list[Any] = getattr(patch.definition, name)
        if name in _OTHER or not isinstance(value, list):  # pyright: ignore[reportUnnecessaryIsInstance]
            continue
        rows = list(_flat(value))
        width = len(rows[0][1])
        letters = "abcd" if width == 4 else {"profile": "rz"}.get(name, "xyz"[:width])
        title = (field.description or name).split(";")[0]
        if not patch.definition.standard and name != "bounds":
            counts = [len(points) for points in (value, value[0]) if isinstance(points[0], list)]
            title = re.sub(r"^\d+( x \d+)?", " x ".join(map(str, counts)), title)
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
