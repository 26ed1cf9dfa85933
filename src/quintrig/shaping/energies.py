"""Energies that a fair surface has little of, with their gradients by the free coordinates.

- ``thin_plate``: ∫∫ |S_uu|² + 2 |S_uv|² + |S_vv|² du dv, length², a quadratic form in the net.
- ``variation``: ∫∫ |S_uuu|² + 3 |S_uuv|² + 3 |S_uvv|² + |S_vvv|² du dv, length², likewise: how bending changes.
- ``bending``: ∫∫ κ1² + κ2² dA, a pure number: that of the shape alone, whatever its parameters (Willmore's, but for a
  multiple of the total curvature).
"""

from dataclasses import dataclass
from math import comb

import numpy as np

from quintrig.geometry.surface import Surface
from quintrig.shaping.derivatives import FIRST_AND_SECOND, Affine, at_grid, by_net
from quintrig.shaping.forms import forms, pulled_back
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import nearest
from quintrig.support.legendre import legendre

ENERGIES = ("thin_plate", "bending", "variation")
"""The names of the energies."""

ORDER = {"thin_plate": 2, "variation": 3}
_NODES = 16
"""Of Gauss on a span: squares of the quintic functions, trigonometric of order 10, are integrated to rounding."""

_NODES_OF_BENDING = 32


def known(name: str) -> str:
    """Return the name of an energy as it stands above, hyphens allowed; ValueError for what is none."""
    found = name.replace("-", "_")
    if found not in ENERGIES:
        raise ValueError(f"energy: expected one of {', '.join(ENERGIES)}, found {name!r}{nearest(found, ENERGIES)}")
    return found


def measured(surface: Surface, name: str) -> float:
    """Return an energy of any surface by Gauss's nodes; not finite where it has no tangent plane and bends."""
    name = known(name)
    (u, wu), (v, wv) = (nodes(surface.breaks(axis), _NODES_OF_BENDING) for axis in (0, 1))
    order = ORDER.get(name, 2)
    partials = surface.local_partials(u[:, None], v, order)
    weights = wu[:, None] * wv
    if name != "bending":
        squares = (partials**2).sum(axis=-1)
        return float(sum(comb(order, a) * (weights * squares[a, order - a]).sum() for a in range(order + 1)))
    at = forms(np.stack([partials[a, b] for a, b in FIRST_AND_SECOND]))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return float((weights * (at.mean**2 - 2.0 * at.gauss * at.area2) * at.area2**-2.5).sum())


@dataclass(frozen=True, eq=False)
class Quadratic:
    """An energy xᵀQx + 2 cᵀx + d of the free coordinates x (p,) of a patch."""

    form: FloatArray
    linear: FloatArray
    constant: float

    def value(self, x: FloatArray) -> tuple[float, FloatArray]:
        """Return the energy and its gradient (p,)."""
        slope = self.form @ x + self.linear
        return float(x @ (slope + self.linear)) + self.constant, 2.0 * slope


@dataclass(frozen=True, eq=False)
class Bending:
    """∫∫ κ1² + κ2² dA of the free coordinates x (p,) of a patch, by Gauss's nodes in u and v."""

    of: Affine
    fu: FloatArray
    fv: FloatArray
    weights: FloatArray

    def value(self, x: FloatArray) -> tuple[float, FloatArray]:
        """Return the energy and its gradient (p,); not finite where the surface has no tangent plane."""
        at = forms(at_grid(self.of.net(x), self.fu, self.fv))
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            power = at.area2**-2.5
            total = at.mean**2 - 2.0 * at.gauss * at.area2
            value = float((self.weights * total * power).sum())
            gradient = pulled_back(
                at,
                self.weights * -2.0 * at.area2 * power,
                self.weights * 2.0 * at.mean * power,
                self.weights * (-2.0 * at.gauss * power - 2.5 * total * power / at.area2),
            )
        return value, by_net(self.fu, self.fv, gradient).ravel() @ self.of.matrix.reshape(-1, len(x))


Energy = Quadratic | Bending


def energy(name: str, of: Affine) -> Energy:
    """Return an energy of a patch by name; ValueError for an unknown name."""
    name = known(name)
    if name == "bending":
        (u, wu), (v, wv) = (nodes(of.breaks(axis), _NODES_OF_BENDING) for axis in (0, 1))
        return Bending(of, of.functions(0, u, 2), of.functions(1, v, 2), wu[:, None] * wv)
    return quadratic(of, ORDER[name])


def quadratic(of: Affine, order: int) -> Quadratic:
    """Return Σ C(k, a) ∫∫ |∂^k S / ∂u^a ∂v^(k-a)|² du dv of the free coordinates, k = ``order``.

    Order 0 gives ∫∫ |S|² du dv, order 2 ``thin_plate``, order 3 ``variation``.
    """
    u, v = (_gram(of, axis, order) for axis in (0, 1))
    still = of.net(np.zeros_like(of.values))  # what stays where a mirror lies off the origin

    def weighted(net: FloatArray) -> FloatArray:
        return sum(
            comb(order, a) * np.einsum("nN,mM,NMk...->nmk...", u[a], v[order - a], net, optimize=True)
            for a in range(order + 1)
        )  # pyright: ignore[reportReturnType]

    form = np.einsum("nmkp,nmkq->pq", of.matrix, weighted(of.matrix), optimize=True)
    linear = np.einsum("nmkp,nmk->p", of.matrix, weighted(still), optimize=True)
    return Quadratic(0.5 * (form + form.T), linear, float((still * weighted(still)).sum()))


def _gram(of: Affine, axis: int, order: int) -> list[FloatArray]:
    """Return ∫ f^(k) f^(k)ᵀ for k = 0, ..., order."""
    t, weights = nodes(of.breaks(axis), _NODES)
    return [np.einsum("t,ti,tj->ij", weights, f, f) for f in of.functions(axis, t, order)]


def nodes(breaks: FloatArray, count: int) -> tuple[FloatArray, FloatArray]:
    """Return Gauss's nodes and weights on every span between breaks."""
    x, w = legendre(count)
    low, width = breaks[:-1, None], np.diff(breaks)[:, None]
    return (low + width * (x + 1.0) / 2.0).ravel(), (width * w / 2.0).ravel()
