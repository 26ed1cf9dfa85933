"""``quintrig report``: one self-contained page about a model."""

from pathlib import Path
from typing import Annotated

import typer

from quintrig.cli import session

_EPILOG = session.examples(
    ("quintrig report car_boot.toml out/car_boot", "writes the page into the folder out/car_boot"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, report, _EPILOG)


def report(
    model: Annotated[Path, typer.Argument(metavar="MODEL", help="Model file, .toml or .json.", show_default=False)],
    out: Annotated[Path, typer.Argument(metavar="OUT", help="Folder or .html file to write.", show_default=False)],
) -> None:
    """Write a page on a model: figures, tables, integrals, how far the methods agree, warnings."""
    loaded = session.load(model)
    from quintrig.report import write_report

    with session.progress() as progress:
        page = write_report(loaded, out, progress=progress)
    session.done(page)
