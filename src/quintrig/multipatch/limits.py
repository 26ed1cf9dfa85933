"""The limits up to which edges count as joined: presets of practice, in a model's own unit."""

from dataclasses import dataclass
from typing import Literal

Preset = Literal["class-a", "engineering"]

_IN_MM = {"um": 1e3, "mm": 1.0, "cm": 0.1, "m": 1e-3, "km": 1e-6, "in": 1.0 / 25.4, "ft": 1.0 / 304.8}
_PRESETS: dict[str, tuple[float, float, float]] = {"class-a": (0.001, 0.016, 0.005), "engineering": (0.01, 0.1, 0.05)}
_OF_SIZE = 1e-3  # a model without a unit counts as one of 1000 mm
_FLAT = 1e-3


@dataclass(frozen=True)
class Limits:
    """Largest gap (length¹), angle (degrees) and relative jump of curvature of edges that are joined.

    Raises ValueError for one that is not a finite number above 0.
    """

    tolerance: float
    angle: float
    curvature: float

    def __post_init__(self) -> None:
        """Check once, at birth."""
        for name, value in (("tolerance", self.tolerance), ("angle", self.angle), ("curvature", self.curvature)):
            if not 0.0 < value < float("inf"):
                raise ValueError(f"{name}: expected a finite number greater than 0, found {value:g}")

    def describe(self, unit: str) -> str:
        """Return the limits in words, with units."""
        length = f"{self.tolerance:.3g} {unit}".rstrip()
        return f"G0 within {length}, G1 within {self.angle:g}°, G2 and G3 within a relative jump of {self.curvature:g}"


def limits(
    unit: str = "",
    size: float = 1.0,
    preset: Preset = "engineering",
    *,
    tolerance: float | None = None,
    angle: float | None = None,
    curvature: float | None = None,
) -> Limits:
    """Return a preset, or some other numbers in its place.

    ``class-a``: 0.001 mm, 0.016°, 0.5 %; ``engineering``: 0.01 mm, 0.1°, 5 %. A model without a unit is taken to be
    1000 mm in ``size``. Raises ValueError for an unknown preset and for limits that are not above 0.
    """
    if preset not in _PRESETS:
        raise ValueError(f"preset: expected {' or '.join(_PRESETS)}, found {preset!r}")
    gap, turn, jump = _PRESETS[preset]
    gap *= _IN_MM[unit] if unit else _OF_SIZE * size if size > 0.0 else 1.0
    return Limits(
        gap if tolerance is None else tolerance,
        turn if angle is None else angle,
        jump if curvature is None else curvature,
    )


def flat(size: float) -> float:
    """Return the curvature, length⁻¹, that counts as none beside a patch of this size: a sagitta of 1/8000 of it."""
    return _FLAT / size
