"""``quintrig compare``."""

import typer

from quintrig.errors import QuintrigError


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command()(compare)


def compare() -> None:
    """Not built yet."""
    raise QuintrigError("compare: not built yet")
