"""Claims on enveloping developables: K vanishes by construction, and the other curvature is a quotient along u.

With Π = (n, d) the family of planes, Π'' its second derivative and x a point of the ruling, the curvature across the
ruling is |n x n'|² / (|n|³ Π''·x). On a ruling Π''·x runs straight from one boundary to the other, so the radius of
curvature does too, and its ends are those on the boundaries. There x = a / w, (a, w) the meet of Π, Π' and a bounding
plane; the edge of regression is inside where Π''·a / w changes its sign, between the boundaries or along one.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from quintrig.basis.exact_forms import bracket, raised, times
from quintrig.basis.exact_numbers import Exact, doubles, fractions
from quintrig.basis.rational import NotRationalError
from quintrig.enclosures import intervals
from quintrig.enclosures.ball import Ball
from quintrig.enclosures.boxes import Boxes
from quintrig.enclosures.claims import Claim
from quintrig.enclosures.intervals import Interval
from quintrig.enclosures.measures import Measure, elevation, tilt
from quintrig.enclosures.search import Bounds, Range, Search, enclosed, nothing, settle
from quintrig.enclosures.verdicts import Region, Verdict, Witness
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

BY_CONSTRUCTION = "the surface is the envelope of a family of planes: K = 0 by construction, where it is regular"


@dataclass(frozen=True, eq=False)
class Boundary:
    """Forms along u on one boundary of one span: Π, Π''·a, w, |n|² and |n x n'|², and which boundary it is."""

    span: Any
    plane: Exact
    bend: Exact
    weight: Exact
    normal: Exact
    turn: Exact
    v: float
    unit: Exact


def boundaries(surface: Surface) -> list[Boundary]:
    """Return the forms of both boundaries, span by span; NotRationalError for planes that are no exact forms."""
    rows: Any = surface.rows
    planes, bounds = (fractions(array) for array in (rows.planes, rows.bounds))
    result: list[Boundary] = []
    for span in rows.functions.exact():
        family = span.columns.dot(planes)
        slope = bracket(family, span.unit)
        second = bracket(slope, span.unit)
        normal, turn = _dot(family[:, :3], family[:, :3]), _cross(family[:, :3], slope[:, :3])
        for cut, v in zip(bounds, (0.0, 1.0), strict=True):
            meet = _meet(family, slope, cut)
            bend = sum((times(second[:, i], meet[i]) for i in range(4)), np.zeros(1, dtype=object) * 0)
            result.append(Boundary(span, family, bend, meet[3], normal, _dot(turn, turn), v, span.unit))
    return result


def prove(surface: Surface, claim: Claim, most: int) -> Verdict:
    """Return what comes of a claim on a strip; ValueError for a quantity that has no proof there."""
    if claim.key == "inside hull":
        raise ValueError("claim 'inside hull': a strip of planes has no control points, so there is no hull to lie in")
    if claim.key in ("developable", "convex"):
        return Verdict("proved", claim.text, 0, notes=(BY_CONSTRUCTION,))
    if claim.key == "gaussian":
        kept = bool(claim.range.holds(np.zeros(1), np.zeros(1))[0])
        word = "proved" if kept else "refuted"
        witness = None if kept else Witness(0.5, 0.5, tuple(surface(0.5, 0.5).tolist()), 0.0)
        return Verdict(word, claim.text, 0, witness, (0.0, 0.0), notes=(BY_CONSTRUCTION,))
    try:
        edges = boundaries(surface)
    except NotRationalError as error:
        raise ValueError(f"claim {claim.text!r}: the planes of this strip are no exact forms: {error}") from None
    regular = _regular(surface, edges, claim.text, most)
    if not claim.measure or regular.verdict != "proved":
        return regular
    enclose = _Curvature(claim.measure, _side(surface), claim.direction)
    boxes, regions = regular.boxes, list[Region]()
    for edge in edges:
        whole = Boxes.whole(enclose.forms(edge))
        found = settle(whole, enclose, claim.range, most)
        boxes += found.boxes
        if found.place:
            return Verdict("refuted", claim.text, boxes, _witness(surface, edge, found))
        regions += [_region(edge, box) for box in found.open]
    if regions:
        return Verdict("undecided", claim.text, boxes, None, None, tuple(regions), "more boxes may settle it")
    return Verdict("proved", claim.text, boxes, notes=(BY_CONSTRUCTION,))


def bounds(surface: Surface, measure: Measure, tolerance: float, most: int, direction: FloatArray) -> Bounds:
    """Return what encloses the values of a quantity on a strip."""
    if measure.key == "gaussian":
        return Bounds((0.0, 0.0), (0.0, 0.0), 0)
    enclose = _Curvature(measure, _side(surface), direction)
    starts = [(Boxes.whole(enclose.forms(edge)), enclose, nothing) for edge in boundaries(surface)]
    return enclosed(starts, tolerance, most, (True, measure.key != "curvature_radius"))


