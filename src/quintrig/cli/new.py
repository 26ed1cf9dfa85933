"""``quintrig new``: a commented starter model."""

from pathlib import Path
from typing import Annotated

import typer

from quintrig.cli import session

_EPILOG = session.examples(
    ("quintrig new swept", "writes swept.toml here"),
    ("quintrig new tensor -o models/bonnet.toml", "writes it under another name"),
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
            help="tensor, symmetric, swept, swung, ruled, developable, nurbs, curve, or a reference surface such as sphere; "
            "a wrong one lists them all.",
            show_default=False,
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="File to write, KIND.toml by default; - for the screen."),
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Replace an existing file.")] = False,
) -> None:
    """Write a starter model, valid and with comments that explain every key.

    Edit its points, then look at it with quintrig check, plot and report.
    """
    from quintrig.model.starter import starter

    text = starter(kind)
    target = output or Path(f"{kind}.toml")
    if target.suffix.lower() != ".toml" and str(target) != "-":
        raise ValueError(f"{target}: expected a name ending in .toml")
    session.deliver(text, target, force=force)
