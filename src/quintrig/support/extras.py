"""Optional packages: imported when needed, and named in one line when missing."""

from importlib import import_module
from typing import Any

from quintrig.support.errors import QuintrigError

EXTRAS = {
    "OCP": ("cad", "OpenCASCADE"),
    "rhino3dm": ("cad", "rhino3dm"),
    "meshio": ("mesh", "meshio"),
    "trimesh": ("mesh", "trimesh"),
    "ezdxf": ("flat", "ezdxf"),
    "polars": ("sweep", "Polars"),
    "pyarrow": ("sweep", "pyarrow"),
    "distributed": ("cluster", "Dask's distributed"),
    "xarray": ("frames", "xarray"),
    "zarr": ("stream", "Zarr"),
    "pyvista": ("tools", "PyVista"),
    "build123d": ("tools", "build123d"),
    "compas": ("tools", "COMPAS"),
    "sympy": ("formulas", "SymPy"),
}
"""The extra of this package and the name of the project, by Python module."""


def need(module: str, purpose: str, extra: str = "") -> Any:
    """Return an optional module; QuintrigError with the pip command, by default of its usual extra, where missing."""
    package = module.partition(".")[0]
    usual, name = EXTRAS[package]
    try:
        return import_module(module)
    except ImportError as error:
        absent = isinstance(error, ModuleNotFoundError) and (error.name or "").partition(".")[0] == package
        if absent:
            raise missing(purpose, name, extra or usual) from None
        raise QuintrigError(
            f"{purpose} needs {name}, which is installed but does not load ({error}); "
            f"try: {install(extra or usual).replace('install', 'install --force-reinstall', 1)}"
        ) from None


def missing(purpose: str, name: str, extra: str) -> QuintrigError:
    """Return the error that says that a package, by name, is not installed."""
    return QuintrigError(f"{purpose} needs {name}; install it with: {install(extra)}")


def install(extra: str) -> str:
    """Return the command that installs an extra of this package."""
    return f"pip install 'quintrig[{extra}]'"
