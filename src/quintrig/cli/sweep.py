"""``quintrig sweep``: every design of a space of shape parameters."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import WhichPatch
from quintrig.support.errors import printable

if TYPE_CHECKING:
    from quintrig.support.arrays import FloatArray
    from quintrig.sweep.query import Question
    from quintrig.sweep.refine import Refined
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


_PLOTTED = 100  # designs of a picture, at most, whose extremes are refined too
_NAMES, _VALUE = 32, 14  # letters that the names with their units take, and that one value takes


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
    patch: WhichPatch = None,
    scheduler: Annotated[
        str | None, typer.Option(metavar="ADDRESS", help="A dask.distributed scheduler, such as tcp://host:8786.")
    ] = None,
    where: Annotated[str, typer.Option(metavar="CONDITION", help="SQL condition on the columns.")] = "",
    best: Annotated[str, typer.Option(metavar="COLUMN", help="Order by this column, least first.")] = "",
    greatest: Annotated[bool, typer.Option("--greatest", help="Greatest first instead.")] = False,
    top: Annotated[int, typer.Option(help="How many designs to list.")] = 10,
    prove: Annotated[
        list[str] | None,
        typer.Option(metavar="CLAIM", help="Prove this of each design listed, as 'gaussian >= 0'. Repeatable."),
    ] = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Parallel coordinates of the designs found: .png, .svg or .pdf.")
    ] = None,
) -> None:
    """Evaluate every design of a space of shape parameters, and find the best.

    Each design becomes a row of summaries: extremes and means of K, H and C, area, energies, the share of each HK type,
    the number of singular points. What follows the patch by [[join]] tables is carried along, and summed up with it.
    Without --patch every patch of the model that has a parameter takes its value, and a row is of the whole model.
    Of curves, length, extreme curvature and torsion, bending energy, inflections. Rows go to Parquet files in a folder;
    a stopped sweep continues where it was.
    """
    from quintrig.sweep.query import Question
    from quintrig.sweep.store import load_sweep

    question, claims = Question(where, best, greatest), prove or []
    if top < 1:
        raise ValueError(f"--top: expected 1 or more, got {top}")
    if plot is not None:
        _check_picture(plot)
    if model.is_dir():
        if vary or output:
            raise ValueError(f"{model}: is a folder, whose sweep is asked as it is; leave out --vary and -o")
        found = load_sweep(model)
        _check_claims(found, claims)
    else:
        found = _begun(model, vary or [], output, sampling, samples, seed, points=points, patch=patch)
        question.check(found.task)  # before the work, not after it
        _check_claims(found, claims)
        if found.repaired:
            session.remark(f"{found.folder}: {', '.join(found.repaired)} damaged; made anew")
        _run(found, scheduler)
    _answer(found, question, top, plot, claims, scheduler)


def _check_claims(found: "Sweep", claims: list[str]) -> None:
    if claims:
        from quintrig.sweep.proofs import check_claims

        check_claims(found, claims)


def _check_picture(file: Path) -> None:
    """Raise QuintrigError, before the work, for a picture that could not be written after it."""
    from quintrig.figure.save import kind_of
    from quintrig.support.files import refuse_unwritable

    kind_of(file)
    refuse_unwritable(file)


def _begun(
    model: Path,
    vary: list[str],
    output: Path | None,
    sampling: Literal["grid", "latin", "sobol"],
    samples: int,
    seed: int,
    *,
    points: int,
    patch: str | None,
) -> "Sweep":
    """Return the sweep that the options describe, new or continued."""
    from quintrig.sweep.part import Task
    from quintrig.sweep.space import DesignSpace, parse_axis
    from quintrig.sweep.store import open_sweep

    if output is None and not model.exists():
        raise ValueError(f"{model}: no such file or folder; check the path")
    if output is None:
        raise ValueError("-o: expected a folder for the results, such as -o out/sweep")
    loaded = session.load_any(model)
    curve = not loaded.patches or patch in [one.name for one in loaded.curves]
    parts = loaded.curves if curve else loaded.patches
    if patch is not None:
        parts = (loaded.curve(patch) if curve else loaded.patch(patch),)
    space = DesignSpace(tuple(parse_axis(text) for text in vary), sampling, samples, seed)
    return open_sweep(output, Task(loaded.to_dict(), parts[0].name if len(parts) == 1 else None, space, points))


def _run(sweep: "Sweep", scheduler: str | None) -> None:
    """Compute what is missing of a sweep, with progress and rate."""
    from time import perf_counter

    from quintrig.sweep.run import run

    began = perf_counter()
    first: list[int] = []
    with session.progress() as show:

        def tell(done: int, total: int) -> None:
            first.append(done)
            rate = (done - first[0]) / max(perf_counter() - began, 1e-9)
            show(f"designs, {rate:,.0f} a second" if done > first[0] else "designs", done, total)

        run(sweep, scheduler, tell)
    total = sweep.task.space.count
    fresh = total - (first[0] if first else 0)
    seconds = perf_counter() - began
    place = printable(str(sweep.folder))
    if fresh:
        said = f"{fresh:,} designs in {seconds:.1f} s, {fresh / seconds:,.0f} a second, in {place}"
    else:
        said = f"all {total:,} designs were there already, in {place}"
    session.messages().print(said, markup=False)


def _answer(
    found: "Sweep", question: "Question", top: int, plot: Path | None, claims: list[str], scheduler: str | None
) -> None:
    """List the designs asked for, and draw them."""
    from quintrig.sweep.query import count, select
    from quintrig.sweep.refine import select_refined

    unfinished = len(found.missing())
    if unfinished:
        session.messages().print(
            f"{unfinished} of {found.parts} parts are missing or cut off: the answer is of the others"
        )
    matching = count(found, question)
    session.emit(f"{matching:,} of {found.task.space.count:,} designs; {found.task.side}")
    refined = select_refined(found, question, top)
    if matching and not found.task.of_curve:
        session.emit(_told(refined, found.task.points))
    if len(next(iter(refined.rows.values()))):
        _list(refined.rows, found)
        if claims:
            _proved(found, refined, claims, scheduler)
    if plot is not None:
        from quintrig.figure.parallel import parallel_coordinates
        from quintrig.figure.save import save

        unit = str(found.task.model.get("unit", ""))
        surface = None if found.task.of_curve else found.task.family().varied[0].surface
        if matching > _PLOTTED and surface:
            session.remark(f"the picture is of more than {_PLOTTED} designs: their extremes are those at the points")
        rows = select(found, question) if matching > _PLOTTED else select_refined(found, question, _PLOTTED).rows
        names = found.task.space.names
        replaced = plot.is_file()
        session.wrote(save(parallel_coordinates(rows, names, surface, best=question.best, unit=unit), plot), replaced)


def _proved(found: "Sweep", refined: "Refined", claims: list[str], scheduler: str | None) -> None:
    """Print what comes of claims on each of the designs listed."""
    from quintrig.cli.prove import tell
    from quintrig.sweep.proofs import prove_rows

    console = session.output()
    for index, verdicts in enumerate(prove_rows(found, refined.rows, claims, scheduler), 1):
        console.print(f"design {index}")
        for verdict in verdicts:
            tell(verdict, console, "  ")


def _told(refined: "Refined", side: int) -> str:
    """Say what the numbers are of, and what became of the designs whose extremes were refined."""
    left = (
        f"counted by {side} × {side} points a design; extremes of those listed are refined between the points, as by "
        "`quintrig check`"
    )
    if refined.dropped:
        ones = "1 design" if refined.dropped == 1 else f"{refined.dropped:,} designs"
        of = "them" if refined.all_tried else f"the first {refined.tried:,}"
        left += f"; of {of}, {ones} no longer met the condition and {'is' if refined.dropped == 1 else 'are'} left out"
    return left


def _list(rows: "dict[str, FloatArray]", found: "Sweep") -> None:
    """Print the designs in tables as wide as the screen."""
    from rich.table import Table

    from quintrig.exchange.tables import shown

    console = session.output()
    kept = [name for name, values in rows.items() if not name.startswith("share_") or (values > 0.0).any()]
    # One line a column of the data: twenty and more columns are wider than any screen, a few designs are not.
    total = len(next(iter(rows.values())))
    fit = max(1, (console.width - _NAMES) // _VALUE)
    for start in range(0, total, fit):
        table = Table()
        table.add_column("", no_wrap=True)
        table.add_column("unit", no_wrap=True)
        for index in range(start, min(start + fit, total)):
            table.add_column(str(index + 1), justify="right", no_wrap=True)
        for name in kept:
            values = rows[name][start : start + fit].tolist()
            last = name == found.task.space.names[-1]
            table.add_row(name, found.task.unit_of(name), *(shown(value, 5) for value in values), end_section=last)
        console.print(table)
