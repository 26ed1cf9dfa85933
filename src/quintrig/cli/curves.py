"""What commands say and draw of a model of curves."""

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from rich.console import Console

    from quintrig.model.model import Model
    from quintrig.model.patch import NamedCurve


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
        facts.append(("shape", one.label))
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
    warnings += [line.rstrip(".") for line in curve.caveats]
    ranges, values = one.definition.ranges, one.definition.acting
    if not curve.caveats and any(not ranges[key].holds(value) for key, value in values.items()):
        warnings.append("shape parameters outside their range: the curve may leave the convex hull of its points")
    if not (np.linalg.norm(np.diff(curve.points, axis=0), axis=-1) > 0.0).all():
        warnings.append("neighbouring control points coincide")
    inner = np.linspace(0.0, 1.0, 2001)[1:-1]
    slow = np.linalg.norm(curve.derivatives(inner, 1)[1], axis=-1)
    if float(slow.min()) < 1e-3 * curve.length():
        warnings.append(f"nearly a cusp at t = {inner[int(np.argmin(slow))]:.4g}: the curve all but stands still there")
    return warnings
