"""What lines are looked for on: the patches, their size, and how fine."""

from dataclasses import dataclass, field, replace
from time import monotonic

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.interrogation.umbilics import patches_of
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray
from quintrig.support.progress import Progress

_QUIET = 2.0  # seconds


@dataclass(frozen=True, eq=False)
class Subject:
    """Patches by number, the unit of length, the size of all of them, and the chord error to keep, length¹."""

    patches: tuple[Patch, ...]
    unit: str
    size: float
    low: FloatArray
    high: FloatArray
    progress: Progress | None = None
    chord: float = 0.0
    since: float = field(default_factory=monotonic)

    @staticmethod
    def of(subject: Surface | Patch | Model, name: str | None, progress: Progress | None) -> "Subject":
        """Return all patches, or the one of this name; ValueError for a single point."""
        unit = subject.unit if isinstance(subject, Model) else ""
        patches = patches_of(subject)
        if name is not None:
            patches = (_named(subject, patches, name),)
        t = np.linspace(0.0, 1.0, 17)
        points = np.concatenate([patch.surface(t[:, None], t[None, :]).reshape(-1, 3) for patch in patches])
        points = points[np.isfinite(points).all(axis=1)]
        low, high = points.min(axis=0), points.max(axis=0)
        size = float(np.linalg.norm(high - low))
        if not size > 0.0:
            raise ValueError("subject: expected a surface, found a single point")
        return Subject(patches, unit, size, low, high, progress)

    def within(self, chord: float) -> "Subject":
        """Return it with a chord error to keep."""
        return replace(self, chord=chord)

    @property
    def surfaces(self) -> tuple[Surface, ...]:
        """The surfaces of the patches."""
        return tuple(patch.surface for patch in self.patches)

    def number(self, name: str | None, what: str = "patch") -> int:
        """Return the number of the patch of this name, or of the only one; ValueError naming those there are."""
        known = [patch.name for patch in self.patches]
        if name is None and len(known) == 1:
            return 0
        if name not in known:
            found = "none" if name is None else repr(name)
            raise ValueError(f"{what}: expected one of {', '.join(known)}, found {found}")
        return known.index(name)

    def measure(self, power: int) -> str:
        """Return the unit of a power of length, such as 1/mm."""
        if not self.unit or power == 0:
            return ""
        raised = self.unit + {1: "", 2: "²"}[abs(power)]
        return raised if power > 0 else f"1/{raised}"

    def tell(self, what: str, done: int, total: int) -> None:
        """Tell how far the work is, once it takes longer than anyone would wonder."""
        if self.progress and monotonic() - self.since > _QUIET:
            self.progress(what, done, total)


def _named(subject: object, patches: tuple[Patch, ...], name: str) -> Patch:
    if isinstance(subject, Model):
        return subject.patch(name)
    if patches[0].name != name:
        raise ValueError(f"patch: expected {patches[0].name}, found {name!r}")
    return patches[0]
