"""Surfaces as PyVista's structured grids, quantities as arrays at their points."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.exchange.tools.whole import Given, alone, keys, pair, whole
from quintrig.geometry.surface import Surface
from quintrig.quantities.table import BY_KEY
from quintrig.support.extras import need

_MOST_POINTS = 4_000_000


def to_pyvista(
    value: Given, *, points: tuple[int, int] = (65, 65), quantities: Iterable[str] | str | None = None
) -> Any:
    """Return a pyvista.StructuredGrid, of a model with several patches a pyvista.MultiBlock of grids by name.

    Field data name what arrays cannot: ``unit`` of length and, for a class, its names by code (``hk_type names``).
    Raises as ``Handed.to_pyvista`` says.
    """
    pyvista = need("pyvista", "to_pyvista")
    model = whole(value)
    nu, nv = _grid(points, len(model.patches))
    wanted = list(BY_KEY) if quantities is None else keys(quantities)
    grids = {patch.name: _of_surface(pyvista, patch.surface, nu, nv, wanted, model.unit) for patch in model.patches}
    return next(iter(grids.values())) if alone(value) else pyvista.MultiBlock(grids)


def _grid(points: tuple[int, int], patches: int) -> tuple[int, int]:
    nu, nv = pair(points, "points")
    if nu < 2 or nv < 2 or nu * nv * patches > _MOST_POINTS:
        raise ValueError(
            f"points: expected a grid of 2 x 2 to {_MOST_POINTS:,} points in all, found {nu} x {nv} for each patch"
        )
    return nu, nv


def _of_surface(pyvista: Any, surface: Surface, nu: int, nv: int, wanted: list[str], unit: str) -> Any:
    u, v = np.linspace(0.0, 1.0, nu)[:, None], np.linspace(0.0, 1.0, nv)[None, :]
    sample = analyse(surface, u, v, ["point", "normal", *wanted])
    grid = pyvista.StructuredGrid(*np.moveaxis(sample.point, -1, 0))
    # VTK runs along the first axis first.
    flat = {key: np.swapaxes(array, 0, 1).reshape(nu * nv, *array.shape[2:]) for key, array in sample.values.items()}
    grid.point_data["u"] = np.tile(u[:, 0], nv)
    grid.point_data["v"] = np.repeat(v[0], nu)
    for key, array in flat.items():
        if key == "normal":
            grid.point_data.active_normals = array
            grid.point_data.set_array(array, "normal")
        elif key != "point":
            grid.point_data.set_array(array, key)
            if BY_KEY[key].kind == "class":
                grid.field_data[f"{key} names"] = list(BY_KEY[key].classes)
    grid.field_data["unit"] = [unit or "none stated"]
    if surface.trim:
        hidden = np.flatnonzero(~np.swapaxes(surface.inside(u, v), 0, 1).ravel())
        if len(hidden):
            grid.hide_points(hidden)
    grid.set_active_scalars(next((key for key in flat if BY_KEY[key].kind == "scalar"), None))
    return grid
