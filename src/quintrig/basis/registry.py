"""The bases that constructions and curves take, by name."""

from typing import Literal

from quintrig.basis.bernstein import Bernstein
from quintrig.basis.functions import Functions
from quintrig.basis.trigonometric import Trigonometric

BasisName = Literal["trigonometric", "bernstein"]


def family(name: BasisName, points: int, alpha: float, zeta: float, unchecked: bool = False) -> Functions:
    """Return the basis called ``name`` for this many control points; ValueError where they do not fit."""
    if name == "trigonometric":
        if points != 6:
            raise ValueError(f"points: expected 6 control points for the trigonometric basis, found {points}")
        return Trigonometric(alpha, zeta, unchecked)
    if name == "bernstein":
        if points < 2:
            raise ValueError(f"points: expected 2 or more control points, found {points}")
        return Bernstein(points - 1)
    raise ValueError(f"basis: expected 'trigonometric' or 'bernstein', found {name!r}")
