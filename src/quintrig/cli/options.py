"""Arguments and options that several commands share, as types of their parameters."""

from pathlib import Path
from typing import Annotated

import typer

from quintrig.cli.show import list_quantities

ModelFile = Annotated[Path, typer.Argument(metavar="MODEL", help="Model file, or a CAD file.", show_default=False)]
Face = Annotated[int | None, typer.Option(metavar="N", help="Which face of a CAD file.")]
Whole = Annotated[bool, typer.Option("--whole", help="All of the surface that a trimmed face is cut from.")]
WhichPatch = Annotated[str | None, typer.Option(metavar="NAME", help="Which surface of a model with several.")]
OnlyPatch = Annotated[str | None, typer.Option(metavar="NAME", help="Only this surface of a model with several.")]
Force = Annotated[bool, typer.Option("--force", help="Replace a model file that exists already.")]
Listing = Annotated[
    bool,
    typer.Option("--list", help="Print the quantities there are and stop.", callback=list_quantities, is_eager=True),
]
