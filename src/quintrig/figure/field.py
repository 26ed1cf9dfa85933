"""A quantity on a grid of a surface, ready to be coloured; its natural size, and the lines where it vanishes."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from contourpy import LineType, contour_generator
from numpy.typing import NDArray

from quintrig.analysis.sample import Sample, analyse
from quintrig.figure.palette import Limits, between, class_colours, limits, real_colours
from quintrig.figure.style import STANDARD, Style
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import Quantity, quantity
from quintrig.support.arrays import BoolArray, FloatArray
from quintrig.support.tolerance import SAME_COLOUR


@dataclass(frozen=True, eq=False)
class Field:
    """Values (n, m) of one quantity at ``u`` (n,) and ``v`` (m,), and its natural ``scale`` on the surface.

    What is within ``noise`` (n, m) of zero is rounding; ``inside`` (n, m) is false outside a trimmed face. ``shades``
    (n, m, 3) are the colours of classes, mixed where a border runs through a cell, so that borders are smooth.
    """

    quantity: Quantity
    u: FloatArray
    v: FloatArray
    values: NDArray[Any]
    scale: float
    noise: FloatArray
    inside: BoolArray
    shades: FloatArray | None = None

    @property
    def undefined(self) -> NDArray[np.bool_]:
        """True where the value is NaN or infinite, or the class is code 0."""
        undefined = self.values == 0 if self.quantity.kind == "class" else ~np.isfinite(self.values)
        return undefined & self.inside

    def colours(self, stretch: Limits | None) -> FloatArray:
        """Return RGB colours, shape (n, m, 3), of a real quantity between the limits, its own where None."""
        if self.quantity.kind == "class":
            return class_colours(self.values, self.quantity.key) if self.shades is None else self.shades
        stretch = stretch or limits(self.values, self.quantity, self.scale)
        return real_colours(self.values, self.quantity, stretch)


def field(surface: Surface, key: str, u: FloatArray, v: FloatArray, thresholds: Thresholds | None = None) -> Field:
    """Compute a quantity on the grid u (n,) x v (m,), none outside a face; ValueError for a key that has no colour."""
    q = quantity(key)
    if q.kind == "vector":
        raise ValueError(f"{key}: a vector cannot be drawn as a colour; choose a number or a class")
    sample = analyse(surface, u[:, None], v[None, :], tuple(dict.fromkeys((key, "curvedness"))), thresholds=thresholds)
    scale = natural_scale(sample, q)
    noise = np.full(sample.shape, scale)
    if q.power < 0:  # rounding grows with the curvature, as near an edge of regression
        noise = np.fmax(noise, sample["curvedness"] ** -q.power)
    inside = np.broadcast_to(surface.inside(sample.u, sample.v), sample.shape)
    values = np.where(inside, sample[key], 0 if q.kind == "class" else np.nan).astype(sample[key].dtype)
    return Field(q, u, v, values, scale, SAME_COLOUR * noise, inside)


def traced(surface: Surface, key: str, nodes: int) -> Field:
    """Return a quantity at ``nodes`` x ``nodes`` parameters between which lines are traced; those of a face span it."""
    u, v = face_grid(surface, nodes, nodes)
    return field(surface, key, u.ravel(), v.ravel())


def facet_fields(
    surfaces: Sequence[Surface],
    key: str | None,
    cells: int = 120,
    thresholds: Thresholds | None = None,
    *,
    square: bool = False,
) -> list[Field]:
    """Return the quantity at the middle of every facet of each surface; none for ``key`` None.

    A facet with an undefined corner is undefined, so that singular points on the edge are not hidden. The facets of a
    trimmed face span its loops, with ``square`` the whole domain.
    """
    if key is None:
        return []
    found: list[Field] = []
    for surface in surfaces:
        u, v = (nodes.ravel() for nodes in face_grid(surface.carrier if square else surface, cells + 1, cells + 1))
        inner = field(surface, key, 0.5 * (u[:-1] + u[1:]), 0.5 * (v[:-1] + v[1:]), thresholds)
        corner = field(surface, key, u, v, thresholds).undefined
        bad = corner[:-1, :-1] | corner[1:, :-1] | corner[1:, 1:] | corner[:-1, 1:]
        nothing = 0 if inner.quantity.kind == "class" else np.nan
        values = np.where(bad, nothing, inner.values).astype(inner.values.dtype)
        shades = _shades(surface, inner, bad, thresholds) if inner.quantity.kind == "class" else None
        found.append(Field(inner.quantity, inner.u, inner.v, values, inner.scale, inner.noise, inner.inside, shades))
    return found


def _shades(surface: Surface, inner: Field, bad: BoolArray, thresholds: Thresholds | None) -> FloatArray:
    """Return the mean colour of 4 x 4 points in each cell around those of ``inner``, that of no class where ``bad``."""
    key, (n, m) = inner.quantity.key, inner.values.shape
    offsets = np.array([-0.375, -0.125, 0.125, 0.375])
    u, v = (t[:, None] + (t[1] - t[0]) * offsets for t in (inner.u, inner.v))
    codes = analyse(surface, u.reshape(-1, 1), v.reshape(1, -1), key, thresholds=thresholds)[key]
    mixed = class_colours(codes, key).reshape(n, 4, m, 4, 3).mean(axis=(1, 3))
    mixed[bad | ~inner.inside] = class_colours(np.zeros(1, dtype=np.int8), key)[0]
    return mixed


def natural_scale(sample: Sample, q: Quantity) -> float:
    """Return the size against which rounding of a quantity is judged, in its own unit.

    1/length is the surface's largest curvedness (98th percentile), at least 1/size; length is the size. ``sample`` must
    hold the curvedness.
    """
    if q.power == 0 or not sample.size > 0.0:
        return 1.0
    if q.power > 0:
        return sample.size**q.power
    bend = sample["curvedness"]
    bend = bend[np.isfinite(bend)]
    largest = float(np.percentile(bend, 98.0)) if bend.size else 0.0
    return max(largest, 1.0 / sample.size) ** -q.power


def common_limits(fields: Sequence[Field], style: Style = STANDARD) -> Limits | None:
    """Return one stretch for all fields of one real quantity; None for classes, whose colours are fixed.

    The ends are those that the style asks for, or such that a few extreme values do not spoil them.
    """
    if not fields or fields[0].quantity.kind == "class":
        return None
    return stretched([f.values for f in fields], fields[0].quantity, style, max(f.scale for f in fields))


def stretched(arrays: Sequence[FloatArray], q: Quantity, style: Style, scale: float = 0.0) -> Limits:
    """Return the stretch of values of a real quantity, of natural size ``scale``, as ``common_limits`` does."""
    values = np.concatenate([array.reshape(-1) for array in arrays])
    finite = values[np.isfinite(values)]
    if q.key in style.scales:
        return style.scales[q.key]
    if style.limits is not None:
        found = between(values, *style.limits)
    elif style.percentiles is not None and finite.size and np.ptp(finite) > 0.0:
        found = between(values, *(float(x) for x in np.percentile(finite, style.percentiles)))
    else:
        found = limits(arrays, q, scale)
    return replace(found, colours=style.colours)


def levels_of(style: Style, stretch: Limits | None) -> tuple[float, ...]:
    """Return the values at which contour lines are drawn: those asked for, or so many between the ends of the scale."""
    if stretch is None:
        return ()
    if not isinstance(style.levels, int):
        return style.levels
    return tuple(np.linspace(stretch.low, stretch.high, style.levels + 2)[1:-1].tolist())


def changes_sign(f: Field) -> bool:
    """Tell whether a real quantity takes both signs, so that there is a line between them."""
    signed = _signed(f)
    return bool(np.any(signed < 0.0) and np.any(signed > 0.0))


def zero_lines(f: Field) -> list[FloatArray]:
    """Return the lines (n, 2) in (u, v) where a real quantity changes its sign; none where it is only rounding."""
    if not changes_sign(f):
        return []
    return _lines(f, _signed(f), 0.0)


def level_lines(f: Field, level: float) -> list[FloatArray]:
    """Return the lines (n, 2) in (u, v) where a real quantity has a value."""
    return _lines(f, np.asarray(f.values, dtype=np.float64), level)


def _lines(f: Field, values: FloatArray, level: float) -> list[FloatArray]:
    masked = np.ma.masked_invalid(np.where(np.isfinite(values), values, np.nan))
    drawn = contour_generator(f.v, f.u, masked, line_type=LineType.Separate).lines(level)
    return [np.asarray(line, dtype=np.float64)[:, ::-1] for line in drawn]


def _signed(f: Field) -> FloatArray:
    """Return the values, with a zero that is exact or rounding as positive: only true negatives have a line."""
    values = np.asarray(f.values, dtype=np.float64)
    return np.where(np.abs(values) <= f.noise, f.noise, values)
