"""Speed of the compiled drivers against the same formulas in NumPy, one thread unless said otherwise."""

import math

import numpy as np

import quintrig
from bench import every, rivals
from bench.timing import HEAD, compared, fastest, race, short, spelt, table
from quintrig.analysis.stream import analyse_blocks

KH = ("gaussian", "mean")
SHAPE = (1.0, 0.0, -2.0, -3.0)


def wavy_net() -> np.ndarray:
    """A net without symmetry, 10 x 10 in plan."""
    x, y = np.meshgrid(np.linspace(0, 10, 6), np.linspace(0, 10, 6), indexing="ij")
    return np.stack([x + 0.1 * y, y - 0.05 * x, np.sin(0.7 * x) * np.cos(0.5 * y) * 2.0], axis=-1)


def grids(count: int, rounds: int) -> None:
    """K and H on a grid."""
    surface = quintrig.tensor(wavy_net(), SHAPE)
    net, (u, v) = wavy_net(), quintrig.grid(count, count)
    out = {key: np.empty((count, count)) for key in KH}

    def blocks(height, fresh=False):
        planes = [np.empty((count, count)) for _ in KH] if fresh else out.values()
        rivals.row_blocks(net, u[:, 0], v[0], SHAPE, height, *planes)

    # The best height of the NumPy blocks is looked for, not assumed.
    best = fastest({height: lambda height=height: blocks(height) for height in (2, 4, 8, 16, 32)})
    mine, theirs = f"NumPy in blocks of {best} rows, arrays handed in", f"NumPy in blocks of {best} rows, fresh arrays"
    fresh, into = "quintrig, fresh arrays", "quintrig, arrays handed in"
    times = race(
        {
            mine: lambda: blocks(best),
            theirs: lambda: blocks(best, fresh=True),
            "NumPy, whole grid at once": lambda: blocks(count),
            fresh: lambda: quintrig.analyse(surface, u, v, KH, threads=1),
            into: lambda: quintrig.analyse(surface, u, v, KH, threads=1, out=out),
        },
        rounds,
    )
    print(
        f"K and H of a biquintic patch on a {count} x {count} grid; fresh against fresh, handed in against handed in\n"
    )
    against = {"NumPy, whole grid at once": mine, fresh: theirs, into: mine}
    table(HEAD, compared(times, count * count, against))


def all_quantities(count: int, rounds: int) -> None:
    """Everything the table of quantities has a use for, on a grid."""
    surface = quintrig.tensor(wavy_net(), SHAPE)
    net, (u, v) = wavy_net(), quintrig.grid(count, count)

    theirs, mine = every.fresh(count, count), quintrig.analyse(surface, u, v, every.KEYS)

    def blocks(height, out=theirs):
        every.every_quantity(net, u[:, 0], v[0], SHAPE, height, surface.size, out)

    def own(out=None):
        quintrig.analyse(surface, u, v, every.KEYS, threads=1, out=out)

    best = fastest({height: lambda height=height: blocks(height) for height in (2, 4, 8, 16, 32)})
    rivals_fresh = f"NumPy in blocks of {best} rows, fresh arrays"
    rivals_into = f"NumPy in blocks of {best} rows, arrays handed in"
    into = "quintrig, arrays handed in"
    times = race(
        {
            rivals_into: lambda: blocks(best),
            rivals_fresh: lambda: blocks(best, every.fresh(count, count)),
            "fresh arrays filled with ones, nothing else": lambda: touched(count),
            "quintrig, fresh arrays": own,
            into: lambda: own(mine.values),
        },
        rounds,
    )
    print(
        "Point, normal, K, H, κ1, κ2, both directions, S, C, four classifications and six invariants (28 numbers a "
        f"point) on a {count} x {count} grid; fresh against fresh, handed in against handed in\n"
    )
    against = {"quintrig, fresh arrays": rivals_fresh, into: rivals_into}
    table(HEAD, compared(times, count * count, against))


def touched(count: int) -> None:
    """Fill as many fresh arrays: the least that any way into fresh arrays can take."""
    for array in every.fresh(count, count).values():
        array.fill(1)


def points(count: int, rounds: int) -> None:
    """K and H at scattered points."""
    surface = quintrig.tensor(wavy_net(), SHAPE)
    rng = np.random.default_rng(1)
    u, v = rng.random(count), rng.random(count)
    out = {key: np.empty(count) for key in KH}

    def pieces(size):
        rivals.scattered(wavy_net(), u, v, SHAPE, size, *out.values())

    best = fastest({size: lambda size=size: pieces(size) for size in (512, 1024, 2048, 4096, 16384)})
    rival = f"NumPy, {best} points at a time, arrays handed in"
    own = {
        "quintrig, fresh arrays": {"threads": 1},
        "quintrig, arrays handed in": {"threads": 1, "out": out},
    }
    ways = {name: lambda how=how: quintrig.analyse(surface, u, v, KH, **how) for name, how in own.items()}
    times = race({rival: lambda: pieces(best)} | ways, rounds)
    print(f"K and H at {count:,} scattered points, basis included\n")
    table(HEAD, compared(times, count, dict.fromkeys(own, rival)))


