"""``quintrig fill``: a hole with four sides, filled."""

from typing import Annotated, Literal

import typer

from quintrig.cli import building, session
from quintrig.cli.options import Force

_EPILOG = session.examples(
    ("quintrig fill body.toml a:u1 b:v0 c:u0 d:v1 --order G1 -o body2.toml", "the hole between four patches"),
    ("quintrig fill curves.toml 'curve 1' 'curve 2' 'curve 3' 'curve 4' -o patch.toml", "a patch on four curves"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, fill, _EPILOG)


def fill(
    model: building.OwnModel,
    output: building.Output,
    sides: Annotated[
        list[str] | None,
        typer.Argument(metavar="[PATCH:SIDE | CURVE]...", help="Four of them, round the hole.", show_default=False),
    ] = None,
    order: Annotated[Literal["G0", "G1"], typer.Option(help="How smooth at the sides; G0 for curves.")] = "G0",
    name: Annotated[str, typer.Option(help="Name of the new patch.")] = "fill",
    hold: building.Hold = False,
    force: Force = False,
) -> None:
    """Add a patch in the hole between four sides, or make one on four curves (Coons).

    Nothing else moves. G1 is exact where the sides beside each other run on smoothly, else the best fit; the seams are
    measured and told.
    """
    loaded = session.load_any(model)
    from quintrig.builders.fill import filled

    building.deliver(filled(loaded, *(sides or []), order=order, name=name, hold=hold), output, model, force=force)
