"""``quintrig strip``: the developable strip between two curves."""

import json
from pathlib import Path
from typing import Annotated

import typer

from quintrig.cli import session
from quintrig.cli.options import Force

_EPILOG = session.examples(
    ("quintrig strip rails.toml -o strip.toml", "a model of two curves; the strip is a ruled patch"),
    ("quintrig flatten strip.toml strip.dxf --distortion 1e-4", "its flat pattern"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, strip, _EPILOG)


def strip(
    curves: Annotated[Path, typer.Argument(metavar="CURVES", help="Model of two curves in space.", show_default=False)],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="OUT", help="Model to write, .toml or .json.")
    ] = None,
    first: Annotated[str | None, typer.Option(metavar="NAME", help="The first curve, of a model with more.")] = None,
    second: Annotated[str | None, typer.Option(metavar="NAME", help="The second curve.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print twist, largest K and deviation as JSON.")] = False,
    force: Force = False,
) -> None:
    """Span the best developable strip between two curves, and say how nearly developable it is.

    Rulings join points at which both curves have the same tangent plane, as far as there are such; the first edge is
    the first curve, the second is fitted to the second curve run at the pace of the rulings.
    """
    if output is not None and output.suffix.lower() not in (".toml", ".json"):
        raise ValueError(f"-o: expected a name ending in .toml or .json, found {str(output)!r}")
    loaded = session.load_any(curves)
    names = [one.name for one in loaded.curves]
    if (first is None or second is None) and len(names) != 2:
        raise ValueError(f"{curves}: expected a model of two curves, found {len(names)}; name --first and --second")
    from quintrig.shaping.strip import strip as make
    from quintrig.support.files import refuse_loss

    if output is not None:
        refuse_loss(output, curves, force=force)
    pair = [loaded.curve(given or names[index]).curve for index, given in enumerate((first, second))]
    done = make(pair[0], pair[1], loaded.unit)
    if as_json:
        session.emit(json.dumps(done.to_dict(), ensure_ascii=False, allow_nan=False))
    else:
        unit = loaded.unit
        session.emit(f"twist: {done.twist:.4g}° at most along a ruling")
        session.emit(f"largest |K|: {done.largest_gaussian:.4g}{f' 1/{unit}²' if unit else ''}")
        session.emit(f"deviation from the second curve: {done.deviation:.4g}{f' {unit}' if unit else ''}")
    if output is not None:
        from quintrig.exchange.export import export

        session.told(export(done.model, output))
