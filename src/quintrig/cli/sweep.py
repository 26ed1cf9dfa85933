"""``quintrig sweep``: every design of a space of shape parameters."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from quintrig.cli import session

if TYPE_CHECKING:
    from quintrig.arrays import FloatArray
    from quintrig.sweep.store import Sweep

_EPILOG = session.examples(
    ("quintrig sweep lid.toml --vary alpha1=-4:1:21 --vary zeta2=-4:1:21 -o out/lid", "441 designs on a grid"),
    (
        "quintrig sweep lid.toml --vary alpha1=-4:1 --vary zeta1=-4:1 --sampling sobol --samples 4096 -o out/lid",
        "4096 designs that fill the plane evenly",
    ),
    (
        "quintrig sweep out/lid --where 'gaussian_min >= 0' --best bending_energy --top 5 --plot lid.png",
        "ask a finished sweep: the five least bent designs without a saddle point, and a picture",
    ),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, sweep, _EPILOG)


def sweep(
    model: Annotated[
        Path, typer.Argument(metavar="MODEL", help="Model file, or the folder of a sweep to ask.", show_default=False)
    ],
    vary: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=LOW:HIGH:COUNT", help="A parameter: alpha1, zeta1, alpha2, zeta2, scale. Repeatable."
        ),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FOLDER", help="Where the results go; begun or continued.")
    ] = None,
    sampling: Annotated[
        Literal["grid", "latin", "sobol"], typer.Option(help="All combinations, or a sample of the space.")
    ] = "grid",
    samples: Annotated[int, typer.Option(help="Number of designs of a sample.")] = 0,
    seed: Annotated[int, typer.Option(help="Seed of a sample.")] = 0,
    points: Annotated[int, typer.Option(help="Points a side at which each design is evaluated.")] = 32,
    patch: Annotated[str | None, typer.Option(metavar="NAME", help="Which surface of a model with several.")] = None,
    scheduler: Annotated[
        str | None, typer.Option(metavar="ADDRESS", help="A dask.distributed scheduler, such as tcp://host:8786.")
    ] = None,
    where: Annotated[str, typer.Option(metavar="CONDITION", help="SQL condition on the columns.")] = "",
    best: Annotated[str, typer.Option(metavar="COLUMN", help="Order by this column, least first.")] = "",
    greatest: Annotated[bool, typer.Option("--greatest", help="Greatest first instead.")] = False,
    top: Annotated[int, typer.Option(help="How many designs to list.")] = 10,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Parallel coordinates of the designs found: .png, .svg or .pdf.")
    ] = None,
) -> None:
    """Evaluate every design of a space of shape parameters, and find the best.

    Each design becomes a row of summaries: extremes and means of K, H and C, area, energies, the share of each HK type,
    the number of singular points. Rows go to Parquet files in a folder; a stopped sweep continues where it was.
    """
    from quintrig.sweep.store import load_sweep

    if model.is_dir():
        if vary:
            raise ValueError(f"{model}: is a folder, whose sweep is asked as it is; leave out --vary")
        found = load_sweep(model)
    else:
        found = _computed(
            model, vary or [], output, sampling, samples, seed, points=points, patch=patch, scheduler=scheduler
        )
    if top < 1:
        raise ValueError(f"--top: expected 1 or more, got {top}")
    _answer(found, where, best, greatest, top, plot)


def _computed(
    model: Path,
    vary: list[str],
    output: Path | None,
    sampling: Literal["grid", "latin", "sobol"],
    samples: int,
    seed: int,
    *,
    points: int,
    patch: str | None,
    scheduler: str | None,
) -> "Sweep":
    """Run what is missing of a sweep and return it."""
    from time import perf_counter

    from quintrig.sweep.part import Task
    from quintrig.sweep.run import run
    from quintrig.sweep.space import DesignSpace, parse_axis
    from quintrig.sweep.store import open_sweep

    if output is None:
        raise ValueError("-o: expected a folder for the results, such as -o out/sweep")
    loaded = session.load(model)
    chosen = loaded.patch(patch)
    space = DesignSpace(tuple(parse_axis(text) for text in vary), sampling, samples, seed)
    result = open_sweep(output, Task(loaded.to_dict(), chosen.name, space, points))
    began = perf_counter()
    first: list[int] = []
    with session.progress() as show:

        def tell(done: int, total: int) -> None:
            first.append(done)
            rate = (done - first[0]) / max(perf_counter() - began, 1e-9)
            show(f"designs, {rate:,.0f} a second" if done > first[0] else "designs", done, total)

        run(result, scheduler, tell)
    fresh = space.count - (first[0] if first else 0)
    seconds = perf_counter() - began
    if fresh:
        session.messages().print(f"{fresh:,} designs in {seconds:.1f} s, {fresh / seconds:,.0f} a second, in {output}")
    else:
        session.messages().print(f"all {space.count:,} designs were there already, in {output}")
    return result


def _answer(found: "Sweep", where: str, best: str, greatest: bool, top: int, plot: Path | None) -> None:
    """List the designs asked for, and draw them."""
    from quintrig.sweep.query import select

    unfinished = len(found.missing())
    if unfinished:
        session.messages().print(f"{unfinished} of {found.parts} parts are missing: the answer is of the others")
    rows = select(found, where, best, greatest)
    _list({name: values[:top] for name, values in rows.items()}, found, len(next(iter(rows.values()))))
    if plot is not None:
        from quintrig.figure.parallel import parallel_coordinates
        from quintrig.figure.save import save

        unit = str(found.task.model.get("unit", ""))
        session.wrote(save(parallel_coordinates(rows, found.task.space.names, best=best, unit=unit), plot))


def _list(rows: "dict[str, FloatArray]", found: "Sweep", count: int) -> None:
    """Print the first designs as a table."""
    from rich.table import Table

    from quintrig.sweep.part import column_unit

    kept = [name for name, values in rows.items() if not name.startswith("share_") or (values > 0.0).any()]
    unit = str(found.task.model.get("unit", ""))
    # One row a column of the data: twenty and more columns are wider than any screen, a few designs are not.
    table = Table(title=f"{count:,} of {found.task.space.count:,} designs", title_justify="left")
    table.add_column("")
    table.add_column("unit")
    for index in range(len(next(iter(rows.values())))):
        table.add_column(str(index + 1), justify="right", no_wrap=True)
    for name in kept:
        last = name == found.task.space.names[-1]
        measure = column_unit(name, unit)
        table.add_row(name, measure, *(f"{value:.5g}" for value in rows[name].tolist()), end_section=last)
    session.output().print(table)
