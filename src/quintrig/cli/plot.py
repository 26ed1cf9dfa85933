"""``quintrig plot``."""

import typer

from quintrig.errors import QuintrigError


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command()(plot)


def plot() -> None:
    """Not built yet."""
    raise QuintrigError("plot: not built yet")
