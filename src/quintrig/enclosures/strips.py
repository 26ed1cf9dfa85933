"""Claims on enveloping developables: K vanishes by construction, and the other curvature is a quotient along u.

With Π = (n, d) the family of planes, Π'' its second derivative and x a point of the ruling, the curvature across the
ruling is |n x n'|² / (|n|³ Π''·x). On a ruling Π''·x runs straight from one boundary to the other, so the radius of
curvature does too, and its ends are those on the boundaries. There x = a / w, (a, w) the meet of Π, Π' and a bounding
plane; the edge of regression is inside where Π''·a / w changes its sign, between the boundaries or along one. The
normal turns over there together with the curvature, so that H keeps its sign and has no bound beside the edge; it is
-τ, which changes where the boundaries cross each other.
"""

from dataclasses import replace

import numpy as np

from quintrig.basis.exact_forms import raised, times
from quintrig.basis.exact_numbers import fractions
from quintrig.basis.rational import NotRationalError
from quintrig.enclosures import intervals
from quintrig.enclosures.ball import Ball
from quintrig.enclosures.boxes import Boxes
from quintrig.enclosures.claims import Claim
from quintrig.enclosures.intervals import Interval
from quintrig.enclosures.measures import Measure, elevation, tilt
from quintrig.enclosures.search import Bounds, Range, enclosed, nothing, settle
from quintrig.enclosures.strip_forms import Boundary, ball
from quintrig.enclosures.strip_state import Strip, beside, region
from quintrig.enclosures.verdicts import Region, Verdict, Witness
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

BY_CONSTRUCTION = "the surface is the envelope of a family of planes: K = 0 by construction, where it is regular"
_STEPS = range(2, 46, 4)  # halvings on the way to an edge of regression


def prove(surface: Surface, claim: Claim, most: int) -> Verdict:
    """Return what comes of a claim on a strip; ValueError for a quantity that has no proof there."""
    if claim.key == "inside hull":
        raise ValueError("claim 'inside hull': a strip of planes has no control points, so there is no hull to lie in")
    if claim.key == "developable" or (claim.sought and claim.key != "gaussian"):
        return Verdict("proved", claim.text, 0, notes=(BY_CONSTRUCTION,))
    if claim.key == "gaussian":
        kept = bool(claim.range.holds(np.zeros(1), np.zeros(1))[0])
        flat = None if kept else Witness(0.5, 0.5, tuple(surface(0.5, 0.5).tolist()), 0.0)
        return Verdict("proved" if kept else "refuted", claim.text, 0, flat, (0.0, 0.0), notes=(BY_CONSTRUCTION,))
    try:
        strip = Strip(surface, most)
    except NotRationalError as error:
        raise ValueError(f"claim {claim.text!r}: the planes of this strip are no exact forms: {error}") from None
    return _compared(strip, claim, claim.measure) if claim.measure else replace(strip.regular, claim=claim.text)


def _compared(strip: Strip, claim: Claim, measure: Measure) -> Verdict:
    enclose = _Curvature(measure, strip, claim.direction)
    boxes, regions = strip.regular.boxes, list[Region]()
    for edge in strip.edges:
        found = settle(Boxes.whole(enclose.forms(edge)), enclose, claim.range, strip.most)
        boxes += found.boxes
        if found.place:
            return Verdict("refuted", claim.text, boxes, strip.found(edge, found))
        regions += [region(edge, box) for box in found.open]
    if not enclose.kept(claim.range):
        place = enclose.witness(claim.range)
        if place:
            return Verdict("refuted", claim.text, boxes, place, why=strip.regular.why)
        regions += strip.regions or [Region((0.0, 1.0), (0.0, 1.0))]
    if regions:
        why = strip.regular.why or "more boxes may settle it"
        return Verdict("undecided", claim.text, boxes, None, None, tuple(regions), why)
    notes = (BY_CONSTRUCTION, strip.regular.why) if strip.regular.why else (BY_CONSTRUCTION,)
    return Verdict("proved", claim.text, boxes, notes=notes)


def bounds(surface: Surface, measure: Measure, tolerance: float, most: int, direction: FloatArray) -> Bounds:
    """Return what encloses the values of a quantity on a strip."""
    if measure.key == "gaussian":
        return Bounds((0.0, 0.0), (0.0, 0.0), 0)
    strip = Strip(surface, most)
    enclose = _Curvature(measure, strip, direction)
    starts = [(Boxes.whole(enclose.forms(edge)), enclose, nothing) for edge in strip.edges]
    found = enclosed(starts, tolerance, most, (True, measure.key != "curvature_radius"))
    return enclose.reaching(found)


