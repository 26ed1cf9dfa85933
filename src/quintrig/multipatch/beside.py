"""What a join is to leave as it is: the other seams of the patch that moves, and the ratio along a line of patches."""

from collections.abc import Iterator

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.multipatch.boundary import SIDES
from quintrig.multipatch.find import joins_of
from quintrig.multipatch.joins import End, Join
from quintrig.multipatch.match import Condition, derivatives_across
from quintrig.support.arrays import FloatArray

_MET = 1e-8  # residual, of the larger patch, up to which a condition counts as met
_WHOLE = 1e-6  # of a side that may be missing at its ends
_T: FloatArray = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 17))


def seams_beside(model: Model, patch: Patch, side: str) -> dict[str, Condition]:
    """Return by name the conditions that other sides of a patch meet already, each to the highest order that holds."""
    found: dict[str, Condition] = {}
    for lead, own, reverse in _neighbours(model, patch.name):
        if own != side:
            condition = _measured(model.patch(lead[0]).surface, lead[1], patch.surface, own, reverse)
            found |= {f"{':'.join(lead)} and {patch.name}:{own}": condition} if condition else {}
    return found


def broken(stay: dict[str, Condition], patch: Patch) -> list[str]:
    """Return the names of those conditions that a patch, moved, does not meet any more."""
    lost: list[str] = []
    for name, one in stay.items():
        now = _measured(one.surface, one.side, patch.surface, one.own_side, one.reverse)
        if now is None or now.order < one.order:
            lost.append(name)
    return lost


def ratio_along(model: Model, patch: Patch, side: str) -> float | None:
    """Return κ of a seam that this side goes on from, across the patch's neighbours; None where there is none.

    Four patches meet smoothly at a corner only where κ is the same along the whole line.
    """
    for lead, own, _ in _neighbours(model, patch.name):
        if SIDES.index(own) // 2 == SIDES.index(side) // 2:
            continue
        corner = _corner(patch.surface, side, own)
        beside = model.patch(lead[0])
        for there, mine, reverse in _neighbours(model, beside.name):
            if SIDES.index(mine) // 2 == SIDES.index(lead[1]) // 2:
                continue
            apart = float(np.linalg.norm(_corner(beside.surface, mine, lead[1]) - corner))
            if apart > 1e-6 * patch.surface.size:
                continue
            found = _measured(beside.surface, mine, model.patch(there[0]).surface, there[1], reverse)
            if found and found.order > 0:
                return found.ratio
    return None


def _neighbours(model: Model, name: str) -> Iterator[tuple[tuple[str, str], str, bool]]:
    """Give patch and side that meet a whole side of this patch, that side, and whether it runs the other way."""
    for seam in joins_of(model, of=(name,)):
        if seam.order != "open" and _whole(seam):
            for lead, own in ((seam.first, seam.second), (seam.second, seam.first)):
                if own.patch == name and lead.patch != name and {lead.side, own.side} <= set(SIDES):
                    yield (lead.patch, lead.side), own.side, seam.reversed


def _whole(seam: Join) -> bool:
    def all_of(end: End) -> bool:
        return end.start <= _WHOLE and end.stop >= 1.0 - _WHOLE

    return all_of(seam.first) and all_of(seam.second)


def _corner(surface: Surface, side: str, other: str) -> FloatArray:
    """Return the point in which two sides of a patch meet."""
    k, m = SIDES.index(side), SIDES.index(other)
    u, v = (k % 2, m % 2) if k < 2 else (m % 2, k % 2)
    return surface(float(u), float(v))


def _measured(first: Surface, side1: str, second: Surface, side2: str, reverse: bool) -> Condition | None:
    """Return the condition between two sides that is met, with its ratio; None where not even the points agree."""
    lead = derivatives_across(first, side1, _T, 3, outward=True)
    own = derivatives_across(second, side2, _T[::-1] if reverse else _T, 3, outward=False)
    size = max(first.size, second.size)
    square = float((lead[1] ** 2).sum())
    kappa = float((own[1] * lead[1]).sum()) / square if square > 0.0 else 0.0
    if np.abs(own[0] - lead[0]).max() > _MET * size:
        return None
    if not kappa > 0.0:
        return Condition(first, side1, side2, 0, reverse, 1.0)
    second_left = own[2] - kappa**2 * lead[2]
    mu = float((second_left * lead[1]).sum()) / square
    third_left = own[3] - kappa**3 * lead[3] - 3.0 * kappa * mu * lead[2]
    nu = float((third_left * lead[1]).sum()) / square
    left = (own[1] - kappa * lead[1], second_left - mu * lead[1], third_left - nu * lead[1])
    met = [bool(np.abs(rest).max() <= _MET * np.pi**k * size) for k, rest in enumerate(left, 1)]
    order = next((k for k, reached in enumerate(met) if not reached), 3)
    return Condition(first, side1, side2, order, reverse, kappa)
