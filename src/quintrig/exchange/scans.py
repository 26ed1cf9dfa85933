"""Point clouds and meshes out of files: CSV, XYZ and other tables of numbers, PLY, OBJ, STL; and faces of CAD files."""

import io
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from quintrig.exchange.cad import isolated
from quintrig.exchange.imports import open_model
from quintrig.exchange.point_tables import read_table
from quintrig.exchange.units import stated_unit
from quintrig.model.model import Model
from quintrig.scan.scan import MILLIMETRES, Scan, scan_of
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError, QuintrigError, nearest, printable
from quintrig.support.extras import need
from quintrig.support.files import open_regular

TABLES = (".csv", ".xyz", ".txt", ".asc", ".pts", ".dat")
"""Endings of the files that hold a point in each line."""

MESHES = (".ply", ".obj", ".stl")
"""Endings of the files that hold points, often with triangles."""

SCAN_SUFFIXES = (*TABLES, *MESHES)
"""Endings of the files that are read as scans."""

LARGEST = 2 * 2**30
"""Bytes of a file that is read at all: some 30 million points."""

_FACE_SAMPLES = 65  # points along a parameter of a CAD face that is a target


def open_target(path: str | Path, unit: str = "", faces: Sequence[int] | None = None) -> Scan:
    """Return the points of a scan, or points on the faces of a CAD file or on a model; see ``read_scan``.

    ``faces`` are numbers of a CAD file from 1. Of a surface there are 65 x 65 points a face, inside its loops, with
    normals. Raises ModelError or QuintrigError in one line.
    """
    path = Path(path)
    suffix = path.suffix.lower()
    if suffix in SCAN_SUFFIXES:
        if faces:
            raise QuintrigError(f"{path}: faces are chosen from CAD files ({', '.join(isolated.CAD_SUFFIXES)})")
        return read_scan(path, unit)
    if suffix not in (*isolated.CAD_SUFFIXES, ".toml", ".json"):
        known = ", ".join((*SCAN_SUFFIXES, *isolated.CAD_SUFFIXES, ".toml", ".json"))
        raise QuintrigError(f"{path}: expected points, a mesh or surfaces, a file ending in {known}")
    return sampled(open_model(path, faces), unit)


def sampled(model: Model, unit: str = "", side: int = _FACE_SAMPLES) -> Scan:
    """Return points of a model's surfaces, ``side`` each way, inside the loops of faces, with their normals."""
    from quintrig.analysis.sample import analyse

    t = np.linspace(0.0, 1.0, side)
    points: list[FloatArray] = []
    normals: list[FloatArray] = []
    at: list[FloatArray] = []
    for patch in model.patches:
        surface = patch.surface
        u, v = (grid.ravel() for grid in np.meshgrid(t, t, indexing="ij"))
        kept = surface.inside(u, v)
        sample = analyse(surface, u[kept], v[kept], ("point", "normal"))
        fine = np.isfinite(sample.normal).all(axis=1) & np.isfinite(sample.point).all(axis=1)
        points.append(np.array(sample.point)[fine])
        normals.append(np.array(sample.normal)[fine])
        at.append(np.stack([u[kept][fine], v[kept][fine]], axis=1))
    found = scan_of(np.concatenate(points), np.concatenate(normals), unit=unit or model.unit, name=model.name)
    if len(at) > 1 or len(at[0]) != len(found.points):
        return replace(found, noisy=False)
    low, span = at[0].min(axis=0), np.ptp(at[0], axis=0)
    return replace(found, noisy=False, parameters=(at[0] - low) / np.where(span > 0.0, span, 1.0))


def read_scan(path: str | Path, unit: str = "") -> Scan:
    """Return the points of a CSV, XYZ, TXT, ASC, PTS, DAT, PLY, OBJ or STL file, with what else it holds of them.

    Tables have a point a line, of 2 or 3 numbers between commas, semicolons or blanks; with a heading the columns x, y,
    z, nx, ny, nz and weight are found by name, without one six or more numbers are a point and its normal. ``unit`` is
    that of the file, which most formats cannot say; a remark such as ``# unit mm`` is read. Points that are no finite
    numbers are left out, and a note says so. Raises QuintrigError or ModelError in one line.
    """
    path = Path(path)
    suffix = path.suffix.lower()
    if unit and unit not in MILLIMETRES:
        raise QuintrigError(f"unit: expected one of {', '.join(MILLIMETRES)}, got {unit!r}{nearest(unit, MILLIMETRES)}")
    if suffix not in SCAN_SUFFIXES:
        raise QuintrigError(f"{path}: expected a scan, a file ending in {', '.join(SCAN_SUFFIXES)}")
    raw = _bytes(path)
    try:
        found = _table(raw, path) if suffix in TABLES else replace(_mesh(raw, path), unit=_unit_stated(raw))
        found = replace(found, unit=unit or found.unit, name=printable(path.stem))
    except (ModelError, QuintrigError):
        raise
    except ValueError as error:
        raise ModelError(f"{path}: {error}") from None
    return found


