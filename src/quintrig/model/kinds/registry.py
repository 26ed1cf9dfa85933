"""All kinds by name: those of quintrig, and those that installed packages bring."""

from functools import cache
from typing import Any

from quintrig.model.kinds.closed_forms import (
    Catenoid,
    Cone,
    Cylinder,
    Ellipsoid,
    Enneper,
    Helicoid,
    HyperbolicParaboloid,
    MonkeySaddle,
    Sphere,
    Torus,
)
from quintrig.model.kinds.constructions import Developable, Ruled, Swept, Swung, Symmetric, Tensor
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.nurbs import Nurbs
from quintrig.support.plugins import with_plugins

GROUP = "quintrig.kinds"
"""Entry points of this group are subclasses of ``Definition``, by the name of their kind."""

CONSTRUCTIONS: tuple[type[Definition], ...] = (Tensor, Symmetric, Swept, Swung, Ruled, Developable)
"""Kinds of the thesis, built from control points or planes."""

REFERENCES: tuple[type[Definition], ...] = (
    Sphere,
    Ellipsoid,
    Cylinder,
    Cone,
    Torus,
    Catenoid,
    Helicoid,
    HyperbolicParaboloid,
    MonkeySaddle,
    Enneper,
)
"""Kinds with curvature in closed form."""

OWN: dict[str, type[Definition]] = {
    form.model_fields["kind"].default: form for form in (*CONSTRUCTIONS, Nurbs, *REFERENCES)
}
"""The kinds that quintrig itself brings."""


@cache
def kinds() -> dict[str, type[Definition]]:
    """Return every kind by name, those of installed packages last; QuintrigError where two have one name."""
    return with_plugins(GROUP, OWN, _accept)


def _accept(name: str, form: Any) -> type[Definition]:
    if not (isinstance(form, type) and issubclass(form, Definition)):
        raise ValueError(  # noqa: TRY004 — a mistake of a package, told as one
            f"expected a subclass of Definition, found {form!r}"
        )
    field = form.model_fields.get("kind")
    if field is None or field.default != name:
        raise ValueError(f"expected the key kind: Literal[{name!r}] = {name!r} on {form.__name__}")
    return form
