"""What a design may vary: coordinates of control points and named parameters, and how a surface depends on them.

A surface is affine in every coordinate and shape parameter taken alone, so its derivatives by them are exact: through
the net for kinds that have one, by a central difference, which is exact for an affine function, for the rest.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.basis.functions import Functions
from quintrig.geometry.surface import Net, Surface
from quintrig.model.patch import Patch
from quintrig.multipatch.nets import handle
from quintrig.shaping.coordinates import chosen_by, flattened, nets_of
from quintrig.shaping.derivatives import Affine, affine
from quintrig.shaping.holds import Hold, held_at, kept_directions
from quintrig.support.arrays import FloatArray

INDICES = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3))
"""The derivatives that goals look at, as (times by u, times by v)."""

_COUNTS = (1, 3, 6, 10)  # of them up to each order
_KEPT = 64  # sets of functions kept
_SAME = 1e-9  # of the patch's size: a change that moves what is held by less leaves it


@dataclass(frozen=True)
class Range:
    """A parameter of the patch by name, and the values that it may have."""

    name: str
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class State:
    """The patch at values of the unknowns, with what its derivatives need."""

    space: "Unknowns"
    values: FloatArray
    patch: Patch

    @property
    def surface(self) -> Surface:
        """The surface."""
        return self.patch.surface

    def partials(self, u: FloatArray, v: FloatArray, order: int = 2) -> FloatArray:
        """Return derivatives up to ``order`` at points u, v (k,), (indices, k, 3), length¹."""
        rows = self.surface.rows
        if self.space.of is None or not isinstance(rows, Net):
            return _partials(self.surface, u, v, order)
        fu, fv = self._functions(u, v, order)
        return _combined(fu, fv, rows.points, self.surface.origin, order)

    def _functions(self, u: FloatArray, v: FloatArray, order: int) -> tuple[FloatArray, FloatArray]:
        """Return the derivatives of the functions in u and v; a search asks for the same ones again and again."""
        rows = self.surface.rows
        if not isinstance(rows, Net):
            raise TypeError(f'patch "{self.patch.name}": expected the rows of a net')
        found: list[FloatArray] = []
        for axis, (family, t) in enumerate(((rows.functions, u), (self.surface.blend, v))):
            key = (axis, order, self.patch.shape, t.tobytes())
            if key not in self.space.known:
                if len(self.space.known) >= _KEPT:
                    self.space.known.clear()
                self.space.known[key] = family.derivatives(t, order)
            found.append(self.space.known[key])
        return found[0], found[1]

    @cached_property
    def _neighbours(self) -> list[tuple[Surface, Surface, float]]:
        """The surfaces a step ahead and back in each unknown that is taken by differences, and twice the step."""
        found: list[tuple[Surface, Surface, float]] = []
        for index, step in self.space.by_steps:
            unit = np.zeros_like(self.values)
            unit[index] = step
            ahead, back = (self.space.built(self.values + sign * unit).surface for sign in (1.0, -1.0))
            found.append((ahead, back, 2.0 * step))
        return found

    def pulled(self, u: FloatArray, v: FloatArray, gradient: FloatArray) -> FloatArray:
        """Return gradients by the unknowns (k, n), from those by the derivatives at each point (indices, k, 3)."""
        order = _COUNTS.index(len(gradient))
        rows: FloatArray = np.zeros((len(u), len(self.values)))
        coordinates = self.space.coordinates
        if self.space.of is not None and coordinates:
            fu, fv = self._functions(u, v, order)
            net: FloatArray = np.zeros((len(u), fu.shape[-1], fv.shape[-1], 3))
            for (a, b), part in zip(INDICES, gradient, strict=False):
                net += fu[a][:, :, None, None] * (fv[b][:, :, None] * part[:, None, :])[:, None]
            rows[:, :coordinates] = net.reshape(len(u), -1) @ self.space.matrix
        for index, change in self._changes(u, v, order):
            rows[:, index] = (gradient * change).sum(axis=(0, 2))
        return rows

    def total(self, u: FloatArray, v: FloatArray, gradient: FloatArray) -> FloatArray:
        """Return the sum of ``pulled`` over the points, (n,)."""
        order = _COUNTS.index(len(gradient))
        result: FloatArray = np.zeros(len(self.values))
        coordinates = self.space.coordinates
        if self.space.of is not None and coordinates:
            fu, fv = self._functions(u, v, order)
            net: FloatArray = np.zeros((fu.shape[-1], fv.shape[-1] * 3))
            for (a, b), part in zip(INDICES, gradient, strict=False):
                net += fu[a].T @ (fv[b][:, :, None] * part[:, None, :]).reshape(len(u), -1)
            result[:coordinates] = net.ravel() @ self.space.matrix
        for index, change in self._changes(u, v, order):
            result[index] = (gradient * change).sum()
        return result

    def _changes(self, u: FloatArray, v: FloatArray, order: int) -> Iterator[tuple[int, FloatArray]]:
        """Yield the derivatives of all that ``partials`` returns by each unknown that is taken by differences."""
        for (index, _), (ahead, back, step) in zip(self.space.by_steps, self._neighbours, strict=True):
            yield index, (self._beside(ahead, u, v, order) - self._beside(back, u, v, order)) / step

    def _beside(self, surface: Surface, u: FloatArray, v: FloatArray, order: int) -> FloatArray:
        """Return what ``partials`` does, of a surface a step away; most of the functions are those of the others."""
        rows = surface.rows
        if not isinstance(rows, Net) or surface.rational:
            return _partials(surface, u, v, order)
        fu, fv = (self._derived(family, t, order) for family, t in ((rows.functions, u), (surface.blend, v)))
        return _combined(fu, fv, rows.points, surface.origin, order)

    def _derived(self, family: Functions, t: FloatArray, order: int) -> FloatArray:
        """Return the derivatives of a family, kept while the patch is here."""
        key = (family, order, t.tobytes())
        if key not in self._kept:
            self._kept[key] = family.derivatives(t, order)
        return self._kept[key]

    @cached_property
    def _kept(self) -> dict[Any, FloatArray]:
        return {}


@dataclass(frozen=True, eq=False)
class Unknowns:
    """The unknowns: first ``coordinates`` of control points, then parameters, each from ``low`` to ``high`` (n,).

    ``of`` is the patch as affine in its coordinates, None for kinds that are taken by differences; ``chosen`` are the
    coordinates that may move. ``directions`` (coordinates, q) are the ways in which they leave what is held.
    ``by_steps`` lists the unknowns taken by differences, with steps; ``notes`` tell what stays and why.
    """

    patch: Patch
    of: Affine | None
    chosen: NDArray[np.int64]
    ranges: tuple[Range, ...]
    directions: FloatArray
    low: FloatArray
    high: FloatArray
    start: FloatArray
    by_steps: tuple[tuple[int, float], ...]
    notes: tuple[str, ...] = ()
    known: dict[Any, FloatArray] = field(default_factory=dict[Any, FloatArray])

    @property
    def coordinates(self) -> int:
        """How many coordinates may move."""
        return len(self.chosen)

    @cached_property
    def matrix(self) -> FloatArray:
        """The net's coordinates by those that may move, (n m 3, coordinates)."""
        if self.of is None:
            raise TypeError("expected a patch whose net may move")
        return self.of.matrix.reshape(-1, self.of.matrix.shape[-1])[:, self.chosen]

    def keys(self, values: FloatArray) -> dict[str, Any]:
        """Return the keys of the definition that these values change."""
        keys: dict[str, Any] = {}
        definition = self.patch.definition
        if self.coordinates:
            flat = flattened(self.patch)
            flat[self.chosen] = values[: self.coordinates]
            keys |= nets_of(self.patch, flat)
        named = dict(zip((one.name for one in self.ranges), values[self.coordinates :].tolist(), strict=True))
        if set(named) & set(definition.ranges):
            keys["shape"] = [named.get(name, definition.parameters.get(name, 0.0)) for name in definition.ranges]
        return keys | {name: value for name, value in named.items() if name not in definition.ranges}

    def values_of(self, patch: Patch) -> FloatArray:
        """Return the unknowns as another patch of the kind has them."""
        flat = flattened(patch)[self.chosen] if self.coordinates else np.zeros(0)
        return np.concatenate([flat, [patch.definition.parameters[one.name] for one in self.ranges]])

    def built(self, values: FloatArray) -> Patch:
        """Return the patch with these values, unchecked: a step may leave the ranges."""
        keys = self.keys(values)
        if "shape" in keys:
            keys["unchecked_shape"] = True
        definition = self.patch.definition.model_copy(update=keys)
        return Patch(self.patch.name, definition, definition.surface())

    def at(self, values: FloatArray) -> State:
        """Return the patch at these values."""
        return State(self, values, self.built(values))

    def finished(self, values: FloatArray) -> Patch:
        """Return the patch with these values in their ranges, checked as a model file is."""
        keys = self.keys(np.clip(values, self.low, self.high))
        dump = self.patch.definition.model_dump(exclude_defaults=True, exclude={"kind"})
        return self.patch.rebuilt(**{"kind": self.patch.kind, **dump, **keys})


