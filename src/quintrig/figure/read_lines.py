"""Lines read from a surface, drawn with it: each label in its colour, quiet greys where there are many levels."""

from typing import Any

from quintrig.figure.scene import Trace
from quintrig.interrogation.find import lines as find
from quintrig.interrogation.line import Lines

_FAMILIES = {
    "κ1": ("lines of κ1", "#b2182b"),
    "κ2": ("lines of κ2", "#2166ac"),
    "family 1": ("family 1", "#b2182b"),
    "family 2": ("family 2", "#2166ac"),
    "crest": ("crests", "#b2182b"),
    "trough": ("troughs", "#2166ac"),
    "K = 0": ("parabolic lines, K = 0", "#b2182b"),
    "H = 0": ("H = 0", "#2166ac"),
}
_PLAIN = "#b2182b"


def traces_of(subject: Any, wanted: str | Lines) -> tuple[Trace, ...]:
    """Return lines to draw, of a kind on a surface or model, or those that were found before; ValueError as ``lines``.

    The first line of each family has the label that the picture lists.
    """
    found = find(subject, wanted) if isinstance(wanted, str) else wanted
    told: set[str] = set()
    traces: list[Trace] = []
    for line in found:
        label, colour = _FAMILIES.get(line.label, (_called(found), _PLAIN))
        traces.append(Trace(line.points, "" if label in told else label, colour, 1.1))
        told.add(label)
    return tuple(traces)


def _called(found: Lines) -> str:
    return {"section": "sections", "geodesic": "geodesics", "iso": "parameter lines", "contour": "contours"}.get(
        found.kind, f"{found.kind} lines" if found.kind in ("reflection", "highlight", "draft") else found.kind
    )
