"""The stage of a 3-D picture: scale, box with ticks, and labels, drawn in the plane of the picture."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.ticker import MaxNLocator

from quintrig.figure.camera import View
from quintrig.figure.palette import INK
from quintrig.figure.sheet import Axes, points_wide
from quintrig.figure.wording import exponent, tick_texts, with_unit
from quintrig.support.arrays import FloatArray

_MARGINS = (42.0, 30.0, 36.0, 8.0)  # points kept free for tick labels: left, right, bottom, top
_NARROW = (34.0, 22.0, 36.0, 8.0)
_SMALL = 190.0  # points: a narrow panel
_BARE = (6.0, 6.0, 6.0, 6.0)
_TICK, _NAME = 7.5, 8.5  # font sizes; a little smaller in narrow panels


@dataclass(frozen=True, eq=False)
class Stage:
    """An axes set up for one view of a box ``low`` to ``high`` (3,); ``point`` is a printer's point in length¹."""

    axes: Axes
    view: View
    low: FloatArray
    high: FloatArray
    point: float


def set_stage(
    axes: Axes, view: View, low: FloatArray, high: FloatArray, framed: bool, point: float | None = None
) -> Stage:
    """Scale the axes, equal in all directions, so that the box and its labels fit, or to ``point`` if given."""
    corners = _corners(view, low, high)
    size = points_wide(axes)
    point = point or point_length(view, low, high, size, framed)
    left, right, bottom, top = _margins(size[0], framed)
    middle = 0.5 * (corners.min(axis=0) + corners.max(axis=0))
    x0 = middle[0] - 0.5 * (size[0] + left - right) * point
    y0 = middle[1] - 0.5 * (size[1] + bottom - top) * point
    axes.set_axis_off()
    axes.set_xlim(x0, x0 + size[0] * point)
    axes.set_ylim(y0, y0 + size[1] * point)
    axes.set_aspect("equal", adjustable="box")
    return Stage(axes, view, low, high, point)


def point_length(view: View, low: FloatArray, high: FloatArray, size: tuple[float, float], framed: bool) -> float:
    """Return the length¹ that a printer's point stands for where a box just fits into ``size`` points."""
    left, right, bottom, top = _margins(size[0], framed)
    wide, tall = np.ptp(_corners(view, low, high), axis=0)
    point = float(max(wide / max(size[0] - left - right, 1.0), tall / max(size[1] - bottom - top, 1.0)))
    return point if point > 0.0 else 1.0


def _margins(width: float, framed: bool) -> tuple[float, float, float, float]:
    if not framed:
        return _BARE
    return _NARROW if width < _SMALL else _MARGINS


def _corners(view: View, low: FloatArray, high: FloatArray) -> FloatArray:
    return view.project(np.array(list(product(*zip(low, high, strict=True)))))[:, :2]


def box_outline(stage: Stage) -> FloatArray:
    """Return the outline (n, 2) of the box as seen, a little widened: what lies outside is cut off."""
    rim = 3.0 * stage.point
    corners = _corners(stage.view, stage.low - rim, stage.high + rim)
    depth = stage.view.project(np.array(list(product(*zip(stage.low, stage.high, strict=True)))))[:, 2]
    nearest = int(np.argmax(depth))
    around = np.delete(corners, (nearest, 7 - nearest), axis=0)  # without it and the corner opposite to it
    x, y = (around - corners.mean(axis=0)).T
    return around[np.argsort(np.arctan2(y, x))]


def panel_size(view: View, low: FloatArray, high: FloatArray, width: float, framed: bool) -> tuple[float, float]:
    """Return the size in inches of a panel of this width that box and labels fill, within reason."""
    left, right, bottom, top = _margins(72.0 * width, framed)
    wide, tall = np.ptp(_corners(view, low, high), axis=0)
    shape = float(tall / wide) if wide > 0.0 else 0.0
    height = shape * (width - (left + right) / 72.0) + (bottom + top) / 72.0
    return width, min(max(height, 0.42 * width), 1.15 * width)


