"""build123d's faces, shells and solids as models."""

from typing import Any

from quintrig.exchange.cad.faces import Contents, to_model
from quintrig.model.model import Model
from quintrig.support.extras import need


def from_build123d(shape: Any) -> Model:
    """Return the faces of a shape as patches of kind ``nurbs`` in millimetres, with the loops that trim them.

    Raises QuintrigError without OpenCASCADE, for a shape without faces, and where no face has a NURBS form.
    """
    need("OCP", "from_build123d")
    from quintrig.exchange.cad.occ import quiet
    from quintrig.exchange.cad.read import faces_of

    inner = shape._wrapped if hasattr(shape, "_wrapped") else getattr(shape, "wrapped", shape)  # asserted in the newer
    with quiet():
        faces = faces_of(inner, "from_build123d")
    return to_model(Contents(str(getattr(shape, "label", "") or "build123d"), "mm", faces), "from_build123d")
