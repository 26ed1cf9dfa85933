"""Which column of a table of points is what: by the names in its heading, or by what the numbers are."""

import re
from dataclasses import dataclass, field

import numpy as np

from quintrig.exchange.units import UNIT_WORDS, unit_of
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError

_PLACE = r"(?:points?|pos(?:ition)?|coord(?:inate)?s?|koordinate|vertex|vertices|location)"
_AXIS = re.compile(rf"(?:{_PLACE}[ _:.\-]*)?([xyz])(?:[ _\-]*{_PLACE})?")
_COUNTED = re.compile(rf"{_PLACE}[ _:.\-]*([012])")
_NORMAL = re.compile(r"n[ _]?([xyz])|normals?[ _:.\-]*([xyz012])")
_WORDS = {
    **dict.fromkeys(("easting", "east", "rechtswert", "ostwert"), 0),
    **dict.fromkeys(("northing", "north", "hochwert", "nordwert"), 1),
    **dict.fromkeys(("elevation", "height", "altitude", "höhe", "hoehe"), 2),
    **dict.fromkeys(("w", "weight", "weights", "gewicht"), 6),
}


@dataclass(frozen=True)
class Columns:
    """The columns of a table that are used, and which of those are x, y, z, the normal and the weight."""

    used: list[int] = field(default_factory=list[int])
    axes: list[int] = field(default_factory=list[int])
    normals: list[int] = field(default_factory=list[int])
    weight: int | None = None
    unit: str = ""

    @property
    def by_name(self) -> bool:
        """Whether x and y have been found by their names."""
        return len(self.axes) > 1


def named(words: list[str]) -> Columns:
    """Return what the words of a heading name, with the unit that stands beside x, y and z; none without x and y."""
    places: dict[int, int] = {}
    units: dict[int, str] = {}
    for column, word in enumerate(words):
        bare, unit = _apart(word)
        place = _place(bare)
        if place is not None and place not in places:
            places[place], units[place] = column, unit
    if not {0, 1} <= set(places):
        return Columns()
    axes = [k for k in (0, 1, 2) if k in places]
    across = [k for k in (3, 4, 5) if k in places]
    stated = {units[k] for k in axes}
    if len(stated) > 1:
        told = ", ".join(f"{'xyz'[k]} in {units[k] or 'none'}" for k in axes)
        raise ModelError(f"heading: expected one unit for x, y and z, found {told}")
    kept = [*axes, *(across if len(across) == 3 else []), *([6] if 6 in places else [])]
    at = {place: index for index, place in enumerate(kept)}
    return Columns(
        [places[k] for k in kept],
        [at[k] for k in axes],
        [at[k] for k in (3, 4, 5) if k in at],
        at.get(6),
        stated.pop(),
    )


def _apart(word: str) -> tuple[str, str]:
    """Return a column's name in small letters and its unit, of ``X [mm]``, ``x_mm``, ``y (in)`` or ``z/m``."""
    word = word.strip(" \"'").lower()
    found = re.fullmatch(rf"(.+?)(?:\s*[\[(]\s*([^\])]+?)\s*[\])]|[ _/]({UNIT_WORDS}))", word)
    if not found:
        return word, ""
    return found[1].strip(), unit_of(found[2] or found[3])


def _place(word: str) -> int | None:
    if word in _WORDS:
        return _WORDS[word]
    found = _AXIS.fullmatch(word) or _COUNTED.fullmatch(word)
    if found:
        return "xyz".find(found[1]) if found[1] in "xyz" else int(found[1])
    found = _NORMAL.fullmatch(word)
    if found:
        letter = found[1] or found[2]
        return 3 + ("xyz".find(letter) if letter in "xyz" else int(letter))
    return None


def unnamed(rows: FloatArray) -> tuple[Columns, tuple[str, ...]]:
    """Return which columns of numbers (n, k) are the point and its normal, where nothing names them, and notes.

    The first three are the point, and three that are unit vectors the normal: other columns are colours, intensities.
    Four columns are a running number and a point where the first counts. Raises ModelError for one and five.
    """
    width = rows.shape[1]
    if width in (1, 5):
        raise ModelError(f"expected 2 or 3 numbers a line, or 6 with a normal, found {width}")
    axes = list(range(min(width, 3)))
    if width == 4 and len(rows) > 3 and np.array_equal(np.diff(rows[:, 0]), np.ones(len(rows) - 1)):
        return Columns(axes=[1, 2, 3]), ("the first of the four columns counts the points and is not read as x",)
    normals = [[first, first + 1, first + 2] for first in dict.fromkeys((3, width - 3)) if first >= 3]
    fits = [three for three in normals if _unit_vectors(rows[:, three])] if width >= 6 else []
    return Columns(axes=axes, normals=fits[0] if fits else []), ()


def _unit_vectors(rows: FloatArray) -> bool:
    length = np.linalg.norm(rows, axis=1)
    return bool((np.abs(length[np.isfinite(length)] - 1.0) < 0.01).all())
