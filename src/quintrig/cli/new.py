"""``quintrig new``."""

import typer

from quintrig.errors import QuintrigError


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command()(new)


def new() -> None:
    """Not built yet."""
    raise QuintrigError("new: not built yet")
