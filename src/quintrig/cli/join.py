"""``quintrig join``: move one side of a model so that it joins another one."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import Force, ModelFile

if TYPE_CHECKING:
    from quintrig.model.model import Model

_EPILOG = session.examples(
    ("quintrig join body.toml hood:u1 roof:u0 --order G2 -o body2.toml", "moves the rows of roof as little as needed"),
    ("quintrig join body.toml hood:u1 roof:u0 --order G2 --both -o body2.toml", "moves both"),
    ("quintrig joins body2.toml", "measures the seams"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, join, _EPILOG)


def join(
    model: ModelFile,
    first: Annotated[str, typer.Argument(metavar="PATCH:SIDE", help="What stays, such as a:u1.", show_default=False)],
    second: Annotated[str, typer.Argument(metavar="PATCH:SIDE", help="What moves, such as b:u0.", show_default=False)],
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="OUT", help="Model to write, .toml or .json.", show_default=False)
    ],
    order: Annotated[Literal["G0", "G1", "G2", "G3"], typer.Option(help="How smooth the seam is to be.")] = "G1",
    ratio: Annotated[
        float | None,
        typer.Option(metavar="κ", help="Speed across the seam, second to first; otherwise that of least change."),
    ] = None,
    both: Annotated[bool, typer.Option("--both", help="Move both sides.")] = False,
    convert: Annotated[
        bool, typer.Option("--convert", help="Make a tensor-product patch of what cannot join and keep its kind.")
    ] = False,
    hold: Annotated[
        bool, typer.Option("--hold", help="Keep the join in the model file: the second side follows from now on.")
    ] = False,
    force: Force = False,
) -> None:
    """Move the rows of the second side, as little as needed, so that it joins the first: G0, G1, G2 or G3.

    It is exact where the functions along both edges are the same (equal shape parameters there), else by least
    squares; what is reached is measured and told. Sides are u0, u1, v0 and v1.
    """
    from quintrig.exchange.export import export, targets
    from quintrig.support.errors import QuintrigError
    from quintrig.support.files import refuse_loss

    if output.suffix.lower() not in (".toml", ".json"):
        raise QuintrigError(f"{output}: expected a name ending in .toml or .json")
    joined = _joined(session.load(model), first, second, order, ratio, both, convert, hold)
    for target in targets(joined, output):
        refuse_loss(target, model, force=force)
    session.told(export(joined, output))


def _joined(
    model: "Model", first: str, second: str, order: str, ratio: float | None, both: bool, convert: bool, hold: bool
) -> "Model":
    """Join patches of a model, and tell what was reached."""
    from quintrig.multipatch.attach import attach

    done = attach(model, first, second, order, ratio, both=both, convert=convert, hold=hold)
    for note in done.notes:
        session.remark(note)
    seam = done.join.describe(model.unit) if done.join else f"{first} and {second} do not meet along their length"
    session.remark(f"{seam}; ratio {done.ratio:.4g}")
    return done.model
