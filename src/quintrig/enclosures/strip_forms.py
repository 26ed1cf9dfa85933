"""Forms along the rulings of a strip of planes: where a plane cuts them, and where the boundaries cross each other.

With Π = (n, d) the family of planes and x a point of the ruling, n'·S_u = -Π''·x and S_v = τ n x n', so that
S_u x S_v = -τ (Π''·x) n: it vanishes on the edge of regression, and where both planes cut a ruling in one point.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from quintrig.basis.exact_forms import bracket, times
from quintrig.basis.exact_numbers import Exact, doubles, fractions
from quintrig.enclosures.ball import Ball
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray


@dataclass(frozen=True, eq=False)
class Boundary:
    """Forms along u where a plane cuts the rulings: Π, Π''·a, w, |n|² and |n x n'|², and at which ``v`` that is."""

    span: Any
    plane: Exact
    bend: Exact
    weight: Exact
    normal: Exact
    turn: Exact
    v: float
    unit: Exact

    @property
    def side(self) -> Exact:
        """What has the sign of Π''·x."""
        return times(self.bend, self.weight)


@dataclass(frozen=True, eq=False)
class Piece:
    """A strip over one span: both boundaries, and ``across``, which has the sign of τ."""

    surface: Surface
    span: Any
    sides: tuple[Boundary, Boundary]
    across: Exact

    @property
    def planes(self) -> FloatArray:
        """The bounding planes (2, 4)."""
        rows: Any = self.surface.rows
        return rows.bounds

    def cut(self, plane: Exact, v: float) -> Boundary:
        """Return the forms where another plane cuts the rulings."""
        return _boundary(self.surface, self.span, plane, v)


def pieces(surface: Surface) -> Iterator[Piece]:
    """Yield the spans of a strip; NotRationalError for planes that are no exact forms."""
    rows: Any = surface.rows
    first, second = fractions(rows.bounds)
    for span in rows.functions.exact():
        sides = _boundary(surface, span, first, 0.0), _boundary(surface, span, second, 1.0)
        family = sides[0].plane
        slope = bracket(family, span.unit)
        meet = _meet(family, slope, first)
        off = second[0] * meet[0] + second[1] * meet[1] + second[2] * meet[2] + second[3] * meet[3]
        # τ = -(off / w) / ŵ: so far is the first boundary from the second plane, and ŵ = (n x n')·n̂ the way there.
        yield Piece(surface, span, sides, -times(off, times(sides[0].weight, sides[1].weight)))


def _boundary(surface: Surface, span: Any, cut: Exact, v: float) -> Boundary:
    rows: Any = surface.rows
    family = span.columns.dot(fractions(rows.planes))
    slope = bracket(family, span.unit)
    second = bracket(slope, span.unit)
    normal, turn = _dot(family[:, :3], family[:, :3]), _cross(family[:, :3], slope[:, :3])
    meet = _meet(family, slope, cut)
    bend = sum((times(second[:, i], meet[i]) for i in range(4)), np.zeros(1, dtype=object) * 0)
    return Boundary(span, family, bend, meet[3], normal, _dot(turn, turn), v, span.unit)


def trimmed(form: Exact) -> Exact:
    """Return a form without the powers of u and 1 - u that divide it: the family may stand still at its ends."""
    form = form[next((i for i, x in enumerate(form) if x), 0) :]
    return form[: len(form) - next((i for i, x in enumerate(form[::-1]) if x), 0)]


def ball(form: Exact) -> Ball:
    """Return a form along u in doubles."""
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
