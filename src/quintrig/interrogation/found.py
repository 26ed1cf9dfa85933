"""What is found of lines, and the lines of all levels of a scalar on all patches."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from quintrig.analysis.sample import analyse
from quintrig.geometry.surface import Surface
from quintrig.interrogation.ask import few
from quintrig.interrogation.levels import Grid, Scalar
from quintrig.interrogation.line import Line
from quintrig.interrogation.polyline import Path, Values, line_of
from quintrig.interrogation.subject import Subject
from quintrig.model.patch import Patch

COUNT = 10
"""Levels where nothing else is asked for."""

_POINT = 1e-9  # of the size: lines no longer than this are points
_SAME = 1e-13  # of the size of the values: a scalar that does not vary


@dataclass(eq=False)
class Found:
    """Lines, what their values are, and what is to be told; ``traced`` lines have their chain numbers already."""

    quantity: str
    unit: str
    lines: list[Line] = field(default_factory=list[Line])
    notes: list[str] = field(default_factory=list[str])
    traced: bool = False


@dataclass(frozen=True)
class Level:
    """A ``value`` of a scalar, the ``label`` of its lines, and the number that is ``told`` of them."""

    value: float
    label: str
    told: float | None = None


Make = Callable[[Surface], Scalar]
"""What makes a scalar for the surface of each patch."""


def level_lines(
    on: Subject, make: Make, wanted: Sequence[Level], found: Found, values: Values, vanish: str = ""
) -> Found:
    """Add the lines of all levels on all patches; ``vanish`` is said of a patch on which the scalar is a level."""
    few(len(wanted), "levels", "ask for fewer")
    for number, patch in enumerate(on.patches):
        surface = patch.surface
        grid = Grid.of(surface, make(surface))
        f, g, _ = grid.parts
        size = float(np.nanmax(np.abs(f), initial=0.0)) + float(np.nanmax(np.abs(g), initial=0.0))
        for k, level in enumerate(wanted):
            on.tell(f"{patch.name}: {level.label}", number * len(wanted) + k, len(on.patches) * len(wanted))
            here = grid.values(level.value)
            inside = np.isfinite(here) & surface.inside(grid.u[:, None], grid.v[None, :])
            if inside.any() and np.abs(here[inside]).max() <= _SAME * size:
                found.notes.append(f"{patch.name}: {vanish or level.label} on the whole patch, which is no line")
                continue
            paths = grid.paths(number, surface, level.value, on.chord)
            found.lines += as_lines(patch, paths, level.label, values, level.told)
    if not found.lines and not found.notes:
        found.notes.append("the model has no such line")
    return found


def as_lines(
    patch: Patch, paths: Sequence[Path], label: str, values: Values, told: float | None = None, strength: bool = False
) -> Iterator[Line]:
    """Yield the lines of paths, cut at the loops of the face; what touches the edge in one point is none."""
    for path in paths:
        for part in path.cut(patch.surface):
            line = line_of(patch.surface, patch.name, part, label, values, level=told, strength=strength)
            if line.length > _POINT * patch.surface.size:
                yield line


def of_quantity(key: str) -> Values:
    """Return the values of a quantity of the table along a line."""
    return lambda surface, uv: analyse(surface, uv[:, 0], uv[:, 1], (key,), threads=1)[key]


def bent(on: Subject) -> Found:
    """Return what has the normal curvature for its values, and no lines yet."""
    return Found("normal curvature", on.measure(-1))
