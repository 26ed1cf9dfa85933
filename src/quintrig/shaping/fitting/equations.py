"""The normal equations of a fit in the net and the shape parameters, with thin-plate energy beside the distances."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.basis.functions import Functions
from quintrig.shaping.fitting import gram_jit
from quintrig.shaping.fitting.forms import Form
from quintrig.support.arrays import FloatArray
from quintrig.support.legendre import legendre
from quintrig.support.scipy_inside import sparse_

_LEAST_SMOOTH = 1e-9
"""Thin-plate energy beside the distances, of their weight: it decides only where no point does."""


_TELLING, _MOST_SMOOTH = 5.0, 1e-6
"""Points whose squared noise the energy counts as much as, and the most of their weight."""


@dataclass(frozen=True, eq=False)
class System:
    """Normal equations: of the net ``net``, of the shape ``shape``, ``mixed``, and the right sides."""

    net: FloatArray
    mixed: FloatArray
    shape: FloatArray
    to_net: FloatArray
    to_shape: FloatArray


def points_on(nets: FloatArray, which: NDArray[np.int64], u: Functions, v: Functions, at: FloatArray) -> FloatArray:
    """Return the points (n, 3) of patches ``which`` (n,) at their parameters (n, 2)."""
    one, other = u.derivatives(at[:, 0], 0)[0], v.derivatives(at[:, 1], 0)[0]
    result = np.empty((len(at), 3))
    for index, net in enumerate(nets):
        mine = which == index
        result[mine] = np.einsum("ni,nj,ijx->nx", one[mine], other[mine], net, optimize=True)
    return result


def system_of(
    form: Form,
    q: FloatArray,
    theta: FloatArray,
    which: NDArray[np.int64],
    at: FloatArray,
    weight: FloatArray,
    away: FloatArray,
    smooth: float,
    free: bool,
    noise: float = 0.0,
) -> System:
    """Return the normal equations of Σ rᵀ W r, r = away - the surface's change, with thin-plate energy.

    ``noise`` is the usual squared distance times its weight: what points do not tell from it, energy decides.
    """
    u, v = form.families(theta)
    n, m = form.shape
    size = n * m
    count = len(theta) if free else 0
    nets = form.nets(q)
    one, other = u.derivatives(at[:, 0], 0)[0], v.derivatives(at[:, 1], 0)[0]
    moves = _moves(form, theta, at, which, nets) if count else np.zeros((0, len(at), 3))
    blocks: list[FloatArray] = []
    mixed = np.zeros((form.patches, size, 3, count))
    to_net = np.zeros((form.patches, size, 3))
    pulled = np.einsum("nxy,ny->nx", weight, away)
    turned = np.einsum("nxy,kny->knx", weight, moves)
    for index in range(form.patches):
        mine = which == index if form.patches > 1 else slice(None)
        every = (one[mine], other[mine], weight[mine], pulled[mine], turned[:, mine])
        ways = [np.ascontiguousarray(part) for part in every]
        sums, own, both = np.zeros((6, size, size)), np.zeros((size, 3)), np.zeros((size, 3, count))
        gram_jit.gram(ways[0], ways[1], ways[2], ways[3], ways[4], np.empty(size), sums, own, both)
        to_net[index], mixed[index] = own, both
        sums += np.triu(sums, 1).transpose(0, 2, 1)
        block = np.empty((size, 3, size, 3))
        pairs = [(x, y) for x in range(3) for y in range(x, 3)]
        for (x, y), product in zip(pairs, sums, strict=True):
            block[:, x, :, y] = block[:, y, :, x] = product
        blocks.append(block.reshape(3 * size, 3 * size))
    slopes = form.slopes(q)
    key = theta.tobytes()
    if key not in form.energies:
        form.energies.clear()  # those of other shape parameters are not asked for again
        form.energies[key] = np.asarray(np.kron(_thin_plate(u, v), np.eye(3)), dtype=np.float64)
    energy = form.energies[key]
    whole = sum(float(np.trace(block)) for block in blocks) or 1.0
    unit = whole / (form.patches * float(np.trace(energy)) or 1.0)
    flat = nets.reshape(form.patches, -1)
    bending = float(((flat @ energy) * flat).sum())
    # So much energy as the surface has counts as much as the squared distances of a few points.
    usual = min(_TELLING * noise / bending, _MOST_SMOOTH * unit) if bending > 0.0 else 0.0
    factor = max(max(smooth, _LEAST_SMOOTH) * unit, usual)
    stacked = sparse_.block_diag([block + factor * energy for block in blocks], format="csr")
    bent = (factor * (flat @ energy)).ravel()
    net = np.asarray((slopes.T @ stacked @ slopes).todense())
    right = np.asarray(slopes.T @ (to_net.ravel() - bent))
    if form.kind == "swung":  # scaling r up and (x, y) down changes nothing
        net = net + 1e-10 * float(np.trace(net)) / len(net) * np.eye(len(net))
    return System(
        net,
        np.asarray(slopes.T @ mixed.reshape(3 * size * form.patches, count)),
        np.einsum("knx,lnx->kl", moves, turned),
        right,
        np.einsum("knx,nx->k", moves, pulled),
    )


def _moves(form: Form, theta: FloatArray, at: FloatArray, which: NDArray[np.int64], nets: FloatArray) -> FloatArray:
    """Return the derivatives (k, n, 3) of the points by the shape parameters; differences are exact where affine."""
    result = np.empty((len(theta), len(at), 3))
    for k, one in enumerate(form.ranges.values()):
        step = 1e-3 * (one.high - one.low)
        low, high = theta.copy(), theta.copy()
        low[k] = max(theta[k] - step, one.low + (1e-9 if one.open[0] else 0.0))
        high[k] = min(theta[k] + step, one.high - (1e-9 if one.open[1] else 0.0))
        ends = [points_on(nets, which, *form.families(value), at) for value in (low, high)]
        result[k] = (ends[1] - ends[0]) / (high[k] - low[k])
    return result


def _thin_plate(u: Functions, v: Functions) -> FloatArray:
    """Return the quadratic form of ∫∫ |S_uu|² + 2 |S_uv|² + |S_vv|² du dv in one coordinate of the net."""
    nodes, weights = legendre(16)
    t, w = 0.5 * (nodes + 1.0), 0.5 * weights
    grams = [
        [np.einsum("n,ni,nj->ij", w, d[k], d[k]) for k in range(3)] for d in (u.derivatives(t, 2), v.derivatives(t, 2))
    ]
    (a0, a1, a2), (b0, b1, b2) = grams
    pairs = ((1.0, a2, b0), (2.0, a1, b1), (1.0, a0, b2))
    both: Any = sum(w * np.einsum("ij,kl->ikjl", a, b) for w, a, b in pairs)
    return np.asarray(both).reshape(len(a0) * len(b0), -1)
