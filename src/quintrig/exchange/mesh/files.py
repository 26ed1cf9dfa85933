"""Meshes as STL, OBJ, PLY and GLB, written here so that coordinates, colours and scalars keep their precision, and VTU.

Common libraries round: PLY coordinates to 32 bits, GLB colours to 8. PLY and VTU hold every quantity as float64.
"""

import io
import json
import struct
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.mesh.triangulate import Mesh
from quintrig.support.arrays import FloatArray
from quintrig.support.extras import need

_JSON, _BINARY = 0x4E4F534A, 0x004E4942  # types of the two chunks of a GLB file


def stored(points: FloatArray, suffix: str) -> FloatArray:
    """Return points (n, 3), length¹, as a file of this ending holds them: STL and GLB have 24 bits, the others 53."""
    if suffix not in (".stl", ".glb"):
        return points
    centre = _centre(points) if suffix == ".glb" else np.zeros(3)
    with np.errstate(over="ignore"):
        return centre + (points - centre).astype("<f4").astype(np.float64)


def _centre(points: FloatArray) -> FloatArray:
    return 0.5 * (points.min(axis=0) + points.max(axis=0))


def stl(mesh: Mesh, remarks: Sequence[str]) -> bytes:
    """Return a binary STL: triangles in float32 with their own normals; the first remark goes into its header."""
    corners = mesh.points[mesh.triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.sqrt((normal**2).sum(axis=1, keepdims=True))
    normal = np.divide(normal, length, out=np.zeros_like(normal), where=length > 0.0)
    record = np.zeros(len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])
    record["normal"], record["corners"] = normal, corners
    # A header that starts with "solid" would be taken for the text form.
    head = ("quintrig: " + (remarks[0] if remarks else "")).encode("ascii", "replace")[:80].ljust(80)
    return head + struct.pack("<I", len(corners)) + record.tobytes()


def obj(mesh: Mesh, colours: FloatArray | None, remarks: Sequence[str]) -> bytes:
    """Return a Wavefront OBJ: points with sRGB colours (n, 3) in [0, 1] after the coordinates, normals, triangles."""
    out = io.StringIO()
    out.writelines(f"# {remark}\n" for remark in remarks)
    shades = [""] * len(mesh.points)
    if colours is not None:
        shades = [f" {r:.4f} {g:.4f} {b:.4f}" for r, g, b in colours.tolist()]
    points, normals = mesh.points.tolist(), mesh.normals.tolist()
    out.writelines(f"v {x!r} {y!r} {z!r}{shade}\n" for (x, y, z), shade in zip(points, shades, strict=True))
    out.writelines(f"vn {x:.7g} {y:.7g} {z:.7g}\n" for x, y, z in normals)
    out.writelines(f"f {a}//{a} {b}//{b} {c}//{c}\n" for a, b, c in (mesh.triangles + 1).tolist())
    return out.getvalue().encode()


