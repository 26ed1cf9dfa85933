"""Proofs as ratios, against one sampling at 129 x 129 points; boxes against interval arithmetic's; nets of lines."""

from pathlib import Path

import numpy as np

import quintrig
from bench.timing import race, ratio, spelt, table
from quintrig.enclosures.prove import Prover
from quintrig.figure import space_picture, to_png_bytes

CLAIMS = {"regular": 50, "gaussian >= 0": 50, "range of K to 1e-3": 200}
"""What is timed, and how many samplings it may take at most."""

RIVAL_BOXES = 65_536
"""Boxes of equal size that naive interval arithmetic is given."""

Interval = tuple[np.ndarray, np.ndarray]


def net() -> np.ndarray:
    """Return a net of 6 x 6 points near a dome."""
    x, y = np.meshgrid(np.linspace(0.0, 3.0, 6), np.linspace(0.0, 2.0, 6), indexing="ij")
    bumps = 0.02 * np.random.default_rng(14).uniform(-1.0, 1.0, (6, 6, 3))
    return np.stack([x, y, -0.2 * (x - 1.5) ** 2 - 0.3 * (y - 1.0) ** 2], axis=-1) + bumps


def interval_boxes(points: np.ndarray, boxes: int) -> float:
    """Return the share of the domain where interval arithmetic on the trigonometric form tells the sign of K.

    The rival as it would be written: each function and its derivatives from intervals of sine and cosine, then K's
    numerator from intervals of the partial derivatives, over a grid of boxes.
    """
    side = round(boxes**0.5)
    edges = 0.5 * np.pi * np.arange(side + 1) / side
    s, c = (np.sin(edges[:-1]), np.sin(edges[1:])), (np.cos(edges[1:]), np.cos(edges[:-1]))
    f = functions(s, c)

    def partial(i: int, j: int, k: int) -> Interval:
        result: Interval = (np.zeros((side, side)), np.zeros((side, side)))
        for p in range(6):
            for q in range(6):
                u, v = f[i][p], f[j][q]
                part = times((u[0][:, None], u[1][:, None]), (v[0][None], v[1][None]))
                value = points[p, q, k]
                part = (part[0] * value, part[1] * value) if value >= 0 else (part[1] * value, part[0] * value)
                result = plus(result, part)
        return result

    su, sv, suu, suv, svv = ([partial(i, j, k) for k in range(3)] for i, j in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2)))
    n = [minus(times(su[k - 2], sv[k - 1]), times(su[k - 1], sv[k - 2])) for k in range(3)]
    first, middle, last = (dot(x, n) for x in (suu, suv, svv))
    low, high = minus(times(first, last), times(middle, middle))
    return float(((low > 0) | (high < 0)).mean())


def functions(s: Interval, c: Interval) -> list[list[Interval]]:
    """Return intervals of the six functions at α = ζ = 0, and of their first and second derivatives by the angle."""
    one = (np.ones_like(s[0]), np.ones_like(s[0]))
    a, b = minus(one, s), minus(one, c)

    def power(x: Interval, n: int) -> Interval:
        return x[0] ** n, x[1] ** n  # of what is not negative

    def half(s: Interval, c: Interval, a: Interval, b: Interval, turn: float) -> list[list[Interval]]:
        """The three functions that belong to one end; the angle runs backwards for the other, ``turn`` = -1."""
        g = [
            power(a, 4),
            scaled(times(s, power(a, 3)), 4.0),
            times(times(power(a, 2), b), plus(plus(scaled(s, 8.0), scaled(c, 3.0)), scaled(one, 9.0))),
        ]
        d = [
            scaled(times(power(a, 3), c), -4.0),
            scaled(times(times(power(a, 2), c), minus(a, scaled(s, 3.0))), 4.0),
            plus(
                times(
                    plus(scaled(times(times(a, c), b), -2.0), times(power(a, 2), s)),
                    plus(plus(scaled(s, 8.0), scaled(c, 3.0)), scaled(one, 9.0)),
                ),
                times(times(power(a, 2), b), minus(scaled(c, 8.0), scaled(s, 3.0))),
            ),
        ]
        e = [
            plus(scaled(times(power(a, 2), power(c, 2)), 12.0), scaled(times(power(a, 3), s), 4.0)),
            None,
            None,
        ]
        # By products: (s a³)'' and (a² b w)'', w = 8s + 3c + 9.
        first = plus(scaled(times(power(a, 2), power(c, 2)), -6.0), scaled(times(power(a, 3), s), -1.0))
        second = times(s, plus(scaled(times(a, power(c, 2)), 6.0), scaled(times(power(a, 2), s), 3.0)))
        e[1] = scaled(plus(first, second), 4.0)
        w = plus(plus(scaled(s, 8.0), scaled(c, 3.0)), scaled(one, 9.0))
        w1, w2 = minus(scaled(c, 8.0), scaled(s, 3.0)), scaled(plus(scaled(s, 8.0), scaled(c, 3.0)), -1.0)
        a1, a2 = scaled(times(a, c), -2.0), plus(scaled(power(c, 2), 2.0), scaled(times(a, s), 2.0))
        squares = power(a, 2)
        e[2] = plus(
            plus(times(times(a2, b), w), plus(times(times(squares, c), w), times(times(squares, b), w2))),
            scaled(plus(plus(times(times(a1, s), w), times(times(a1, b), w1)), times(times(squares, s), w1)), 2.0),
        )
        return [g, [scaled(x, turn) for x in d], e]

    start, end = half(s, c, a, b, 1.0), half(c, s, b, a, -1.0)
    return [[*start[k], *end[k][::-1]] for k in range(3)]


