"""Nodes of a sweep's quadrature: Clenshaw-Curtis, drawn towards edges beside which a design nearly stands still.

Just above α = -4 curvature changes within a layer of width w (``layers``), as (x + w)^-p. Nodes evenly spaced in
ln(x + w), or in ln((x + w0) / (1 - x + w1)) between two layers, see nothing of that pole. Designs are sorted into
classes by powers of four of their widths, so that each depends on itself alone and classes share their nodes.
"""

from functools import cache

import numpy as np
from numpy.typing import NDArray

from quintrig.support.arrays import FloatArray
from quintrig.sweep.summarise import clenshaw_curtis

WIDEST = 1 / 40
"""Layers from this width on need no drawn nodes: 32 points err by about 1e-4 there, and less above."""

_STEP = 4.0  # of the widths of two classes
_CLASSES = 12
_MORE = 2  # times the points: those drawn to the ends would be missing elsewhere


def layer_classes(widths: FloatArray) -> NDArray[np.intp]:
    """Return the class of layers of these widths: 0 for wide and for singular ones, whose width is 0."""
    thin = (widths > 0.0) & (widths < WIDEST)
    ratio = np.where(thin, widths, 1.0) / WIDEST
    found = np.ceil(-np.log(ratio) / np.log(_STEP)).astype(np.intp)
    return np.where(thin, np.clip(found, 1, _CLASSES), 0)


@cache
def drawn_nodes(points: int, first: int, last: int) -> tuple[FloatArray, FloatArray]:
    """Return nodes on [0, 1] and weights that sum to 1, for layers of these classes at 0 and 1.

    ``points`` of them where there is no layer, else twice as many.
    """
    if not first and not last:
        return clenshaw_curtis(points)
    if not first:
        t, backwards = drawn_nodes(points, last, 0)
        return 1.0 - t[::-1], backwards[::-1]
    s, weights = clenshaw_curtis(_MORE * points)
    start, end = _width(first), _width(last)
    if not last:
        rate = np.log1p(1.0 / start)
        t, speed = start * np.expm1(rate * s), start * rate * np.exp(rate * s)
    else:
        rate = np.log1p(1.0 / start) + np.log1p(1.0 / end)
        grown = start / (1.0 + end) * np.exp(rate * s)
        t, speed = start * np.expm1(rate * s) / (1.0 + grown), (1.0 + start + end) * rate * grown / (1.0 + grown) ** 2
    t[0], t[-1] = 0.0, 1.0
    weights = weights * speed
    return t, weights / weights.sum()


def _width(number: int) -> float:
    """Return the width that nodes of a class are drawn to."""
    return 2.0 * WIDEST / _STEP**number
