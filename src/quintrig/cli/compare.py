"""``quintrig compare``: what shape parameters do to a surface."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session
from quintrig.cli.options import WhichPatch
from quintrig.cli.show import print_table
from quintrig.cli.style import with_style
from quintrig.support.errors import ModelError, QuintrigError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from quintrig.analysis.table import Table
    from quintrig.figure.style import Style
    from quintrig.model.model import Model
    from quintrig.model.patch import NamedCurve, Patch
    from quintrig.report.shape_effect_page import Picture
    from quintrig.shaping.effect import Effect
    from quintrig.shaping.shape_effect import Variant

_MOST = 12
_DRAWN = 12  # parts of a model whose pictures a page holds

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
    """As which files the pictures are written, in which style, of which quantities."""

    formats: tuple[str, ...]
    style: "Style"
    keys: tuple[str | None, ...]


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
    several patches, of its seams too: what follows the patch by [[join]] tables is carried along. Without --patch each
    patch, or each curve, is varied in turn. In a folder the pictures and the tables are files too.
    """
    from quintrig.quantities.drawn import read_quantities

    alone = out is not None and out.suffix.lower() == ".html"
    keys = tuple(read_quantities(session.words(quantities)))
    look = _look(figures, alone, style, keys) if out is not None or figures is not None else None
    loaded = session.load_any(model)
    from quintrig.shaping.shape_effect import standard_shapes
    from quintrig.support.files import refuse_unwritable, write_whole

    if out is not None and out.is_file() and not alone:
        raise QuintrigError(
            f"{out}: expected a folder or an .html page to write, found another file; choose another name"
        )
    if out is not None:
        refuse_unwritable(out if alone else out / "index.html")
    given = [session.numbers(text, None, "--shape") for text in shape or []]
    if len(given) > _MOST:
        raise ValueError(f"--shape: expected at most {_MOST} sets, got {len(given)}")
    parts = _varied(loaded, patch, given)
    drawn = look if out is not None and len(parts) <= _DRAWN else None
    if out is not None and len(parts) > _DRAWN:
        session.remark(f"no pictures of more than {_DRAWN} parts: name one of the {len(parts)} with --patch for those")
    effects: list[tuple[Effect, tuple[Picture, ...]]] = []
    with session.progress() as progress:
        for index, one in enumerate(parts):
            fit = [numbers for numbers in given if len(parts) == 1 or len(numbers) == len(one.shape)]
            if len(parts) > 1:
                progress(one.name, index, len(parts))
            told = progress if len(parts) == 1 else _quietly
            effects.append(_effect(loaded, one, fit or standard_shapes(one), drawn, told))
    title = f"{loaded.name}: effect of the shape parameters"
    tables = _tables([effect for effect, _ in effects], loaded.name, title)
    if out is None or look is None:  # which a page always has
        for table in tables.values():
            print_table(table)
        return
    from quintrig.report.shape_effect_page import Section, page

    sections = [Section(effect, pictures) for effect, pictures in effects]
    for path, content in _files(out, page(sections, title, look.style), effects, tables).items():
        write_whole(path, content)
    session.done(out if alone else out / "index.html")


def _varied(model: "Model", name: str | None, given: "Sequence[Sequence[float]]") -> "list[Patch | NamedCurve]":
    """Return the patch or curve of the name, or all that have shape parameters to vary, or any of the sets fit."""
    curves = not model.patches or name in [one.name for one in model.curves]
    if name is not None:
        return [model.curve(name) if curves else model.patch(name)]
    every: list[Patch | NamedCurve] = [*model.curves] if curves else [*model.patches]
    if len(every) == 1:
        return every
    acting = [one for one in every if one.definition.acting]
    if not acting:
        raise ModelError(f"model {model.name!r}: no {'curve' if curves else 'patch'} has shape parameters to vary")
    fitting = [one for one in acting if not given or len(one.shape) in map(len, given)]
    if not fitting:
        counts = " or ".join(str(count) for count in sorted({len(one.shape) for one in acting}))
        raise ValueError(f"--shape: expected {counts} numbers, got {', '.join(str(len(one)) for one in given)}")
    return fitting


