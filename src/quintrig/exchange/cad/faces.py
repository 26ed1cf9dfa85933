"""What a CAD file holds for us: faces as NURBS with their trim, curves, a unit; and how that becomes a model."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

from quintrig.model.model import Model
from quintrig.support.errors import ModelError, QuintrigError


@dataclass(frozen=True)
class Face:
    """One face: its number from 1, its name, the kind of its surface, and the keys of a ``nurbs`` patch.

    Where ``problem`` says why it cannot be read, ``keys`` is empty.
    """

    number: int
    name: str
    surface: str
    keys: dict[str, Any] = field(default_factory=dict[str, Any])
    problem: str = ""
    note: str = ""

    @property
    def described(self) -> str:
        """What it is, in a few words."""
        if self.problem:
            return f"{self.surface}: {self.problem}"
        p, q = self.keys["degrees"]
        size = f"{len(self.keys['points'])} x {len(self.keys['points'][0])} points"
        trimmed = ", trimmed" if self.keys.get("trim") else ""
        note = f"; {self.note}" if self.note else ""
        return f"{self.surface}, degree ({p}, {q}), {size}{trimmed}{note}"


@dataclass(frozen=True)
class SpaceCurve:
    """One curve: its number from 1, its name, and its NURBS: points (n, 3), weights, degree and full knot vector."""

    number: int
    name: str
    points: list[list[float]]
    weights: list[float]
    degree: int
    knots: list[float]

    @property
    def described(self) -> str:
        """What it is, in a few words."""
        return f"curve of degree {self.degree}, {len(self.points)} points"


@dataclass(frozen=True)
class Contents:
    """Everything read from one CAD file."""

    name: str
    unit: str
    faces: tuple[Face, ...]
    curves: tuple[SpaceCurve, ...] = ()
    notes: tuple[str, ...] = ()
    shells: int = 0

    def to_dict(self) -> dict[str, Any]:
        """Return it as plain values, to go through JSON."""
        return asdict(self)

    @staticmethod
    def from_dict(data: dict[str, Any]) -> "Contents":
        """Return what ``to_dict`` gave."""
        return Contents(
            data["name"],
            data["unit"],
            tuple(Face(**face) for face in data["faces"]),
            tuple(SpaceCurve(**curve) for curve in data["curves"]),
            tuple(data["notes"]),
            data["shells"],
        )


def to_model(contents: Contents, place: str, numbers: Sequence[int] | None = None) -> Model:
    """Return a model of the faces with these numbers, by default of all that can be read.

    Raises QuintrigError, naming the file as ``place``, where there is none, or no face of a number.
    """
    if not contents.faces:
        curves = f", only {len(contents.curves)} curves" if contents.curves else ""
        raise QuintrigError(
            f"{place}: expected a file with surfaces, found none{curves}",
            remedy="export the faces as NURBS",
            key="curves" if curves else "",
        )
    chosen = [_pick(contents, place, number) for number in numbers] if numbers else list(contents.faces)
    usable = [face for face in chosen if not face.problem]
    if not usable or (numbers and len(usable) < len(chosen)):
        first = next(face for face in chosen if face.problem)
        raise QuintrigError(f"{place}: face {first.number}: {first.problem}; convert it to NURBS in the CAD system")
    names = _distinct([face.name for face in usable])
    patches = [{"kind": "nurbs", "name": name, **face.keys} for face, name in zip(usable, names, strict=True)]
    header: dict[str, Any] = {"schema": 1, "name": contents.name[:200]}
    if contents.unit:
        header["unit"] = contents.unit
    keys = header | {"patch": patches}
    if len(patches) == 1:
        keys = {**header, **patches[0], "name": names[0] if numbers else header["name"] or names[0]}
    try:
        return Model.from_dict(keys)
    except ModelError as error:
        raise QuintrigError(f"{place}: {error}; export the face again") from None


def pick_curve(contents: Contents, place: str, number: int) -> SpaceCurve:
    """Return the curve with this number; QuintrigError naming how many there are."""
    for curve in contents.curves:
        if curve.number == number:
            return curve
    raise QuintrigError(f"{place}: expected a curve from 1 to {len(contents.curves)}, found {number}")


def _pick(contents: Contents, place: str, number: int) -> Face:
    for face in contents.faces:
        if face.number == number:
            return face
    raise QuintrigError(
        f"{place}: expected a face from 1 to {len(contents.faces)}, found {number}",
        remedy="contents(path).faces lists them",
        key="faces",
        file=place,
    )


def _distinct(names: Sequence[str]) -> list[str]:
    """Return the names, numbered where one comes twice."""
    seen: set[str] = set()
    result: list[str] = []
    for word in names:
        name, count = word[:190] or "face", 1
        base = name
        while name in seen:
            count += 1
            name = f"{base} {count}"
        seen.add(name)
        result.append(name)
    return result
