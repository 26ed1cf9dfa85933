"""Rows of developable strips: between several rails in turn, and in pieces along rulings, with what each seam is."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Literal

import numpy as np

from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.model.model import Model
from quintrig.shaping.continued import continued
from quintrig.shaping.matching import SITES, Pace, matched
from quintrig.shaping.rails import Rail, alike, rail
from quintrig.shaping.strip import finite, largest_gaussian, patch_keys, twist
from quintrig.support.arrays import FloatArray, whole

_SMOOTH = 0.1  # degrees, up to which a seam counts as G1: what quintrig check takes for engineering
_SAME = 1e-6  # of the parameter: cuts nearer to each other are one
_MET = 1e-6  # of the size: rails missed by less are met
_MOST_PIECES = 64


@dataclass(frozen=True)
class StripPart:
    """One strip of several: its rails, its patches' names, and how nearly developable it is, as of a ``Strip``."""

    name: str
    rails: tuple[str, str]
    patches: tuple[str, ...]
    twist: float
    largest_gaussian: float
    deviation: float


@dataclass(frozen=True)
class Seam:
    """Where two strips or two pieces meet: ``along`` a rail of this name, or a ruling (None).

    ``angle`` is the largest between their tangent planes, degrees. ``missed`` is how far the next rail is from the
    first strip continued, length¹: 0 where one developable passes through both; None along a ruling, and where the
    rulings of the first strip do not come near the next rail.
    """

    first: str
    second: str
    along: str | None
    angle: float
    missed: float | None

    @property
    def continuity(self) -> str:
        """G1 where the angle is at most 0.1°, else G0."""
        return "G1" if self.angle <= _SMOOTH else "G0"

    def to_dict(self) -> dict[str, Any]:
        """Return plain values."""
        return {
            "first": self.first,
            "second": self.second,
            "along": "ruling" if self.along is None else "rail",
            "rail": self.along,
            "angle": self.angle,
            "continuity": self.continuity,
            "missed": self.missed,
        }


