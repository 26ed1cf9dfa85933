"""Which closed form a bare surface is: its sizes are read off its coefficients and checked by building it again."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from quintrig.basis.functions import Circular, Hyperbolic, Joined, Powers
from quintrig.geometry import closed_forms as reference
from quintrig.geometry.surface import Net, Surface

_ALIKE = 1e-12  # of the size: closer than this, two surfaces are one


def closed_form(surface: Surface) -> dict[str, Any] | None:
    """Return the keys of a model that builds this surface from a closed form; None for any other surface."""
    for kind, sizes in _candidates(surface.rows):
        if not all(0.0 < abs(value) < np.inf for value in sizes.values()):
            continue
        try:
            plain: Surface = getattr(reference, kind)(**sizes)
        except ValueError:  # a radius below zero, say
            continue
        if _alike(plain, surface):
            return {"kind": kind, **sizes, "flip": plain.flip != surface.flip}
    return None


def _candidates(rows: object) -> Iterator[tuple[str, dict[str, float]]]:
    """Yield the closed forms that rows may be, with the sizes that their coefficients then say."""
    if not isinstance(rows, Net) or rows.dimension != 3:
        return
    functions, shape = rows.functions, rows.points.shape[:2]

    def at(i: int, j: int, x: int) -> float:
        return float(rows.points[i, j, x])

    if isinstance(functions, Circular) and shape == (2, 3):
        yield "sphere", {"radius": at(0, 0, 0)}
        yield "ellipsoid", {"a": at(0, 0, 0), "b": at(0, 1, 1), "c": at(1, 2, 2)}
    elif isinstance(functions, Joined) and shape == (3, 3):
        yield "torus", {"major": at(2, 0, 0), "minor": at(0, 0, 0)}
    elif isinstance(functions, Joined) and isinstance(functions.parts[0], Hyperbolic) and shape == (4, 3):
        yield "catenoid", {"waist": at(0, 0, 0), "height": 2.0 * functions.parts[0].end * at(0, 0, 0)}
    elif isinstance(functions, Powers):
        if shape == (2, 3):
            for kind in ("cylinder", "cone"):
                yield kind, {"radius": at(0, 0, 0), "height": at(1, 2, 2)}
        if shape == (2, 4):
            yield "helicoid", {"radius": functions.end, "pitch": 2.0 * np.pi * at(0, 3, 2)}
        for kind in ("hyperbolic_paraboloid", "monkey_saddle", "enneper"):
            yield kind, {"size": functions.end}


def _alike(one: Surface, other: Surface) -> bool:
    """Return whether two surfaces of like rows are the same: 81 points are more than any closed form has freedom."""
    t = np.linspace(0.0, 1.0, 9)
    gap = np.abs(one(t[:, None], t[None, :]) - other(t[:, None], t[None, :])).max()
    return bool(gap <= _ALIKE * one.size)
