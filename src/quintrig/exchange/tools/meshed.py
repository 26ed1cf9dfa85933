"""The mesh of a surface or model that tools for meshes take."""

from collections.abc import Sequence

from quintrig.exchange.mesh.write import QUANTITIES
from quintrig.exchange.tools.whole import Given, whole
from quintrig.mesh.triangulate import Mesh, mesh
from quintrig.model.model import Model
from quintrig.quantities.table import quantity


def meshed(
    value: Given,
    *,
    tolerance: float | None = None,
    grid: tuple[int, int] | None = None,
    quantities: Sequence[str] | str = QUANTITIES,
) -> tuple[Mesh, Model]:
    """Return the mesh, and the model whose patches it numbers; ValueError as ``mesh`` and for unknown quantities."""
    model = whole(value)
    names = [quantities] if isinstance(quantities, str) else list(quantities)
    keys = [quantity(name).key for name in names]
    vectors = [key for key in keys if quantity(key).kind == "vector"]
    if vectors:
        raise ValueError(f"quantities: {vectors[0]} is a vector; normals come anyway, take quantities of one value")
    return mesh([patch.surface for patch in model.patches], tolerance=tolerance, grid=grid, quantities=keys), model
