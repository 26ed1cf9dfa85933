"""``quintrig strip``: the developable strip between two curves."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import Force

if TYPE_CHECKING:
    from quintrig.shaping.strips import Strips

_EPILOG = session.examples(
    ("quintrig strip rails.toml -o strip.toml", "a model of two curves; the strip is a ruled patch"),
    ("quintrig strip hull.toml -o hull_strips.toml --rails keel,chine,sheer", "a strip between each two neighbours"),
    ("quintrig strip rails.toml -o strip.toml --pieces 4", "cut along rulings into four that join smoothly"),
    ("quintrig flatten strip.toml strip.dxf --distortion 1e-4", "its flat pattern"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, strip, _EPILOG)


def strip(
    curves: Annotated[Path, typer.Argument(metavar="CURVES", help="Model of curves in space.", show_default=False)],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="OUT", help="Model to write, .toml or .json.")
    ] = None,
    first: Annotated[str | None, typer.Option(metavar="NAME", help="The first curve, of a model with more.")] = None,
    second: Annotated[str | None, typer.Option(metavar="NAME", help="The second curve.")] = None,
    rails: Annotated[
        str | None,
        typer.Option(
            metavar="NAMES",
            help="Curves in turn: keel,chine,sheer; fore+aft is one rail of two curves. By itself all, as they come.",
        ),
    ] = None,
    pieces: Annotated[int, typer.Option(metavar="N", min=1, max=64, help="Patches of each strip, cut at rulings.")] = 1,
    join: Annotated[
        Literal["G0", "G1"],
        typer.Option(help="At shared rails: G0 meets all rails, G1 continues the first strip smoothly."),
    ] = "G0",
    as_json: Annotated[bool, typer.Option("--json", help="Print twist, largest K, deviation and seams.")] = False,
    force: Force = False,
) -> None:
    """Span the best developable strips between curves, and say how nearly developable they are.

    Rulings join points at which both curves have the same tangent plane, as far as there are such; the first edge is
    the first curve, the second is fitted to the second curve run at the pace of the rulings. Two strips that share a
    rail are tangent along it only where they are one developable: the angle is told, and what a smooth one would miss.
    """
    if output is not None and output.suffix.lower() not in (".toml", ".json"):
        raise ValueError(f"-o: expected a name ending in .toml or .json, found {str(output)!r}")
    loaded = session.load_any(curves)
    labels = _labels(curves, [one.name for one in loaded.curves], first, second, rails)
    from quintrig.support.files import refuse_loss

    if output is not None:
        refuse_loss(output, curves, force=force)
    chosen = [[loaded.curve(part.strip()).curve for part in label.split("+")] for label in labels]
    unit = loaded.unit
    if len(chosen) == 2 and pieces == 1 and all(len(one) == 1 for one in chosen):
        from quintrig.shaping.strip import strip as make

        done = make(chosen[0][0], chosen[1][0], unit)
        told, model = done.to_dict(), done.model
        lines = _lines(done.twist, done.largest_gaussian, done.deviation, labels[1], unit)
    else:
        from quintrig.shaping.strips import strips as make_all

        row = make_all(chosen, names=labels, pieces=pieces, join=join, unit=unit)
        told, model = row.to_dict(), row.model
        lines = _row_lines(row, unit)
    if as_json:
        session.emit(json.dumps(told, ensure_ascii=False, allow_nan=False))
    else:
        for line in lines:
            session.emit(line)
        for note in told.get("notes", ()):
            session.remark(note)
    if output is not None:
        from quintrig.exchange.export import export

        session.told(export(model, output))


def _labels(file: Path, names: list[str], first: str | None, second: str | None, rails: str | None) -> list[str]:
    """Return which curves are the rails, in turn; a ``+`` joins several to one."""
    if rails is not None:
        if first is not None or second is not None:
            raise ValueError("--rails: expected without --first and --second; name all curves in one of the two ways")
        labels = [word.strip() for word in rails.split(",")]
        if len(labels) < 2 or not all(part.strip() for label in labels for part in label.split("+")):
            raise ValueError(f"--rails: expected two names or more such as keel,chine, got {rails[:60]!r}")
        return labels
    if first is None and second is None:
        if len(names) < 2:
            raise ValueError(f"{file}: expected a model of two curves or more, found {len(names)}")
        return names
    if (first is None or second is None) and len(names) != 2:
        raise ValueError(f"{file}: expected a model of two curves, found {len(names)}; name --first and --second")
    return [given or names[index] for index, given in enumerate((first, second))]


def _lines(twist: float, gauss: float, deviation: float, rail: str, unit: str) -> list[str]:
    return [
        f"twist: {twist:.4g}° at most along a ruling",
        f"largest |K|: {gauss:.4g}{f' 1/{unit}²' if unit else ''}",
        f"deviation from {rail}: {deviation:.4g}{f' {unit}' if unit else ''}",
    ]


def _row_lines(row: "Strips", unit: str) -> list[str]:
    result: list[str] = []
    for one in row.strips:
        count = f", {len(one.patches)} patches" if len(one.patches) > 1 else ""
        result.append(f"{one.name}{count}")
        values = _lines(one.twist, one.largest_gaussian, one.deviation, one.rails[1], unit)
        result += [f"  {line}" for line in values]
    for seam in row.seams:
        where = f"at {seam.along}" if seam.along is not None else "along a ruling"
        result.append(f"{seam.first} and {seam.second} join {seam.continuity} {where}: {seam.angle:.3g}° at most")
    return result
