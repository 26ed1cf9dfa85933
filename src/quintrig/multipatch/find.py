"""Finding the joins of a model: edges paired by place, measured, and judged by limits."""

from collections import defaultdict
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.model.held import Held
from quintrig.model.model import Model
from quintrig.multipatch.boundary import Edge, edges
from quintrig.multipatch.contact import Contact, contact
from quintrig.multipatch.continuity import Across, across, angle, jump
from quintrig.multipatch.joins import ORDERS, End, Join, Joins, Range
from quintrig.multipatch.limits import Limits, Preset, flat, limits
from quintrig.multipatch.neighbours import candidates
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import rounding

_NEAR = 0.2
"""Edges are near misses up to this part of their length and of their patches' width."""

_LITTLE = 0.02  # of an edge: less than that is not told as free


def find_joins(
    model: Model | Sequence[Surface],
    wanted: Limits | None = None,
    *,
    near: float = _NEAR,
    of: Collection[str] | None = None,
) -> Joins:
    """Return the joins of a model's patches, or of surfaces, within ``wanted`` limits (default: engineering).

    Edges farther apart than these are told as open up to ``near`` times their length and their patches' width. The
    angle is that of the tangent planes across the edge, folded patches at 180°. ``of`` names the only patches whose
    joins and free edges are wanted. Cost grows with the number of edges.
    """
    if isinstance(model, Model):
        title, unit = model.name, model.unit
        names, surfaces = [patch.name for patch in model.patches], [patch.surface for patch in model.patches]
    else:
        title, unit, surfaces = "surfaces", "", list(model)
        names = [str(k + 1) for k in range(len(surfaces))]
    alive, poles = edges(surfaces)
    sizes = [surface.size for surface in surfaces if surface.size > 0.0] or [1.0]
    if wanted is None:
        wanted = limits(unit, _extent(alive))
    least = min(sizes)
    floors = flat(least), flat(least) / least
    reach = np.array([max(near * min(edge.length, edge.width), wanted.tolerance) for edge in alive])
    chosen = {k for k, name in enumerate(names) if of is None or name in of}
    found = [
        (alive[a], alive[b], met)
        for a, b in _around(candidates(alive, reach), [edge.patch in chosen for edge in alive])
        if (met := contact(alive[a], alive[b], min(reach[a], reach[b]), _tolerance(alive[a], alive[b], wanted)))
    ]
    kept = [one for one in _kept(found, wanted) if {one[0].patch, one[1].patch} & chosen]
    joins = [_measured(names, *one, wanted, floors) for one in kept]
    return Joins(
        title,
        unit,
        wanted,
        floors,
        tuple(joins),
        tuple(_free(names, [edge for edge in alive if edge.patch in chosen], kept, wanted)),
        tuple(End(names[edge.patch], edge.side) for edge in poles if edge.patch in chosen),
        tuple(_unmet(model.held, joins, None if of is None else set(of))) if isinstance(model, Model) else (),
    )


def joins_of(
    model: Model,
    preset: Preset = "engineering",
    *,
    tolerance: float | None = None,
    angle: float | None = None,
    curvature: float | None = None,
    near: float = _NEAR,
    of: Collection[str] | None = None,
) -> Joins:
    """Return the joins of a model, or those ``of`` some patches, under a preset's limits, some replaced.

    Raises ValueError for limits not above 0.
    """
    if not 0.0 < near <= 0.5:
        raise ValueError(f"near: expected a part of an edge's length above 0 and up to 0.5, found {near:g}")
    size = 1.0 if model.unit else _extent(edges([patch.surface for patch in model.patches])[0])
    wanted = limits(model.unit, size, preset, tolerance=tolerance, angle=angle, curvature=curvature)
    return find_joins(model, wanted, near=near, of=of)


def _unmet(rules: Sequence[Held], joins: Sequence[Join], of: set[str] | None) -> Iterator[str]:
    """Give a line on each join that is to hold between these patches and does not reach its order."""
    found = {frozenset(f"{end.patch}:{end.side}" for end in (one.first, one.second)): one for one in joins}
    for rule in rules:
        seam = found.get(frozenset((rule.first, rule.second)))
        order = seam.order if seam else "open"
        if ORDERS.index(order) < ORDERS.index(rule.order) and (of is None or set(rule.patches) & of):
            yield (
                f"{rule.second} is held to {rule.first} to {rule.order} and reaches {order}: its kind or its functions "
                "along the side do not allow it; make it a tensor-product patch with the same shape parameters there"
            )


def _around(pairs: list[tuple[int, int]], wanted: Sequence[bool]) -> list[tuple[int, int]]:
    """Return the pairs of wanted edges, and of those that may be near them: which near misses count hangs on these."""
    beside = {edge for pair in pairs if wanted[pair[0]] or wanted[pair[1]] for edge in pair}
    return [pair for pair in pairs if pair[0] in beside or pair[1] in beside]


def _extent(alive: Sequence[Edge]) -> float:
    if not alive:
        return 1.0
    low, high = (np.array([f(edge.points, axis=0) for edge in alive]) for f in (np.min, np.max))
    return float(np.linalg.norm(high.max(axis=0) - low.min(axis=0)))


