"""NURBS surfaces, as CAD files hold them: the general form in which everything rational can be analysed."""

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from quintrig.basis.bspline import BSpline, normalised
from quintrig.geometry.origin import local_origin
from quintrig.geometry.surface import Net, Surface
from quintrig.support.arrays import FloatArray, frozen

LARGEST_RATIO = 1e6
"""Largest ratio of two weights: a surface squeezed more than this by one of them counts as singular, to rounding."""

_FACTOR = f"{LARGEST_RATIO:,.0f}"


def nurbs(
    points: ArrayLike,
    weights: ArrayLike | None = None,
    degrees: Sequence[int] | None = None,
    knots: Sequence[ArrayLike] | None = None,
    *,
    flip: bool = False,
    trim: Sequence[ArrayLike] = (),
) -> Surface:
    """Return S = ΣΣ w_ij P_ij N_i(u) N_j(v) / ΣΣ w_ij N_i(u) N_j(v) (Piegl and Tiller 1997, eq. 4.11).

    ``points`` (n, m, 3), length¹; ``weights`` (n, m), positive, all 1 by default. Without ``degrees`` (p, q) and
    ``knots`` (a full knot vector each, n + p + 1 and m + q + 1 long) it is one Bézier patch. Whatever interval the
    knots span, u and v run over [0, 1]; ``trim`` holds closed loops in that square. Raises ValueError for counts or
    values that do not fit.
    """
    net = frozen(points, "points", (None, None, 3))
    n, m = net.shape[:2]
    p, q = degrees if degrees is not None else (n - 1, m - 1)
    if knots is None:
        knots = [np.repeat([0.0, 1.0], p + 1), np.repeat([0.0, 1.0], q + 1)]
    if len(knots) != 2:
        raise ValueError(f"knots: expected two knot vectors, for u and v, found {len(knots)}")
    u = _functions(knots[0], p, n, 0)
    v = _functions(knots[1], q, m, 1)
    loops = tuple(frozen(loop, f"trim[{i}]", (None, 2)) for i, loop in enumerate(trim))
    origin = local_origin(net)
    local = net - origin
    plain = Surface(Net(local, u), v, flip, net, loops, origin)
    if weights is None:
        return plain
    w = _weights(weights, n, m)
    if (w == w[0, 0]).all():
        return plain
    homogeneous: FloatArray = np.concatenate([local * w[..., None], w[..., None]], axis=-1)
    return Surface(Net(frozen(homogeneous, "points times weights"), u), v, flip, net, loops, origin)


def _weights(weights: ArrayLike, n: int, m: int) -> FloatArray:
    """Return the weights (n, m), the largest from 1 to 2: a common factor, here a power of 2, changes no point."""
    w = frozen(weights, "weights", (n, m))
    if not (w > 0.0).all():
        i, j = np.argwhere(~(w > 0.0))[0]
        raise ValueError(f"weights[{i}][{j}]: expected a number greater than 0, found {w[i, j]:g}")
    least, most = (np.unravel_index(at, w.shape) for at in (w.argmin(), w.argmax()))
    if w[most] > LARGEST_RATIO * w[least]:
        raise ValueError(
            f"weights[{least[0]}][{least[1]}]: expected weights within a factor of {_FACTOR} of each other, found "
            f"{w[least]:g} beside weights[{most[0]}][{most[1]}] = {w[most]:g}; beyond it curvature is lost to rounding"
        )
    return np.ldexp(w, 1 - int(np.frexp(w[most])[1]))


def _functions(knots: ArrayLike, degree: int, count: int, axis: int) -> BSpline:
    array = frozen(knots, f"knots[{axis}]", (None,))
    wanted = count + degree + 1
    if 1 <= degree < count and len(array) != wanted:
        raise ValueError(
            f"knots[{axis}]: expected {wanted} for {count} control points of degree {degree}, found {len(array)}"
        )
    try:
        functions = normalised(array, degree)
    except ValueError as error:
        place = re.sub("^knots|^degree(?=:)", lambda found: f"{found[0].rstrip('s')}s[{axis}]", str(error))
        raise ValueError(place) from None
    if functions.size != count:
        raise ValueError(f"degrees[{axis}]: expected at most {count - 1} for {count} control points, found {degree}")
    return functions