def _look(figures: str | None, alone: bool, style: "Style | None", keys: "tuple[str | None, ...]") -> _Look:
    from quintrig.figure.save import formats_of
    from quintrig.figure.style import STANDARD

    formats = formats_of((("" if alone else "png") if figures is None else figures).split(","))
    return _Look(formats, style or STANDARD, keys)


def _quietly(what: str, done: int, total: int) -> None:
    """Tell nothing of the steps of one part of many."""


def _effect(
    model: "Model",
    part: "Patch | NamedCurve",
    shapes: "Sequence[Sequence[float]]",
    look: "_Look | None",
    progress: "Callable[[str, int, int], None]",
) -> "tuple[Effect, tuple[Picture, ...]]":
    """Return what other sets of shape parameters do to a patch or a curve, and its pictures where they have a look."""
    from quintrig.model.patch import NamedCurve
    from quintrig.shaping.curve_effect import curve_measures, curve_variant
    from quintrig.shaping.effect import Effect
    from quintrig.shaping.seam_effect import seam_effect
    from quintrig.shaping.shape_effect import beside_own, intensities, variant

    name, many = part.name, len(model.patches) + len(model.curves) > 1
    title = f"{model.name}: {name}" if many else model.name
    if isinstance(part, NamedCurve):
        bent = [curve_variant(one, own=index == 0) for index, one in enumerate(beside_own(part, shapes))]
        effect = Effect(name, bent, curve_measures(bent, model.unit))
        if look is None:
            return effect, ()
        from quintrig.report.shape_effect_page import curve_pictures

        return effect, curve_pictures(bent, model.unit, title, look.formats, look.style)
    sets = beside_own(part, shapes)
    found: list[Variant] = []
    for index, changed in enumerate(sets):
        progress(f"shape parameters {index + 1} of {len(sets)}", index, len(sets))
        found.append(variant(changed, model.unit, own=index == 0))
    seams = seam_effect(model, name, sets, [v.label for v in found]) if len(model.patches) > 1 else None
    effect = Effect(name, found, intensities(found), seams)
    if look is None:
        return effect, ()
    from quintrig.report.shape_effect_page import pictures

    return effect, pictures(found, look.keys, title, progress, look.formats, look.style)


def _tables(effects: "Sequence[Effect]", name: str, title: str) -> "dict[str, Table]":
    """Return the tables of intensities and of seams by their names: those of several parts as one."""
    from quintrig.analysis.table import stacked

    found = {"intensities": [(one.name, one.table) for one in effects]}
    if effects[0].seams is not None:
        found["seams"] = [(one.name, one.seams) for one in effects if one.seams is not None]
    if len(effects) > 1:
        return {key: stacked(some, title if key == "intensities" else f"{name}: {key}") for key, some in found.items()}
    return {key: some[0][1] if key == "seams" else replace(some[0][1], title=title) for key, some in found.items()}


def _files(
    out: Path, page: str, effects: "Sequence[tuple[Effect, tuple[Picture, ...]]]", tables: "dict[str, Table]"
) -> dict[Path, str | bytes]:
    """Return the page, and in a folder, or where pictures are asked for as files, those and the tables as files too."""
    from quintrig.exchange.tables import TABLE_FORMATS, WRITERS

    alone = out.suffix.lower() == ".html"
    result: dict[Path, str | bytes] = {out if alone else out / "index.html": page}
    if alone and not any(picture.files for _, pictures in effects for picture in pictures):
        return result
    folder = out.parent / "figures" if alone else out
    for number, (one, pictures) in enumerate(effects, 1):
        start = f"{number}-{_plain(one.name)}-" if len(effects) > 1 else ""
        for picture in pictures:
            result |= {folder / f"{start}{picture.name}.{form}": data for form, data in picture.files.items()}
    folder = out.parent / "tables" if alone else out
    for name, table in tables.items():
        result |= {folder / f"{name}{suffix}": WRITERS[form](table) for suffix, form in TABLE_FORMATS.items()}
    return result


def _plain(name: str) -> str:
    return "".join(letter if letter.isalnum() or letter in "-_" else "_" for letter in name)[:60]
