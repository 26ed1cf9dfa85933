"""Lines of curvature and umbilics of a patch: the picture, and what is said beside it."""

import math
from collections.abc import Sequence

from matplotlib.figure import Figure

from quintrig.figure import Mark, Scene, space_picture
from quintrig.figure.read_lines import traces_of
from quintrig.figure.style import STANDARD, Style
from quintrig.geometry.surface import Surface
from quintrig.interrogation.find import lines
from quintrig.interrogation.umbilic import Umbilic
from quintrig.report.facts import Facts

_SPACING = 1.0 / 7.0  # of the size
_TOLD = 6  # umbilics by name


def lines_picture(
    surface: Surface, found: Sequence[Umbilic], unit: str, width: float, style: Style = STANDARD
) -> Figure:
    """Return the surface with a net of lines of curvature and the umbilics ``found``."""
    traces = traces_of(surface, lines(surface, "curvature", spacing=_SPACING * surface.size)) if surface.size else ()
    marks = tuple(Mark(one.u, one.v, f"{one.type} {k + 1}") for k, one in enumerate(found[:_TOLD]))
    return space_picture(surface, None, Scene(traces=traces, marks=marks), unit=unit, width=width, style=style)


def _of_index(one: Umbilic) -> str:
    return "" if math.isnan(one.index) else f" of index {one.index:+g}"


def umbilic_words(facts: Facts) -> str:
    """Say how many umbilics there are, of which types, and whether their indices sum as they must."""
    found = facts.umbilics
    unit = f" 1/{facts.unit}" if facts.unit else ""
    if any(region.kind == "region" for region in found.regions):
        return "Here every point is an umbilic: no direction is principal, and there are no such lines."
    curves = sum(region.kind == "curve" for region in found.regions)
    if not found.umbilics:
        said = "There is no isolated umbilic, proved." if found.complete else "No isolated umbilic was found."
    else:
        shown = found.umbilics[:_TOLD]
        ones = "; ".join(
            f"{one.type}{_of_index(one)} at (u, v) = ({one.u:.4g}, {one.v:.4g}), κ = {one.curvature:.3g}{unit}"
            for one in shown
        )
        more = f" and {len(found) - _TOLD} more" if len(found) > _TOLD else ""
        said = f"Umbilics: {ones}{more}{'; it is proved that there are no others' if found.complete else ''}."
    if curves:
        said += f" There {'is a curve' if curves == 1 else f'are {curves} curves'} of umbilics."
    for told in found.sums:
        if told["agree"]:  # the sum is what Poincaré and Hopf ask for
            said += f" Their indices sum to {told['index_sum']:g}, as the turning along the edges demands."
    return said
