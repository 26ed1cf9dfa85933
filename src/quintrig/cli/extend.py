"""``quintrig extend``: a patch that goes on past a side."""

from typing import Annotated, Literal

import typer

from quintrig.cli import building, session
from quintrig.cli.options import Force

_EPILOG = session.examples(
    ("quintrig extend body.toml hood:u1 --length 40 -o body2.toml", "straight on, G1"),
    ("quintrig extend body.toml hood:u1 --length 40 --order G2 -o body2.toml", "with the same bend"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, extend, _EPILOG)


def extend(
    model: building.OwnModel,
    side: Annotated[str, typer.Argument(metavar="PATCH:SIDE", help="Where it starts.", show_default=False)],
    output: building.Output,
    length: Annotated[float, typer.Option(metavar="LENGTH", help="How far it goes, in the mean.", show_default=False)],
    order: Annotated[Literal["G0", "G1", "G2", "G3"], typer.Option(help="How smooth at the side.")] = "G1",
    name: Annotated[str, typer.Option(help="Name of the new patch.")] = "extension",
    hold: building.Hold = False,
    force: Force = False,
) -> None:
    """Add a patch that goes on past a side: straight for G0 and G1, with its bend for G2 and G3.

    Nothing else moves. The seam is measured and told.
    """
    loaded = session.load(model)
    from quintrig.builders.strips import extended

    building.deliver(extended(loaded, side, length, order, name=name, hold=hold), output, model, force=force)
