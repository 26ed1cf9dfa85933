"""``quintrig blend``: a strip from one side of a body to another."""

from typing import Annotated, Literal

import typer

from quintrig.cli import building, session
from quintrig.cli.options import Force

_EPILOG = session.examples(
    ("quintrig blend body.toml hood:u1 fender:u0 --order G2 -o body2.toml", "a strip that meets both with equal bend"),
    ("quintrig blend body.toml hood:u1 fender:u0 --fullness 0.7 -o body2.toml", "sharper than an arc"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, blend, _EPILOG)


def blend(
    model: building.OwnModel,
    first: Annotated[str, typer.Argument(metavar="PATCH:SIDE", help="Where it starts.", show_default=False)],
    second: Annotated[str, typer.Argument(metavar="PATCH:SIDE", help="Where it ends.", show_default=False)],
    output: building.Output,
    order: Annotated[Literal["G0", "G1", "G2", "G3"], typer.Option(help="How smooth at both sides.")] = "G1",
    fullness: Annotated[float, typer.Option(help="1 is about a circular arc, less is sharper.")] = 1.0,
    name: Annotated[str, typer.Option(help="Name of the strip.")] = "blend",
    hold: building.Hold = False,
    force: Force = False,
) -> None:
    """Add a strip between two sides, as a fillet between two faces, smooth at both.

    Nothing else moves. The seams are measured and told.
    """
    loaded = session.load(model)
    from quintrig.builders.strips import blended

    built = blended(loaded, first, second, order, fullness, name=name, hold=hold)
    building.deliver(built, output, model, force=force)
