"""Demands on all of a surface, such as ``gaussian >= 0``, as smooth functions that are to be 0 or more at every point.

|κ| <= c at both principal curvatures is c - H >= 0, c² - 2cH + K >= 0, c + H >= 0 and c² + 2cH + K >= 0, which are
smooth where κ1 and κ2 are not: at umbilics. What is asked of one curvature alone, such as k1 >= c, takes
H ± √(H² - K). Everything is scaled by the patch's size, so that 1 is as much as a patch of this size bends.
"""

import math
import re
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from quintrig.shaping.forms import forms, pulled_back
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError, nearest
from quintrig.support.numerals import real

CURVATURES = {"gaussian": -2, "mean": -1, "k1": -1, "k2": -1, "curvedness": -1, "curvature_radius": 1}
"""Quantities with a value at each point, by their power of length."""

ANGLES = ("slope", "draft")
"""Angles of the tangent plane with z = const and of the surface with the direction z, degrees."""

TOTALS = {"area": 2, "volume": 3, "bending": 0, "thin_plate": 2, "variation": 2, "deviation": 1}
"""Quantities of all of the surface; ``deviation`` is the largest distance from the target, or from the given patch."""

_SHORT = {"K": "gaussian", "H": "mean", "κ1": "k1", "κ2": "k2", "C": "curvedness", "radius": "curvature_radius"}
_LENGTHS = {"um": 1e-3, "mm": 1.0, "cm": 10.0, "m": 1e3, "km": 1e6, "in": 25.4, "ft": 304.8}
_OPERATORS = {"≥": ">=", "≤": "<=", "=>": ">=", "=<": "<="}
_EXAMPLES = "'gaussian >= 0', 'curvature_radius >= 30', 'area <= 2e6' or 'convex'"
_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"

Pointwise = Callable[[FloatArray, FloatArray], list[tuple[FloatArray, FloatArray, FloatArray]]]
"""From K and H to values that are to be 0 or more, each with its derivatives by K and H."""


@dataclass(frozen=True)
class Demand:
    """A quantity ``key`` that is to be at least (``sign`` 1) or at most (-1) ``bound``, in the model's unit.

    ``text`` is what the user wrote.
    """

    text: str
    key: str
    sign: int
    bound: float

    @property
    def total(self) -> bool:
        """Whether it is of all of the surface, not of each point."""
        return self.key in TOTALS

    @property
    def claim(self) -> str:
        """The demand as a claim to prove, lengths in the model's unit."""
        if self.text.strip().lower() == "convex":
            return "convex"
        degrees = " deg" if self.key in ANGLES else ""
        return f"{self.key} {'>=' if self.sign > 0 else '<='} {self.bound!r}{degrees}"

    def measured(self, partials: FloatArray, sign: float) -> FloatArray:
        """Return the quantity at points, of derivatives (6, k, 3), in powers of the length; radii may be infinite."""
        if self.key in ANGLES:
            up = _upward(partials, sign)
            angle = np.arcsin(np.clip(up, -1.0, 1.0)) if self.key == "draft" else np.arccos(np.clip(abs(up), 0.0, 1.0))
            return np.degrees(angle)
        gauss, mean = _curvatures(partials, sign)
        root = np.sqrt(np.maximum(mean**2 - gauss, 0.0))
        largest = np.abs(mean) + root
        with np.errstate(divide="ignore"):
            values: dict[str, FloatArray] = {
                "gaussian": gauss,
                "mean": mean,
                "k1": mean + root,
                "k2": mean - root,
                "curvedness": np.sqrt(np.maximum(2.0 * mean**2 - gauss, 0.0)),
                "curvature_radius": 1.0 / largest,
            }
        return values[self.key]

    def slack(self, partials: FloatArray, sign: float, size: float, margin: float = 0.0) -> FloatArray:
        """Return what is to be 0 or more at points, of derivatives (6, k, 3): (forms, k), scaled by the size.

        ``margin``, scaled too, is by how much more than the bound is asked for.
        """
        if self.key in ANGLES:
            return np.stack([value for value, _ in self._tilts(_upward(partials, sign))]) - margin
        gauss, mean = _curvatures(partials, sign)
        return np.stack([value for value, _, _ in self._forms(size, margin)(gauss * size**2, mean * size)])

    def slack_and_gradient(
        self, partials: FloatArray, sign: float, size: float, margin: float = 0.0
    ) -> tuple[FloatArray, list[FloatArray]]:
        """Return ``slack`` and the gradient of each form by the derivatives, (6, k, 3)."""
        at = forms(partials[1:])
        area = np.maximum(at.area2, np.finfo(float).tiny)
        gradients: list[FloatArray] = []
        values: list[FloatArray] = []
        nothing = np.zeros_like(area)
        if self.key in ANGLES:
            up = _upward(partials, sign)
            for value, slope in self._tilts(up):
                cross = np.zeros_like(at.cross)
                cross[:, 2] = slope * sign / np.sqrt(area)
                gradient = pulled_back(at, nothing, nothing, slope * -0.5 * up / area, cross)
                gradients.append(np.concatenate([np.zeros_like(partials[:1]), gradient]))
                values.append(value - margin)
            return np.stack(values), gradients
        gauss, mean = at.gauss / area**2, 0.5 * sign * at.mean / area**1.5
        for value, by_gauss, by_mean in self._forms(size, margin)(gauss * size**2, mean * size):
            k, h = by_gauss * size**2, by_mean * size
            by_area = -2.0 * k * gauss / area - 1.5 * h * mean / area
            gradient = pulled_back(at, k / area**2, 0.5 * sign * h / area**1.5, by_area)
            gradients.append(np.concatenate([np.zeros_like(partials[:1]), gradient]))
            values.append(value)
        return np.stack(values), gradients

    def _tilts(self, up: FloatArray) -> list[tuple[FloatArray, FloatArray]]:
        """Return the forms of an angle by n·z, with their derivatives."""
        ones = np.ones_like(up)
        if self.key == "draft":
            return [(self.sign * (up - math.sin(math.radians(self.bound))), self.sign * ones)]
        c = math.cos(math.radians(self.bound))
        steep = np.where(up < 0.0, -1.0, 1.0)  # slope is that of the tangent plane, whichever way the normal points
        return [(-self.sign * (steep * up - c), -self.sign * steep)]

    def _forms(self, size: float, margin: float) -> Pointwise:
        # The bound itself is moved: a product such as (c - κ1)(c - κ2) falls with the square of what is left.
        if self.key == "curvature_radius":
            c = size / self.bound - self.sign * margin
            return _within(c) if self.sign > 0 else _one_beyond(c)
        return _FORMS[self.key, self.sign](self.bound * size ** -CURVATURES[self.key] + self.sign * margin)


