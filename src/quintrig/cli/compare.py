"""``quintrig compare``: what shape parameters do to a surface."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session
from quintrig.cli.options import WhichPatch
from quintrig.cli.show import print_table
from quintrig.cli.style import with_style
from quintrig.support.errors import QuintrigError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from quintrig.analysis.table import Table
    from quintrig.figure.style import Style
    from quintrig.model.model import Model
    from quintrig.model.patch import NamedCurve
    from quintrig.report.shape_effect_page import Picture
    from quintrig.shaping.curve_effect import CurveVariant
    from quintrig.shaping.shape_effect import Variant

_MOST = 12

_EPILOG = session.examples(
    ("quintrig compare lid.toml out/shapes", "as it is and with the thesis's four sets: page, pictures, tables"),
    ("quintrig compare lid.toml shapes.html", "the page alone, in one file"),
    ("quintrig compare lid.toml out/shapes --shape 1,1,1,1 --shape 1,1,-3,-3", "sets of your own beside it"),
    (
        "quintrig compare lid.toml out/shapes --figures pdf --style journal",
        "pictures as PDF, to be printed in a journal",
    ),
    ("quintrig compare lid.toml", "the table of intensities alone, on the screen"),
)


@dataclass(frozen=True)
class _Look:
    """As which files the pictures are written, and in which style."""

    formats: tuple[str, ...]
    style: "Style"


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, with_style(compare), _EPILOG)


def compare(
    model: Annotated[Path, typer.Argument(metavar="MODEL", help="Model file, .toml or .json.", show_default=False)],
    out: Annotated[
        Path | None,
        typer.Argument(
            metavar="OUT", help="Folder for a page, pictures and tables, or one page.html.", show_default=False
        ),
    ] = None,
    shape: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NUMBERS", help="Shape parameters α1,ζ1,α2,ζ2 (α,ζ for a developable). Up to twelve times."
        ),
    ] = None,
    quantities: Annotated[
        str, typer.Option("-q", "--quantities", metavar="KEYS", help="What the pictures show.")
    ] = "gaussian,mean",
    figures: Annotated[
        str | None,
        typer.Option(
            metavar="FORMATS", help="Pictures and tables as files too, such as png,pdf.", show_default="png in a folder"
        ),
    ] = None,
    patch: WhichPatch = None,
    style: "Style | None" = None,
) -> None:
    """Show the effect of shape parameters: the model's own, and other sets beside them.

    Writes a page with pictures on one scale of length and colour and a table of intensities: least, greatest and mean
    K and H, area and energies; of a curve length, extreme curvature and torsion, bending energy; of a model with
    several patches, of its seams too: what follows the patch by [[join]] tables is carried along. In a folder the
    pictures and the tables are files too.
    """
    from quintrig.figure.plot import read_quantities
    from quintrig.figure.save import formats_of
    from quintrig.figure.style import STANDARD

    alone = out is not None and out.suffix.lower() == ".html"
    formats = formats_of((("" if alone else "png") if figures is None else figures).split(","))
    look = _Look(formats, style or STANDARD)
    keys = read_quantities(session.words(quantities))
    loaded = session.load_any(model)
    from quintrig.model.patch import NamedCurve
    from quintrig.shaping.seam_effect import seam_effect
    from quintrig.shaping.shape_effect import beside_own, intensities, standard_shapes, variant
    from quintrig.support.files import refuse_unwritable, write_whole

    if patch is None and len(loaded.patches) > 1 and out is None:
        _whole(loaded, shape)
        return
    curve = not loaded.patches or patch in [one.name for one in loaded.curves]
    one = loaded.curve(patch) if curve else loaded.patch(patch)
    shapes = [session.numbers(text, None, "--shape") for text in shape] if shape else standard_shapes(one)
    if len(shapes) > _MOST:
        raise ValueError(f"--shape: expected at most {_MOST} sets, got {len(shapes)}")
    if out is not None and out.is_file() and out.suffix.lower() != ".html":
        raise QuintrigError(
            f"{out}: expected a folder or an .html page to write, found another file; choose another name"
        )
    if out is not None:
        refuse_unwritable(out if out.suffix.lower() == ".html" else out / "index.html")
    title = f"{loaded.name}: effect of the shape parameters"
    if isinstance(one, NamedCurve):
        _of_curve(beside_own(one, shapes), out, title, loaded.unit, look)
        return
    sets = beside_own(one, shapes)
    with session.progress() as progress:
        found: list[Variant] = []
        for index, changed in enumerate(sets):
            progress(f"shape parameters {index + 1} of {len(sets)}", index, len(sets))
            found.append(variant(changed, loaded.unit, own=index == 0))
        table = intensities(found, title)
        seams = seam_effect(loaded, one.name, sets, [v.label for v in found]) if len(loaded.patches) > 1 else None
        results = {} if out is None else _results(out, found, table, keys, look, progress, seams)
    if out is None:
        print_table(table)
        if seams is not None:
            print_table(seams)
        return
    for path, content in results.items():
        write_whole(path, content)
    session.done(next(iter(results)))


def _of_curve(curves: "Sequence[NamedCurve]", out: Path | None, title: str, unit: str, look: "_Look") -> None:
    """Print or write what shape parameters do to a curve."""
    from quintrig.shaping.curve_effect import curve_measures, curve_variant

    found = [curve_variant(one, own=index == 0) for index, one in enumerate(curves)]
    table = curve_measures(found, unit, title)
    if out is None:
        print_table(table)
        return
    from quintrig.report.shape_effect_page import curve_pictures
    from quintrig.support.files import write_whole

    drawn = curve_pictures(found, unit, title.partition(": effect")[0], look.formats, look.style)
    for path, content in _files(out, found, table, drawn, look.style).items():
        write_whole(path, content)
    session.done(out if out.suffix.lower() == ".html" else out / "index.html")


def _whole(model: "Model", shape: list[str] | None) -> None:
    """Print the intensities of every patch that has shape parameters, and what they do to its seams."""
    from quintrig.analysis.table import stacked
    from quintrig.shaping.seam_effect import seam_effect
    from quintrig.shaping.shape_effect import beside_own, intensities, standard_shapes, variant
    from quintrig.support.errors import ModelError

    varied = [one for one in model.patches if one.definition.acting]
    if not varied:
        raise ModelError(f"model {model.name!r}: no patch has shape parameters to vary")
    given = [session.numbers(text, None, "--shape") for text in shape or []]
    tables: list[tuple[str, Table]] = []
    seams: list[tuple[str, Table]] = []
    with session.progress() as progress:
        for index, one in enumerate(varied):
            progress(f"patch {one.name}", index, len(varied))
            sets = beside_own(one, given or standard_shapes(one))
            found = [variant(changed, model.unit, own=k == 0) for k, changed in enumerate(sets)]
            tables.append((one.name, intensities(found)))
            seams.append((one.name, seam_effect(model, one.name, sets, [v.label for v in found])))
    print_table(stacked(tables, f"{model.name}: effect of the shape parameters"))
    print_table(stacked(seams, f"{model.name}: seams"))


def _results(
    out: Path,
    found: "Sequence[Variant]",
    table: "Table",
    keys: "Sequence[str | None]",
    look: "_Look",
    progress: "Callable[[str, int, int], None]",
    seams: "Table | None" = None,
) -> dict[Path, str | bytes]:
    """Return the files to write, the page first: all is made before anything is written."""
    from quintrig.report.shape_effect_page import pictures

    drawn = pictures(found, keys, table.title.partition(": effect")[0], progress, look.formats, look.style)
    return _files(out, found, table, drawn, look.style, seams)


def _files(
    out: Path,
    found: "Sequence[Variant] | Sequence[CurveVariant]",
    table: "Table",
    drawn: "Sequence[Picture]",
    style: "Style",
    seams: "Table | None" = None,
) -> dict[Path, str | bytes]:
    """Return the page, and in a folder, or where pictures are asked for as files, those and the table as files too."""
    from quintrig.exchange.tables import TABLE_FORMATS, WRITERS
    from quintrig.report.shape_effect_page import page

    alone = out.suffix.lower() == ".html"
    shown: dict[Path, str | bytes] = {out if alone else out / "index.html": page(found, table, drawn, seams, style)}
    if alone and not any(one.files for one in drawn):
        return shown
    folder = out.parent / "figures" if alone else out
    files = {folder / f"{one.name}.{form}": data for one in drawn for form, data in one.files.items()}
    folder = out.parent / "tables" if alone else out
    tables: dict[Path, str | bytes] = {
        folder / f"{name}{suffix}": WRITERS[form](one)
        for name, one in (("intensities", table), ("seams", seams))
        if one is not None
        for suffix, form in TABLE_FORMATS.items()
    }
    return {**shown, **files, **tables}
