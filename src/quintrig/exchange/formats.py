"""The kinds of file that are written, one row each: menus, messages and tests read this table."""

from dataclasses import dataclass
from importlib.util import find_spec
from typing import Literal

Family = Literal["cad", "mesh", "pattern", "net", "model"]

FAMILIES: dict[Family, str] = {
    "cad": "CAD, exact",
    "mesh": "Mesh, to a tolerance",
    "pattern": "Flat pattern",
    "net": "Control net",
    "model": "Model",
}
"""What the families are called."""


@dataclass(frozen=True)
class Format:
    """A kind of file: its ``suffixes``, the usual one first, its name, and the Python module that writing it needs."""

    suffixes: tuple[str, ...]
    label: str
    family: Family
    needs: str = ""

    @property
    def suffix(self) -> str:
        """The usual ending, with its dot."""
        return self.suffixes[0]

    @property
    def installed(self) -> bool:
        """Whether what writing it needs is installed."""
        return not self.needs or find_spec(self.needs) is not None


FORMATS = (
    Format((".step", ".stp"), "STEP", "cad", "OCP"),
    Format((".iges", ".igs"), "IGES", "cad", "OCP"),
    Format((".brep",), "OpenCASCADE BREP", "cad", "OCP"),
    Format((".3dm",), "Rhino 3DM", "cad", "rhino3dm"),
    Format((".stl",), "STL", "mesh"),
    Format((".obj",), "OBJ with colours", "mesh"),
    Format((".ply",), "PLY with curvature", "mesh"),
    Format((".glb",), "glTF with colours", "mesh"),
    Format((".vtu",), "VTK with curvature", "mesh", "meshio"),
    Format((".dxf",), "DXF for the cutter", "pattern", "ezdxf"),
    Format((".svg",), "SVG drawing", "pattern"),
    Format((".pdf",), "PDF at true scale", "pattern"),
    Format((".csv",), "CSV of the points", "net"),
    Format((".json",), "JSON", "model"),
    Format((".toml",), "TOML", "model"),
)
"""Every format, whether or not it is installed here."""


def suffixes(*families: Family) -> tuple[str, ...]:
    """Return every ending of the families, in the order of the table."""
    return tuple(suffix for one in FORMATS if one.family in families for suffix in one.suffixes)
