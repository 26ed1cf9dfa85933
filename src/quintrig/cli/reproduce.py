"""``quintrig reproduce``: the figures and tables of the thesis, rebuilt on one page."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session
from quintrig.cli.style import with_style

if TYPE_CHECKING:
    from quintrig.figure.style import Style

_EPILOG = session.examples(
    ("quintrig reproduce out/thesis", "builds every figure and table into one page"),
    ("quintrig reproduce out/figure --only 4.3", "one figure or table alone"),
    ("quintrig reproduce --list", "prints the inventory: number, what it shows, model and view"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, with_style(reproduce), _EPILOG)


def reproduce(
    out: Annotated[Path | None, typer.Argument(metavar="OUT", help="Folder to write.", show_default=False)] = None,
    only: Annotated[
        list[str] | None,
        typer.Option("--only", metavar="NUMBER", help="Build these alone, such as 4.3 or table-4.1. Repeatable."),
    ] = None,
    inventory: Annotated[bool, typer.Option("--list", help="Print the inventory and build nothing.")] = False,
    style: "Style | None" = None,
) -> None:
    """Rebuild the figures and tables of the thesis into one page to browse."""
    if out is None and not inventory:
        raise ValueError("OUT: expected a folder to write to, or --list to see what would be built")
    from quintrig import reproduce as thesis

    if out is None:
        session.emit(thesis.inventory_text())
        return
    wanted = [word.strip() for text in only or [] for word in text.split(",")]
    keys = thesis.chosen(wanted) if wanted else None
    # A process takes as long to start as a few pictures to draw.
    processes = 1 if keys is not None and len(keys) < 5 else None
    with session.progress() as progress:
        page = thesis.write_reproduction(out, progress=progress, only=keys, style=style, processes=processes)
    session.done(page)
