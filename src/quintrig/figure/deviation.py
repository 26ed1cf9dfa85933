"""The picture of a deviation: the surface with the points in the colours of their distance, and a histogram."""

from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from quintrig.figure.style import STANDARD, Style

if TYPE_CHECKING:  # scans bring Numba and SciPy with them
    from quintrig.scan.deviation import Deviation

_MOST = 20_000  # points drawn


def deviation_picture(result: "Deviation", title: str = "", width: float = 8.0, *, style: Style = STANDARD) -> Figure:
    """Return the surfaces with the points coloured by distance, blue below and red above, beside a histogram."""
    width = style.across(width)
    figure = Figure(figsize=(width, 0.56 * width), layout="constrained")
    drawn: Any = figure
    grid: Any = drawn.add_gridspec(1, 2, width_ratios=(1.7, 1.0))
    space: Any = drawn.add_subplot(grid[0], projection="3d")
    t = np.linspace(0.0, 1.0, 25)
    for surface in result.surfaces:
        p = surface(t[:, None], t[None, :])
        p = np.where(np.isfinite(p) & surface.inside(t[:, None], t[None, :])[..., None], p, np.nan)
        space.plot_wireframe(p[..., 0], p[..., 1], p[..., 2], color="0.6", linewidth=0.4, rstride=2, cstride=2)
    reach = float(np.percentile(np.abs(result.distance), 99.0)) or float(np.abs(result.distance).max()) or 1.0
    if style.limits is not None:
        reach = max(map(abs, style.limits))
    colours = style.colours or "RdBu_r"
    chosen = np.linspace(0, len(result) - 1, min(len(result), _MOST)).astype(int)
    order = chosen[np.argsort(np.abs(result.distance[chosen]))]  # the largest on top
    p = result.points[order]
    dots = space.scatter(
        p[:, 0],
        p[:, 1],
        p[:, 2],
        c=result.distance[order],
        cmap=colours,
        vmin=-reach,
        vmax=reach,
        s=max(2.0, min(14.0, 20_000 / len(order))),
        linewidths=0.0,
        depthshade=False,
    )
    space.set_aspect("equal")
    for axis in "xyz":
        getattr(space, f"{axis}axis").set_major_locator(MaxNLocator(4))
        getattr(space, f"set_{axis}label")(f"{axis} ({result.unit})" if result.unit else axis)
    space.tick_params(labelsize=7)
    unit = f" ({result.unit})" if result.unit else ""
    bar: Any = drawn.colorbar(dots, ax=space, shrink=0.7, pad=0.12, extend="both")
    bar.set_label(f"distance{unit}, + towards the normal", fontsize=8)
    bar.ax.tick_params(labelsize=7)
    _histogram(drawn.add_subplot(grid[1]), result, reach, unit, colours)
    if title and style.title:
        drawn.suptitle(title, fontsize=11)
    return style.finish(figure)


def _histogram(axes: Any, result: "Deviation", reach: float, unit: str, cmap: str) -> None:
    ends = np.linspace(-1.15 * reach, 1.15 * reach, 42)
    counts, _ = np.histogram(np.clip(result.distance, ends[0], ends[-1]), ends)
    middle = 0.5 * (ends[1:] + ends[:-1])
    colours = matplotlib.colormaps[cmap](0.5 + 0.5 * np.clip(middle / reach, -1.0, 1.0))
    axes.bar(middle, 100.0 * counts / len(result), width=np.diff(ends), color=colours, edgecolor="0.4", linewidth=0.4)
    if result.tolerance is not None and result.tolerance < 1.15 * reach:
        for x in (-result.tolerance, result.tolerance):
            axes.axvline(x, color="k", linewidth=0.8, linestyle="--")
    axes.set_xlabel(f"distance{unit}", fontsize=8)
    axes.set_ylabel("% of the points", fontsize=8)
    axes.tick_params(labelsize=7)
    lines = [f"{len(result):,} points", f"rms {result.rms:.3g}", f"mean {result.mean:.3g}"]
    lines += [f"{result.min:.3g} to {result.max:.3g}"]
    if result.within is not None:
        lines.append(f"{100 * result.within:.1f} % within ±{result.tolerance:g}")
    if result.edge.any():
        lines.append(f"{int(result.edge.sum()):,} at an edge")
    axes.set_title("\n".join(lines), fontsize=8, loc="left")
