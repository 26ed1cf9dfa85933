"""Umbilics as common zeros of forms: whether those known are alone, and whether there are others.

With the X, Y, λ, μ, ρ and ν of ``shape``, E M - F L = f² A and E N - G L = f g B, where A = f (X·X) μ - g (X·Y) λ and
B = f (X·X) ν - g (Y·Y) λ. Where S_u does not vanish, both are 0 at umbilics and nowhere else; where S_v does not, the
same is true of B and C, F N - G M = g² C. Of each, the factor of an edge where S_u or S_v vanishes is divided out. At a
pole f g is a factor of all, and there are more in common if and only if it is an umbilic. Of other such edges nothing
is said.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from quintrig.basis.rational import NotRationalError
from quintrig.enclosures.ball import Ball, Edges
from quintrig.enclosures.boxes import Boxes
from quintrig.enclosures.charts import Chart, charts
from quintrig.enclosures.faces import outside
from quintrig.enclosures.measures import MEASURES, UPRIGHT, equal
from quintrig.enclosures.shape import Form, Shape, dot, shared
from quintrig.enclosures.strips import bounds
from quintrig.enclosures.turns import Part, turn
from quintrig.enclosures.whole import InexactError, Whole
from quintrig.enclosures.zeros import Rectangle, alone_in, searched
from quintrig.geometry.envelope import Envelope
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import BoolArray, FloatArray

MOST = 2048
"""Most boxes on one chart."""

_LEVEL = 1e-10
"""Of the sizes of its factors: a pair of forms that is rounding everywhere, as on a sphere with rounded weights."""

Side = tuple[int, float]
"""A side of the domain: its axis, and where on it."""

_CLOSED = 1e-9  # of the size: two sides this near are one
_LINKED = 2e-3  # of the domain: umbilics that are not alone and this near are looked at together
_GROUPS = 12  # of these, at most
_WIDTHS = (4, 6, 8, 10, 12)  # half the width of a box around them is 2^-k
_RIM = 1e-6  # of the domain: on the edge


@dataclass(frozen=True, eq=False)
class Group:
    """The numbers of umbilics known that a box [low, high] (2,) in u, v holds, and the index of all that it holds."""

    members: tuple[int, ...]
    low: FloatArray
    high: FloatArray
    index: float


@dataclass(frozen=True, eq=False)
class Umbilical:
    """Which of the umbilics known are ``alone`` (k,), what is left ``open``, (u, v, u, v) (m, 4), and ``poles``.

    ``groups`` are boxes around the others, whose index in all is known, though not how many each holds. ``all`` where
    every point is one, to rounding; ``poles`` are the sides (axis, end) that are one point, an umbilic; of the sides
    ``untold``, along which a tangent vanishes, nothing is said.
    """

    alone: BoolArray
    open: FloatArray
    groups: tuple[Group, ...]
    poles: frozenset[Side]
    untold: frozenset[Side]
    all: bool
    boxes: int


def prove(surface: Surface, known: FloatArray, most: int = MOST) -> Umbilical | None:
    """Return what is certain of umbilics, with those ``known`` (k, 2) in u, v; None for a surface without forms."""
    alone = np.zeros(len(known), dtype=np.bool_)
    if isinstance(surface.rows, Envelope):
        return _of_envelope(surface, alone, most)
    try:
        each = list(charts(surface))
    except (NotRationalError, AttributeError):
        return None
    left: list[FloatArray] = []
    poles, untold = set[Side](), set[Side]()
    level, boxes = 0, 0
    turns = _turns(surface)
    looked: list[tuple[Chart, Boxes, list[Rectangle]]] = []
    for chart in each:
        forms, flat, still = _parted(chart)
        poles |= flat
        untold |= still
        if _rounding(chart, forms):
            level += 1
            left.append(_parameters(chart, [(0.0, 0.0, 1.0, 1.0)]))
            continue
        whole = Boxes.whole([part.ball() for part in forms])
        places = np.concatenate([np.stack(chart.places(*(known + shift).T), axis=-1) for shift in turns])
        here, around = alone_in(whole, places)
        alone |= here.reshape(len(turns), -1).any(axis=0)
        looked.append((chart, whole, around))
    parts = [part for chart, whole, _ in looked for part in _extended(chart, whole, turns, poles | untold)]
    groups = grouped(parts, known, alone)
    for chart, whole, around in looked:
        for group in groups:
            for shift in turns:
                low, high = (np.array(chart.places(*(end + shift))) for end in (group.low, group.high))
                around.append((*low.tolist(), *high.tolist()))
        found = searched(whole, alone, around, most, outside(surface, chart))
        boxes += found.boxes
        left.append(_parameters(chart, found.open))
    sides = frozenset(poles), frozenset(untold)
    return Umbilical(alone, np.concatenate(left), tuple(groups), *sides, level == len(each), boxes)


def _parameters(chart: Chart, rectangles: list[Rectangle]) -> FloatArray:
    """Return rectangles of a chart in u, v, (n, 4)."""
    low, high = np.split(np.array(rectangles).reshape(-1, 4), 2, axis=1)
    return np.stack([*chart.parameters(*low.T), *chart.parameters(*high.T)], axis=-1)


def _extended(chart: Chart, whole: Boxes, turns: list[FloatArray], bare: set[Side]) -> Iterator[Part]:
    """Yield the part that a chart is, and seen from behind the seam; beyond free edges it is continued."""
    spans = (chart.u.span, chart.v.span)
    low, high = (np.array([float(getattr(span, end)) for span in spans]) for end in ("start", "end"))
    closed = [any(shift[axis] for shift in turns) for axis in (0, 1)]
    for axis in (0, 1):
        if low[axis] == 0.0 and not closed[axis] and (axis, 0.0) not in bare:
            low[axis] = -1.0
        if high[axis] == 1.0 and not closed[axis] and (axis, 1.0) not in bare:
            high[axis] = 2.0
    for shift in turns:

        def place(uv: FloatArray, shift: FloatArray = shift) -> FloatArray:
            return np.array(chart.places(*(uv + shift)))

        yield Part(whole, low - shift, high - shift, place)


def grouped(parts: Sequence[Part], known: FloatArray, alone: BoolArray) -> list[Group]:
    """Return boxes around the umbilics that are not alone, as large as those that are let them be.

    Others that are not alone are in one only where there is no box without them.
    """
    found: list[Group] = []
    taken = alone.copy()
    for members in clusters(known, np.flatnonzero(~alone))[:_GROUPS]:
        if taken[members].any():
            continue
        for strangers, k in product((False, True), _WIDTHS):
            low, high = _around(known[members], 2.0**-k)
            inside = ((known >= low) & (known <= high)).all(axis=1)
            if (inside & taken).any() or (not strangers and inside.sum() > len(members)):
                continue
            turned = turn(parts, low, high)
            if turned is not None:
                found.append(Group(tuple(np.flatnonzero(inside).tolist()), low, high, 0.5 * turned))
                taken |= inside
                break
    return found


def _around(places: FloatArray, width: float) -> tuple[FloatArray, FloatArray]:
    """Return a box around places (k, 2), ``width`` wider at each side; over an edge only where they are on it."""
    low, high = places.min(axis=0), places.max(axis=0)
    below, above = (np.where(gap > _RIM, np.minimum(width, 0.5 * gap), width) for gap in (low, 1.0 - high))
    return low - below, high + above


def clusters(known: FloatArray, some: NDArray[np.intp]) -> list[NDArray[np.intp]]:
    """Return the numbers of umbilics in clusters, each nearer than _LINKED to another one of its own."""
    left, found = some.tolist(), list[NDArray[np.intp]]()
    while left:
        cluster = [left.pop(0)]
        for one in cluster:
            near = [k for k in left if np.abs(known[k] - known[one]).max() <= _LINKED]
            cluster += near
            left = [k for k in left if k not in near]
        found.append(np.array(sorted(cluster)))
    return found


def _turns(surface: Surface) -> list[FloatArray]:
    """Return what may be added to u, v of an umbilic on a surface that is closed in u or v, to see it from behind."""
    t, end = np.linspace(0.0, 1.0, 17), np.ones(17)
    pairs = (surface(0.0 * end, t) - surface(end, t), surface(t, 0.0 * end) - surface(t, end))
    reach = [(0, -1, 1) if np.abs(gap).max() <= _CLOSED * surface.size else (0,) for gap in pairs]
    return [np.array([i, j], dtype=np.float64) for i in reach[0] for j in reach[1]]


def _of_envelope(surface: Surface, alone: BoolArray, most: int) -> Umbilical:
    """Return the same of a strip of planes: K = 0, so that an umbilic is where H = 0."""
    found = bounds(surface, MEASURES["mean"], 1e-3, most, UPRIGHT)
    free = found.minimum[0] > 0.0 or found.maximum[1] < 0.0
    flat = found.minimum[0] == found.maximum[1] == 0.0
    left = np.zeros((0, 4)) if free or flat else np.array([[0.0, 0.0, 1.0, 1.0]])
    return Umbilical(alone, left, (), frozenset(), frozenset(), flat, found.boxes)


def _parted(chart: Chart) -> tuple[list[Form], set[Side], set[Side]]:
    """Return A, B and C without factors of edges, the sides that are one point, an umbilic, and those not spoken of."""
    shape = Shape(chart, Ball)
    ends = (chart.u.span.start, chart.u.span.end, chart.v.span.start, chart.v.span.end)
    sides = [(index // 2, end) for index, end in enumerate(ends)]
    still = {side for side, power, one in zip(sides, shape.both, shape.collapsing, strict=True) if power and not one}
    if not any(shape.both):
        return equal(shape, _forms(shape)), set(), set()
    whole, poles = Shape(chart, Whole), set[Side]()
    try:
        forms = _forms(whole)
    except InexactError:
        return equal(shape, _forms(shape)), set(), set(sides)
    for side, power, one, more in zip(sides, whole.both, whole.collapsing, shared(forms), strict=True):
        if one and more > power:
            poles.add(side)
    forms = [part if part.vanishes else part.divided(_where(part.edges(), whole.both)) for part in forms]
    return equal(whole, forms), poles, still


def _where(edges: Edges, both: Edges) -> Edges:
    """Return the powers by which an edge divides a form, of those edges alone where a tangent vanishes."""
    a, b, c, d = (power if there else 0 for power, there in zip(edges, both, strict=True))
    return a, b, c, d


def _forms(shape: Shape) -> list[Form]:
    """Return A and B, and C where S_u or S_v vanishes on an edge."""
    lam, mu, rho, nu = shape.second_form
    f, g = shape.factors
    e, middle, last = dot(shape.x, shape.x), dot(shape.x, shape.y), dot(shape.y, shape.y)
    two = [
        (e * mu).multiplied(f) - (middle * lam).multiplied(g),
        (e * nu).multiplied(f) - (last * lam).multiplied(g),
    ]
    return [*two, (middle * nu).multiplied(f) - (last * rho).multiplied(g)] if any(shape.both) else two


def _rounding(chart: Chart, forms: list[Form]) -> bool:
    """Return whether all forms are no more than rounding everywhere."""
    shape = Shape(chart, Ball)
    x, y, n = (max(_largest(part.ball()) for part in vector) for vector in (shape.x, shape.y, shape.normal))
    return all(_largest(part.ball()) <= _LEVEL * max(x, y) * x * x * n for part in forms)


def _largest(form: Ball) -> float:
    """Return a bound of the absolute values of a form."""
    low, high = Boxes.whole([form]).bounds()
    return float(np.maximum(np.abs(low), np.abs(high)).max(initial=0.0))
