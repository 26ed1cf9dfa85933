"""``quintrig prove``: claims on all of a surface, proved, refuted or left open."""

import json
import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperCommand

from quintrig.cli import session
from quintrig.cli.ending import FOUND
from quintrig.cli.options import Face, ModelFile, OnlyPatch, Whole

if TYPE_CHECKING:
    from rich.console import Console

    from quintrig.enclosures.verdicts import Verdict

_COLOURS = {"proved": "green", "refuted": "red", "undecided": "yellow"}
_NEGATIVE = re.compile(r"-\s*[\d.].*[<>=]")
_MANY = 8  # proofs take a fraction of a second each: fewer need no bar
_EPILOG = session.examples(
    ("quintrig prove lid.toml regular 'gaussian > 0'", "on all of the surface, not only at samples"),
    ("quintrig prove lid.toml 'curvature_radius >= 30 mm'", "the smallest radius of curvature, or where it is less"),
    ("quintrig prove lid.toml 'draft >= 3 deg along z'", "the angle at which a mould opens"),
    ("quintrig prove lid.toml '-0.01 <= mean <= 0' --json", "a range, for programs"),
    ("quintrig prove lid.toml gaussian", "what surely encloses the values"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, prove, _EPILOG, cls=_Prove)


class _Prove(TyperCommand):
    """Takes claims that begin with a negative number for claims, not for options."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Set a blank before such claims, which nothing else of the command can be."""
        return super().parse_args(ctx, [f" {text}" if _NEGATIVE.match(text) else text for text in args])


def prove(
    model: ModelFile,
    claims: Annotated[
        list[str], typer.Argument(metavar="CLAIM...", help="Such as 'gaussian > 0' or regular.", show_default=False)
    ],
    as_json: Annotated[
        bool, typer.Option("--json", help="Print JSON: verdict, claim, boxes, witness, bounds; a list for several.")
    ] = False,
    patch: OnlyPatch = None,
    face: Face = None,
    whole: Whole = False,
    boxes: Annotated[int, typer.Option(metavar="N", help="Most boxes for a claim, on each chart.")] = 1024,
    output: Annotated[Path | None, typer.Option("-o", "--output", metavar="FILE", help="Write the JSON here.")] = None,
    strict: Annotated[bool, typer.Option("--strict", help="Exit with 1 where a claim is not proved.")] = False,
) -> None:
    """Prove claims on the whole of every patch: each is proved, refuted with a place where it fails, or undecided.

    Claims compare gaussian, mean, k1, k2, curvedness, curvature_radius, slope or draft with a number or a range, in the
    model's unit or in one of their own; angles take deg or rad, and a direction after 'along' (z by default). Others
    are regular, convex, developable, 'no fold' and 'inside hull'.

    A proof is of all points, and accounts for every rounding; samples are not asked.
    """
    from quintrig.analysis import proofs

    claims = [claim.strip() for claim in claims]
    loaded = session.only(session.load(model, face, whole), patch)
    if len(loaded.patches) * len(claims) > _MANY:
        with session.progress() as progress:
            found = proofs.prove(loaded, claims, bounds=True, boxes=boxes, progress=progress)
    else:
        found = proofs.prove(loaded, claims, bounds=True, boxes=boxes)
    if as_json or output:
        data = [verdict.to_dict() for verdict in found]
        text = json.dumps(data if len(data) > 1 else data[0], ensure_ascii=False, indent=1, allow_nan=False)
        session.deliver(f"{text}\n", output, model)
    else:
        console = session.output()
        for verdict in found:
            tell(verdict, console)
    if strict and not all(verdict.proved for verdict in found):
        raise typer.Exit(FOUND)


def tell(verdict: "Verdict", console: "Console", indent: str = "") -> None:
    """Print a verdict and what belongs to it."""
    from rich.markup import escape

    colour = _COLOURS[verdict.verdict]
    boxes = "1 box" if verdict.boxes == 1 else f"{verdict.boxes} boxes"
    console.print(
        f"{indent}[{colour}]{verdict.verdict:<10}[/{colour}]{escape(verdict.claim)}  [dim]{boxes}[/dim]", soft_wrap=True
    )
    for name, text in _lines(verdict):
        console.print(f"{indent}  [cyan]{name:<8}[/cyan]{escape(text)}", soft_wrap=True)


def _lines(verdict: "Verdict") -> list[tuple[str, str]]:
    unit = f" {verdict.unit}" if verdict.unit else ""
    lines: list[tuple[str, str]] = []
    if verdict.witness:
        at = verdict.witness
        point = ", ".join(f"{x:.6g}" for x in at.point)
        where = f'patch "{at.patch}", ' if at.patch else ""
        lines.append(("fails", f"{where}u = {at.u:.6g}, v = {at.v:.6g}, point ({point}): {at.value:.6g}{unit}"))
    if verdict.bounds:
        lines.append(("bounds", f"{verdict.bounds[0]:.6g} to {verdict.bounds[1]:.6g}{unit}"))
    for region in verdict.regions[:3]:
        where = f'patch "{region.patch}", ' if region.patch else ""
        text = f"{where}u {region.u[0]:.6g} to {region.u[1]:.6g}, v {region.v[0]:.6g} to {region.v[1]:.6g}"
        lines.append(("open", text))
    if len(verdict.regions) > 3:
        lines.append(("open", f"and {len(verdict.regions) - 3} more regions"))
    if verdict.why:
        lines.append(("why", verdict.why))
    return [*lines, *(("note", note) for note in verdict.notes)]
