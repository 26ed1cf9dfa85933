"""Optional packages: imported when needed, and named in one line when missing or of another version."""

import re
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

VERSIONS = {
    "OCP": ("7.9.3", "9"),
    "rhino3dm": ("8.9", ""),
    "meshio": ("5.3", ""),
    "trimesh": ("4.5", ""),
    "ezdxf": ("1.3", ""),
    "polars": ("2.0", ""),
    "pyarrow": ("23.0.1", ""),
    "distributed": ("2026.1.0", ""),
    "xarray": ("2025.1", ""),
    "zarr": ("3.1.1", ""),
    "pyvista": ("0.44", ""),
    "build123d": ("0.10", ""),
    "compas": ("2.4", ""),
    "sympy": ("1.13", ""),
}
"""The lowest version that does and the first that no longer does, as in pyproject.toml."""


def need(module: str, purpose: str, extra: str = "") -> Any:
    """Return an optional module; QuintrigError with the pip command, of its usual extra, where missing or too old."""
    package = module.partition(".")[0]
    usual, name = EXTRAS[package]
    try:
        top = import_module(package)
        _refuse_version(package, str(getattr(top, "__version__", "")), purpose, extra or usual)
        return top if module == package else import_module(module)
    except ImportError as error:
        absent = isinstance(error, ModuleNotFoundError) and (error.name or "").partition(".")[0] == package
        if absent:
            raise missing(purpose, name, extra or usual) from None
        raise QuintrigError(
            f"{purpose} needs {name}, which is installed but does not load ({error}); "
            f"try: {install(extra or usual).replace('install', 'install --force-reinstall', 1)}"
        ) from None


def _refuse_version(package: str, found: str, purpose: str, extra: str) -> None:
    lowest, end = VERSIONS[package]
    if not found or (_numbers(found) >= _numbers(lowest) and not (end and _numbers(found) >= _numbers(end))):
        return
    raise QuintrigError(
        f"{purpose} needs {EXTRAS[package][1]} {lowest} or newer{f', below {end}' if end else ''}, found {found}; "
        f"try: {install(extra).replace('install', 'install -U', 1)}"
    )


def _numbers(version: str) -> tuple[int, ...]:
    """Return the numbers that a version begins with."""
    return tuple(int(part) for part in re.findall(r"\d+", re.split(r"[^\d.]", version, maxsplit=1)[0]))


def missing(purpose: str, name: str, extra: str) -> QuintrigError:
    """Return the error that says that a package, by name, is not installed."""
    return QuintrigError(f"{purpose} needs {name}; install it with: {install(extra)}")


def install(extra: str) -> str:
    """Return the command that installs an extra of this package."""
    return f"pip install 'quintrig[{extra}]'"