def plus(x: Interval, y: Interval) -> Interval:
    return x[0] + y[0], x[1] + y[1]


def minus(x: Interval, y: Interval) -> Interval:
    return x[0] - y[1], x[1] - y[0]


def scaled(x: Interval, factor: float) -> Interval:
    return (x[0] * factor, x[1] * factor) if factor >= 0 else (x[1] * factor, x[0] * factor)


def times(x: Interval, y: Interval) -> Interval:
    ends = [x[i] * y[j] for i in (0, 1) for j in (0, 1)]
    return np.minimum.reduce(ends), np.maximum.reduce(ends)


def dot(x: list[Interval], y: list[Interval]) -> Interval:
    return plus(plus(times(x[0], y[0]), times(x[1], y[1])), times(x[2], y[2]))


BOOT = Path(__file__).parent.parent / "examples" / "car_boot.toml"


def nets(quick: bool) -> None:
    """Print what nets of lines on the boot lid take, and complain where one takes longer than its report picture."""
    model = quintrig.load(BOOT)
    surface, picture = model.patches[0].surface, "its report picture, of H in space"
    ways = {
        picture: lambda: to_png_bytes(space_picture(surface, "mean", unit=model.unit), 144),
        "net of lines of curvature": lambda: quintrig.lines(model, "curvature"),
        "net of asymptotic lines": lambda: quintrig.lines(model, "asymptotic"),
        "geodesic between two points": lambda: quintrig.lines(model, "geodesic", start=(0.1, 0.1), to=(0.9, 0.8)),
        "isophotes": lambda: quintrig.lines(model, "isophotes", direction=(0, 0, 1)),
    }
    found = race(ways, 5 if quick else 15)
    rows = [(name, f"{one.median * 1e3:.0f}", spelt(one, found[picture])) for name, one in found.items()]
    print("\nLines on the boot lid, the report picture being 1\n")
    table(("what", "milliseconds", "pictures"), rows)
    middle = ratio(found["net of lines of curvature"], found[picture])[0]
    if middle > 1.0:
        print(f"\nnet of lines of curvature: {middle:.1f} pictures, more than 1")


def report(quick: bool) -> None:
    """Print the tables."""
    points = net()
    surface = quintrig.tensor(points)
    grid = quintrig.grid(129, 129)
    sampling = "sampling at 129 x 129 points"
    ways = {
        sampling: lambda: quintrig.analyse(surface, *grid),
        "regular": lambda: Prover(surface).prove("regular"),
        "gaussian >= 0": lambda: Prover(surface).prove("gaussian >= 0"),
        "range of K to 1e-3": lambda: Prover(surface).bounds("gaussian", 1e-3),
    }
    boxes = {
        "regular": Prover(surface).prove("regular").boxes,
        "gaussian >= 0": Prover(surface).prove("gaussian >= 0").boxes,
        "range of K to 1e-3": Prover(surface).bounds("gaussian", 1e-3).boxes,
    }
    times_ = race(ways, 5 if quick else 15)
    rows = [
        (name, f"{times_[name].median * 1e3:.2f}", spelt(times_[name], times_[sampling]), f"{most}", f"{boxes[name]}")
        for name, most in CLAIMS.items()
    ]
    print("Proofs on a tensor-product patch, every quantity of one sampling at 129 x 129 points being 1\n")
    table(("claim", "milliseconds", "samplings", "at most", "boxes"), rows)
    rival = RIVAL_BOXES // (16 if quick else 1)
    share = interval_boxes(points, rival)
    print("\nBoxes to decide the sign of K\n")
    rows = [
        ("Bernstein forms", f"{boxes['gaussian >= 0']}", "100 %"),
        ("intervals", f"{rival:,}", f"{100 * share:.0f} %"),
    ]
    table(("way", "boxes", "of the patch decided"), rows)
    for name, most in CLAIMS.items():
        middle = ratio(times_[name], times_[sampling])[0]
        if middle > most:
            print(f"\n{name}: {middle:.0f} samplings, more than {most}")
    nets(quick)
