"""``fair``: the smoothest patch near a given one, by its control points, its shape parameters, or both.

The net goes along a path: for λ from large to small the minimum of energy + λ ∫∫ |S - S_0|² du dv (Tikhonov), and the
smallest λ whose surface stays within the allowed deviation is taken. A step is kept only where it lowers the energy.
"""

from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Any, Literal

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.shaping.coordinates import chosen_by
from quintrig.shaping.derivatives import Affine, affine
from quintrig.shaping.energies import ENERGIES, Energy, Quadratic, energy, known, measured, quadratic
from quintrig.shaping.fairing import BETWEEN, Fairing, fairest_near
from quintrig.shaping.holds import Hold, free_directions, held_at, hold, kept_directions, usual
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError

Vary = Literal["net", "shape", "both"]

_ROUNDS = 4  # of net and shape in turn
_SAME = 1e-9  # of a side's size: a shape parameter that moves it by less leaves it


def fair(
    model: Model | Surface,
    *,
    patch: str | None = None,
    energy: str = "thin_plate",
    vary: Vary = "net",
    hold: Sequence[str] | None = None,
    within: float | None = None,
    only: Sequence[str] = (),
) -> Fairing:
    """Return the model with one patch made fairer: least ``energy`` with what is held held, nowhere raised.

    ``energy`` is thin_plate, bending or variation. ``vary`` says what may change: the net, the shape parameters (within
    their ranges), or both. ``hold`` lists sides and points that stay, to an order: ``"u0"``, ``"v1:G2"``,
    ``"0.5,0.5:G1"``; by default seams with neighbours to the order they have, and all four sides where the net alone
    varies. ``within`` bounds the deviation, length¹; it may be left out where the shape alone varies, all sides are
    held, or points are named. ``only`` names the control points or coordinates that move, such as ``points[2][3]`` or
    ``section[1].z``; sides without neighbours are free then.
    Raises ModelError for a patch whose net is not free, ValueError for words that are none, and where nothing is
    left to vary.
    """
    if isinstance(model, Surface):
        model = Model("surface", "", (Patch.of(model),))
    name = known(energy)
    if vary not in ("net", "shape", "both"):
        raise ValueError(f"vary: expected net, shape or both, found {vary!r}")
    if within is not None and not 0.0 < within < np.inf:
        raise ValueError(f"within: expected a length greater than 0, found {within:g}")
    first = model.patch(patch)
    if first.surface.trim:
        raise ModelError(f'patch "{first.name}": a trimmed face is not made fairer; take its whole surface')
    if only and vary == "shape":
        raise ValueError("only: names control points, which stay where the shape alone varies; vary the net")
    named = (only,) if isinstance(only, str) else tuple(only)
    holds = _usual(model, first.name, vary, bool(named)) if hold is None else _read(hold)
    found, notes = _fairest(first, name, vary, holds, within, named)
    start, end = _energies(first), _energies(found)
    return Fairing(
        model.with_patch(found), first.name, name, start, end, deviation(first, found), tuple(map(str, holds)), notes
    )


def deviation(first: Patch, second: Patch) -> float:
    """Return the largest distance between points of equal (u, v) of two patches, at 129 x 129 points, length¹."""
    t = np.linspace(0.0, 1.0, 129)
    apart = first.surface(t[:, None], t) - second.surface(t[:, None], t)
    return float(np.sqrt((apart**2).sum(axis=-1)).max())


def _usual(model: Model, patch: str, vary: Vary, named: bool) -> tuple[Hold, ...]:
    """Return what is held if nothing is said; the seams alone where points are named."""
    holds = usual(model, patch, edges=vary == "net" and not named)
    return tuple(one for one in holds if isinstance(one.place, str)) if named else holds


def _read(texts: Sequence[str]) -> tuple[Hold, ...]:
    return tuple(hold(text) for text in ([texts] if isinstance(texts, str) else texts))


def _energies(patch: Patch) -> dict[str, float]:
    return {name: measured(patch.surface, name) for name in ENERGIES}


def _fairest(
    first: Patch, name: str, vary: Vary, holds: Sequence[Hold], within: float | None, only: Sequence[str]
) -> tuple[Patch, tuple[str, ...]]:
    """Return the fairest patch, and what to tell."""

    def near(patch: Patch) -> bool:
        return within is None or deviation(first, patch) <= BETWEEN * within

    if vary != "shape":
        _ = affine(first)  # refuses what has no net
        if within is None and not only and sum(isinstance(one.place, str) for one in holds) < 4:
            raise ValueError("within: expected a largest deviation where not all four sides are held; give one")
    if vary == "net":
        return _by_net(first, first, name, holds, near, only)
    free = _free_shape(first, holds)
    if not free and vary == "shape":
        raise ValueError(
            f'patch "{first.name}": what is held ({", ".join(map(str, holds)) or "nothing"}) leaves no shape parameter '
            "free; hold fewer sides or vary the net"
        )
    notes = tuple(f"{key} stays: it moves what is held" for key in first.definition.ranges if key not in free)
    if vary == "shape":
        return _by_shape(first, name, free, near), notes
    best, least = first, _value(first, name)
    for _ in range(_ROUNDS):
        turned = _by_shape(best, name, free, near) if free else best
        turned, _ = _by_net(first, turned, name, holds, near, only)
        reached = _value(turned, name)
        if not reached < least:
            break
        gain, best, least = (least - reached) / least, turned, reached
        if gain < 1e-3:
            break
    return best, notes


def _value(patch: Patch, name: str) -> float:
    return measured(patch.surface, name)


# --------------------------------------------------------------------------------------------------------- the net


