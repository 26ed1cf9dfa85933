"""What commands do with a scan in the place of a model: the curvature of its points, with errors."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session

if TYPE_CHECKING:
    from quintrig.analysis.table import Table
    from quintrig.figure.style import Style
    from quintrig.scan.curvature import ScanCurvature

_SHOWN = 25  # points of a table on the screen
_SIDED = 20_000  # points that suffice to tell which way the normals of those point
_MOST = 2_000_000  # points with their curvature, in some minutes and GB

ScanUnit = Annotated[str, typer.Option("--unit", metavar="UNIT", help="Of a scan: its unit, where it states none.")]
Neighbours = Annotated[
    int | None, typer.Option(metavar="N", help="Of a scan: points around each that its curvature is taken from.")
]
Degree = Annotated[
    int | None, typer.Option(metavar="D", help="Of a scan: degree of the polynomials over them, 2 to 5.")
]


def is_scan(path: Path) -> bool:
    """Return whether a file is read as a scan, by its ending."""
    if path.suffix.lower() in (".toml", ".json"):
        return False
    from quintrig.exchange.scans import SCAN_SUFFIXES

    return path.suffix.lower() in SCAN_SUFFIXES


def curvature(
    path: Path, unit: str, neighbours: int | None = None, degree: int | None = None, most: int = _MOST
) -> "ScanCurvature":
    """Return the curvature of a scan, at no more than ``most`` points; ModelError or QuintrigError in one line."""
    from quintrig.exchange.scans import read_scan
    from quintrig.scan.curvature import scan_curvature
    from quintrig.support.progress import patient

    scan = read_scan(path, unit)
    for note in scan.notes:
        session.remark(note)
    count = len(scan.points)
    try:
        with session.progress() as progress:
            found = scan_curvature(scan, degree=degree, neighbours=neighbours, most=most, progress=patient(progress))
    except ValueError as error:
        if str(error).startswith("points:"):
            raise ValueError(f"{path}: {str(error).removeprefix('points: ').split('; take kind')[0]}") from None
        raise
    if count > most:
        session.remark(f"curvature at {most:,} of {count:,} points, spread evenly through the file")
    return found


def on_screen(
    path: Path, unit: str, neighbours: int | None, degree: int | None, quantities: Sequence[str] | None
) -> "Table":
    """Return a table of a few points of a scan."""
    import numpy as np

    from quintrig.scan.curvature_table import tabulate_scan

    found = curvature(path, unit, neighbours, degree, _SIDED)
    count = len(found.scan.points)
    chosen = np.linspace(0, count - 1, min(count, _SHOWN)).astype(int)
    if count > _SHOWN:
        session.remark(f"{_SHOWN} points, spread evenly through the file; -o FILE.csv has all")
    return tabulate_scan(found, quantities, chosen, found.scan.name)


def draw(
    path: Path,
    output: Path,
    quantities: str,
    view: str | None,
    style: "Style | None",
    unit: str,
    neighbours: int | None,
    degree: int | None,
) -> None:
    """Draw a scan in the colours of quantities."""
    from quintrig.figure.camera import read_view
    from quintrig.figure.plot import plot
    from quintrig.figure.save import DPI, kind_of, save
    from quintrig.figure.style import STANDARD
    from quintrig.quantities.drawn import read_quantities
    from quintrig.support.files import refuse_unwritable

    kind_of(output)
    refuse_unwritable(output)
    words, look = session.words(quantities), style or STANDARD
    read_quantities(words)
    read_view(view or "iso")
    found = curvature(path, unit, neighbours, degree)
    replaced = output.is_file()
    figure = plot(found, words, view=view, style=look)
    session.wrote(save(figure, output, look.dpi or DPI), replaced)
