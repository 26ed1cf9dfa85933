"""What can be asked for of lines: the options, each checked once."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray, frozen, parameter
from quintrig.support.errors import nearest

MOST = 1000
"""Lines of one kind that can be asked for."""

Vector = Sequence[float]


@dataclass(frozen=True)
class Ask:
    """Options of all kinds; each kind says which it takes. Lengths in the model's unit, angles in degrees."""

    start: Vector | None = None
    patch: str | None = None
    to: Vector | None = None
    to_patch: str | None = None
    direction: float | Vector | None = None
    eye: Vector | None = None
    light: Vector | None = None
    along: Vector | None = None
    angles: Sequence[float] | None = None
    quantity: str | None = None
    levels: Sequence[float] | None = None
    count: int | None = None
    spacing: float | None = None
    normal: Vector | None = None
    through: Vector | None = None
    other: Surface | Patch | Model | None = None
    u: Sequence[float] | None = None
    v: Sequence[float] | None = None
    family: int | None = None
    umbilics: bool | None = None
    length: float | None = None
    tolerance: float | None = None

    def given(self) -> list[str]:
        """Return the names of the options that are set."""
        return [name for name, value in vars(self).items() if value is not None]


def refuse_others(kind: str, ask: Ask, takes: Sequence[str]) -> None:
    """Raise ValueError for an option that a kind does not take."""
    for name in ask.given():
        if name not in (*takes, "tolerance"):
            raise ValueError(
                f"{name}: {kind} lines take {', '.join((*takes, 'tolerance'))}, not this{nearest(name, takes)}"
            )


def vector(values: object, name: str) -> FloatArray:
    """Return a unit vector (3,); ValueError where it is none or has no length."""
    found = frozen(values, name, (3,))  # pyright: ignore[reportArgumentType]
    size = float(np.linalg.norm(found))
    if not size > 0.0:
        raise ValueError(f"{name}: expected a vector with a length, found 0,0,0")
    return found / size


def place(values: Vector | None, name: str) -> FloatArray:
    """Return parameters (2,); ValueError where there are none, or outside [0, 1]."""
    if values is None:
        raise ValueError(f"{name}: expected parameters U,V to begin at, found none")
    found = frozen(values, name, (2,))
    return parameter(found, name)


def length(value: float | None, name: str, usual: float) -> float:
    """Return a length above 0, or the usual one."""
    if value is None:
        return usual
    if not (np.isfinite(value) and value > 0.0):
        raise ValueError(f"{name}: expected a length greater than 0, found {value:g}")
    return float(value)


def few(number: float, name: str, remedy: str) -> None:
    """Raise ValueError where more lines are asked for than are drawn."""
    if number > MOST:
        raise ValueError(f"{name}: asks for about {number:.3g} lines, of at most {MOST:,}; {remedy}")


def degrees(values: Sequence[float], name: str, low: float, high: float) -> FloatArray:
    """Return angles in degrees between two bounds."""
    found = frozen(values, name, (None,))
    few(len(found), name, "ask for fewer")
    for angle in found.tolist():
        if not low <= angle <= high:
            raise ValueError(f"{name}: expected degrees from {low:g} to {high:g}, found {angle:g}")
    return found
