"""Surfaces as trimesh's meshes."""

from typing import Any

from quintrig.exchange.tools.meshed import meshed
from quintrig.exchange.tools.whole import Given
from quintrig.support.extras import need


def to_trimesh(value: Given, **options: Any) -> Any:
    """Return a trimesh.Trimesh; ``metadata`` hold the unit, the names of the patches, the chord measured and notes.

    ``vertex_attributes`` hold u, v, the number of the patch and the quantities. Raises as ``Handed.to_trimesh`` says.
    """
    trimesh = need("trimesh", "to_trimesh")
    result, model = meshed(value, **options)
    return trimesh.Trimesh(
        result.points,
        result.triangles,
        vertex_normals=result.normals,
        vertex_attributes={"u": result.u, "v": result.v, "patch": result.patch, **result.values},
        metadata={
            "unit": model.unit,
            "patches": [patch.name for patch in model.patches],
            "chord": result.chord,
            "notes": list(result.notes),
        },
        process=False,  # it would merge points and lose their attributes
    )
