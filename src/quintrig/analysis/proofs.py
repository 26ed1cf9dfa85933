"""Claims on models, proved, refuted or left open, and certified bounds of their quantities."""

from collections.abc import Sequence
from dataclasses import replace
from typing import overload

import numpy as np
from numpy.typing import ArrayLike

from quintrig.analysis.sample import analyse
from quintrig.enclosures.claims import DIRECTIONS, Claim, key_of, read
from quintrig.enclosures.measures import MEASURES
from quintrig.enclosures.prove import MOST, Prover
from quintrig.enclosures.search import Bounds
from quintrig.enclosures.verdicts import Verdict, together
from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.quantities.table import BY_KEY
from quintrig.support.arrays import frozen, number, whole
from quintrig.support.errors import nearest
from quintrig.support.progress import Progress, watched
from quintrig.support.tolerance import typical_rounding

Subject = Surface | Patch | Model
_AGREE = 1e-6
"""Of the curvedness: a witness's value and that of a sample at the same place differ by no more."""


@overload
def prove(  # pyright: ignore[reportOverlappingOverload]  # a text is a sequence too, but is meant as one claim
    subject: Subject,
    claim: str,
    *,
    unit: str = "",
    bounds: bool = False,
    boxes: int = MOST,
    progress: Progress | None = None,
) -> Verdict: ...
@overload
def prove(
    subject: Subject,
    claim: Sequence[str],
    *,
    unit: str = "",
    bounds: bool = False,
    boxes: int = MOST,
    progress: Progress | None = None,
) -> tuple[Verdict, ...]: ...
@watched
def prove(
    subject: Subject,
    claim: str | Sequence[str],
    *,
    unit: str = "",
    bounds: bool = False,
    boxes: int = MOST,
    progress: Progress | None = None,
) -> Verdict | tuple[Verdict, ...]:
    """Return whether claims hold on all of a surface, or of every patch: ``proved``, ``refuted`` or ``undecided``.

    A claim compares one of gaussian, mean, k1, k2, curvedness, curvature_radius, slope and draft with numbers, in the
    unit of the model or in one of its own (angles always with one), as ``gaussian > 0``, ``-5 deg <= draft <= 5 deg``
    or ``slope <= 60 deg along x``; or it is one of regular, convex, inside hull, no fold, developable. ``bounds`` adds
    what encloses the quantity's values, and ``boxes`` is the most that a claim may take on a chart. Every rounding is
    accounted for (docs/guide/proofs.md). Raises ValueError for a claim that cannot be read, and NoProofError, one too,
    for a surface whose functions are neither polynomials nor trigonometric forms of one angle.
    """
    texts = [claim] if isinstance(claim, str) else list(claim)
    unit = _unit(subject, unit)
    claims = [read(text, unit) for text in texts]
    boxes = whole(boxes, "boxes", 1)
    provers = [(name, Prover(surface, unit, boxes)) for name, surface in _surfaces(subject)]
    steps, done = len(claims) * len(provers), 0
    result: list[Verdict] = []
    for one in claims:
        found: list[Verdict] = []
        for name, prover in provers:
            if progress:
                progress(f"proving {one.text}", done, steps)
            found.append(_checked(prover, one, prover.prove(one, bounds)).on(name))
            done += 1
        result.append(together(found))
    return result[0] if isinstance(claim, str) else tuple(result)


def bounds(
    subject: Subject,
    key: str,
    tolerance: float = 1e-3,
    *,
    direction: ArrayLike = DIRECTIONS["z"],
    unit: str = "",
    boxes: int = MOST,
) -> Bounds:
    """Return what surely encloses the least and the greatest value of a quantity on a surface, or on all patches.

    Each end is known to ``tolerance`` times the larger of both, unless ``boxes`` a chart are used up before; of
    curvature_radius, the smaller radius of curvature, length¹, the least is sought. ``direction`` is that of slope and
    draft, degrees. Raises ValueError as ``prove`` does.
    """
    key = key_of(given := key)
    if key not in MEASURES:
        raise ValueError(
            f"key: {given!r} has no certified bounds{nearest(key, MEASURES)}; there are {', '.join(MEASURES)}"
        )
    tolerance = number(tolerance, "tolerance")
    if not tolerance > 0.0:
        raise ValueError(f"tolerance: expected a number greater than 0, found {tolerance:g}")
    along = frozen(direction, "direction", (3,))
    unit = _unit(subject, unit)
    found = [
        Prover(surface, unit, whole(boxes, "boxes", 1)).bounds(key, tolerance, along)
        for _, surface in _surfaces(subject)
    ]
    low, high = (np.array([getattr(one, name) for one in found]) for name in ("minimum", "maximum"))
    return replace(
        found[0],
        minimum=tuple(low.min(axis=0).tolist()),
        maximum=tuple(high.max(axis=0).tolist()),
        boxes=sum(one.boxes for one in found),
        complete=all(one.complete for one in found),
    )


def _surfaces(subject: Subject) -> list[tuple[str, Surface]]:
    if isinstance(subject, Model):
        subject.refuse_curves()
        return [(patch.name, patch.surface) for patch in subject.patches]
    return [(subject.name, subject.surface)] if isinstance(subject, Patch) else [("", subject)]


def _unit(subject: Subject, unit: str) -> str:
    return subject.unit if isinstance(subject, Model) else unit


def _checked(prover: Prover, claim: Claim, verdict: Verdict) -> Verdict:
    """Return the verdict; where it is refuted, the witness has been looked at with the sampler too."""
    witness = verdict.witness
    if witness is None or claim.key not in BY_KEY or not np.isfinite(witness.value):
        return verdict
    sample = analyse(prover.surface, witness.u, witness.v, (claim.key, "curvedness"))
    value, size = (float(part) for part in (sample[claim.key], sample["curvedness"]))
    power = BY_KEY[claim.key].power
    scale: float = max(size**-power, abs(witness.value))
    if power < 0 and abs(witness.value) <= typical_rounding(size, power):
        note = "the value there is no more than what rounded control points make of 0; leave the claim that much room"
        verdict = replace(verdict, notes=(*verdict.notes, note))
    if np.isfinite(value) and abs(value - witness.value) > _AGREE * scale:
        note = f"sampled there it is {value:.6g}: the surface is nearly singular, and samples lose their digits"
        return replace(verdict, notes=(*verdict.notes, note))
    return verdict
