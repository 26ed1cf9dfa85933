"""A sweep says infinity where a curvature or an energy has no bound, and only there, as ``summarise`` does."""

import json
from pathlib import Path

import numpy as np
import pytest

import quintrig
from quintrig.analysis.extremes import find_extremes
from quintrig.analysis.integrate import integrals
from quintrig.developables.regression import inner_regression
from quintrig.sweep.part import Task, columns, summaries
from quintrig.sweep.space import Axis, DesignSpace

NAMES = ("alpha1", "zeta1", "alpha2", "zeta2")
SHAPES = [(-4, 0, 0, 0), (0, 0.2, 1, -4), (-4, -4, -4, -4)]
CASES = json.loads((Path(__file__).parent / "data" / "cases.json").read_text())
LINE = np.arange(6.0)


def hilly(seed):
    """A net that is nowhere special, over a square."""
    heights = 0.4 * np.random.default_rng(seed).normal(size=(6, 6, 3))
    x, y = np.meshgrid(LINE, LINE, indexing="ij")
    return np.stack([x, y, 0 * x], axis=-1) + heights


MODELS = {
    "tensor": {"kind": "tensor", "points": hilly(1).tolist()},
    "swept": {"kind": "swept", "section": hilly(2)[0].tolist(), "trajectory": hilly(2)[:, 0].tolist()},
    "ruled": {"kind": "ruled", "first": hilly(3)[:, 0].tolist(), "second": hilly(3)[:, 4].tolist()},
    "swung": {
        "kind": "swung",
        "profile": [[2, 0], [3, 1], [4, 3], [3, 5], [2, 7], [2, 8]],
        "trajectory": [[1, 0], [1, 0.6], [0.7, 1], [0, 1.2], [-0.6, 1.1], [-1, 0.9]],
    },
}


def swept_rows(model, shape, points=16):
    """Return the summary of one design, as a sweep works it out, and the design's surface."""
    names = NAMES[: len(shape)] if len(shape) == 4 else ("alpha", "zeta")
    space = DesignSpace(tuple(Axis(name, value, value, 1) for name, value in zip(names, shape, strict=True)))
    task = Task(model, None, space, points)
    values = dict(zip(names, shape, strict=True))
    row = dict(zip(columns(space), summaries(task, 0, 1)[0], strict=True))
    return row, task.varied()[0].with_parameters(values).surface


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("name", MODELS)
def test_infinite_energies_are_those_that_grow_without_bound(name, shape):
    row, surface = swept_rows(MODELS[name], shape)
    told = integrals(surface, 1e-8)
    assert told.bending_energy.status == "grows without bound"
    assert row["bending_energy"] == np.inf
    assert row["curvedness_max"] == np.inf
    assert find_extremes(surface, ("curvedness",), 33)["curvedness"].maximum.status == "unbounded"
    for finite in ("area", "thin_plate_energy", "curvedness_mean", "gaussian_mean", "mean_mean", "curvedness_min"):
        assert np.isfinite(row[finite]), finite
    assert told.thin_plate_energy.converged
    assert row["thin_plate_energy"] == pytest.approx(told.thin_plate_energy.value, rel=1e-3)


@pytest.mark.parametrize("name", MODELS)
def test_a_regular_design_has_finite_summaries(name):
    for shape in ((0, 0, 0, 0), (-3.5, 1, -2, 0.5)):
        row, surface = swept_rows(MODELS[name], shape)
        assert integrals(surface).bending_energy.converged
        assert np.isfinite(list(row.values())).all()


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(("shape", "end"), [((-4, 0.5, 0.3, -1), 0), ((0.2, -4, -2, 1), 1)])
def test_signs_of_infinity_are_those_of_the_expansion_beside_the_edge(seed, shape, end):
    """Beside the edge S = P + x² A + x³ B, so with q = x² the form's S_qq·n grows as ¾ B·n / x, and all else stays."""
    net = hilly(seed)
    row, surface = swept_rows({"kind": "tensor", "points": net.tolist()}, shape)
    p = surface.partials(np.array(float(end)), np.linspace(0.0, 1.0, 401), 3)
    inward = -1.0 if end else 1.0  # x runs inwards, u need not
    normal = inward * np.cross(p[2, 0], p[0, 1])
    across = inward * (p[3, 0] * normal).sum(-1) / (np.linalg.norm(normal, axis=-1) * (p[2, 0] ** 2).sum(-1))
    along = (p[0, 2] * normal).sum(-1) / (np.cross(p[2, 0], p[0, 1]) ** 2).sum(-1)
    for key, values in (("mean", across), ("gaussian", across * along)):
        for end_name, sense in (("min", -1.0), ("max", 1.0)):
            limit = (sense * values).max()
            if abs(limit) > 1e-2 * np.abs(values).max():  # else it is too near to call
                assert (row[f"{key}_{end_name}"] == sense * np.inf) == (limit > 0.0), (key, end_name)


FLAT = {"kind": "tensor", "points": [[[i, j + 0.1 * i, 2.0 * i - j] for j in range(6)] for i in range(6)]}
PRISM = {  # straight across the edges that stand still
    "kind": "swept",
    "section": [[i, 0.3 * i, 0.0] for i in range(6)],
    "trajectory": [[0, j, np.sin(j)] for j in range(6)],
}
BOWL = {  # a smooth pole, without a tangent plane by parameters
    "kind": "swung",
    "profile": [[0, 0], [1, 0], [2, 0.5], [3, 2], [3, 3], [3, 4]],
    "trajectory": MODELS["swung"]["trajectory"],
}
CONE = {**BOWL, "profile": [[0, 0], [1, 1], [2, 3], [3, 4], [3, 5], [3, 6]]}


