"""What is known of the normal of a strip of planes: whether it turns over inside, and where.

S_u x S_v = -τ (Π''·x) n, and the curvature along n has the sign of Π''·x: so H has that of -τ, on both sides of the
edge of regression, and keeps it unless the boundaries cross each other.
"""

from fractions import Fraction
from functools import cached_property

import numpy as np

from quintrig.basis.exact_numbers import Exact, doubles, fractions
from quintrig.enclosures import intervals
from quintrig.enclosures.boxes import Boxes
from quintrig.enclosures.search import Range, Search, settle
from quintrig.enclosures.strip_forms import Boundary, Piece, ball, pieces, trimmed
from quintrig.enclosures.verdicts import Region, Verdict, Witness
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

_INSIDE, _CROSSED = "the edge of regression is inside", "the boundaries cross each other"
_SAMPLES, _HALVINGS = 257, 60


class Strip:
    """A strip in pieces. NotRationalError where its planes are no exact forms.

    ``sense`` is the sign of H, 0 where it is not known to keep one, and ``way`` that of S_u x S_v along n.
    """

    def __init__(self, surface: Surface, most: int) -> None:
        """Look for sign changes with at most so many boxes a form."""
        self.surface, self.most, self.boxes = surface, most, 0
        self.pieces = list(pieces(surface))
        self.edges = [edge for piece in self.pieces for edge in piece.sides]
        self.regions: list[Region] = []
        self.sense = -self._sign([(piece.across, piece.sides[0]) for piece in self.pieces]) * surface.sign
        self.bend = self._sign([(edge.side, edge) for edge in self.edges])
        self.way = self.sense * self.bend

    @cached_property
    def regular(self) -> Verdict:
        """Whether neither the edge of regression is inside nor the boundaries cross."""
        if self.way:
            return Verdict("proved", "regular", self.boxes, notes=("no edge of regression lies in the strip",))
        why = _CROSSED if self.bend else _INSIDE
        found = self._crossing() if self.bend else self.turning
        if found is None:
            why = why.replace(" is ", " may be ").replace(" cross ", " may cross ")
            return Verdict("undecided", "regular", self.boxes, None, None, tuple(self.regions), why)
        piece, x, v = found
        return Verdict("refuted", "regular", self.boxes, self.witness(piece, x, v, 0.0), why=why)

    def witness(self, piece: Piece, x: float, v: float, value: float) -> Witness:
        """Return a place of a piece with a value there."""
        u = float(piece.span.parameter(np.array(x)))
        return Witness(u, v, tuple(self.surface(u, v).tolist()), value)

    def found(self, edge: Boundary, found: Search) -> Witness:
        """Return the place on a boundary that a search came upon."""
        if found.place is None:
            raise RuntimeError("a refutation without a place; please report this with the model")
        u = float(edge.span.parameter(np.array(found.place[0])))
        return Witness(u, edge.v, tuple(self.surface(u, edge.v).tolist()), 0.5 * (found.low + found.high))

    @cached_property
    def turning(self) -> tuple[Piece, float, float] | None:
        """A piece, x on it, and the v at which the ruling meets the edge of regression; None where none was seen."""
        best: tuple[float, Piece, float, float] | None = None
        for piece in self.pieces:
            x = np.linspace(0.0, 1.0, _SAMPLES)
            with np.errstate(divide="ignore", invalid="ignore"):  # where the family stands still
                first, second = (_values(edge.bend, x) / _values(edge.weight, x) for edge in piece.sides)
            for k in np.flatnonzero(first * second < 0.0):
                v = float(first[k] / (first[k] - second[k]))
                if best is None or abs(v - 0.5) < best[0]:
                    best = abs(v - 0.5), piece, float(x[k]), v
        return best[1:] if best else None

    def _crossing(self) -> tuple[Piece, float, float] | None:
        """The same where the boundaries cross."""
        for piece in self.pieces:
            x = np.linspace(0.0, 1.0, _SAMPLES)
            values = _values(piece.across, x)
            turned = np.flatnonzero(values[:-1] * values[1:] < 0.0)
            if not len(turned):
                continue
            low, high, sign = x[turned[0]], x[turned[0] + 1], values[turned[0]]
            for _ in range(_HALVINGS):
                middle = 0.5 * (low + high)
                alike = _values(piece.across, np.array([middle]))[0] * sign > 0.0
                low, high = (middle, high) if alike else (low, middle)
            return piece, float(low), 0.5
        return None

    def _sign(self, forms: list[tuple[Exact, Boundary]]) -> float:
        """Return the one sign that forms have inside the strip; 0 where they have both, or it is not known."""
        way, known = 0.0, True
        for whole, edge in forms:
            form = trimmed(whole)
            if not len(form):
                return 0.0
            way = way or float(np.sign(_values(form, np.array([0.5]))[0])) or 1.0
            wanted = Range(0.0, np.inf, (True, False)) if way > 0.0 else Range(-np.inf, 0.0, (False, True))
            found = settle(Boxes.whole([ball(form)]), intervals.sign, wanted, self.most)
            self.boxes += found.boxes
            if found.place:
                return 0.0
            self.regions += [region(edge, box) for box in found.open]
            known &= not found.open
        return way if known else 0.0


def beside(piece: Piece, x: float, v: float) -> Boundary:
    """Return the forms of the cut through the ruling at x that meets it at v, by a plane between the bounding ones."""
    near, far = (float(_values(edge.weight, np.array([x]))[0]) for edge in piece.sides)
    share = Fraction(v * near / (v * near + (1.0 - v) * far))
    first, second = fractions(piece.planes)
    return piece.cut((1 - share) * first + share * second, v)


def region(edge: Boundary, box: tuple[float, float, float, float]) -> Region:
    """Return a stretch of a boundary that is left open."""
    ends = edge.span.parameter(np.array([box[0], box[2]]))
    return Region((float(ends[0]), float(ends[1])), (edge.v, edge.v))


def _values(form: Exact, x: FloatArray) -> FloatArray:
    """Return a form at x, up to a positive factor, rounded."""
    n = len(form) - 1
    middle, _ = doubles(form[:, None])
    k = np.arange(n + 1.0)
    return ((1.0 - x[:, None]) ** (n - k) * x[:, None] ** k) @ middle[:, 0]
