"""The report on a model, written as one HTML file."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from quintrig import __version__
from quintrig.analysis.table import Table
from quintrig.exchange.tables import TABLE_FORMATS, WRITERS
from quintrig.figure.save import formats_of
from quintrig.figure.style import STANDARD, Style
from quintrig.model.model import Model
from quintrig.model.toml import to_toml
from quintrig.multipatch.joins import Joins
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.signs import SIGN_TABLES
from quintrig.quantities.table import QUANTITIES, quantity
from quintrig.report import curves, deviation, kinds, tables
from quintrig.report import facts as known
from quintrig.report.deviation import Beside
from quintrig.report.facts import Facts
from quintrig.report.findings import findings, methods
from quintrig.report.lines import umbilic_words
from quintrig.report.mathml import mathml
from quintrig.report.pictures import (
    Image,
    Picture,
    drawn,
    invariants_shown,
    overview,
    picture_count,
    pictures,
    readings,
    told,
)
from quintrig.report.wording import digits_of, measure, percent, prose
from quintrig.studio import page as studio
from quintrig.support.files import refuse_unwritable, write_whole
from quintrig.support.processes import pool
from quintrig.support.progress import Progress, watched

DETAILED = 4
"""Models with more patches than this are told in brief: fewer pictures of each."""

Waiting = list[tuple[Picture, Future[Image]]]
"""Pictures that are being drawn."""

_LONGEST = 60_000  # characters of the model's own text that the page holds
_LARGEST_VIEW = 2_000_000  # characters of a model that the interactive view is given


@dataclass(frozen=True, eq=False)
class Chapter:
    """A patch on the page: its facts and its drawn pictures by name."""

    facts: Facts
    images: dict[str, Image]
    anchor: str
    detailed: bool


@watched
def write_report(
    model: Model,
    out: Path,
    *,
    progress: Progress | None = None,
    grid: int = 129,
    thresholds: Thresholds | None = None,
    figures: Sequence[str] = (),
    style: Style = STANDARD,
    processes: int | None = 1,
    beside: Beside | None = None,
) -> Path:
    """Write a self-contained page on a model and return its path.

    That is ``out/index.html``, or ``out`` itself where it ends in .html.
    ``grid`` points a side are classified, compared and searched for extremes. ``figures`` are the formats, such as pdf,
    in which every picture is a file beside the page too, with the tables of labelled points as CSV and LaTeX;
    ``style`` is how all of them look, and ``processes`` draw at once. ``beside`` is a target to tell of. The page is
    written whole or not at all;
    QuintrigError where it cannot be written, ValueError for fewer than 2 points.
    """
    target = _target(out)
    formats = formats_of(figures)
    source = to_toml(model.to_dict())  # before all the work where it cannot be written
    thresholds = thresholds or Thresholds()
    detailed = len(model.patches) <= DETAILED
    several = len(model.patches) > 1
    total = 1 + (4 if several else 0)
    joins: Joins | None = model.joins() if several else None
    total += curves.picture_count(model) + (beside is not None)
    total += sum(
        known.steps(patch, detailed) + picture_count(patch, detailed, style.quantities) for patch in model.patches
    )
    step = _steps(progress, total)
    if not model.patches:
        along = curves.curve_chapters(model, step, formats, style)
        every = curves.together(model, step, formats, style)
        step("writing the page")
        if formats:
            _write_beside(target.parent, *_along(along, every))
        return write_whole(target, _curve_page(model, source, along, every, style))
    facts = [Facts(patch, model.unit, thresholds, grid, detailed) for patch in model.patches]
    with pool(processes) as workers:

        def submit(some: Iterable[Picture]) -> Waiting:
            return [(one, workers.submit(drawn, one.draw, one.name, formats, style)) for one in some]

        try:
            # The pictures are drawn while the numbers are worked out here.
            shared = submit(overview(model, joins)) if joins is not None else []
            shared += submit([deviation.picture(beside)]) if beside is not None else []
            waiting = [submit(pictures(found, style.quantities)) for found in facts]
            for found in facts:
                name = f"{found.patch.name}: " if several else ""
                known.work_out(found, lambda what, name=name: step(name + what))
            images = [_arrived(some, step) for some in (*waiting, shared)]
        finally:
            workers.shutdown(wait=False, cancel_futures=True)
    along = curves.curve_chapters(model, step, formats, style)
    chapters = [
        Chapter(found, shown, f"patch-{number}", detailed)
        for number, (found, shown) in enumerate(zip(facts, images[:-1], strict=True), 1)
    ]
    step("writing the page")
    if formats:
        many = len(chapters) > 1
        shown = {one.anchor if many else "": tuple(one.images.values()) for one in chapters}
        points = {one.anchor if many else "": one.facts.points for one in chapters}
        _write_beside(target.parent, shown | {"together": tuple(images[-1].values())}, points)
        _write_beside(target.parent, *_along(along, ()))
    return write_whole(
        target, _page(model, source, chapters, images[-1], joins, grid, thresholds, along, style, beside)
    )


def _arrived(waiting: Waiting, step: Callable[[str], None]) -> dict[str, Image]:
    """Return pictures by name, waiting for each in turn."""
    found: dict[str, Image] = {}
    for picture, future in waiting:
        step(f"picture {picture.name}")
        found[picture.name] = told(picture, future.result())
    return found


def _along(
    along: Sequence[curves.CurveChapter], every: Sequence[tuple[str, Image]]
) -> tuple[dict[str, tuple[Image, ...]], dict[str, Table]]:
    """Return the pictures and the table of every curve by its anchor, and the pictures of all together."""
    shown = {one.anchor: tuple(image for _, image in one.images) for one in along}
    return shown | {"together": tuple(image for _, image in every)}, {one.anchor: one.table for one in along}


def _write_beside(folder: Path, images: Mapping[str, Sequence[Image]], points: Mapping[str, Table]) -> None:
    """Write pictures and tables of points as files into ``folder``, their names begun by the part that they show."""
    for part, shown in images.items():
        for image in shown:
            for form, data in image.files.items():
                write_whole(folder / "figures" / f"{_file(part, image.name)}.{form}", data)
    for part, table in points.items():
        for suffix, form in TABLE_FORMATS.items():
            write_whole(folder / "tables" / f"{_file(part, 'points')}{suffix}", WRITERS[form](table))


def _file(part: str, name: str) -> str:
    return f"{part}-{name}" if part else name


def _steps(progress: Progress | None, total: int) -> Callable[[str], None]:
    """Return what counts the steps for ``progress``."""
    done = count()
    return lambda what: progress(what, next(done), total) if progress else None


def _target(out: Path) -> Path:
    """Return the file to write; QuintrigError where it is plain before all the work that it cannot be written."""
    target = out if out.suffix.lower() in (".html", ".htm") else out / "index.html"
    refuse_unwritable(target)
    return target


def _page(
    model: Model,
    source: str,
    chapters: list[Chapter],
    together: dict[str, Image],
    joins: Joins | None,
    grid: int,
    thresholds: Thresholds,
    along: tuple[curves.CurveChapter, ...],
    style: Style,
    beside: Beside | None,
) -> str:
    live = len(source) <= _LARGEST_VIEW
    return (
        _environment()
        .get_template("page.html.j2")
        .render(
            model=model,
            chapters=chapters,
            curves=along,
            surfaces=True,
            together=together,
            style=style,
            joins=joins,
            beside=beside,
            beside_image=together.get("deviation"),
            grid=grid,
            thresholds=thresholds,
            version=__version__,
            source=source if len(source) <= _LONGEST else "",
            quantities=[q for q in QUANTITIES if q.key not in ("point", "normal")],
            signs=SIGN_TABLES,
            basis=[mathml(latex) for latex in kinds.BASIS],
            other_bases=kinds.other_bases(model.patches),
            viewer=Markup(studio.viewer(model)) if live else "",
            code=Markup(studio.code()) if live else "",
            policy=studio.policy(),
        )
    )


def _curve_page(
    model: Model,
    source: str,
    along: tuple[curves.CurveChapter, ...],
    every: tuple[tuple[str, Image], ...],
    style: Style,
) -> str:
    """Return the page of a model of curves alone."""
    page = _environment().get_template("curve_page.html.j2")
    return page.render(
        model=model,
        curves=along,
        all_curves=every,
        style=style,
        bases=curves.bases_of(model.curves),
        source=source if len(source) <= _LONGEST else "",
        version=__version__,
    )


def _environment() -> Environment:
    """Return the templates; every value is escaped unless it was built as markup, since names come from files."""
    environment = Environment(
        loader=PackageLoader("quintrig.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    words: dict[str, Any] = {
        "prose": prose,
        "number": digits_of,
        "measure": measure,
        "percent": percent,
        "mathml": mathml,
    }
    environment.filters.update(words)
    functions: dict[str, Any] = {
        "kinds": kinds,
        "tables": tables,
        "deviation": deviation,
        "findings": findings,
        "methods": methods,
        "umbilic_words": umbilic_words,
        "invariants_shown": invariants_shown,
        "readings": readings,
        "quantity": quantity,
        "sections": sections,
        "facts_of": _facts_of,
    }
    environment.globals.update(functions)
    return environment


def sections(chapter: Chapter) -> tuple[tuple[str, str], ...]:
    """Return anchor and title of every section of a patch, in order."""
    every = (
        ("short", "In short", True),
        ("what", "What it is", True),
        ("views", "Side, back and top", chapter.detailed),
        ("curvature", "Curvature", True),
        ("numbers", "Extremes, means, integrals", True),
        ("points", "At labelled points", True),
        ("lines", "Lines of curvature and umbilics", chapter.detailed),
        ("invariants", "The six invariants", chapter.detailed),
        ("methods", "Do the methods agree?", True),
        ("effect", "Effect of the shape parameters", bool(chapter.facts.variants)),
    )
    return tuple((anchor, title) for anchor, title, there in every if there)


def _facts_of(chapters: list[Chapter]) -> list[Facts]:
    return [chapter.facts for chapter in chapters]
