"""The page of the reproduction: every item with its caption, pictures and tables in files beside it."""

import io
import shutil
import tempfile
from concurrent.futures import as_completed
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

from jinja2 import Environment, StrictUndefined
from PIL import Image, ImageChops

from quintrig import __version__
from quintrig.figure import to_bytes
from quintrig.figure.style import STANDARD, Style
from quintrig.quantities.classify import Thresholds
from quintrig.report.wording import prose
from quintrig.reproduce.figures import draw
from quintrig.reproduce.inventory import Item, inventory, labelled_points, model, model_text
from quintrig.reproduce.tables import PrintedTable, tables
from quintrig.support.errors import QuintrigError
from quintrig.support.files import refuse_unwritable, write_whole
from quintrig.support.processes import pool
from quintrig.support.progress import Progress, watched

FORMATS = ("png", "svg", "pdf")

_DPI = 130
_THUMBNAIL = (320, 240)  # pixels, twice as many as on the page, for dense screens


@dataclass(frozen=True)
class Built:
    """An item as the page shows it: names of its pictures, or its tables with the paths of their files.

    Each picture is a file of that name in ``figures``, once in each of ``FORMATS``, and a small one in ``thumbnails``.
    """

    item: Item
    pictures: tuple[str, ...] = ()
    tables: tuple[tuple[PrintedTable, tuple[str, ...]], ...] = ()


@watched
def write_reproduction(
    out: Path,
    *,
    progress: Progress | None = None,
    only: frozenset[str] | None = None,
    style: Style | None = None,
    processes: int | None = 1,
) -> Path:
    """Build every figure and table into the folder ``out`` and return the page's path.

    ``only`` limits it to some items, by key such as ``figure-4.3``; ``style`` is how pictures look, and ``processes``
    draw at once. An existing reproduction is replaced when the new one is complete. Raises QuintrigError where ``out``
    holds other files or cannot be written.
    """
    if out.exists() and (not out.is_dir() or (any(out.iterdir()) and not (out / "inventory.toml").exists())):
        raise QuintrigError(f"{out}: expected a new or empty folder, or an earlier reproduction; choose another")
    items = [item for item in inventory() if only is None or item.key in only]
    refuse_unwritable(out.absolute().parent / "index.html" if out.exists() else out)
    try:
        out.absolute().parent.mkdir(parents=True, exist_ok=True)
        place = Path(tempfile.mkdtemp(dir=out.absolute().parent, prefix=f".{out.name}."))
    except OSError as error:
        raise QuintrigError(f"{out}: cannot be written ({error.strerror or error}); choose another place") from None
    try:
        fresh = place / "new"
        _write_all(fresh, items, progress, style or STANDARD, processes)
        fresh.chmod(0o755)
        if out.exists():
            out.rename(place / "old")
        fresh.rename(out)
    except OSError as error:
        raise QuintrigError(f"{out}: cannot be written ({error.strerror or error}); choose another place") from None
    finally:
        shutil.rmtree(place, ignore_errors=True)
    return out / "index.html"


def _write_all(folder: Path, items: list[Item], progress: Progress | None, style: Style, processes: int | None) -> None:
    built: dict[str, Built] = {}
    with pool(processes) as workers:
        waiting = [workers.submit(_build, item, folder, style) for item in items]
        try:
            for future in as_completed(waiting):
                result = future.result()
                built[result.item.key] = result
                if progress:
                    progress(result.item.name, len(built), len(items))
        finally:
            for future in waiting:
                future.cancel()
    names = sorted({name for item in items for name in item.models})
    for name in names:
        write_whole(folder / "models" / f"{name}.toml", model_text(name))
    source = (files("quintrig.reproduce") / "inventory.toml").read_text(encoding="utf-8")
    write_whole(folder / "inventory.toml", source)
    write_whole(folder / "index.html", _page([built[item.key] for item in items], names))


def _build(item: Item, folder: Path, style: Style) -> Built:
    """Draw or tabulate one item and write its files."""
    if item.kind == "figure":
        pictures: list[str] = []
        figures = draw(item, style)
        for index, figure in enumerate(figures):
            letter = "abcdefgh"[index] if len(figures) > 1 else ""
            name = f"{item.key}{letter}"
            content = {form: to_bytes(figure, form, style.dpi or _DPI) for form in FORMATS}
            for form, data in content.items():
                write_whole(folder / "figures" / f"{name}.{form}", data)
            write_whole(folder / "thumbnails" / f"{name}.png", _thumbnail(content["png"]))
            pictures.append(name)
        return Built(item, tuple(pictures))
    parts: list[tuple[PrintedTable, tuple[str, ...]]] = []
    found = tables(item)
    for index, rows in enumerate(found):
        letter = "abcdefgh"[index] if len(found) > 1 else ""
        paths = tuple(f"tables/{item.key}{letter}{suffix}" for suffix, _ in rows.files)
        for path, (_, text) in zip(paths, rows.files, strict=True):
            write_whole(folder / path, text)
        parts.append((rows, paths))
    return Built(item, tables=tuple(parts))


def _thumbnail(png: bytes) -> bytes:
    """Return a PNG, its white margins cut off, reduced to fit the thumbnails' size."""
    buffer = io.BytesIO()
    with Image.open(io.BytesIO(png)) as picture:
        whole = picture.convert("RGB")
        small = whole.crop(ImageChops.difference(whole, Image.new("RGB", whole.size, "white")).getbbox())
        small.thumbnail(_THUMBNAIL, Image.Resampling.LANCZOS)
        small.save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def _page(built: list[Built], names: list[str]) -> str:
    environment = Environment(autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    environment.filters["prose"] = prose
    template = environment.from_string((files("quintrig.reproduce") / "page.html.j2").read_text(encoding="utf-8"))
    chapters = {
        "Chapter 2: basis, curves, surfaces": [b for b in built if b.item.number.startswith("2.")],
        "Chapter 3: constructions and classifications": [b for b in built if b.item.number.startswith("3.")],
        "Chapter 4: results": [b for b in built if b.item.number.startswith("4.")],
        "Appendix": [b for b in built if b.item.number.startswith("A")],
    }
    return template.render(
        chapters={title: found for title, found in chapters.items() if found},
        count=len(built),
        models={name: model(name).name for name in names},
        points=labelled_points(),
        version=__version__,
        relative=Thresholds().relative,
        flat=Thresholds().flat,
        letters="abcdefgh",
        formats=FORMATS,
    )
