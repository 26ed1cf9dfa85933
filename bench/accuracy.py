"""Largest errors over the exact cases of tests/data/cases.json, relative to each point's curvedness."""

import json
from pathlib import Path

import numpy as np

import quintrig
from bench.timing import table
from quintrig.analysis.stream import analyse_blocks

CASES = Path(__file__).parent.parent / "tests" / "data" / "cases.json"
POWERS = {"gaussian": 2, "mean": 1, "k1": 1, "k2": 1, "curvedness": 1, "shape_index": 0}
PATHS = ("grid", "scattered", "streamed")


def values(surface: quintrig.Surface, points: list[dict[str, float]], path: str) -> dict[str, np.ndarray]:
    """Return each quantity at the points, by one of the ways to the same numbers."""
    u, v = (np.array([p[name] for p in points]) for name in "uv")
    if path == "scattered":
        sample = quintrig.analyse(surface, u, v, tuple(POWERS))
        return {key: sample[key] for key in POWERS}
    if path == "grid":
        sample = quintrig.analyse(surface, u[:, None], v[None, :], tuple(POWERS))
        return {key: np.diagonal(sample[key]) for key in POWERS}
    # The points lie on a grid of 21 x 21.
    (block,) = analyse_blocks(surface, 21, 21, tuple(POWERS))
    at = np.rint(20 * u).astype(int), np.rint(20 * v).astype(int)
    return {key: block.sample[key][at] for key in POWERS}


def errors(path: str) -> dict[str, float]:
    """Return the largest error of each quantity on one path."""
    worst = dict.fromkeys(POWERS, 0.0)
    for case in json.loads(CASES.read_text()):
        surface = quintrig.Model.from_dict(case["model"]).surface
        found = values(surface, case["points"], path)
        for key, power in POWERS.items():
            for p, value in zip(case["points"], found[key], strict=True):
                if p[key] is not None:
                    worst[key] = max(worst[key], abs(value - p[key]) / p["curvedness"] ** power)
    return worst


def report(quick: bool) -> None:
    """Print the table."""
    print("Accuracy: largest error over 33 exact models x 5 points, relative to the curvedness (K: to its square)\n")
    found = [errors(path) for path in PATHS]
    table(("quantity", *PATHS), [(key, *(f"{worst[key]:.1e}" for worst in found)) for key in POWERS])
