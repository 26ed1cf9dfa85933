"""The convex-hull property, proved: non-negative functions that sum to 1 keep a surface inside the hull of its net."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from quintrig.basis.exact_forms import POLYNOMIAL, raised
from quintrig.basis.exact_numbers import doubles
from quintrig.basis.functions import Functions
from quintrig.enclosures import intervals
from quintrig.enclosures.ball import Ball
from quintrig.enclosures.boxes import Boxes
from quintrig.enclosures.convex_hull import check_hull
from quintrig.enclosures.search import Range, settle
from quintrig.enclosures.verdicts import Verdict, Witness
from quintrig.geometry.surface import Surface

_OPEN = "some functions of the basis are not seen to be non-negative with sum 1, and no sample is outside"


def prove(surface: Surface, text: str, most: int) -> Verdict:
    """Return whether a surface lies in the hull of its control points; ValueError for one without a net."""
    if surface.net is None:
        raise ValueError("claim 'inside hull': the surface has no control net, so there is no hull to lie in")
    rows: Any = surface.rows
    families = [*getattr(rows.functions, "parts", (rows.functions,)), surface.blend]
    boxes, kept = _kept(families, surface.rational, most)
    if kept:
        return Verdict("proved", text, boxes, notes=("the functions are non-negative and sum to 1",))
    sampled = check_hull(surface)
    if sampled.inside:
        return Verdict("undecided", text, boxes, why=_OPEN)
    u, v = sampled.at
    witness = Witness(u, v, tuple(surface(u, v).tolist()), sampled.distance)
    return Verdict("refuted", text, boxes + sampled.samples, witness, notes=("value: the distance from the hull",))


def _kept(families: Sequence[Functions], rational: bool, most: int) -> tuple[int, bool]:
    """Return how many boxes it took, and whether all functions are non-negative and, unless ``rational``, sum to 1."""
    boxes = 0
    for functions in families:
        for span in functions.exact():
            unit = POLYNOMIAL if span.unit is None else span.unit
            one = raised(np.array([1], dtype=object), len(span.columns) - 1, unit)
            if not rational and (span.columns.sum(axis=1) != one).any():
                return boxes, False
            for column in span.columns.T:
                middle, radius = doubles(column[:, None])
                found = settle(Boxes.whole([Ball(middle, radius)]), intervals.sign, Range(low=0.0), most)
                boxes += found.boxes
                if found.open or found.place:
                    return boxes, False
    return boxes, True
