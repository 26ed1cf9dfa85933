"""Speed of the compiled driver against the same formulas in NumPy, one thread unless said otherwise."""

import platform

import numpy as np

import quintrig
from bench import rivals
from bench.timing import Timing, race, ratio

KH = ("gaussian", "mean")
SHAPE = (1.0, 0.0, -2.0, -3.0)


def wavy_net() -> np.ndarray:
    """A net without symmetry, 10 x 10 in plan."""
    x, y = np.meshgrid(np.linspace(0, 10, 6), np.linspace(0, 10, 6), indexing="ij")
    return np.stack([x + 0.1 * y, y - 0.05 * x, np.sin(0.7 * x) * np.cos(0.5 * y) * 2.0], axis=-1)


def line(name: str, timing: Timing, points: int, against: Timing | None = None) -> None:
    """Print one row: nanoseconds a point, spread, ratio with its range."""
    nanoseconds = timing.median / points * 1e9
    text = f"| {name:44} | {nanoseconds:9.1f} | {timing.spread:6.0%} |"
    if against is not None:
        middle, low, high = ratio(against, timing)
        text += f" {middle:5.1f} ({low:.1f} to {high:.1f}) |"
    else:
        text += f" {'1':>5} {'':14} |"
    print(text)


def heading(title: str) -> None:
    """Print the head of a table."""
    print(f"{title}\n")
    print(f"| {'way':44} | ns/point  | spread | times as fast       |")
    print(f"|{'-' * 46}|{'-' * 10}:|{'-' * 7}:|{'-' * 21}|")


def grids(count: int, rounds: int) -> None:
    """K and H on a grid."""
    surface = quintrig.tensor(wavy_net(), SHAPE)
    net, (u, v) = wavy_net(), quintrig.grid(count, count)
    out = {key: np.empty((count, count)) for key in KH}
    planes = (out["gaussian"], out["mean"])
    # The best height of the NumPy blocks is looked for, not assumed.
    heights = {h: lambda h=h: rivals.row_blocks(net, u[:, 0], v[0], SHAPE, h, *planes) for h in (2, 4, 8, 16, 32)}
    best = min(race(heights, 3).items(), key=lambda item: item[1].median)[0]
    ways = {
        f"NumPy in blocks of {best} rows": heights[best],
        "NumPy, whole grid": lambda: rivals.whole_grid(net, u[:, 0], v[0], SHAPE, *planes),
        "quintrig, fresh arrays": lambda: quintrig.analyse(surface, u, v, KH, threads=1),
        "quintrig, arrays handed in": lambda: quintrig.analyse(surface, u, v, KH, threads=1, out=out),
        "quintrig, arrays handed in, two threads": lambda: quintrig.analyse(surface, u, v, KH, threads=2, out=out),
    }
    times = race(ways, rounds)
    rival = times[f"NumPy in blocks of {best} rows"]
    heading(f"K and H of a biquintic patch on a {count} x {count} grid")
    for name, timing in times.items():
        line(name, timing, count * count, None if timing is rival else rival)
    print()


def points(count: int, rounds: int) -> None:
    """K and H at scattered points."""
    surface = quintrig.tensor(wavy_net(), SHAPE)
    rng = np.random.default_rng(1)
    u, v = rng.random(count), rng.random(count)
    out = {key: np.empty(count) for key in KH}
    planes = (out["gaussian"], out["mean"])
    pieces = {
        p: lambda p=p: rivals.scattered(wavy_net(), u, v, SHAPE, p, *planes) for p in (512, 1024, 2048, 4096, 16384)
    }
    best = min(race(pieces, 3).items(), key=lambda item: item[1].median)[0]
    ways = {
        f"NumPy, {best} points at a time": pieces[best],
        "quintrig, fresh arrays": lambda: quintrig.analyse(surface, u, v, KH, threads=1),
        "quintrig, arrays handed in": lambda: quintrig.analyse(surface, u, v, KH, threads=1, out=out),
    }
    times = race(ways, rounds)
    rival = times[f"NumPy, {best} points at a time"]
    heading(f"K and H at {count:,} scattered points, basis included")
    for name, timing in times.items():
        line(name, timing, count, None if timing is rival else rival)
    print()


def report(quick: bool) -> None:
    """Print all tables."""
    print(f"Speed on {platform.processor() or platform.machine()}, Python {platform.python_version()}, NumPy {np.__version__}\n")
    side, many, rounds = (300, 100_000, 5) if quick else (1000, 1_000_000, 9)
    grids(side, rounds)
    points(many, rounds)