def unknowns(
    patch: Patch, ranges: Sequence[Range], points: float | None, only: Sequence[str], holds: Sequence[Hold]
) -> Unknowns:
    """Return what may vary: parameters in their ranges, and points by up to ``points`` each way, length¹.

    ``only`` names the points or coordinates that may move, such as ``points[2][3]``, ``section[1].z`` or ``z``; all
    where it is empty. What moves something held stays. Raises ModelError for names that are none, ValueError where
    nothing is left.
    """
    notes: list[str] = []
    net = points is not None
    of = affine(patch) if net and handle(patch) is not None else None
    chosen = chosen_by(patch, only, "vary: only") if net else np.zeros(0, np.int64)
    flat = flattened(patch)[chosen] if net else np.zeros(0)
    reach = points or 0.0
    named = [one for one in ranges if _leaves(patch, {one.name: one}, holds)]
    notes += [f"{one.name} stays: it moves what is held" for one in ranges if one not in named]
    if net and of is None and holds:
        free = np.array([_coordinate_leaves(patch, int(k), reach, holds) for k in chosen], dtype=bool)
        if not free.all():
            notes.append(f"{int((~free).sum())} coordinates stay: they move what is held")
        chosen, flat = chosen[free], flat[free]
    directions = np.eye(len(chosen)) if of is None else kept_directions(of, holds, chosen)
    if directions.shape[1] == 0:
        chosen, flat, directions = chosen[:0], flat[:0], np.zeros((0, 0))
    if not named and not len(chosen):
        held = ", ".join(map(str, holds)) or "nothing"
        raise ValueError(f'vary: patch "{patch.name}": what is held ({held}) leaves nothing free; hold less')
    here = patch.definition.parameters
    start = np.concatenate([flat, [here[one.name] for one in named]])
    low = np.concatenate([flat - reach, [one.low for one in named]])
    high = np.concatenate([flat + reach, [one.high for one in named]])
    first = Unknowns(patch, of, chosen, tuple(named), directions, low, high, start, (), tuple(notes))
    stepped = range(len(chosen) if of is not None else 0, len(start))
    by_steps = tuple((index, _step(first, index)) for index in stepped)
    return Unknowns(patch, of, chosen, tuple(named), directions, low, high, start, by_steps, tuple(notes))


