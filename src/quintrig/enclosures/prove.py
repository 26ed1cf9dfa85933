"""Claims on a surface, decided: forms of each chart, in doubles with bounds first, exactly where these do not tell."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from quintrig.basis.rational import NotRationalError
from quintrig.enclosures import hulls, strips
from quintrig.enclosures.ball import Ball
from quintrig.enclosures.boxes import Boxes, Enclose
from quintrig.enclosures.charts import Chart, charts
from quintrig.enclosures.claims import Claim, read
from quintrig.enclosures.faces import outside
from quintrig.enclosures.folds import turning
from quintrig.enclosures.measures import MEASURES, REGULAR, UPRIGHT, Measure, Problem, gauss_sign, saddle_sign
from quintrig.enclosures.poles import apex
from quintrig.enclosures.search import Bounds, Range, Search, enclosed, settle
from quintrig.enclosures.shape import Shape
from quintrig.enclosures.verdicts import Region, Verdict, Witness
from quintrig.enclosures.whole import InexactError, Whole
from quintrig.geometry.envelope import Envelope
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

MOST = 1024
"""Most boxes of one claim on one chart."""

_FOR_BOUNDS = 256

_ZERO, _SADDLE = Range(0.0, 0.0), Range(high=0.0)
_TOO_FLAT = "these boxes hold neither a proof nor a place where the claim fails; more boxes may settle it"
_BARE = "the surface has no normal anywhere: it is a curve or a point"
_TOUCHES = "the quantity comes too near to the bound there to be told from it"


class NoProofError(ValueError):
    """A surface that has no proof: its functions are neither polynomials nor forms of one angle."""


@dataclass(frozen=True, eq=False)
class Prover:
    """Proofs about one surface, with ``most`` boxes a claim and chart; forms are kept from claim to claim."""

    surface: Surface
    unit: str = ""
    most: int = MOST

    def __post_init__(self) -> None:
        """Split the surface into charts once; NoProofError where it has none."""
        _ = self._each

    @cached_property
    def _each(self) -> list[tuple[Chart, Shape, Shape]]:
        if isinstance(self.surface.rows, Envelope):
            return []
        try:
            found = list(charts(self.surface))
        except (NotRationalError, AttributeError) as error:
            raise NoProofError(f"no proof for this surface, whose curvature can only be sampled: {error}") from None
        return [(chart, Shape(chart, Ball), Shape(chart, Whole)) for chart in found]

    def prove(self, text: str | Claim, bounds: bool = False) -> Verdict:
        """Return what comes of a claim; with ``bounds`` also what encloses the quantity's values. ValueError."""
        claim = read(text, self.unit) if isinstance(text, str) else text
        if isinstance(self.surface.rows, Envelope):
            verdict = strips.prove(self.surface, claim, self.most)
            return replace(self._with_bounds(verdict, claim, bounds), unit=self.named_unit(claim.measure))
        ways: dict[str, Callable[[Claim], Verdict]] = {
            "regular": self._regular,
            "no fold": self._regular,
            "convex": self._convex,
            "developable": self._developable,
            "inside hull": self._inside_hull,
        }
        verdict = self._bare(claim)
        if verdict is None:
            verdict = ways[claim.word](claim) if claim.word else self._compared(claim, bounds)
        return replace(verdict, unit=self.named_unit(claim.measure)) if claim.measure else verdict

    def _bare(self, claim: Claim) -> Verdict | None:
        """Return that a claim on curvature is open where the surface has no normal anywhere; None elsewhere."""
        if claim.word in ("regular", "no fold", "inside hull") or not any(
            part.area.vanishes for _, part, _ in self._each
        ):
            return None
        return Verdict("undecided", claim.text, 0, None, None, (Region((0.0, 1.0), (0.0, 1.0)),), _BARE)

    def bounds(
        self, key: str, tolerance: float = 1e-3, direction: FloatArray = UPRIGHT, most: int | None = None
    ) -> Bounds:
        """Return what encloses the least and the greatest value of a quantity, to ``tolerance`` times the larger.

        Of a radius of curvature, which may be infinite, the least alone is sought.
        """
        measure, most = MEASURES[key], most or self.most
        if isinstance(self.surface.rows, Envelope):
            found = strips.bounds(self.surface, measure, tolerance, most, direction)
        else:
            starts = [
                (*self._start(measure.problem, shape, direction), outside(self.surface, chart))
                for chart, shape in self.shapes(False)
            ]
            found = enclosed(starts, tolerance, most * len(starts), (True, key != "curvature_radius"))
        return replace(found, unit=self.named_unit(measure))

    def shapes(self, sign_only: bool) -> Iterator[tuple[Chart, Shape]]:
        """Yield the forms of each chart: exact ones where a factor on an edge may be common to a quotient."""
        for chart, balls, wholes in self._each:
            shape = balls
            if not sign_only and any(balls.both) and balls.hidden:
                try:
                    shape = wholes if wholes.gauss else balls
                except InexactError:
                    shape = balls
            yield chart, shape

    def _start(self, problem: Callable[..., Problem], shape: Shape, direction: FloatArray) -> tuple[Boxes, Enclose]:
        forms, enclose = problem(shape, self.surface.sign, direction)
        return Boxes.whole([form.ball() for form in forms]), enclose

    def named_unit(self, measure: Measure | None) -> str:
        """Return the unit of a quantity in text."""
        if measure is None or measure.degrees:
            return "deg" if measure else ""
        return {1: "{}", -1: "1/{}", -2: "1/{}²"}[measure.power].format(self.unit) if self.unit else ""

    def _compared(self, claim: Claim, bounds: bool) -> Verdict:
        measure = claim.measure
        if measure is None:
            raise RuntimeError(f"{claim.text}: a comparison without a quantity; please report this")
        verdict = Verdict("proved", claim.text, 0)
        if not claim.sought:
            verdict = self._settled(claim, *asked(claim, measure), claim.range)
        verdict = self._with_bounds(verdict, claim, bounds)
        return replace(verdict, notes=(*verdict.notes, *self._edge_notes()))

    def _with_bounds(self, verdict: Verdict, claim: Claim, bounds: bool) -> Verdict:
        """Return a verdict with what encloses the quantity's values, where that is asked for."""
        if claim.measure is None or verdict.bounds or not (bounds or claim.sought):
            return verdict
        found = self.bounds(claim.measure.key, direction=claim.direction, most=min(self.most, _FOR_BOUNDS))
        boxes = verdict.boxes + (found.boxes if claim.sought else 0)
        notes = verdict.notes if found.complete else (*verdict.notes, "the bounds hold, but are not tight to 1e-3")
        return replace(verdict, bounds=(found.minimum[0], found.maximum[1]), boxes=boxes, notes=notes)

    def _settled(self, claim: Claim, problem: Callable[..., Problem], sign_only: bool, wanted: Range) -> Verdict:
        """Return what comes of a quantity being in a range on every chart."""
        boxes, regions = 0, list[Region]()
        for index, (chart, shape) in enumerate(self.shapes(sign_only)):
            found = Search()
            ways = [(shape, False), (self._each[index][2], False), (self._each[index][2], True)]
            for arithmetic, split in ways:
                try:
                    found = self._searched(chart, arithmetic, split, problem, claim, wanted)
                except InexactError:
                    continue
                boxes += found.boxes
                if found.place or not found.touching:  # exactness does not help where boxes ran out
                    break
            if found.place:
                witness = self._witness(chart, found, claim, self._each[index][1:])
                return Verdict("refuted", claim.text, boxes, witness)
            regions += _regions(chart, found)
        if regions:
            narrow = all(max(r.u[1] - r.u[0], r.v[1] - r.v[0]) < 1e-6 for r in regions)
            why = _TOUCHES if narrow else _TOO_FLAT
            return Verdict("undecided", claim.text, boxes, None, None, tuple(regions), why)
        return Verdict("proved", claim.text, boxes)

    def _searched(
        self,
        chart: Chart,
        shape: Shape,
        split: bool,
        problem: Callable[..., Problem],
        claim: Claim,
        wanted: Range,
    ) -> Search:
        """Return what comes of one chart; with ``split`` it is cut into quarters before its forms are rounded."""
        if problem is gauss_sign and wanted == _SADDLE and self._saddle(shape):
            return Search(1)
        forms, enclose = problem(shape, self.surface.sign, claim.direction)
        away = outside(self.surface, chart)
        if not split:
            return settle(Boxes.whole([f.ball() for f in forms]), enclose, wanted, self.most, away, shape.both)
        result = Search()
        for i, j in ((0, 0), (0, 1), (1, 0), (1, 1)):
            parts = [form.halves(0)[i].halves(1)[j].ball() for form in forms]
            part = Boxes.whole(parts, (0.5 * i, 0.5 * j), 0.5)
            found = settle(part, enclose, wanted, self.most, away, shape.both)
            result.boxes += found.boxes
            if found.place:
                found.boxes = result.boxes
                return found
            result.open += found.open
            result.touching |= found.touching
        return result

    def _saddle(self, shape: Shape) -> bool:
        """Return whether K <= 0 because λν <= 0, as on ruled surfaces, where P is minus a square."""
        whole, enclose = self._start(saddle_sign, shape, UPRIGHT)
        found = settle(whole, enclose, _SADDLE, 1)
        return not found.place and not found.open

    def _witness(self, chart: Chart, found: Search, claim: Claim, shapes: tuple[Shape, Shape] | None = None) -> Witness:
        """Return the place with the quantity's value there, which the sign of a form alone does not give."""
        if found.place is None:
            raise RuntimeError("a refutation without a place; please report this with the model")
        u, v = (float(part) for part in chart.parameters(*(np.array(part) for part in found.place)))
        low, high = found.low, found.high
        if shapes and claim.measure:
            for shape in shapes:
                try:
                    whole, enclose = self._start(claim.measure.problem, shape, claim.direction)
                except InexactError:
                    continue
                low, high = (float(end[0]) for end in enclose(*whole.at(*found.place)))
                if np.isfinite([low, high]).all():
                    break
        return Witness(u, v, tuple(self.surface(u, v).tolist()), 0.5 * (low + high))

    def _regular(self, claim: Claim) -> Verdict:
        verdict = self._settled(claim, REGULAR.problem, True, Range(0.0, np.inf, (True, False)))
        if verdict.verdict == "proved" and claim.word == "regular":
            for chart, balls, wholes in self._each:
                if any(balls.collapsing):
                    place = apex(chart, wholes)
                    if place:
                        witness = self._witness(chart, Search(place=place, low=0.0, high=0.0), claim)
                        return replace(verdict, verdict="refuted", witness=witness)
        elif verdict.verdict == "undecided":
            return self._folded(verdict)
        return replace(verdict, notes=self._edge_notes())

    def _folded(self, verdict: Verdict) -> Verdict:
        """Return what was left open, refuted where the normal is seen to turn over."""
        for chart, _, wholes in self._each:
            try:
                place = turning([part for part in wholes.normal if isinstance(part, Whole)])
            except InexactError:
                continue
            if place:
                u, v = (float(part) for part in chart.parameters(*(np.array(part) for part in place)))
                if self.surface.inside(u, v):
                    witness = Witness(u, v, tuple(self.surface(u, v).tolist()), 0.0)
                    return Verdict("refuted", verdict.claim, verdict.boxes, witness, why="the normal turns over there")
        return verdict

    def _convex(self, claim: Claim) -> Verdict:
        first = self.prove("gaussian >= 0")
        if first.verdict != "proved":
            return replace(first, claim=claim.text, why=first.why or "K < 0 there")
        ways = [self.prove(f"mean {sign} 0") for sign in (">=", "<=")]
        boxes = first.boxes + sum(one.boxes for one in ways)
        best = [one for one in ways if one.proved] + [one for one in ways if one.regions]
        why = best[0].why if best else "H < 0 there, and > 0 elsewhere: the surface bends to both sides"
        return replace([*best, *ways][0], claim=claim.text, boxes=boxes, why=why)

    def _developable(self, claim: Claim) -> Verdict:
        gauss = MEASURES["gaussian"]
        verdict = self._settled(replace(claim, measure=gauss), gauss_sign, True, _ZERO)
        if verdict.proved:
            notes = ("K vanishes as a polynomial, coefficient by coefficient", *self._edge_notes())
            return replace(verdict, notes=notes)
        why = verdict.why or "K is not 0 there"
        return replace(verdict, unit=self.named_unit(gauss), why=why, notes=self._edge_notes())

    def _inside_hull(self, claim: Claim) -> Verdict:
        return hulls.prove(self.surface, claim.text, self.most)

    def _edge_notes(self) -> tuple[str, ...]:
        """Return what to know of edges along which a tangent vanishes."""
        told: dict[str, None] = {}
        for chart, balls, _ in self._each:
            for edges, name in zip(balls.factors, ("S_u", "S_v"), strict=True):
                for power, edge in zip(edges, _edges(chart), strict=True):
                    if power:
                        told[
                            f"{name} vanishes along {edge}: its factor is divided out, and the proof is of the rest; "
                            "on the edge the normal is the limit, and curvature may be without bound beside it"
                        ] = None
        return tuple(told)


def asked(claim: Claim, measure: Measure) -> tuple[Callable[..., Problem], bool]:
    """Return what a comparison is decided by, and whether that is the sign alone, as of bounds that are 0."""
    if measure.sign_only and {claim.range.low, claim.range.high} <= {0.0, np.inf, -np.inf}:
        return measure.sign_only, True
    return measure.problem, False


def _edges(chart: Chart) -> tuple[str, str, str, str]:
    ends = (("u", chart.u.span.start), ("u", chart.u.span.end), ("v", chart.v.span.start), ("v", chart.v.span.end))
    a, b, c, d = (f"{name} = {value:g}" for name, value in ends)
    return a, b, c, d


def _regions(chart: Chart, found: Search) -> list[Region]:
    low = np.array([box[:2] for box in found.open]).reshape(-1, 2)
    high = np.array([box[2:] for box in found.open]).reshape(-1, 2)
    u0, v0 = chart.parameters(low[:, 0], low[:, 1])
    u1, v1 = chart.parameters(high[:, 0], high[:, 1])
    return [Region((a, b), (c, d)) for a, b, c, d in zip(*(part.tolist() for part in (u0, u1, v0, v1)), strict=True)]
