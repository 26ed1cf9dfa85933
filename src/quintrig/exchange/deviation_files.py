"""Deviations as CSV, with a point a line, and as PLY with colours."""

import io
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from quintrig.scan.deviation import SIGN, Deviation
from quintrig.support.arrays import FloatArray
from quintrig.support.files import write_whole

DEVIATION_SUFFIXES = (".csv", ".ply")
"""Endings of the files that a deviation is written to, pictures and JSON aside."""


def write_deviation(result: Deviation, path: Path, beside: Mapping[str, FloatArray] | None = None) -> Path:
    """Write points, distances and places on the model to a .csv or .ply; QuintrigError where it cannot be written.

    ``beside`` are more numbers of each point, (n,) by name.
    """
    write = _ply if path.suffix.lower() == ".ply" else _csv
    return write_whole(path, write(result, beside or {}))


def _csv(result: Deviation, beside: Mapping[str, FloatArray]) -> str:
    stream = io.StringIO()
    unit = f", lengths in {result.unit}" if result.unit else ""
    stream.write(f"# distance {SIGN}{unit}; edge 1: foot on a border, not orthogonal\n")
    named = len(result.names) > 1
    if named:
        stream.write("# patches: " + ", ".join(f"{i} {name}" for i, name in enumerate(result.names)) + "\n")
    stream.write(
        "x,y,z,distance,u,v,foot_x,foot_y,foot_z,edge"
        + (",patch" if named else "")
        + "".join(f",{name}" for name in beside)
        + "\n"
    )
    columns = [result.points, result.distance, result.u, result.v, result.foot, result.edge]
    rows = np.column_stack([*columns, *([result.patch] if named else []), *beside.values()])
    np.savetxt(stream, rows, delimiter=",", fmt=["%.17g"] * 9 + ["%d"] * (1 + named) + ["%.17g"] * len(beside))
    return stream.getvalue()


def _ply(result: Deviation, beside: Mapping[str, FloatArray]) -> bytes:
    reach = float(np.percentile(np.abs(result.distance), 99.0)) or 1.0
    return ply_of(
        result.points,
        {"distance": result.distance, **beside},
        diverging(result.distance / reach),
        (f"distance {SIGN}", f"unit {result.unit or 'none stated'}", f"colours show distance, ±{reach:.4g}"),
    )


def ply_of(
    points: FloatArray,
    values: dict[str, FloatArray],
    colours: NDArray[np.uint8],
    remarks: tuple[str, ...],
    triangles: NDArray[np.int64] | None = None,
) -> bytes:
    """Return a binary PLY of points (n, 3), named numbers (n,) beside them, 8-bit colours (n, 3), and triangles."""
    head = ["ply", "format binary_little_endian 1.0", *(f"comment {line}" for line in remarks)]
    head += [f"element vertex {len(points)}", *(f"property double {axis}" for axis in "xyz")]
    head += [f"property double {name}" for name in values]
    head += [f"property uchar {name}" for name in ("red", "green", "blue")]
    if triangles is not None:
        head += [f"element face {len(triangles)}", "property list uchar int vertex_indices"]
    kinds = [(axis, "<f8") for axis in "xyz"] + [(name, "<f8") for name in values] + [(c, "u1") for c in "rgb"]
    rows = np.empty(len(points), dtype=kinds)
    for k, axis in enumerate("xyz"):
        rows[axis] = points[:, k]
    for name, column in values.items():
        rows[name] = column
    for k, c in enumerate("rgb"):
        rows[c] = colours[:, k]
    body = rows.tobytes()
    if triangles is not None:
        faces = np.empty(len(triangles), dtype=[("n", "u1"), ("i", "<i4", 3)])
        faces["n"], faces["i"] = 3, triangles
        body += faces.tobytes()
    return "\n".join([*head, "end_header", ""]).encode() + body


def diverging(values: FloatArray) -> NDArray[np.uint8]:
    """Return colours from blue at -1 over white at 0 to red at 1, grey where there is no number."""
    import matplotlib

    colours = matplotlib.colormaps["RdBu_r"](0.5 + 0.5 * np.clip(np.nan_to_num(values), -1.0, 1.0))[:, :3]
    colours[np.isnan(values)] = 0.6
    return np.round(255.0 * colours).astype(np.uint8)
