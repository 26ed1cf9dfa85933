"""Zebra stripes in a picture: a room of striped lamps, reflected, whose stripes kink where a seam is not smooth."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from quintrig.figure.camera import ISO, View
from quintrig.figure.frame import panel_size
from quintrig.figure.read_lines import staged
from quintrig.figure.scene import Scene, Trace, bounds, thinned
from quintrig.figure.sheet import sheet
from quintrig.figure.space import draw_space
from quintrig.figure.style import STANDARD, Style
from quintrig.geometry.domain import face_grid
from quintrig.geometry.surface import Surface
from quintrig.support.arrays import FloatArray

STRIPES = 12
"""Bright stripes from one side of the room to the other."""

_DARK, _BRIGHT = np.array([0.09, 0.11, 0.15]), np.array([0.97, 0.97, 0.95])
_SHARP = 6.0  # of a stripe's edge: it fades over about a tenth of the stripe
_NOTE = "zebra stripes break at a seam that is G0, kink at G1, run on smoothly from G2"


def stripes(surface: Surface, view: View, cells: int) -> FloatArray:
    """Return the colours (cells, cells, 3) of stripes reflected to the camera, from the surface's own normals."""
    u, v = (0.5 * (nodes[1:] + nodes[:-1]) for nodes in (x.ravel() for x in face_grid(surface, cells + 1, cells + 1)))
    s = surface.partials(u[:, None], v[None, :], 1)
    normal = np.cross(s[1, 0], s[0, 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        normal = normal / np.linalg.norm(normal, axis=-1, keepdims=True)
    towards = view.axes[2]
    reflected = 2.0 * (normal @ towards)[..., None] * normal - towards
    # The lamps run to the right; a stripe is a range of angles about that axis.
    angle = np.arctan2(reflected @ view.axes[1], reflected @ towards)
    light = np.clip(0.5 + _SHARP * np.sin(STRIPES * np.nan_to_num(angle)) / 2.0, 0.0, 1.0)[..., None]
    return _DARK + light * (_BRIGHT - _DARK)


def zebra_picture(
    surfaces: Sequence[Surface],
    *,
    view: View = ISO,
    title: str = "",
    unit: str = "",
    traces: Sequence[Trace] = (),
    width: float = 6.4,
    style: Style = STANDARD,
) -> Figure:
    """Return a picture in space of surfaces that reflect a striped room: ``STRIPES`` lamps that run across the view."""
    width = style.across(width)
    scene = thinned(
        staged(Scene(view=view, traces=tuple(traces), rims=False, cells=160), style, surfaces), len(surfaces)
    )
    box = bounds(surfaces, scene, style)
    panel = panel_size(scene.view, *box, width - 0.2, scene.frame)
    lengths = f"; lengths in {unit}" if unit else ""
    page = sheet(1, panel, title=title, note=f"{_NOTE[0].upper()}{_NOTE[1:]}{lengths}", key="none", style=style)
    tints = [stripes(surface, scene.view, scene.cells) for surface in surfaces]
    draw_space(page.panels[0].axes(), surfaces, scene, tints=tints, unit=unit, box=box)
    return style.finish(page.figure)