def as_it_is(patch: Patch) -> State:
    """Return a patch of which nothing varies."""
    none: FloatArray = np.zeros(0)
    empty: FloatArray = np.zeros((0, 0))
    space = Unknowns(patch, None, np.zeros(0, np.int64), (), empty, none, none, none, ())
    return State(space, none, patch)


def _step(space: Unknowns, index: int) -> float:
    """Return a step in one unknown: a wide one where the surface is affine in it, as tried, else a small one."""
    width = float(space.high[index] - space.low[index])
    if index >= space.coordinates and space.ranges[index - space.coordinates].name not in space.patch.definition.ranges:
        # A size must not be stepped below 0 from the low end of its range.
        return 1e-3 * min(width, max(abs(float(space.low[index])), 1e-3 * width))
    u, v = (part.ravel() for part in np.meshgrid(np.linspace(0.0, 1.0, 4), np.linspace(0.0, 1.0, 4)))
    middle = np.clip(space.start, space.low, space.high)
    middle[index] = 0.5 * (space.low[index] + space.high[index])
    unit = np.zeros_like(middle)
    unit[index] = 0.25 * width
    try:
        ahead, here, back = (_partials(space.built(middle + k * unit).surface, u, v, 2) for k in (1.0, 0.0, -1.0))
        bent = np.abs(ahead + back - 2.0 * here).max()
        if bent <= 1e-11 * np.abs(here).max():
            return 0.25 * width
    except (ValueError, ArithmeticError):
        pass
    return 1e-5 * width


def _combined(fu: FloatArray, fv: FloatArray, points: FloatArray, origin: FloatArray, order: int) -> FloatArray:
    """Return partial derivatives (indices, n, 3) from those of the functions, (order + 1, n, k) each way."""
    flat = points.reshape(len(points), -1)
    along = [(part @ flat).reshape(len(part), -1, 3) for part in fu]
    found = [(fv[b][:, None] @ along[a])[:, 0] for a, b in INDICES[: _COUNTS[order]]]
    found[0] = found[0] + origin
    return np.stack(found)


def _partials(surface: Surface, u: FloatArray, v: FloatArray, order: int) -> FloatArray:
    found = surface.local_partials(u, v, order)
    result = np.stack([found[a, b] for a, b in INDICES[: _COUNTS[order]]])
    result[0] += surface.origin
    return result


def _leaves(patch: Patch, moved: dict[str, Range], holds: Sequence[Hold]) -> bool:
    """Return whether a parameter leaves what is held where it is."""
    here = patch.definition.parameters
    values: dict[str, float] = {}
    for name, one in moved.items():
        low, high = max(one.low, -1e30), min(one.high, 1e30)
        values[name] = low + (0.25 if here[name] > 0.5 * (low + high) else 0.75) * (high - low)
    return not holds or _same(patch, patch.with_parameters(values).surface, holds)


def _coordinate_leaves(patch: Patch, index: int, reach: float, holds: Sequence[Hold]) -> bool:
    flat = flattened(patch)
    flat[index] += 0.5 * reach
    return _same(patch, patch.definition.model_copy(update=nets_of(patch, flat)).surface(), holds)


def _same(patch: Patch, surface: Surface, holds: Sequence[Hold]) -> bool:
    size = patch.surface.size
    return all(np.abs(held_at(surface, one) - held_at(patch.surface, one)).max() <= _SAME * size for one in holds)
