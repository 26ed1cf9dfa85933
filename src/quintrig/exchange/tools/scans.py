"""What other tools hold as points and triangles, as a scan."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quintrig.scan.scan import MILLIMETRES, Scan, scan_of
from quintrig.support.arrays import LARGEST, FloatArray

_SPELT = {
    "millimeter": "mm",
    "millimetre": "mm",
    "centimeter": "cm",
    "centimetre": "cm",
    "meter": "m",
    "metre": "m",
    "micron": "um",
    "inch": "in",
    "inche": "in",
    "foot": "ft",
    "feet": "ft",
}


def unit_of(word: object) -> str:
    """Return the unit that a tool names, and none for one that is not known."""
    text = str(word or "").strip().lower()
    text = text if text in MILLIMETRES else _SPELT.get(text.removesuffix("s"), "")
    return text if text in MILLIMETRES else ""


def as_scan(
    points: ArrayLike,
    triangles: NDArray[np.int64] | None,
    normals: FloatArray | None,
    unit: str,
    name: str,
    *,
    shown: NDArray[np.bool_] | None = None,
    parameters: FloatArray | None = None,
) -> Scan:
    """Return the points (n, 3) that are finite and ``shown`` (n,), with their parameters (n, 2); see ``scan_of``."""
    array = np.asarray(points, dtype=np.float64)
    found = scan_of(array, normals, triangles, unit=unit, name=name)
    fine = (np.abs(array) <= LARGEST).all(axis=1)
    if parameters is not None:
        found = replace(found, parameters=parameters[fine])
    if shown is None or shown.all():
        return found
    if not shown[fine].any():
        raise ValueError(f"{name}: expected points, found only hidden ones; show some first")
    return found.within(shown[fine])


def joined(parts: Sequence[Scan]) -> Scan:
    """Return several scans as one; normals and triangles stay where all have some."""
    first = parts[0]
    if len(parts) == 1:
        return first
    units = {part.unit for part in parts}
    if len(units) > 1:
        raise ValueError(f"{first.name}: expected blocks in one unit, found {', '.join(sorted(units))}; give unit=")
    before = np.cumsum([0, *(len(part.points) for part in parts)])
    normals = [part.normals for part in parts if part.normals is not None]
    faces = [part.triangles + start for part, start in zip(parts, before, strict=False) if part.triangles is not None]
    return Scan(
        np.concatenate([part.points for part in parts]),
        np.concatenate(normals) if len(normals) == len(parts) else None,
        np.concatenate(faces) if len(faces) == len(parts) else None,
        unit=first.unit,
        name=first.name,
        notes=tuple(note for part in parts for note in part.notes),
    )
