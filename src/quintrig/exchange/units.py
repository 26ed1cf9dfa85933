"""Units of length as each format names them."""

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Unit:
    """One unit: millimetres in it, and its names in OpenCASCADE, STEP files, Rhino and DXF ($INSUNITS)."""

    millimetres: float
    opencascade: str
    step: tuple[str, ...]
    rhino: str
    dxf: int


UNITS: dict[str, Unit] = {
    "um": Unit(1e-3, "UM", ("micrometre", "micrometer", "micron"), "Microns", 13),
    "mm": Unit(1.0, "MM", ("millimetre", "millimeter"), "Millimeters", 4),
    "cm": Unit(10.0, "CM", ("centimetre", "centimeter"), "Centimeters", 5),
    "m": Unit(1e3, "M", ("metre", "meter"), "Meters", 6),
    "km": Unit(1e6, "KM", ("kilometre", "kilometer"), "Kilometers", 7),
    "in": Unit(25.4, "INCH", ("inch", "in"), "Inches", 1),
    "ft": Unit(304.8, "FT", ("foot", "feet", "ft"), "Feet", 2),
}
"""Every unit that a model may state."""

ASSUMED = "mm"
"""Written where a model states no unit and the format must."""


def stated(unit: str) -> Unit:
    """Return the unit of a model, millimetres where it states none."""
    return UNITS[unit or ASSUMED]


def named(attribute: str, name: str) -> str:
    """Return the model unit that a format calls ``name``, or an empty string for one that models do not have."""
    for key, unit in UNITS.items():
        names = getattr(unit, attribute)
        known = (names,) if isinstance(names, str) else names
        if name.strip().lower() in [word.lower() for word in known]:
            return key
    return ""


_SPELT = {
    **{word: key for key, unit in UNITS.items() for name in unit.step for word in (key, name, f"{name}s")},
    **{"µm": "um", "μm": "um", "inches": "in"},
}

UNIT_WORDS = "|".join(sorted(map(re.escape, _SPELT), key=len, reverse=True))
"""What matches the name of a unit, in small letters."""

_STATED = re.compile(
    rf"\b(?:units?|lengths?|coordinates|values|dimensions)(?:\s+(?:are|is|of\s+length))?(?:\s+in)?\s*[:=]?\s*[\[(\"']?"
    rf"({UNIT_WORDS})\b"
)


def unit_of(word: str) -> str:
    """Return the model unit that a word names, such as ``inches``, or an empty string."""
    return _SPELT.get(word.strip().lower(), "")


def stated_unit(text: str) -> str:
    """Return the unit that a remark states, as ``Units: inch`` or ``all lengths in mm`` do, or an empty string."""
    found = _STATED.search(text.lower())
    return _SPELT[found[1]] if found else ""
