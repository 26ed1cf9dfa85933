"""A patch that is varied, with the patches that its joins carry along, and one summary of them all."""

from collections.abc import Mapping

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.model.held import carried
from quintrig.model.model import Model
from quintrig.support.arrays import FloatArray
from quintrig.sweep.summarise import COLUMNS


class Family:
    """The patch of a model that is varied, and the names of its followers."""

    def __init__(self, model: Model, name: str | None) -> None:
        """Find what follows the patch."""
        self.model, self.patch = model, model.patch(name)
        self.followers = carried(model.held, self.patch.name)[1:]

    def surfaces(self, values: Mapping[str, float]) -> list[Surface]:
        """Return the surface of one design, and those of its followers; ModelError where the joins forbid it."""
        changed = self.patch.with_parameters(values)
        if not self.followers:
            return [changed.surface]
        moved = self.model.with_patch(changed)
        return [moved.patch(name).surface for name in (self.patch.name, *self.followers)]


def combined(rows: FloatArray) -> FloatArray:
    """Return one summary of several (n, columns): ends of all, sums, and means and shares by area."""
    area = rows[:, COLUMNS.index("area")]
    result = np.empty(len(COLUMNS))
    for at, name in enumerate(COLUMNS):
        values = rows[:, at]
        if name.endswith("_min"):
            result[at] = values.min()
        elif name.endswith("_max"):
            result[at] = values.max()
        elif name.endswith("_mean") or name.startswith("share_"):
            result[at] = (values * area).sum() / area.sum()
        else:
            result[at] = values.sum()
    return result
