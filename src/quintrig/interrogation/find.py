"""``quintrig.lines``: every kind of line on a surface or a model by its name."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from quintrig.geometry.surface import Surface
from quintrig.interrogation import by_flow, by_level, by_light, by_section
from quintrig.interrogation.ask import Ask, length, refuse_others
from quintrig.interrogation.found import Found
from quintrig.interrogation.line import Line, Lines
from quintrig.interrogation.polyline import chained
from quintrig.interrogation.subject import Subject
from quintrig.model.model import Model
from quintrig.model.patch import Patch
from quintrig.support.errors import nearest
from quintrig.support.progress import Progress, watched

_CHORD = 1e-4  # of the size
_SEAM = 1e-4  # of the size: ends this near are one line


@dataclass(frozen=True)
class Kind:
    """One kind of lines: what finds them, which options it takes, and what it is in words."""

    find: Callable[[Subject, Ask], Found]
    takes: tuple[str, ...]
    words: str


_FLOW = ("start", "patch", "spacing", "family", "length")

KINDS: dict[str, Kind] = {
    "curvature": Kind(by_flow.curvature, (*_FLOW, "umbilics"), "lines of curvature: through a point, or a net"),
    "asymptotic": Kind(by_flow.asymptotic, _FLOW, "lines in whose direction the surface does not bend (K < 0)"),
    "parabolic": Kind(by_level.parabolic, ("patch",), "where K = 0"),
    "mean-zero": Kind(by_level.mean_zero, ("patch",), "where H = 0"),
    "ridges": Kind(by_level.ridge_lines, ("patch", "family"), "crests and troughs, with their strength"),
    "isophotes": Kind(by_light.isophotes, ("patch", "direction", "angles", "count"), "equal angle to the light"),
    "reflection": Kind(
        by_light.reflection,
        ("patch", "light", "along", "eye", "direction", "spacing", "count"),
        "what parallel lights look like in the surface",
    ),
    "highlight": Kind(
        by_light.highlight, ("patch", "light", "along", "spacing", "count"), "where the normal meets a line of light"
    ),
    "silhouette": Kind(by_light.silhouette, ("patch", "direction", "eye"), "the outline, seen from afar or a point"),
    "contour": Kind(by_level.contour, ("patch", "quantity", "levels", "count"), "where a quantity has a value"),
    "section": Kind(
        by_section.section,
        ("patch", "normal", "through", "spacing", "count", "other"),
        "cut by a plane, a stack of planes, or another surface",
    ),
    "geodesic": Kind(
        by_flow.geodesic,
        ("start", "patch", "direction", "length", "to", "to_patch"),
        "straight on the surface: in a direction, or between two points",
    ),
    "iso": Kind(by_section.iso, ("patch", "u", "v", "count"), "parameter lines"),
    "draft": Kind(by_light.draft, ("patch", "direction", "angles"), "equal draft angle to the pull direction"),
}
"""All kinds by name."""

ALIASES = {
    "draft-angle": "draft",
    "geodesics": "geodesic",
    "sections": "section",
    "contours": "contour",
    "crests": "ridges",
}


@watched
def lines(subject: Surface | Patch | Model, kind: str, *, progress: Progress | None = None, **options: Any) -> Lines:
    """Return lines of one kind on a surface, or on all patches of a model, across their seams.

    ``kind`` is curvature, asymptotic, parabolic, mean-zero, ridges, isophotes, reflection, highlight, silhouette,
    contour, section, geodesic, iso or draft. Options: ``patch`` by its name; ``start`` and ``to`` (u, v), with
    ``to_patch``; ``direction`` (x, y, z), or degrees from S_u for geodesics; ``eye``, ``light``, ``through`` (x, y, z);
    ``along`` and ``normal`` (x, y, z); ``angles`` in degrees; ``quantity`` and ``levels``; ``count``; ``spacing`` and
    ``length`` (length¹); ``other``, a surface; ``u`` and ``v``; ``family`` 1 or 2; ``umbilics`` True for the lines
    that leave umbilics. ``tolerance`` (length¹, by default 1e-4 of the size) bounds the chord error. Raises ValueError
    for an unknown kind, an option that it does not take, and what cannot be used.
    """
    name = ALIASES.get(kind, kind)
    if name not in KINDS:
        raise ValueError(f"kind: expected one of {', '.join(KINDS)}, got {kind[:40]!r}{nearest(kind, KINDS)}")
    unknown = [key for key in options if key not in Ask.__dataclass_fields__]
    if unknown:
        raise ValueError(f"{unknown[0]}: {name} lines take {', '.join(KINDS[name].takes)}, not this")
    ask = Ask(**options)
    refuse_others(name, ask, KINDS[name].takes)
    on = Subject.of(subject, ask.patch if name not in ("geodesic", "curvature", "asymptotic") else None, progress)
    on = on.within(length(ask.tolerance, "tolerance", _CHORD * on.size))
    found = KINDS[name].find(on, ask)
    return Lines(
        name, _chained(found, on), found.quantity, found.unit, on.unit, on.chord, tuple(dict.fromkeys(found.notes))
    )


def _chained(found: Found, on: Subject) -> tuple[Line, ...]:
    """Return the lines with their chain numbers: as they were traced, or by ends that meet."""
    return tuple(found.lines) if found.traced else chained(found.lines, _SEAM * on.size)
