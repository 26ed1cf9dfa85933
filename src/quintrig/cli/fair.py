"""``quintrig fair``: the smoothest patch near a given one."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import Force, WhichPatch

if TYPE_CHECKING:
    from quintrig.model.model import Model
    from quintrig.shaping.fairing import Fairing

_EPILOG = session.examples(
    ("quintrig fair lid.toml -o fairer.toml", "moves the net, all four sides held"),
    ("quintrig fair lid.toml --vary shape -o fairer.toml", "changes the shape parameters alone"),
    (
        "quintrig fair lid.toml --energy bending --hold u0:G1 --within 0.5 -o fairer.toml",
        "one side and its tangents held",
    ),
    ('quintrig fair lid.toml --only "section[2]" -o fairer.toml', "moves one control point alone"),
    ("quintrig fair lid.toml -o fairer.toml --picture both.png", "before and after, side by side"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, fair, _EPILOG)


def fair(
    model: Annotated[Path, typer.Argument(metavar="MODEL", help="Model file, .toml or .json.", show_default=False)],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="OUT", help="Model to write, .toml or .json.")
    ] = None,
    energy: Annotated[
        str, typer.Option(metavar="NAME", help="What is to be least: thin-plate, bending or variation.")
    ] = "thin-plate",
    vary: Annotated[
        Literal["net", "shape", "both"], typer.Option(help="What may change: control points, shape parameters, both.")
    ] = "net",
    hold: Annotated[
        list[str] | None,
        typer.Option(
            metavar="PLACE",
            help="What stays: a side or a point, to an order, such as u0, v1:G2, 0.5,0.5:G1. Several times.",
            show_default=False,
        ),
    ] = None,
    within: Annotated[
        float | None, typer.Option(metavar="LENGTH", help="The farthest that a point may move.", show_default=False)
    ] = None,
    only: Annotated[
        list[str] | None,
        typer.Option(
            metavar="POINT",
            help="Only these control points or coordinates move, such as points[2][3] or section[1].z. Several times.",
            show_default=False,
        ),
    ] = None,
    patch: WhichPatch = None,
    picture: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="The patch before and after, with combs and zebra.", show_default=False),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print what was reached as JSON.")] = False,
    force: Force = False,
) -> None:
    """Make a patch, or a curve, fairer: the least energy near it, with what is held held.

    thin-plate and variation are integrals of squared second and third derivatives over (u, v), bending is that of
    κ1² + κ2² over the area. By default seams with neighbours are held to the order they have; where the net varies
    alone, all four sides stay. The energy that is asked for never rises.

    Of a curve --hold takes parameters, such as 0:G2 or 0.5; both ends are held to G1 by default, and bending is ∫κ² ds.
    """
    if output is not None and output.suffix.lower() not in (".toml", ".json"):
        raise ValueError(f"-o: expected a name ending in .toml or .json, found {str(output)!r}")
    loaded = session.load_any(model)
    from quintrig.shaping.fair import fair as make_fair
    from quintrig.support.files import refuse_loss

    if output is not None:
        refuse_loss(output, edited=model, force=force)
    if loaded.curves:
        if vary != "net" or picture is not None:
            raise ValueError(f"{model}: a curve is made fairer by its net, and has no picture here; leave both out")
        from quintrig.shaping.fair_curve import fair_curve

        done = fair_curve(loaded, curve=patch, energy=energy, hold=hold or None, within=within, only=only or ())
    else:
        done = make_fair(
            loaded, patch=patch, energy=energy, vary=vary, hold=hold or None, within=within, only=only or ()
        )
    if as_json:
        session.emit(json.dumps(done.to_dict(), ensure_ascii=False))
    else:
        _tell(done)
    if output is not None and loaded.curves:
        from quintrig.model.save import save

        save(done.model, output)
        session.wrote(output)
    elif output is not None:
        from quintrig.exchange.export import export

        session.told(export(done.model, output))
    if picture is not None and not loaded.curves:
        _draw(loaded, done, picture)


def _tell(done: "Fairing") -> None:
    unit = done.model.unit
    for name in ("thin_plate", "bending", "variation"):
        mark = " (asked for)" if name == done.energy else ""
        power = f" {unit}²" if unit and name != "bending" else f" 1/{unit}" if unit and done.of_curve else ""
        session.emit(f"{name.replace('_', '-')}: {done.before[name]:.6g} to {done.after[name]:.6g}{power}{mark}\n")
    session.emit(f"largest deviation: {done.deviation:.4g}{' ' + unit if unit else ''}\n")
    if done.held:
        session.emit(f"held: {', '.join(done.held)}\n")
    for note in done.notes:
        session.remark(note)


def _draw(before: "Model", done: "Fairing", path: Path) -> None:
    """Draw the patch before and after, with combs and in zebra, on one scale."""
    from quintrig.figure.fairness import fairness_picture
    from quintrig.figure.save import save

    surfaces = [one.patch(done.part).surface for one in (before, done.model)]
    figure = fairness_picture(surfaces, ["before", "after"], unit=done.model.unit)
    save(figure, path)
    session.wrote(path)
