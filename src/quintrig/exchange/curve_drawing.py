"""Curves as drawings: splines of a DXF file, with every digit, and paths of an SVG at true scale."""

import io
from collections.abc import Sequence
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np

from quintrig.exchange.cad.curve_forms import CurveCarrier, curve_carriers, in_space
from quintrig.exchange.cad.fit import FitOptions
from quintrig.exchange.units import ASSUMED, UNITS, stated
from quintrig.geometry.curve import Curve
from quintrig.model.model import Model
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import need
from quintrig.support.files import write_whole

CURVE_DRAWING_SUFFIXES = (".dxf", ".svg")
"""Endings of the drawings of curves."""

_MOST_PIECES = 4096
_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00")


def export_curves(model: Model, path: Path, fit: FitOptions | None = None) -> tuple[str, ...]:
    """Write the curves of a model as DXF or SVG, whole or not at all, and return what to tell, one line each.

    DXF holds the exact NURBS, or a fit with its deviation, in the plane z = 0 or in space. SVG holds cubic Bézier
    paths in millimetres, within ``fit``'s tolerance or 1e-6 of the size; curves in space are seen from above. Raises
    ValueError where a curve has no such form, QuintrigError for an unwritable target.
    """
    if path.suffix.lower() == ".dxf":
        parts = curve_carriers(model, fit)
        notes = [f"{one.name}: {one.note}" for one in parts]
        write_whole(path, _dxf(parts, model.unit))
    else:
        text, notes = _svg(model, None if fit is None else fit.tolerance)
        write_whole(path, text)
        if not model.unit:
            notes.append(f"the model states no unit; the file says {ASSUMED}")
    if model.patches:
        notes.append("surfaces are left out: a drawing holds the model's curves alone")
    return tuple(notes)


def _dxf(parts: Sequence[CurveCarrier], unit: str) -> str:
    """Return a DXF file (R2010) with a spline on a layer of its own for each curve."""
    ezdxf = need("ezdxf", "writing DXF")
    document = ezdxf.new("R2010", setup=True)
    document.header["$INSUNITS"] = UNITS[unit].dxf if unit else 0
    document.header["$MEASUREMENT"] = 0 if unit in ("in", "ft") else 1
    space = document.modelspace()
    names = _layers([one.name for one in parts])
    for index, (one, layer) in enumerate(zip(parts, names, strict=True)):
        document.layers.add(layer, color=1 + index % 6)
        form = one.form
        keys = {
            "control_points": in_space(form.points).tolist(),
            "degree": form.basis.degree,
            "knots": list(form.basis.knots),
            "dxfattribs": {"layer": layer},
        }
        if (form.weights != form.weights[0]).any():
            space.add_rational_spline(weights=form.weights.tolist(), **keys)
        else:
            space.add_open_spline(**keys)
    problems = document.audit()
    if problems.errors:
        raise QuintrigError(
            f"the DXF file is not valid ({problems.errors[0].message}); please report this with the model"
        )
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue()


def _layers(names: Sequence[str]) -> list[str]:
    """Return names that DXF takes for layers, each once."""
    result: list[str] = []
    for name in names:
        word = "".join("_" if letter in '<>/\\":;?*|=,`' or not letter.isprintable() else letter for letter in name)
        word = base = word.strip()[:200] or "curve"
        count = 1
        while word.lower() in [one.lower() for one in result]:
            count += 1
            word = f"{base} {count}"
        result.append(word)
    return result


def _svg(model: Model, tolerance: float | None) -> tuple[str, list[str]]:
    """Return an SVG file, a path for each curve, and a line on each."""
    scale = stated(model.unit).millimetres
    notes: list[str] = []
    drawn: list[tuple[str, FloatArray]] = []
    for one in model.curves:
        if not np.ptp(one.curve.points, axis=0).max() > 0.0:
            raise ValueError(f'curve "{one.name}": all of it is a single point; are its control points equal?')
        allowed = tolerance or 1e-6 * float(np.linalg.norm(np.ptp(one.curve.points, axis=0)))
        pieces, off = cubic_pieces(one.curve, allowed)
        drawn.append((one.name, pieces))
        notes.append(f"{one.name}: {len(pieces)} cubic pieces, largest deviation {off:.3g} (allowed {allowed:.3g})")
        if one.curve.points.shape[1] == 3:
            notes.append(f"{one.name}: seen from above, along z; .dxf, .step and .3dm hold it in space")
    every = np.concatenate([pieces.reshape(-1, 2) for _, pieces in drawn])
    low, high = every.min(axis=0), every.max(axis=0)
    extent = float((high - low).max()) or 1.0
    rim = 0.03 * extent
    low, high = low - rim, high + rim
    width, height = (scale * (high - low)).tolist()
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.9g}mm" height="{height:.9g}mm" '
        f'viewBox="0 0 {width:.9g} {height:.9g}">',
        f"<title>{escape(model.name)}</title>",
    ]
    for index, (name, pieces) in enumerate(drawn):
        page = scale * (pieces - low)
        page[..., 1] = height - page[..., 1]
        start = page[0, 0]
        path = f"M{start[0]:.15g},{start[1]:.15g}" + "".join(
            " C" + " ".join(f"{x:.15g},{y:.15g}" for x, y in piece[1:].tolist()) for piece in page
        )
        lines.append(
            f'<path fill="none" stroke="{_COLOURS[index % len(_COLOURS)]}" stroke-width="{0.004 * scale * extent:.4g}" '
            f'd="{path}"><title>{escape(name)}</title></path>'
        )
    return "\n".join([*lines, "</svg>"]) + "\n", notes


def cubic_pieces(curve: Curve, tolerance: float) -> tuple[FloatArray, float]:
    """Return cubic Bézier pieces (n, 4, 2) of a curve seen along z, with its tangents, and their deviation, length¹.

    Measured between 33 points of equal parameters on each piece, so an upper bound of the distance there. Raises
    ValueError where 4096 pieces are not enough.
    """
    count = 1
    share = np.linspace(0.0, 1.0, 33)
    blend = np.stack([(1 - share) ** 3, 3 * share * (1 - share) ** 2, 3 * share**2 * (1 - share), share**3], axis=-1)
    while True:
        knots = np.linspace(0.0, 1.0, count + 1)
        place, speed = curve.derivatives(knots, 1)[..., :2]
        leg = speed / (3.0 * count)
        pieces = np.stack([place[:-1], place[:-1] + leg[:-1], place[1:] - leg[1:], place[1:]], axis=1)
        t = knots[:-1, None] + share / count
        off = np.einsum("sk,nkx->nsx", blend, pieces) - curve(np.minimum(t, 1.0))[..., :2]
        worst = float(np.linalg.norm(off, axis=-1).max())
        if worst <= tolerance:
            return pieces, worst
        if 2 * count > _MOST_PIECES:
            raise ValueError(f"the paths deviate by {worst:.3g} with {count} pieces, more than {tolerance:.3g}")
        count *= 2
