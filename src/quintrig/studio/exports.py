"""Exports through the exchange package, of which only what is installed is offered."""

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from quintrig.errors import QuintrigError
from quintrig.model import Model

_EXCHANGE = "quintrig.exchange.formats"


@dataclass(frozen=True)
class Format:
    """A kind of file that a model can be exported to: name, ending, and the Python package that writing it needs."""

    label: str
    suffix: str
    needs: str = ""

    @property
    def key(self) -> str:
        """What the browser calls it."""
        return self.suffix


FORMATS = (
    Format("STEP, exact", "step", "OCP"),
    Format("IGES, exact", "iges", "OCP"),
    Format("Rhino 3DM, exact", "3dm", "rhino3dm"),
    Format("STL mesh", "stl"),
    Format("OBJ mesh", "obj"),
    Format("PLY mesh with curvature", "ply"),
    Format("glTF mesh with colours", "glb"),
    Format("VTK mesh with curvature", "vtu", "meshio"),
    Format("DXF, flat pattern or net", "dxf", "ezdxf"),
)
"""Every format, whether or not it is installed here."""


def formats() -> list[Format]:
    """Return the formats that can be written here; empty without the exchange package."""
    if find_spec("quintrig.exchange") is None or find_spec(_EXCHANGE) is None:
        return []
    return [one for one in FORMATS if not one.needs or find_spec(one.needs) is not None]


def export(model: Model, key: str) -> bytes:
    """Return the file of a format; QuintrigError or ValueError where it is not offered or has no such form."""
    known = {one.key: one for one in formats()}
    if key not in known:
        offered = ", ".join(known) or "none"
        raise QuintrigError(f"export: no format {key!r} is installed here (offered: {offered})")
    write: Callable[[Model, Path], Any] = import_module(_EXCHANGE).export
    with tempfile.TemporaryDirectory(prefix="quintrig-") as folder:
        path = Path(folder) / f"model.{known[key].suffix}"
        try:
            write(model, path)
        except (QuintrigError, ValueError) as error:
            # The user knows nothing of this folder.
            raise QuintrigError(str(error).replace(str(path), f"export to {key.upper()}")) from None
        return path.read_bytes()
