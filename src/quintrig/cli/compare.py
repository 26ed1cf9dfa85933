"""``quintrig compare``: what shape parameters do to a surface."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session
from quintrig.cli.show import print_table
from quintrig.errors import QuintrigError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from matplotlib.figure import Figure

    from quintrig.compare import Variant
    from quintrig.figure import View
    from quintrig.model import Model
    from quintrig.table import Table

_MOST = 12

_EPILOG = session.examples(
    ("quintrig compare lid.toml out/shapes", "the thesis's four sets of shape parameters"),
    ("quintrig compare lid.toml out/shapes --shape 1,1,1,1 --shape 1,1,-3,-3", "sets of your own, two to twelve"),
    ("quintrig compare lid.toml", "the table of intensities alone, on the screen"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, compare, _EPILOG)


def compare(
    model: Annotated[Path, typer.Argument(metavar="MODEL", help="Model file, .toml or .json.", show_default=False)],
    out: Annotated[
        Path | None, typer.Argument(metavar="OUT", help="Folder for pictures and tables.", show_default=False)
    ] = None,
    shape: Annotated[
        list[str] | None,
        typer.Option(metavar="NUMBERS", help="Shape parameters α1,ζ1,α2,ζ2 (α,ζ for a developable). Repeatable."),
    ] = None,
    quantities: Annotated[
        str, typer.Option("-q", "--quantities", metavar="KEYS", help="What the pictures show.")
    ] = "gaussian,mean",
    view: Annotated[str, typer.Option(metavar="VIEW", help="iso, side, back, top, or AZIMUTH,ELEVATION.")] = "iso",
    patch: Annotated[str | None, typer.Option(metavar="NAME", help="Which surface of a model with several.")] = None,
) -> None:
    """Show the effect of shape parameters: several sets side by side.

    Writes pictures on one scale of length and colour, and a table of intensities: least, greatest and mean K and H,
    area and energies, as CSV, JSON, Markdown and LaTeX.
    """
    from quintrig.cli.plot import read_keys, read_view

    keys, seen = read_keys(quantities), read_view(view)
    loaded = session.load(model)
    from quintrig.compare import intensities, standard_shapes, variant, with_shapes

    one = loaded.patch(patch)
    shapes = [session.numbers(text, None, "--shape") for text in shape] if shape else standard_shapes(one)
    if len(shapes) > _MOST:
        raise ValueError(f"--shape: expected at most {_MOST} sets, got {len(shapes)}")
    if out is not None and out.exists() and not out.is_dir():
        raise QuintrigError(f"{out}: expected a folder to write to, found a file; choose another name")
    title = f"{loaded.name}: effect of the shape parameters"
    changed = with_shapes(one, shapes)
    steps = len(shapes) + (0 if out is None else 1 + 2 * len([key for key in keys if key]))
    with session.progress() as progress:
        found: list[Variant] = []
        for index, patch_with_shape in enumerate(changed):
            progress(f"shape parameters {index + 1} of {len(shapes)}", index, steps)
            found.append(variant(patch_with_shape, loaded.unit))
        table = intensities(found, title)
        if out is not None:
            _write_tables(out, table)
            for index, (name, draw) in enumerate(_pictures(found, keys, seen, loaded)):
                progress(name, len(shapes) + index, steps)
                _save(draw(), out / name)
    if out is None:
        print_table(table, session.output())
    else:
        session.finished(out)


def _write_tables(out: Path, table: "Table") -> None:
    from quintrig.files import write_whole
    from quintrig.typeset import SUFFIXES, WRITERS

    for suffix, form in SUFFIXES.items():
        write_whole(out / f"intensities{suffix}", WRITERS[form](table))


def _save(figure: "Figure", path: Path) -> None:
    from quintrig.figure import save

    save(figure, path)


def _pictures(
    found: "Sequence[Variant]", keys: "Sequence[str | None]", view: "View", model: "Model"
) -> "Iterator[tuple[str, Callable[[], Figure]]]":
    """Return names of files and what draws them: the plain surfaces, then each quantity in space and as a map."""
    from functools import partial

    from quintrig.figure import Scene, comparison, map_comparison
    from quintrig.quantity import quantity

    surfaces = [variant.patch.surface for variant in found]
    labels = [variant.label for variant in found]
    plain, coloured = Scene(view=view, isolines=7), Scene(view=view)
    for key in dict.fromkeys((None, *keys)):
        title = f"{model.name}: {'surface' if key is None else quantity(key).name}"
        scene = plain if key is None else coloured
        yield (
            f"{key or 'surface'}.png",
            partial(comparison, surfaces, labels, key, scene, title=title, unit=model.unit),
        )
        if key is not None:
            yield f"{key}_map.png", partial(map_comparison, surfaces, labels, key, title=title, unit=model.unit)
