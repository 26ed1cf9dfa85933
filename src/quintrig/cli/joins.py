"""``quintrig joins``: which edges of a model's patches meet, and how smoothly."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import ModelFile
from quintrig.cli.show import print_table
from quintrig.support.errors import printable

if TYPE_CHECKING:
    from quintrig.model.model import Model
    from quintrig.multipatch.joins import Joins

_PICTURES = (".png", ".svg", ".pdf")
_EPILOG = session.examples(
    ("quintrig joins body.toml", "every seam: gap, angle, jump of curvature, order reached; free edges; near misses"),
    ("quintrig joins body.step --preset class-a", "faces of a CAD file, under the limits of visible surfaces"),
    ("quintrig joins body.toml --json", "the same for programs"),
    ("quintrig joins body.toml --tolerance 0.05 -o seams.csv", "a table; .tex for a paper"),
    ("quintrig joins body.toml -o seams.png", "a picture with each seam in the colour of its order"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, joins, _EPILOG)


def joins(
    model: ModelFile,
    preset: Annotated[
        Literal["class-a", "engineering"],
        typer.Option(help="Limits: class-a is 0.001 mm, 0.016°, 0.005; engineering 0.01 mm, 0.1°, 0.05."),
    ] = "engineering",
    tolerance: Annotated[float | None, typer.Option(metavar="LENGTH", help="Largest gap of a closed seam.")] = None,
    angle: Annotated[float | None, typer.Option(metavar="DEGREES", help="Largest angle of a G1 seam.")] = None,
    curvature: Annotated[
        float | None, typer.Option(metavar="PART", help="Largest relative jump of curvature of a G2 or G3 seam.")
    ] = None,
    near: Annotated[
        float, typer.Option(metavar="PART", help="Near misses: up to this part of an edge's length and width.")
    ] = 0.2,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON: joins, free edges, poles, limits.")] = False,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="Write .csv, .json, .md, .tex, .dxf, or a picture."),
    ] = None,
    view: Annotated[
        str, typer.Option(metavar="VIEW", help="Of a picture: iso, side, back, top, or AZIMUTH,ELEVATION.")
    ] = "iso",
    strict: Annotated[bool, typer.Option("--strict", help="Exit with 1 where a seam is nearly closed.")] = False,
) -> None:
    """Tell which edges meet, and how smoothly: open, G0, G1, G2 or G3.

    For every pair of neighbouring edges: the largest gap, the largest angle between the normals, and the largest
    jump of the normal curvature across the edge, relative to |κ1| + |κ2|. Edges that nearly meet are told as open.
    """
    loaded = session.load(model)
    result = loaded.joins(preset=preset, tolerance=tolerance, angle=angle, curvature=curvature, near=near)
    if output and output.suffix.lower() in _PICTURES:
        _draw(loaded, result, output, view)
    elif output and output.suffix.lower() == ".dxf":
        from quintrig.exchange.seams import seams_dxf

        session.deliver(seams_dxf(result), output, model)
    else:
        _tell(result, model, as_json, output)
    if strict and result.warnings:
        from quintrig.cli.ending import FOUND

        raise typer.Exit(FOUND)


def _draw(model: "Model", result: "Joins", output: Path, view: str) -> None:
    from quintrig.figure import save, seam_picture
    from quintrig.figure.camera import read_view

    replaced = output.is_file()
    figure = seam_picture([patch.surface for patch in model.patches], result, title=model.name, view=read_view(view))
    session.wrote(save(figure, output), replaced)


def _tell(result: "Joins", model: Path, as_json: bool, output: Path | None) -> None:
    from quintrig.exchange.tables import TABLE_FORMATS, WRITERS

    chosen = TABLE_FORMATS.get(output.suffix.lower()) if output and str(output) != "-" else None
    if output and not chosen and not as_json:
        raise ValueError(f"{output}: expected a name ending in {', '.join((*TABLE_FORMATS, *_PICTURES, '.dxf'))}")
    if as_json or chosen == "json":
        session.deliver(json.dumps(result.to_dict(), ensure_ascii=False, indent=1) + "\n", output, model)
    elif chosen:
        session.deliver(WRITERS[chosen](result.table()), output, model)
    else:
        from rich.markup import escape

        console = session.output()
        if len(result):
            print_table(result.table())
        else:
            for note in result.table().notes:
                session.emit(note)
        counts = ", ".join(f"{count} {order}" for order, count in result.counts.items() if count)
        seams = "1 seam" if len(result) == 1 else f"{len(result)} seams"
        session.emit(f"{seams}: {counts}" if counts else "no edges meet")
        for line in result.warnings:
            console.print(f"[yellow]warning   {escape(printable(line))}[/yellow]", soft_wrap=True)
