"""What fairing gives, of a patch or of a curve, and the path from what is there to the least energy."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

from quintrig.model.model import Model

Shape = TypeVar("Shape")

BETWEEN = 0.999
"""Of the deviation allowed is used: what may be more between the points that are looked at."""

_WEIGHTS = (-12.0, 6.0)  # of the distance, relative to the energy's own scale, as powers of ten


@dataclass(frozen=True, eq=False)
class Fairing:
    """The model with a fairer ``part``, a patch or a curve by name, and what that took.

    ``before`` and ``after`` are all energies by name. Of a patch ``thin_plate`` and ``variation`` are in length²,
    ``bending``, ∫κ1² + κ2² dA, is a pure number; of a curve they are ∫|z''|² dt and ∫|z'''|² dt in length², and ∫κ² ds
    in length⁻¹. ``deviation`` is the largest distance that a point moved at its parameters, length¹, at 129 x 129
    points of a patch and 257 of a curve. ``held`` names what was held.
    """

    model: Model
    part: str
    energy: str
    before: dict[str, float]
    after: dict[str, float]
    deviation: float
    held: tuple[str, ...]
    notes: tuple[str, ...] = ()

    @property
    def of_curve(self) -> bool:
        """Whether the part is a curve."""
        return any(one.name == self.part for one in self.model.curves)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, without the model; of a patch its shape parameters too."""
        shape = {} if self.of_curve else {"shape": list(self.model.patch(self.part).shape)}
        return {
            "curve" if self.of_curve else "patch": self.part,
            "unit": self.model.unit,
            "energy": self.energy,
            "before": self.before,
            "after": self.after,
            "deviation": self.deviation,
            "held": list(self.held),
            **shape,
            "notes": list(self.notes),
        }


def fairest_near(step: Callable[[float], Shape], near: Callable[[Shape], bool], rounds: int) -> Shape:
    """Return ``step`` of the least weight of the distance that is ``near`` enough, by halving in its logarithm.

    Where none is near, it is that of the least weight, which the caller has to refuse.
    """
    low, high = _WEIGHTS
    found = step(10.0**low)
    if near(found):
        return found
    for _ in range(rounds):
        middle = 0.5 * (low + high)
        tried = step(10.0**middle)
        found, low, high = (tried, low, middle) if near(tried) else (found, middle, high)
    return found
