"""Diagrams that explain the classifications with little canonical patches z = (κ1 x² + κ2 y²)/2, normal upwards."""

import numpy as np
from matplotlib.figure import Figure

from quintrig.basis.elementary import Powers
from quintrig.figure.camera import View
from quintrig.figure.palette import CLASS_COLOURS, INK
from quintrig.figure.sheet import Area, Axes, new_figure
from quintrig.figure.space import Scene, draw_space
from quintrig.geometry.surface import Net, Surface
from quintrig.quantities.classify import HK_TYPES, SHAPE_CLASSES
from quintrig.support.arrays import FloatArray

_VIEW = View("oblique view", -60.0, 24.0)
_BOX = (np.array([-0.95, -0.95, -0.55]), np.array([0.95, 0.95, 0.55]))
_SCENE = Scene(view=_VIEW, frame=False, isolines=5, cells=36, regression=False)
_SIZE = 8.5
_MINUS = "−"


def canonical_patch(k1: float, k2: float) -> Surface:
    """Return z = (k1 x² + k2 y²)/2 over |x|, |y| <= 1: at the middle κ1, κ2 are k1 and k2, n upwards."""
    points: FloatArray = np.zeros((3, 3, 3))
    points[1, 0, 0] = points[0, 1, 1] = 1.0
    points[2, 0, 2], points[0, 2, 2] = 0.5 * k1, 0.5 * k2
    return Surface(Net(points, Powers(-1.0, 1.0, 2)), Powers(-1.0, 1.0, 2))


def scale_patch(index: float) -> Surface:
    """Return the canonical patch of a shape index from -1 to +1, the normal towards the viewer being upwards."""
    h, r = -np.sin(0.5 * np.pi * index), np.cos(0.5 * np.pi * index)
    return canonical_patch(0.9 * (h + r), 0.9 * (h - r))


def hk_table(width: float = 6.4) -> Figure:
    """Return the eight surface types in the table of the signs of H and K (Besl; thesis figures 2.6 and 3.5)."""
    left, head, foot, step = 0.62, 0.36, 0.3, (width - 0.72) / 3.0
    tall = 0.86 * step
    height = head + 3 * tall + foot
    figure = new_figure(width, height)
    page = Area(figure, 0.0, 0.0, width, height)
    back = page.axes()
    back.set_axis_off()
    back.set_xlim(0.0, width)
    back.set_ylim(0.0, height)
    for column, sign in enumerate((">", "=", "<")):
        _write(back, left + (column + 0.5) * step, height - 0.5 * head, f"$K {sign} 0$", 11.0)
    for row, sign in enumerate(("<", "=", ">")):
        _write(back, 0.5 * left, height - head - (row + 0.5) * tall, f"$H {sign} 0$", 11.0)
    ends = {-1: (-0.9, -0.9), 0: (0.0, 0.0), 1: (0.9, 0.9)}
    for row, h in enumerate((-1, 0, 1)):
        for column, k in enumerate((1, 0, -1)):
            code = 1 + 3 * (1 + h) + (1 - k)
            area = Area(figure, left + column * step, height - head - (row + 1) * tall, step, tall)
            if code == 4:
                _write(back, area.left + 0.5 * step, area.bottom + 0.5 * tall, "impossible:\n$H^2 \\geq K$", _SIZE)
            else:
                k1, k2 = tile_curvatures(h, k, ends)
                _tile(area, canonical_patch(k1, k2), CLASS_COLOURS["hk_type"][code], HK_TYPES[code], _signs(k1, k2))
    for i in range(4):
        back.plot([left + i * step] * 2, [foot, height - 0.06], color="#dcdcdc", linewidth=0.7)
        back.plot([0.1, width - 0.1], [foot + i * tall] * 2, color="#dcdcdc", linewidth=0.7)
    _write(back, 0.5 * width, 0.5 * foot, "seen with the normal towards the viewer, here upwards", 7.5)
    return figure