@pytest.mark.parametrize("far", [0.0, 1e3])
@pytest.mark.parametrize("model", [FLAT, PRISM], ids=["plane", "prism"])
@pytest.mark.parametrize("shape", [(-4, 0, 0, 0), (0, -4, 0, 0), (-4, -4, 0, 0)])
def test_an_edge_that_stands_still_does_no_harm_where_nothing_bends_across_it(model, shape, far):
    exact = integrals(swept_rows(model, shape)[1]).bending_energy
    moved = json.loads(json.dumps(model))
    for row in moved.get("points", [moved.get("section", [])]):
        for point in row:
            point[2] += far
    row, _ = swept_rows(moved, shape, 32)
    assert exact.converged
    assert row["singular"] > 0
    assert np.isfinite(list(row.values())).all()
    assert row["bending_energy"] == pytest.approx(exact.value, rel=1e-2, abs=1e-9)


def test_a_smooth_pole_is_finite_and_an_apex_is_not():
    smooth, bowl = swept_rows(BOWL, (0, 0, 0, 0), 32)
    exact = integrals(bowl).bending_energy
    assert exact.converged
    assert smooth["singular"] == 32
    assert smooth["bending_energy"] == pytest.approx(exact.value, rel=1e-2)
    assert np.isfinite(list(smooth.values())).all()
    pointed, cone = swept_rows(CONE, (0, 0, 0, 0), 32)
    assert integrals(cone).bending_energy.status == "grows without bound"
    assert pointed["bending_energy"] == pointed["curvedness_max"] == np.inf


@pytest.mark.parametrize(
    "model", [case["model"] for case in CASES if case["model"]["kind"] == "developable"], ids=lambda m: str(m["shape"])
)
def test_an_edge_of_regression_inside_makes_the_energy_infinite(model):
    row, surface = swept_rows(model, model["shape"])
    inside = inner_regression(surface) is not None
    assert (row["bending_energy"] == np.inf) == inside
    assert (row["curvedness_max"] == np.inf) == inside
    assert inside == (np.inf in (row["mean_max"], -row["mean_min"]))
    assert inside == (integrals(surface, 1e-6, 16).bending_energy.status == "grows without bound")
    assert abs(row["gaussian_max"]) < np.inf


def test_a_design_without_a_regular_point_has_no_energy():
    row, _ = swept_rows({"kind": "tensor", "points": [[[1.0, 2.0, 3.0]] * 6] * 6}, (0, 0, 0, 0))
    assert row["singular"] == 256
    assert np.isnan([row[name] for name in ("bending_energy", "curvedness_max", "gaussian_min", "mean_mean")]).all()


def test_flipping_turns_the_signs_of_infinity():
    row, _ = swept_rows(MODELS["tensor"], SHAPES[0])
    turned, _ = swept_rows({**MODELS["tensor"], "flip": True}, SHAPES[0])
    assert (turned["mean_min"], turned["mean_max"]) == (-row["mean_max"], -row["mean_min"])
    assert (turned["gaussian_min"], turned["gaussian_max"]) == (row["gaussian_min"], row["gaussian_max"])


def test_designs_with_and_without_singular_edges_stand_side_by_side():
    space = DesignSpace((Axis("alpha1", -4.0, 1.0, 3), Axis("zeta2", -4.0, 1.0, 3)))
    rows = summaries(Task(MODELS["tensor"], None, space, 12), 0, 9)
    endless = np.isinf(rows[:, columns(space).index("bending_energy")])
    np.testing.assert_array_equal(endless, (rows[:, :2] == -4.0).any(axis=1))
    assert quintrig.Model.from_dict(MODELS["tensor"]).patch().shape == (0.0,) * 4


def at_random(kind, seed):
    """Return a rough model of a kind and a shape with at least one parameter at -4, others just above it."""
    rng = np.random.default_rng(seed)
    net = hilly(100 + seed)
    shape = rng.choice([-4.0, -4.0, -3.99, -3.9, -1.3, 0.0, 1.0], size=4)
    shape[seed % 4] = -4.0
    model = {
        "tensor": {"points": net.tolist()},
        "symmetric": {"points": net[:3].tolist(), "mirror": [1, 0, 0, -3]},
        "swept": {"section": net[0].tolist(), "trajectory": net[:, 0].tolist()},
        "ruled": {"first": net[:, 0].tolist(), "second": net[:, 4].tolist()},
        "swung": {
            key: (np.array(MODELS["swung"][key]) + 0.05 * rng.normal(size=(6, 2))).tolist()
            for key in ("profile", "trajectory")
        },
    }[kind]
    return {"kind": kind, **model}, tuple(shape.tolist())


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("kind", ["tensor", "symmetric", "swept", "ruled", "swung"])
def test_sweeps_and_extremes_agree_on_what_has_no_bound(kind, seed):
    model, shape = at_random(kind, seed)
    row, surface = swept_rows(model, shape)
    found = find_extremes(surface, ("gaussian", "mean", "curvedness"), 33)
    for key, both in found.items():
        for name, end in (("min", both.minimum), ("max", both.maximum)):
            assert (end.status == "unbounded") == np.isinf(row[f"{key}_{name}"]), (key, name)
            assert end.status != "undefined"
    if kind == "ruled":  # K = -M²/W² on any ruled surface
        assert row["gaussian_max"] <= 0.0
        assert found["gaussian"].maximum.value <= 0.0
