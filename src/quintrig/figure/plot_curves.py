"""Pictures of curves: which there are, and the one that is asked for."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

from matplotlib.figure import Figure

from quintrig.figure.along import curvature_plot, torsion_plot
from quintrig.figure.curve import plane_curves
from quintrig.figure.read_lines import staged
from quintrig.figure.scene import Scene
from quintrig.figure.space import draw_space
from quintrig.figure.space_curves import curve_traces, space_curves
from quintrig.figure.style import Style
from quintrig.geometry.curve import Curve
from quintrig.model.model import Model
from quintrig.model.patch import NamedCurve
from quintrig.support.errors import ArgumentError, nearest

CURVE_PICTURES = ("curve", "comb", "hull", "curvature", "torsion")
"""What is drawn of curves."""

_SYMBOLS = {"κ": "curvature", "kappa": "curvature", "τ": "torsion", "tau": "torsion"}


def curve_picture(names: Sequence[str], known: Sequence[str] = CURVE_PICTURES, of: str = "curves") -> str:
    """Return which of the ``known`` pictures of curves a name or symbol asks for; ValueError for others."""
    found = ",".join(names)[:40]
    what = "curve" if list(names) == ["surface"] else _SYMBOLS.get(found, found)
    if what not in known:
        hint = nearest(found, known)
        raise ArgumentError(f"expected, for {of}, one of {', '.join(known)}, got {found!r}{hint}", "quantity")
    return what


def picture_of_curves(
    subject: Any, names: Sequence[str], *, title: str, unit: str, style: Style, axes: Any = None
) -> Figure:
    """Return a picture of curves or of a model of curves, on ``axes`` if given; ValueError for what has no picture."""
    parts = list(subject.curves) if isinstance(subject, Model) else _checked(subject)
    curves = [one.curve if isinstance(one, NamedCurve) else one for one in parts]
    named = [one for one in parts if isinstance(one, NamedCurve)]
    labels = [one.label if len(parts) == 1 else f"{one.name}: {one.label}" for one in named]
    labels = labels if len(named) == len(parts) else []
    if not curves:
        raise ArgumentError("expected at least one curve, found none", "subject")
    what = curve_picture(names)
    if what in ("curvature", "torsion"):
        along = curvature_plot if what == "curvature" else torsion_plot
        return along(curves, labels, title=title, unit=unit, style=style, axes=axes)
    hull, comb = what == "hull", what == "comb"
    dimensions = {curve.points.shape[1] for curve in curves}
    if len(dimensions) > 1:
        raise ArgumentError(
            "expected curves all in space or all in the plane, found both", "subject", remedy="draw them apart"
        )
    if dimensions == {2}:
        return plane_curves(curves, labels, hull=hull, comb=comb, title=title, unit=unit, style=style, axes=axes)
    if axes is not None:
        scene = staged(Scene(traces=tuple(curve_traces(curves, polygon=True, hull=hull, comb=comb))), style, [])
        draw_space(axes, [], scene, unit=unit)
        return style.dress(axes)
    return space_curves(curves, labels, hull=hull, comb=comb, title=title, unit=unit, style=style)


def _checked(subject: Any) -> list[Curve | NamedCurve]:
    """Return curves as a list; ValueError for what has no picture."""
    several = isinstance(subject, list | tuple)
    parts: list[Any] = [*cast("Sequence[Any]", subject)] if several else [subject]
    wrong = [one for one in parts if not isinstance(one, Curve | NamedCurve)]
    if wrong:
        raise ArgumentError(
            "expected a surface, patch, model, curve, sample, lines or scan, or several curves, found "
            f"{'several with ' if several else ''}{type(wrong[0]).__name__}",
            "subject",
            remedy="quintrig.load reads a file" if isinstance(wrong[0], str | Path) else "",
        )
    return parts
