"""Windows of points that close in on extremes of quantities.

A window of 9 x 9 points moves while its best point lies on its border and shrinks otherwise, down to 1e-9 of the
domain. Windows are cut off at the edges of the domain, so an extreme on an edge or at a corner is met exactly. Beside
points where a quantity is undefined windows stop early, and a value that goes on growing there has no bound.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quintrig.analysis.sample import analyse
from quintrig.geometry.surface import Surface
from quintrig.quantities.table import quantity
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.tolerance import rounding_floor

FINEST = 1e-9
"""Half the width of the last window."""

SHRINK = 0.3
"""A little more than the distance of two points of a window, a quarter of its half width."""

_BESIDE = 1e-3  # windows that hold undefined points stop here: beyond, rounding beside a singular point takes over
_RISE = 1e-2  # a hundred times nearer to an undefined point, a value without bound has at least doubled, risen by this
_POLE = 1e3  # a refined value this many times the largest sample has no bound either
_BOUNDED = ("shape_index", "beta0_surface")
_STEPS = 100
_OFFSETS = 0.25 * (np.argwhere(np.ones((9, 9))) - 4)  # of the points of a window, (81, 2), from -1 to 1


@dataclass(frozen=True, eq=False)
class Starts:
    """Places (c, 2) that minima of sense · q are near, q being ``best`` (c,) there; ``largest`` is that of |q|."""

    key: str
    sense: float
    places: FloatArray
    best: FloatArray
    largest: float


@dataclass(frozen=True, eq=False)
class Reached:
    """Places (c, 2), sense · q there (c,), where the last window held undefined points, and where q has no bound."""

    places: FloatArray
    values: FloatArray
    beside: BoolArray
    growing: BoolArray


def closed_in(surface: Surface, starts: Sequence[Starts], width: float) -> list[Reached]:
    """Return what windows, at first 2 · ``width`` wide, have closed in on: of all quantities and places together."""
    if not starts:
        return []
    keys = list(dict.fromkeys(one.key for one in starts))
    count = [len(one.places) for one in starts]
    which = np.repeat([keys.index(one.key) for one in starts], count)
    sense, largest = (
        np.repeat(part, count) for part in zip(*((one.sense, one.largest) for one in starts), strict=True)
    )
    places = np.concatenate([one.places for one in starts])
    best = np.concatenate([one.best for one in starts])
    widths: FloatArray = np.full(len(places), width)
    beside: BoolArray = np.zeros(len(places), dtype=np.bool_)
    still = np.arange(len(places))  # those that are not done
    for _ in range(_STEPS):
        near = _window(places[still], widths[still])
        costs = sense[still, None] * values_of(surface, keys, which[still], near)
        defined = np.isfinite(costs)
        beside[still] = ~defined.all(axis=1)
        inside = surface.inside(near[..., 0], near[..., 1]) if surface.trim else True
        costs = np.where(defined & inside, costs, np.inf)
        choice = costs.argmin(axis=1)
        each = np.arange(len(still))
        better = costs[each, choice] < best[still]
        moved = near[each, choice]
        # On the border of the window, but not of the domain, the extreme may lie further out: go on before shrinking.
        roam = better & ((np.abs(_OFFSETS[choice]) == 1.0) & (moved > 0.0) & (moved < 1.0)).any(axis=1)
        places[still[better]] = moved[better]
        best[still[better]] = costs[each, choice][better]
        done = ~roam & ((widths[still] <= FINEST) | (beside[still] & (widths[still] <= _BESIDE)))
        next_width = np.where(roam, np.minimum(2.0 * widths[still], width), SHRINK * widths[still])
        widths[still] = np.where(done, widths[still], next_width)
        still = still[~done]
        if not len(still):
            break
    nearer, probe = _probe(surface, keys, which, sense, places, widths)
    endless = ~np.isin(which, [keys.index(key) for key in _BOUNDED if key in keys])
    unbounded = endless & (np.maximum(np.abs(best), _RISE * largest) <= best - probe)
    places, best = np.where(unbounded[:, None], nearer, places), np.where(unbounded, probe, best)
    growing = unbounded | (endless & (np.abs(best) > _POLE * largest))
    ends = np.cumsum(count)[:-1]
    return [
        Reached(*one) for one in zip(*(np.split(part, ends) for part in (places, best, beside, growing)), strict=True)
    ]


def values_of(surface: Surface, keys: Sequence[str], which: NDArray[np.intp], at: FloatArray) -> FloatArray:
    """Return quantities (c, ...) at parameters (c, ..., 2), ``which`` (c,) of the keys; 0 for what is only rounding."""
    sample = analyse(surface, at[..., 0], at[..., 1], tuple(dict.fromkeys((*keys, "curvedness"))))
    result: FloatArray = np.empty(at.shape[:-1])
    for k, key in enumerate(keys):
        rows = which == k
        result[rows] = without_rounding(sample[key][rows], sample["curvedness"][rows], surface.size, key)
    return result


def without_rounding(values: FloatArray, curved: FloatArray, size: float, key: str) -> FloatArray:
    """Return the values with 0 for curvatures that are only rounding, ``curved`` being C at the same points."""
    power = quantity(key).power
    return np.where(np.abs(values) <= rounding_floor(curved, size, power), 0.0, values) if power < 0 else values


def _window(places: FloatArray, widths: FloatArray) -> FloatArray:
    """Return the points (c, 81, 2) of windows about places (c, 2)."""
    return np.clip(places[:, None] + widths[:, None, None] * _OFFSETS, 0.0, 1.0)


def _probe(
    surface: Surface, keys: Sequence[str], which: NDArray[np.intp], sense: FloatArray, places: FloatArray,
    widths: FloatArray,
) -> tuple[FloatArray, FloatArray]:  # fmt: skip
    """Go from ``places`` 99 % of the way to the nearest undefined point of the window.

    Returns the new places and sense · q there, infinite where the window has no undefined point.
    """
    near = _window(places, widths)
    undefined = ~np.isfinite(values_of(surface, keys, which, near))
    distance = np.where(undefined, np.linalg.norm(near - places[:, None], axis=-1), np.inf)
    target = near[np.arange(len(places)), distance.argmin(axis=1)]
    nearer = places + 0.99 * (target - places)
    values = sense * values_of(surface, keys, which, nearer)
    return nearer, np.where(undefined.any(axis=1) & np.isfinite(values), values, np.inf)
