"""``quintrig export``: a model as CAD file, mesh or control net."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import Force, ModelFile, OnlyPatch
from quintrig.cli.scans import ScanUnit, curvature, is_scan

_EPILOG = session.examples(
    ("quintrig export lid.toml lid.step", "the exact surface for CAD, read back and compared"),
    ("quintrig export lid.toml lid.igs --fit 3", "a cubic spline near it, for systems that refuse high degrees"),
    ("quintrig export lid.toml lid.glb --tolerance 0.05", "a mesh within 0.05, coloured by K"),
    ("quintrig export lid.toml lid.vtu --grid 200x200", "a mesh of 200 x 200 points with every curvature"),
    ("quintrig export lid.toml lid.csv", "the control nets: lid.csv, or lid-section.csv and others"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, export, _EPILOG)


def export(
    model: ModelFile,
    output: Annotated[
        Path,
        typer.Argument(
            metavar="OUT",
            help="CAD: .step .iges .brep .3dm; mesh: .stl .obj .ply .glb .vtu; net or model: .csv .json .toml; curves: "
            "CAD, .dxf .svg .csv .json .toml.",
            show_default=False,
        ),
    ],
    patch: OnlyPatch = None,
    face: Annotated[
        list[int] | None, typer.Option(metavar="N", help="Only this face of a CAD file. Repeatable.")
    ] = None,
    schema: Annotated[Literal["ap242", "ap214"], typer.Option(help="STEP: application protocol.")] = "ap242",
    fit: Annotated[
        int | None, typer.Option(metavar="DEGREE", help="CAD: a fit of this degree in place of the exact form.")
    ] = None,
    continuity: Annotated[
        int | None, typer.Option(metavar="K", help="Fit: order of continuity at its knots; degree - 1 by default.")
    ] = None,
    sew: Annotated[
        float | None, typer.Option(metavar="LENGTH", help="CAD: sew patches whose edges are this near.")
    ] = None,
    tolerance: Annotated[
        float | None,
        typer.Option(
            metavar="LENGTH",
            help="Mesh: largest chordal deviation, 1/1000 of the size by default. Fit: largest deviation, 1e-6 of it.",
        ),
    ] = None,
    grid: Annotated[str | None, typer.Option(metavar="NUxNV", help="Mesh: points along u and v instead.")] = None,
    colour: Annotated[str, typer.Option(metavar="KEY", help="Mesh: quantity to colour by, or none.")] = "gaussian",
    unit: ScanUnit = "",
    force: Force = False,
) -> None:
    """Write a model for other programs: CAD, mesh, or control net, by the ending of OUT.

    CAD files hold the exact rational form, with names and unit. They are read back, and the deviation is printed.
    Meshes keep to their tolerance, without gaps between patches, and carry curvature as colours and numbers.

    A .csv holds one net of points. Of a model with several nets, such as section and trajectory, OUT.csv becomes
    OUT-section.csv and OUT-trajectory.csv, and there is no OUT.csv. Every file written is named. Other files are
    replaced, and this is said; model files only with --force, and never the one that is read.

    A scan (.csv .xyz .ply .obj .stl) is written with the curvature of its points, as .ply, .csv or .json.
    """
    if is_scan(model):
        from quintrig.exchange.scan_files import export_scan
        from quintrig.support.files import refuse_loss as refuse

        refuse(output, model, force=force)
        replaced = output.is_file()
        found = curvature(model, unit)
        session.wrote(export_scan(found, output, None if colour == "none" else colour), replaced)
        return
    from quintrig.exchange.cad.fit import FitOptions
    from quintrig.exchange.cad.save import CadOptions
    from quintrig.exchange.export import ExportOptions, MeshOptions, targets
    from quintrig.exchange.export import export as write
    from quintrig.exchange.imports import open_model
    from quintrig.support.files import refuse_loss

    if continuity is not None and fit is None:
        raise ValueError("--continuity: belongs to a fit; give its degree with --fit")
    cad = CadOptions(schema, None if fit is None else FitOptions(fit, continuity, tolerance), sew)
    size = None if grid is None else session.counts(grid, "--grid")
    mesh = MeshOptions(None if fit is not None else tolerance, size, None if colour == "none" else colour)
    loaded = session.only(open_model(model, face), patch)
    for target in targets(loaded, output):
        refuse_loss(target, model, force=force)
    session.told(write(loaded, output, ExportOptions(cad, mesh)))
