"""``quintrig table``: quantities at chosen points."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import Face, Listing, ModelFile, WhichPatch, Whole
from quintrig.cli.scans import Degree, Neighbours, ScanUnit, curvature, is_scan, on_screen
from quintrig.cli.show import print_table

if TYPE_CHECKING:
    from quintrig.analysis.table import Table
    from quintrig.model.model import Model
    from quintrig.support.arrays import FloatArray

_MOST = 250_000  # points: a table keeps all its cells in memory; quintrig grid does not
_MOST_SHOWN = 2_500

_EPILOG = session.examples(
    ("quintrig table lid.toml", "5 x 5 points of the surface, on the screen"),
    ("quintrig table lid.toml --at 0.5,0.5 --at 0,1", "two points"),
    ("quintrig table lid.toml --grid 50x50 -o lid.csv", "2500 points with every digit, for other programs"),
    ("quintrig table lid.toml -q gaussian,mean -o lid.tex", "K and H alone, for a paper"),
    ("quintrig table scan.ply -o curvature.csv", "curvature of a scan's points, with an error for each value"),
    ("quintrig table lid.toml --metric both -q beta0,beta1", "invariants in both metrics"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, table, _EPILOG)


def table(
    model: ModelFile,
    at: Annotated[
        list[str] | None, typer.Option(metavar="U,V", help="A point, u and v from 0 to 1; of a curve t. Repeatable.")
    ] = None,
    grid: Annotated[
        str | None,
        typer.Option(metavar="NUxNV", help="Points on a grid, edges included, 5x5 otherwise; of a curve N."),
    ] = None,
    points: Annotated[
        Path | None, typer.Option(metavar="FILE.csv", help="Points from a file with a row u,v each.")
    ] = None,
    quantities: Annotated[
        str | None,
        typer.Option("-q", "--quantities", metavar="KEYS", help="Such as gaussian,mean,κ1; --list shows all."),
    ] = None,
    metric: Annotated[
        Literal["planar", "surface", "both"], typer.Option(help="Metric of the six invariants.")
    ] = "planar",
    patch: WhichPatch = None,
    form: Annotated[
        Literal["text", "csv", "json", "md", "latex"] | None,
        typer.Option("-f", "--format", help="Otherwise the ending of the output file tells: .csv .json .md .tex"),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE", help="Write to this file, not to the screen.")
    ] = None,
    digits: Annotated[int, typer.Option(min=1, max=17, help="Significant digits in LaTeX.")] = 6,
    siunitx: Annotated[bool, typer.Option("--siunitx", help="LaTeX that aligns numbers with siunitx.")] = False,
    listing: Listing = False,
    face: Face = None,
    whole: Whole = False,
    unit: ScanUnit = "",
    neighbours: Neighbours = None,
    degree: Degree = None,
) -> None:
    """Give position, curvatures, types and invariants at chosen points.

    Gaussian and mean curvature, principal curvatures, shape index and curvedness, the four classifications and the six
    algebraic invariants. It says the unit, which way the normal points, and what counts as zero.

    Of a scan (.csv .xyz .ply .obj .stl) it gives the curvature of its points themselves, each value with its error.
    """
    import numpy as np

    chosen = _format(form, output)
    if is_scan(model):
        if at or grid or points:
            raise ValueError("--at, --grid and --points: belong to surfaces; of a scan all points are taken")
        names = [word.strip() for word in quantities.split(",")] if quantities is not None else None
        if chosen == "text":
            print_table(on_screen(model, unit, neighbours, degree, names))
            return
        from quintrig.scan.curvature_table import tabulate_scan

        found = curvature(model, unit, neighbours, degree)
        _deliver(tabulate_scan(found, names, title=found.scan.name), chosen, output, digits, siunitx, model)
        return
    loaded = session.load_any(model, face)
    if not loaded.patches or patch in [one.name for one in loaded.curves]:
        if points is not None:
            raise ValueError(f"--points: expected a surface, found curves; give --at T, or --grid N (got {points})")
        result = _of_curve(loaded, patch, at, grid)
        _deliver(result if quantities is None else _only(result, quantities), chosen, output, digits, siunitx, model)
        return
    u, v = _points(at, grid, points)
    count = np.broadcast(u, v).size
    if chosen == "text" and count > _MOST_SHOWN:
        raise ValueError(
            f"--format: expected csv, json, md or latex for {count:,} points; the screen shows at most {_MOST_SHOWN:,}"
        )
    from quintrig.analysis.table import stacked, tabulate

    keys = [word.strip() for word in quantities.split(",")] if quantities is not None else None
    if patch is None and len(loaded.patches) > 1:
        if chosen == "text" and count * len(loaded.patches) > _MOST_SHOWN:
            raise ValueError(
                f"--format: expected csv, json, md or latex for {count * len(loaded.patches):,} points of "
                f"{len(loaded.patches)} patches; the screen shows at most {_MOST_SHOWN:,}, or choose one by --patch"
            )
        parts = [
            (one.name, tabulate(one.surface, u, v, keys, metric=metric, unit=loaded.unit, whole=whole))
            for one in loaded.patches
        ]
        _deliver(stacked(parts, loaded.name), chosen, output, digits, siunitx, model, points)
        return
    one = loaded.patch(patch)
    title = loaded.name if len(loaded.patches) == 1 else f"{loaded.name}: {one.name}"
    result = tabulate(one.surface, u, v, keys, metric=metric, unit=loaded.unit, title=title, whole=whole)
    _deliver(result, chosen, output, digits, siunitx, model, points)


def _deliver(
    result: "Table", chosen: str, output: Path | None, digits: int, siunitx: bool, *sources: Path | None
) -> None:
    """Print a table, or write it in the format chosen."""
    if siunitx and chosen != "latex":
        raise ValueError(f"--siunitx: belongs to LaTeX, and this is {chosen}; add -o FILE.tex or --format latex")
    if chosen == "text":
        print_table(result)
        return
    if chosen == "latex":
        from quintrig.exchange.latex import to_latex

        text = to_latex(result, digits=digits, siunitx=siunitx)
    else:
        from quintrig.exchange.tables import WRITERS

        text = WRITERS[chosen](result)
    session.deliver(text, output, *sources)


def _of_curve(model: "Model", name: str | None, at: Sequence[str] | None, grid: str | None) -> "Table":
    """Return the table of the curves of a model, or of one, at parameters or at so many evenly spaced ones."""
    import numpy as np

    from quintrig.analysis.curve_table import tabulate_curve
    from quintrig.analysis.table import stacked
    from quintrig.support.numerals import whole

    chosen = model.curves if name is None else (model.curve(name),)
    if at:
        t = np.array([session.numbers(text, 1, "--at")[0] for text in at])
    else:
        try:
            count = whole(grid or "11")
        except ValueError:
            raise ValueError(f"--grid: expected a number of points of a curve, such as 101, got {grid!r}") from None
        if not 2 <= count <= _MOST:
            raise ValueError(f"--grid: expected 2 to {_MOST:,} points of a curve, got {grid}")
        t = np.linspace(0.0, 1.0, count)
    parts = [(one.name, tabulate_curve(one.curve, t, unit=model.unit, title=one.name)) for one in chosen]
    return parts[0][1] if len(parts) == 1 else stacked(parts, model.name)


def _only(table: "Table", quantities: str) -> "Table":
    """Return what leads the rows of a table of curves, and the columns asked for by key or symbol."""
    leading, rest = table.columns[: table.lead], table.columns[table.lead :]
    known = {name: one for one in rest for name in (one.key, one.symbol)}
    words = [word.strip() for word in quantities.split(",")]
    unknown = next((word for word in words if word not in known), None)
    if unknown is not None:
        from quintrig.support.errors import nearest

        keys, hint = ", ".join(one.key for one in rest), nearest(unknown, [*known])
        raise ValueError(f"--quantities: expected some of {keys} for curves, found {unknown!r}{hint}")
    return replace(table, columns=(*leading, *dict.fromkeys(known[word] for word in words)))


def _format(form: str | None, output: Path | None) -> str:
    """Return the format asked for, or the one of the file's ending; ValueError where neither tells."""
    from quintrig.exchange.tables import TABLE_FORMATS

    if output is None:
        return form or "text"
    chosen = form or TABLE_FORMATS.get(output.suffix.lower())
    if chosen is None or chosen == "text":
        raise ValueError(
            f"{output}: expected a name ending in {', '.join(TABLE_FORMATS)}, or --format csv, json, md or latex"
        )
    return chosen


