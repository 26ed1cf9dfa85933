"""``quintrig join``: curves one after the other, with continuous tangent, curvature or slope of curvature."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from quintrig.cli import session

_EPILOG = session.examples(
    ("quintrig join a.toml b.toml -o both.toml", "moves the first points of b, G2"),
    ("quintrig join pieces.toml --order G3 --ratio 0.8 -o smooth.toml", "the curves of one model, each to the next"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, join, _EPILOG)


def join(
    models: Annotated[
        list[Path], typer.Argument(metavar="MODEL...", help="Models of curves, in order.", show_default=False)
    ],
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="FILE", help="File to write; - for the screen.")
    ] = Path("-"),
    order: Annotated[Literal["G0", "G1", "G2", "G3"], typer.Option(help="How smooth the joins are.")] = "G2",
    ratio: Annotated[float, typer.Option(metavar="NUMBER", help="Speed after a join over that before it.")] = 1.0,
    free: Annotated[float, typer.Option(metavar="NUMBER", help="The free number μ of G2 joins.")] = 0.0,
    force: Annotated[bool, typer.Option("--force", help="Replace an existing file.")] = False,
) -> None:
    """Join curves: each goes on from the end of the one before it, which moves its first control points.

    One for G0, two for G1, three for G2 and G3; the curves before stay as they are.
    """
    from quintrig.geometry.curve_joins import join_curves
    from quintrig.model.model import Model
    from quintrig.model.toml import to_toml
    from quintrig.support.errors import ModelError

    if output.suffix.lower() != ".toml" and str(output) != "-":
        raise ValueError(f"{output}: expected a name ending in .toml")
    loaded = [session.load_any(path) for path in models]
    for path, model in zip(models, loaded, strict=True):
        if not model.curves:
            raise ModelError(f"{path}: expected a model of curves, found surfaces")
    if len({model.unit for model in loaded}) > 1:
        found = ", ".join(model.unit or "none" for model in loaded)
        raise ModelError(f"unit: expected one for all the models, found {found}; state it alike")
    curves = [one.curve for model in loaded for one in model.curves]
    if len(curves) < 2:
        raise ModelError(f"{models[0]}: expected two or more curves to join, found one; name another model")
    joined = curves[:1]
    for curve in curves[1:]:
        joined.append(join_curves(joined[-1], curve, order, ratio, free))
    result = Model.of_curves(joined, loaded[0].name, loaded[0].unit)
    session.deliver(to_toml(result.to_dict()), output, *models, force=force)
