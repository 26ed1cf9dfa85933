"""Rate of a sweep: designs a second, 32 x 32 points each, of a tensor-product surface in all four shape parameters."""

import os
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from pathlib import Path

import quintrig
from bench.speed import wavy_net
from bench.timing import HEAD, compared, race, table
from quintrig.geometry.constructions import SHAPE_NAMES
from quintrig.sweep.part import Task, summaries
from quintrig.sweep.run import run
from quintrig.sweep.space import Axis, DesignSpace
from quintrig.sweep.store import open_sweep
from quintrig.sweep.summarise import clenshaw_curtis

POINTS = 32


def report(quick: bool) -> None:
    """Print the table, and the time of the whole sweep."""
    model = {"kind": "tensor", "points": wavy_net().tolist(), "name": "wavy"}
    task = Task(model, "wavy", DesignSpace(tuple(Axis(name, -4.0, 1.0, 21) for name in SHAPE_NAMES)), POINTS)
    patch, total = task.varied()[0], task.space.count
    t, w = clenshaw_curtis(POINTS)
    some, few, rounds = (2048, 32, 3) if quick else (18522, 64, 5)
    first = total // 2  # the first designs have a shape parameter of -4, where more work is needed than on the whole

    def one_by_one():
        for values in task.space.designs(first, first + few).tolist():
            surface = patch.with_parameters(dict(zip(SHAPE_NAMES, values, strict=True))).surface
            sample = quintrig.analyse(
                surface, t[:, None], t[None, :], ("gaussian", "mean", "curvedness", "hk_type", "E", "F", "G")
            )
            area = (abs(sample["E"] * sample["G"] - sample["F"] ** 2)) ** 0.5 * w[:, None] * w[None, :]
            _ = [
                (sample[key].min(), sample[key].max(), (sample[key] * area).sum())
                for key in ("gaussian", "mean", "curvedness")
            ]
            _ = [area[sample["hk_type"] == code].sum() for code in range(1, 10)]

    def threads(count):
        edges = [first + some * i // (4 * count) for i in range(4 * count + 1)]
        with ThreadPoolExecutor(count) as pool:
            list(pool.map(lambda ends: summaries(task, *ends), pairwise(edges)))

    slow, one, two = "a loop over analyse with NumPy sums", "quintrig sweep, one thread", "quintrig sweep, two threads"
    times = race({slow: one_by_one, one: lambda: summaries(task, first, first + some), two: lambda: threads(2)}, rounds)
    # Per design, so that ways that did different numbers of designs can be compared.
    per = {
        name: type(timing)(tuple(x / (few if name == slow else some) for x in timing.rounds))
        for name, timing in times.items()
    }
    rows = [
        (name, f"{1 / timing.median:,.0f}", *row[2:])
        for (name, timing), row in zip(per.items(), compared(per, 1, {one: slow, two: slow}), strict=True)
    ]
    print(f"A sweep of a tensor-product surface, {POINTS} x {POINTS} points and 22 summaries a design\n")
    table(("way", "designs a second", *HEAD[2:]), rows)
    if quick:
        print(
            f"All 21^4 = {total:,} designs on two threads, estimated from {some:,}: {per[two].median * total:.1f} s.\n"
        )
        return
    with tempfile.TemporaryDirectory() as folder:
        began = time.perf_counter()
        run(open_sweep(Path(folder) / "sweep", task), threads=min(2, os.cpu_count() or 1))
        seconds = time.perf_counter() - began
        size = sum(file.stat().st_size for file in (Path(folder) / "sweep").iterdir())
    print(
        f"All 21^4 = {total:,} designs on two threads, Parquet files of {size / 1e6:.0f} MB included: {seconds:.1f} s, "
        f"{total / seconds:,.0f} designs a second.\n"
    )
