"""Lines on the patches of a model: what every way of finding them returns."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from quintrig.support.arrays import FloatArray
from quintrig.support.display import Shown
from quintrig.support.pickled import Pickled


@dataclass(frozen=True, eq=False)
class Line(Pickled, Shown):
    """A polyline on one patch: parameters ``uv`` (n, 2), ``points`` (n, 3) and arc length ``s`` (n,), length¹.

    ``values`` (n,) is the quantity along it, ``label`` its family or level. Lines that run on across patches or the
    seam of a closed surface have one ``chain``. ``chord_error`` is how far, at most, the line lies from its chords,
    measured at the middle of each, and of level sets at the quarters too, length¹. ``strength`` is that of a ridge,
    ∫|κ| ds.
    """

    patch: str
    label: str
    chain: int
    closed: bool
    uv: FloatArray
    points: FloatArray
    s: FloatArray
    values: FloatArray
    chord_error: float
    level: float | None = None
    strength: float | None = None

    @property
    def length(self) -> float:
        """Arc length, length¹."""
        return float(self.s[-1])

    def __repr__(self) -> str:
        """Return one line: where it runs and how long it is."""
        closed = ", closed" if self.closed else ""
        return f"<Line {self.label!r} on {self.patch!r}: {len(self.uv)} points, length {self.length:.6g}{closed}>"

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, to go through JSON."""
        more = {"level": self.level, "strength": self.strength}
        return {
            "patch": self.patch,
            "label": self.label,
            "chain": self.chain,
            "closed": self.closed,
            "length": self.length,
            "chord_error": self.chord_error,
            **{key: value for key, value in more.items() if value is not None},
            "uv": self.uv.tolist(),
            "points": self.points.tolist(),
            "s": self.s.tolist(),
            "values": [value if abs(value) < float("inf") else None for value in self.values.tolist()],
        }


@dataclass(frozen=True, eq=False)
class Lines(Pickled, Shown):
    """All lines of one kind on a model; ``quantity`` names what ``values`` are, ``unit`` is that of lengths.

    ``quantity_unit`` is the unit of the values, ``notes`` say what else is to be known, such as why there is no line.
    """

    kind: str
    lines: tuple[Line, ...]
    quantity: str
    quantity_unit: str
    unit: str
    tolerance: float
    notes: tuple[str, ...] = ()

    def __iter__(self) -> Iterator[Line]:
        """Yield the lines."""
        return iter(self.lines)

    def __len__(self) -> int:
        """Return the number of lines."""
        return len(self.lines)

    def __getitem__(self, index: int) -> Line:
        """Return a line by its number from 0."""
        return self.lines[index]

    def __repr__(self) -> str:
        """Return one line: kind, number and length."""
        return f"<Lines {self.kind}: {len(self)} lines on the model, length {self.length:.6g} in all>"

    @property
    def length(self) -> float:
        """Arc length of all lines, length¹."""
        return sum(line.length for line in self.lines)

    @property
    def chord_error(self) -> float:
        """The largest distance of a line from its chords, length¹; 0 where there is no line."""
        return max((line.chord_error for line in self.lines), default=0.0)

    def to_dict(self) -> dict[str, Any]:
        """Return everything as plain values, to go through JSON."""
        return {
            "kind": self.kind,
            "unit": self.unit,
            "quantity": self.quantity,
            "quantity_unit": self.quantity_unit,
            "count": len(self),
            "length": self.length,
            "tolerance": self.tolerance,
            "chord_error": self.chord_error,
            "lines": [line.to_dict() for line in self.lines],
            "notes": list(self.notes),
        }
