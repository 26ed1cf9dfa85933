"""Surfaces as build123d's faces, exact where a rational form exists."""

from typing import Any

from quintrig.exchange.cad.forms import written_carriers
from quintrig.exchange.tools.whole import Given, whole
from quintrig.support.extras import need


def to_build123d(value: Given) -> Any:
    """Return a build123d.Face, of several patches a Shell where they hang together and else a Compound.

    Raises as ``Handed.to_build123d`` says.
    """
    build123d = need("build123d", "to_build123d")
    from quintrig.exchange.cad.occ import down_to, explored, quiet
    from quintrig.exchange.cad.shell import shell

    model = whole(value)
    for patch in model.patches:
        if patch.surface.trim:
            raise ValueError(
                f'to_build123d: patch "{patch.name}" is a trimmed face, which is not handed over yet; '
                "hand over its surface.carrier, the whole surface without loops"
            )
    with quiet():
        result = shell(written_carriers(model))
    if len(model.patches) == 1:
        face = build123d.Face(down_to("Face", explored(result.shape, "FACE")[0]))
        face.label = model.patches[0].name
        return face
    shells = explored(result.shape, "SHELL")
    if len(shells) == 1 and len(explored(result.shape, "FACE")) == len(model.patches):
        whole_shape = build123d.Shell(down_to("Shell", shells[0]))
    else:
        whole_shape = build123d.Compound(children=[build123d.Face(down_to("Face", face)) for face in result.faces])
    whole_shape.label = model.name
    return whole_shape
