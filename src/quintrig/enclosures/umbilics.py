"""Umbilics as common zeros of forms: whether those known are alone, and whether there are others.

With the X, Y, λ, μ, ρ and ν of ``shape``, E M - F L = f² A and E N - G L = f g B, where A = f (X·X) μ - g (X·Y) λ and
B = f (X·X) ν - g (Y·Y) λ. Where S_u does not vanish, both are 0 at umbilics and nowhere else; where S_v does not, the
same is true of B and C, F N - G M = g² C. Of each, the factor of an edge where S_u or S_v vanishes is divided out. At a
pole f g is a factor of all, and there are more in common if and only if it is an umbilic. Of other such edges nothing
is said.
"""

from dataclasses import dataclass

import numpy as np

from quintrig.basis.rational import NotRationalError
from quintrig.enclosures.ball import Ball, Edges
from quintrig.enclosures.boxes import Boxes
from quintrig.enclosures.charts import Chart, charts
from quintrig.enclosures.faces import outside
from quintrig.enclosures.measures import MEASURES, UPRIGHT, equal
from quintrig.enclosures.shape import Form, Shape, dot, shared
from quintrig.enclosures.strips import bounds
from quintrig.enclosures.whole import InexactError, Whole
from quintrig.enclosures.zeros import Zeros, zeros
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


@dataclass(frozen=True, eq=False)
class Umbilical:
    """Which of the umbilics known are ``alone`` (k,), what is left ``open``, (u, v, u, v) (m, 4), and ``poles``.

    ``all`` where every point is one, to rounding; ``poles`` are the sides (axis, end) that are one point, an umbilic;
    of the sides ``untold``, along which a tangent vanishes, nothing is said.
    """

    alone: BoolArray
    open: FloatArray
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
    for chart in each:
        forms, flat, still = _parted(chart)
        poles |= flat
        untold |= still
        places = np.concatenate([np.stack(chart.places(*(known + turn).T), axis=-1) for turn in turns])
        if _rounding(chart, forms):
            level += 1
            found = Zeros(np.zeros(len(places), dtype=np.bool_), [(0.0, 0.0, 1.0, 1.0)])
        else:
            found = zeros([part.ball() for part in forms], places, most, outside(surface, chart))
        alone |= found.alone.reshape(len(turns), -1).any(axis=0)
        boxes += found.boxes
        low, high = np.split(np.array(found.open).reshape(-1, 4), 2, axis=1)
        left.append(np.stack([*chart.parameters(*low.T), *chart.parameters(*high.T)], axis=-1))
    return Umbilical(alone, np.concatenate(left), frozenset(poles), frozenset(untold), level == len(each), boxes)


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
    return Umbilical(alone, left, frozenset(), frozenset(), flat, found.boxes)


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
