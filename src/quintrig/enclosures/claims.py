"""Claims as people write them: ``gaussian > 0``, ``curvature_radius >= 30 mm``, ``-5 deg <= draft <= 5 deg``."""

import math
import re
from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np

from quintrig.enclosures.measures import MEASURES, UPRIGHT, Measure
from quintrig.enclosures.search import Range
from quintrig.quantities.table import BY_KEY
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import nearest
from quintrig.support.numerals import real

STRUCTURAL = ("regular", "convex", "inside hull", "no fold", "developable")
"""Claims that are no comparison."""

_LENGTHS = {
    "um": Fraction(1, 1000),
    "µm": Fraction(1, 1000),
    "mm": Fraction(1),
    "cm": Fraction(10),
    "m": Fraction(1000),
    "km": Fraction(1000000),
    "in": Fraction(254, 10),
    "ft": Fraction(3048, 10),
}
_ANGLES = {"deg": 1.0, "°": 1.0, "degree": 1.0, "degrees": 1.0, "rad": 180.0 / math.pi}
_OPERATORS = {"≥": ">=", "≤": "<=", "=>": ">=", "=<": "<=", "\u2212": "-"}
_TURNED = {">": "<", ">=": "<=", "<": ">", "<=": ">="}
_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[+-]?inf"
_EXAMPLES = "'gaussian > 0', 'curvature_radius >= 30', 'slope <= 60 deg' or 'regular'"
DIRECTIONS = {
    "x": (1.0, 0.0, 0.0),
    "y": (0.0, 1.0, 0.0),
    "z": (0.0, 0.0, 1.0),
    "-x": (-1.0, 0.0, 0.0),
    "-y": (0.0, -1.0, 0.0),
    "-z": (0.0, 0.0, -1.0),
}
_LONGEST = 200


@dataclass(frozen=True, eq=False)
class Claim:
    """A claim: its ``text``, and what is to be in which ``range``, or a ``word`` of STRUCTURAL.

    ``sought`` says that only the values are asked for, which every surface has.
    """

    text: str
    word: str = ""
    measure: Measure | None = None
    range: Range = field(default_factory=Range)
    direction: FloatArray = field(default_factory=lambda: UPRIGHT)
    sought: bool = False

    @property
    def key(self) -> str:
        """The quantity, or the word."""
        return self.measure.key if self.measure else self.word


def read(text: str, unit: str = "") -> Claim:
    """Return a claim on a model in ``unit``; ValueError saying what was expected and what was found."""
    if not isinstance(text, str) or not text.strip() or len(text) > _LONGEST:  # pyright: ignore[reportUnnecessaryIsInstance]
        raise ValueError(f"claim: expected one such as {_EXAMPLES}, found {str(text)[:60]!r}")
    words = " ".join(text.split())
    for sign, plain in _OPERATORS.items():
        words = words.replace(sign, plain)
    word = _word(words)
    if word:
        return Claim(words, word)
    body, direction = _direction(words)
    claim = _comparison(words, body, unit, direction)
    if body != words and claim.measure and not claim.measure.degrees:
        raise ValueError(f"claim {words!r}: slope and draft are along a direction, {claim.measure.key} is not")
    return claim


def _word(words: str) -> str:
    """Return the claim of STRUCTURAL that is meant, or none; ValueError where something is said of it besides."""
    plain = re.sub(r"[_-]", " ", words.lower())
    for word in STRUCTURAL:
        if plain == word:
            return word
        if re.match(rf"{word}\b", plain):
            raise ValueError(f"claim {words!r}: {word} is a claim by itself; expected nothing after it")
    return ""


def _comparison(words: str, body: str, unit: str, direction: FloatArray) -> Claim:
    inside = re.fullmatch(r"(?:range\s+)?(.+?)\s+in\s+\[(.+?),(.+)\](.*)", body)
    if inside:
        name, low, high, both = inside.groups()
        measure = _measure(name)
        ends = [_value(f"{part.strip()} {both}", measure, unit) for part in (low, high)]
        return _compared(words, measure, ">=", ends[0], "<=", ends[1], direction)
    parts = re.split(r"\s*(>=|<=|==|!=|=|>|<)\s*", body)
    for sign in parts[1::2]:
        if sign not in _TURNED:
            raise ValueError(
                f"claim {words!r}: expected >, >=, < or <=, found {sign}; write a range as low <= x <= high"
            )
    if len(parts) == 1:
        name = re.sub(r"^range\s+", "", body)
        return Claim(words, "", _measure(name), direction=direction, sought=True)
    if len(parts) == 3:
        left, sign, right = parts
        if re.match(rf"({_NUMBER})", left):
            left, sign, right = right, _TURNED[sign], left
        measure = _measure(left)
        return _compared(words, measure, sign, _value(right, measure, unit), None, 0.0, direction)
    if len(parts) == 5:
        low, first, name, second, high = parts
        measure = _measure(name)
        if first[0] != second[0]:
            raise ValueError(
                f"claim {words!r}: expected a range such as low <= {name} <= high, found {first} and {second}"
            )
        ends = [_value(part, measure, unit) for part in (low, high)]
        return _compared(words, measure, _TURNED[first], ends[0], second, ends[1], direction)
    raise ValueError(f"claim: expected one such as {_EXAMPLES}, found {words[:60]!r}")


