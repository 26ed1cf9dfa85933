"""Everything that the page tells of one patch, computed once."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from quintrig.analysis.agreement import Agreement, compare_methods
from quintrig.analysis.certified import Certified, certify
from quintrig.analysis.sample import analyse
from quintrig.analysis.summary import Summary, summarise
from quintrig.analysis.table import Table, tabulate
from quintrig.figure import Mark
from quintrig.geometry.domain import face_grid, on_face
from quintrig.geometry.surface import Surface
from quintrig.interrogation.umbilic import Umbilics
from quintrig.interrogation.umbilics import umbilics
from quintrig.model.patch import Patch
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import BY_KEY
from quintrig.shaping.shape_effect import Variant, beside_own, standard_shapes, variant
from quintrig.support.errors import ModelError
from quintrig.support.tolerance import typical_rounding

Report = Callable[[str], None]
"""Called with what is being computed."""

MARKS: tuple[tuple[Mark, str], ...] = tuple(
    (Mark(u, v, label), place)
    for label, u, v, place in (
        ("A", 0.0, 0.0, "corner"),
        ("B", 0.0, 0.5, "middle of the edge u = 0"),
        ("C", 0.0, 1.0, "corner"),
        ("D", 0.5, 0.0, "middle of the edge v = 0"),
        ("E", 0.5, 0.5, "centre"),
        ("F", 0.5, 1.0, "middle of the edge v = 1"),
        ("G", 1.0, 0.0, "corner"),
        ("H", 1.0, 0.5, "middle of the edge u = 1"),
        ("I", 1.0, 1.0, "corner"),
    )
)
"""The labelled points of a whole surface and what they are."""

_STEEP = 0.1  # n_z: the slope is 10, and γ1 and γ3 in the metric of the plane a thousand times those of the surface


_LONG = {
    "summary": "integrals and extremes",
    "agreement": "comparison of the methods",
    "certified": "proofs",
    "varied": "other shape parameters",
}


@dataclass(frozen=True, eq=False)
class Facts:
    """What is known of a patch on grid x grid points, each fact found once, where it is first asked for.

    So pictures, which need few of them, are drawn while the others are worked out. The effect of the shape parameters
    is known where ``detailed``.
    """

    patch: Patch
    unit: str
    thresholds: Thresholds
    grid: int
    detailed: bool

    @cached_property
    def summary(self) -> Summary:
        """Integrals, extremes, means, shares of classes."""
        return summarise(self.patch.surface, self.unit, self.thresholds, self.grid)

    @cached_property
    def agreement(self) -> Agreement:
        """How far the methods agree."""
        return compare_methods(self.patch.surface, self.grid, self.grid, self.thresholds)

    @cached_property
    def certified(self) -> Certified:
        """What is proved."""
        return certify(self.patch.surface, self.unit)

    @cached_property
    def umbilics(self) -> Umbilics:
        """The umbilics, which a picture and the words beside it tell."""
        return umbilics(self.patch)

    @cached_property
    def marks(self) -> tuple[Mark, ...]:
        """The labelled points."""
        return marks_of(self.patch.surface)

    @cached_property
    def points(self) -> Table:
        """Every quantity at the labelled points."""
        u, v = np.array([(mark.u, mark.v) for mark in self.marks]).T
        return tabulate(self.patch.surface, u, v, tuple(BY_KEY), unit=self.unit, thresholds=self.thresholds)

    @cached_property
    def others(self) -> tuple[Patch, ...]:
        """The patch with the thesis's sets of shape parameters, empty where none act."""
        return _others(self.patch) if self.detailed else ()

    @cached_property
    def varied(self) -> tuple[Variant, ...]:
        """The ``others`` with their summaries."""
        return tuple(variant(other, self.unit) for other in self.others)

    @property
    def variants(self) -> tuple[Variant, ...]:
        """The patch as it is, then those ``varied``; empty where there are none."""
        own = Variant(self.patch.shape, self.patch, self.summary, own=True)
        return (own, *self.varied) if self.varied else ()

    @cached_property
    def middle(self) -> tuple[float, float, float]:
        """The normal at the point called E, u = v = 1/2 of a whole surface, NaN where that is singular."""
        x, y, z = analyse(self.patch.surface, self.marks[4].u, self.marks[4].v, ("normal",)).normal.tolist()
        return x, y, z

    @cached_property
    def steep(self) -> bool:
        """Whether the tangent plane comes so near to vertical that in its metric invariants would show little else."""
        surface = self.patch.surface
        over = face_grid(surface, self.grid, self.grid)
        upright = analyse(surface, *over, ("normal",)).normal[..., 2]
        return bool(((np.abs(upright) < _STEEP) & surface.inside(*over)).any())


def marks_of(surface: Surface) -> tuple[Mark, ...]:
    """Return the labelled points: corners, middles and centre, or those of a trimmed face nearest to them."""
    u, v = on_face(surface, *np.array([(mark.u, mark.v) for mark, _ in MARKS]).T)
    return tuple(Mark(float(a), float(b), mark.label) for a, b, (mark, _) in zip(u, v, MARKS, strict=True))


def steps(patch: Patch, detailed: bool) -> int:
    """Return how many steps ``work_out`` reports."""
    return len(_LONG) - (not (detailed and has_effect(patch)))


def work_out(facts: Facts, report: Report) -> None:
    """Find all that takes long, and ``report`` what is at work."""
    for name, what in _LONG.items():
        if name != "varied" or facts.others:
            report(what)
            getattr(facts, name)


def has_effect(patch: Patch) -> bool:
    """Tell whether shape parameters act on a patch."""
    return bool(_others(patch))


def standard(facts: Facts) -> tuple[Variant, ...]:
    """Return the variants with the thesis's sets of shape parameters alone."""
    shapes = standard_shapes(facts.patch) if facts.variants else ()
    return tuple(one for one in facts.variants if one.shape in shapes)


def _others(patch: Patch) -> tuple[Patch, ...]:
    try:
        return beside_own(patch, standard_shapes(patch))[1:]
    except ModelError:  # a kind on which shape parameters do not act
        return ()


def rounding(summary: Summary, key: str) -> float:
    """Return the size at or below which a value of a quantity on this surface is only rounding of zero."""
    return typical_rounding(summary.extremes["curvedness"].mean.value, BY_KEY[key].power)
