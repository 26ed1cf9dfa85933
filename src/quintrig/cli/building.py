"""What the commands that add patches to a model share: their options, and what they tell of the result."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session

if TYPE_CHECKING:
    from quintrig.builders.build import Built

OwnModel = Annotated[Path, typer.Argument(metavar="MODEL", help="Model of surfaces.", show_default=False)]
Output = Annotated[
    Path, typer.Option("-o", "--output", metavar="OUT", help="Model to write, .toml or .json.", show_default=False)
]
Hold = Annotated[
    bool, typer.Option("--hold", help="Keep the joins in the model file: the new patch follows its sides.")
]


def deliver(built: "Built", output: Path, source: Path, *, force: bool) -> None:
    """Write the model, and tell what was added, how its seams are and what else came of it."""
    if output.suffix.lower() not in (".toml", ".json"):
        raise ValueError(f"-o: expected a name ending in .toml or .json, found {str(output)!r}")
    from quintrig.exchange.export import export, targets
    from quintrig.support.files import refuse_loss

    for target in targets(built.model, output):
        refuse_loss(target, edited=source, force=force)
    for note in built.notes:
        session.remark(note)
    for seam in built.seams:
        session.remark(seam.describe(built.model.unit))
    session.told(export(built.model, output))
