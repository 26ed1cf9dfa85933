"""Whatever another tool holds, as a scan or a model: who knows it is told by the package that its type comes from."""

from importlib import import_module
from typing import Any

import numpy as np

from quintrig.model.model import Model
from quintrig.scan.scan import Scan

_KNOWN = {
    "pyvista": "from_pyvista",
    "vtkmodules": "from_pyvista",
    "trimesh": "from_trimesh",
    "compas": "from_compas",
    "build123d": "from_build123d",
}


def foreign(value: Any) -> Scan | Model | None:
    """Return what the tool's ``from_...`` gives, and None for a value of no such tool; raises what those raise."""
    if isinstance(value, (np.ndarray, list, tuple)):  # arrays and lists of theirs are numbers first
        return None
    for kind in type(value).__mro__:
        name = _KNOWN.get(kind.__module__.partition(".")[0])
        if name:
            taken: Scan | Model = getattr(import_module(f"quintrig.exchange.tools.{name}"), name)(value)
            return taken
    return None