class _Curvature:
    """Encloses a quantity by κ² = |n x n'|⁴ w² / (|n|⁶ (Π''·a)²), in forms of one degree, and the sign of κ.

    Slope and draft are of (n·d)² / |n|² and the sign of n·d.
    """

    def __init__(self, measure: Measure, strip: Strip, direction: FloatArray) -> None:
        self._key, self._strip, self._direction = measure.key, strip, fractions(direction)
        self._tilt = measure.degrees
        self._side = strip.way if self._tilt else strip.sense

    @property
    def limit(self) -> float | None:
        """What the quantity comes near to beside an edge of regression inside; None without one, or where none is."""
        if self._strip.bend or self._tilt:
            return None
        ends = {"curvature_radius": 0.0, "curvedness": np.inf, "mean": self._side * np.inf if self._side else np.nan}
        if self._key in ends:
            return ends[self._key]
        upwards = self._key == "k1"
        return None if self._side == (-1.0 if upwards else 1.0) else (np.inf if upwards else -np.inf)

    def kept(self, wanted: Range) -> bool:
        """Return whether all values beside an edge of regression inside are in a range, if those beyond it are."""
        limit = self.limit
        if limit is None:
            return True
        if limit == 0.0:
            return wanted.low <= 0.0
        upwards, downwards = wanted.high == np.inf, wanted.low == -np.inf
        return upwards and downwards if np.isnan(limit) else upwards if limit > 0.0 else downwards

    def reaching(self, found: Bounds) -> Bounds:
        """Return bounds that reach to the limit."""
        limit = self.limit
        if limit is None:
            return found
        if limit == 0.0 or not limit > 0.0:
            found = replace(found, minimum=(0.0 if limit == 0.0 else -np.inf, found.minimum[1]), complete=False)
        return found if limit <= 0.0 else replace(found, maximum=(found.maximum[0], np.inf), complete=False)

    def witness(self, wanted: Range) -> Witness | None:
        """Return a place beside the edge of regression where the quantity is out of a range, for certain."""
        place = self._strip.turning
        if place is None:
            return None
        piece, x, v = place
        for k in _STEPS:
            for step in (2.0**-k, -(2.0**-k)):
                if 0.0 < v + step < 1.0:
                    edge = beside(piece, x, v + step)
                    low, high = self(*Boxes.whole(self.forms(edge)).at(x, 0.0))
                    if wanted.misses(low, high)[0]:
                        return self._strip.witness(piece, x, v + step, 0.5 * float(low[0] + high[0]))
        return None

    def forms(self, edge: Boundary) -> list[Ball]:
        """Return the two squares, and what has the sign of the quantity."""
        if self._tilt:
            way = edge.plane[:, :3].dot(self._direction)
            top, bottom = times(way, way), edge.normal * sum(self._direction * self._direction)
        else:
            top = times(times(edge.turn, edge.turn), times(edge.weight, edge.weight))
            bottom = times(times(edge.normal, times(edge.normal, edge.normal)), times(edge.bend, edge.bend))
            way = np.array([1], dtype=object)
        degree = max(len(top), len(bottom), len(way)) - 1
        if (degree + 1 - len(way)) % 2:
            way = times(way, np.array([1, 1], dtype=object))
        return [ball(raised(form, degree, edge.unit)) for form in (top, bottom, way)]

    def __call__(self, low: FloatArray, high: FloatArray) -> Interval:
        size = intervals.root(*intervals.quotient((low[:, 0], high[:, 0]), (low[:, 1], high[:, 1])))
        below, above = intervals.sign(low, high, 2)
        if self._side < 0.0:
            below, above = -above, -below
        elif not self._side:  # it may be either
            above = np.maximum(-below, above)
            below = -above
        bent = np.where(below >= 0.0, size[0], -size[1]), np.where(above <= 0.0, -size[0], size[1])
        if self._tilt:
            return tilt(*size) if self._key == "slope" else elevation(*bent)
        if self._key == "curvature_radius":
            return intervals.inverse(*size)
        if self._key == "curvedness":
            return intervals.outward(size[0] / np.sqrt(2.0), size[1] / np.sqrt(2.0))
        if self._key == "mean":
            return 0.5 * bent[0], 0.5 * bent[1]
        limit = np.maximum if self._key == "k1" else np.minimum
        return limit(bent[0], 0.0), limit(bent[1], 0.0)
