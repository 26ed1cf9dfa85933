"""COMPAS's meshes and point clouds as scans."""

from typing import Any

import numpy as np

from quintrig.exchange.tools.scans import as_scan, unit_of
from quintrig.scan.scan import Scan
from quintrig.support.extras import need


def from_compas(mesh: Any, *, unit: str = "") -> Scan:
    """Return the points of a Mesh, shape or Pointcloud, length¹, with triangles, and the unit among its attributes.

    Faces of more than three corners are split into triangles around their first. ``unit`` goes before that of the
    attributes. Raises QuintrigError without COMPAS, ValueError for what has no points.
    """
    need("compas", "from_compas")
    points: list[Any]
    faces: list[list[int]]
    if hasattr(mesh, "to_vertices_and_faces"):
        points, faces = mesh.to_vertices_and_faces()
    elif hasattr(mesh, "points"):
        points, faces = mesh.points, []
    else:
        raise ValueError(f"from_compas: expected a mesh or a point cloud, found {type(mesh).__name__}; mesh it first")
    points = [list(point) for point in points]
    if not points:
        raise ValueError(f"from_compas: expected points, found an empty {type(mesh).__name__}; fill it first")
    fans = [(face[0], face[k], face[k + 1]) for face in faces for k in range(1, len(face) - 1)]
    unit = unit or unit_of(getattr(mesh, "attributes", {}).get("unit"))
    return as_scan(points, np.array(fans, dtype=np.int64) if fans else None, None, unit, "compas")
