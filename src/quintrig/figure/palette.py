"""Colours: maps for real quantities, fixed colours for classes, and the limits between which a map is stretched.

All sets were checked for the three kinds of colour blindness. Red is positive and blue negative wherever there is a
sign. Like shapes have like hues in every classification: warm for the peak, dome and cap family, mint for saddles,
blue for the pit, bowl and cup family.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.colors import Colormap, LinearSegmentedColormap, to_rgb

from quintrig.quantities.table import Quantity
from quintrig.support.arrays import FloatArray
from quintrig.support.tolerance import SAME_COLOUR

UNDEFINED = "#7d7d7d"
"""Grey of NaN, infinity and class code 0; nothing else is drawn in it."""

INK = "#262626"
"""Text and lines."""

REGRESSION = "#c2007a"
"""The edge of regression of a developable."""

FRONT, BACK = "#9dc3e0", "#e8c793"
"""Uncoloured surface: the side that the normal points out of, and the other."""

SERIES = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#a6761d")
"""Distinct colours for lines and for surfaces laid over each other (Okabe and Ito 2008, the yellow left out)."""

_FLAT = "#f2f0ea"
_NEVER = "#000000"
_CAP, _PEAK, _RIDGE, _SADDLE_RIDGE = "#7f1d0f", "#d9541e", "#f5a623", "#fbe26a"
_CUP, _PIT, _VALLEY, _SADDLE_VALLEY = "#08306b", "#2166ac", "#56a0d3", "#a6d8f0"
_SADDLE = "#5fd99a"

_SIGNS = (
    UNDEFINED,
    _PEAK,
    _RIDGE,
    _SADDLE_RIDGE,
    _NEVER,
    _FLAT,
    _SADDLE,
    _PIT,
    _VALLEY,
    _SADDLE_VALLEY,
)

CLASS_COLOURS: dict[str, tuple[str, ...]] = {
    "point_type": (UNDEFINED, _PEAK, _SADDLE, _RIDGE, _FLAT, _CAP),
    "hk_type": _SIGNS,
    "shape_class": (
        UNDEFINED,
        _CUP,
        _PIT,
        _VALLEY,
        _SADDLE_VALLEY,
        _SADDLE,
        _SADDLE_RIDGE,
        _RIDGE,
        _PEAK,
        _CAP,
        _FLAT,
    ),
    "invariant_type": _SIGNS,
}
"""Colour of each code of each classification."""

DIVERGING: Colormap = LinearSegmentedColormap.from_list(
    "quintrig_diverging",
    ["#12406f", "#2f78b3", "#7fb4d6", "#c9dfec", "#f6f4ef", "#f8d3bf", "#ea9a79", "#c9483f", "#821226"],
).with_extremes(bad=UNDEFINED)

SEQUENTIAL: Colormap = LinearSegmentedColormap.from_list(
    "quintrig_sequential",
    ["#f3f1d8", "#c9dfae", "#86c49d", "#4aa29a", "#2f7d92", "#2c5784", "#2e2f63"],
).with_extremes(bad=UNDEFINED)


@dataclass(frozen=True)
class Limits:
    """The values at the ends of a colour map, and the shares of the finite values ``below`` and ``above`` them."""

    low: float
    high: float
    below: float = 0.0
    above: float = 0.0

    @property
    def clipped_share(self) -> float:
        """Share of the finite values beyond the ends, 0 to 1; they are drawn in the colours of the ends."""
        return self.below + self.above


def colour_map(quantity: Quantity) -> Colormap:
    """Return the map of a real quantity: diverging for one with a sign, sequential for one without."""
    return DIVERGING if quantity.colour == "diverging" else SEQUENTIAL


def limits(values: Sequence[FloatArray] | FloatArray, quantity: Quantity, scale: float = 0.0) -> Limits:
    """Return limits that a few extreme values do not spoil, common to all arrays given.

    They hold the 2nd to the 98th percentile, all values where the rest is near; with a sign they are centred on zero.
    ``scale`` is the natural size of the quantity (``field.natural_scale``): what is within 1e-9 of it is rounding,
    and the limits are wide enough to draw it in one colour. The shape index always has [-1, 1]. NaN and infinities
    are left out.
    """
    arrays = [values] if isinstance(values, np.ndarray) else list(values)
    flat = np.concatenate([array.reshape(-1) for array in arrays]) if arrays else np.zeros(0)
    flat = flat[np.isfinite(flat)]
    if quantity.key == "shape_index":
        return Limits(-1.0, 1.0)
    if not flat.size:
        return Limits(-1.0, 1.0) if quantity.colour == "diverging" else Limits(0.0, 1.0)
    low, high = _centred(flat, scale) if quantity.colour == "diverging" else _ranged(flat, scale)
    return Limits(low, high, float(np.mean(flat < low)), float(np.mean(flat > high)))


def between(values: FloatArray, low: float, high: float) -> Limits:
    """Return limits chosen by hand, with the shares of the finite values that are beyond them."""
    flat = values[np.isfinite(values)]
    if not flat.size:
        return Limits(low, high)
    return Limits(low, high, float(np.mean(flat < low)), float(np.mean(flat > high)))


def real_colours(values: FloatArray, quantity: Quantity, stretch: Limits) -> FloatArray:
    """Return the colours of values, shape (*values.shape, 3); grey where they are not finite."""
    share = (np.clip(values, stretch.low, stretch.high) - stretch.low) / (stretch.high - stretch.low)
    rgba = colour_map(quantity)(np.ma.masked_invalid(np.where(np.isfinite(values), share, np.nan)))
    return np.asarray(rgba, dtype=np.float64)[..., :3]


def class_colours(codes: np.ndarray[tuple[int, ...], np.dtype[np.int8]], key: str) -> FloatArray:
    """Return the colours of the codes of a classification, shape (*codes.shape, 3)."""
    table = np.array([to_rgb(colour) for colour in CLASS_COLOURS[key]])
    return table[codes.astype(np.intp)]


def _centred(values: FloatArray, scale: float) -> tuple[float, float]:
    size = np.abs(values)
    small, large = (float(x) for x in np.percentile(size, (2.0, 98.0)))
    bound = _reach(large, float(size.max()))
    if large - small <= 0.02 * large:
        bound *= 1.5  # constant: a clear colour, but not the one of the end
    if bound <= SAME_COLOUR * scale or bound == 0.0:
        bound = scale if scale > 0.0 else 1.0
    return -bound, bound


def _ranged(values: FloatArray, scale: float) -> tuple[float, float]:
    low, high = float(np.percentile(values, 2.0)), float(np.percentile(values, 98.0))
    middle = 0.5 * (low + high)
    low = middle - _reach(middle - low, middle - float(values.min()))
    high = middle + _reach(high - middle, float(values.max()) - middle)
    if low >= 0.0 and low <= 0.4 * high:
        low = 0.0  # zero means something (flat, level, degenerate), so let it be seen
    least = max(0.02 * abs(middle), SAME_COLOUR * scale)
    if high - low >= least and high > low:
        return low, high
    # Constant to rounding: one colour from the middle of the map.
    if abs(middle) <= SAME_COLOUR * scale or middle == 0.0:
        return 0.0, scale or 1.0
    half = 0.5 * abs(middle)
    return middle - half, middle + half


def _reach(robust: float, extreme: float) -> float:
    """Return the extreme where it is hardly beyond the robust end, else the robust end."""
    return extreme if extreme <= 1.5 * robust else robust
