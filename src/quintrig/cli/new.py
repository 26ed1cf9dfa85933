"""``quintrig new``: a commented starter model."""

from pathlib import Path
from typing import Annotated

import typer

from quintrig.cli import session

_EPILOG = session.examples(
    ("quintrig new swept", "writes swept.toml here"),
    ("quintrig new tensor -o models/bonnet.toml", "writes it under another name"),
    ("quintrig new curve --through points.csv --closed", "curves through points, with continuous curvature"),
    ("quintrig new developable -o -", "prints it"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, new, _EPILOG)


def new(
    kind: Annotated[
        str,
        typer.Argument(
            metavar="KIND",
            help="tensor, symmetric, swept, swung, ruled, developable, nurbs, curve, or a reference surface such as "
            "sphere; a wrong one lists them all.",
            show_default=False,
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="File to write, KIND.toml by default; - for the screen."),
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace an existing file.")] = False,
    through: Annotated[
        Path | None, typer.Option(metavar="FILE.csv", help="Points, a row x,y or x,y,z each, for curves to go through.")
    ] = None,
    closed: Annotated[bool, typer.Option("--closed", help="Curves through points come back to the first.")] = False,
) -> None:
    """Write a starter model, valid and with comments that explain every key.

    Edit its points, then look at it with quintrig check, plot and report.
    """
    from quintrig.model.starter import starter

    if through is None and closed:
        raise ValueError("--closed: expected --through FILE.csv beside it")
    if through is not None and kind != "curve":
        raise ValueError(f"--through: expected the kind curve, got {kind[:40]!r}")
    remark = "Check it with: quintrig check FILE.toml"
    text = starter(kind, remark) if through is None else _through(through, closed)
    target = output or Path(f"{kind}.toml")
    if target.suffix.lower() != ".toml" and str(target) != "-":
        raise ValueError(f"{target}: expected a name ending in .toml")
    session.deliver(text, target, through, force=force)


def _through(file: Path, closed: bool) -> str:
    """Return a model of the curves through the points of a file."""
    from quintrig.geometry.curve_joins import interpolate
    from quintrig.model.model import Model
    from quintrig.model.reading import read_net
    from quintrig.model.toml import to_toml

    rows = read_net(file)
    if len({len(row) for row in rows}) != 1 or len(rows[0]) not in (2, 3):
        raise ValueError(f"{file}: expected rows of x,y or of x,y,z, all alike")
    try:
        curves = interpolate(rows, closed)
    except ValueError as error:
        raise ValueError(f"{file}: {error}") from None
    return to_toml(Model.of_curves(curves, "Curve through points").to_dict())