@dataclass(frozen=True, eq=False)
class Strips:
    """A model of ruled patches, the strips that they are, the seams between them, and what to tell of those."""

    model: Model
    join: str
    strips: tuple[StripPart, ...]
    seams: tuple[Seam, ...]
    notes: tuple[str, ...]

    @property
    def angle(self) -> float:
        """The largest angle at a seam, degrees."""
        return max((one.angle for one in self.seams), default=0.0)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, without the model."""
        return {
            "unit": self.model.unit,
            "join": self.join,
            "twist": max(one.twist for one in self.strips),
            "largest_gaussian": finite(max(one.largest_gaussian for one in self.strips)),
            "deviation": max(one.deviation for one in self.strips),
            "angle": self.angle,
            "strips": [
                {
                    "name": one.name,
                    "rails": list(one.rails),
                    "patches": list(one.patches),
                    "twist": one.twist,
                    "largest_gaussian": finite(one.largest_gaussian),
                    "deviation": one.deviation,
                }
                for one in self.strips
            ],
            "seams": [one.to_dict() for one in self.seams],
            "notes": list(self.notes),
        }


def strips(
    rails: Sequence[Curve | Sequence[Curve]],
    *,
    names: Sequence[str] | None = None,
    pieces: int = 1,
    join: Literal["G0", "G1"] = "G0",
    unit: str = "",
    name: str = "strips",
) -> Strips:
    """Return developable strips between each two neighbours of several rails, as one model.

    A rail is a curve in space, or several joined end to end. Each strip is cut along rulings into so many ``pieces``,
    and where a curve of a rail ends; they share tangent planes there. Strips meet along rails at the angle that is
    told: rails leave developables no choice. With ``join`` "G1" the strips after the first continue it, the only
    developable that is tangent to it, and their deviation from their rails is told. Raises ValueError for fewer than
    two rails, for rails that meet, and where rulings do not come near a rail that they are to be continued to.
    """
    if len(rails) < 2:
        raise ValueError(f"rails: expected two or more, found {len(rails)}")
    if join not in ("G0", "G1"):
        raise ValueError(f"join: expected G0 or G1, got {join!r}")
    if whole(pieces, "pieces", 1) > _MOST_PIECES:
        raise ValueError(f"pieces: expected 1 to {_MOST_PIECES}, found {pieces}")
    called = list(names) if names is not None else [f"rail {k + 1}" for k in range(len(rails))]
    asked = alike([rail(one, label) for one, label in zip(rails, called, strict=True)])
    return _Row(asked, called, pieces, join).made(name, unit)


class _Row:
    """Rails in turn, the paces of the rulings between them, and where the strips are cut."""

    def __init__(self, rails: list[Rail], names: list[str], pieces: int, join: str) -> None:
        self.asked, self.rails, self.names, self.join = rails, list(rails), names, join
        count = len(rails) - 1
        few = 1 if join == "G1" else count
        labels = [f"{a}, {b}" for a, b in pairwise(names)]
        self.paces = [matched(rails[k], rails[k + 1], labels[k]) for k in range(few)]
        self.paces += [Pace(SITES, plain=True)] * (count - few)
        # Cuts on the first rail, and from there on all others: pieces meet corner to corner.
        cuts = [np.linspace(0.0, 1.0, pieces + 1)]
        for k in range(few + 1):
            at = rails[k].breaks
            for pace in self.paces[:k][::-1]:
                at = pace.inverse(at)
            cuts.append(at)
        found = np.sort(np.concatenate(cuts))
        self.cuts = [found[np.concatenate([[True], np.diff(found) > _SAME])]]
        self.cuts[0][-1] = 1.0
        for pace in self.paces:
            at = pace(self.cuts[-1])
            at[[0, -1]] = 0.0, 1.0
            self.cuts.append(at)
        self.missed: list[float | None] = []
        for k in range(1, count):
            onward = continued(self.rails[k - 1], self.rails[k], self.paces[k - 1], rails[k + 1], self.cuts[k])
            self.missed.append(None if onward is None else onward.misses(rails[k + 1]))
            if join == "G1":
                if onward is None:
                    raise ValueError(
                        f"join: the rulings between {names[k - 1]} and {names[k]} do not come near {names[k + 1]} when "
                        "continued, so no strip there is tangent to this one; take join G0"
                    )
                self.rails[k + 1] = onward

    def made(self, name: str, unit: str) -> Strips:
        """Return the model with everything that is to be told of it."""
        patches: list[dict[str, Any]] = []
        grouped: list[list[str]] = []
        off: list[float] = []
        for k, pace in enumerate(self.paces):
            title = f"{self.names[k]} to {self.names[k + 1]}"
            spans = list(pairwise(self.cuts[k].tolist()))
            grouped.append([])
            far = 0.0
            for j, (low, high) in enumerate(spans):
                keys, here = patch_keys(self.rails[k], self.rails[k + 1], pace, low, high)
                grouped[-1].append(title if len(spans) == 1 else f"{title}, {j + 1}")
                patches.append({"name": grouped[-1][-1]} | keys)
                far = max(far, here)
            missed = self.missed[k - 1] if self.join == "G1" and k else None
            off.append(far if missed is None else max(far, missed))
        header: dict[str, Any] = {"name": name} | ({"unit": unit} if unit else {})
        model = Model.from_dict(header | {"patch": patches})
        surfaces = {patch.name: patch.surface for patch in model.patches}
        parts = tuple(
            StripPart(
                f"{self.names[k]} to {self.names[k + 1]}",
                (self.names[k], self.names[k + 1]),
                tuple(own),
                max(twist(surfaces[one]) for one in own),
                max(largest_gaussian(surfaces[one]) for one in own),
                off[k],
            )
            for k, own in enumerate(grouped)
        )
        seams = self._seams(grouped, surfaces)
        size = max(one.size for one in surfaces.values())
        return Strips(model, self.join, parts, seams, tuple(self._notes(seams, size, unit)))

    def _seams(self, grouped: list[list[str]], surfaces: dict[str, Surface]) -> tuple[Seam, ...]:
        result: list[Seam] = []
        x = np.linspace(0.0, 1.0, 129)
        for own in grouped:
            for one, other in pairwise(own):
                angle = _angle(surfaces[one], (1.0, x), surfaces[other], (0.0, x))
                result.append(Seam(one, other, None, angle, None))
        for k in range(1, len(grouped)):
            angles: list[float] = []
            for j, (one, other) in enumerate(zip(grouped[k - 1], grouped[k], strict=True)):
                before, here = self.cuts[k - 1][[j, j + 1]], self.cuts[k][[j, j + 1]]
                s = before[0] + x * (before[1] - before[0])
                there = np.clip((self.paces[k - 1](s) - here[0]) / (here[1] - here[0]), 0.0, 1.0)
                angles.append(_angle(surfaces[one], (x, 1.0), surfaces[other], (there, 0.0)))
            titles = [f"{self.names[i]} to {self.names[i + 1]}" for i in (k - 1, k)]
            result.append(Seam(titles[0], titles[1], self.names[k], max(angles), self.missed[k - 1]))
        return tuple(result)

    def _notes(self, seams: tuple[Seam, ...], size: float, unit: str) -> list[str]:
        """Say what it would take where a seam along a rail is not smooth."""
        length = f" {unit}" if unit else ""
        result: list[str] = []
        for one in seams:
            if one.along is None:
                if one.continuity != "G1":
                    result.append(f"{one.first} and {one.second} meet at a corner of a rail, at {one.angle:.3g}°")
                continue
            onward = self.names[self.names.index(one.along) + 1]
            if self.join == "G1":
                if one.missed is not None and one.missed > _MET * size:
                    far = f"{one.missed:.3g}{length}"
                    result.append(f"continued across {one.along}, the strip misses {onward} by {far}")
            elif one.continuity != "G1":
                far = "does not come near" if one.missed is None else f"misses {onward} by"
                by = f" {onward}" if one.missed is None else f" {one.missed:.3g}{length}"
                result.append(
                    f"no smooth seam along {one.along}: developables that are tangent along a curve are one, and "
                    f"{one.first}, continued, {far}{by}"
                )
        return result


def _angle(
    one: Surface, at: tuple[FloatArray | float, FloatArray | float], other: Surface, there: tuple[Any, Any]
) -> float:
    """Return the largest angle between two surfaces' normals at parameters of each, degrees."""
    normals: list[FloatArray] = []
    for surface, (u, v) in ((one, at), (other, there)):
        p = surface.partials(u + 0.0 * v, v + 0.0 * u, 1)
        normals.append(surface.sign * np.cross(p[1, 0], p[0, 1]))
    sine = np.linalg.norm(np.cross(normals[0], normals[1]), axis=-1)
    return float(np.degrees(np.arctan2(sine, (normals[0] * normals[1]).sum(axis=-1))).max())
