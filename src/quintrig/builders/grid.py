"""A grid of points, or a larger net, as patches that meet smoothly: tensor products of one spline in each direction."""

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.functions import Functions
from quintrig.basis.trigonometric import Trigonometric
from quintrig.builders.build import level
from quintrig.builders.hermite import energy
from quintrig.builders.rims import tensor
from quintrig.model.model import UNITS, Model
from quintrig.support.arrays import FloatArray, frozen

_LITTLE = 1e-9  # weight of the energy beside that of the points, where they are approximated
_MOST = 64  # patches in one direction


def grid_of_patches(
    points: ArrayLike,
    order: str = "G2",
    patches: tuple[int, int] | None = None,
    shape: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0),
    *,
    name: str = "grid",
    unit: str = "",
) -> Model:
    """Return a model of patches through a grid of points (n, m, 3), length¹, that meet to ``order``, G1 or G2.

    Without ``patches`` there is one between each pair of neighbouring points, and all points are met; with ``(p, q)``
    there are p x q of them, which come as near to the points as they can (least squares) and keep the corners.
    ``shape`` (α1, ζ1, α2, ζ2) is that of every patch. The bending energy is the least, by parameters that are mean
    lengths of chords. Patches are called p1_1, p1_2, ...; all ratios are constant along whole lines of patches, so that
    four of them meet smoothly at each corner (Farin 2002, §21). Raises ValueError for points that are no grid.
    """
    return gridded(points, order, patches, shape, name=name, unit=unit)[0]


def gridded(
    points: ArrayLike,
    order: str = "G2",
    patches: tuple[int, int] | None = None,
    shape: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0),
    *,
    name: str = "grid",
    unit: str = "",
) -> tuple[Model, float]:
    """Do what ``grid_of_patches`` does, and tell how far a point lies off its place, at most, length¹."""
    net = frozen(points, "points", (None, None, 3))
    k = level(order, "G2")
    if k == 0:
        raise ValueError("order: expected G1 or G2, found 'G0'")
    if unit and unit not in UNITS:
        raise ValueError(f"unit: expected one of {', '.join(UNITS)}, found {unit!r}")
    n, m = net.shape[:2]
    if n < 2 or m < 2:
        raise ValueError(f"points: expected a grid of 2 x 2 or more, found {n} x {m}")
    counts = (n - 1, m - 1) if patches is None else patches
    for count, given in zip(counts, (n, m), strict=True):
        if not 1 <= count <= min(given - 1, _MOST):
            raise ValueError(
                f"patches: expected 1 to {min(given - 1, _MOST)} for {given} points in a row, found {count}"
            )
    families = [Trigonometric(*shape[:2]), Trigonometric(*shape[2:])]
    for family in families:
        if not (family.alpha > -4.0 and family.zeta > -4.0):
            raise ValueError("shape: expected more than -4, where a patch stands still and cannot be joined")
    (along, one), (across, two) = (
        _spline(_parameters(side), count, family, k)
        for side, count, family in zip((net, net.transpose(1, 0, 2)), counts, families, strict=True)
    )
    controls = np.einsum("ain,bjm,nmx->abijx", along, across, net)
    made = [
        tensor(f"p{a + 1}_{b + 1}", families[0], families[1], controls[a, b])
        for a in range(counts[0])
        for b in range(counts[1])
    ]
    away = np.linalg.norm(np.einsum("in,jm,nmx->ijx", one, two, net) - net, axis=-1)
    return Model(name, unit, tuple(made)), float(away.max())


def _parameters(net: FloatArray) -> FloatArray:
    """Return parameters from 0 to 1 of the rows of a net, by the mean length of the chords between them."""
    chords = np.linalg.norm(np.diff(net, axis=0), axis=-1).mean(axis=1)
    if not (chords > 1e-9 * chords.max()).all() or not chords.max() > 0.0:
        k = int(np.argmin(chords))
        raise ValueError(f"points: rows {k + 1} and {k + 2} coincide; leave one of them out")
    t = np.concatenate([[0.0], np.cumsum(chords)])
    return t / t[-1]


def _spline(t: FloatArray, count: int, functions: Functions, order: int) -> tuple[FloatArray, FloatArray]:
    """Return the control points of each piece (count, size, n) from points at t, and what comes out at t, (n, n)."""
    size, whole = functions.size, count * functions.size
    borders = np.interp(np.linspace(0.0, len(t) - 1.0, count + 1), np.arange(len(t)), t)
    steps = np.diff(borders)
    ends = [functions.derivatives(x, order) for x in (0.0, 1.0)]
    smooth = np.zeros((count - 1, order + 1, whole))
    for i in range(count - 1):
        for k in range(order + 1):
            smooth[i, k, i * size : (i + 1) * size] = ends[1][k] / steps[i] ** k
            smooth[i, k, (i + 1) * size : (i + 2) * size] = -ends[0][k] / steps[i + 1] ** k
            smooth[i, k] /= np.abs(smooth[i, k]).max()
    piece = np.clip(np.searchsorted(borders, t, side="right") - 1, 0, count - 1)
    values = np.zeros((len(t), whole))
    for row, (i, x) in enumerate(zip(piece, t, strict=True)):
        place = min(max((x - borders[i]) / steps[i], 0.0), 1.0)
        values[row, i * size : (i + 1) * size] = functions.derivatives(place, 0)[0]
    bent = np.zeros((whole, whole))
    one = energy(functions, 2)
    for i in range(count):
        bent[i * size : (i + 1) * size, i * size : (i + 1) * size] = one / steps[i] ** 3
    bent /= np.trace(bent) / whole
    fixed = np.arange(len(t)) if count == len(t) - 1 else np.array([0, len(t) - 1])
    exact = np.concatenate([smooth.reshape(-1, whole), values[fixed]])
    loose = np.setdiff1d(np.arange(len(t)), fixed)
    quadratic = values[loose].T @ values[loose] + _LITTLE * bent if len(loose) else bent
    m = len(exact)
    system = np.zeros((whole + m, whole + m))
    system[:whole, :whole], system[:whole, whole:], system[whole:, :whole] = quadratic, exact.T, exact
    right = np.zeros((whole + m, len(t)))
    right[:whole, loose] = values[loose].T
    right[whole + len(smooth.reshape(-1, whole)) :, :][np.arange(len(fixed)), fixed] = 1.0
    found = np.array(np.linalg.lstsq(system, right, rcond=1e-15)[0], dtype=np.float64)
    return found[:whole].reshape(count, size, len(t)), values @ found[:whole]
