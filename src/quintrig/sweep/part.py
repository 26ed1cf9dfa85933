"""One part of a sweep: a run of designs and their summaries, computed anywhere from plain data."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from quintrig.analysis.edge_layers import layers_at_edges
from quintrig.analysis.integrate import orientation
from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import NamedCurve, Patch
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import BY_KEY
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ArgumentError, ModelError
from quintrig.sweep.affine import amounts_above, is_affine, weights
from quintrig.sweep.curves import CURVE_COLUMNS, curve_summary
from quintrig.sweep.family import Family, combined
from quintrig.sweep.measure import affine_measure, single_measure
from quintrig.sweep.nodes import WIDEST
from quintrig.sweep.space import DesignSpace, check
from quintrig.sweep.summarise import COLUMNS
from quintrig.sweep.unbounded import true_summaries

LARGEST_SIDE = 128


@dataclass(frozen=True)
class Task:
    """A whole sweep as plain data, which travels to other machines."""

    model: dict[str, Any]
    patch: str | None
    space: DesignSpace
    points: int = 32
    thresholds: Thresholds = field(default_factory=Thresholds)

    def __post_init__(self) -> None:
        """Check once, at birth."""
        if not 4 <= self.points <= LARGEST_SIDE:
            raise ArgumentError(f"expected 4 to {LARGEST_SIDE} a side, got {self.points}", "points")
        check(self.space, self.varied())

    def varied(self) -> tuple[Patch, ...] | tuple[NamedCurve, ...]:
        """Return what is varied: all patches, or all curves of a model without any, or the one of the name.

        Raises ModelError where there is none of the name.
        """
        model = Model.from_dict(self.model)
        if not model.patches or self.patch in [one.name for one in model.curves]:
            return model.curves if self.patch is None else (model.curve(self.patch),)
        return model.patches if self.patch is None else (model.patch(self.patch),)

    @cached_property
    def of_curve(self) -> bool:
        """Whether the designs are those of a curve."""
        return isinstance(self.varied()[0], NamedCurve)

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of all columns: the varied parameters, then the summaries."""
        return (*self.space.names, *(CURVE_COLUMNS if self.of_curve else COLUMNS))

    @property
    def side(self) -> str:
        """What the signs of the columns go by, in words."""
        if self.of_curve:
            return "curvature is positive where a plane curve turns left"
        found = dict.fromkeys(orientation(one.surface) for one in self.family().varied)
        return next(iter(found)) if len(found) == 1 else "each patch has a normal of its own"

    def unit_of(self, column: str) -> str:
        """Return the unit of a column in text, such as 1/mm²; empty for a pure number or where the model has none."""
        return column_unit(column, str(self.model.get("unit", "")), self.of_curve)

    def family(self) -> Family:
        """Return the patches that are varied with what their joins carry along."""
        return Family(Model.from_dict(self.model), self.patch)

    def to_dict(self) -> dict[str, Any]:
        """Return plain data that tells this sweep from every other."""
        return {
            "model": self.model,
            "patch": self.patch,
            "space": self.space.to_dict(),
            "points": self.points,
            "relative": self.thresholds.relative,
            "flat": self.thresholds.flat,
        }


def summaries(task: Task, start: int, stop: int) -> FloatArray:
    """Return designs ``start`` to ``stop`` and their summaries, (n, axes + columns).

    Each row depends on its design alone, so that parts computed anywhere, in any order, are the same to the last bit.
    """
    designs = task.space.designs(start, stop)
    if task.of_curve:
        curves = [one for one in task.varied() if isinstance(one, NamedCurve)]
        rows = [_of_curves(curves, dict(zip(task.space.names, design, strict=True))) for design in designs.tolist()]
        return np.concatenate([designs, np.stack(rows)], axis=1)
    family = task.family()
    patch = family.varied[0]
    if len(family.names) > 1:
        kept: dict[Surface, FloatArray] = {}
        result = np.stack([_together(task, family, design, kept) for design in designs.tolist()])
    elif is_affine(patch, task.space):
        measure = affine_measure(patch, task.space, designs, task.thresholds)
        still = amounts_above(weights(patch, task.space, designs), patch.kind == "ruled")
        result = true_summaries(measure, WIDEST * still, task.points, patch.surface)
    else:
        result = np.stack([_one(task, patch, design) for design in designs.tolist()])
    return np.concatenate([designs, result], axis=1)


def _one(task: Task, patch: Patch, design: list[float]) -> FloatArray:
    """Return the summary of one design, built anew."""
    try:
        surface = patch.with_parameters(dict(zip(task.space.names, design, strict=True))).surface
    except ModelError:  # planes that envelop no strip, say: a design without a single regular point
        result = np.full(len(COLUMNS), np.nan)
        result[COLUMNS.index("singular")] = task.points**2
        return result
    widths = np.array([layers_at_edges(surface)])
    return true_summaries(single_measure(surface, task.thresholds), widths, task.points, surface)[0]


def _together(task: Task, family: Family, design: list[float], kept: dict[Surface, FloatArray]) -> FloatArray:
    """Return the summary of one design of several patches, taken together; ``kept`` keeps those of what stays."""
    try:
        surfaces = family.surfaces(dict(zip(task.space.names, design, strict=True)))
    except ModelError:  # a design that its joins cannot all meet has none
        result = np.full(len(COLUMNS), np.nan)
        result[COLUMNS.index("singular")] = task.points**2 * len(family.names)
        return result
    own = {one.surface for one in family.model.patches}
    rows: list[FloatArray] = []
    for surface in surfaces:
        row = kept.get(surface)
        if row is None:
            widths = np.array([layers_at_edges(surface)])
            row = true_summaries(single_measure(surface, task.thresholds), widths, task.points, surface)[0]
            kept |= {surface: row} if surface in own else {}
        rows.append(row)
    return combined(np.array(rows), COLUMNS)


def _of_curves(curves: Sequence[NamedCurve], values: Mapping[str, float]) -> FloatArray:
    """Return the summary of one design of a curve, or of several taken together."""
    own = [{name: values[name] for name in values if name in one.definition.parameters} for one in curves]
    rows = [curve_summary(one, mine) for one, mine in zip(curves, own, strict=True)]
    return combined(np.array(rows), tuple(CURVE_COLUMNS))


def columns(space: DesignSpace) -> tuple[str, ...]:
    """Return the names of all columns: the varied parameters, then the summaries."""
    return (*space.names, *COLUMNS)


def column_unit(name: str, length: str, of_curve: bool = False) -> str:
    """Return the unit of a column in text, such as 1/mm²; empty for a pure number or where the model has no unit."""
    if of_curve:
        power = CURVE_COLUMNS.get(name, 0)
        return "" if not (length and power) else length if power > 0 else f"1/{length}"
    key = name.rpartition("_")[0]
    if key in BY_KEY:
        return BY_KEY[key].unit(length)
    return f"{length}²" if length and name in ("area", "thin_plate_energy") else ""
