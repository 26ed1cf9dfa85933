"""The mesh of a surface or model that tools for meshes take."""

from collections.abc import Sequence

from quintrig.exchange.mesh.write import QUANTITIES
from quintrig.exchange.tools.whole import Given, keys, pair, whole
from quintrig.mesh.triangulate import Mesh, mesh
from quintrig.model.model import Model
from quintrig.quantities.table import quantity


def meshed(
    value: Given,
    *,
    tolerance: float | None = None,
    grid: tuple[int, int] | None = None,
    quantities: Sequence[str] | str | None = None,
) -> tuple[Mesh, Model]:
    """Return the mesh, and the model whose patches it numbers; ValueError as ``mesh`` and for unknown quantities."""
    model = whole(value)
    wanted = keys(QUANTITIES if quantities is None else quantities)
    vectors = [key for key in wanted if quantity(key).kind == "vector"]
    if vectors:
        raise ValueError(f"quantities: {vectors[0]} is a vector; normals come anyway, take quantities of one value")
    if grid is not None:
        grid = pair(grid, "grid")
    surfaces = [patch.surface for patch in model.patches]
    return mesh(surfaces, tolerance=tolerance, grid=grid, quantities=wanted), model
