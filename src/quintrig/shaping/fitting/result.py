"""What a fit comes to: the model, how far the points are from it, and how well its shape parameters are determined."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from quintrig.model.model import Model
from quintrig.scan.deviation import Deviation
from quintrig.support.arrays import BoolArray


@dataclass(frozen=True)
class ShapeValue:
    """A shape parameter that was fitted: its value, standard deviation, and where it lies with 95 %.

    That is in one of ``intervals``, all of them from ``low`` to ``high``; not ``determined`` where they are most of the
    range that it may have.
    """

    name: str
    value: float
    deviation: float
    low: float
    high: float
    intervals: tuple[tuple[float, float], ...]
    determined: bool

    def describe(self) -> str:
        """Return the value and the intervals in words."""
        spans = " or ".join(f"from {low:.4g} to {high:.4g}" for low, high in self.intervals)
        return f"{self.value:.4g}, {'' if self.determined else 'not determined: '}with 95 % {spans}"

    def to_dict(self) -> dict[str, Any]:
        """Return plain values."""
        return {
            "name": self.name,
            "value": self.value,
            "std": self.deviation,
            "interval95": [self.low, self.high],
            "intervals95": [list(span) for span in self.intervals],
            "determined": self.determined,
        }


@dataclass(frozen=True, eq=False)
class Fit:
    """A fitted model; its deviation from the points, of which ``kept`` (n,) are no outliers; and what was found."""

    model: Model
    kind: str
    deviation: Deviation
    kept: BoolArray
    shape: tuple[ShapeValue, ...] = ()
    tolerance: float | None = None
    facts: dict[str, Any] = field(default_factory=dict[str, Any])
    notes: tuple[str, ...] = ()

    def __repr__(self) -> str:
        """Return one line: kind, points, rms and largest distance."""
        unit = f" {self.model.unit}" if self.model.unit else ""
        return f"<Fit {self.kind} of {len(self.deviation):,} points: rms {self.rms:.4g}, max {self.max:.4g}{unit}>"

    @property
    def rms(self) -> float:
        """The root of the mean of the squared distances of the points that are no outliers, length¹."""
        return float(np.sqrt(np.mean(self.deviation.distance[self.kept] ** 2)))

    @property
    def max(self) -> float:
        """The largest distance of a point that is no outlier, length¹."""
        return float(np.abs(self.deviation.distance[self.kept]).max())

    @property
    def points(self) -> int:
        """The number of points."""
        return len(self.deviation)

    @property
    def outliers(self) -> int:
        """The number of points that did not count."""
        return int((~self.kept).sum())

    @property
    def within_tolerance(self) -> bool | None:
        """Whether all points but outliers are within the tolerance; None without one."""
        return None if self.tolerance is None else self.max <= self.tolerance

    def to_dict(self) -> dict[str, Any]:
        """Return what the fit reached, for JSON."""
        told = self.deviation.to_dict()
        return {
            "rms": self.rms,
            "max": self.max,
            "points": self.points,
            "unit": self.model.unit,
            "kind": self.kind,
            "mean": float(self.deviation.distance[self.kept].mean()),
            "outliers": self.outliers,
            "rms_all": self.deviation.rms,
            "max_all": float(np.abs(self.deviation.distance).max()),
            "tolerance": self.tolerance,
            "within_tolerance": self.within_tolerance,
            "shape": [one.to_dict() for one in self.shape],
            "patches": [{"name": patch.name, "kind": patch.kind} for patch in self.model.patches],
            **self.facts,
            "percentiles": told["percentiles"],
            "edge": told["edge"]["points"],
            "notes": list(self.notes),
        }
