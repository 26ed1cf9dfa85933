"""A surface or a model, as the model that is handed over."""

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch


def whole(value: Surface | Model) -> Model:
    """Return a model as it is and a surface as the only patch of one; ModelError where there are curves alone."""
    if isinstance(value, Surface):
        return Model("surface", "", (Patch.of(value),))
    value.refuse_curves()
    return value


def alone(value: Surface | Model) -> bool:
    """Return whether what is handed over is one patch, not a collection by name."""
    return isinstance(value, Surface) or len(value.patches) == 1
