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
    from quintrig.model.model import Model
    from quintrig.report.deviation import Beside

_EPILOG = session.examples(
    ("quintrig report car_boot.toml out/car_boot", "writes the page into the folder out/car_boot"),
    ("quintrig report car_boot.toml out/car_boot --figures png,pdf", "with every picture and table as files"),
    ("quintrig report lid.toml out/lid --target scan.ply --tolerance 0.1", "with how far a scan is from it"),
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
    target: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Tell how far this scan, CAD file or other model is from the model too."),
    ] = None,
    tolerance: Annotated[
        float | None, typer.Option(metavar="LENGTH", help="Of a target: the share of its points within this distance.")
    ] = None,
    align: Annotated[
        bool, typer.Option("--align", help="Move a target onto the model first, as a rigid body.")
    ] = False,
    style: "Style | None" = None,
) -> None:
    """Write a page on a model: figures, tables, integrals, how far the methods agree, warnings.

    On a scan (.csv .xyz .ply .obj .stl) it shows the curvature of its points, with errors.
    """
    if is_scan(model):
        from quintrig.figure.style import STANDARD
        from quintrig.report.scan_page import write_scan_report

        if target is not None:
            raise ValueError("--target: belongs to a model, found a scan in its place; turn the two about")
        session.done(write_scan_report(curvature(model, unit), out, figures.split(","), style or STANDARD))
        return
    loaded = session.load_any(model, face, whole)
    from quintrig.figure.style import STANDARD
    from quintrig.report import write_report

    beside = _beside(loaded, target, unit, tolerance, align)
    formats, look = figures.split(","), style or STANDARD
    with session.progress() as progress:
        page = write_report(loaded, out, progress=progress, figures=formats, style=look, processes=None, beside=beside)
    session.done(page)


def _beside(model: "Model", target: Path | None, unit: str, tolerance: float | None, align: bool) -> "Beside | None":
    """Return the deviation of a target that the page tells of; None without one."""
    if target is None:
        if align or tolerance is not None:
            raise ValueError(f"{'--align' if align else '--tolerance'}: expected a target too, --target FILE")
        return None
    from quintrig.cli.deviation import read_target
    from quintrig.report.deviation import Beside
    from quintrig.scan.deviation import deviation

    return Beside(target.name, deviation(model, read_target(target, unit), tolerance=tolerance, align=align))
