"""``quintrig table``."""

import typer

from quintrig.errors import QuintrigError


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command()(table)


def table() -> None:
    """Not built yet."""
    raise QuintrigError("table: not built yet")
