"""Timing of two or more ways to do the same work, in turn, so that a drifting machine slows all of them alike."""

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass

Way = Callable[[], object]


@dataclass(frozen=True)
class Timing:
    """Seconds of each round: quote the median, and the spread as (maximum - minimum) / median."""

    rounds: tuple[float, ...]

    @property
    def median(self) -> float:
        return statistics.median(self.rounds)

    @property
    def spread(self) -> float:
        return (max(self.rounds) - min(self.rounds)) / self.median


def race(ways: dict[str, Way], rounds: int = 9) -> dict[str, Timing]:
    """Run each way once to warm up, then all in turn, ``rounds`` times."""
    for way in ways.values():
        way()
    times: dict[str, list[float]] = {name: [] for name in ways}
    for _ in range(rounds):
        for name, way in ways.items():
            start = time.perf_counter()
            way()
            times[name].append(time.perf_counter() - start)
    return {name: Timing(tuple(values)) for name, values in times.items()}


def fastest(ways: dict[int, Way]) -> int:
    """Return the key of the fastest way, found by a short race: for settings that are looked for, not assumed."""
    times = race({str(key): way for key, way in ways.items()}, 3)
    return int(min(times, key=lambda name: times[name].median))


def ratio(slow: Timing, fast: Timing) -> tuple[float, float, float]:
    """Return the median, smallest and largest ratio, pair by pair in the order they were run."""
    pairs = sorted(s / f for s, f in zip(slow.rounds, fast.rounds, strict=True))
    return statistics.median(pairs), pairs[0], pairs[-1]


def spelt(slow: Timing, fast: Timing) -> str:
    """Return a ratio with its range in words."""
    middle, low, high = ratio(slow, fast)
    return f"{short(middle)} ({short(low)} to {short(high)})"


def short(value: float) -> str:
    """Return a number with two or three digits that mean something."""
    return f"{value:,.0f}" if value >= 100 else f"{value:.1f}" if value >= 1 else f"{value:.2f}"


def table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> None:
    """Print a Markdown table, numbers to the right."""
    widths = [max(len(row[i]) for row in (head, *rows)) for i in range(len(head))]

    def line(cells: tuple[str, ...]) -> str:
        words = [
            cell.ljust(width) if i == 0 else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(cells, widths, strict=True))
        ]
        return f"| {' | '.join(words)} |"

    print(line(head))
    print(
        "|" + "|".join("-" * (width + 2) if i == 0 else "-" * (width + 1) + ":" for i, width in enumerate(widths)) + "|"
    )
    for row in rows:
        print(line(row), flush=True)
    print()


def compared(times: dict[str, Timing], points: int, rivals: dict[str, str]) -> list[tuple[str, ...]]:
    """Return rows for a table: way, nanoseconds a point, spread, times as fast as its rival (a rival itself has 1)."""
    return [
        (
            name,
            short(timing.median / points * 1e9),
            f"{timing.spread:.0%}",
            spelt(times[rivals[name]], timing) if name in rivals else "1",
        )
        for name, timing in times.items()
    ]


HEAD = ("way", "ns a point", "spread", "times as fast")
