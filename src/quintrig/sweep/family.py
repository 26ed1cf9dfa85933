"""The patches that a sweep varies, with those that their joins carry along, and one summary of them all."""

from collections.abc import Mapping, Sequence

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.model.held import carried
from quintrig.model.model import Model
from quintrig.support.arrays import FloatArray


class Family:
    """The patch of a model that is varied and those that follow it, or, without a name, all patches of the model."""

    def __init__(self, model: Model, name: str | None) -> None:
        """Find what is varied and what takes part."""
        self.model = model
        self.varied = model.patches if name is None else (model.patch(name),)
        self.names = tuple(one.name for one in model.patches) if name is None else carried(model.held, name)

    def design(self, values: Mapping[str, float]) -> Model:
        """Return the model of one design: a value goes to every varied patch that has a parameter of its name.

        Raises ModelError where a patch cannot be built, or the joins forbid it.
        """
        own = [{name: values[name] for name in values if name in one.definition.parameters} for one in self.varied]
        changed = (one.with_parameters(mine) for one, mine in zip(self.varied, own, strict=True) if mine)
        return self.model.replace(*changed)

    def surfaces(self, values: Mapping[str, float]) -> list[Surface]:
        """Return the surfaces of one design; ModelError as ``design``."""
        if len(self.names) == 1:  # no seam is looked at
            return [self.varied[0].with_parameters(values).surface]
        design = self.design(values)
        return [design.patch(name).surface for name in self.names]


def combined(rows: FloatArray, columns: Sequence[str]) -> FloatArray:
    """Return one summary of several (n, columns): ends of all, sums, and means and shares by area."""
    result = np.empty(len(columns))
    for at, name in enumerate(columns):
        values = rows[:, at]
        if name.endswith("_min"):
            result[at] = values.min()
        elif name.endswith("_max"):
            result[at] = values.max()
        elif name.endswith("_mean") or name.startswith("share_"):
            area = rows[:, columns.index("area")]
            result[at] = (values * area).sum() / area.sum()
        else:
            result[at] = values.sum()
    return result