def to_csv(scan: Scan) -> str:
    """Return the points of a scan as CSV, with normals where there are some, every digit kept."""
    stream = io.StringIO()
    names = "xyz"[: scan.points.shape[1]]
    columns = [scan.points, *([] if scan.normals is None else [scan.normals])]
    heading = ",".join([*names, *([] if scan.normals is None else ["nx", "ny", "nz"])])
    stream.write(f"# unit {scan.unit}\n{heading}\n" if scan.unit else f"{heading}\n")
    np.savetxt(stream, np.column_stack(columns), delimiter=",", fmt="%.17g")
    return stream.getvalue()


def _bytes(path: Path) -> bytes:
    try:
        if path.is_dir():
            raise QuintrigError(f"{path}: expected a file, found a folder")
        size = path.stat().st_size
        if size > LARGEST:
            raise QuintrigError(
                f"{path}: expected at most {LARGEST >> 30} GB, found {size / 2**30:.1f} GB; thin the scan out"
            )
        with open_regular(path) as file:
            raw = file.read(LARGEST)
    except FileNotFoundError:
        raise QuintrigError(f"{path}: no such file; check the path") from None
    except OSError as error:
        raise QuintrigError(f"{path}: cannot be read ({error.strerror or error})") from None
    if not raw.strip():
        raise QuintrigError(f"{path}: the file is empty; expected points")
    return raw


def _unit_stated(raw: bytes) -> str:
    """Return the unit that a remark in the head of a mesh file states."""
    lines = raw[:4096].split(b"end_header")[0].decode("latin-1").splitlines()
    remarks = [line for line in lines if line.startswith(("comment", "obj_info", "#", "solid"))]
    return next((unit for line in (*remarks, lines[0][:80]) if (unit := stated_unit(line))), "")


def _table(raw: bytes, path: Path) -> Scan:
    try:
        found = read_table(raw)
    except (ModelError, ValueError) as error:
        raise ModelError(f"{path}: {error}") from None
    return _aerofoil(found) if path.suffix.lower() == ".dat" and found.points.shape[1] == 2 else found


def _aerofoil(found: Scan) -> Scan:
    """Return the points of an aerofoil, Selig's way or Lednicer's, whose first row tells how many are in each row."""
    points = found.points
    count = int(points[0].sum()) if len(points) > 4 and points[0].min() > 1.5 else 0
    if count == len(points) - 1:
        found = found.within(np.arange(len(points)) > 0)
    return replace(found, outline=True, noisy=False)


def _mesh(raw: bytes, path: Path) -> Scan:
    trimesh = need("trimesh", "reading meshes")
    suffix = path.suffix.lower()[1:]
    try:
        # As it stands in the file: nothing merged, mended or thrown away.
        found: Any = trimesh.load(io.BytesIO(raw), file_type=suffix, process=False)
    except (MemoryError, KeyboardInterrupt):
        raise
    except Exception as error:  # whatever a parser of another package meets in a damaged file
        raise ModelError(
            f"{path}: expected a mesh or points in {suffix.upper()}, found a damaged file or another "
            f"({type(error).__name__}: {printable(str(error))[:100]})"
        ) from None
    if hasattr(found, "geometry") and not hasattr(found, "vertices"):
        found = found.to_geometry() if found.geometry else None
    points = np.asarray(getattr(found, "vertices", np.empty((0, 3))), dtype=np.float64)
    if not len(points):
        raise ModelError(f"{path}: expected points, found none")
    faces = np.asarray(getattr(found, "faces", np.empty((0, 3))), dtype=np.int64)
    normals = _normals_of(found, len(points)) if not len(faces) else None
    if suffix == "stl":  # every triangle has corners of its own there
        points, merged = np.unique(points, axis=0, return_inverse=True)
        faces = merged.reshape(-1)[faces] if len(faces) else faces
    same = (faces[:, 0] == faces[:, 1]) | (faces[:, 1] == faces[:, 2]) | (faces[:, 2] == faces[:, 0])
    result = scan_of(points, normals, faces[~same] if len(faces) else None)
    if same.any():
        result = replace(result, notes=(*result.notes, f"{int(same.sum()):,} triangles without area are left out"))
    return result


def _normals_of(found: Any, count: int) -> FloatArray | None:
    """Return the normals of points that a PLY file holds beside them."""
    raw: Any = getattr(found, "metadata", {}).get("_ply_raw", {}).get("vertex", {}).get("data")
    names: Any = getattr(getattr(raw, "dtype", None), "names", None) or list(raw or ())
    if raw is None or not {"nx", "ny", "nz"} <= set(names):
        return None
    normals = np.stack([np.asarray(raw[name], dtype=np.float64).reshape(-1) for name in ("nx", "ny", "nz")], axis=1)
    return normals if len(normals) == count else None
