"""``fair`` of a curve: the smoothest curve near a given one, by its control points."""

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib import import_module
from typing import Any

import numpy as np

from quintrig.model.model import Model
from quintrig.model.patch import NamedCurve, curve_of
from quintrig.shaping.energies import ENERGIES, ORDER, known, nodes
from quintrig.shaping.fairing import BETWEEN, Fairing, fairest_near
from quintrig.shaping.holds import ORDERS
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError


def fair_curve(
    model: Model,
    *,
    curve: str | None = None,
    energy: str = "thin_plate",
    hold: Sequence[str] | None = None,
    within: float | None = None,
    only: Sequence[str] = (),
) -> Fairing:
    """Return the model with one curve made fairer by its control points: least ``energy`` with what is held held.

    ``hold`` lists parameters that stay, to an order: ``"0"``, ``"1:G2"``, ``"0.5"``; both ends to G1 if left out.
    ``within`` bounds the deviation, length¹. ``only`` names the control points that move, such as ``points[2]``; the
    ends are free then. Raises ValueError for words that are none and where nothing is left.
    """
    named, name = model.curve(curve), known(energy)
    if within is not None and not 0.0 < within < np.inf:
        raise ValueError(f"within: expected a length greater than 0, found {within:g}")
    if named.definition.flip:
        raise ModelError(f'curve "{named.name}": expected one that is not flipped; write its points the other way')
    ends = () if only else ("0:G1", "1:G1")
    texts = ends if hold is None else tuple([hold] if isinstance(hold, str) else hold)
    family, points = named.curve.functions, named.curve.points
    rows = [family.derivatives(np.array(t), order) for t, order in map(_held, texts)]
    if named.definition.close:
        first, last = family.derivatives(np.array([0.0, 1.0]), 0)[0]
        rows.append((first - last)[None])
    if only:
        rows.append(np.delete(np.eye(len(points)), _moving(only, len(named.definition.points)), axis=0))
    stacked = np.concatenate([*rows, np.zeros((0, len(points)))])
    _, sizes, vectors = np.linalg.svd(stacked / (np.abs(stacked).max(initial=0.0) or 1.0))
    free: FloatArray = vectors[int((sizes > 1e-10).sum()) :].T
    if not free.shape[1]:
        raise ValueError(f'curve "{named.name}": what is held leaves no control point free; hold less')

    t, weights = nodes(family.breaks, 32)
    functions = family.derivatives(t, 3)
    mass = free.T @ np.einsum("t,ti,tj->ij", weights, functions[0], functions[0]) @ free
    fine = family.derivatives(np.linspace(0.0, 1.0, 257), 0)[0]

    def far(moved: FloatArray) -> float:
        return float(np.linalg.norm(fine @ (moved - points), axis=1).max())

    step = (_bent if name == "bending" else _plain)(name, functions, weights, free, mass, points)

    def near(moved: FloatArray) -> bool:
        return within is None or far(moved) <= BETWEEN * within

    found = fairest_near(step, near, 16)
    before = _energies(points, functions, weights)
    after = _energies(found, functions, weights)
    notes: tuple[str, ...] = ()
    if not (near(found) and after[name] < before[name]):
        found, after, notes = points, before, ("nothing fairer is within what is held and allowed",)
    changed = _with_points(named, found)
    curves = tuple(changed if one is named else one for one in model.curves)
    return Fairing(replace(model, curves=curves), named.name, name, before, after, far(found), texts, notes)


def _with_points(named: NamedCurve, points: FloatArray) -> NamedCurve:
    dump = named.definition.model_dump(exclude_defaults=True)
    kept = points[:-1] if named.definition.close else points
    return curve_of({**dump, "kind": "curve", "points": kept.tolist()}, named.name, None)


def _moving(only: Sequence[str], count: int) -> list[int]:
    """Return the numbers of the control points that texts name."""
    found: list[int] = []
    for text in [only] if isinstance(only, str) else only:
        part = re.fullmatch(r"\s*points\[(\d{1,6})\]\s*", text)
        if part is None or int(part[1]) >= count:
            raise ValueError(f"only: expected control points such as points[1], up to {count - 1}, found {text[:60]!r}")
        found.append(int(part[1]))
    return found


