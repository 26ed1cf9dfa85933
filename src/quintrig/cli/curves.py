"""What commands say and draw of a model of curves."""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from quintrig.cli import session

if TYPE_CHECKING:
    from rich.console import Console

    from quintrig.figure.style import Style
    from quintrig.model.model import Model, NamedCurve

_PICTURES = ("curve", "comb", "hull", "curvature")


def tell_curve(one: "NamedCurve", model: "Model", console: "Console") -> int:
    """Print what a curve is; return the number of warnings."""
    from rich.markup import escape

    if len(model.curves) > 1:
        console.print(f"  [bold]{escape(one.name)}[/bold]")
    facts, warnings = _facts(one, model.unit)
    for name, value in facts:
        console.print(f"  [cyan]{name:<12}[/cyan]{escape(value)}", soft_wrap=True)
    for warning in warnings:
        console.print(f"  [yellow]warning     {escape(warning)}[/yellow]", soft_wrap=True)
    if not warnings:
        console.print("  [green]no warnings[/green]")
    return len(warnings)


def _facts(one: "NamedCurve", unit: str) -> tuple[list[tuple[str, str]], list[str]]:
    from quintrig.exchange.tables import shown

    curve, definition = one.curve, one.definition
    plane = curve.points.shape[1] == 2
    per = f" 1/{unit}" if unit else ""
    facts = [
        ("kind", f"curve in {'the plane' if plane else 'space'}, {'closed' if curve.closed else 'open'}"),
        ("length", f"{shown(curve.length(), 6)}{f' {unit}' if unit else ''}"),
    ]
    if definition.basis_words:
        facts.append(("basis", definition.basis_words))
    if definition.shape_symbols:
        facts.append(("shape", _shape(one)))
    ends = np.concatenate([[0.0], curve.curvature_extremes(), [1.0]])
    bends = curve.signed_curvature(ends) if plane else curve.curvature(ends)
    name = "κ signed, left positive," if plane else "κ"
    for word, pick in (("lowest", np.argmin), ("highest", np.argmax)):
        finite = np.where(np.isfinite(bends), bends, np.inf if word == "lowest" else -np.inf)
        index = int(pick(finite))
        if np.isfinite(finite[index]):
            facts.append(("curvature", f"{name} {word} {shown(float(bends[index]), 6)}{per} at t = {ends[index]:.4g}"))
    if not plane:
        twist = curve.torsion(np.linspace(0.0, 1.0, 2001))
        twist = twist[np.isfinite(twist)]
        if twist.size:
            span = f"from {shown(float(twist.min()), 4)} to {shown(float(twist.max()), 4)}{per} at 2001 points"
            facts.append(("torsion", span))
    turns = curve.inflections()
    facts.append(("inflections", "at t = " + ", ".join(f"{t:.6g}" for t in turns) if turns.size else "none"))
    facts.append(("bending", f"∫κ² ds = {shown(curve.bending_energy(), 6)}{per}"))
    return facts, _warnings(one, bends)


def _warnings(one: "NamedCurve", bends: "np.ndarray[tuple[int, ...], np.dtype[np.float64]]") -> list[str]:
    curve = one.curve
    warnings: list[str] = []
    if not np.isfinite(bends).all():
        warnings.append("the curve stands still at an end: curvature is not defined there")
    ranges, values = one.definition.ranges, one.definition.acting
    if any(not ranges[key].holds(value) for key, value in values.items()):
        warnings.append("shape parameters outside their range: the curve may leave the convex hull of its points")
    if not (np.linalg.norm(np.diff(curve.points, axis=0), axis=-1) > 0.0).all():
        warnings.append("neighbouring control points coincide")
    inner = np.linspace(0.0, 1.0, 2001)[1:-1]
    slow = np.linalg.norm(curve.derivatives(inner, 1)[1], axis=-1)
    if float(slow.min()) < 1e-3 * curve.length():
        warnings.append(f"nearly a cusp at t = {inner[int(np.argmin(slow))]:.4g}: the curve all but stands still there")
    return warnings


def draw_curves(
    model: "Model", what: str, output: Path, name: str | None, width: str, dpi: int, style: "Style"
) -> None:
    """Draw curves: themselves with their polygons, with combs or hulls, or their curvature over t."""
    from quintrig.figure import curve as figures
    from quintrig.figure import save
    from quintrig.figure.save import kind_of
    from quintrig.figure.style import inches
    from quintrig.support.errors import ModelError, nearest
    from quintrig.support.files import refuse_unwritable

    what = "curve" if what == "surface" else what
    if what not in _PICTURES:
        raise ValueError(f"--quantities: expected, for curves, one of {', '.join(_PICTURES)}, got {what[:40]!r}")
    kind_of(output)
    refuse_unwritable(output)
    wide = inches(width)
    known = [one.name for one in model.curves]
    if name is not None and name not in known:
        raise ModelError(f"model {model.name!r} has no curve {name!r}{nearest(name, known)}; it has {', '.join(known)}")
    chosen = [one for one in model.curves if name in (None, one.name)]
    curves = [one.curve for one in chosen]
    labels = [_label(one, len(chosen) > 1) for one in chosen]
    if what == "curvature":
        figure = figures.curvature_plot(curves, labels, title=model.name, unit=model.unit, width=wide, style=style)
    elif curves[0].points.shape[1] == 3:
        if what != "curve":
            raise ValueError(f"--quantities: expected curve or curvature for curves in space, got {what!r}")
        figure = figures.space_curves(curves, labels, title=model.name, unit=model.unit, width=wide, style=style)
    else:
        figure = figures.plane_curves(
            curves,
            labels,
            hull=what == "hull",
            comb=what == "comb",
            title=model.name,
            unit=model.unit,
            width=wide,
            style=style,
        )
    replaced = output.is_file()
    session.wrote(save(figure, output, dpi), replaced)


def _shape(one: "NamedCurve") -> str:
    """Return the shape parameters that act, by their letters."""
    values = one.definition.acting.values()
    return ", ".join(f"{name} = {value:g}" for name, value in zip(one.definition.shape_symbols, values, strict=True))


def _label(one: "NamedCurve", several: bool) -> str:
    shape = _shape(one) or one.definition.basis_words
    return f"{one.name}: {shape}" if several else shape