def bases(count: int, scattered: int, rounds: int) -> None:
    """A basis from formulas beside the Bernstein polynomials of the same size, and beside the compiled quintic."""
    rng, (u, v) = np.random.default_rng(1), quintrig.grid(count, count)
    x, y = rng.random(scattered), rng.random(scattered)
    for name, n in (("lambda_bezier", 6), ("generalised_trigonometric", 6), ("cubic", 4)):
        net = rng.normal(size=(n, n, 3))
        surfaces = {one: quintrig.tensor(net, basis=one) for one in (name, "bernstein")}
        ways = {one: lambda s=s: quintrig.analyse(s, u, v, KH, threads=1) for one, s in surfaces.items()}
        print(f"K and H with {n} x {n} points on a {count} x {count} grid: formulas against Bernstein\n")
        table(HEAD, compared(race(ways, rounds), count * count, {name: "bernstein"}))
    net = wavy_net()
    surfaces = {one: quintrig.tensor(net, basis=one) for one in ("generalised_trigonometric", "trigonometric")}
    ways = {one: lambda s=s: quintrig.analyse(s, x, y, KH, threads=1) for one, s in surfaces.items()}
    print(f"K and H at {scattered:,} scattered points: formulas against the compiled quintic\n")
    table(HEAD, compared(race(ways, rounds), scattered, {"generalised_trigonometric": "trigonometric"}))


def scaling(side: int, rounds: int) -> None:
    """Two threads against one, in a race of their own: a core that slept through a rival takes its time to wake."""
    surface = quintrig.tensor(wavy_net(), SHAPE)
    rng = np.random.default_rng(1)
    rows = []
    for factor in (1, 3):
        u, v = quintrig.grid(factor * side, factor * side)
        at = rng.random((2, u.size * v.size // factor))
        work = {
            f"K and H, {u.size} x {v.size} grid": (u, v, KH),
            f"K and H, {at.shape[1]:,} scattered points": (*at, KH),
        }
        if factor == 1:
            work[f"28 numbers a point, {u.size} x {v.size} grid"] = (u, v, every.KEYS)
        for name, what in work.items():
            out = quintrig.analyse(surface, *what).values

            def own(threads, what=what, out=out):
                quintrig.analyse(surface, *what, threads=threads, out=out)

            times = race({"1": lambda own=own: own(1), "2": lambda own=own: own(2)}, rounds)
            points = math.prod(np.broadcast_shapes(what[0].shape, what[1].shape))
            cells = (f"{short(times[n].median / points * 1e9)}" for n in ("1", "2"))
            rows.append((name, *cells, f"{times['2'].spread:.0%}", spelt(times["1"], times["2"])))
    print("Two threads against one, arrays handed in\n")
    table(("work", "one thread, ns a point", "two threads", "spread", "times as fast"), rows)


def growth(largest: int, rounds: int) -> None:
    """Cost a point as the grid grows."""
    surface = quintrig.tensor(wavy_net(), SHAPE)
    rows = []
    for power in range(4, largest + 1):
        side = math.isqrt(10**power)
        u, v = quintrig.grid(side, side)
        fewer = max(3, rounds - 2 * (power - 4))

        def blocks(side=side):
            for _ in analyse_blocks(surface, side, side, KH, threads=1):
                pass

        ways = {"blocks": blocks}
        if power <= 7:
            ways["whole"] = lambda u=u, v=v: quintrig.analyse(surface, u, v, KH, threads=1)
        times = race(ways, fewer)
        cells = [short(times[name].median / side**2 * 1e9) if name in times else "-" for name in ("whole", "blocks")]
        rows.append((f"10^{power}", *cells, f"{times['blocks'].spread:.0%}", f"{times['blocks'].median:.2g} s"))
    print("K and H on a grid as it grows, one thread: `analyse` in one piece, `analyse_blocks` in constant memory\n")
    table(("points", "ns a point, analyse", "ns a point, analyse_blocks", "spread", "time of the latter"), rows)


def report(quick: bool) -> None:
    """Print all tables."""
    side, many, rounds = (300, 100_000, 5) if quick else (1000, 1_000_000, 9)
    grids(side, rounds)
    all_quantities(side, max(5, rounds - 2))
    points(many, rounds)
    bases(side, many, rounds)
    scaling(side, rounds)
    growth(6 if quick else 8, rounds)
