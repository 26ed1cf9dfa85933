"""A surface or a model, as the model that is handed over, and the checks of what every tool is asked for."""

from collections.abc import Iterable
from operator import index

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.quantities.table import quantity

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


def pair(value: object, name: str) -> tuple[int, int]:
    """Return two numbers of points, along u and v; ValueError naming the argument."""
    try:
        nu, nv = (index(number) for number in value)  # pyright: ignore
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected two numbers of points, along u and v, found {value!r}") from None
    return nu, nv


def keys(quantities: Iterable[str] | str) -> list[str]:
    """Return the keys of quantities that are given by key or symbol, one or several; ValueError for others."""
    try:
        given = [quantities] if isinstance(quantities, str) else list(quantities)
        fine = all(isinstance(one, str) for one in given)  # pyright: ignore[reportUnnecessaryIsInstance]
    except TypeError:
        given, fine = [], False
    if not fine:
        raise ValueError(f"quantities: expected keys or symbols such as gaussian or K, found {quantities!r}")
    return [quantity(name).key for name in given]


def alone(value: Given) -> bool:
    """Return whether what is handed over is one patch, not a collection by name."""
    return not isinstance(value, Model) or len(value.patches) == 1
