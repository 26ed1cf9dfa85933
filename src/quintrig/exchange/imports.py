"""Any file with surfaces as a model: quintrig's own models, and faces of CAD files."""

from collections.abc import Sequence
from pathlib import Path

from quintrig.exchange.cad import isolated
from quintrig.exchange.cad.faces import Contents, to_model
from quintrig.model.model import Model, load
from quintrig.support.errors import QuintrigError

CAD_SUFFIXES = isolated.CAD_SUFFIXES
"""Endings of the files that are read as CAD."""


def open_model(path: str | Path, faces: Sequence[int] | None = None) -> Model:
    """Return a model file, or the faces of a STEP, IGES, BREP or 3DM file as patches of kind ``nurbs``.

    ``faces`` are numbers from 1; without, all that can be read. Raises ModelError or QuintrigError in one line.
    """
    path = Path(path)
    if path.suffix.lower() not in CAD_SUFFIXES:
        if faces:
            raise QuintrigError(f"{path}: faces are chosen from CAD files ({', '.join(CAD_SUFFIXES)}), not from models")
        return load(path)
    return to_model(isolated.read(path), str(path), faces)


def contents(path: str | Path) -> Contents:
    """Return everything that a CAD file holds, to choose from."""
    return isolated.read(Path(path))