def equal_scale(
    views: Sequence[View], low: FloatArray, high: FloatArray, width: float, framed: bool
) -> tuple[list[tuple[float, float]], float]:
    """Return panels (width, height) in inches that show a box in several views at one scale, and a point's length¹.

    Side by side they are ``width`` inches wide; none is taller than 0.6 of that, or too narrow for its title.
    """
    seen = [np.ptp(_corners(view, low, high), axis=0) for view in views]
    left, right, bottom, top = _MARGINS if framed else _BARE
    least = 72.0 * min(1.9, width / len(views))
    room = 72.0 * width - len(views) * (left + right)
    point = max(
        float(sum(wide for wide, _ in seen)) / max(room, 1.0),
        float(max(tall for _, tall in seen)) / max(0.6 * 72.0 * width - bottom - top, 1.0),
    )
    point = point if point > 0.0 else 1.0
    # Columns too narrow for their titles are widened at the cost of the scale.
    for _ in range(300):
        if sum(max(wide / point + left + right, least) for wide, _ in seen) <= 72.0 * width * 1.001:
            break
        point *= 1.02
    sizes = [
        (float(max(wide / point + left + right, least)) / 72.0, float(tall / point + bottom + top) / 72.0)
        for wide, tall in seen
    ]
    return sizes, point


def stacked_scale(
    views: Sequence[View], low: FloatArray, high: FloatArray, width: float, framed: bool
) -> tuple[list[tuple[float, float]], float]:
    """Return the same for panels above each other, each ``width`` inches wide."""
    sizes = [panel_size(view, low, high, width, framed) for view in views]
    points = [
        point_length(view, low, high, (72.0 * width, 72.0 * height), framed)
        for view, (_, height) in zip(views, sizes, strict=True)
    ]
    return sizes, max(points)


def draw_frame(stage: Stage, unit: str) -> None:
    """Draw the far sides of the box with a light grid, and ticks and names along its near edges."""
    towards = stage.view.axes[2]
    far = np.where(towards >= 0.0, stage.low, stage.high)
    near = np.where(towards > 0.0, stage.high, stage.low)
    largest = float(max(np.abs(stage.low).max(), np.abs(stage.high).max()))
    extent = float(np.max(stage.high - stage.low))
    power = exponent(largest if largest < 100.0 * extent else extent)  # far from the origin every digit counts
    ticks = [_ticks(stage, axis) for axis in range(3)]
    _sides(stage, far, ticks)
    for axis, edge in enumerate(_edges(stage, far, near)):
        if len(ticks[axis]):
            # x and y meet at the near corner, where only x has a number.
            taken = float(near[1]) if axis == 1 and towards.all() else np.inf
            _scale(stage, axis, edge, ticks[axis], taken, power, with_unit("xyz"[axis], unit, power))