def ply(mesh: Mesh, colours: FloatArray | None, remarks: Sequence[str]) -> bytes:
    """Return a binary PLY: points, normals and scalars as doubles, sRGB colours as bytes, classes as bytes."""
    columns: list[tuple[str, str, str, NDArray[Any]]] = [
        (name, "double", "<f8", mesh.points[:, k]) for k, name in enumerate(("x", "y", "z"))
    ]
    columns += [(name, "double", "<f8", mesh.normals[:, k]) for k, name in enumerate(("nx", "ny", "nz"))]
    if colours is not None:
        shades = np.rint(255.0 * colours).astype(np.uint8)
        columns += [(name, "uchar", "u1", shades[:, k]) for k, name in enumerate(("red", "green", "blue"))]
    for key, values in mesh.values.items():
        name, kind = ("char", "i1") if values.dtype == np.int8 else ("double", "<f8")
        columns.append((key, name, kind, values))
    table = np.empty(len(mesh.points), dtype=[(name, kind) for name, _, kind, _ in columns])
    for name, _, _, values in columns:
        table[name] = values
    faces = np.empty(len(mesh.triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, mesh.triangles
    lines = ["ply", "format binary_little_endian 1.0", *(f"comment {remark}" for remark in remarks)]
    lines += [f"element vertex {len(table)}", *(f"property {kind} {name}" for name, kind, _, _ in columns)]
    lines += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    return ("\n".join(lines) + "\n").encode() + table.tobytes() + faces.tobytes()


def glb(mesh: Mesh, colours: FloatArray | None, remarks: Sequence[str], metres: float) -> bytes:
    """Return a binary glTF 2.0: float32, y up, in metres, with linear colours in 16 bits and each quantity as ``_KEY``.

    ``colours`` (n, 3) are sRGB in [0, 1], ``metres`` the model's unit. The node turns z up into y up; its translation
    keeps the digits of a model that lies far from the origin.
    """
    centre = _centre(mesh.points)
    near = (mesh.points - centre).astype("<f4")
    pack = _Buffer()
    attributes = {
        "POSITION": pack.add(near, "VEC3", 5126, 34962, bounds=True),
        "NORMAL": pack.add(mesh.normals.astype("<f4"), "VEC3", 5126, 34962),
    }
    if colours is not None:
        shade = np.rint(65535.0 * linear(colours)).astype("<u2")
        opaque = np.concatenate([shade, np.full((len(shade), 1), 65535, dtype="<u2")], axis=1)
        attributes["COLOR_0"] = pack.add(opaque, "VEC4", 5123, 34962, normalised=True)
    for key, values in mesh.values.items():
        # NaN has no place in glTF; singular points are grey, and their value 0.
        attributes[f"_{key.upper()}"] = pack.add(np.nan_to_num(values).astype("<f4"), "SCALAR", 5126, 34962)
    indices = pack.add(mesh.triangles.astype("<u4").ravel(), "SCALAR", 5125, 34963)
    s = metres
    x, y, z = (centre * s).tolist()
    matrix = [s, 0, 0, 0, 0, 0, -s, 0, 0, s, 0, 0, x, z, -y, 1]
    paint = {"metallicFactor": 0.0, "roughnessFactor": 0.6}
    tree = {
        "asset": {"version": "2.0", "generator": "quintrig", "extras": {"remarks": list(remarks)}},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "matrix": [float(value) for value in matrix]}],
        "meshes": [{"primitives": [{"attributes": attributes, "indices": indices, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": paint, "doubleSided": True}],
        "accessors": pack.accessors,
        "bufferViews": pack.views,
        "buffers": [{"byteLength": len(pack.data)}],
    }
    text = json.dumps(tree, ensure_ascii=False).encode()
    text += b" " * (-len(text) % 4)
    heads = [struct.pack("<II", len(part), tag) for part, tag in ((text, _JSON), (pack.data, _BINARY))]
    chunks = heads[0] + text + heads[1] + pack.data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def vtu(mesh: Mesh, remarks: Sequence[str]) -> bytes:
    """Return a VTK unstructured grid with every quantity as point data, real ones as float64; needs extra ``mesh``."""
    meshio = need("meshio", "writing VTU")
    data = {"Normals": mesh.normals, "patch": mesh.patch.astype(np.int32), **mesh.values}
    grid = meshio.Mesh(mesh.points, [("triangle", mesh.triangles)], point_data=data)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "mesh.vtu"
        grid.write(path, file_format="vtu")
        first, _, rest = path.read_bytes().partition(b"\n")
    note = "\n".join(remarks).replace("--", "- -")
    return first + b"\n<!-- " + note.encode() + b" -->\n" + rest


def linear(srgb: FloatArray) -> FloatArray:
    """Return linear-light values of sRGB values, both in [0, 1] (IEC 61966-2-1): glTF colours are linear."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


class _Buffer:
    """The binary part of a GLB file, while it is put together."""

    def __init__(self) -> None:
        self.data = b""
        self.views: list[dict[str, int]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(
        self,
        array: NDArray[Any],
        kind: str,
        component: int,
        target: int,
        *,
        bounds: bool = False,
        normalised: bool = False,
    ) -> int:
        """Append an array and return the number of its accessor."""
        raw = array.tobytes()
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(raw), "target": target})
        self.data += raw + b"\0" * (-len(raw) % 4)
        accessor: dict[str, Any] = {
            "bufferView": len(self.views) - 1,
            "componentType": component,
            "count": len(array),
            "type": kind,
        }
        if bounds:
            accessor |= {"min": array.min(axis=0).tolist(), "max": array.max(axis=0).tolist()}
        if normalised:
            accessor["normalized"] = True
        self.accessors.append(accessor)
        return len(self.accessors) - 1
