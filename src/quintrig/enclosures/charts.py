"""A surface in charts: rectangles of (u, v) over which it is one pair of forms, with exact coefficients.

The surface meant is the one in memory: its control points, or the increments that its construction gives, are the
doubles that they are, and its functions are those of the formulas, to the last digit. B-spline faces have a chart for
each pair of spans, a full turn one for each right angle.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from quintrig.basis.exact_forms import POLYNOMIAL, Span, bracket, raised
from quintrig.basis.exact_numbers import Exact, fractions
from quintrig.basis.functions import Functions
from quintrig.geometry.surface import Net, Surface
from quintrig.support.arrays import FloatArray

_ROUNDED = 2.0**-48
"""Of the largest coordinate: control points no farther apart than this differ by rounding alone."""

Edge = tuple[int, int]
"""The axis of the parameter that is constant along an edge, and at which end: 0 or -1."""


@dataclass(frozen=True, eq=False)
class Direction:
    """What a chart has along u or v: its ``span``, the forms (degree + 1, a) that the net is blended by, and σ."""

    span: Span
    forms: Exact
    unit: Exact

    @cached_property
    def slopes(self) -> Exact:
        """The derivatives of the forms."""
        return bracket(self.forms, self.unit)


@dataclass(frozen=True, eq=False)
class Chart:
    """S over u.span x v.span: ``scale`` Σ u.forms_i net_ij v.forms_j, points (3) or homogeneous ones (4).

    Points are as seen from the surface's origin; ``scale`` is a power of 2, length¹, by which the net is about 1.
    """

    u: Direction
    v: Direction
    net: Exact
    scale: Fraction

    @property
    def rational(self) -> bool:
        """Whether the last coordinate is a weight."""
        return self.net.shape[2] == 4

    def parameters(self, x: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return u, v at the chart's own parameters, each from 0 to 1, rounded."""
        return self.u.span.parameter(x), self.v.span.parameter(y)

    def places(self, u: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the chart's own parameters at u, v, rounded; beyond 0 and 1 where these lie beyond the chart."""
        return self.u.span.place(u), self.v.span.place(v)


def charts(surface: Surface) -> Iterator[Chart]:
    """Yield the charts of a surface; NotRationalError where its rows or functions are no exact forms."""
    rows: Any = surface.rows
    if not isinstance(rows, Net):
        rows = rows.homogeneous  # of a strip
    if rows.dimension == 4:
        net = _homogeneous(surface, rows, rounded_edges(surface))
    elif rows.steps is not None:
        net = fractions(rows.steps)
    else:
        points = _as_one(fractions(rows.points), rounded_edges(surface))
        net = _split(_split(points, rows.functions).transpose(1, 0, 2), surface.blend)
        net = net.transpose(1, 0, 2)
    whole = rows.dimension == 4
    along = [_direction(span, rows.functions, whole) for span in rows.functions.exact()]
    across = [_direction(span, surface.blend, whole) for span in surface.blend.exact()]
    scale = _scale(net)
    net = net.copy()
    net[..., :3] = net[..., :3] / scale
    for u, used_u in along:
        for v, used_v in across:
            yield Chart(u, v, net[used_u][:, used_v], scale)


def _scale(net: Exact) -> Fraction:
    """Return a power of 2 near the largest coordinate of a net, its origin aside."""
    largest = max((abs(value) for value in net[..., :3].reshape(-1, 3)[1:].flat), default=Fraction(0))
    if not largest:
        return Fraction(1)
    return Fraction(2) ** (largest.numerator.bit_length() - largest.denominator.bit_length())


def rounded_edges(surface: Surface) -> tuple[Edge, ...]:
    """Return the edges, (0, 0), (0, -1), (1, 0), (1, -1), whose control points differ, but by rounding alone.

    So CAD programs write poles: cos 90° is 6e-17 to them.
    """
    net, found = surface.net, list[Edge]()
    if net is None or not isinstance(surface.rows, Net) or surface.rows.steps is not None:
        return ()
    least = _ROUNDED * float(np.abs(net).max(initial=0.0))
    for axis in (0, 1):
        for end in (0, -1):
            edge = np.take(net, end, axis)
            off = float(np.abs(edge - edge[0]).max(initial=0.0))
            if 0.0 < off <= least:
                found.append((axis, end))
    return tuple(found)


def _as_one(points: Exact, edges: tuple[Edge, ...]) -> Exact:
    """Return points with all of some edges made the first of each."""
    points = points.copy()
    for axis, end in edges:
        edge = (end, slice(None)) if axis == 0 else (slice(None), end)
        points[edge] = points[edge][0]
    return points


def _homogeneous(surface: Surface, rows: Net, edges: tuple[Edge, ...]) -> Exact:
    """Return homogeneous points; where points and weights are known, not rounded, so that poles stay poles."""
    points = fractions(rows.points)
    if surface.net is not None and surface.net.shape[:2] == points.shape[:2]:
        near = _as_one(fractions(surface.net) - fractions(surface.origin), edges)
        points = np.concatenate([near * points[..., 3:], points[..., 3:]], axis=-1)
    return points


def _split(points: Exact, functions: Functions) -> Exact:
    """Return origin and increments, as ``Functions.split``, without rounding."""
    parts = getattr(functions, "parts", None)
    if parts:
        ends = np.cumsum([part.size for part in parts])[:-1]
        pieces = [_split(p, part) for p, part in zip(np.split(points, ends), parts, strict=True)]
        return np.concatenate([sum(piece[:1] for piece in pieces), *(piece[1:] for piece in pieces)])
    if functions.partition:
        return np.concatenate([points[:1], points[1:] - points[:-1]])
    return np.concatenate([0 * points[:1], points])


def _direction(span: Span, functions: Functions, whole: bool) -> tuple[Direction, list[int]]:
    """Return the forms of 1 and the increments of a span, or with ``whole`` its functions, and which are not 0."""
    unit = POLYNOMIAL if span.unit is None else span.unit
    columns = span.columns if whole else _increments(span.columns, functions)
    one = span.raised(len(columns) - 1, unit).sum(axis=1) if functions.partition else _one(len(columns) - 1, unit)
    forms = columns if whole else np.concatenate([one[:, None], columns], axis=1)
    # A constant increment moves nothing; without its column the others' coefficients stay exact zeros.
    used = [i for i in range(forms.shape[1]) if forms[:, i].any()]
    return Direction(span, forms[:, used], unit), used


def _increments(columns: Exact, functions: Functions) -> Exact:
    parts = getattr(functions, "parts", None)
    if parts:
        ends = np.cumsum([part.size for part in parts])[:-1]
        pieces = np.split(columns, ends, axis=1)
        return np.concatenate([_increments(p, part) for p, part in zip(pieces, parts, strict=True)], axis=1)
    return np.cumsum(columns[:, :0:-1], axis=1)[:, ::-1] if functions.partition else columns


def _one(degree: int, unit: Exact) -> Exact:
    """Return σ to half the degree, which stands for 1."""
    return raised(np.array([1], dtype=object), degree, unit)