def _by_net(
    first: Patch,
    start: Patch,
    name: str,
    holds: Sequence[Hold],
    near: Callable[[Patch], bool],
    only: Sequence[str],
) -> tuple[Patch, tuple[str, ...]]:
    """Return the patch of least energy by its net, no farther from ``first`` than allowed."""
    of = affine(start)
    directions = _directions(of, holds, only)
    if not directions.shape[1]:
        raise ValueError(f'patch "{first.name}": what is held leaves no control point free; hold fewer sides')
    what, mass = energy(name, of), quadratic(of, 0)
    target = affine(first).values
    least = _value(start, name)
    step = _path(what, mass, of, directions, target)
    rounds = 16 if isinstance(what, Quadratic) else 10
    found = fairest_near(lambda weight: of.rebuilt(step(weight)), near, rounds)
    if not (near(found) and _value(found, name) < least):
        return start, ("nothing fairer is within what is held and allowed",)
    return found, ()


def _directions(of: Affine, holds: Sequence[Hold], only: Sequence[str]) -> FloatArray:
    """Return a basis (p, q) of the changes of free coordinates, or of those named, that keep what is held."""
    if not only:
        return free_directions(of, holds)
    chosen = chosen_by(of.patch, only)
    kept = kept_directions(of, holds, chosen)
    result: FloatArray = np.zeros((len(of.values), kept.shape[1]))
    result[chosen] = kept
    return result


def _path(
    what: Energy, mass: Quadratic, of: Affine, directions: FloatArray, target: FloatArray
) -> Callable[[float], FloatArray]:
    """Return the minimum of energy + λ distance², a function of λ relative to the scales of both."""
    linalg: Any = import_module("scipy.linalg")  # takes long; its types are open
    x0 = of.values
    z_mass = directions.T @ mass.form @ directions
    form = what.form if isinstance(what, Quadratic) else quadratic(of, 2).form
    z_form = directions.T @ form @ directions
    scale = np.trace(z_form) / np.trace(z_mass)
    back = directions.T @ mass.form @ (target - x0)

    if isinstance(what, Quadratic):
        pull = -directions.T @ (0.5 * what.value(x0)[1])

        def solved(weight: float) -> FloatArray:
            z = linalg.cho_solve(linalg.cho_factor(z_form + weight * scale * z_mass), pull + weight * scale * back)
            return x0 + directions @ z

        return solved

    # Thin-plate energy is the bending energy of a nearly flat patch in good parameters: its root makes steps even.
    lower: FloatArray = np.asarray(np.linalg.cholesky(z_form + 1e-9 * scale * z_mass), dtype=np.float64)
    unit = max(what.value(x0)[0], 1.0) / scale  # of the distance, so that λ means the same
    size = float(np.sqrt(np.trace(z_mass) / len(z_mass))) or 1.0

    def bent(weight: float) -> FloatArray:
        def objective(y: FloatArray) -> tuple[float, FloatArray]:
            z = linalg.solve_triangular(lower.T, y, lower=False)
            x = x0 + directions @ z
            value, gradient = what.value(x)
            away = z_mass @ z - back
            value += weight * scale * unit * float(z @ z_mass @ z - 2.0 * back @ z) / size**2
            slope = directions.T @ gradient + 2.0 * weight * scale * unit * away / size**2
            if not (np.isfinite(value) and np.isfinite(slope).all()):
                return np.inf, np.zeros_like(y)
            return value, linalg.solve_triangular(lower, slope, lower=True)

        done = _minimize()(
            objective, np.zeros(len(lower)), jac=True, method="L-BFGS-B", options={"maxiter": 120, "maxcor": 30}
        )
        return x0 + directions @ linalg.solve_triangular(lower.T, done.x, lower=False)

    return bent


# ------------------------------------------------------------------------------------------------ shape parameters


def _free_shape(patch: Patch, holds: Sequence[Hold]) -> list[str]:
    """Return the shape parameters that leave the held sides and points where they are."""
    before = [held_at(patch.surface, one) for one in holds]
    free: list[str] = []
    for name, known_range in patch.definition.ranges.items():
        value = patch.definition.parameters[name]
        low, high = known_range.low, known_range.high
        other = low + 0.375 * (high - low) if value > 0.5 * (low + high) else low + 0.625 * (high - low)
        moved = patch.with_parameters({name: other})
        shift = [np.abs(held_at(moved.surface, one) - old).max() for one, old in zip(holds, before, strict=True)]
        if all(step <= _SAME * patch.surface.size for step in shift):
            free.append(name)
    return free


def _by_shape(start: Patch, name: str, free: Sequence[str], near: Callable[[Patch], bool]) -> Patch:
    """Return the patch of least energy by some of its shape parameters, as far as it may deviate."""
    ranges = [(start.definition.ranges[key].low, start.definition.ranges[key].high) for key in free]
    here = np.array([start.definition.parameters[key] for key in free])
    least = _value(start, name)
    if not np.isfinite(least):
        least = np.inf

    def shaped(values: FloatArray) -> Patch:
        return start.with_parameters(dict(zip(free, values.tolist(), strict=True)))

    def objective(values: FloatArray) -> float:
        value = _value(shaped(values), name)
        return value if np.isfinite(value) else 1e300

    inner = [(low + 1e-6 * (high - low), high) for low, high in ranges]
    done = _minimize()(objective, np.clip(here, *np.array(inner).T), bounds=inner, method="L-BFGS-B")
    share = 1.0
    for _ in range(30):
        tried = shaped(here + share * (np.asarray(done.x) - here))
        if near(tried) and _value(tried, name) < least:
            return tried
        share *= 0.7
    return start


def _minimize() -> Any:
    return import_module("scipy.optimize").minimize  # takes long; its types are open