def shape_scale(width: float = 9.0) -> Figure:
    """Return the nine shape classes along the shape index from -1 to +1 (Koenderink; thesis figure 2.7)."""
    step = (width - 0.4) / 9.0
    tall = 0.9 * step
    height = tall + 1.0
    figure = new_figure(width, height)
    centres = np.linspace(-1.0, 1.0, 9)
    for index, s in enumerate(centres.tolist()):
        area = Area(figure, 0.2 + index * step, height - tall - 0.08, step, tall)
        _draw_patch(area.axes(), scale_patch(s), CLASS_COLOURS["shape_class"][index + 1])
    bar = Area(figure, 0.0, 0.0, width, 0.95).axes()
    bar.set_axis_off()
    bar.set_xlim(0.0, width)
    bar.set_ylim(0.0, 0.95)
    # Each class has one tile's width on the bar: the two end classes are half as wide in S.
    for index, s in enumerate(centres.tolist()):
        x = 0.2 + index * step
        colour = CLASS_COLOURS["shape_class"][index + 1]
        bar.fill([x, x + step, x + step, x], [0.44, 0.44, 0.6, 0.6], facecolor=colour, edgecolor="white", linewidth=0.8)
        _write(bar, x + 0.5 * step, 0.76, SHAPE_CLASSES[index + 1], _SIZE)
        if index:
            _write(bar, x, 0.32, _eighths(s - 0.125), _SIZE - 1.0)
    _write(bar, 0.2, 0.32, f"{_MINUS}1", _SIZE - 1.0)
    _write(bar, width - 0.2, 0.32, "1", _SIZE - 1.0)
    _write(bar, 0.5 * width, 0.1, "shape index $S$, seen with the normal towards the viewer, here upwards", _SIZE)
    return figure


def tile_curvatures(h: int, k: int, ends: dict[int, tuple[float, float]]) -> tuple[float, float]:
    """Return typical k1, k2 for the signs of H and K."""
    if k > 0:
        return ends[h]
    if k == 0:
        return (0.0, 0.0) if h == 0 else (0.9, 0.0) if h > 0 else (0.0, -0.9)
    return {-1: (0.35, -0.9), 0: (0.8, -0.8), 1: (0.9, -0.35)}[h]


def _signs(k1: float, k2: float) -> str:
    def one(name: str, value: float) -> str:
        return f"\\kappa_{name} {'=' if value == 0.0 else '>' if value > 0.0 else '<'} 0"

    extra = ""
    if k1 * k2 < 0.0:
        extra = "=" if k1 == -k2 else "<" if k1 < -k2 else ">"
        extra = f",\\; \\kappa_1 {extra} -\\kappa_2"
    return f"${one('1', k1)},\\; {one('2', k2)}{extra}$"


def _tile(area: Area, patch: Surface, colour: str, name: str, signs: str) -> None:
    _draw_patch(area.inside(0.05, 0.36, area.width - 0.1, area.height - 0.4), patch, colour)
    axes = area.axes()
    axes.set_axis_off()
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(0.0, area.height)
    _write(axes, 0.5, 0.32, name, _SIZE + 0.5)
    _write(axes, 0.5, 0.13, signs, _SIZE - 1.0)


def _draw_patch(axes: Axes, patch: Surface, colour: str) -> None:
    ends = np.array([0.0, 0.5, 1.0])
    heights = patch(ends[:, None], ends[None, :])[..., 2]
    middle = np.array([0.0, 0.0, 0.5 * float(heights.max() + heights.min())])
    draw_space(axes, [patch], _SCENE, colours=[colour], box=(_BOX[0] + middle, _BOX[1] + middle))


def _eighths(s: float) -> str:
    count = round(8.0 * abs(s))
    return f"{_MINUS if s < 0.0 else ''}{count}/8"


def _write(axes: Axes, x: float, y: float, text: str, size: float) -> None:
    axes.text(x, y, text, fontsize=size, color=INK, ha="center", va="center", linespacing=1.4)
