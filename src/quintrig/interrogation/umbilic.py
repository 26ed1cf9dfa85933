"""What is told of umbilics: the isolated ones, curves and regions of them, and all that there is on a model."""

import math
from dataclasses import dataclass
from typing import Any, Literal

from quintrig.support.arrays import FloatArray
from quintrig.support.pickled import Pickled

Type = Literal["star", "lemon", "monstar", "planar", "other"]


@dataclass(frozen=True, eq=False)
class Umbilic(Pickled):
    """An isolated umbilic: parameters, point (3,), curvature κ1 = κ2 (1/length), index and type.

    ``directions`` are the angles in degrees from S_u in which lines of curvature leave it. ``proved`` says that it is
    ``alone`` in a box, or that the ``index`` is that of all that the ``box`` (u, v, u, v) holds, be it one umbilic or
    more. The index is NaN where it cannot be told.
    """

    patch: str
    u: float
    v: float
    point: FloatArray
    curvature: float
    index: float
    type: Type
    directions: tuple[float, ...] = ()
    proved: Literal["alone", "index", ""] = ""
    box: tuple[float, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, to go through JSON."""
        return {
            "patch": self.patch,
            "u": self.u,
            "v": self.v,
            "point": self.point.tolist(),
            "curvature": self.curvature,
            "index": None if math.isnan(self.index) else self.index,
            "type": self.type,
            "directions": list(self.directions),
            "proved": self.proved or None,
            "box": list(self.box) or None,
        }


@dataclass(frozen=True, eq=False)
class Region(Pickled):
    """Umbilics that are not isolated: all of a patch (``region``), or along a line in (u, v), (n, 2) (``curve``)."""

    patch: str
    kind: Literal["region", "curve"]
    curvature: float
    uv: FloatArray
    points: FloatArray

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, to go through JSON."""
        return {
            "patch": self.patch,
            "kind": self.kind,
            "curvature": self.curvature,
            "uv": self.uv.tolist(),
            "points": self.points.tolist(),
        }


@dataclass(frozen=True, eq=False)
class Umbilics(Pickled):
    """What there is on the patches of a model; ``sums`` compares, by patch, the indices with the boundary's rotation.

    ``complete`` is true only where a proof says that there are no others, and ``none_elsewhere`` where one says that
    there are none outside the boxes of those whose index alone is proved.
    """

    umbilics: tuple[Umbilic, ...]
    regions: tuple[Region, ...]
    complete: bool
    sums: tuple[dict[str, Any], ...]
    notes: tuple[str, ...]
    unit: str = ""
    none_elsewhere: bool = False

    def __len__(self) -> int:
        """Return the number of isolated umbilics."""
        return len(self.umbilics)

    def __repr__(self) -> str:
        """Return one line: how many."""
        return f"<Umbilics: {len(self)} isolated, {len(self.regions)} curves and regions, complete: {self.complete}>"

    def to_dict(self) -> dict[str, Any]:
        """Return everything as plain values, to go through JSON."""
        return {
            "umbilics": [one.to_dict() for one in self.umbilics],
            "complete": self.complete,
            "none_elsewhere": self.none_elsewhere,
            "regions": [one.to_dict() for one in self.regions],
            "index_sums": list(self.sums),
            "unit": self.unit,
            "notes": list(self.notes),
        }
