"""Every case of data/cases.json: 33 models, exact to 40 digits, at five points each."""

import json
from pathlib import Path

import numpy as np
import pytest

import quintrig

CASES = json.loads((Path(__file__).parent / "data" / "cases.json").read_text())
IDS = [f"{case['model']['name']}-{case['model']['shape']}-{case['model'].get('scale', '')}" for case in CASES]
POWERS = {"gaussian": 2, "mean": 1, "k1": 1, "k2": 1, "curvedness": 1}
INVARIANTS = ("beta0", "beta1", "beta2", "gamma1", "gamma2", "gamma3")


@pytest.mark.parametrize("path", ["grid", "scattered"])
@pytest.mark.parametrize("case", CASES, ids=IDS)
def test_case_is_met_to_1e_11_of_its_curvedness(case, path):
    surface = quintrig.Model.from_dict(case["model"]).surface
    expected = case["points"]
    u = np.array([p["u"] for p in expected])
    v = np.array([p["v"] for p in expected])
    if path == "grid":
        sample = quintrig.analyse(surface, u[:, None], v[None, :])
        at = (np.arange(len(u)), np.arange(len(v)))
    else:
        sample = quintrig.analyse(surface, u, v)
        at = (np.arange(len(u)),)
    scale = np.array([p["curvedness"] for p in expected])
    for key, power in POWERS.items():
        error = np.abs(sample[key][at] - [p[key] for p in expected]) / scale**power
        assert error.max() <= 1e-11, key
    index = np.array([np.nan if p["shape_index"] is None else p["shape_index"] for p in expected])
    np.testing.assert_allclose(sample["shape_index"][at], index, rtol=0, atol=1e-11)
    size = sample.size
    np.testing.assert_allclose(sample.point[at], [p["point"] for p in expected], rtol=0, atol=1e-13 * size)
    np.testing.assert_allclose(sample.normal[at], [p["normal"] for p in expected], rtol=0, atol=1e-12)


@pytest.mark.parametrize("metric", ["planar", "surface"])
@pytest.mark.parametrize("case", CASES, ids=IDS)
def test_invariants_are_met_to_1e_11_of_their_scale(case, metric):
    surface = quintrig.Model.from_dict(case["model"]).surface
    for p in case["points"]:
        suffix = "" if metric == "planar" else "_surface"
        sample = quintrig.analyse(surface, p["u"], p["v"], [key + suffix for key in INVARIANTS])
        exact = p[f"invariants_{metric}"]
        # The Hessian grows with the slope: its size, from its own eigenvalues, is the scale of each invariant.
        hessian = np.sqrt(max(exact["beta1"] ** 2 - 2 * exact["beta2"], 0.0))
        slope = 1.0 + exact["beta0"]
        scales = {"beta0": slope, "beta1": hessian, "beta2": hessian**2}
        for key in INVARIANTS:
            scale = scales.get(key, slope * hessian)
            assert abs(sample[key + suffix] - exact[key]) <= 1e-11 * scale, key
