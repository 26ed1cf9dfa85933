"""Developable strips joined by their control planes, so that both stay developable."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from quintrig.model.patch import Patch
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError

_RATIOS = np.geomspace(0.1, 10.0, 201)


@dataclass(frozen=True, eq=False)
class AttachedStrip:
    """The second strip, moved; the ratio κ, and how far its planes have moved (of a unit)."""

    patch: Patch
    ratio: float
    moved: float
    notes: tuple[str, ...]


def attach_strip(one: Patch, side1: str, two: Patch, side2: str, level: int, ratio: float | None) -> AttachedStrip:
    """Return the second strip with its first planes and its bounds set so that it joins the first along a ruling.

    L0' = ρ L5; L1' = σ L5 + ρ λ (L5 - L4), λ = κ (4 + ζ) / (4 + α'); L2' = ρ κ² L3 + a L4 + b L5. G0 needs the same
    ruling, which is what G1 needs too. Raises ModelError for anything but two rulings, up to G2.
    """
    if one.kind != "developable":
        raise ModelError(
            f"{two.name}:{side2}: a developable strip joins another one only, along a ruling; found a {one.kind}"
        )
    for patch, side in ((one, side1), (two, side2)):
        if side not in ("u0", "u1"):
            raise ModelError(f"{patch.name}:{side}: developable strips join along rulings: u0 or u1")
    if level > 2:
        raise ModelError(f"{two.name}:{side2}: developable strips join to G1 or G2, not G{level}")
    planes, zeta = _towards(one, side1)
    own, alpha = _from(two, side2)
    if zeta == -4.0 or alpha == -4.0:
        raise ModelError(
            f"{two.name}:{side2}: with a shape parameter of -4 at the seam the planes stand still; change it"
        )
    candidates = _RATIOS if ratio is None else np.array([ratio])
    best = min(
        ((*_solved(planes, own, zeta, alpha, float(k), level), float(k)) for k in candidates), key=lambda x: x[1]
    )
    moved, cost, kappa = best
    keys: dict[str, Any] = two.definition.model_dump(exclude_defaults=True)
    ordered = moved if side2 == "u0" else moved[::-1]
    bounds, own_bounds = (patch.definition.model_dump()["bounds"] for patch in (one, two))
    notes = () if bounds == own_bounds else (f"{two.name}: cut by the bounding planes of {one.name}",)
    keys |= {"kind": two.kind, "planes": ordered.tolist(), "bounds": [list(plane) for plane in bounds]}
    return AttachedStrip(two.rebuilt(**keys), kappa, cost, notes)


def _towards(patch: Patch, side: str) -> tuple[FloatArray, float]:
    """Return the control planes so that the last is at the side, and the shape parameter there."""
    planes, (alpha, zeta) = np.array(patch.definition.model_dump()["planes"], dtype=np.float64), patch.shape
    return (planes, zeta) if side == "u1" else (planes[::-1], alpha)


def _from(patch: Patch, side: str) -> tuple[FloatArray, float]:
    planes, (alpha, zeta) = np.array(patch.definition.model_dump()["planes"], dtype=np.float64), patch.shape
    return (planes, alpha) if side == "u0" else (planes[::-1], zeta)


def _solved(
    planes: FloatArray, own: FloatArray, zeta: float, alpha: float, kappa: float, level: int
) -> tuple[FloatArray, float]:
    """Return the second strip's planes for a ratio, and how far they have moved, measured in planes of unit size."""
    last, before, third = planes[5], planes[4], planes[3]
    rate = kappa * (4.0 + zeta) / (4.0 + alpha)
    zero = np.zeros(4)
    columns = [
        np.concatenate([last, rate * (last - before), kappa**2 * third]),
        np.concatenate([zero, last, zero]),
        np.concatenate([zero, zero, before]),
        np.concatenate([zero, zero, last]),
    ]
    rows, used = (12, 4) if level == 2 else (8, 2)
    basis = np.stack(columns[:used], axis=-1)[:rows]
    sizes = np.repeat(np.linalg.norm(own[: rows // 4], axis=-1), 4)
    free = np.linalg.lstsq(basis / sizes[:, None], own[: rows // 4].ravel() / sizes, rcond=None)[0]
    if free[0] <= 0.0:
        free[0] = 1e-3  # the planes would turn back
    result = own.copy()
    result[: rows // 4] = (basis @ free).reshape(-1, 4)
    return result, float(np.linalg.norm((result - own)[: rows // 4].ravel() / sizes))
