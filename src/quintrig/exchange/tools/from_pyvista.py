"""PyVista's and VTK's data sets as scans: points to measure against or to fit."""

from inspect import signature
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.exchange.tools.scans import as_scan, joined, unit_of
from quintrig.scan.scan import Scan
from quintrig.support.arrays import FloatArray
from quintrig.support.extras import need


def from_pyvista(mesh: Any, *, unit: str = "") -> Scan:
    """Return the points of a data set or MultiBlock, length¹, with triangles, normals and the unit where known.

    A StructuredGrid of one layer is a grid of nodes: its arrays u and v, or its indices, are parameters with which a
    fit begins. Hidden points are left out. ``unit`` goes before that of the field data. Raises QuintrigError without
    PyVista, ValueError for what has no points.
    """
    pyvista = need("pyvista", "from_pyvista")
    given = type(mesh).__name__
    if not isinstance(mesh, (pyvista.DataSet, pyvista.MultiBlock)):
        try:
            mesh = pyvista.wrap(mesh)  # VTK's own
        except (TypeError, ValueError, NotImplementedError):
            mesh = None
        if mesh is None:
            raise ValueError(f"from_pyvista: expected a data set, found {given}")
    found = _parts(pyvista, mesh, unit)
    if not found:
        raise ValueError(f"from_pyvista: expected points, found an empty {given}; fill it first")
    return joined(found)


def _parts(pyvista: Any, mesh: Any, unit: str) -> list[Scan]:
    if isinstance(mesh, pyvista.MultiBlock):
        return [part for block in mesh if block is not None for part in _parts(pyvista, block, unit)]
    if not mesh.n_points:
        return []
    unit = unit or unit_of(mesh.field_data["unit"][0] if "unit" in mesh.field_data else "")
    if isinstance(mesh, pyvista.StructuredGrid) and sum(size > 1 for size in mesh.dimensions) == 2:
        return [_nodes(mesh, unit)]
    if not isinstance(mesh, pyvista.PolyData):
        bare = not mesh.n_cells or isinstance(mesh, pyvista.PointSet)
        mesh = pyvista.PolyData(np.asarray(mesh.points)) if bare else _outside(mesh)
    mesh = mesh.triangulate()
    triangles = np.asarray(mesh.faces, dtype=np.int64).reshape(-1, 4)[:, 1:]
    return [as_scan(mesh.points, triangles, _normals(mesh), unit, "pyvista", shown=_shown(mesh.point_data))]


def _outside(mesh: Any) -> Any:
    """Return the outside of cells as PolyData; newer versions of PyVista ask which algorithm finds it."""
    asked = "algorithm" in signature(mesh.extract_surface).parameters
    return mesh.extract_surface(**{"algorithm": None} if asked else {})


def _nodes(mesh: Any, unit: str) -> Scan:
    """Return a grid of one layer: two triangles for each cell that is shown, and the parameters of its nodes."""
    n, m = (int(size) for size in mesh.dimensions if size > 1)
    number = np.arange(n * m).reshape(m, n)  # VTK runs along the first axis first
    cells = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], axis=-1).reshape(-1, 4)
    shown = _shown(mesh.cell_data)
    cells = cells if shown is None else cells[shown]
    own: list[Any] = [mesh.point_data[key] for key in "uv" if key in mesh.point_data]
    if [np.shape(one) for one in own] != [(n * m,)] * 2:
        own = [np.tile(np.arange(n), m), np.repeat(np.arange(m), n)]
    at: FloatArray = np.stack(own, axis=1).astype(np.float64)
    span = np.ptp(at, axis=0)
    at = (at - at.min(axis=0)) / np.where(span > 0.0, span, 1.0)
    triangles = np.concatenate([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
    normals = _normals(mesh)
    return as_scan(mesh.points, triangles, normals, unit, "pyvista", shown=_shown(mesh.point_data), parameters=at)


def _normals(mesh: Any) -> FloatArray | None:
    """Return the normals of the points, by any of the names under which they are kept."""
    for name in (mesh.point_data.active_normals_name, "Normals", "normal"):
        if name in mesh.point_data and np.shape(mesh.point_data[name]) == (mesh.n_points, 3):
            return np.asarray(mesh.point_data[name], dtype=np.float64)
    return None


def _shown(data: Any) -> NDArray[np.bool_] | None:
    return np.asarray(data["vtkGhostType"]) == 0 if "vtkGhostType" in data else None
