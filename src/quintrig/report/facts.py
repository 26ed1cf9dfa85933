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


@dataclass(frozen=True, eq=False)
class Facts:
    """What is known of a patch.

    ``variants`` are its own, first, and the thesis's sets of shape parameters, empty where none act; ``marks`` are the
    labelled points and ``middle`` is the normal at the one called E, u = v = 1/2 of a whole surface, NaN where that is
    singular. ``steep`` says that the tangent plane comes so near to vertical that maps of the invariants in the metric
    of the plane would show little else.
    """

    patch: Patch
    unit: str
    thresholds: Thresholds
    summary: Summary
    agreement: Agreement
    marks: tuple[Mark, ...]
    certified: Certified
    points: Table
    variants: tuple[Variant, ...]
    middle: tuple[float, float, float]
    steep: bool

    @cached_property
    def umbilics(self) -> Umbilics:
        """The umbilics, which a picture and the words beside it tell."""
        return umbilics(self.patch)


def marks_of(surface: Surface) -> tuple[Mark, ...]:
    """Return the labelled points: corners, middles and centre, or those of a trimmed face nearest to them."""
    u, v = on_face(surface, *np.array([(mark.u, mark.v) for mark, _ in MARKS]).T)
    return tuple(Mark(float(a), float(b), mark.label) for a, b, (mark, _) in zip(u, v, MARKS, strict=True))


def steps(patch: Patch, detailed: bool) -> int:
    """Return how many steps ``gather`` reports."""
    return 3 + (len(_others(patch)) if detailed else 0)


def gather(patch: Patch, unit: str, thresholds: Thresholds, grid: int, detailed: bool, report: Report) -> Facts:
    """Compute everything about a patch on grid x grid points; the effect of the shape parameters where ``detailed``."""
    surface = patch.surface
    report("integrals and extremes")
    summary = summarise(surface, unit, thresholds, grid)
    report("comparison of the methods")
    agreement = compare_methods(surface, grid, grid, thresholds)
    report("proofs")
    certified = certify(surface, unit)
    marks = marks_of(surface)
    u, v = np.array([(mark.u, mark.v) for mark in marks]).T
    points = tabulate(surface, u, v, tuple(BY_KEY), unit=unit, thresholds=thresholds)
    variants: list[Variant] = []
    for other in _others(patch) if detailed else ():
        report(f"shape parameters ({', '.join(f'{x:g}' for x in other.shape)})")
        variants.append(variant(other, unit))
    if variants:
        variants.insert(0, Variant(patch.shape, patch, summary, own=True))
    centre = marks[4]
    middle = analyse(surface, centre.u, centre.v, ("normal",)).normal
    x, y, z = (float(part) for part in middle)
    over = face_grid(surface, grid, grid)
    upright = analyse(surface, *over, ("normal",)).normal[..., 2]
    steep = bool(((np.abs(upright) < _STEEP) & surface.inside(*over)).any())
    found = (summary, agreement, marks, certified, points, tuple(variants))
    return Facts(patch, unit, thresholds, *found, (x, y, z), steep)


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
