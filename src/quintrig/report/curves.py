"""Curves in a report: what each is, its pictures and its table; a page of their own where there are no surfaces."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from markupsafe import Markup

from quintrig.analysis.curve_summary import curve_facts, summarise_curve
from quintrig.analysis.curve_table import tabulate_curve
from quintrig.analysis.table import Table
from quintrig.basis.formulas import Basis
from quintrig.figure import curvature_plot, plane_curves, space_curves, torsion_plot
from quintrig.figure.style import STANDARD, Style
from quintrig.model.model import Model
from quintrig.model.patch import NamedCurve
from quintrig.report import kinds
from quintrig.report.pictures import Image, Picture, render

_WIDE, _HALF = 5.6, 4.8  # inches
_ROWS = 11


@dataclass(frozen=True, eq=False)
class CurveChapter:
    """A curve on the page: facts in words, cautions, formula, table, control points and drawn pictures with titles."""

    curve: NamedCurve
    facts: tuple[tuple[str, str], ...]
    cautions: tuple[str, ...]
    formula: Markup
    table: Table
    images: tuple[tuple[str, Image], ...]
    anchor: str

    @property
    def points(self) -> list[list[float]]:
        """The control points, those that ``close`` adds among them."""
        return self.curve.curve.points.tolist()


def picture_count(model: Model) -> int:
    """Return how many steps the curves of a model take."""
    return 4 * len(model.curves) + (len(model.curves) > 1)


def curve_chapters(
    model: Model, step: Callable[[str], None], formats: Sequence[str] = (), style: Style = STANDARD
) -> tuple[CurveChapter, ...]:
    """Return what the page says of each curve, pictures as files of ``formats`` too; ``step`` is told what is drawn."""
    chapters: list[CurveChapter] = []
    for index, one in enumerate(model.curves, 1):
        found = summarise_curve(one.curve)
        facts = curve_facts(found, model.unit)
        more = [("basis", one.definition.basis_words)] if one.definition.basis_words else []
        more += [("shape", one.label)] if one.definition.shape_symbols else []
        table = tabulate_curve(one.curve, np.linspace(0.0, 1.0, _ROWS), unit=model.unit, title=one.name)
        images: list[tuple[str, Image]] = []
        for title, picture in _pictures([one], model.unit):
            step(f"{one.name}: picture {picture.name}")
            images.append((title, render(picture, formats, style)))
        told = (*facts[:2], *more, *facts[2:])
        formula = kinds.formula(one)
        chapters.append(CurveChapter(one, told, found.cautions, formula, table, tuple(images), f"curve-{index}"))
    return tuple(chapters)


def together(
    model: Model, step: Callable[[str], None], formats: Sequence[str] = (), style: Style = STANDARD
) -> tuple[tuple[str, Image], ...]:
    """Return pictures of several curves at once: all of them, and their curvature; none of a single one."""
    if len(model.curves) < 2:
        return ()
    step("all curves")
    shown = _pictures(model.curves, model.unit)
    return tuple((title, render(picture, formats, style)) for title, picture in (shown[0], shown[2]))


def bases_of(curves: Sequence[NamedCurve]) -> tuple[Basis, ...]:
    """Return the bases of curves that are not the quintic one, each once."""
    used = (basis for one in curves if not one.definition.standard for basis in one.definition.bases_used)
    return tuple(dict.fromkeys(used))


def _pictures(named: Sequence[NamedCurve], unit: str) -> list[tuple[str, Picture]]:
    """Return titles and pictures: the curves with polygon and hull, combs, curvature and torsion."""
    curves, labels = [one.curve for one in named], [one.label for one in named]
    if len(named) > 1:
        labels = [f"{one.name}: {one.label}" for one in named]
    plane = curves[0].points.shape[1] == 2
    draw = partial(plane_curves if plane else space_curves, curves, labels, unit=unit, width=_WIDE)
    along = {"unit": unit, "width": _HALF}
    names = ", ".join(one.name for one in named)
    shown = [
        ("The curve in its control polygon and convex hull", "curve", partial(draw, hull=True)),
        ("Curvature comb", "comb", partial(draw, comb=True, polygon=False)),
        ("Curvature", "curvature", partial(curvature_plot, curves, labels, **along)),
    ]
    if not plane:
        shown.append(("Torsion", "torsion", partial(torsion_plot, curves, labels, **along)))
    return [(title, Picture(name, f"{title}: {names}.", figure)) for title, name, figure in shown]
