"""``quintrig deviation``: how far a scan or a CAD face is from a model."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import ModelFile, OnlyPatch

if TYPE_CHECKING:
    from quintrig.scan.deviation import Deviation
    from quintrig.scan.scan import Scan

PICTURES = (".png", ".svg", ".pdf", ".eps")
_EPILOG = session.examples(
    ("quintrig deviation lid.toml scan.ply", "how far the points of a scan are from the surface"),
    ("quintrig deviation lid.toml scan.csv --unit mm --tolerance 0.1", "and the share of them within 0.1"),
    ("quintrig deviation lid.toml scan.stl --align --json", "after moving the scan onto the surface, for programs"),
    ("quintrig deviation lid.toml scan.ply -o dev.png -o dev.csv", "a picture with a histogram, and every distance"),
    ("quintrig deviation lid.toml part.step --face 3 --from model", "from the surface to a face of a CAD file"),
)

Unit = Annotated[
    str, typer.Option(metavar="UNIT", help="Unit of the target where it states none: um, mm, cm, m, km, in, ft.")
]
TargetFace = Annotated[
    list[int] | None, typer.Option("--face", metavar="N", help="Only this face of a CAD target. Repeatable.")
]


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, deviation, _EPILOG)


def deviation(
    model: ModelFile,
    target: Annotated[
        Path,
        typer.Argument(
            metavar="TARGET",
            help="Points or mesh: .csv .xyz .txt .asc .pts .ply .obj .stl; or a CAD file, or a model.",
            show_default=False,
        ),
    ],
    tolerance: Annotated[
        float | None, typer.Option(metavar="LENGTH", help="Tell the share of the points within this distance.")
    ] = None,
    align: Annotated[
        bool, typer.Option("--align", help="Move the target onto the model first, as a rigid body.")
    ] = False,
    unit: Unit = "",
    source: Annotated[
        Literal["target", "model"],
        typer.Option("--from", help="Measure from points of the target, or from points of the model to a mesh or CAD."),
    ] = "target",
    face: TargetFace = None,
    patch: OnlyPatch = None,
    curvature: Annotated[
        bool, typer.Option("--curvature", help="Compare the curvature of the scan's points with the model's too.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON: min, max, mean, rms, percentiles, ...")] = False,
    output: Annotated[
        list[Path] | None,
        typer.Option(
            "-o", "--output", metavar="FILE", help="A picture (.png .svg .pdf), .csv, .ply or .json. Repeatable."
        ),
    ] = None,
) -> None:
    """Tell how far a target is from a model: the signed orthogonal distance of every point.

    Distances are positive where the target lies on the side that the model's normal points to. Points beyond the border
    of the surfaces are measured to the border, which is not orthogonal, and are told apart.
    """
    from quintrig.exchange.deviation_files import DEVIATION_SUFFIXES
    from quintrig.scan.deviation import deviation as measure
    from quintrig.support.progress import patient

    for file in output or []:
        if file.suffix.lower() not in (*PICTURES, *DEVIATION_SUFFIXES, ".json"):
            known = ", ".join((*PICTURES, *DEVIATION_SUFFIXES, ".json"))
            raise ValueError(f"{file}: expected a name ending in {known}")
    loaded = session.only(session.load(model), patch)
    aim: Any = read_target(target, unit, face)
    if source == "model" and aim.triangles is None:
        from quintrig.exchange.scans import SCAN_SUFFIXES as SCANS

        if target.suffix.lower() not in SCANS:
            from quintrig.exchange.imports import open_model

            aim = open_model(target, face)
    with session.progress() as progress:
        asked: Any = {"tolerance": tolerance, "align": align, "source": source, "progress": patient(progress)}
        result = measure(loaded, aim, **asked)
    for note in result.notes:
        session.remark(note)
    told = result.to_dict()
    if curvature:
        told["curvature"] = _gaps(result, aim, source)
    if as_json:
        session.emit(json.dumps(told, ensure_ascii=False, indent=1))
    else:
        _tell(result, told)
    for file in output or []:
        write(result, file, loaded.name, model, target)


def read_target(target: Path, unit: str, face: list[int] | None = None) -> "Scan":
    """Read a target; ModelError or QuintrigError in one line."""
    from quintrig.exchange.scans import open_target

    return open_target(target, unit, face)


def write(result: "Deviation", file: Path, title: str, *sources: Path) -> None:
    """Write a deviation as a picture, CSV, PLY or JSON, by the ending of the file, and say so."""
    from quintrig.support.files import refuse_loss

    suffix = file.suffix.lower()
    refuse_loss(file, *sources)
    replaced = file.is_file()
    if suffix in PICTURES:
        from quintrig.figure import save
        from quintrig.figure.deviation import deviation_picture

        session.wrote(save(deviation_picture(result, title), file), replaced)
    elif suffix == ".json":
        session.deliver(json.dumps(result.to_dict(), ensure_ascii=False, indent=1) + "\n", file, *sources)
    else:
        from quintrig.exchange.deviation_files import write_deviation

        session.wrote(write_deviation(result, file), replaced)


def _gaps(result: "Deviation", aim: Any, source: str) -> dict[str, Any]:
    from dataclasses import replace

    from quintrig.scan.beside_design import curvature_gaps
    from quintrig.scan.curvature import scan_curvature

    if source == "model":
        raise ValueError("--curvature: compares points of the target, not of the model; leave out --from model")
    normals = aim.normals if result.motion is None else aim.moved(result.motion.matrix).normals
    return curvature_gaps(result, scan_curvature(replace(aim, points=result.points, normals=normals)))


def _tell(result: "Deviation", told: dict[str, Any]) -> None:
    from quintrig.exchange.tables import shown
    from quintrig.scan.deviation import SIGN

    unit = f" {result.unit}" if result.unit else ""
    console = session.output()

    def row(name: str, text: str) -> None:
        console.print(f"  [cyan]{name:<12}[/cyan]{text}", soft_wrap=True)

    row("points", f"{len(result):,}")
    if result.motion is not None:
        moved = result.motion
        out = f"; {100 * moved.left_out:.2g} % of the points are outliers and did not count" if moved.left_out else ""
        row("aligned", f"turned by {moved.angle:.4g}°, points moved by up to {shown(moved.largest)}{unit}{out}")
    row("distance", f"{shown(result.min)} to {shown(result.max)}{unit}, {SIGN}")
    row("mean", f"{shown(result.mean)}{unit}")
    row("rms", f"{shown(result.rms)}{unit}")
    parts = ", ".join(f"{key} %: {shown(value, 4)}" for key, value in result.percentiles.items())
    row("percentiles", f"{parts}{unit}")
    if result.within is not None:
        row("within", f"{100 * result.within:.4g} % within ±{result.tolerance:g}{unit}")
    if result.edge.any():
        worst = float(abs(result.distance[result.edge]).max())
        inner = told["orthogonal"]["rms"]
        row("at edges", f"{int(result.edge.sum()):,} points beyond the border, up to {shown(worst)}{unit} from it")
        if inner is not None:
            row("", f"rms of the others {shown(inner)}{unit}")
    if len(result.names) > 1:
        for part in told["patches"]:
            if part["points"]:
                row("", f"{part['name']}: {part['points']:,} points, rms {shown(part['rms'])}{unit}")
    gaps: dict[str, Any] = told.get("curvature", {})
    for name, symbol in (("gaussian", "K"), ("mean", "H")):
        one = gaps.get(name)
        if one:
            per = f" {one['unit']}" if one["unit"] else ""
            share = f"{100 * one['within_error']:.3g} % within their error"
            row(f"{symbol}, scan", f"differs from the model's by {shown(one['rms'], 4)}{per} (rms), {share}")
