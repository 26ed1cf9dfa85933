"""A surface or a model, as the model that is handed over."""

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch

Given = Surface | Patch | Model
"""What is handed over."""


def whole(value: Given) -> Model:
    """Return a model as it is, a patch or surface as the only one of a model; ModelError for curves alone."""
    if isinstance(value, Surface):
        value = Patch.of(value)
    if isinstance(value, Patch):
        return Model(value.name, "", (value,))
    value.refuse_curves()
    return value


def alone(value: Given) -> bool:
    """Return whether what is handed over is one patch, not a collection by name."""
    return not isinstance(value, Model) or len(value.patches) == 1
