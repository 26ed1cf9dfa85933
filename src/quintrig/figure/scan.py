"""Pictures of a scan: its points or triangles in the colours of their curvature."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from quintrig.figure.camera import ISO, View, read_view
from quintrig.figure.field import stretched
from quintrig.figure.palette import class_colours, colour_map, real_colours
from quintrig.figure.picture import Picture
from quintrig.figure.style import STANDARD, Style
from quintrig.figure.wording import quantity_label
from quintrig.quantities.table import Quantity, quantity
from quintrig.scan.curvature import ScanCurvature
from quintrig.scan.scan import Scan
from quintrig.support.arrays import FloatArray

_LEAST = 3.0  # inches across a picture with its scale
_ROOM = 0.78  # of the axes: numbers and names stand outside
_END_ON = 0.98  # cosine: an axis seen so has no room for numbers
_MOST = 60_000  # points or triangles drawn


def scan_picture(
    subject: ScanCurvature | Scan,
    keys: Sequence[str] = (),
    *,
    view: View = ISO,
    title: str = "",
    width: float = 6.4,
    style: Style = STANDARD,
) -> Figure:
    """Return a scan in the colours of quantities side by side, or in one colour without any.

    Of a style it takes what is no matter of surfaces: not the note, levels, net, lines and marks.
    """
    width, view = style.across(width), view if style.view is None else read_view(style.view)
    scan = subject.scan if isinstance(subject, ScanCurvature) else subject
    count = max(len(keys), 1)
    columns = max(1, min(count, int(width / _LEAST)))
    rows = -(-count // columns)
    high = (0.78 if columns == 1 else 0.84) * width / columns
    figure = Picture(figsize=(width, rows * high), layout="constrained")
    for index, key in enumerate(keys or ("",)):
        axes: Any = figure.add_subplot(rows, columns, index + 1, projection="3d")
        axes.view_init(elev=view.elevation, azim=view.azimuth)
        axes.set_proj_type("ortho")  # as all pictures in space, with true proportions
        if not key or not isinstance(subject, ScanCurvature):
            _draw(axes, scan, np.tile(to_rgb("0.6"), (len(scan.points), 1)), shade=True)
        else:
            q = quantity(key)
            _draw(axes, scan, _coloured(figure, axes, subject, q, style), shade=False, classes=q.kind == "class")
            if style.title:
                axes.set_title(quantity_label(q), fontsize=9)
        axes.set_aspect("equal")
        axes.set_box_aspect(axes.get_box_aspect(), zoom=_ROOM)
        axes.tick_params(labelsize=6)
        for axis, towards in zip("xyz", view.axes[2].tolist(), strict=True):
            if abs(towards) > _END_ON:
                getattr(axes, f"set_{axis}ticks")([])
                continue
            getattr(axes, f"{axis}axis").set_major_locator(MaxNLocator(_intervals(scan, "xyz".index(axis))))
            getattr(axes, f"set_{axis}label")(f"{axis} ({scan.unit})" if scan.unit else axis, fontsize=7)
    if title and style.title:
        drawn: Any = figure
        drawn.suptitle(title, fontsize=11)
    return style.finish(figure)


def _intervals(scan: Scan, axis: int) -> int:
    """Return how many intervals between its numbers an axis has room for: four on the longest."""
    spans = np.ptp(scan.points, axis=0)
    return max(1, min(4, round(8.0 * float(spans[axis] / max(float(spans.max()), np.finfo(float).tiny)))))


def _coloured(figure: Any, axes: Any, found: ScanCurvature, q: Quantity, style: Style) -> FloatArray:
    """Return the colours (n, 3) of the points, and draw the scale beside the axes."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    from matplotlib.patches import Patch

    values = found[q.key]
    if q.kind == "class":
        colours = class_colours(values, q.key)
        there = [int(code) for code in np.unique(values)]
        patches = [Patch(color=colours[int(np.argmax(values == code))], label=q.classes[code]) for code in there]
        axes.legend(
            handles=patches, fontsize=6, loc="upper center", bbox_to_anchor=(0.5, -0.06), ncols=2, frameon=False
        )
        return colours
    inner = np.where(found.border, np.nan, values)  # borders are worse, and would stretch the scale
    stretch = stretched([inner], q, style)
    unit = q.unit(found.scan.unit)
    shade = ScalarMappable(Normalize(stretch.low, stretch.high), colour_map(q, stretch.colours))
    bar: Any = figure.colorbar(shade, ax=axes, shrink=0.6, pad=0.16)
    bar.set_label(f"{q.symbol} ({unit})" if unit else q.symbol, fontsize=8)
    bar.ax.tick_params(labelsize=7)
    return real_colours(values, q, stretch)


def _draw(axes: Any, scan: Scan, colours: FloatArray, shade: bool, classes: bool = False) -> None:
    p = scan.points
    if scan.triangles is not None and len(scan.triangles) <= _MOST:
        faces = axes.plot_trisurf(*p.T, triangles=scan.triangles, shade=False, linewidth=0.0, antialiased=False)
        a, b, c = (colours[scan.triangles[:, k]] for k in range(3))
        # Of classes a triangle shows the one of most of its corners: a mixture would be another.
        shades = np.where((b == c).all(axis=1)[:, None], b, a) if classes else (a + b + c) / 3.0
        faces.set_facecolors(shades * _lit(scan)[:, None] if shade else shades)
        return
    chosen = np.linspace(0, len(p) - 1, min(len(p), _MOST)).astype(int)
    size = max(1.0, min(14.0, 30_000 / len(chosen)))
    axes.scatter(*p[chosen].T, c=colours[chosen], s=size, linewidths=0.0, depthshade=False)


def _lit(scan: Scan) -> FloatArray:
    """Return how bright each triangle is (m,), from one half to one, by the tilt of its plane."""
    a, b, c = (scan.points[scan.triangles][:, k] for k in range(3))
    across = np.cross(b - a, c - a)
    return 0.5 + 0.5 * np.abs(across[:, 2]) / np.maximum(np.linalg.norm(across, axis=1), 1e-300)
