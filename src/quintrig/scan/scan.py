"""A scan: measured points, with normals, triangles, weights and a unit where they are known."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quintrig.support.arrays import LARGEST, BoolArray, FloatArray, locked
from quintrig.support.display import Shown
from quintrig.support.errors import nearest

MILLIMETRES = {"um": 1e-3, "mm": 1.0, "cm": 10.0, "m": 1e3, "km": 1e6, "in": 25.4, "ft": 304.8}
"""Millimetres in each unit that a scan may be in."""

Triangles = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Scan(Shown):
    """Points (n, 2 or 3), length¹; unit ``normals`` (n, 3), ``triangles`` (m, 3) and ``weights`` (n,) where known.

    ``notes`` tell what was left out when it was read. ``parameters`` (n, 2), from 0 to 1, are those of points taken
    from one surface, which are exact and so not ``noisy``, or of the nodes of a grid. ``outline`` is true of the points
    of an aerofoil.
    """

    points: FloatArray
    normals: FloatArray | None = None
    triangles: Triangles | None = None
    weights: FloatArray | None = None
    unit: str = ""
    name: str = "scan"
    notes: tuple[str, ...] = ()
    parameters: FloatArray | None = None
    noisy: bool = True
    outline: bool = False

    def __repr__(self) -> str:
        """Return one line: how many points and triangles, and the unit."""
        mesh = f", {len(self.triangles):,} triangles" if self.triangles is not None else ""
        return f"<Scan {self.name!r} of {len(self.points):,} points{mesh} in {self.unit or 'plain numbers'}>"

    @property
    def size(self) -> float:
        """Diagonal of the bounding box of the points, length¹."""
        return float(np.linalg.norm(self.points.max(axis=0) - self.points.min(axis=0)))

    def within(self, kept: BoolArray | Triangles) -> "Scan":
        """Return the points that are kept (n,) alone, or numbered, with the triangles whose corners all are kept."""
        triangles = self.triangles if kept.dtype == np.bool_ else None
        if triangles is not None:
            number = np.cumsum(kept) - 1
            triangles = number[triangles[kept[triangles].all(axis=1)]]
        return replace(
            self,
            points=self.points[kept],
            normals=None if self.normals is None else self.normals[kept],
            weights=None if self.weights is None else self.weights[kept],
            triangles=triangles,
            parameters=None if self.parameters is None else self.parameters[kept],
        )

    def moved(self, motion: FloatArray) -> "Scan":
        """Return the scan moved by a rigid motion (4, 4)."""
        turn, shift = motion[:3, :3], motion[:3, 3]
        normals = None if self.normals is None else self.normals @ turn.T
        return replace(self, points=self.points @ turn.T + shift, normals=normals)

    def in_unit(self, unit: str) -> "Scan":
        """Return the scan in another unit; one that states none is taken to be in it already, and a note says so."""
        if not unit or unit == self.unit:
            return self
        if not self.unit:
            note = f"the target states no unit; its lengths are taken to be in {unit}, as the model's are"
            return replace(self, unit=unit, notes=(*self.notes, note))
        factor = MILLIMETRES[self.unit] / MILLIMETRES[unit]
        note = f"the target is in {self.unit}, the model in {unit}: lengths are multiplied by {factor:g}"
        return replace(self, points=self.points * factor, unit=unit, notes=(*self.notes, note))


def scan_of(
    points: ArrayLike,
    normals: ArrayLike | None = None,
    triangles: ArrayLike | None = None,
    weights: ArrayLike | None = None,
    unit: str = "",
    name: str = "scan",
) -> Scan:
    """Return a scan of points (n, 2 or 3), length¹; those that are not finite are left out, and a note tells how many.

    Raises ValueError for wrong shapes, for fewer than one finite point and for a unit that is none.
    """
    if unit and unit not in MILLIMETRES:
        raise ValueError(f"unit: expected one of {', '.join(MILLIMETRES)}, got {unit!r}{nearest(unit, MILLIMETRES)}")
    try:
        array = np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError("points: expected numbers, an array (n, 3)") from None
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise ValueError(f"points: expected an array (n, 3), found one of shape {array.shape}")
    across = None if normals is None else np.asarray(normals, dtype=np.float64)
    if across is not None:
        if across.shape != array.shape:
            raise ValueError(f"normals: expected one for each point, {array.shape}, found {across.shape}")
        with np.errstate(invalid="ignore", divide="ignore"):
            across = across / np.linalg.norm(across, axis=1, keepdims=True)
        across = across if np.isfinite(across).all() else None
    faces = None if triangles is None else np.asarray(triangles, dtype=np.int64).reshape(-1, 3)
    if faces is not None and len(faces) and not (faces.min() >= 0 and faces.max() < len(array)):
        raise ValueError(f"triangles: expected numbers of points, 0 to {len(array) - 1}, found {faces.max()}")
    heavy = None if weights is None else np.asarray(weights, dtype=np.float64)
    if heavy is not None and (heavy.shape != (len(array),) or not np.isfinite(heavy).all() or (heavy < 0.0).any()):
        raise ValueError(f"weights: expected {len(array)} numbers not below 0, one for each point")
    found = Scan(array, across, faces if faces is None or len(faces) else None, heavy, unit, name)
    fine: BoolArray = np.asarray((np.abs(array) <= LARGEST).all(axis=1))  # which NaN is not
    if not fine.all():
        note = f"{int((~fine).sum()):,} of {len(array):,} points are no finite numbers and are left out"
        found = replace(found.within(fine), notes=(note,))
    if not len(found.points):
        raise ValueError("points: expected at least one finite point, found none")
    return replace(found, points=locked(found.points))


def refuse_no_surface(points: FloatArray) -> None:
    """Raise ValueError for points (n, 3) that are all in one place or on one line."""
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    if not spread[0] > 1e-12 * float(np.abs(points).max()):
        raise ValueError("points: expected points apart from each other, found all in one place")
    if not spread[1] > 1e-9 * spread[0]:
        raise ValueError("points: expected points of a surface, found all on a line; take kind curve")
