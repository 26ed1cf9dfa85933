"""What shape parameters do to a surface: the same control points with several of them, and a table of intensities."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

from quintrig.analysis.extremes import Extreme
from quintrig.analysis.integrate import INTEGRALS
from quintrig.analysis.quadrature import Integral
from quintrig.analysis.summary import Summary, summarise
from quintrig.analysis.table import Column, Table
from quintrig.basis.formulas import Parameter
from quintrig.model.patch import NamedCurve, Patch
from quintrig.quantities.table import BY_KEY
from quintrig.support.errors import ModelError
from quintrig.support.tolerance import typical_rounding

Part = TypeVar("Part", Patch, NamedCurve)

SHAPE_SETS: dict[int, tuple[tuple[float, ...], ...]] = {
    4: ((1, 1, 1, 1), (1, 1, -3, -3), (1, -3, 1, -3), (1, 0, -2, -3)),
    2: ((1, 1), (0, -4), (-2, 0), (-2, -4)),
}
"""The thesis's sets of shape parameters by their number: (α1, ζ1, α2, ζ2) for every surface of chapter 4 but the
enveloping developable, (α, ζ) for that (figures 4.29 to 4.32)."""

AS_GIVEN = "as in the file"
"""What is said of the model's own shape parameters."""

_INTENSITIES = ("gaussian", "mean")


@dataclass(frozen=True, eq=False)
class Variant:
    """A patch with shape parameters, ``own`` where they are those of the model's file, and its summary."""

    shape: tuple[float, ...]
    patch: Patch
    summary: Summary
    own: bool = False

    @property
    def parameters(self) -> str:
        """The shape parameters, such as ``(1, 1, -3, -3)``."""
        return spelt(self.shape)

    @property
    def label(self) -> str:
        """The shape parameters as a title, which says whose they are where they are the model's own."""
        return spelt(self.shape, own=self.own)


def spelt(shape: Sequence[float], *, own: bool = False) -> str:
    """Return shape parameters as a title, which says so where they are the model's ``own``."""
    parameters = f"({', '.join(f'{value:g}' for value in shape)})"
    return f"{parameters} {AS_GIVEN}" if own else parameters


def standard_shapes(patch: Patch | NamedCurve) -> tuple[tuple[float, ...], ...]:
    """Return the thesis's sets of shape parameters for this kind of surface; ModelError where it has none."""
    _check(patch)
    if patch.definition.standard:
        return SHAPE_SETS[len(patch.shape)]
    return _ends(list(patch.definition.ranges.values()))


def _ends(ranges: Sequence[Parameter]) -> tuple[tuple[float, ...], ...]:
    """Return all parameters at the high end, all at the low end, and both in turn; a tenth inside an end left out."""
    low = [one.low + 0.1 * (one.high - one.low) * one.open[0] for one in ranges]
    high = [one.high - 0.1 * (one.high - one.low) * one.open[1] for one in ranges]
    turns = [[i % 2 == turn for i in range(len(ranges))] for turn in (0, 1)]
    mixed = [[a if up else b for a, b, up in zip(high, low, turn, strict=True)] for turn in turns]
    return tuple(dict.fromkeys(map(tuple, (high, low, *mixed))))


def beside_own(patch: Part, shapes: Sequence[Sequence[float]]) -> tuple[Part, ...]:
    """Return the patch or curve as it is, then with each of several other sets of shape parameters.

    Raises ModelError where they do not fit or act.
    """
    _check(patch)
    others = tuple(patch.with_shape(shape) for shape in shapes)
    return (patch, *(other for other in others if other.shape != patch.shape))


def variant(patch: Patch, unit: str = "", *, own: bool = False) -> Variant:
    """Return a patch with its shape parameters and its summary; ``own`` says that they are the model's."""
    return Variant(patch.shape, patch, summarise(patch.surface, unit), own)


def intensities(found: Sequence[Variant], title: str = "") -> Table:
    """Return a table with a row for each variant: least, greatest and mean K and H, area and the other integrals.

    What grows without bound beside a singular point is infinite, what is undefined NaN; the notes say why.
    """
    unit = found[0].summary.unit
    plain, labels = tuple(one.parameters for one in found), tuple(one.label for one in found)
    columns = [Column("shape", "shape", r"\mathrm{shape}", "shape parameters", "", plain, labels)]
    for key in _INTENSITIES:
        q = BY_KEY[key]
        every = [one.summary.extremes[key] for one in found]
        for end, latex, values in (
            ("min", rf"{q.latex}_{{\min}}", [_end(one.minimum, -math.inf) for one in every]),
            ("max", rf"{q.latex}_{{\max}}", [_end(one.maximum, math.inf) for one in every]),
            ("mean", rf"\overline{{{q.latex}}}", [_integral(one.mean) for one in every]),
        ):
            words = (f"{key}_{end}", f"{q.symbol} {end}", latex, f"{q.name}, {end}")
            columns.append(Column(*words, q.unit(unit), tuple(values), _rounded(values, found, -q.power, False)))
    for q in INTEGRALS:
        values = tuple(_integral(one.summary.integrals[q.key]) for one in found)
        short = len(q.symbol) < 8
        words = (q.key, q.symbol if short else q.name, q.latex if short else rf"\mbox{{{q.name}}}", q.name)
        columns.append(Column(*words, q.unit(unit), values, _rounded(values, found, 2 - q.power, True)))
    return Table(title, _notes(found), tuple(columns), lead=1)


def _rounded(values: Sequence[float], found: Sequence[Variant], power: int, integral: bool) -> tuple[float, ...]:
    """Return the values with 0 for what is rounding beside the typical curvature to a power, or its integral."""
    floors: list[float] = []
    for one in found:
        floor = typical_rounding(one.summary.extremes["curvedness"].mean.value, -power)
        floors.append(floor * one.summary.integrals.area.value if integral else floor)
    return tuple(0.0 if abs(value) <= floor else value for value, floor in zip(values, floors, strict=True))


def _end(extreme: Extreme, limit: float) -> float:
    return limit if extreme.status == "unbounded" else extreme.value


def _integral(integral: Integral) -> float:
    return math.inf if integral.status == "grows without bound" else integral.value


def _notes(found: Sequence[Variant]) -> tuple[str, ...]:
    summary = found[0].summary
    formulas = "; ".join(f"{q.name}: {q.symbol}" for q in INTEGRALS if len(q.symbol) >= 8)
    notes = [
        f"Lengths in {summary.unit}." if summary.unit else "Lengths are plain numbers: the model states no unit.",
        f"{summary.orientation[0].upper()}{summary.orientation[1:]}; means are over the area.",
        f"{formulas[0].upper()}{formulas[1:]}.",
    ]
    notes += [f"Shape parameters {AS_GIVEN}: {one.parameters}." for one in found if one.own]
    told = ((one.parameters, line) for one in found for line in (*one.summary.warnings, *one.summary.notes))
    return (*notes, *(f"{label}: {line}" for label, line in told))


def _check(patch: Patch | NamedCurve) -> None:
    """Refuse a patch on which shape parameters do not act."""
    if patch.definition.classical:
        raise ModelError(
            f'patch "{patch.name}": a {patch.kind} in the Bernstein basis has no shape parameters to vary; take '
            'another basis, such as basis = "trigonometric"'
        )
    if not patch.shape:
        where = f"in this basis, a {patch.kind}" if patch.definition.bases_used else f"kind: a {patch.kind}"
        raise ModelError(f'patch "{patch.name}": {where} has no shape parameters to vary')
