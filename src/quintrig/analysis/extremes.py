"""Minimum, maximum and mean of quantities over a surface, and where the extremes are.

The quantity is sampled on a grid that includes edges and corners, and windows close in on the best local extremes of
the samples. A feature that is narrower than a grid cell and missed by all samples is not found. Of a trimmed face only
points inside its loops count, and the loops themselves are searched along their length.
A curvature that is zero to rounding is told as 0. Beside singular edges two rings decide whether curvature has a bound,
as in integrals and sweeps (``beside``).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from quintrig.analysis.integrate import Integral, area_means, orientation
from quintrig.analysis.sample import analyse
from quintrig.analysis.singular_edges import Limit, limits
from quintrig.analysis.windows import FINEST, SHRINK, Reached, Starts, closed_in, values_of, without_rounding
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.geometry.trimmed import along, window
from quintrig.quantities.table import quantity
from quintrig.support.arrays import BoolArray, FloatArray, typical

if TYPE_CHECKING:
    from quintrig.enclosures.search import Bounds

Status = Literal["attained", "approached", "unbounded", "undefined"]
"""Attained at a point; only approached, or unbounded, beside points where there is no value; no value at all."""

_GROUPS = 12  # values of local extremes of the samples that are refined, at up to three places each
_EQUAL = 1e-8  # values this close, relative to the natural size of the quantity, count as equal
_ROUNDING = 1e-13
_CANCELLED = 1e-10  # curvatures nowhere above this share of C or C² are rounding of zero
_APART = 1e-3  # places further apart than this share of the size are different places
_ALONG = 64  # samples of a loop's side as long as the domain
_MOST_ALONG = 8192  # samples of a loop

_Limits = Mapping[tuple[str, float], Limit]


@dataclass(frozen=True, eq=False)
class Extreme:
    """The least or greatest value, its parameters and its point (3,), length¹.

    ``unique`` is false where the same value is taken at several places, of which this is the first in order of u, then
    v.
    """

    value: float
    u: float
    v: float
    point: FloatArray
    unique: bool
    status: Status

    def describe(self) -> str:
        """Return what is to be said beside the value; empty for an extreme attained at one place only."""
        words = {
            "attained": "",
            "approached": "approached beside points where it is undefined",
            "unbounded": "grows without bound beside points where it is undefined; this is only the nearest sample",
            "undefined": "undefined everywhere",
        }[self.status]
        several = not self.unique and self.status in ("attained", "approached")
        others = "taken at several places, of which this is the first" if several else ""
        return "; ".join(part for part in (words, others) if part)


@dataclass(frozen=True, eq=False)
class Extremes:
    """Extremes and mean of one quantity; ``key`` is its row in the table of quantities.

    ``mean`` is ∫q dA / ∫dA over the points where q is defined, with its measured error; ``grid_mean`` the plain mean of
    the samples, which depends on the parametrisation. ``undefined`` of the ``samples`` are NaN or infinite.
    ``certified`` surely encloses both extremes, where it was asked for and there is a proof.
    """

    key: str
    minimum: Extreme
    maximum: Extreme
    mean: Integral
    grid_mean: float
    samples: int
    undefined: int
    orientation: str
    certified: "Bounds | None" = None


def find_extremes(
    surface: Surface,
    keys: Sequence[str] | str = ("gaussian", "mean", "k1", "k2", "shape_index", "curvedness"),
    samples: int = 65,
    certified: bool = False,
) -> dict[str, Extremes]:
    """Return minimum, maximum and mean of scalar quantities, by key; ``samples`` a side are refined.

    ``keys`` may be symbols, or a single one. ``certified`` adds bounds that are proved, for quantities and surfaces
    that have a proof. Raises ValueError for an unknown or vector quantity, or fewer than 2 samples.
    """
    keys = [quantity(key).key for key in ([keys] if isinstance(keys, str) else keys)]
    means = area_means(surface, keys)
    found = find_ends(surface, keys, samples)
    u, v = face_grid(surface, samples, samples)
    sample = analyse(surface, u, v, tuple(dict.fromkeys((*keys, "curvedness"))))
    curved, inside = sample["curvedness"], surface.inside(u, v)
    results: dict[str, Extremes] = {}
    for key in keys:
        values = without_rounding(sample[key], curved, surface.size, key)[inside]
        defined = np.isfinite(values)
        mean = float(values[defined].mean()) if defined.any() else np.nan
        bounds = _bounds(surface, key) if certified else None
        missing = int((~defined).sum())
        results[key] = Extremes(key, *found[key], means[key], mean, values.size, missing, orientation(surface), bounds)
    return results


def _bounds(surface: Surface, key: str) -> "Bounds | None":
    from quintrig.enclosures.measures import MEASURES
    from quintrig.enclosures.prove import NoProofError, Prover

    try:
        return Prover(surface).bounds(key, most=256) if key in MEASURES else None
    except NoProofError:
        return None


def find_ends(surface: Surface, keys: Sequence[str], samples: int = 65) -> dict[str, tuple[Extreme, Extreme]]:
    """Return minimum and maximum of scalar quantities, by key, without the means, which take longer.

    Raises ValueError as ``find_extremes`` does.
    """
    u, v = face_grid(surface, samples, samples)
    sample = analyse(surface, u, v, tuple(dict.fromkeys((*keys, "curvedness"))))
    inside, beside = surface.inside(u, v), _beside(surface, sample["curvedness"])
    curved = np.where(inside, sample["curvedness"], np.nan)
    usual = typical(curved)
    # Where C itself vanishes its own rounding is the measure.
    curved_at = np.maximum(curved, 1e-5 * usual)
    zeros: dict[str, Extreme] = {}
    sought: dict[tuple[str, float], tuple[FloatArray, float, Starts]] = {}
    for key in keys:
        values = np.where(inside, without_rounding(sample[key], curved, surface.size, key), np.nan)
        defined = np.isfinite(values)
        power = quantity(key).power
        # Curvatures may cancel; the size of their rounding is that of C to the same power.
        natural = usual ** (-power) if power <= 0 else 0.0
        if power < 0 and defined.any() and (np.abs(values) <= _CANCELLED * curved_at**-power)[defined].all():
            zeros[key] = _zero(surface, _place(surface, np.argwhere(defined)[0], samples))
            continue
        for sense in (1.0, -1.0):
            limit = beside.get((key, sense))
            if defined.any() and not (limit and limit.unbounded):
                costs = np.where(defined, sense * values, np.inf)
                largest = max(float(np.abs(values[defined]).max()), natural)
                starts = _local_minima(costs, largest)
                at = _place(surface, starts, samples)
                sought[key, sense] = costs, natural, Starts(key, sense, at, costs[starts[:, 0], starts[:, 1]], largest)
    # All at once: one call for all windows takes little longer than one for a single window.
    reached = dict(
        zip(sought, closed_in(surface, [one[2] for one in sought.values()], 1.0 / (samples - 1.0)), strict=True)
    )

    def end(key: str, sense: float) -> Extreme:
        if (key, sense) in sought:
            return _extreme(surface, *sought[key, sense], reached[key, sense], (key, sense) in beside)
        limit = beside.get((key, sense))
        if limit and limit.unbounded:
            return Extreme(limit.value, limit.u, limit.v, surface(limit.u, limit.v), True, "unbounded")
        return Extreme(np.nan, np.nan, np.nan, np.full(3, np.nan), False, "undefined")

    return {key: (zeros[key], zeros[key]) if key in zeros else (end(key, 1.0), end(key, -1.0)) for key in keys}


def _zero(surface: Surface, place: FloatArray) -> Extreme:
    """Return the extreme of a curvature that is zero everywhere; its rounding has none worth telling."""
    return Extreme(0.0, float(place[0]), float(place[1]), surface(place[0], place[1]), False, "attained")


def _beside(surface: Surface, curved: FloatArray) -> _Limits:
    """Return what becomes of curvatures beside singular edges; empty where there is none, or other singular points."""
    inner = np.isfinite(curved[1:-1, 1:-1]).all()
    found = (limits(surface) if inner else None) or {}
    return {end: limit for end, limit in found.items() if surface.inside(limit.u, limit.v)}


def _place(surface: Surface, index: NDArray[np.intp], samples: int) -> FloatArray:
    """Return the parameters (..., 2) of samples by their indices (..., 2)."""
    low, high = window(surface.trim)
    return low + (high - low) * index / (samples - 1.0)


def _extreme(
    surface: Surface, costs: FloatArray, natural: float, starts: Starts, reached: Reached, limited: bool
) -> Extreme:
    """Return the least of sense · q of the samples' costs (n, n) and of what windows have reached from them.

    A value that is ``limited`` beside singular edges does not grow without bound there.
    """
    sense, n = starts.sense, len(costs)
    places, found, beside = reached.places, reached.values, reached.beside
    growing = reached.growing & (not limited)
    if surface.trim:
        rim, least = _on_loops(surface, starts.key, sense, starts.largest)
        places, found = np.concatenate([places, rim]), np.concatenate([found, least])
        inner: BoolArray = np.zeros(len(least), dtype=np.bool_)
        beside, growing = np.concatenate([beside, inner]), np.concatenate([growing, inner])
    best = min(float(costs.min()), float(found.min()))
    scale = max(abs(best), natural)
    tied = np.argwhere(costs <= best + _EQUAL * scale)
    places = np.concatenate([_place(surface, tied, n), places])
    found = np.concatenate([costs[tied[:, 0], tied[:, 1]], found])
    none = np.zeros(len(tied), dtype=np.bool_)
    beside, growing = np.concatenate([none, beside]), np.concatenate([none, growing])
    limit = found[growing].min() if growing.any() else best + _EQUAL * scale
    equal = (found <= limit) & (growing | ~growing.any())
    # A value that is attained somewhere is better than one that is only approached, and one at a sample, where it is no
    # worse, better than one that the refinement has reached by following rounding.
    attained = equal & ~beside & ~growing
    sampled = attained & (found <= best + _ROUNDING * scale) & (np.arange(len(found)) < len(tied))
    first = _first(places, found, next(x for x in (sampled, attained, equal) if x.any()), _ROUNDING * scale)
    points = surface(places[equal, 0], places[equal, 1])
    point = surface(places[first, 0], places[first, 1])
    unique = bool(np.linalg.norm(points - point, axis=-1).max() <= _APART * surface.size)
    status: Status = "unbounded" if growing[first] else "approached" if beside[first] else "attained"
    return Extreme(
        float(sense * found[first]) + 0.0, float(places[first, 0]), float(places[first, 1]), point, unique, status
    )


def _first(places: FloatArray, found: FloatArray, among: BoolArray, rounding: float) -> int:
    """Return the first of the places in order of u, then v; of those that are one place, the first that is no worse."""
    choice = np.flatnonzero(among)
    rounded = np.round(places[choice], 4)
    order = np.lexsort((rounded[:, 1], rounded[:, 0]))
    same = choice[(rounded == rounded[order[0]]).all(axis=1)]
    return int(same[found[same] <= found[same].min() + rounding][0])


def _local_minima(costs: FloatArray, scale: float) -> NDArray[np.intp]:
    """Return the indices (c, 2) of the least local minima among the samples.

    Of those with equal values, as on a ring of extremes, only the first, the middle and the last, so that others
    that may prove deeper have room.
    """
    n, m = costs.shape
    around = np.pad(costs, 1, constant_values=np.inf)
    slack = _EQUAL * scale
    least = np.isfinite(costs)
    for i in range(3):
        for j in range(3):
            least &= costs <= around[i : i + n, j : j + m] + slack
    found = np.argwhere(least)
    values = costs[found[:, 0], found[:, 1]]
    order = np.argsort(values, kind="stable")
    groups = np.split(order, np.flatnonzero(np.diff(values[order]) > slack) + 1)
    chosen = [np.sort(group)[sorted({0, len(group) // 2, len(group) - 1})] for group in groups[:_GROUPS]]
    return found[np.concatenate(chosen)]


def _on_loops(surface: Surface, key: str, sense: float, largest: float) -> tuple[FloatArray, FloatArray]:
    """Return places (c, 2) on the trim loops where sense · q is least, and its values (c,)."""
    places: list[FloatArray] = []
    found: list[FloatArray] = []
    for loop in surface.trim:
        longest = float(np.abs(np.roll(loop, -1, axis=0) - loop).max())
        parts = max(1, min(round(longest * _ALONG), _ALONG, _MOST_ALONG // len(loop)))
        t = np.arange(len(loop) * parts) / parts
        at = along(loop, t)
        costs = _costs(surface, key, sense, at)
        slack = _EQUAL * largest
        least = np.isfinite(costs) & (costs <= np.minimum(np.roll(costs, 1), np.roll(costs, -1)) + slack)
        chosen = np.flatnonzero(least)
        chosen = chosen[np.argsort(costs[chosen], kind="stable")[:_GROUPS]]
        t, best, width = t[chosen], costs[chosen], 1.0 / parts
        while len(t) and width > FINEST:
            near = t[:, None] + width * np.linspace(-1.0, 1.0, 9)
            costs = _costs(surface, key, sense, along(loop, near))
            choice = costs.argmin(axis=1)
            each = np.arange(len(t))
            better = costs[each, choice] < best
            t, best = np.where(better, near[each, choice], t), np.where(better, costs[each, choice], best)
            width *= SHRINK
        places.append(along(loop, t))
        found.append(best)
    return np.concatenate(places), np.concatenate(found)


def _costs(surface: Surface, key: str, sense: float, at: FloatArray) -> FloatArray:
    values = values_of(surface, [key], np.zeros(len(at), dtype=np.intp), at)
    return np.where(np.isfinite(values), sense * values, np.inf)
