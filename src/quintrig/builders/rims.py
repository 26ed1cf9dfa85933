"""A side of a patch as a new patch beside it sees it: points along it, ways out of it, and the functions along it."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from quintrig.basis.bernstein import Bernstein
from quintrig.basis.functions import Functions
from quintrig.basis.trigonometric import Trigonometric
from quintrig.geometry.surface import Net
from quintrig.model.kinds.constructions import basis_keys
from quintrig.model.model import Model
from quintrig.model.patch import Patch, patch_of
from quintrig.multipatch.attach import edge_of, side_of
from quintrig.multipatch.boundary import Edge
from quintrig.multipatch.match import derivatives_across
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError
from quintrig.support.tolerance import SINGULAR

POINTS = 49
"""Points along a side at which it is looked at."""

T: FloatArray = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, POINTS))
"""Their parameters, denser to the ends."""

_ENDS = 30.0  # weight of the end points of a side in a fit
_NEARLY = 1e-9
_HELD = 1e-12  # of the size: a fit better than this is the curve itself
_DEGREES = (5, 9, 13, 17, 21, 25)
_MOST = 16  # functions along a side that a new patch takes over; a NURBS face may have hundreds


@dataclass(frozen=True, eq=False)
class Rim:
    """One side of a patch, of which ``text`` is the name as it was given, run through as the patch does."""

    text: str
    patch: Patch
    side: str
    edge: Edge

    @cached_property
    def across(self) -> FloatArray:
        """Derivatives 0 to 3 out of the patch at ``T``, (4, POINTS, 3), length¹."""
        return derivatives_across(self.patch.surface, self.side, T, 3, outward=True)

    @property
    def points(self) -> FloatArray:
        """Points of the side at ``T``, length¹."""
        return self.across[0]

    @property
    def speed(self) -> float:
        """Mean length of the first derivative out of the patch; ModelError where the patch stands still there."""
        speed = float(np.linalg.norm(self.across[1], axis=-1).mean())
        if not speed > SINGULAR * self.patch.surface.size:
            raise ModelError(
                f"{self.text}: the patch stands still across this side (a shape parameter of -4, or rows that "
                "coincide), so nothing goes on from it; change it, or take G0"
            )
        return speed

    @property
    def drift(self) -> float:
        """The mean m of S''·S' / S'·S' out of the patch: S'' - m S' bends alike, and neither hastens nor brakes."""
        first, second = self.across[1:3]
        return float((first * second).sum() / (first * first).sum())

    @cached_property
    def functions(self) -> Functions:
        """The functions along the side where a tensor-product patch can have them, else the quintic ones."""
        surface = self.patch.surface
        rows = surface.rows
        if isinstance(rows, Net) and rows.dimension == 3 and surface.net is not None:
            found = surface.blend if self.side in ("u0", "u1") else rows.functions
            if found.size <= _MOST and basis_keys((found,)) is not None:
                return found
        return Trigonometric()


def rim(model: Model, text: str) -> Rim:
    """Return the side that a text such as ``a:u1`` names; ModelError for poles, trimmed faces and unknown names."""
    patch, side = side_of(model, text)
    return Rim(text, patch, side, edge_of(patch, side))


def fitted(functions: Functions, values: FloatArray, t: FloatArray = T) -> FloatArray:
    """Return control values (size, ...) of curves through values (..., n, 3) at t: exact where the functions allow."""
    weights = np.ones_like(t)
    weights[[0, -1]] = _ENDS
    matrix = functions.derivatives(t, 0)[0] * weights[:, None]
    inverse = np.array(np.linalg.pinv(matrix, rcond=1e-13), dtype=np.float64) * weights
    return np.einsum("it,...tx->...ix", inverse, values)


def common(wanted: Sequence[Functions], values: Sequence[FloatArray]) -> tuple[Functions, bool]:
    """Return the first functions that hold all curves through values (..., n, 3) at ``T``, and whether any did.

    Where none of those wanted does, Bernstein functions of a degree high enough do, but for rounding.
    """
    size = max(float(np.ptp(one, axis=-2).max()) for one in values)
    tried: list[tuple[float, Functions]] = []
    for functions in dict.fromkeys([*wanted, *(Bernstein(degree) for degree in _DEGREES)]):
        away = max(_away(functions, one) for one in values)
        if away <= _HELD * size:
            return functions, True
        tried.append((away, functions))
    away, functions = min(tried, key=lambda one: one[0])
    return functions, away <= _NEARLY * size


def _away(functions: Functions, values: FloatArray) -> float:
    """Return how far a fit strays from the points, at most, length¹."""
    return float(np.abs(functions.derivatives(T, 0)[0] @ fitted(functions, values) - values).max())


def turned(functions: Functions) -> Functions | None:
    """Return the functions that run the other way: f_(n-i)(1 - t); None where the basis has none such."""
    if isinstance(functions, Trigonometric):
        return Trigonometric(functions.zeta, functions.alpha, functions.unchecked)
    t = np.linspace(0.0, 1.0, 9)
    values = functions.derivatives(t, 0)[0]
    return functions if np.allclose(values, values[::-1, ::-1], atol=1e-13) else None


def tensor(name: str, u: Functions, v: Functions, net: FloatArray, flip: bool = False) -> Patch:
    """Return the tensor-product patch of a net (n, m, 3) on functions in u and v."""
    keys = basis_keys((u, v)) or {}
    return patch_of({"kind": "tensor", "points": net.tolist(), "flip": flip, **keys}, name, None)


def unused(name: str, model: Model, others: Sequence[str] = ()) -> str:
    """Return the name, or with the first number behind it that no patch of the model has."""
    taken = {*(patch.name for patch in model.patches), *others}
    if name not in taken:
        return name
    return next(f"{name}{k}" for k in range(2, len(taken) + 3) if f"{name}{k}" not in taken)
