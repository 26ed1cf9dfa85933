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


def curvature(path: Path, unit: str, neighbours: int | None = None, degree: int | None = None) -> "ScanCurvature":
    """Return the curvature of a scan; ModelError or QuintrigError in one line."""
    from quintrig.exchange.scans import read_scan
    from quintrig.scan.curvature import scan_curvature

    scan = read_scan(path, unit)
    for note in scan.notes:
        session.remark(note)
    return scan_curvature(scan, degree=degree, neighbours=neighbours)


def table_of(found: "ScanCurvature", quantities: Sequence[str] | None, all_points: bool) -> "Table":
    """Return the table of a scan: of all points, or of some spread evenly through the file for the screen."""
    import numpy as np

    from quintrig.scan.curvature_table import tabulate_scan

    count = len(found.scan.points)
    chosen = None if all_points or count <= _SHOWN else np.linspace(0, count - 1, _SHOWN).astype(int)
    if chosen is not None:
        session.remark(f"{_SHOWN} of {count:,} points, spread evenly through the file; -o FILE.csv has all")
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