def _ticks(stage: Stage, axis: int) -> FloatArray:
    """Return few round positions along a world axis; none where it is seen end-on or has no extent."""
    low, high = float(stage.low[axis]), float(stage.high[axis])
    seen = float(np.linalg.norm(stage.view.axes[:2, axis])) * (high - low) / stage.point
    if not seen > 4.0:
        return np.zeros(0)
    count = int(np.clip(seen / 36.0, 1, 5))
    values = np.asarray(MaxNLocator(nbins=count, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    slack = 1e-9 * (high - low)
    values = values[(values >= low - slack) & (values <= high + slack)]
    room = float(np.linalg.norm(stage.view.axes[:2, axis])) / stage.point
    if len(values) > 1 and (values[1] - values[0]) * room < 10.0:
        values = values[:1]
    return values


def _edges(stage: Stage, far: FloatArray, near: FloatArray) -> list[FloatArray]:
    """Return a corner on the edge along which each axis is labelled; its own coordinate is replaced by the ticks."""
    floor = stage.low[2] if stage.view.elevation >= 0.0 else stage.high[2]
    upright = [np.array([near[0], far[1], 0.0]), np.array([far[0], near[1], 0.0])]
    left = min(upright, key=lambda corner: float(stage.view.project(corner)[0]))
    return [np.array([0.0, near[1], floor]), np.array([near[0], 0.0, floor]), left]


def _sides(stage: Stage, far: FloatArray, ticks: list[FloatArray]) -> None:
    low, high = stage.low, stage.high
    faces: list[FloatArray] = []
    lines: list[FloatArray] = []
    for fixed in range(3):
        first, second = (axis for axis in range(3) if axis != fixed)
        corners = np.tile(far, (4, 1))
        corners[:, first] = [low[first], high[first], high[first], low[first]]
        corners[:, second] = [low[second], low[second], high[second], high[second]]
        faces.append(stage.view.project(corners)[:, :2])
        for along, across in ((first, second), (second, first)):
            for value in ticks[along]:
                ends = np.tile(far, (2, 1))
                ends[:, along] = value
                ends[:, across] = [low[across], high[across]]
                lines.append(stage.view.project(ends)[:, :2])
    stage.axes.add_collection(
        PolyCollection(faces, facecolors="#fafafa", edgecolors="#cfcfcf", linewidths=0.6, zorder=0), autolim=False
    )
    stage.axes.add_collection(LineCollection(lines, colors="#e4e4e4", linewidths=0.5, zorder=0.5), autolim=False)


def _scale(stage: Stage, axis: int, edge: FloatArray, ticks: FloatArray, taken: float, power: int, name: str) -> None:
    """Draw the ticks, their numbers (none near ``taken``) and the name of one axis, outwards from the box."""
    ends = np.tile(edge, (2, 1))
    ends[:, axis] = [stage.low[axis], stage.high[axis]]
    line = stage.view.project(ends)[:, :2]
    centre = stage.view.project(0.5 * (stage.low + stage.high))[:2]
    along = line[1] - line[0]
    outwards = np.array([along[1], -along[0]]) / float(np.linalg.norm(along))
    if outwards @ (line.mean(axis=0) - centre) < 0.0:
        outwards = -outwards
    places = np.tile(edge, (len(ticks), 1))
    places[:, axis] = ticks
    at = stage.view.project(places)[:, :2]
    marks = np.stack([at, at + 3.0 * stage.point * outwards], axis=1)
    stage.axes.add_collection(
        LineCollection([line, *marks], colors="#8a8a8a", linewidths=0.7, zorder=1, capstyle="round"), autolim=False
    )
    room = float(np.linalg.norm(stage.view.axes[:2, axis])) / stage.point
    narrow = points_wide(stage.axes)[0] < _SMALL
    small, large = (_TICK - 0.8, _NAME - 1.0) if narrow else (_TICK, _NAME)
    widest = 0.0
    for place, value, text in zip(at, ticks.tolist(), tick_texts(ticks.tolist(), power), strict=True):
        if abs(value - taken) * room < 14.0:
            continue
        half = np.array([0.30 * small * len(text), 0.45 * small])
        away = 5.0 + float(np.abs(outwards) @ half)
        widest = max(widest, away + float(np.abs(outwards) @ half))
        x, y = place + away * stage.point * outwards
        stage.axes.text(x, y, text, fontsize=small, color=INK, ha="center", va="center", zorder=1)
    half = np.array([0.28 * large * len(name), 0.5 * large])
    slope = np.degrees(np.arctan2(along[1], along[0]))
    upright = abs(outwards[0]) > 0.9  # beside the box: turn the name along the edge
    away = widest + (0.55 * large if upright else float(np.abs(outwards) @ half)) + 1.0
    x, y = line.mean(axis=0) + away * stage.point * outwards
    turn = (slope + 90.0) % 180.0 - 90.0 if upright else 0.0
    stage.axes.text(
        x,
        y,
        name,
        fontsize=large,
        color=INK,
        ha="center",
        va="center",
        rotation=turn if abs(turn) < 89 else 90,
        zorder=1,
    )
