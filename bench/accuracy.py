"""Largest errors over the exact cases of tests/data/cases.json, relative to each point's curvedness."""

import json
from pathlib import Path

import numpy as np

import quintrig

CASES = Path(__file__).parent.parent / "tests" / "data" / "cases.json"
POWERS = {"gaussian": 2, "mean": 1, "k1": 1, "k2": 1, "curvedness": 1, "shape_index": 0}


def errors(path: str) -> dict[str, float]:
    """Return the largest error of each quantity on the ``grid`` or the ``scattered`` path."""
    worst = dict.fromkeys(POWERS, 0.0)
    for case in json.loads(CASES.read_text()):
        surface = quintrig.Model.from_dict(case["model"]).surface
        for p in case["points"]:
            at = ([[p["u"]]], [[p["v"]]]) if path == "grid" else (p["u"], p["v"])
            sample = quintrig.analyse(surface, *at, tuple(POWERS))
            for key, power in POWERS.items():
                if p[key] is not None:
                    error = abs(float(np.ravel(sample[key])[0]) - p[key]) / p["curvedness"] ** power
                    worst[key] = max(worst[key], error)
    return worst


def report() -> None:
    """Print the table."""
    print("Accuracy: largest error over 33 exact models x 5 points, relative to the curvedness (K: to its square)\n")
    grid, scattered = errors("grid"), errors("scattered")
    print(f"| {'quantity':12} | {'grid':>8} | {'scattered':>9} |\n|{'-' * 14}|{'-' * 9}:|{'-' * 10}:|")
    for key in POWERS:
        print(f"| {key:12} | {grid[key]:8.1e} | {scattered[key]:9.1e} |")
    print()
