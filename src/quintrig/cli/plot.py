"""``quintrig plot``: pictures of a model."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session
from quintrig.cli.options import Face, Listing, ModelFile, OnlyPatch, Whole
from quintrig.cli.style import with_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from quintrig.figure import Mark, Scene, View
    from quintrig.figure.style import Style
    from quintrig.model.model import Model, Patch

_EPILOG = session.examples(
    ("quintrig plot lid.toml -o lid.png", "the surface, seen obliquely, with its normal"),
    ("quintrig plot lid.toml -o lid.png --net", "with its control net"),
    ("quintrig plot lid.toml -q gaussian -o k.pdf --view flat", "a map of K over (u, v), with the line K = 0"),
    ("quintrig plot lid.toml -q surface,gaussian,mean -o lid.svg", "three pictures side by side"),
    ("quintrig plot lid.toml -q mean --view 30,20 -o h.png", "seen from azimuth 30°, elevation 20°"),
    ("quintrig plot lid.toml --view all -o lid.png", "side, back and top view"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, with_style(plot), _EPILOG)


def plot(
    model: ModelFile,
    output: Annotated[
        Path,
        typer.Option(
            "-o", "--output", metavar="FILE", help="Picture to write: .png, .svg, .pdf or .eps.", show_default=False
        ),
    ],
    quantities: Annotated[
        str,
        typer.Option(
            "-q", "--quantities", metavar="KEYS", help="What to colour by, such as gaussian,mean; --list shows all."
        ),
    ] = "surface",
    view: Annotated[
        str,
        typer.Option(
            metavar="VIEW", help="iso, side, back, top, all (side, back and top), flat, or AZIMUTH,ELEVATION."
        ),
    ] = "iso",
    net: Annotated[bool, typer.Option("--net/--no-net", help="Draw the control net.")] = False,
    lines: Annotated[int, typer.Option(min=0, max=100, help="Number of parameter lines each way.")] = 7,
    at: Annotated[
        list[str] | None, typer.Option(metavar="U,V", help="Mark a point of the surface. Repeatable.")
    ] = None,
    shape: Annotated[
        str | None, typer.Option(metavar="NUMBERS", help="Other shape parameters, such as 1,1,-3,-3.")
    ] = None,
    patch: OnlyPatch = None,
    width: Annotated[
        str, typer.Option(metavar="WIDTH", help="Width: inches, or such as 84mm, column or page (84 and 174 mm).")
    ] = "8",
    dpi: Annotated[int, typer.Option(min=30, max=600, help="Dots per inch of a .png.")] = 200,
    listing: Listing = False,
    face: Face = None,
    whole: Whole = False,
    style: "Style | None" = None,
) -> None:
    """Draw a model in space, with true proportions, or as flat maps over its parameters.

    One picture a quantity, each with its scale; surface stands for the plain surface.

    Of a model of curves, -q takes curve, comb, hull or curvature.
    """
    loaded = session.load_any(model, face, whole)
    if loaded.curves:
        from quintrig.cli.curves import draw_curves
        from quintrig.figure.style import STANDARD

        draw_curves(loaded, quantities, output, patch, width, dpi, style or STANDARD)
        return
    keys = read_keys(quantities)
    chosen = session.patches(loaded, patch)
    if shape is not None:
        values = session.numbers(shape, None, "--shape")
        chosen = tuple(one.with_shape(values) for one in chosen)
    from quintrig.figure import save
    from quintrig.figure.save import kind_of
    from quintrig.support.files import refuse_unwritable

    kind_of(output)
    refuse_unwritable(output)
    marks = _marks(at or [])
    from quintrig.figure.style import STANDARD, inches

    look, wide = style or STANDARD, inches(width)
    if view == "flat":
        figure = _flat(loaded, chosen, keys, marks, wide, look)
    else:
        figure = _space(loaded, chosen, keys, view, _scene(view, net, lines, marks, keys), wide, look)
    replaced = output.is_file()
    session.wrote(save(figure, output, dpi), replaced)


def read_keys(text: str) -> list[str | None]:
    """Return the keys asked for, None for the plain surface; ValueError for one that is no scalar or class."""
    from quintrig.quantities.table import quantity

    keys = [None if word.strip() == "surface" else quantity(word.strip()).key for word in text.split(",")]
    for key in keys:
        if key is not None and quantity(key).components > 1:
            raise ValueError(f"--quantities: {key!r} is a vector, which no colour shows; see --list for the others")
    return keys


def _marks(at: Sequence[str]) -> "tuple[Mark, ...]":
    from quintrig.figure import Mark
    from quintrig.support.arrays import parameter

    pairs = [session.numbers(text, 2, "--at") for text in at]
    for pair in pairs:
        parameter(pair[0], "u")
        parameter(pair[1], "v")
    return tuple(Mark(u, v, f"P{index + 1}" if len(pairs) > 1 else "P") for index, (u, v) in enumerate(pairs))


def _scene(view: str, net: bool, lines: int, marks: "tuple[Mark, ...]", keys: list[str | None]) -> "Scene":
    from quintrig.figure import ISO, Scene

    return Scene(
        view=ISO if view == "all" else read_view(view, ("all", "flat")),
        net=net,
        isolines=lines,
        marks=marks,
        normal=None in keys and view != "all",
    )


def read_view(text: str, others: Sequence[str] = ()) -> "View":
    """Return the view asked for; ValueError naming those there are, and the ``others`` that the command knows."""
    from quintrig.figure import VIEWS, View

    if text in VIEWS:
        return VIEWS[text]
    try:
        azimuth, elevation = session.numbers(text, 2, "--view")
    except ValueError:
        names = ", ".join([*VIEWS, *others])
        raise ValueError(f"--view: expected {names} or AZIMUTH,ELEVATION in degrees, got {text[:40]!r}") from None
    if not (-360.0 <= azimuth <= 360.0 and -90.0 <= elevation <= 90.0):
        raise ValueError(
            f"--view: expected an azimuth within ±360 and an elevation within ±90 degrees, got {text[:40]}"
        )
    return View(f"view from azimuth {azimuth:g}°, elevation {elevation:g}°", azimuth, elevation)


def _flat(
    model: "Model",
    chosen: "Sequence[Patch]",
    keys: list[str | None],
    marks: "tuple[Mark, ...]",
    width: float,
    style: "Style",
) -> "Figure":
    from quintrig import figure
    from quintrig.support.errors import ModelError

    wanted = [key for key in keys if key is not None]
    if not wanted:
        raise ValueError("--quantities: a flat map needs a quantity, such as -q gaussian")
    if len(chosen) > 1:
        names = ", ".join(repr(one.name) for one in chosen)
        raise ModelError(f"--patch: a flat map shows one surface; choose one of {names}")
    surface, name, unit = chosen[0].surface, model.name, model.unit
    if len(wanted) == 1:
        return figure.flat_map(surface, wanted[0], marks=marks, title=name, unit=unit, width=width, style=style)
    return figure.map_panels(surface, wanted, marks=marks, title=name, unit=unit, width=width, style=style)


def _space(
    model: "Model",
    chosen: "Sequence[Patch]",
    keys: list[str | None],
    view: str,
    scene: "Scene",
    width: float,
    style: "Style",
) -> "Figure":
    from quintrig import figure

    surfaces = [one.surface for one in chosen]
    name, unit = model.name, model.unit
    if view == "all":
        if len(keys) > 1:
            raise ValueError("--quantities: expected one with --view all, got several")
        return figure.projections(surfaces, keys[0], scene, title=name, unit=unit, width=width, style=style)
    if len(keys) == 1:
        return figure.space_picture(surfaces, keys[0], scene, title=name, unit=unit, width=width, style=style)
    return figure.panels(surfaces, keys, scene, title=name, unit=unit, width=width, style=style)
