"""Surfaces as COMPAS's meshes, and as the data of its NURBS surfaces."""

from typing import Any, Literal

import numpy as np

from quintrig.exchange.cad.forms import Carrier, written_carriers
from quintrig.exchange.tools.meshed import meshed
from quintrig.exchange.tools.whole import Given, alone, whole
from quintrig.support.extras import need


def to_compas(value: Given, *, form: Literal["mesh", "nurbs"] = "mesh", **options: Any) -> Any:
    """Return a compas.datastructures.Mesh, or the data of NURBS surfaces; see ``Handed.to_compas``."""
    if form not in ("mesh", "nurbs"):
        raise ValueError(f'form: expected "mesh" or "nurbs", found {form!r}')
    datastructures = need("compas.datastructures", "to_compas")
    if form == "nurbs":
        given = [name for name, value in options.items() if value is not None]
        if given:
            raise ValueError(f'{given[0]}: goes with form = "mesh" alone; a NURBS surface has no points')
        parts = {part.name: _data(part) for part in written_carriers(whole(value))}
        return next(iter(parts.values())) if alone(value) else parts
    result, model = meshed(value, **options)
    mesh = datastructures.Mesh.from_vertices_and_faces(result.points.tolist(), result.triangles.tolist())
    mesh.name = model.name
    mesh.attributes["unit"] = model.unit
    mesh.attributes["notes"] = list(result.notes)
    names = [patch.name for patch in model.patches]
    columns = {"u": result.u, "v": result.v, **result.values}
    for k, normal in enumerate(result.normals.tolist()):
        own = {key: column[k].item() for key, column in columns.items()}
        mesh.vertex_attributes(k, ["patch", "normal", *own], [names[result.patch[k]], normal, *own.values()])
    return mesh


def _data(part: Carrier) -> dict[str, Any]:
    form = part.form
    knots = [np.unique(basis.knots, return_counts=True) for basis in (form.u, form.v)]
    return {
        "points": form.points.tolist(),
        "weights": form.weights.tolist(),
        "knots_u": knots[0][0].tolist(),
        "knots_v": knots[1][0].tolist(),
        "mults_u": knots[0][1].tolist(),
        "mults_v": knots[1][1].tolist(),
        "degree_u": form.degrees[0],
        "degree_v": form.degrees[1],
        "is_periodic_u": False,
        "is_periodic_v": False,
    }
