"""Units of length as each format names them."""

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
