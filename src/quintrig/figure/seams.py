"""The seams of a model in space, each in the colour of the order that it reaches."""

from collections.abc import Sequence

from matplotlib.figure import Figure

from quintrig.figure.camera import ISO, View
from quintrig.figure.palette import INK
from quintrig.figure.scene import Scene, Trace
from quintrig.figure.style import STANDARD, Style
from quintrig.figure.whole import space_picture
from quintrig.geometry.surface import Surface
from quintrig.multipatch.joins import ORDERS, Joins

SEAM_COLOURS: dict[str, str] = {
    "open": "#b2182b",
    "G0": "#e69f00",
    "G1": "#cc79a7",
    "G2": "#0072b2",
    "G3": "#009e73",
}
"""Colours of the orders; open seams are dashed too."""


def seam_traces(joins: Joins) -> tuple[Trace, ...]:
    """Return the seams as lines in space, smooth ones first so that faults lie on top."""
    lines: list[Trace] = []
    for order in reversed(ORDERS):
        found = [join for join in joins.joins if join.order == order]
        label = f"{order} ({len(found)} seam{'s' if len(found) != 1 else ''})"
        lines += [
            Trace(join.points, label if k == 0 else "", SEAM_COLOURS.get(order, INK), 2.4, dashed=order == "open")
            for k, join in enumerate(found)
        ]
    return tuple(lines)


def seam_picture(
    surfaces: Sequence[Surface],
    joins: Joins,
    *,
    title: str = "",
    width: float = 6.4,
    view: View = ISO,
    style: Style = STANDARD,
) -> Figure:
    """Return a picture in space of all surfaces with their seams in the colours of their orders."""
    scene = Scene(view=view, traces=seam_traces(joins))
    return space_picture(surfaces, None, scene, title=title, unit=joins.unit, width=width, style=style)
