"""What a style puts into a scene; lines read from a surface, each label in its colour."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from quintrig.figure.camera import read_view
from quintrig.figure.scene import Mark, Scene, Trace
from quintrig.figure.style import Style
from quintrig.geometry.surface import Surface
from quintrig.interrogation.find import lines as find
from quintrig.interrogation.line import Lines
from quintrig.support.arrays import parameter

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


def staged(scene: Scene, style: Style, surfaces: Sequence[Surface]) -> Scene:
    """Return a scene with what the style asks for in the place of its own; ValueError for no kind of lines."""
    if style.view is not None:
        scene = replace(scene, view=read_view(style.view))
    if style.net is not None:
        scene = replace(scene, net=style.net)
    if isinstance(style.lines, int):
        scene = replace(scene, isolines=style.lines)
    elif style.lines is not None:
        found = [trace for surface in surfaces for trace in traces_of(surface, style.lines)]
        scene = replace(scene, isolines=0, traces=(*scene.traces, *_labelled_once(found)))
    return replace(scene, marks=(*scene.marks, *marks_at(style.at)))


def marks_at(at: Sequence[tuple[float, float]]) -> tuple[Mark, ...]:
    """Return marks at parameters (u, v), numbered where there are several; ValueError outside the domain."""
    for u, v in at:
        parameter(u, "u")
        parameter(v, "v")
    return tuple(Mark(u, v, f"P{i + 1}" if len(at) > 1 else "P") for i, (u, v) in enumerate(at))


def traces_of(subject: Any, wanted: str | Lines) -> tuple[Trace, ...]:
    """Return lines to draw, of a kind on a surface or model, or those that were found before; ValueError as ``lines``.

    The first line of each family has the label that the picture lists.
    """
    found = find(subject, wanted) if isinstance(wanted, str) else wanted
    named = [(line, *_FAMILIES.get(line.label, (_called(found), _PLAIN))) for line in found]
    return _labelled_once(Trace(line.points, label, colour, 1.1) for line, label, colour in named)


def _labelled_once(traces: Iterable[Trace]) -> tuple[Trace, ...]:
    """Return traces of which the first of each label alone has it."""
    told: set[str] = set()
    result: list[Trace] = []
    for trace in traces:
        result.append(replace(trace, label="") if trace.label in told else trace)
        told.add(trace.label)
    return tuple(result)


def _called(found: Lines) -> str:
    return {"section": "sections", "geodesic": "geodesics", "iso": "parameter lines", "contour": "contours"}.get(
        found.kind, f"{found.kind} lines" if found.kind in ("reflection", "highlight", "draft") else found.kind
    )
