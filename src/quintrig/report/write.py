"""The report on a model, written as one HTML file."""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from quintrig import __version__
from quintrig.model.model import Model
from quintrig.model.toml import to_toml
from quintrig.multipatch.joins import Joins
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.signs import SIGN_TABLES
from quintrig.quantities.table import QUANTITIES, quantity
from quintrig.report import facts as known
from quintrig.report import kinds, tables
from quintrig.report.facts import MARKS, Facts
from quintrig.report.findings import findings, methods
from quintrig.report.lines import umbilic_words
from quintrig.report.mathml import mathml
from quintrig.report.pictures import Image, invariants_shown, overview, picture_count, pictures, readings, render
from quintrig.report.wording import measure, number, percent, prose
from quintrig.studio import page as studio
from quintrig.support.files import refuse_unwritable, write_whole
from quintrig.support.progress import Progress

DETAILED = 4
"""Models with more patches than this are told in brief: fewer pictures of each."""

_LONGEST = 60_000  # characters of the model's own text that the page holds
_LARGEST_VIEW = 2_000_000  # characters of a model that the interactive view is given


@dataclass(frozen=True, eq=False)
class Chapter:
    """A patch on the page: its facts and its drawn pictures by name."""

    facts: Facts
    images: dict[str, Image]
    anchor: str
    detailed: bool


def write_report(
    model: Model,
    out: Path,
    *,
    progress: Progress | None = None,
    grid: int = 129,
    thresholds: Thresholds | None = None,
) -> Path:
    """Write a self-contained page on a model and return its path.

    That is ``out/index.html``, or ``out`` itself where it ends in .html.
    ``grid`` points a side are classified, compared and searched for extremes. The page is written whole or not at all;
    QuintrigError where it cannot be written, ValueError for fewer than 2 points.
    """
    model.refuse_curves()
    target = _target(out)
    source = to_toml(model.to_dict())  # before all the work where it cannot be written
    thresholds = thresholds or Thresholds()
    detailed = len(model.patches) <= DETAILED
    several = len(model.patches) > 1
    total = 1 + (4 if several else 0)
    joins: Joins | None = model.joins() if several else None
    total += sum(known.steps(patch, detailed) + picture_count(patch, detailed) for patch in model.patches)
    step = _steps(progress, total)
    chapters: list[Chapter] = []
    for index, patch in enumerate(model.patches):
        name = f"{patch.name}: " if several else ""
        found = known.gather(patch, model.unit, thresholds, grid, detailed, lambda what, name=name: step(name + what))
        images: dict[str, Image] = {}
        for picture in pictures(found, detailed):
            step(f"{name}picture {picture.name}")
            images[picture.name] = render(picture)
        chapters.append(Chapter(found, images, f"patch-{index + 1}", detailed))
    together: dict[str, Image] = {}
    for picture in overview(model, joins) if joins is not None else ():
        step(f"picture {picture.name}")
        together[picture.name] = render(picture)
    step("writing the page")
    return write_whole(target, _page(model, source, chapters, together, joins, grid, thresholds))


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
) -> str:
    live = len(source) <= _LARGEST_VIEW
    return (
        _environment()
        .get_template("page.html.j2")
        .render(
            model=model,
            chapters=chapters,
            together=together,
            joins=joins,
            grid=grid,
            thresholds=thresholds,
            version=__version__,
            source=source if len(source) <= _LONGEST else "",
            quantities=[q for q in QUANTITIES if q.key not in ("point", "normal")],
            signs=SIGN_TABLES,
            marks=MARKS,
            basis=[mathml(latex) for latex in kinds.BASIS],
            other_bases=kinds.other_bases(model.patches),
            viewer=Markup(studio.viewer(model)) if live else "",
            code=Markup(studio.code()) if live else "",
            policy=studio.policy(),
        )
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
        "number": number,
        "measure": measure,
        "percent": percent,
        "mathml": mathml,
    }
    environment.filters.update(words)
    functions: dict[str, Any] = {
        "kinds": kinds,
        "tables": tables,
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