def _held(text: str) -> tuple[float, int]:
    """Return the parameter and the order that a text names."""
    place, _, order = text.strip().partition(":")
    try:
        t = float(place)
    except ValueError:
        t = np.nan
    if not 0.0 <= t <= 1.0 or (order and order not in ORDERS):
        raise ValueError(f"hold {text!r}: expected a parameter from 0 to 1, with :G0 to :G3 after it if you like")
    return t, ORDERS.index(order) if order else 0


def _energies(points: FloatArray, functions: FloatArray, weights: FloatArray) -> dict[str, float]:
    found = {key: float(weights @ ((functions[k] @ points) ** 2).sum(axis=1)) for key, k in ORDER.items()}
    return {key: found.get(key, _bending(points, functions, weights)[0]) for key in ENERGIES}


def _bending(points: FloatArray, functions: FloatArray, weights: FloatArray) -> tuple[float, FloatArray]:
    """Return ∫ |z' x z''|² / |z'|⁵ dt, and its gradient by the points; |a x b|² = |a|²|b|² - (a·b)²."""
    a, b = functions[1] @ points, functions[2] @ points
    aa, bb, ab = (a * a).sum(axis=1), (b * b).sum(axis=1), (a * b).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        power = weights * aa**-2.5
        cross = aa * bb - ab**2
        value = float((power * cross).sum())
        by_a = (power * (2.0 * bb - 5.0 * cross / aa))[:, None] * a - (2.0 * power * ab)[:, None] * b
        by_b = (2.0 * power * aa)[:, None] * b - (2.0 * power * ab)[:, None] * a
    return value, functions[1].T @ by_a + functions[2].T @ by_b


def _plain(
    name: str, functions: FloatArray, weights: FloatArray, free: FloatArray, mass: FloatArray, points: FloatArray
) -> Callable[[float], FloatArray]:
    """Return the minimum of a quadratic energy + λ distance², by λ relative to the scales of both."""
    part = functions[ORDER[name]]
    form = np.einsum("t,ti,tj->ij", weights, part, part)
    own = free.T @ form @ free
    scale = float(np.trace(own) / np.trace(mass))

    def solved(weight: float) -> FloatArray:
        z = np.asarray(np.linalg.solve(own + weight * scale * mass, free.T @ form @ points), dtype=np.float64)
        return points - free @ z

    return solved


def _bent(
    name: str, functions: FloatArray, weights: FloatArray, free: FloatArray, mass: FloatArray, points: FloatArray
) -> Callable[[float], FloatArray]:
    """Return the same for ∫κ² ds, by L-BFGS."""
    del name
    form = np.einsum("t,ti,tj->ij", weights, functions[2], functions[2])
    own: FloatArray = free.T @ form @ free
    lower: FloatArray = np.asarray(np.linalg.cholesky(own + 1e-9 * np.trace(own) * np.eye(len(own))), dtype=np.float64)
    root: FloatArray = np.asarray(np.linalg.inv(lower), dtype=np.float64).T
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    unit = max(_bending(points, functions, weights)[0], 1e-9 / size)
    shape = (free.shape[1], points.shape[1])

    def solved(weight: float) -> FloatArray:
        def objective(y: FloatArray) -> tuple[float, FloatArray]:
            z = root @ y.reshape(shape) * size
            value, gradient = _bending(points + free @ z, functions, weights)
            away = mass @ z
            value = value / unit + weight * float((z * away).sum()) / size**2
            slope = free.T @ gradient / unit + 2.0 * weight * away / size**2
            if not (np.isfinite(value) and np.isfinite(slope).all()):
                return 1e300, np.zeros_like(y)
            return value, (root.T @ slope * size).ravel()

        minimize: Any = import_module("scipy.optimize").minimize  # takes long; its types are open
        done = minimize(objective, np.zeros(shape).ravel(), jac=True, method="L-BFGS-B", options={"maxiter": 300})
        return points + free @ (root @ np.asarray(done.x, dtype=np.float64).reshape(shape) * size)

    return solved
