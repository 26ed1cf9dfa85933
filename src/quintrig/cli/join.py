"""``quintrig join``: sides of a body, or curves one after the other, made to meet smoothly."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import Force

if TYPE_CHECKING:
    from quintrig.geometry.curve_joins import Order
    from quintrig.model.model import Model

_EPILOG = session.examples(
    ("quintrig join body.toml hood:u1 roof:u0 --order G2 -o body2.toml", "moves the rows of roof as little as needed"),
    ("quintrig join body.toml hood:u1 roof:u0 --order G2 --both -o body2.toml", "moves both"),
    ("quintrig joins body2.toml", "measures the seams"),
    ("quintrig join a.toml b.toml -o both.toml", "curves: moves the first points of b, G2"),
    ("quintrig join pieces.toml --order G3 --ratio 0.8 -o smooth.toml", "the curves of one model, each to the next"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, join, _EPILOG)


def join(
    model: Annotated[
        Path, typer.Argument(metavar="MODEL", help="Model of surfaces, or of curves.", show_default=False)
    ],
    others: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[PATCH:SIDE PATCH:SIDE | MODEL...]",
            help="Of surfaces the side that stays and the one that moves, such as a:u1 b:u0; of curves more models.",
            show_default=False,
        ),
    ] = None,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="OUT", help="Model to write; - for the screen (curves).")
    ] = Path("-"),
    order: Annotated[
        Literal["G0", "G1", "G2", "G3"] | None,
        typer.Option(help="How smooth: G1 for surfaces, G2 for curves if not given.", show_default=False),
    ] = None,
    ratio: Annotated[
        float | None,
        typer.Option(
            metavar="κ", help="Speed after the join over that before it; that of least change (surfaces), or 1."
        ),
    ] = None,
    free: Annotated[float, typer.Option(metavar="μ", help="The free number of G2 joins of curves.")] = 0.0,
    both: Annotated[bool, typer.Option("--both", help="Move both sides.")] = False,
    convert: Annotated[
        bool, typer.Option("--convert", help="Make a tensor-product patch of what cannot join and keep its kind.")
    ] = False,
    hold: Annotated[
        bool, typer.Option("--hold", help="Keep the join in the model file: the second side follows from now on.")
    ] = False,
    force: Force = False,
) -> None:
    """Make sides of a body, or curves, meet smoothly: G0, G1, G2 or G3.

    Of surfaces the rows of the second side move as little as needed. It is exact where the functions along both edges
    are the same (equal shape parameters there), else by least squares; what is reached is measured and told. Sides are
    u0, u1, v0 and v1.

    Of curves each goes on from the end of the one before it, which moves its first control points: one for G0, two for
    G1, three for G2 and G3.
    """
    loaded, words = session.load_any(model), others or []
    if loaded.curves:
        result = _curves(loaded, model, words, order or "G2", 1.0 if ratio is None else ratio, free)
        from quintrig.model.toml import to_toml

        if output.suffix.lower() != ".toml" and str(output) != "-":
            raise ValueError(f"{output}: expected a name ending in .toml")
        session.deliver(to_toml(result.to_dict()), output, model, *map(Path, words), force=force)
        return
    if len(words) != 2:
        raise ValueError(f"{model}: expected two sides to join, such as a:u1 b:u0, found {len(words)}")
    if output.suffix.lower() not in (".toml", ".json"):
        raise ValueError(f"-o: expected a name ending in .toml or .json, found {str(output)!r}")
    from quintrig.exchange.export import export, targets
    from quintrig.support.files import refuse_loss

    joined = _sides(loaded, words[0], words[1], order or "G1", ratio, both, convert, hold)
    for target in targets(joined, output):
        refuse_loss(target, edited=model, force=force)
    session.told(export(joined, output))


def _sides(
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


def _curves(model: "Model", path: Path, others: list[str], order: "Order", ratio: float, free: float) -> "Model":
    """Join the curves of a model and of others, each to the next."""
    from quintrig.geometry.curve_joins import join_curves
    from quintrig.model.model import Model
    from quintrig.support.errors import ModelError

    loaded = [model, *(session.load_any(Path(other)) for other in others)]
    for name, one in zip([str(path), *others], loaded, strict=True):
        if not one.curves:
            raise ModelError(f"{name}: expected a model of curves, found surfaces")
    if len({one.unit for one in loaded}) > 1:
        found = ", ".join(one.unit or "none" for one in loaded)
        raise ModelError(f"unit: expected one for all the models, found {found}; state it alike")
    curves = [named.curve for one in loaded for named in one.curves]
    if len(curves) < 2:
        raise ModelError(f"{path}: expected two or more curves to join, found one; name another model")
    joined = curves[:1]
    for curve in curves[1:]:
        joined.append(join_curves(joined[-1], curve, order, ratio, free))
    return Model.of_curves(joined, model.name, model.unit)
