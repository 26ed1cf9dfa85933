"""What shape parameters do to the seams of a model: each seam of what changes, with each set of them."""

from collections.abc import Sequence

import numpy as np

from quintrig.analysis.table import Column, Table
from quintrig.model.held import carried
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.multipatch.joins import Join
from quintrig.support.errors import ModelError


def with_variant(model: Model, patch: Patch) -> Model | None:
    """Return the model with a patch of other shape parameters and what follows it; None where its joins forbid it."""
    try:
        return model.with_patch(patch)
    except ModelError:
        return None


def seam_effect(model: Model, name: str, variants: Sequence[Patch], labels: Sequence[str]) -> Table:
    """Return a table with a row for each set of shape parameters and seam of the patch or of what follows it.

    Gap (length¹), angle of the normals (degrees) and relative jump of curvature are the greatest along the seam; a set
    that the joins forbid has one row that says so.
    """
    moving = set(carried(model.held, name))
    rows: list[tuple[str, str, str, str, float, float, float]] = []
    for patch, label in zip(variants, labels, strict=True):
        changed = with_variant(model, patch)
        if changed is None:
            rows.append((label, "", "", "refused", np.nan, np.nan, np.nan))
            continue
        seams: list[Join] = list(changed.joins(of=moving))
        rows += [
            (label, str(one.first), str(one.second), one.order, one.gap.most, one.angle.most, one.curvature.most)
            for one in seams
        ]
    followers = ", ".join(carried(model.held, name)[1:]) or "no other patch"
    notes = (
        "Seams of the patch that is varied and of those that follow it by [[join]] tables: "
        f"{name} carries {followers} along; largest gap, angle of the normals and relative jump of curvature.",
    )
    texts = (
        _column(("shape", "shape"), "", tuple(row[0] for row in rows)),
        _column(("first", "first edge"), "", tuple(row[1] for row in rows)),
        _column(("second", "second edge"), "", tuple(row[2] for row in rows)),
        _column(("order", "order"), "", tuple(row[3] for row in rows)),
    )
    numbers = (
        _column(("gap", "gap"), model.unit, tuple(row[4] for row in rows)),
        _column(("angle", "angle"), "°", tuple(row[5] for row in rows)),
        _column(("curvature", "rel. jump"), "", tuple(row[6] for row in rows)),
    )
    return Table(f"{model.name}: seams by shape parameters of {name}", notes, (*texts, *numbers), lead=3)


def _column(head: tuple[str, str], unit: str, values: tuple[str, ...] | tuple[float, ...]) -> Column:
    key, symbol = head
    return Column(key, symbol, rf"\mathrm{{{symbol}}}", symbol, unit, values, values)