# A form of K and H: its value, and its derivatives by K and by H.


def _within(c: float) -> Pointwise:
    """|κ1| <= c and |κ2| <= c."""

    def values(k: FloatArray, h: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
        return [*_below(c)(k, h), *_above(-c)(k, h)]

    return values


def _below(c: float) -> Pointwise:
    """κ1 <= c."""
    scale = 1.0 / max(abs(c), 1.0)

    def values(k: FloatArray, h: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
        one, none = np.ones_like(h), np.zeros_like(h)
        return [(c - h, none, -one), (scale * (c * c - 2.0 * c * h + k), scale * one, -2.0 * scale * c * one)]

    return values


def _above(c: float) -> Pointwise:
    """κ2 >= c."""
    scale = 1.0 / max(abs(c), 1.0)

    def values(k: FloatArray, h: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
        one, none = np.ones_like(h), np.zeros_like(h)
        return [(h - c, none, one), (scale * (c * c - 2.0 * c * h + k), scale * one, -2.0 * scale * c * one)]

    return values


def _root(k: FloatArray, h: FloatArray) -> FloatArray:
    return np.sqrt(np.maximum(h * h - k, 0.0) + 1e-16)  # above 0: at umbilics it has no derivative


def _larger(c: float) -> Pointwise:
    """κ1 >= c."""

    def values(k: FloatArray, h: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
        r = _root(k, h)
        return [(h + r - c, -0.5 / r, 1.0 + h / r)]

    return values


def _smaller(c: float) -> Pointwise:
    """κ2 <= c."""

    def values(k: FloatArray, h: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
        r = _root(k, h)
        return [(c - h + r, -0.5 / r, -1.0 + h / r)]

    return values


def _one_beyond(c: float) -> Pointwise:
    """The larger of |κ1| and |κ2| is c or more."""

    def values(k: FloatArray, h: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
        r = _root(k, h)
        return [(np.abs(h) + r - c, -0.5 / r, np.sign(h) + h / r)]

    return values


def _gauss(sign: int) -> Callable[[float], Pointwise]:
    def bounded(c: float) -> Pointwise:
        def values(k: FloatArray, h: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
            return [(sign * (k - c), np.full_like(k, sign), np.zeros_like(k))]

        return values

    return bounded


def _mean(sign: int) -> Callable[[float], Pointwise]:
    def bounded(c: float) -> Pointwise:
        def values(k: FloatArray, h: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
            return [(sign * (h - c), np.zeros_like(h), np.full_like(h, sign))]

        return values

    return bounded


def _curved(sign: int) -> Callable[[float], Pointwise]:
    def bounded(c: float) -> Pointwise:
        scale = 1.0 / max(c, 1e-3)

        def values(k: FloatArray, h: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
            form = sign * scale * (2.0 * h * h - k - c * c)
            return [(form, np.full_like(k, -sign * scale), sign * scale * 4.0 * h)]

        return values

    return bounded


_FORMS: dict[tuple[str, int], Callable[[float], Pointwise]] = {
    ("gaussian", 1): _gauss(1),
    ("gaussian", -1): _gauss(-1),
    ("mean", 1): _mean(1),
    ("mean", -1): _mean(-1),
    ("k1", 1): _larger,
    ("k1", -1): _below,
    ("k2", 1): _above,
    ("k2", -1): _smaller,
    ("curvedness", 1): _curved(1),
    ("curvedness", -1): _curved(-1),
}


def _curvatures(partials: FloatArray, sign: float) -> tuple[FloatArray, FloatArray]:
    at = forms(partials[1:])
    with np.errstate(divide="ignore", invalid="ignore"):
        return at.gauss / at.area2**2, 0.5 * sign * at.mean / at.area2**1.5


def _upward(partials: FloatArray, sign: float) -> FloatArray:
    at = forms(partials[1:])
    with np.errstate(divide="ignore", invalid="ignore"):
        return sign * at.cross[..., 2] / np.sqrt(at.area2)


# ------------------------------------------------------------------------------------------------------ as written


def demands(text: str, unit: str = "") -> tuple[Demand, ...]:
    """Return what a text asks for: one demand, or two for a range and for ``convex``; ValueError for anything else."""
    words = " ".join(text.split())
    for sign, plain in _OPERATORS.items():
        words = words.replace(sign, plain)
    if words.lower() == "convex":
        return (Demand(text, "gaussian", 1, 0.0),)
    parts = re.split(r"\s*(>=|<=|==|=|>|<)\s*", words)
    wrong = ValueError(f"demands: expected one such as {_EXAMPLES}, found {text[:60]!r}")
    if len(parts) == 5 and parts[1][0] == parts[3][0] and parts[1][0] in "<>":
        low, first, name, second, high = parts
        return (_demand(text, name, _turned(first), low, unit), _demand(text, name, second, high, unit))
    if len(parts) != 3:
        raise wrong
    left, sign, right = parts
    if sign in ("=", "=="):
        raise ValueError(f"demands: {text[:60]!r}: expected >= or <=, found {sign}; no surface meets it exactly")
    if re.match(_NUMBER, left):
        left, sign, right = right, _turned(sign), left
    return (_demand(text, left, sign, right, unit),)


def _turned(sign: str) -> str:
    return ("<" if sign[0] == ">" else ">") + sign[1:]


def _demand(text: str, name: str, sign: str, value: str, unit: str) -> Demand:
    key = _SHORT.get(name.strip(), name.strip().lower().replace(" ", "_").replace("-", "_"))
    known = (*CURVATURES, *ANGLES, *TOTALS)
    if key not in known:
        raise ValueError(
            f"demands: no quantity {name.strip()[:60]!r}{nearest(key, known)}; there are {', '.join(known)}"
        )
    bound = _value(text, key, value, unit)
    up = 1 if sign[0] == ">" else -1
    if key == "curvature_radius" and not bound > 0.0:
        raise ValueError(f"demands: {text[:60]!r}: expected a radius greater than 0")
    if key in ("curvedness", "area", "bending", "thin_plate", "variation", "deviation") and bound < 0.0:
        raise ValueError(f"demands: {text[:60]!r}: expected 0 or more, which {key} always is")
    if key in ANGLES and not -90.0 <= bound <= 90.0:
        raise ValueError(f"demands: {text[:60]!r}: expected an angle from -90 to 90 degrees")
    if key == "deviation" and up > 0:
        raise ValueError(f"demands: {text[:60]!r}: expected deviation <= a length")
    return Demand(text, key, up, bound)


def _value(text: str, key: str, value: str, unit: str) -> float:
    """Return a number with or without a unit, in the model's."""
    found = re.match(rf"({_NUMBER})\s*(.*)$", value.strip())
    if not found:
        raise ValueError(f"demands: {text[:60]!r}: expected a number to compare {key} with, found {value[:40]!r}")
    number, given = real(found[1]), found[2].strip()
    if not given:
        return number
    if key in ANGLES:
        if given not in ("deg", "°", "degrees", "rad"):
            raise ValueError(f"demands: {text[:60]!r}: expected deg or rad, found {given[:20]!r}")
        return math.degrees(number) if given == "rad" else number
    power = {**CURVATURES, **TOTALS}[key]
    plain = given.replace("²", "2").replace("³", "3").replace("^", "").replace(" ", "")
    parts = re.fullmatch(r"(1?/)?([a-z]+?)([23]?)", plain)
    raised = int(parts[3] or 1) * (-1 if parts[1] else 1) if parts else 0
    if parts is None or parts[2] not in _LENGTHS or raised != power:
        wanted = {1: "mm", 2: "mm²", 3: "mm³", -1: "1/mm", -2: "1/mm²", 0: "no unit"}[power]
        raise ValueError(f"demands: {text[:60]!r}: expected a unit such as {wanted}, found {given[:20]!r}")
    if not unit:
        raise ModelError(f"demands: {text[:60]!r}: the model states no unit; expected a plain number")
    return number * (_LENGTHS[parts[2]] / _LENGTHS[unit]) ** power