class _Curvature:
    """Encloses a quantity by κ² = |n x n'|⁴ w² / (|n|⁶ (Π''·a)²), in forms of one degree, and the sign of κ.

    Slope and draft are of (n·d)² / |n|² and the sign of n·d.
    """

    def __init__(self, measure: Measure, side: float, direction: FloatArray) -> None:
        self._key, self._side, self._direction = measure.key, side, fractions(direction)
        self._tilt = measure.degrees

    def forms(self, edge: Boundary) -> list[Ball]:
        """Return the two squares, and what has the sign of the quantity."""
        if self._tilt:
            way = edge.plane[:, :3].dot(self._direction)
            top, bottom = times(way, way), edge.normal * sum(self._direction * self._direction)
        else:
            top = times(times(edge.turn, edge.turn), times(edge.weight, edge.weight))
            bottom = times(times(edge.normal, times(edge.normal, edge.normal)), times(edge.bend, edge.bend))
            way = times(edge.bend, edge.weight)
        degree = max(len(top), len(bottom), len(way)) - 1
        if (degree + 1 - len(way)) % 2:
            way = times(way, np.array([1, 1], dtype=object))
        return [_ball(raised(form, degree, edge.unit)) for form in (top, bottom, way)]

    def __call__(self, low: FloatArray, high: FloatArray) -> Interval:
        size = intervals.root(*intervals.quotient((low[:, 0], high[:, 0]), (low[:, 1], high[:, 1])))
        below, above = intervals.sign(low, high, 2)
        if self._side < 0.0:
            below, above = -above, -below
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


def _side(surface: Surface) -> float:
    """Return whether the surface's normal looks along that of the planes: it does everywhere or nowhere."""
    rows: Any = surface.rows
    partials = surface.local_partials(0.5, 0.5, 1)
    plane = rows.functions.derivatives(0.5, 0)[0] @ rows.planes[:, :3]
    return float(np.sign(np.cross(partials[1, 0], partials[0, 1]) @ plane)) * surface.sign


def _regular(surface: Surface, edges: list[Boundary], text: str, most: int) -> Verdict:
    """Return whether Π''·a w keeps one sign along both boundaries: then no edge of regression is inside."""
    boxes, regions = 0, list[Region]()
    way = 0.0
    for edge in edges:
        form = times(edge.bend, edge.weight)
        form = form[next((i for i, x in enumerate(form) if x), 0) :]  # a family that stands still at u = 0 or 1
        last = next((i for i, x in enumerate(form[::-1]) if x), 0)
        form = form[: len(form) - last]
        middle = float(np.sign(doubles(form[:, None])[0].sum()))
        way = way or middle or 1.0
        wanted = Range(0.0, np.inf, (True, False)) if way > 0.0 else Range(-np.inf, 0.0, (False, True))
        found = settle(Boxes.whole([_ball(form)]), intervals.sign, wanted, most)
        boxes += found.boxes
        if found.place:
            return Verdict(
                "refuted", text, boxes, _witness(surface, edge, found), why="the edge of regression is inside"
            )
        regions += [_region(edge, box) for box in found.open]
    if regions:
        return Verdict("undecided", text, boxes, None, None, tuple(regions), "the edge of regression may be inside")
    return Verdict("proved", text, boxes, notes=("no edge of regression lies in the strip",))


def _witness(surface: Surface, edge: Boundary, found: Search) -> Witness:
    if found.place is None:
        raise RuntimeError("a refutation without a place; please report this with the model")
    u = float(edge.span.parameter(np.array(found.place[0])))
    return Witness(u, edge.v, tuple(surface(u, edge.v).tolist()), 0.5 * (found.low + found.high))


def _region(edge: Boundary, box: tuple[float, float, float, float]) -> Region:
    ends = edge.span.parameter(np.array([box[0], box[2]]))
    return Region((float(ends[0]), float(ends[1])), (edge.v, edge.v))


def _ball(form: Exact) -> Ball:
    return Ball(*doubles(form[:, None]))


def _dot(x: Exact, y: Exact) -> Exact:
    return times(x[:, 0], y[:, 0]) + times(x[:, 1], y[:, 1]) + times(x[:, 2], y[:, 2])


def _cross(x: Exact, y: Exact) -> Exact:
    parts = [times(x[:, i - 2], y[:, i - 1]) - times(x[:, i - 1], y[:, i - 2]) for i in range(3)]
    return np.stack(parts, axis=-1)


def _meet(plane: Exact, slope: Exact, cut: Exact) -> list[Exact]:
    """Return the homogeneous point in which three planes meet: the signed minors of their coordinates."""
    pairs = {
        (i, j): times(plane[:, i], slope[:, j]) - times(plane[:, j], slope[:, i]) for i in range(4) for j in range(4)
    }
    result: list[Exact] = []
    for k in range(4):
        i, j, m = (n for n in range(4) if n != k)
        minor = pairs[i, j] * cut[m] - pairs[i, m] * cut[j] + pairs[j, m] * cut[i]
        result.append(minor if k % 2 else -minor)
    # The point with w = det(n, n', b): n·A = -d, by Cramer.
    return result