def _tolerance(first: Edge, second: Edge, wanted: Limits) -> float:
    """Return the limit of a gap, or what rounding alone may leave far from the origin."""
    return max(wanted.tolerance, rounding(first.points), rounding(second.points))


_Found = tuple[Edge, Edge, Contact]


def _kept(found: list[_Found], wanted: Limits) -> list[_Found]:
    """Leave out near misses of edges that are taken along that stretch by nearer ones; order by patch and side."""
    taken: dict[int, list[tuple[float, float]]] = defaultdict(list)
    result: list[_Found] = []
    for first, second, met in sorted(found, key=lambda one: one[2].gap):
        spans = [(id(first), _span(met.t)), (id(second), _span(met.feet))]
        if met.gap > _tolerance(first, second, wanted) and all(_covered(taken[key], span) > 0.5 for key, span in spans):
            continue
        for key, span in spans:
            taken[key].append(span)
        swap = (second.patch, second.side) < (first.patch, first.side)
        result.append((second, first, _swapped(met)) if swap else (first, second, met))
    return sorted(result, key=lambda one: (one[0].patch, one[0].side, one[1].patch, one[1].side))


def _swapped(met: Contact) -> Contact:
    step = -1 if met.reversed else 1
    return Contact(met.feet[::step], met.t[::step], met.distance[::step], met.reversed)


def _span(t: FloatArray) -> tuple[float, float]:
    return float(t.min()), float(t.max())


def _covered(spans: Sequence[tuple[float, float]], span: tuple[float, float]) -> float:
    """Return the part of a stretch that others cover."""
    return (span[1] - span[0] - sum(b - a for a, b in _gaps(spans, span))) / max(span[1] - span[0], 1e-300)


def _gaps(spans: Sequence[tuple[float, float]], span: tuple[float, float]) -> list[tuple[float, float]]:
    """Return what others leave of a stretch."""
    at, result = span[0], list[tuple[float, float]]()
    for a, b in sorted(spans):
        if a > at:
            result.append((at, min(a, span[1])))
        at = max(at, b)
        if at >= span[1]:
            break
    if at < span[1]:
        result.append((at, span[1]))
    return result


def _free(names: Sequence[str], alive: Sequence[Edge], kept: Sequence[_Found], wanted: Limits) -> list[End]:
    """Return the stretches of edges that no closed join takes."""
    taken: dict[int, list[tuple[float, float]]] = defaultdict(list)
    for first, second, met in kept:
        if met.gap <= _tolerance(first, second, wanted):
            taken[id(first)].append(_span(met.t))
            taken[id(second)].append(_span(met.feet))
    return [
        End(names[edge.patch], edge.side, a, b)
        for edge in alive
        for a, b in _gaps(taken[id(edge)], (0.0, 1.0))
        if b - a > _LITTLE
    ]


def _measured(
    names: Sequence[str], first: Edge, second: Edge, met: Contact, wanted: Limits, floors: tuple[float, float]
) -> Join:
    one = across(first, met.t, outward=True)
    two = across(second, met.feet, outward=False, backwards=met.reversed)
    points = first.curve(met.t)[0]
    sign = _side(one, first)
    k1, k2 = sign * one.curvature, sign * two.curvature
    turn = angle(one.normal, two.normal)
    relative = jump(k1, k2, floors[0])
    rate = jump(one.rate, two.rate, floors[1])
    change = bool(((k1 * k2 < 0.0) & (np.minimum(np.abs(k1), np.abs(k2)) > floors[0])).any())
    closed = met.gap <= _tolerance(first, second, wanted)
    result = Join(
        End(names[first.patch], first.side, *_span(met.t)),
        End(names[second.patch], second.side, *_span(met.feet)),
        reversed=met.reversed,
        opposed=bool(np.median(one.agrees != two.agrees) > 0.5),
        gap=_range(met.distance, points),
        angle=_range(turn, points),
        first_curvature=_range(k1, points),
        second_curvature=_range(k2, points),
        difference=_range(np.abs(k1 - k2), points),
        curvature=_range(relative, points),
        rate=_range(rate, points),
        sign_change=change,
        order="open",
        points=points,
    )
    return replace(result, order=_order(result, closed, wanted))


def _order(join: Join, closed: bool, wanted: Limits) -> str:
    """Return the highest order of which it and all below are reached."""
    steps = (
        closed,
        join.angle.most <= wanted.angle,
        join.curvature.most <= wanted.curvature,
        join.rate.most <= wanted.curvature,
    )
    return ORDERS[next((k for k, reached in enumerate(steps) if not reached), len(steps))]


def _side(one: Across, edge: Edge) -> float:
    """Return the sign that turns curvatures to the first patch's own normal."""
    return 1.0 if np.median(one.agrees) > 0.5 else -1.0


def _range(values: FloatArray, points: FloatArray) -> Range:
    if np.isnan(values).all():
        return Range(np.nan, np.nan, (np.nan, np.nan, np.nan))
    x, y, z = points[int(np.nanargmax(np.abs(values)))].tolist()
    return Range(float(np.nanmin(values)), float(np.nanmax(values)), (x, y, z))
