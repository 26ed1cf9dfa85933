"""Words and numbers on figures: names with symbol and unit, powers of ten, and the note that every figure carries."""

import math
from collections.abc import Sequence

import numpy as np

from quintrig.figure.edge import regression_note
from quintrig.figure.field import Field, changes_sign
from quintrig.figure.scene import single_point
from quintrig.geometry.surface import Surface
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import Quantity
from quintrig.support.arrays import FloatArray

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def exponent(largest: float) -> int:
    """Return the power of ten, a multiple of 3, to take out of numbers up to ``largest``; 0 where they read well."""
    if not largest > 0.0 or not math.isfinite(largest) or 0.01 <= largest < 1e4:
        return 0
    return 3 * math.floor(math.log10(largest) / 3.0)


def number_text(value: float, power: int = 0) -> str:
    """Return value / 10^power, as short as it can be told."""
    text = f"{value / 10.0**power:.4g}"
    return "0" if text in ("-0", "0") else text.replace("-", "−")


def point_text(point: Sequence[float] | FloatArray) -> str:
    """Return the coordinates of a point, such as ``(0, 2.5, −1)``."""
    return f"({', '.join(number_text(float(part)) for part in point)})"


def tick_texts(values: Sequence[float], power: int = 0) -> list[str]:
    """Return evenly spaced values / 10^power with just the decimals that tell them apart."""
    scaled = [value / 10.0**power for value in values]
    if len(scaled) < 2:
        return [number_text(value) for value in scaled]
    step = abs(scaled[1] - scaled[0])
    for decimals in range(13):
        if all(abs(round(value, decimals) - value) <= 1e-3 * step for value in scaled):
            texts = [f"{round(value, decimals) + 0.0:.{decimals}f}" for value in scaled]
            texts = [text.rstrip("0").rstrip(".") if decimals else text for text in texts]
            return [text.replace("-", "−") for text in texts]
    return [number_text(value) for value in scaled]


def plain(text: str) -> str:
    """Return a user's text so that its dollar signs are drawn and enclose no formula."""
    return text.replace("$", "\\$")


def with_unit(name: str, unit: str, power: int = 0) -> str:
    """Return a name with its unit and the power of ten taken out, such as ``x (10⁻³ mm)``."""
    ten = f"$10^{{{power}}}$" if power else ""
    inside = f"{ten} {plain(unit)}".strip() if unit else (f"× {ten}" if ten else "")
    return f"{name} ({inside})" if inside else name


def quantity_label(q: Quantity, unit: str = "", power: int = 0) -> str:
    """Return name, symbol and unit, such as ``Gaussian curvature K (1/mm²)``; ``unit`` is that of length."""
    name = q.name[0].upper() + q.name[1:]
    return with_unit(name if q.kind == "class" else f"{name} ${q.latex}$", q.unit(unit), power)


def normal_note(surface: Surface) -> str:
    """Return which way the normal points, in words."""
    return "normal turned, against $S_u{\\times}S_v$" if surface.flip else "normal along $S_u{\\times}S_v$"


def zeros_note(drawn: Sequence[Quantity]) -> str:
    """Return what the lines mean at which these quantities are zero: dashed for H, solid for the others."""
    rows = {q.key: q for q in drawn}
    others = [q.latex for q in rows.values() if q.key not in ("gaussian", "mean")]
    solid = ""
    if "gaussian" in rows:
        solid = "solid line: $K = 0$"
        solid += f", in pictures of {', '.join(f'${name}$' for name in others)} their own zero" if others else ""
    elif others:
        solid = f"solid line: ${others[0]} = 0$" if len(others) == 1 else "solid line: zero of the quantity shown"
    return "; ".join(part for part in (solid, "dashed line: $H = 0$" if "mean" in rows else "") if part)


def note(
    surfaces: Sequence[Surface],
    fields: Sequence[Field] = (),
    unit: str = "",
    thresholds: Thresholds | None = None,
    outside: float = 0.0,
    *,
    zeros: bool = False,
) -> str:
    """Return the line under a figure: the normal, the unit, what is grey, zero or cut off, and warnings.

    ``zeros`` says what the zero lines of pictures in space mean, each of which shows that of its own quantity only.
    """
    parts: list[str] = []
    ways = {normal_note(surface) for surface in surfaces}
    if ways:
        way = ways.pop() if len(ways) == 1 else "normals along $S_u{\\times}S_v$ on some patches, turned on others"
        parts.append(way[0].upper() + way[1:])
    if surfaces:
        parts.append(f"lengths in {plain(unit)}" if unit else "no unit of length given")
    grey = sum(int(np.count_nonzero(f.undefined)) for f in fields)
    if grey:
        total = sum(f.values.size for f in fields)
        share = f"{100.0 * grey / total:.3g} % of the cells" if grey > 1e-3 * total else f"{grey} of {total} cells"
        parts.append(f"grey: undefined ({share})")
    if any(f.quantity.kind == "class" for f in fields):
        t = thresholds or Thresholds()
        parts.append(f"zero means within {_small(t.relative)} of the curvedness, flat within {_small(t.flat)} / size")
    if zeros and (
        lines := zeros_note([f.quantity for f in fields if f.quantity.colour == "diverging" and changes_sign(f)])
    ):
        parts.append(lines)
    text = "; ".join(parts)
    warnings = [regression_note(surface) for surface in surfaces]
    warnings += dict.fromkeys(line.rstrip(".") for surface in surfaces for line in surface.caveats)
    points = [point for surface in surfaces if (point := single_point(surface)) is not None]
    if points:
        whose = "The surface is" if len(surfaces) == 1 else f"{len(points)} of {len(surfaces)} surfaces are"
        where = point_text(points[0]) if len({tuple(point.tolist()) for point in points}) == 1 else ""
        warnings.append(f"{whose} a single point{f', {where}' if where else ' each'}: it has no curvature")
    if outside > 0.0:
        warnings.append(f"{max(100.0 * outside, 0.1):.3g} % of the surface lies far outside the box and is not drawn")
    return ". ".join([part for part in [text, *warnings] if part])


def _small(value: float) -> str:
    power = math.floor(math.log10(value))
    digits = f"{value / 10.0**power:.3g}"
    return ("" if digits == "1" else f"{digits}·") + f"10{str(power).translate(_RAISED)}"
