"""The joins of a model: which edges meet, how smoothly, where not, and which are free."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from quintrig.analysis.table import Column, Table
from quintrig.multipatch.limits import Limits
from quintrig.support.arrays import FloatArray

_ALL = 5e-3  # of an edge at its ends: less than that missing is not told
_ROUNDING = 1e-6  # share of a limit up to which a value is shown as 0
ORDERS = ("open", "G0", "G1", "G2", "G3")


@dataclass(frozen=True)
class End:
    """One side of a join: the patch's name, its side, and the stretch of it from t = ``start`` to ``stop``."""

    patch: str
    side: str
    start: float = 0.0
    stop: float = 1.0

    def __str__(self) -> str:
        """Return ``patch:side``, and the stretch if it is not all of it."""
        whole = self.start <= _ALL and self.stop >= 1.0 - _ALL
        return f"{self.patch}:{self.side}" + ("" if whole else f" [{self.start:.3g}, {self.stop:.3g}]")

    def to_dict(self) -> dict[str, Any]:
        """Return plain values."""
        return {"patch": self.patch, "side": self.side, "from": self.start, "to": self.stop}


@dataclass(frozen=True)
class Range:
    """The least and the greatest value along a join, and the point (x, y, z) of the greatest; NaN if undefined."""

    least: float
    most: float
    where: tuple[float, float, float]

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, None for NaN."""
        where = None if np.isnan(self.where[0]) else list(self.where)
        return {"min": _number(self.least), "max": _number(self.most), "where": where}


@dataclass(frozen=True, eq=False)
class Join:
    """Two edges that meet, or nearly do, measured along the stretch that they share.

    ``gap`` is a length, ``angle`` of the normals is in degrees, 180 where the surfaces fold back. ``first_curvature``
    and ``second_curvature`` are the normal curvatures across the edge (length⁻¹), signed by the first patch's normal;
    ``difference`` is the size of their jump, ``curvature`` that jump relative to |κ1| + |κ2| with the floor of
    ``Joins``, and ``rate`` the same of their derivatives across the edge. ``order`` is open, G0, G1, G2 or G3.
    ``opposed`` where the patches' normals look to opposite sides. ``points`` (n, 3) run along the first edge.
    """

    first: End
    second: End
    reversed: bool
    opposed: bool
    gap: Range
    angle: Range
    first_curvature: Range
    second_curvature: Range
    difference: Range
    curvature: Range
    rate: Range
    sign_change: bool
    order: str
    points: FloatArray = field(repr=False)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values: the greatest ones, and under ``ranges`` least, greatest and where."""
        names = ("gap", "angle", "first_curvature", "second_curvature", "difference", "curvature", "rate")
        return {
            "first": self.first.to_dict(),
            "second": self.second.to_dict(),
            "reversed": self.reversed,
            "opposed_normals": self.opposed,
            "gap": _number(self.gap.most),
            "angle": _number(self.angle.most),
            "curvature": _number(self.curvature.most),
            "curvature_difference": _number(self.difference.most),
            "curvature_rate": _number(self.rate.most),
            "sign_change": self.sign_change,
            "order": self.order,
            "ranges": {name: getattr(self, name).to_dict() for name in names},
        }

    def describe(self, unit: str = "") -> str:
        """Return what joins or parts the edges, in one line."""
        gap = f"{self.gap.most:.3g} {unit}".rstrip()
        names = f"{self.first} and {self.second}"
        if self.order == "open":
            return f"{names} are open by {gap}"
        return f"{names} join {self.order}: gap {gap}, angle {self.angle.most:.3g}°, jump {self.curvature.most:.3g}"


