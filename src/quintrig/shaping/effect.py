"""What shape parameters do to one part of a model."""

from collections.abc import Sequence
from dataclasses import dataclass

from quintrig.analysis.table import Table
from quintrig.shaping.curve_effect import CurveVariant
from quintrig.shaping.shape_effect import Variant


@dataclass(frozen=True, eq=False)
class Effect:
    """What shape parameters do to one patch or curve: its variants, their table, and of a body those of its seams."""

    name: str
    found: Sequence[Variant] | Sequence[CurveVariant]
    table: Table
    seams: Table | None = None
