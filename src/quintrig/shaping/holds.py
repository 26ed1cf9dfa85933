"""What of a patch stays as it is while the rest of it moves: sides to an order, points, tangents."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.multipatch.boundary import SIDES
from quintrig.shaping.derivatives import Affine
from quintrig.support.arrays import FloatArray

ORDERS = ("G0", "G1", "G2", "G3")


@dataclass(frozen=True)
class Hold:
    """A side such as ``u1``, or a point (u, v), held with its derivatives up to an order."""

    place: str | tuple[float, float]
    order: int

    def __str__(self) -> str:
        """Return it as it is typed, such as ``u1:G2``."""
        place = self.place if isinstance(self.place, str) else ",".join(f"{x:g}" for x in self.place)
        return f"{place}:{ORDERS[self.order]}"

    def rows(self, of: Affine) -> FloatArray:
        """Return what is kept, linear in the free coordinates: a matrix (rows, p)."""
        if isinstance(self.place, str):
            axis, end = ("uv".index(self.place[0]), float(self.place[1]))
            functions = of.functions(axis, end, self.order)
            return np.einsum(("an,nmkp->amkp", "am,nmkp->ankp")[axis], functions, of.matrix).reshape(
                -1, of.matrix.shape[-1]
            )
        fu, fv = (of.functions(axis, self.place[axis], self.order) for axis in (0, 1))
        both = [(a, b) for a in range(self.order + 1) for b in range(self.order + 1 - a)]
        return np.concatenate([np.einsum("n,m,nmkp->kp", fu[a], fv[b], of.matrix) for a, b in both])


def hold(text: str) -> Hold:
    """Return what a text names: ``u0``, ``v1:G1``, ``0.5,0.25`` or ``0.5,0.25:G1``; ValueError for anything else."""
    place, _, order = text.strip().partition(":")
    expected = f"hold {text!r}: expected a side ({', '.join(SIDES)}) or u,v, with :G0 to :G3 after it if you like"
    if order and order not in ORDERS:
        raise ValueError(expected)
    level = ORDERS.index(order) if order else 0
    if place in SIDES:
        return Hold(place, level)
    try:
        u, v = (float(part) for part in place.split(","))
    except ValueError:
        raise ValueError(expected) from None
    if not (0.0 <= u <= 1.0 and 0.0 <= v <= 1.0):
        raise ValueError(f"hold {text!r}: expected u and v from 0 to 1")
    return Hold((u, v), level)


def usual(model: Model, patch: str, *, edges: bool) -> tuple[Hold, ...]:
    """Return what is held if nothing is said: seams with neighbours to their order; all sides, or else all corners."""
    orders = dict.fromkeys(SIDES, 0) if edges else {}
    for join in model.joins() if len(model.patches) > 1 else ():
        for end in (join.first, join.second):
            if end.patch == patch and end.side in SIDES and join.order in ORDERS:
                orders[end.side] = max(orders.get(end.side, 0), ORDERS.index(join.order))
    corners = () if edges else tuple(Hold((u, v), 0) for u in (0.0, 1.0) for v in (0.0, 1.0))
    return (*(Hold(side, order) for side, order in orders.items()), *corners)


def held_at(surface: Surface, one: Hold) -> FloatArray:
    """Return what is held, at nine points of a side or at the point: points and derivatives, (rows, 3) each."""
    t = np.linspace(0.0, 1.0, 9)
    if isinstance(one.place, str):
        end = float(one.place[1])
        u, v = (end, t) if one.place[0] == "u" else (t, end)
    else:
        u, v = one.place
    partials = surface.partials(u, v, one.order)
    return np.stack([partials[a, b] for a in range(one.order + 1) for b in range(one.order + 1 - a)])


def kept_directions(of: Affine, holds: Sequence[Hold], chosen: NDArray[np.int64]) -> FloatArray:
    """Return a basis (chosen, q) of the changes of some free coordinates that leave what is held, single ones first."""
    if not holds:
        return np.eye(len(chosen))
    rows = np.concatenate([one.rows(of) for one in holds])[:, chosen]
    rows = rows / (np.abs(rows).max() or 1.0)
    single = np.abs(rows).max(axis=0, initial=0.0) <= 1e-10
    _, sizes, vectors = np.linalg.svd(rows[:, ~single])
    others = vectors[int((sizes > 1e-10).sum()) :].T
    result: FloatArray = np.zeros((len(chosen), int(single.sum()) + others.shape[1]))
    result[np.flatnonzero(single), np.arange(int(single.sum()))] = 1.0
    result[~single, int(single.sum()) :] = others
    return result


def free_directions(of: Affine, holds: Sequence[Hold]) -> FloatArray:
    """Return an orthonormal basis (p, q) of the changes of free coordinates that move the net, but not what is held."""
    matrix = of.matrix.reshape(-1, len(of.values))
    _, sizes, vectors = np.linalg.svd(matrix, full_matrices=False)
    moving = vectors[
        sizes > 1e-10 * sizes[0]
    ].T  # a swept surface stands still where its curves shift against each other
    if not holds:
        return moving
    rows = np.concatenate([one.rows(of) for one in holds])
    rows = rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), np.finfo(float).tiny)
    _, sizes, vectors = np.linalg.svd(rows @ moving)
    return moving @ vectors[int((sizes > 1e-10).sum()) :].T
