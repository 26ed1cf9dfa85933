"""trimesh's meshes and point clouds as scans."""

from typing import Any

import numpy as np

from quintrig.exchange.tools.scans import as_scan, joined, unit_of
from quintrig.scan.scan import Scan
from quintrig.support.extras import need


def from_trimesh(mesh: Any, *, unit: str = "") -> Scan:
    """Return the points of a Trimesh, PointCloud or Scene, length¹, with triangles, and the unit that it states.

    ``unit`` goes before that. Raises QuintrigError without trimesh, ValueError for what has no points.
    """
    trimesh = need("trimesh", "from_trimesh")
    stated = getattr(mesh, "units", None) or getattr(mesh, "metadata", {}).get("unit")
    parts = mesh.dump() if isinstance(mesh, trimesh.Scene) else [mesh]
    if not all(hasattr(part, "vertices") for part in parts):
        raise ValueError(f"from_trimesh: expected a mesh, a point cloud or a scene, found {type(mesh).__name__}")
    found = [_scan(part, unit or unit_of(stated)) for part in parts if len(part.vertices)]
    if not found:
        raise ValueError(f"from_trimesh: expected points, found an empty {type(mesh).__name__}; fill it first")
    return joined(found)


def _scan(part: Any, unit: str) -> Scan:
    faces = np.asarray(getattr(part, "faces", ()), dtype=np.int64)
    return as_scan(part.vertices, faces if len(faces) else None, None, unit, "trimesh")
