"""Lines on surfaces as files: tables, drawings, and fitted curves for CAD."""

import csv
import io
import json
import re
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np

from quintrig.exchange.units import ASSUMED, UNITS, stated
from quintrig.interrogation.line import Line, Lines
from quintrig.support.arrays import FloatArray
from quintrig.support.csv_rows import guarded
from quintrig.support.errors import ArgumentError, QuintrigError
from quintrig.support.extras import need
from quintrig.support.files import write_whole

LINE_SUFFIXES = (".csv", ".json", ".dxf", ".svg", ".3dm", ".step", ".stp")
"""Endings of the files that lines can be written to."""

COLOURS = ("#b2182b", "#2166ac", "#009e73", "#e69f00", "#cc79a7", "#56b4e9", "#7d7d7d")
"""Colours of lines, by their label in order."""

_CUBIC = 3
_TRIES = 12


@dataclass(frozen=True, eq=False)
class Fitted:
    """A B-spline curve near a line: full ``knots``, poles (n, 3), degree, and its largest ``error``, length¹."""

    knots: FloatArray
    poles: FloatArray
    degree: int
    error: float


def write_lines(lines: Lines, path: str | Path, view: str = "iso") -> tuple[str, ...]:
    """Write lines to a .csv, .json, .dxf, .svg, .3dm or .step file; return what to tell about it, one line each.

    DXF, 3DM and STEP are in the model's unit and in space; SVG is what a ``view`` (iso, side, back, top) shows, at true
    scale. 3DM and STEP hold cubic B-splines, fitted within the lines' tolerance. Raises QuintrigError for another
    ending, a missing extra or an unwritable target.
    """
    path = Path(path)
    suffix = path.suffix.lower()
    if suffix not in LINE_SUFFIXES:
        raise QuintrigError(f"{path}: expected a name ending in {', '.join(LINE_SUFFIXES)}")
    notes: tuple[str, ...] = ()
    if suffix == ".csv":
        data: str | bytes = csv_text(lines)
    elif suffix == ".json":
        data = json.dumps(lines.to_dict(), ensure_ascii=False) + "\n"
    elif suffix == ".dxf":
        data = _dxf(lines)
    elif suffix == ".svg":
        data = _svg(lines, view)
    else:
        curves = [fitted(line, lines.tolerance) for line in lines]
        if not curves:
            raise QuintrigError(f"{path}: there is no line to write; see the notes of the lines")
        data = _rhino(lines, curves) if suffix == ".3dm" else _step(lines, curves)
        error = max(curve.error for curve in curves)
        unit = f" {lines.unit}" if lines.unit else ""
        notes = (f"{len(curves)} cubic B-spline curves, at most {error:.2g}{unit} from the lines",)
    if not lines.unit and suffix in (".3dm", ".step", ".stp"):
        notes = (*notes, f"the model states no unit; the file says {ASSUMED}")
    write_whole(path, data)
    return notes


def names_of(lines: Lines) -> list[str]:
    """Return a name for every line, such as ``κ1 3``."""
    return [f"{line.label} {k + 1}" for k, line in enumerate(lines)]


