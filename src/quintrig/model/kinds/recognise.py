"""The definition of a surface that was built without one."""

from typing import Literal

from pydantic import ValidationError

from quintrig.geometry.surface import Surface
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.registry import kinds


class Bare(Definition):
    """Surface made in Python, of rows that no kind of model has."""

    kind: Literal["surface"] = "surface"

    def surface(self) -> Surface:
        """Refuse: only the program that made it can make it again."""
        raise ValueError("a surface made in Python of rows that no kind of model has cannot be built from a file")


def recognised(surface: Surface) -> Definition:
    """Return the definition by which the first kind that can would build the surface; ``Bare`` where none would."""
    for form in kinds().values():
        keys = form.recognised(surface)
        if keys is None:
            continue
        try:
            return form.model_validate({"flip": surface.flip, **keys})
        except ValidationError:  # a number that no model file may hold
            continue
    return Bare(flip=surface.flip)
