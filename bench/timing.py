"""Timing of two or more ways to do the same work, in turn, so that a drifting machine slows all of them alike."""

import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass


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


def race(ways: dict[str, Callable[[], object]], rounds: int = 9) -> dict[str, Timing]:
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


def ratio(slow: Timing, fast: Timing) -> tuple[float, float, float]:
    """Return the median, smallest and largest ratio, pair by pair in the order they were run."""
    pairs = sorted(s / f for s, f in zip(slow.rounds, fast.rounds, strict=True))
    return statistics.median(pairs), pairs[0], pairs[-1]
