"""``quintrig lines``: lines on a model, by their kind."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from quintrig.cli import session
from quintrig.cli.options import Face, ModelFile, OnlyPatch, Whole
from quintrig.support.errors import printable

if TYPE_CHECKING:
    from quintrig.interrogation.line import Lines

_EPILOG = session.examples(
    ("quintrig lines lid.toml curvature --spacing 100 -o net.dxf", "a net of lines of curvature, 100 mm apart"),
    ("quintrig lines lid.toml curvature --from 0.3,0.4", "the two lines through a point"),
    ("quintrig lines lid.toml curvature --umbilics -o out.svg", "the lines that leave umbilics"),
    ("quintrig lines lid.toml ridges --json", "crests and troughs with their strength"),
    ("quintrig lines lid.toml section --normal 1,0,0 --spacing 50 -o cuts.step", "a stack of plane sections"),
    ("quintrig lines lid.toml section --with tool.toml", "where another surface cuts it"),
    ("quintrig lines lid.toml geodesic --from 0.1,0.1 --to 0.9,0.8", "the straight line between two points"),
    ("quintrig lines lid.toml geodesic --from 0.1,0.1 --direction 30 --length 200", "one in a direction from S_u"),
    ("quintrig lines lid.toml contour -q gaussian --levels 0,1e-6", "where K has these values"),
    ("quintrig lines lid.toml draft --direction 0,0,1 --angles 0,3", "draft angles of 0° and 3° to the pull"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, lines, _EPILOG)


def _option(metavar: str, words: str, *names: str) -> Any:
    return typer.Option(*names, metavar=metavar, help=words, show_default=False)


def lines(
    model: ModelFile,
    kind: Annotated[
        str,
        typer.Argument(
            metavar="KIND",
            help="curvature, asymptotic, parabolic, mean-zero, ridges, isophotes, reflection, highlight, silhouette, "
            "contour, section, geodesic, iso or draft.",
            show_default=False,
        ),
    ],
    start: Annotated[str | None, _option("U,V", "Point to begin at.", "--from", "--start")] = None,
    to: Annotated[str | None, _option("U,V", "Second point of a geodesic.", "--to")] = None,
    to_patch: Annotated[str | None, _option("NAME", "Its patch.", "--to-patch")] = None,
    direction: Annotated[
        str | None,
        _option("X,Y,Z", "Light, view or pull; of a geodesic also degrees from S_u.", "--direction"),
    ] = None,
    eye: Annotated[str | None, _option("X,Y,Z", "Point to see from.", "--eye")] = None,
    light: Annotated[str | None, _option("X,Y,Z", "Point of the middle light.", "--light")] = None,
    along: Annotated[str | None, _option("X,Y,Z", "Direction of the lights.", "--along")] = None,
    angles: Annotated[str | None, _option("DEGREES", "Angles of isophotes or draft.", "--angles")] = None,
    quantity: Annotated[str | None, _option("KEY", "Quantity of contours.", "-q", "--quantity")] = None,
    levels: Annotated[str | None, _option("NUMBERS", "Its values.", "--levels")] = None,
    count: Annotated[int | None, _option("N", "How many levels, planes, lights or parameter lines.", "--count")] = None,
    spacing: Annotated[str | None, _option("LENGTH", "Between lines of a net, planes or lights.", "--spacing")] = None,
    normal: Annotated[str | None, _option("X,Y,Z", "Normal of the planes.", "--normal", "--plane")] = None,
    through: Annotated[str | None, _option("X,Y,Z", "Point of the first plane.", "--through")] = None,
    other: Annotated[Path | None, _option("MODEL", "Other surfaces to cut with.", "--with")] = None,
    u: Annotated[str | None, _option("NUMBERS", "Parameter lines of constant u.", "--u")] = None,
    v: Annotated[str | None, _option("NUMBERS", "Parameter lines of constant v.", "--v")] = None,
    family: Annotated[int | None, _option("1|2", "Only the family of κ1, or of κ2.", "--family")] = None,
    umbilics: Annotated[bool, typer.Option("--umbilics", help="The lines of curvature that leave umbilics.")] = False,
    length: Annotated[str | None, _option("LENGTH", "Longest line; of a geodesic, its length.", "--length")] = None,
    tolerance: Annotated[
        str | None, _option("LENGTH", "Largest chord error (usual: 1e-4 of the size).", "--tolerance")
    ] = None,
    patch: OnlyPatch = None,
    view: Annotated[str, typer.Option(metavar="VIEW", help="Of an .svg: iso, side, back or top.")] = "iso",
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", metavar="FILE", help="Write .csv, .json, .dxf, .svg, .3dm or .step.", show_default=False
        ),
    ] = None,
    face: Face = None,
    whole: Whole = False,
) -> None:
    """Find lines on a model: polylines in (u, v) and in space, with a stated chord error, through all its patches.

    Lengths are in the model's unit, angles in degrees.

    What each kind takes: curvature and asymptotic --spacing, --from, --family, --length (curvature --umbilics too);
    ridges --family; isophotes and draft --direction, --angles; silhouette --direction or --eye; reflection and
    highlight --light, --along, --spacing, --count (reflection --eye or --direction too); contour -q, --levels or
    --count; section --normal, --through, --spacing, --count, or --with; geodesic --from, and --direction and --length
    or --to; iso --u, --v or --count.
    """
    from quintrig.interrogation.find import lines as find

    loaded = session.load(model, face, whole)
    given: dict[str, Any] = {
        "start": _read(start, 2, "--from"),
        "to": _read(to, 2, "--to"),
        "to_patch": to_patch,
        "direction": _direction(direction),
        "eye": _read(eye, 3, "--eye"),
        "light": _read(light, 3, "--light"),
        "along": _read(along, 3, "--along"),
        "angles": _read(angles, None, "--angles"),
        "quantity": quantity,
        "levels": _read(levels, None, "--levels"),
        "count": count,
        "spacing": _one(spacing, "--spacing"),
        "normal": _read(normal, 3, "--normal"),
        "through": _read(through, 3, "--through"),
        "other": None if other is None else session.load(other),
        "u": _read(u, None, "--u"),
        "v": _read(v, None, "--v"),
        "family": family,
        "umbilics": umbilics or None,
        "length": _one(length, "--length"),
        "tolerance": _one(tolerance, "--tolerance"),
        "patch": patch,
    }
    _refuse_output(output)
    with session.progress() as show:
        found = find(loaded, kind, progress=show, **{key: value for key, value in given.items() if value is not None})
    if output is not None and str(output) != "-":
        from quintrig.exchange.lines import write_lines

        replaced = output.is_file()
        for note in write_lines(found, output, view):
            session.remark(note)
        session.wrote(output, replaced)
    if as_json:
        session.emit(json.dumps(found.to_dict(), ensure_ascii=False))
    elif output is None:
        _tell(found)
    for note in found.notes if not as_json else ():
        session.remark(note)


def _refuse_output(output: Path | None) -> None:
    from quintrig.support.files import refuse_unwritable

    if output is not None and str(output) != "-":
        from quintrig.exchange.lines import LINE_SUFFIXES

        if output.suffix.lower() not in LINE_SUFFIXES:
            raise ValueError(f"{output}: expected a name ending in {', '.join(LINE_SUFFIXES)}")
        refuse_unwritable(output)


def _read(text: str | None, count: int | None, name: str) -> tuple[float, ...] | None:
    return None if text is None else session.numbers(text, count, name)


def _one(text: str | None, name: str) -> float | None:
    return None if text is None else session.numbers(text, 1, name)[0]


def _direction(text: str | None) -> float | tuple[float, ...] | None:
    if text is None:
        return None
    return session.numbers(text, 3, "--direction") if "," in text else session.numbers(text, 1, "--direction")[0]


def _tell(found: "Lines") -> None:
    """Print a table of the lines."""
    from rich.table import Table

    unit = f" ({found.unit})" if found.unit else ""
    console = session.output()
    if len(found):
        table = Table()
        for heading in ("line", "patch", "chain", "points", f"length{unit}"):
            table.add_column(heading, justify="left" if heading in ("line", "patch") else "right")
        strong = any(line.strength is not None for line in found)
        if strong:
            table.add_column("strength", justify="right")
        for line in found.lines[:200]:
            row = [line.label + (", closed" if line.closed else ""), printable(line.patch), str(line.chain)]
            row += [str(len(line.uv)), f"{line.length:.6g}"]
            table.add_row(*row, *([f"{line.strength:.4g}"] if line.strength is not None else [""] if strong else []))
        console.print(table)
    ones = "1 line" if len(found) == 1 else f"{len(found)} lines"
    more = "; the first 200 are listed" if len(found) > 200 else ""
    session.emit(
        f"{found.kind}: {ones}, {found.length:.6g}{found.unit and ' ' + found.unit} in all; "
        f"chord error at most {found.chord_error:.2g}{found.unit and ' ' + found.unit}{more}"
    )
