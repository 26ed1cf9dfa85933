"""Optional packages: imported when needed, and named in one line when missing."""

from importlib import import_module
from typing import Any

from quintrig.support.errors import QuintrigError

EXTRAS = {
    "OCP": ("cad", "OpenCASCADE"),
    "rhino3dm": ("cad", "rhino3dm"),
    "meshio": ("mesh", "meshio"),
    "ezdxf": ("flat", "ezdxf"),
}
"""The extra of this package and the name of the project, by Python module."""


def need(module: str, purpose: str) -> Any:
    """Return an optional module; QuintrigError with the pip command where it is not installed."""
    extra, name = EXTRAS[module.partition(".")[0]]
    try:
        return import_module(module)
    except ImportError as error:
        if isinstance(error, ModuleNotFoundError) and (error.name or "").partition(".")[0] == module.partition(".")[0]:
            raise QuintrigError(f"{purpose} needs {name}; install it with: pip install 'quintrig[{extra}]'") from None
        raise QuintrigError(
            f"{purpose} needs {name}, which is installed but does not load ({error}); "
            f"try: pip install --force-reinstall 'quintrig[{extra}]'"
        ) from None
