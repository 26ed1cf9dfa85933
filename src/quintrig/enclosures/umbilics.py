"""Umbilics as common zeros of two forms: whether those known are alone, and whether there are others.

With the X, Y, λ, μ, ρ and ν of ``shape``, E M - F L = f² A and E N - G L = f g B, where A = f (X·X) μ - g (X·Y) λ and
B = f (X·X) ν - g (Y·Y) λ. Where S_u does not vanish, both are 0 at umbilics and nowhere else. Along an edge that is one
point, as at a pole, they have its factor in common; it is divided out, and so the pole is spoken of, too: where it is
no umbilic, what is left does not vanish there.
"""

from dataclasses import dataclass

import numpy as np

from quintrig.basis.rational import NotRationalError
from quintrig.enclosures.ball import Ball
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

    ``all`` where every point is one, to rounding; ``poles`` are the sides (axis, end) that are one point, an umbilic.
    """

    alone: BoolArray
    open: FloatArray
    poles: frozenset[Side]
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
    poles: set[Side] = set()
    level, boxes = 0, 0
    turns = _turns(surface)
    for chart in each:
        pair, around = _pair(chart)
        poles |= around
        places = np.concatenate([np.stack(chart.places(*(known + turn).T), axis=-1) for turn in turns])
        if _rounding(chart, pair):
            level += 1
            found = Zeros(np.zeros(len(places), dtype=np.bool_), [(0.0, 0.0, 1.0, 1.0)])
        else:
            found = zeros([part.ball() for part in pair], places, most, outside(surface, chart))
        alone |= found.alone.reshape(len(turns), -1).any(axis=0)
        boxes += found.boxes
        low, high = np.split(np.array(found.open).reshape(-1, 4), 2, axis=1)
        left.append(np.stack([*chart.parameters(*low.T), *chart.parameters(*high.T)], axis=-1))
    return Umbilical(alone, np.concatenate(left), frozenset(poles), level == len(each), boxes)


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
    return Umbilical(alone, left, frozenset(), flat, found.boxes)


def _pair(chart: Chart) -> tuple[list[Form], set[Side]]:
    """Return A and B without the factors of edges that they share, and the sides that are one point, an umbilic."""
    balls = Shape(chart, Ball)
    if not any(balls.both):
        return equal(balls, _forms(balls)), set()
    shape = Shape(chart, Whole)
    try:
        pair = _forms(shape)
    except InexactError:
        return equal(balls, _forms(balls)), set()
    common = shared(pair)
    ends = (chart.u.span.start, chart.u.span.end, chart.v.span.start, chart.v.span.end)
    poles: set[Side] = set()
    for index, (collapsing, power) in enumerate(zip(shape.collapsing, shape.both, strict=True)):
        if collapsing and common[index] > power:  # f g alone is what it takes for curvature to stay bounded
            poles.add((index // 2, ends[index]))
    return equal(shape, [part if part.vanishes else part.divided(common) for part in pair]), poles


def _forms(shape: Shape) -> list[Form]:
    lam, mu, _, nu = shape.second_form
    f, g = shape.factors
    e, middle, last = dot(shape.x, shape.x), dot(shape.x, shape.y), dot(shape.y, shape.y)
    return [
        (e * mu).multiplied(f) - (middle * lam).multiplied(g),
        (e * nu).multiplied(f) - (last * lam).multiplied(g),
    ]


def _rounding(chart: Chart, pair: list[Form]) -> bool:
    """Return whether both forms are no more than rounding everywhere."""
    shape = Shape(chart, Ball)
    x, y, n = (max(_largest(part.ball()) for part in vector) for vector in (shape.x, shape.y, shape.normal))
    return all(_largest(part.ball()) <= _LEVEL * max(x, y) * x * x * n for part in pair)


def _largest(form: Ball) -> float:
    """Return a bound of the absolute values of a form."""
    low, high = Boxes.whole([form]).bounds()
    return float(np.maximum(np.abs(low), np.abs(high)).max(initial=0.0))
