"""``quintrig cap``: a closed edge, capped."""

from typing import Annotated, Literal

import typer

from quintrig.cli import building, session
from quintrig.cli.options import Force

_EPILOG = session.examples(
    ("quintrig cap vase.toml vase:u1 -o closed.toml", "a round side, by one patch that ends in a point"),
    ("quintrig cap tube.toml a:u1 b:u1 c:u1 d:u1 --order G2 -o closed.toml", "a loop of sides, by a patch each"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, cap, _EPILOG)


def cap(
    model: building.OwnModel,
    sides: Annotated[
        list[str],
        typer.Argument(metavar="PATCH:SIDE...", help="A closed side, or a loop of sides.", show_default=False),
    ],
    output: building.Output,
    order: Annotated[Literal["G0", "G1", "G2", "G3"], typer.Option(help="How smooth at the sides.")] = "G1",
    height: Annotated[
        float | None, typer.Option(metavar="LENGTH", help="Of the point over the middle of the edge.")
    ] = None,
    name: Annotated[str, typer.Option(help="Name of the cap.")] = "cap",
    hold: building.Hold = False,
    force: Force = False,
) -> None:
    """Cap a closed edge: a patch from each side to one point, with one tangent plane there.

    Nothing else moves. The seams are measured and told.
    """
    loaded = session.load(model)
    from quintrig.builders.cap import capped

    built = capped(loaded, *sides, order=order, height=height, name=name, hold=hold)
    building.deliver(built, output, model, force=force)
