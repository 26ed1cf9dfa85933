"""What no file holds well: a model far from the origin, and one that is a single point."""

import numpy as np

from quintrig.geometry.domain import grid
from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.support.tolerance import rounding

_TOLD = 1e-10
"""Rounding of the coordinates, relative to a surface's size, that the user should know of."""


def is_far(surface: Surface) -> bool:
    """Return whether a surface lies so far from the origin that rounding is more than 1e-10 of its size."""
    return rounding(surface(*grid(3, 3))) > _TOLD * surface.size


def far(surface: Surface) -> str:
    """Return in words how far from the origin a surface lies, and what the rounding there is, length¹."""
    away = distance(surface)
    return f"it lies {away:.3g} from the origin, where coordinates go in steps of {float(np.spacing(away)):.2g}"


def distance(surface: Surface) -> float:
    """Return how far from the origin a surface reaches, length¹, by nine of its points."""
    points = surface(*grid(3, 3)).reshape(-1, 3)
    points = points[np.isfinite(points).all(axis=-1)]
    return float(np.sqrt((points**2).sum(axis=-1)).max(initial=0.0))


def refuse_point(model: Model) -> None:
    """Raise ValueError where all of a patch is one point: it has no size to be exact or near to."""
    for patch in model.patches:
        if not patch.surface.size > 0.0:
            raise ValueError(
                f'patch "{patch.name}": all of it is a single point; are its control points equal, or so far from the '
                "origin that rounding makes them equal?"
            )
