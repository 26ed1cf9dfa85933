"""``quintrig mirror``: the other half of a body."""

from typing import Annotated, Literal

import typer

from quintrig.cli import building, session
from quintrig.cli.options import Force

_EPILOG = session.examples(
    ("quintrig mirror quarter.toml --plane x=0 --order G2 -o half.toml", "images of all patches, the seam smooth"),
    (
        "quintrig mirror half.toml --plane 0,1,0,-1200 --order G0 -o body.toml",
        "in the plane y = 1200, a crease allowed",
    ),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, mirror, _EPILOG)


def mirror(
    model: building.OwnModel,
    output: building.Output,
    plane: Annotated[str, typer.Option(metavar="PLANE", help="x=0, y=5, z=-2, or a,b,c,d: ax+by+cz+d = 0.")] = "x=0",
    order: Annotated[Literal["G0", "G1", "G2"], typer.Option(help="How smooth across the plane.")] = "G1",
    near: Annotated[
        float, typer.Option(metavar="PART", help="Sides this near to the plane, of a patch's size, are laid on it.")
    ] = 0.05,
    convert: Annotated[
        bool, typer.Option("--convert", help="Make a tensor-product patch of what cannot keep its kind.")
    ] = False,
    force: Force = False,
) -> None:
    """Add the mirror image of every patch, and make the seams on the plane smooth.

    Sides that lie on the plane are laid on it exactly, and their next rows moved as little as needed. Images are called
    NAME_mirror, look to the same side of the body, and keep their kind.
    """
    loaded = session.load(model)
    from quintrig.builders.mirror import mirrored

    building.deliver(mirrored(loaded, plane, order, near=near, convert=convert), output, model, force=force)
