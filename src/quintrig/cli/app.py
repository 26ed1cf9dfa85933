"""The typer application: one module of this package for each command."""

from collections.abc import Sequence
from importlib import import_module
from typing import Annotated

import typer

from quintrig import __version__

COMMANDS = (
    "new",
    "check",
    "table",
    "grid",
    "plot",
    "prove",
    "report",
    "compare",
    "deviation",
    "fit",
    "view",
    "export",
    "flatten",
    "import",
    "join",
    "joins",
    "lines",
    "umbilics",
    "mirror",
    "blend",
    "extend",
    "fill",
    "cap",
    "patches",
    "fair",
    "design",
    "strip",
    "reproduce",
    "sweep",
    "basis",
    "schema",
)
"""Every command, in the order of the help: a module of this package for each, read where it is asked for."""

_MODULES = {"import": "import_"}  # a word of Python

_HELP = """Quintic trigonometric Bézier surfaces: build them, read their curvature, decide.

A model is a small TOML or JSON file of control points and shape parameters.
"""

_EPILOG = "\n".join(
    (
        "[bold]First steps[/bold]",
        "  [cyan]quintrig new swept -o lid.toml[/cyan]",
        "  [cyan]quintrig check lid.toml[/cyan]",
        "  [cyan]quintrig report lid.toml out/lid[/cyan]",
        "",
        "[dim]Exit codes: 0 done; 1 check or prove --strict found problems; 2 a mistake in the command or the model; "
        "70 a fault in quintrig; 130 interrupted, 143 terminated.[/dim]",
    )
)


def build(words: Sequence[str] = ()) -> typer.Typer:
    """Return the application with the command that the words of a command line begin with, or else with all."""
    app = typer.Typer(
        name="quintrig",
        rich_markup_mode="rich",
        no_args_is_help=True,
        add_completion=False,
        pretty_exceptions_enable=False,
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    app.callback(help=_HELP, epilog=_EPILOG)(_options)
    named = next((word for word in words if not word.startswith("-")), "")
    for name in (named,) if named in COMMANDS else COMMANDS:
        import_module(f"quintrig.cli.{_MODULES.get(name, name)}").register(app)
    return app


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"quintrig {__version__}")
        raise typer.Exit


def _options(
    version: Annotated[
        bool, typer.Option("--version", help="Print the version and stop.", callback=_version, is_eager=True)
    ] = False,
    debug: Annotated[bool, typer.Option("--debug", help="Show the traceback of a failure.")] = False,
) -> None:
    """Read the options that stand before the command; ``run`` has taken --debug out already."""