@dataclass(frozen=True, eq=False)
class Joins:
    """All joins of a model, its free edges and its poles, under stated limits.

    ``floors`` are the normal curvature (length⁻¹) and its rate (length⁻²) below which a relative jump is measured
    against them: what is as good as flat at the size of the smallest patch. ``unmet`` has a line on each join that the
    model is to hold and that does not reach its order.
    """

    name: str
    unit: str
    limits: Limits
    floors: tuple[float, float]
    joins: tuple[Join, ...]
    free: tuple[End, ...]
    poles: tuple[End, ...]
    unmet: tuple[str, ...] = ()

    def __len__(self) -> int:
        """Return the number of joins."""
        return len(self.joins)

    def __iter__(self) -> Any:
        """Run through the joins."""
        return iter(self.joins)

    def __getitem__(self, index: int) -> Join:
        """Return a join by its number."""
        return self.joins[index]

    @cached_property
    def counts(self) -> dict[str, int]:
        """How many joins reach each order."""
        return {order: sum(join.order == order for join in self.joins) for order in ORDERS}

    @property
    def warnings(self) -> tuple[str, ...]:
        """A line on every seam that is nearly closed, and on every join that is to hold and does not."""
        return (*(join.describe(self.unit) for join in self.joins if join.order == "open"), *self.unmet)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values for JSON; angles in degrees."""
        return {
            "name": self.name,
            "unit": self.unit,
            "limits": {
                "tolerance": self.limits.tolerance,
                "angle": self.limits.angle,
                "curvature": self.limits.curvature,
                "curvature_floor": self.floors[0],
                "rate_floor": self.floors[1],
            },
            "joins": [join.to_dict() for join in self.joins],
            "free": [end.to_dict() for end in self.free],
            "poles": [{"patch": end.patch, "side": end.side} for end in self.poles],
            "unmet": list(self.unmet),
        }

    def table(self) -> Table:
        """Return the joins as a table of text and numbers: the greatest values along each."""
        per = f"1/{self.unit}" if self.unit else ""
        words = [
            ("first", "first edge", [str(join.first) for join in self.joins]),
            ("second", "second edge", [str(join.second) for join in self.joins]),
            ("order", "order", [join.order for join in self.joins]),
            ("reversed", "reversed", ["yes" if join.reversed else "no" for join in self.joins]),
            ("sign_change", "inflection", ["yes" if join.sign_change else "no" for join in self.joins]),
        ]
        small = (self.limits.tolerance, self.limits.angle, self.limits.curvature, self.floors[0])
        numbers = [
            ("gap", "gap", r"d", "largest gap", self.unit, [join.gap.most for join in self.joins]),
            ("angle", "angle", r"\vartheta", "largest angle of the normals", "°", [j.angle.most for j in self.joins]),
            ("curvature", "rel. jump", r"\delta", "relative jump", "", [j.curvature.most for j in self.joins]),
            ("curvature_difference", "|κ1-κ2|", r"|\kappa_1-\kappa_2|", "jump", per, [j.difference.most for j in self]),
        ]
        texts = [
            Column(key, name, rf"\mathrm{{{name}}}", name, "", *(tuple(values),) * 2) for key, name, values in words
        ]
        floats = [
            Column(key, symbol, latex, name, unit, tuple(values), _read(values, limit))
            for (key, symbol, latex, name, unit, values), limit in zip(numbers, small, strict=True)
        ]
        free = ", ".join(map(str, self.free)) or "none"
        notes = [
            f"Limits: {self.limits.describe(self.unit)}; jumps are relative to |κ1| + |κ2|, or to {self.floors[0]:.3g} "
            "where that is more.",
            f"Free edges: {free}." if len(self.free) <= 12 else f"Free edges: {len(self.free)}.",
        ]
        if self.poles:
            notes.append(f"Edges collapsed to a point: {', '.join(f'{p.patch}:{p.side}' for p in self.poles[:12])}.")
        return Table(f"{self.name}: joins", tuple(notes), (*texts[:3], *floats, *texts[3:]))


def _read(values: Sequence[float], limit: float) -> tuple[float, ...]:
    """Return values to be read: three digits, 0 for what is as good as nothing beside a limit."""
    return tuple(0.0 if abs(x) <= _ROUNDING * limit else float(f"{x:.3g}") for x in values)


def _number(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
