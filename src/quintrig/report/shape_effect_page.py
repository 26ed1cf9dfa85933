"""The comparison of shape parameters in pictures, and as one self-contained page."""

import base64
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib.resources import files

from jinja2 import Environment, StrictUndefined
from matplotlib.figure import Figure

from quintrig import __version__
from quintrig.exchange.tables import shown
from quintrig.figure import (
    Scene,
    comparison,
    curvature_plot,
    map_comparison,
    plane_curves,
    space_curves,
    to_bytes,
    torsion_plot,
)
from quintrig.figure.save import DPI
from quintrig.figure.style import STANDARD, Style
from quintrig.model.patch import NamedCurve, Patch
from quintrig.quantities.table import quantity
from quintrig.shaping.curve_effect import CurveVariant
from quintrig.shaping.effect import Effect
from quintrig.shaping.shape_effect import Variant

_DPI = 150


@dataclass(frozen=True)
class Picture:
    """A picture as PNG, with the name of its file, its title, and as ``files``, by format."""

    name: str
    title: str
    png: bytes
    files: Mapping[str, bytes] = field(default_factory=dict[str, bytes])

    @property
    def source(self) -> str:
        """The picture as a data address, to stand in a page."""
        return f"data:image/png;base64,{base64.b64encode(self.png).decode()}"


def pictures(
    found: Sequence[Variant],
    keys: Sequence[str | None] = ("gaussian", "mean"),
    name: str = "",
    progress: Callable[[str, int, int], None] | None = None,
    formats: Sequence[str] = (),
    style: Style = STANDARD,
) -> tuple[Picture, ...]:
    """Return the plain surfaces side by side, then each quantity in space and as a map, each on one scale.

    They are files of ``formats`` too, all in one ``style``. ``progress`` is told what is drawn, how many are
    done and how many there are.
    """
    surfaces = [one.patch.surface for one in found]
    labels = [one.label for one in found]
    unit = found[0].summary.unit
    start = f"{name}: " if name else ""
    wanted = [(None, False)] + [(key, flat) for key in dict.fromkeys(keys) if key for flat in (False, True)]
    drawn: list[Picture] = []
    for key, flat in wanted:
        title = f"{start}{'surface' if key is None else quantity(key).name}"
        if progress:
            progress(f"{title}{', map' if flat else ''}", len(drawn), len(wanted))
        if flat and key is not None:
            figure = map_comparison(surfaces, labels, key, title=title, unit=unit, style=style)
        else:
            scene = Scene(isolines=7 if key is None else 0)
            figure = comparison(surfaces, labels, key, scene, title=title, unit=unit, style=style)
        drawn.append(_picture(f"{key or 'surface'}{'_map' if flat else ''}", title, figure, formats, style.dpi))
    return tuple(drawn)


def curve_pictures(
    found: Sequence[CurveVariant],
    unit: str = "",
    name: str = "",
    formats: Sequence[str] = (),
    style: Style = STANDARD,
) -> tuple[Picture, ...]:
    """Return the curves in their control polygon, then curvature, and torsion in space, each in one picture."""
    curves, labels = [one.curve.curve for one in found], [one.label for one in found]
    plane = found[0].summary.plane
    start = f"{name}: " if name else ""
    drawn: list[Picture] = []
    for what, draw in (
        ("curve", plane_curves if plane else space_curves),
        ("curvature", curvature_plot),
        *([] if plane else [("torsion", torsion_plot)]),
    ):
        figure = draw(curves, labels, title=f"{start}{what}", unit=unit, width=6.4, style=style)
        drawn.append(_picture(what, f"{start}{what}", figure, formats, style.dpi))
    return tuple(drawn)


def _picture(name: str, title: str, figure: Figure, formats: Sequence[str], dpi: int | None) -> Picture:
    png = to_bytes(figure, "png", dpi or _DPI)
    return Picture(
        name, title, png, {form: png if form == "png" else to_bytes(figure, form, dpi or DPI) for form in formats}
    )


@dataclass(frozen=True, eq=False)
class Section:
    """What shape parameters do to one patch or curve, and the pictures of it."""

    effect: Effect
    pictures: tuple[Picture, ...] = ()

    @property
    def kind(self) -> str:
        """What it is, in words."""
        kind = self._part.kind
        return "curve" if kind == "curve" else f"{kind} surface"

    @property
    def names(self) -> str:
        """The symbols of the shape parameters, such as (α1, ζ1, α2, ζ2)."""
        return f"({', '.join(self._part.definition.shape_symbols)})"

    @property
    def lines(self) -> list[tuple[str, str, list[str]]]:
        """Symbol, unit and values of each column of the table."""
        table = self.effect.table
        columns = table.columns[table.lead :]
        return [(one.symbol, one.unit, [shown(value) for value in one.rounded]) for one in columns]

    @property
    def seam_rows(self) -> list[list[str]]:
        """The rows of the table of seams."""
        seams = self.effect.seams
        if seams is None:
            return []
        return [[shown(cell) for cell in row] for row in zip(*(c.rounded for c in seams.columns), strict=True)]

    @property
    def _part(self) -> Patch | NamedCurve:
        first = self.effect.found[0]
        return first.curve if isinstance(first, CurveVariant) else first.patch


def page(sections: Sequence[Section], title: str, style: Style = STANDARD) -> str:
    """Return the page as HTML with its pictures inside: nothing beside it and no network is needed."""
    environment = Environment(autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    template = environment.from_string((files("quintrig.report.templates") / "shape_effect.html.j2").read_text("utf-8"))
    return template.render(title=title, sections=sections, style=style, version=__version__)
