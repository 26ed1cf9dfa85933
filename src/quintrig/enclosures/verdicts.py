"""What comes of a claim: proved, refuted with a witness, or undecided with the regions that are left open."""

from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np

Word = Literal["proved", "refuted", "undecided"]


@dataclass(frozen=True)
class Witness:
    """A place where a claim does not hold: (u, v), the point, length¹, and the ``value`` of the quantity there."""

    u: float
    v: float
    point: tuple[float, ...]
    value: float
    patch: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Return it as keys and values; a value that is not finite is null."""
        value = self.value if np.isfinite(self.value) else None
        return {"patch": self.patch, "u": self.u, "v": self.v, "point": list(self.point), "value": value}


@dataclass(frozen=True)
class Region:
    """A rectangle of (u, v) that is left open."""

    u: tuple[float, float]
    v: tuple[float, float]
    patch: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Return it as keys and values."""
        return {"patch": self.patch, "u": list(self.u), "v": list(self.v)}


@dataclass(frozen=True)
class Verdict:
    """What came of a ``claim``, after so many ``boxes``.

    ``bounds`` enclose all values that the quantity takes, in the model's unit; None for claims without one.
    ``regions`` are those left open, and ``why``; ``notes`` say what the proof does not speak of.
    """

    verdict: Word
    claim: str
    boxes: int
    witness: Witness | None = None
    bounds: tuple[float, float] | None = None
    regions: tuple[Region, ...] = ()
    why: str = ""
    notes: tuple[str, ...] = field(default=())
    unit: str = ""

    @property
    def proved(self) -> bool:
        """Whether the claim is proved."""
        return self.verdict == "proved"

    def __bool__(self) -> bool:
        """Refuse to be read as true or false: undecided is neither."""
        raise TypeError("a verdict is proved, refuted or undecided; ask .proved or .verdict")

    def to_dict(self) -> dict[str, Any]:
        """Return it as keys and values; bounds without end are null."""
        ends = [end if np.isfinite(end) else None for end in self.bounds] if self.bounds else None
        return {
            "verdict": self.verdict,
            "claim": self.claim,
            "boxes": self.boxes,
            "witness": self.witness.to_dict() if self.witness else None,
            "bounds": ends,
            "unit": self.unit,
            "regions": [region.to_dict() for region in self.regions],
            "why": self.why,
            "notes": list(self.notes),
        }

    def on(self, patch: str) -> "Verdict":
        """Return the same, said of a patch by its name."""
        witness = replace(self.witness, patch=patch) if self.witness else None
        return replace(self, witness=witness, regions=tuple(replace(one, patch=patch) for one in self.regions))


def together(verdicts: list[Verdict]) -> Verdict:
    """Return one verdict on all patches: refuted where one is, else undecided where one is, else proved."""
    order: tuple[Word, ...] = ("refuted", "undecided", "proved")
    worst = next(word for word in order if any(one.verdict == word for one in verdicts))
    found = [one.bounds for one in verdicts if one.bounds]
    return replace(
        next(one for one in verdicts if one.verdict == worst),
        boxes=sum(one.boxes for one in verdicts),
        bounds=(min(low for low, _ in found), max(high for _, high in found)) if found else None,
        regions=tuple(region for one in verdicts for region in one.regions),
        notes=tuple(dict.fromkeys(note for one in verdicts for note in one.notes)),
    )
