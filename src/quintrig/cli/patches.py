"""``quintrig patches``: patches through a grid of points."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from quintrig.cli import building, session
from quintrig.cli.options import Force

_EPILOG = session.examples(
    ("quintrig patches scan.csv --grid 9x6 --order G2 -o body.toml", "8 x 5 patches through 9 x 6 points"),
    ("quintrig patches scan.csv --grid 90x60 --patches 4x3 -o body.toml", "4 x 3 patches as near to them as can be"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, patches, _EPILOG)


def patches(
    points: Annotated[
        Path, typer.Argument(metavar="POINTS.csv", help="Rows of x,y,z, v running fastest.", show_default=False)
    ],
    output: building.Output,
    grid: Annotated[str, typer.Option(metavar="NUxNV", help="Points along u and v.", show_default=False)],
    order: Annotated[Literal["G1", "G2"], typer.Option(help="How smooth from patch to patch.")] = "G2",
    number: Annotated[
        str | None, typer.Option("--patches", metavar="PxQ", help="Patches along u and v; else one between points.")
    ] = None,
    unit: Annotated[str, typer.Option(help="Unit of length of the model.")] = "",
    force: Force = False,
) -> None:
    """Make a body of patches that meet smoothly, through a grid of points or as near to it as so many can come."""
    import numpy as np

    from quintrig.builders.build import Built
    from quintrig.builders.grid import gridded
    from quintrig.model.reading import in_rows, read_net

    rows, columns = session.counts(grid, "--grid")
    found = in_rows(read_net(points), columns, str(points))
    if len(found) != rows:
        raise ValueError(f"--grid: expected {len(found)}x{columns} for the points of {points}, found {grid}")
    net = np.array(found)
    wanted = session.counts(number, "--patches", least=1) if number else None
    model, away = gridded(net, order, wanted, name=points.stem, unit=unit)
    notes = (f"the points lie up to {away:.3g} {unit}".rstrip() + " off the patches",) if wanted else ()
    built = Built(model, tuple(one.name for one in model.patches), (), notes)
    building.deliver(built, output, points, force=force)
