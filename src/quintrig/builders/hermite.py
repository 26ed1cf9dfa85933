"""Rows of control points from what is wanted at the ends of a line across: linear, and as quiet as the rest allows."""

from collections.abc import Sequence

import numpy as np

from quintrig.basis.functions import Functions
from quintrig.support.arrays import FloatArray
from quintrig.support.legendre import legendre

_NODES, _WEIGHTS = legendre(24)


def energy(functions: Functions, order: int) -> FloatArray:
    """Return the matrix (n, n) of ∫ f_i⁽ᵏ⁾ f_j⁽ᵏ⁾ dt over [0, 1], k the order."""
    values = functions.derivatives(0.5 + 0.5 * _NODES, order)[order]
    return np.einsum("q,qi,qj->ij", 0.5 * _WEIGHTS, values, values)


def quiet(conditions: FloatArray, quadratic: FloatArray) -> FloatArray:
    """Return the matrix (n, m) from right sides b to the x with ``conditions`` (m, n) x = b and least xᵀQx."""
    n, m = conditions.shape[1], len(conditions)
    scale = float(np.trace(quadratic)) / n or 1.0
    rows = np.linalg.norm(conditions, axis=1, keepdims=True)
    whole = np.zeros((n + m, n + m))
    whole[:n, :n] = quadratic / scale
    whole[:n, n:], whole[n:, :n] = (conditions / rows).T, conditions / rows
    right = np.zeros((n + m, m))
    right[n:] = np.diag(1.0 / rows[:, 0])
    return np.array(np.linalg.lstsq(whole, right, rcond=1e-14)[0][:n], dtype=np.float64)


def rows_from(functions: Functions, wanted: Sequence[tuple[float, int]], order: int) -> FloatArray:
    """Return the matrix (n, m) from derivatives wanted at (t, k) to control points, ∫|S⁽ᵒʳᵈᵉʳ⁾|² least."""
    conditions = np.stack([functions.derivatives(t, k)[k] for t, k in wanted])
    return quiet(conditions, energy(functions, order))


def going_on(functions: Functions, bent: bool) -> FloatArray:
    """Return the matrix (n, 2 or 3) from point, first and, where ``bent``, second derivative at 0 to control points.

    As near as may be to a line, or to a parabola: what the first derivative asks for of the second is left to it.
    """
    straight = rows_from(functions, [(0.0, 0), (0.0, 1)], 2)
    if not bent:
        return straight
    second = functions.derivatives(0.5 + 0.5 * _NODES, 2)[2]
    start = np.stack([functions.derivatives(0.0, k)[k] for k in range(3)])
    system = np.zeros((functions.size + 3,) * 2)
    quadratic = energy(functions, 2)
    scale = float(np.trace(quadratic)) / functions.size
    system[:-3, :-3], system[:-3, -3:], system[-3:, :-3] = quadratic / scale, start.T, start
    right = np.zeros(functions.size + 3)
    right[:-3], right[-1] = 0.5 * _WEIGHTS @ second / scale, 1.0
    column = np.array(np.linalg.lstsq(system, right, rcond=1e-14)[0][:-3], dtype=np.float64)
    return np.column_stack([straight, column])


def relaxed(nets: Sequence[FloatArray], ways: Sequence[Sequence[FloatArray]], functions: Functions) -> list[FloatArray]:
    """Return nets (n, m, 3) moved along their ways, by amounts that are the same for all nets, to the least ∫|S''|²."""
    quadratic = energy(functions, 2)
    count = len(ways[0])
    a, b = np.zeros((count, count)), np.zeros(count)
    for net, own in zip(nets, ways, strict=True):
        for i in range(count):
            b[i] -= np.einsum("imx,ij,jmx->", own[i], quadratic, net)
            for j in range(count):
                a[i, j] += np.einsum("imx,ik,kmx->", own[i], quadratic, own[j])
    amounts = np.linalg.lstsq(a, b, rcond=None)[0].tolist()
    return [
        net + sum((x * way for x, way in zip(amounts, own, strict=True)), np.zeros_like(net))
        for net, own in zip(nets, ways, strict=True)
    ]
