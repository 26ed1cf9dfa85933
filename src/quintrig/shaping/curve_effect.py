"""What shape parameters do to a curve: the same control points with several of them, and a table of measures."""

from collections.abc import Sequence
from dataclasses import dataclass

from quintrig.analysis.curve_summary import CurveSummary, summarise_curve
from quintrig.analysis.table import Column, Table
from quintrig.model.patch import NamedCurve
from quintrig.shaping.shape_effect import AS_GIVEN

_ROWS = (
    ("length", "length", r"\mbox{length}", "length", 1),
    ("curvature_min", "κ min", r"\kappa_{\min}", "curvature, min", -1),
    ("curvature_max", "κ max", r"\kappa_{\max}", "curvature, max", -1),
    ("torsion_min", "τ min", r"\tau_{\min}", "torsion, min", -1),
    ("torsion_max", "τ max", r"\tau_{\max}", "torsion, max", -1),
    ("bending_energy", "∫κ² ds", r"\int\kappa^2\,ds", "bending energy", -1),
)


@dataclass(frozen=True, eq=False)
class CurveVariant:
    """A curve with shape parameters, ``own`` where they are those of the model's file, and what it measures."""

    curve: NamedCurve
    summary: CurveSummary
    own: bool = False

    @property
    def parameters(self) -> str:
        """The shape parameters, such as ``(1, -3)``."""
        return f"({', '.join(f'{value:g}' for value in self.curve.shape)})"

    @property
    def label(self) -> str:
        """The shape parameters as a title, which says whose they are where they are the model's own."""
        return f"{self.parameters} {AS_GIVEN}" if self.own else self.parameters


def curve_variant(curve: NamedCurve, *, own: bool = False) -> CurveVariant:
    """Return a curve with what it measures; ``own`` says that its shape parameters are the model's."""
    return CurveVariant(curve, summarise_curve(curve.curve), own)


def curve_measures(found: Sequence[CurveVariant], unit: str = "", title: str = "") -> Table:
    """Return a table with a row for each variant: length, extreme curvature and torsion, bending energy."""
    plain, labels = tuple(one.parameters for one in found), tuple(one.label for one in found)
    columns = [Column("shape", "shape", r"\mathrm{shape}", "shape parameters", "", plain, labels)]
    plane = found[0].summary.plane
    for key, symbol, latex, name, power in _ROWS:
        if plane and key.startswith("torsion"):
            continue
        values = tuple(float(getattr(one.summary, key)) for one in found)
        measure = "" if not unit else unit if power > 0 else f"1/{unit}"
        columns.append(Column(key, symbol, latex, name, measure, values, values))
    notes = [
        f"Lengths in {unit}." if unit else "Lengths are plain numbers: the model states no unit.",
        "Curvature is positive where the curve turns left." if plane else "Curvature is not negative in space.",
        *(f"Shape parameters {AS_GIVEN}: {one.parameters}." for one in found if one.own),
        *(f"{one.parameters}: {line}" for one in found for line in one.summary.cautions),
    ]
    return Table(title, tuple(notes), tuple(columns), lead=1)