def _points(at: Sequence[str] | None, grid: str | None, file: Path | None) -> "tuple[FloatArray, FloatArray]":
    """Return the parameters asked for, as two arrays that broadcast."""
    if sum(choice is not None and choice != [] for choice in (at, grid, file)) > 1:
        raise ValueError("--at, --grid and --points: expected one of them, got several")
    import numpy as np

    if at:
        pairs = np.array([session.numbers(text, 2, "--at") for text in at])
        return pairs[:, 0], pairs[:, 1]
    if file is not None:
        return _from_file(file)
    from quintrig.geometry.domain import grid as mesh

    return mesh(*session.counts(grid or "5x5", "--grid", _MOST, "quintrig grid writes any number"))


def _from_file(file: Path) -> "tuple[FloatArray, FloatArray]":
    import numpy as np

    from quintrig.model.reading import read_rows

    rows = read_rows(file)
    for number, row in rows.items():
        if len(row) != 2:
            raise ValueError(f"{file}: row {number}: expected 2 numbers, u and v, got {len(row)}")
        for name, value in zip("uv", row, strict=True):
            if not 0.0 <= value <= 1.0:
                raise ValueError(f"{file}: row {number}: expected {name} in the domain [0, 1], got {value:g}")
    if not rows or len(rows) > _MOST:
        raise ValueError(f"{file}: expected 1 to {_MOST:,} rows of u and v, got {len(rows):,}")
    pairs = np.array(list(rows.values()))
    return pairs[:, 0], pairs[:, 1]
