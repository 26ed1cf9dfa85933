"""What a shape is measured against in the studio: a target beside it, demands on it, and the fairest one near it."""

import base64
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from quintrig.exchange.imports import CAD_SUFFIXES
from quintrig.exchange.scans import SCAN_SUFFIXES, open_target
from quintrig.model.model import Model
from quintrig.scan.deviation import Deviation, deviation
from quintrig.scan.scan import Scan
from quintrig.shaping.asked import judged
from quintrig.shaping.fair import fair
from quintrig.shaping.fair_curve import fair_curve
from quintrig.shaping.fairing import Fairing
from quintrig.studio import folder
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError

TARGETS = (*SCAN_SUFFIXES, *CAD_SUFFIXES)
"""Endings of files that can be shown beside a model."""

_MOST = 20_000  # points of a target that the page is given
_JUDGED = 2_000  # by which a demand on the deviation is judged
_DEMANDS = 50


def names(where: Path) -> list[str]:
    """Return the names of the files of a folder that may be targets."""
    return folder.names(where, TARGETS)


def beside(where: Path, model: Model, name: str, most: int, tolerance: float | None, align: bool) -> dict[str, Any]:
    """Return points of a target, evenly through the file, with their distances from a model, and what they come to.

    Numbers go over as little-endian doubles in base 64. Raises ModelError or QuintrigError for a file that is none.
    """
    scan = _target(where, name)
    if scan.points.shape[1] != 3:
        raise QuintrigError(f"{name}: expected points in space, found points in the plane")
    found: Deviation = deviation(model, _thinned(scan, most), tolerance=tolerance, align=align)
    told = found.to_dict()
    return {
        "name": name,
        "count": len(scan.points),
        "places": _sent(found.points),
        "distances": _sent(found.distance),
        "reach": float(np.percentile(np.abs(found.distance), 99.0)),
        **{key: told[key] for key in ("points", "unit", "min", "max", "mean", "rms", "within", "tolerance", "notes")},
        "edge": told["edge"]["points"],
    }


def lights(where: Path, model: Model, patch: str, text: str, target: str) -> list[dict[str, Any]]:
    """Return what comes of demands, one a line, on a patch as it is: met or not, the worst value and its place.

    ``deviation`` is that from a target, where one is named. A line that is no demand has an ``error``.
    """
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    if len(lines) > _DEMANDS:
        raise QuintrigError(f"demands: expected {_DEMANDS} at most, found {len(lines)}")
    points = None
    if target and any("deviation" in line for line in lines):
        points = _thinned(_target(where, target).in_unit(model.unit), _JUDGED).points
    found: list[dict[str, Any]] = []
    for line in lines:
        try:
            parts = [one.to_dict() for one in judged(model, patch, line, points if "deviation" in line else None)]
        except ValueError as error:
            found.append({"demand": line, "error": str(error)})
            continue
        missed = [part for part in parts if not part["met"]]
        found.append((missed or parts)[0] | {"demand": line, "error": ""})
    return found


def fairer(model: Model, part: str, only: str) -> Fairing:
    """Return a model with one patch or curve of least thin-plate energy, by one control point or by all of its net.

    Seams and, where all of the net moves, sides stay. Raises ModelError or ValueError where nothing is free.
    """
    if any(one.name == part for one in model.curves):
        return fair_curve(model, curve=part, energy="thin_plate", only=(only,) if only else ())
    return fair(model, patch=part, energy="thin_plate", only=(only,) if only else ())


def _target(where: Path, name: str) -> Scan:
    path = folder.confined(where, name, TARGETS)
    try:
        stamp = path.stat()
    except OSError as error:
        raise QuintrigError(f"{name}: cannot be read ({error.strerror or error})") from None
    return _read(path, stamp.st_mtime_ns, stamp.st_size)


@lru_cache(maxsize=2)
def _read(path: Path, changed: int, size: int) -> Scan:
    """Return a target; ``changed`` and ``size`` tell its versions apart."""
    return open_target(path)


def _thinned(scan: Scan, most: int) -> Scan:
    """Return at most so many points of a scan, evenly through the file."""
    count, kept = len(scan.points), max(1, min(most, _MOST))
    if count <= kept:
        return Scan(scan.points, unit=scan.unit, name=scan.name)
    return Scan(scan.points[np.linspace(0, count - 1, kept).astype(int)], unit=scan.unit, name=scan.name)


def _sent(values: FloatArray) -> str:
    return base64.b64encode(np.ascontiguousarray(values, dtype="<f8").tobytes()).decode("ascii")
