"""``quintrig design``: from demands to a shape."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session
from quintrig.cli.ending import FOUND
from quintrig.cli.options import Force

if TYPE_CHECKING:
    from quintrig.shaping.design import Design
    from quintrig.shaping.outcomes import Outcome

_INTERRUPTED = 130
_EPILOG = session.examples(
    ("quintrig design goals.toml -o better.toml", "what meets the demands with the least of what is minimised"),
    ("quintrig design goals.toml -o better.toml --starts 10 --state goals.json", "more starts; go on after Ctrl-C"),
    ("quintrig design goals.toml --json", "which demands are met and which bind, for programs"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, design, _EPILOG)


def design(
    goals: Annotated[Path, typer.Argument(metavar="GOALS", help="Goals file, .toml or .json.", show_default=False)],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="OUT", help="Model to write, .toml or .json.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print what was reached as JSON.")] = False,
    starts: Annotated[int, typer.Option(metavar="N", help="Places that the search starts from.")] = 3,
    seed: Annotated[int, typer.Option(metavar="N", help="Of the places at random.")] = 0,
    state: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Keep what was reached here, and go on from it.", show_default=False),
    ] = None,
    strict: Annotated[bool, typer.Option("--strict", help="Exit with 1 where a demand is not met.")] = False,
    force: Force = False,
) -> None:
    """Design a patch: the least of what is minimised that meets demands on all of the surface.

    The goals file names the model, what may vary (shape parameters, control points, sizes, with ranges), what is
    minimised (bending, thin_plate, variation, area, deviation or none: the least change) and the demands, such as
    "gaussian >= 0" or "curvature_radius >= 30".

    Demands that contradict each other are named, and the best compromise is written. Ctrl-C keeps the best so far.
    """
    if output is not None and output.suffix.lower() not in (".toml", ".json"):
        raise ValueError(f"-o: expected a name ending in .toml or .json, found {str(output)!r}")
    from quintrig.shaping.design import design as make
    from quintrig.shaping.goals import model_file
    from quintrig.support.files import refuse_loss

    if output is not None:
        refuse_loss(output, goals, model_file(goals), force=force)
    if state is not None:
        refuse_loss(state, goals, model_file(goals))
    with session.progress() as progress:
        done = make(goals, starts=starts, seed=seed, state=state, progress=progress)
    if as_json:
        session.emit(json.dumps(done.to_dict(), ensure_ascii=False, allow_nan=False))
    else:
        _tell(done)
    if output is not None:
        from quintrig.exchange.export import export

        session.told(export(done.model, output))
    if done.stopped:
        session.remark("interrupted: this is the best so far" + (f"; {state} goes on from it" if state else ""))
        raise typer.Exit(_INTERRUPTED)
    if strict and not done.met:
        raise typer.Exit(FOUND)


def _tell(done: "Design") -> None:
    for one in done.outcomes:
        session.emit(_line(one))
    if done.contradictions:
        several = len(done.contradictions) > 1
        what = " and ".join(done.contradictions)
        session.emit(
            f"{what}: contradict each other; this is the best compromise"
            if several
            else f"{what}: no design was found that meets it; this is the nearest (more --starts may come nearer)"
        )
    name = {"none": "change"}.get(done.minimised, done.minimised.replace("_", "-"))
    session.emit(f"{name}: {done.before:.6g} to {done.after:.6g}")
    patch = done.model.patch(done.patch)
    if patch.definition.parameters:
        values = ", ".join(f"{key} = {value:.6g}" for key, value in patch.definition.parameters.items())
        session.emit(values)
    for note in done.notes:
        session.remark(note)


def _line(one: "Outcome") -> str:
    word = "met" if one.met else "not met"
    where = "" if one.u is None else f" at u = {one.u:.4g}" + ("" if one.v is None else f", v = {one.v:.4g}")
    unit = f" {one.unit}" if one.unit else ""
    binds = ", binds" if one.binds and one.met else ""
    return f"{word:<8}{one.demand}: worst {one.worst:.6g}{unit}{where}{binds}, {one.verdict}"
