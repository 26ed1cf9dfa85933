"""Tables of quantities at chosen points of a surface; ``typeset`` writes them."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quintrig.analysis.sample import Sample, analyse
from quintrig.geometry.surface import Surface
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import BY_KEY, CLASSES, Quantity, quantity
from quintrig.support.arrays import BoolArray
from quintrig.support.tolerance import rounding_floor

Metric = Literal["planar", "surface", "both"]

INVARIANTS: tuple[str, ...] = ("beta0", "beta1", "beta2", "gamma1", "gamma2", "gamma3")
"""Keys of the six invariants in the planar metric; those in the surface metric end in ``_surface``."""

STANDARD: tuple[str, ...] = ("gaussian", "mean", "k1", "k2", "shape_index", "curvedness", *CLASSES, *INVARIANTS)
"""Quantities of a table for which none are named."""


@dataclass(frozen=True, eq=False)
class Column:
    """One column: key, symbol and name, unit in text, and its values, numbers or names of classes."""

    key: str
    symbol: str
    latex: str
    name: str
    unit: str
    values: tuple[float, ...] | tuple[str, ...]
    rounded: tuple[float, ...] | tuple[str, ...]
    """The values to be read by people: 0 in place of what is only rounding."""

    @property
    def heading(self) -> str:
        """Symbol with its unit, such as ``K (1/mm²)``."""
        return f"{self.symbol} ({self.unit})" if self.unit else self.symbol

    @property
    def is_text(self) -> bool:
        """True for a column of names."""
        return bool(self.values) and isinstance(self.values[0], str)


@dataclass(frozen=True, eq=False)
class Table:
    """Columns of equal length with a title and notes: unit, direction of the normal, metric, undefined values."""

    title: str
    notes: tuple[str, ...]
    columns: tuple[Column, ...]
    lead: int = 2
    """How many of the first columns name the row, such as u and v."""
    region: str = ""
    """Of a trimmed face: whether the values are of the ``trimmed`` face or of its ``whole`` surface."""

    @property
    def rows(self) -> Iterator[tuple[float | str, ...]]:
        """The rows with every digit, in the order of the points."""
        return zip(*(column.values for column in self.columns), strict=True)


def tabulate(
    surface: Surface,
    u: ArrayLike,
    v: ArrayLike,
    quantities: Iterable[str] | None = None,
    *,
    metric: Metric = "planar",
    unit: str = "",
    title: str = "",
    thresholds: Thresholds | None = None,
    whole: bool = False,
) -> Table:
    """Return a table of u, v, x, y, z and the quantities at parameters that broadcast as in NumPy.

    ``quantities`` are keys of ``quantity.QUANTITIES`` (None: ``STANDARD``); an invariant without ``_surface`` is given
    in ``metric``. Points outside the loops of a trimmed face have a place but no values, save where ``whole`` asks for
    those of all of its surface. ``unit`` is the unit of length, empty for plain numbers. Raises ValueError for unknown
    keys or metrics and for parameters outside [0, 1].
    """
    keys = _in_metric(STANDARD if quantities is None else quantities, metric)
    sample = analyse(surface, u, v, ("point", "mean", "curvedness", *keys), thresholds=thresholds)
    inside = np.broadcast_to(surface.inside(sample.u, sample.v), sample.shape)
    if not whole:
        sample = replace(sample, values={key: _within(key, sample[key], inside) for key in sample.values})
    columns: list[Column] = []
    for name, values in zip("uv", np.broadcast_arrays(sample.u, sample.v), strict=True):
        columns.append(Column(name, name, name, f"parameter {name}", "", _floats(values), _floats(values)))
    for key in ("point", *(key for key in keys if key != "point")):
        columns += _columns(BY_KEY[key], sample, unit)
    if surface.trim:
        words = tuple("inside" if inner else "outside" for inner in inside.ravel().tolist())
        columns.append(Column("trim", "trim", r"\mathrm{trim}", "side of the face's trim loops", "", words, words))
    region = "" if not surface.trim else "whole" if whole else "trimmed"
    return Table(title, _notes(sample, keys, unit, whole), tuple(columns), region=region)


def stacked(tables: Sequence[tuple[str, Table]], title: str = "") -> Table:
    """Return tables of several patches as one, the patch in its first column; only columns that all of them have."""
    first = tables[0][1]
    shared = [one for one in first.columns if all(one.key in {c.key for c in table.columns} for _, table in tables)]
    names = tuple(name for name, table in tables for _ in table.columns[0].values)
    columns = [Column("patch", "patch", r"\mathrm{patch}", "patch", "", names, names)]
    for one in shared:
        parts = [next(c for c in table.columns if c.key == one.key) for _, table in tables]
        values, rounded = (tuple(x for part in parts for x in getattr(part, what)) for what in ("values", "rounded"))
        columns.append(replace(one, values=values, rounded=rounded))
    alike = [note for note in first.notes if all(note in table.notes for _, table in tables)]
    own = [f"{name}: {note}" for name, table in tables for note in table.notes if note not in alike]
    return Table(title, (*alike, *own), tuple(columns), lead=first.lead + 1)


def _within(key: str, values: NDArray[Any], inside: BoolArray) -> NDArray[Any]:
    """Return values (...) or vectors (..., 3) with none outside a face; a point has its place all the same."""
    if key == "point" or inside.all():
        return values
    kept = inside[..., None] if values.ndim > inside.ndim else inside
    nothing: Any = 0 if BY_KEY[key].kind == "class" else np.nan
    return np.where(kept, values, nothing).astype(values.dtype)


def normal_note(sample: Sample) -> str:
    """Say which way the normal points; ``sample`` must hold it."""
    along = "against" if sample.surface.flip else "along"
    middle = analyse(sample.surface, 0.5, 0.5, ("normal",)).normal
    if np.isnan(middle).any():
        return f"The normal n points {along} S_u × S_v."
    x, y, z = (f"{part + 0.0:.3f}" for part in np.round(middle, 3))
    return f"The normal n points {along} S_u × S_v: in the middle, at u = v = 1/2, it is ({x}, {y}, {z})."


def _in_metric(keys: Iterable[str], metric: str) -> tuple[str, ...]:
    """Check the keys, and replace each invariant by its form in the metric or metrics asked for."""
    suffixes = {"planar": ("",), "surface": ("_surface",), "both": ("", "_surface")}
    if metric not in suffixes:
        raise ValueError(f"metric: expected planar, surface or both, got {metric!r}")
    result: list[str] = []
    for key in keys:
        known = quantity(key).key
        result += [known + suffix for suffix in suffixes[metric]] if known in INVARIANTS else [known]
    return tuple(dict.fromkeys(result))


def _columns(q: Quantity, sample: Sample, unit: str) -> list[Column]:
    if q.kind == "class":
        codes: list[int] = sample[q.key].ravel().tolist()
        names = tuple(q.classes[code] for code in codes)
        return [Column(q.key, q.symbol, q.latex, q.name, "", names, names)]
    parts = sample[q.key].reshape(-1, q.components)
    floor = rounding_floor(sample["curvedness"].ravel(), sample.size, q.power)
    columns: list[Column] = []
    for axis, values in zip("xyz", parts.T, strict=False):
        words = (q.key, q.symbol, q.latex, q.name)
        if q.key == "point":
            words = (axis, axis, axis, f"{axis} of the point")
        elif q.components == 3:
            words = (f"{q.key}_{axis}", f"{q.symbol}_{axis}", f"{{{q.latex}}}_{axis}", f"{axis} of the {q.name}")
        read = np.where(np.abs(values) <= floor, 0.0, values)
        columns.append(Column(*words, q.unit(unit), _floats(values), _floats(read)))
    return columns


def _notes(sample: Sample, keys: Sequence[str], unit: str, whole: bool) -> tuple[str, ...]:
    notes = [
        f"Lengths in {unit}." if unit else "Lengths are plain numbers: the model states no unit.",
        normal_note(sample),
    ]
    planar = any(key in INVARIANTS for key in keys) or "invariant_type" in keys
    own = any(key.endswith("_surface") for key in keys)
    if planar and own:
        notes.append("Invariants in the metric of the horizontal plane and, marked ˢ, in that of the surface.")
    elif planar or own:
        which = "horizontal plane" if planar else "surface"
        notes.append(f"Invariants in the metric of the {which}.")
    if any(key in CLASSES for key in keys) and sample.size > 0.0:
        notes.append(f"Types: {sample.thresholds.describe(sample.size, unit)}.")
    notes += sample.surface.caveats
    if sample.surface.trim:
        outside = (
            "belong to its whole surface alone" if whole else "have no values (its carrier, the whole surface, has)"
        )
        notes.append(f"The face is trimmed: points outside its loops {outside}.")
    inside = sample.surface.inside(sample.u, sample.v) | whole
    count = int((sample.singular & inside).sum())
    if count:
        notes.append(
            f"{count} of {sample.singular.size} points {'is' if count == 1 else 'are'} singular: without a tangent "
            "plane, curvature is undefined."
        )
    return tuple(notes)


def _floats(values: NDArray[Any]) -> tuple[float, ...]:
    return tuple(values.ravel().tolist())