def _compared(
    text: str, measure: Measure, first: str, value: float, second: str | None, other: float, direction: FloatArray
) -> Claim:
    low, high, open_ = -math.inf, math.inf, [False, False]
    for sign, at in ((first, value), (second, other)):
        if sign and sign[0] == ">":
            low, open_[0] = at, sign == ">"
        elif sign:
            high, open_[1] = at, sign == "<"
    if low > high or (low == high and any(open_)):
        raise ValueError(f"claim {text!r}: expected a range with some value in it, found {low:g} to {high:g}")
    return Claim(text, "", measure, Range(low, high, (open_[0], open_[1])), direction)


_SYMBOLS = {"K": "gaussian", "H": "mean", "κ1": "k1", "κ2": "k2", "C": "curvedness", "radius": "curvature_radius"}


def key_of(name: str) -> str:
    """Return the key of ``MEASURES`` that a key, a symbol or words stand for; other names as keys are spelt."""
    name = name.strip()
    return _SYMBOLS.get(name, name.lower().replace(" ", "_").replace("draft_angle", "draft"))


def _measure(name: str) -> Measure:
    name = name.strip()
    key = key_of(name)
    if key in MEASURES:
        return MEASURES[key]
    known = ", ".join((*MEASURES, *STRUCTURAL))
    if not name:
        raise ValueError(f"claim: expected a quantity to compare, found none; there are {known}")
    if key in BY_KEY:
        raise ValueError(f"claim: {key} has no proof; these have: {known}")
    raise ValueError(
        f"claim: no quantity {name[:60]!r} to prove{nearest(key, (*MEASURES, *STRUCTURAL))}; there are {known}"
    )


def _value(text: str, measure: Measure, unit: str) -> float:
    """Return a value with or without a unit, in the model's."""
    found = re.match(rf"({_NUMBER})\s*(.*)$", text.strip())
    if not found:
        raise ValueError(f"claim: expected a number to compare {measure.key} with, found {text[:60]!r}")
    value, given = real(found[1]), found[2].strip()
    if measure.degrees:
        if not given and value:
            raise ValueError(f"claim: {measure.key} is an angle; expected a unit, as in '{value:g} deg', found none")
        if given and given not in _ANGLES:
            raise ValueError(f"claim: {measure.key} is an angle; expected deg or rad, found {given[:20]!r}")
        return value * _ANGLES.get(given, 1.0)
    if not given:
        return value
    power, length = _length(given, measure, unit)
    if power != measure.power or length not in _LENGTHS:
        raise ValueError(f"claim: expected {_wanted(measure, unit)} for {measure.key}, found {given[:20]!r}")
    if not unit:
        raise ValueError(f"claim: the model states no unit; expected a plain number for {measure.key}, found {given!r}")
    return float(Fraction(value) * (_LENGTHS[length] / _LENGTHS[unit]) ** power)


def _length(given: str, measure: Measure, unit: str) -> tuple[int, str]:
    """Return power and unit of length of a text such as ``1/mm²``."""
    text = (
        given.replace("²", "2")
        .replace("^", "")
        .replace("**", "")
        .replace(" ", "")
        .replace("⁻¹", "-1")
        .replace("⁻2", "-2")
    )
    found = re.fullmatch(r"(1?/)?([a-zµ]+)(-?[12])?", text)
    if not found:
        raise ValueError(f"claim: expected {_wanted(measure, unit)} for {measure.key}, found {given[:20]!r}")
    power = int(found[3] or 1)
    return (-power if found[1] else power), found[2]


def _wanted(measure: Measure, unit: str) -> str:
    length = unit or "mm"
    return {1: f"a length such as {length}", -1: f"1/{length}", -2: f"1/{length}²"}[measure.power]


def _direction(words: str) -> tuple[str, FloatArray]:
    """Return a claim without its ``along`` direction, and that one."""
    body, sign, text = words.partition(" along ")
    if not sign:
        return words, UPRIGHT
    if text in DIRECTIONS:
        return body, np.array(DIRECTIONS[text])
    parts = [part for part in re.split(r"[,\s()\[\]]+", text) if part]
    try:
        found = np.array([real(part) for part in parts])
    except ValueError:
        found = np.zeros(0)
    if found.shape != (3,) or not np.isfinite(found).all() or not found.any():
        raise ValueError(f"claim: expected a direction such as x, z or 0,0,1 after 'along', found {text[:40]!r}")
    return body, found
