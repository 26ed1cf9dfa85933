"""``quintrig import``: faces and curves of CAD files, and control nets, as models."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import Force
from quintrig.cli.scans import ScanUnit, is_scan

if TYPE_CHECKING:
    from quintrig.model.model import Model
    from quintrig.support.arrays import FloatArray

_EPILOG = session.examples(
    ("quintrig import part.step --list", "what the file holds"),
    ("quintrig import part.step --face 3 -o face.toml", "one face as a model"),
    ("quintrig import frame.3dm --curve 2 -o section.csv", "a curve as six control points"),
    ("quintrig import frame.3dm --curve 2 --into lid.toml --key section -o lid2.toml", "the same, into a model"),
    ("quintrig import net.csv -o net.toml", "36 points as a tensor-product surface"),
)


def register(app: typer.Typer) -> None:
    """Add the command, whose name is a word of Python."""
    session.add(app, import_, _EPILOG, name="import")


def import_(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="FILE",
            help="STEP, IGES, BREP, 3DM, CSV or JSON file; a scan: XYZ, PLY, OBJ, STL.",
            show_default=False,
        ),
    ],
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="OUT", help="Model to write, .toml or .json; a net: .csv.")
    ] = None,
    listing: Annotated[bool, typer.Option("--list", help="Print what the file holds and stop.")] = False,
    face: Annotated[list[int] | None, typer.Option(metavar="N", help="Only this face. Repeatable.")] = None,
    curve: Annotated[int | None, typer.Option(metavar="N", help="This curve, as a control polygon.")] = None,
    shape: Annotated[
        str, typer.Option(metavar="α,ζ", help="Shape parameters of the six points that stand for a curve.")
    ] = "0,0",
    raw: Annotated[bool, typer.Option("--raw", help="The curve's own control points, as they are.")] = False,
    into: Annotated[Path | None, typer.Option(metavar="MODEL", help="Put the net into this model.")] = None,
    key: Annotated[str | None, typer.Option(metavar="KEY", help="Which net of it, such as section.")] = None,
    patch: Annotated[str | None, typer.Option(metavar="NAME", help="Which patch of it, if it has several.")] = None,
    kind: Annotated[
        Literal["tensor"], typer.Option(help="Kind of the model that a CSV or JSON net becomes.")
    ] = "tensor",
    unit: ScanUnit = "",
    force: Force = False,
) -> None:
    """Turn faces of CAD files into models, exactly, and curves and nets into control points.

    A face becomes a NURBS patch with its trim; every other command reads CAD files directly too. A model file that
    exists is replaced only with --force, and never the one that is read.
    """
    from quintrig.exchange.imports import CAD_SUFFIXES, contents
    from quintrig.support.errors import QuintrigError

    if _is_scan(file):
        _scan(file, output, unit, listing)
        return
    if listing:
        if is_scan(file):
            _scan(file, output, unit, listing)
            return
        if file.suffix.lower() not in CAD_SUFFIXES:
            from quintrig.exchange.scans import SCAN_SUFFIXES

            known = ", ".join((*CAD_SUFFIXES, *SCAN_SUFFIXES))
            raise QuintrigError(f"{file}: expected a CAD file or a scan to list ({known})")
        found = contents(file)
        unit = f", unit {found.unit}" if found.unit else ""
        session.emit(f"{found.name}: faces {len(found.faces)}, curves {len(found.curves)}{unit}")
        for item in found.faces:
            session.emit(f"face {item.number}: {item.name}: {item.described}")
        for item in found.curves:
            session.emit(f"curve {item.number}: {item.name}: {item.described}")
        return
    if output is None:
        raise QuintrigError("import: expected where to write, -o OUT, or --list")
    if curve is not None or into is not None:
        _net(file, output, face, curve, shape, raw, into, key, patch, force)
        return
    from quintrig.exchange.imports import open_model
    from quintrig.exchange.nets import NET_SUFFIXES, model_from_net

    if output.suffix.lower() not in NET_SUFFIXES:
        raise QuintrigError(f"{output}: expected a name ending in .toml, .json or .csv; quintrig export writes others")
    is_net = file.suffix.lower() in (".csv", ".json")
    if not is_net and file.suffix.lower() not in (*CAD_SUFFIXES, ".toml"):
        raise QuintrigError(f"{file}: expected a file ending in {', '.join(CAD_SUFFIXES)}, .csv or .json")
    model = model_from_net(file, {"kind": kind}) if is_net else open_model(file, face)
    _write(model, output, force, file)


def _is_scan(file: Path) -> bool:
    """Return whether a file holds points that are no control net: a CSV may be one."""
    return is_scan(file) and file.suffix.lower() != ".csv"


def _scan(file: Path, output: Path | None, unit: str, listing: bool) -> None:
    """Print what a scan holds, or write its points as CSV."""
    from quintrig.exchange.scans import read_scan
    from quintrig.support.errors import QuintrigError

    scan = read_scan(file, unit)
    for note in scan.notes:
        session.remark(note)
    if listing:
        mesh = f", triangles {len(scan.triangles):,}" if scan.triangles is not None else ""
        normals = ", with normals" if scan.normals is not None else ""
        session.emit(
            f"{scan.name}: points {len(scan.points):,}{mesh}{normals}, unit {scan.unit or 'none stated'}, "
            f"size {scan.size:.6g}"
        )
        return
    if output is None:
        raise QuintrigError("import: expected where to write, -o POINTS.csv, or --list")
    if output.suffix.lower() != ".csv":
        raise QuintrigError(f"{file}: a scan is written as .csv points; a fit makes a model of it (quintrig fit)")
    from quintrig.exchange.scans import to_csv

    session.deliver(to_csv(scan), output, file)


def _write(model: "Model", output: Path, force: bool, *sources: Path) -> None:
    from quintrig.exchange.export import export, targets
    from quintrig.support.files import refuse_loss

    for target in targets(model, output):
        refuse_loss(target, *sources, force=force)
    session.told(export(model, output))


def _net(
    file: Path,
    output: Path,
    face: list[int] | None,
    curve: int | None,
    shape: str,
    raw: bool,
    into: Path | None,
    key: str | None,
    patch: str | None,
    force: bool,
) -> None:
    """Write a curve's or face's control points as CSV, or into a model."""
    from quintrig.support.errors import QuintrigError

    points = _points(file, face, curve, shape, raw)
    if into is None:
        if output.suffix.lower() != ".csv":
            raise QuintrigError(f"{output}: expected a name ending in .csv for the points of a curve, or --into MODEL")
        from quintrig.exchange.nets import to_csv

        session.deliver(to_csv(points), output, file)
        return
    if key is None:
        raise QuintrigError("--into: expected the name of the net too, such as --key section")
    from quintrig.exchange.nets import put_into

    _write(put_into(session.load(into), patch, key, points), output, force, file, into)


def _points(file: Path, face: list[int] | None, curve: int | None, shape: str, raw: bool) -> "FloatArray":
    import numpy as np

    from quintrig.exchange.cad.faces import pick_curve, to_model
    from quintrig.exchange.imports import CAD_SUFFIXES, contents
    from quintrig.exchange.nets import polygon, read_points
    from quintrig.support.errors import QuintrigError

    if file.suffix.lower() not in CAD_SUFFIXES:
        return read_points(file)
    found = contents(file)
    if curve is None:
        net = to_model(found, str(file), face).surface.net
        if net is None:
            raise QuintrigError(f"{file}: expected a face with control points; choose another face")
        return net
    chosen = pick_curve(found, str(file), curve)
    if raw:
        return np.array(chosen.points)
    points, gap = polygon(chosen, session.numbers(shape, 2, "--shape"))
    session.remark(
        f"six control points: largest distance from the curve {gap:.3g}{' ' + found.unit if found.unit else ''}"
    )
    return points
