"""A scan with its curvature as PLY with colours and numbers, or as a table."""

from pathlib import Path

import numpy as np

from quintrig.exchange.deviation_files import ply_of
from quintrig.exchange.tables import TABLE_FORMATS as TABLES
from quintrig.exchange.tables import WRITERS
from quintrig.quantities.table import quantity
from quintrig.scan.curvature import VALUES, ScanCurvature
from quintrig.scan.curvature_table import notes_of, tabulate_scan
from quintrig.support.errors import QuintrigError
from quintrig.support.files import write_whole

SCAN_CURVATURE_SUFFIXES = (".ply", *TABLES)
"""Endings of the files that a scan's curvature is written to."""


def export_scan(found: ScanCurvature, path: Path, colour: str | None = "gaussian") -> Path:
    """Write a scan with its curvatures and their errors, PLY in colours; QuintrigError for other endings."""
    suffix = path.suffix.lower()
    if suffix in TABLES:
        return write_whole(path, WRITERS[TABLES[suffix]](tabulate_scan(found, title=found.scan.name)))
    if suffix != ".ply":
        raise QuintrigError(
            f"{path}: expected a name ending in {', '.join(SCAN_CURVATURE_SUFFIXES)} for the curvature of a scan"
        )
    from quintrig.figure import palette

    values = {key: np.asarray(found[key], dtype=np.float64) for key in VALUES}
    values |= {f"{key}_error": found.errors[key] for key in VALUES}
    values |= {"border": found.border.astype(np.float64)}
    grey = np.full((len(found.scan.points), 3), 0.6)
    if colour is None:
        shades = grey
    else:
        q = quantity(colour)
        inner = np.where(found.border, np.nan, found[q.key]) if q.kind != "class" else found[q.key]
        if q.kind == "class":
            shades = palette.class_colours(found[q.key], q.key)
        else:
            shades = palette.real_colours(found[q.key], q, palette.limits(inner, q))
    unit = f"unit {found.scan.unit or 'none stated'}"
    notes = tuple(" ".join(note.split()) for note in notes_of(found))
    colours = np.round(255.0 * np.nan_to_num(np.asarray(shades)[:, :3], nan=0.6)).astype(np.uint8)
    return write_whole(path, ply_of(found.scan.points, values, colours, (unit, *notes), found.scan.triangles))
