"""``quintrig report``: one self-contained page about a model."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session
from quintrig.cli.options import Face, ModelFile, Whole
from quintrig.cli.scans import ScanUnit, curvature, is_scan
from quintrig.cli.style import with_style

if TYPE_CHECKING:
    from quintrig.figure.style import Style

_EPILOG = session.examples(
    ("quintrig report car_boot.toml out/car_boot", "writes the page into the folder out/car_boot"),
    ("quintrig report car_boot.toml out/car_boot --figures png,pdf", "with every picture and table as files"),
    ("quintrig report part.step out/face3 --face 3", "on a face of a CAD file"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, with_style(report), _EPILOG)


def report(
    model: ModelFile,
    out: Annotated[Path, typer.Argument(metavar="OUT", help="Folder or .html file to write.", show_default=False)],
    figures: Annotated[
        str, typer.Option("--figures", metavar="FORMATS", help="Pictures as files too, such as png,pdf; and tables.")
    ] = "",
    face: Face = None,
    whole: Whole = False,
    unit: ScanUnit = "",
    style: "Style | None" = None,
) -> None:
    """Write a page on a model: figures, tables, integrals, how far the methods agree, warnings.

    On a scan (.csv .xyz .ply .obj .stl) it shows the curvature of its points, with errors.
    """
    if is_scan(model):
        from quintrig.figure.style import STANDARD
        from quintrig.report.scan_page import write_scan_report

        session.done(write_scan_report(curvature(model, unit), out, figures.split(","), style or STANDARD))
        return
    loaded = session.load_any(model, face, whole)
    from quintrig.figure.style import STANDARD
    from quintrig.report import write_report

    formats, look = figures.split(","), style or STANDARD
    with session.progress() as progress:
        page = write_report(loaded, out, progress=progress, figures=formats, style=look, processes=None)
    session.done(page)
