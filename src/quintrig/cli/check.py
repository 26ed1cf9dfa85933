"""``quintrig check``."""

import typer

from quintrig.errors import QuintrigError


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command()(check)


def check() -> None:
    """Not built yet."""
    raise QuintrigError("check: not built yet")