def csv_text(lines: Lines) -> str:
    """Return one row a point: line, chain, patch, label, u, v, x, y, z, arc length, and the quantity."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    length = f" [{lines.unit}]" if lines.unit else ""
    value = lines.quantity + (f" [{lines.quantity_unit}]" if lines.quantity_unit else "")
    writer.writerow(["line", "chain", "patch", "label", "u", "v", *(f"{x}{length}" for x in "xyzs"), value])
    for number, line in enumerate(lines, 1):
        head = [number, line.chain, guarded(line.patch), guarded(line.label)]
        for uv, point, s, found in zip(line.uv, line.points, line.s, line.values, strict=True):
            writer.writerow([*head, *(repr(float(x)) for x in (*uv, *point, s, found))])
    return stream.getvalue()


def fitted(line: Line, tolerance: float) -> Fitted:
    """Return a cubic B-spline within ``tolerance`` (length¹) of a line, with as few poles as a smoothing fit needs.

    The error is measured at the points and, against the chords, halfway between them. After Dierckx 1993.
    """
    from scipy import interpolate

    keep = np.concatenate([[True], np.diff(line.s) > 0.0])
    points, s = line.points[keep], line.s[keep]
    if len(points) < 2:
        points, s = np.repeat(line.points[:1], 2, axis=0), np.array([0.0, 1.0])
    if len(points) <= _CUBIC:
        knots = np.concatenate([s[:1], s, s[-1:]])
        return Fitted(knots, points, 1, 0.0)
    middle, chords = 0.5 * (s[1:] + s[:-1]), 0.5 * (points[1:] + points[:-1])
    smooth = len(points) * (0.3 * tolerance) ** 2

    def smoothed(wanted: float) -> tuple[Fitted, float]:
        (knots, coefficients, degree), _ = interpolate.splprep(points.T, u=s, k=_CUBIC, s=wanted)  # pyright: ignore
        poles = np.stack(coefficients, axis=1)  # pyright: ignore
        curve = interpolate.BSpline(knots, poles, degree)  # pyright: ignore
        at = float(np.linalg.norm(curve(s) - points, axis=1).max())
        between = float(np.linalg.norm(curve(middle) - chords, axis=1).max())
        return Fitted(np.asarray(knots), poles, int(degree), max(at, between)), at  # pyright: ignore

    for attempt in range(_TRIES):
        best, at = smoothed(smooth * 0.1**attempt)
        if at <= 0.5 * tolerance:
            return best
    return smoothed(0.0)[0]


def _layer(label: str) -> str:
    return re.sub(r'[<>/\\":;?*|=`,]', " ", label).strip()[:200] or "lines"


def _dxf(lines: Lines) -> str:
    ezdxf = need("ezdxf", "writing DXF")
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = UNITS[lines.unit].dxf if lines.unit else 0
    document.header["$MEASUREMENT"] = 0 if lines.unit in ("in", "ft") else 1
    space = document.modelspace()
    for k, label in enumerate(dict.fromkeys(_layer(line.label) for line in lines)):
        document.layers.add(label, color=k % 6 + 1)
    for line in lines:
        open_ = line.points[:-1] if line.closed else line.points
        space.add_polyline3d(open_.tolist(), close=line.closed, dxfattribs={"layer": _layer(line.label)})
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue()


def _svg(lines: Lines, name: str) -> str:
    """Return the lines as a view shows them, in millimetres of the page at true scale."""
    from quintrig.figure.camera import VIEWS  # which loads matplotlib

    if name not in VIEWS:
        raise ArgumentError(f"expected one of {', '.join(VIEWS)}, got {name[:40]!r}", "view")
    view = VIEWS[name]
    scale = stated(lines.unit).millimetres
    flat = [scale * view.project(line.points)[:, :2] for line in lines]
    cloud = np.concatenate(flat) if flat else np.zeros((1, 2))
    low, high = cloud.min(axis=0), cloud.max(axis=0)
    margin = 0.02 * float(np.linalg.norm(high - low)) + 1e-9
    low, high = low - margin, high + margin
    width, height = (high - low).tolist()
    thin = 0.003 * max(width, height)
    rows = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.6f}mm" height="{height:.6f}mm" '
        f'viewBox="0 0 {width:.6f} {height:.6f}">',
        f"<title>{escape(lines.kind)} lines, {escape(view.name)}</title>",
        f'<rect width="{width:.6f}" height="{height:.6f}" fill="#ffffff"/>',
    ]
    for k, label in enumerate(dict.fromkeys(line.label for line in lines)):
        colour = COLOURS[k % len(COLOURS)]
        rows.append(f'<g fill="none" stroke="{colour}" stroke-width="{thin:.6f}" stroke-linejoin="round">')
        rows.append(f"  <title>{escape(label)}</title>")
        for line, points in zip(lines, flat, strict=True):
            if line.label == label:
                path = " ".join(f"{x - low[0]:.6f},{high[1] - y:.6f}" for x, y in points.tolist())
                rows.append(f'  <polyline points="{path}"/>')
        rows.append("</g>")
    return "\n".join([*rows, "</svg>"]) + "\n"


def _rhino(lines: Lines, curves: list[Fitted]) -> bytes:
    from quintrig.exchange.cad.rhino import write_3dm_curves

    return write_3dm_curves([(c.degree, c.knots, c.poles) for c in curves], names_of(lines), lines.unit, lines.kind)


def _step(lines: Lines, curves: list[Fitted]) -> bytes:
    from quintrig.exchange.cad.wires import step_curves

    error = max(curve.error for curve in curves)
    remark = f"{lines.kind} lines, cubic B-splines at most {error:.2g} from them"
    name = f"{lines.kind} lines"
    return step_curves([(c.degree, c.knots, c.poles) for c in curves], name, names_of(lines), lines.unit, remark)
