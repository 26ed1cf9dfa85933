"""The browser's numbers against Python's, for every quantity: in Node, on the bundle that ships."""

import json
from pathlib import Path

import numpy as np
import pytest

import quintrig
from catalogue import SURFACES
from node import asked
from quintrig.quantities import table
from quintrig.quantities.table import BY_KEY, QUANTITIES
from random_models import RANDOM, displaced

CASES = json.loads((Path(__file__).parent / "data" / "cases.json").read_text())
KINDS = [
    {"kind": "symmetric", "shape": [1, -2, 0.5, -4], "mirror": [1, 0.2, 0, -3]},
    {"kind": "sphere", "radius": 2.5},
    {"kind": "ellipsoid"},
    {"kind": "cylinder", "flip": True},
    {"kind": "cone"},
    {"kind": "torus"},
    {"kind": "catenoid"},
    {"kind": "helicoid"},
    {"kind": "hyperbolic_paraboloid"},
    {"kind": "monkey_saddle"},
    {"kind": "enneper"},
    {"kind": "swept", "basis": "bernstein", "section": [[0, 0, 0], [1, 0, 2], [3, 1, 0], [4, 0, 1]]},
    {
        "kind": "nurbs",
        "degrees": [2, 2],
        "knots": [[0, 0, 0, 1, 3, 3, 3], [0, 0, 0, 1, 1, 1]],
        "weights": [[1, 0.7, 1], [2, 1, 1], [1, 1, 0.5], [1, 3, 1]],
    },
]
QUADRATIC = {"kind": "tensor", "basis": "bernstein"}


def quadratic(x, y, z):
    """Return a model of (x, y, z)(u, v), each given by its coefficients of u², u v, v², u, v."""

    def polar(form, i, j):  # of the three by three Bernstein points: u² is 0, 0, 1, and u is 0, 1/2, 1
        a, b, c, d, e = form
        u, v = i / 2, j / 2
        return a * (i == 2) + b * u * v + c * (j == 2) + d * u + e * v

    return QUADRATIC | {"points": [[[polar(f, i, j) for f in (x, y, z)] for j in range(3)] for i in range(3)]}


EDGES = {
    # A wall with w = u + v along it: n_z is rounding, on both sides of 0, and the invariants in the plane are infinite.
    "vertical wall": quadratic((0, 0, 0, 0.3, 0.3), (0.7, 1.4, 0.7, 0, 0), (0, 0, 0, 1.1, -1.3)),
    # K / C² is 2 ε: on either side of the 1e-6 at which K counts as zero.
    "hardly bent across": quadratic((0, 0, 0, 1, 0), (0, 0, 0, 0, 1), (0.5, 0, 2e-7, 0, 0)),
    "bent enough across": quadratic((0, 0, 0, 1, 0), (0, 0, 0, 0, 1), (0.5, 0, 3e-7, 0, 0)),
    # C times the size is δ √2: on either side of the 1e-6 at which a point counts as flat.
    "hardly bent": quadratic((0, 0, 0, 1, 0), (0, 0, 0, 0, 1), (2.8e-7, 0, 2.8e-7, 0, 0)),
    "bent enough": quadratic((0, 0, 0, 1, 0), (0, 0, 0, 0, 1), (4.2e-7, 0, 4.2e-7, 0, 0)),
    "single point": QUADRATIC | {"points": [[[0.1, 0.2, 0.3]] * 3] * 3},
}
SCRIPT = """
import { readFileSync } from "node:fs";
const studio = await import(process.argv[1]);
const jobs = JSON.parse(readFileSync(0, "utf8"));
const numbers = (array) => Array.from(array, (x) => (Number.isFinite(x) ? x : String(x)));
const answers = jobs.map(({ model, u, v }) => {
  const surface = studio.build(studio.fromDict(model).patches[0]);
  const both = [studio.analyse(surface, u, v, true), studio.analyse(surface, u, v)];
  return both.map((sample) => Object.fromEntries(Object.entries(sample).map(([key, a]) => [key, numbers(a)])));
});
process.stdout.write(JSON.stringify(answers));
"""


def every_job():
    """Every reference case at its points, other kinds at random ones, and edges and corners of all."""
    random = np.random.default_rng(5)
    for case in CASES:
        inside = [(p["u"], p["v"]) for p in case["points"]]
        edges = [(0.0, 0.3), (1.0, 0.6), (0.2, 0.0), (0.7, 1.0), (0.0, 0.0), (1.0, 1.0)]
        u, v = np.array(inside + edges).T
        yield {"model": case["model"], "u": u.tolist(), "v": v.tolist()}
    for keys in KINDS:
        model = dict(keys)
        if model["kind"] == "symmetric":
            model["points"] = random.uniform(-5, 5, (3, 6, 3)).tolist()
        if model["kind"] == "nurbs":
            model["points"] = random.uniform(-5, 5, (4, 3, 3)).tolist()
        if model["kind"] == "swept":
            model["trajectory"] = random.uniform(-5, 5, (3, 3)).tolist()
        u, v = random.uniform(0.02, 0.98, (2, 11))
        yield {"model": model, "u": u.tolist(), "v": v.tolist()}
    for model in EDGES.values():
        u, v = random.uniform(0.02, 0.2, (2, 11))
        yield {"model": model, "u": u.tolist(), "v": v.tolist()}


def far_jobs():
    """Every kind at distances, with shape parameters inside the range, near -4 and at it."""
    random = np.random.default_rng(17)
    for kind in (*RANDOM, "nurbs"):
        for distance in (0.0, 1e3, 1e6, 1e9, 1e12):
            for shape in SHAPES:
                model = (
                    dict(SURFACES["nurbs"].model) if kind == "nurbs" else {"kind": kind, **RANDOM[kind](random, 1.0)}
                )
                if kind != "nurbs":
                    model["shape"] = shape[:2] if kind == "developable" else shape
                if kind == "developable" and shape[0] < -3.5:  # its first ruling would run far away
                    continue
                beside = [[1e-3, 0.3, 0.999], [0.4, 0.998, 1e-3]]
                u, v = np.concatenate([random.uniform(0.02, 0.98, (2, 6)), beside], axis=1).tolist()
                moved = displaced(model, distance * np.array([1.0, -0.7, 0.4]))
                yield {"model": json.loads(json.dumps(moved, default=np.ndarray.tolist)), "u": u, "v": v}


def still_jobs():
    """Kinds with edges at exactly -4, ever nearer to these."""
    random = np.random.default_rng(23)
    for kind in ("tensor", "symmetric", "swept", "swung", "ruled"):
        for shape in ([-4.0] * 4, [-4.0, 0.5, -4.0, 1.0]):
            model = {"kind": kind, **RANDOM[kind](random, 1.0), "shape": shape}
            u = [1e-2, 1e-4, 1e-6, 0.3, 1e-5, 1.0 - 1e-4]
            v = [0.3, 0.7, 0.4, 0.6, 1e-4, 0.2]
            yield {"model": json.loads(json.dumps(model, default=np.ndarray.tolist)), "u": u, "v": v}


SHAPES = ([0.5, -2.0, 1.0, 0.0], [-4.0 + 1e-4, -3.99, -4.0 + 1e-5, -3.999], [-4.0, 0.5, 0.0, -4.0])
JOBS = list(every_job())
FIRST_EDGE = len(JOBS) - len(EDGES)
JOBS += far_jobs()
FIRST_STILL = len(JOBS)
JOBS += still_jobs()
NAMES = [f"{i}-{job['model']['kind']}-{job['model'].get('shape', '')}" for i, job in enumerate(JOBS)]


@pytest.fixture(scope="module")
def answers():
    """What the bundle computes for every job: scattered and on the grid."""
    return asked(SCRIPT, JOBS)


@pytest.mark.parametrize("index", range(len(JOBS)), ids=NAMES)
def test_the_bundle_agrees_with_python_to_1e_11(answers, index):
    job = JOBS[index]
    surface = quintrig.Model.from_dict(job["model"]).surface
    u, v = np.array(job["u"]), np.array(job["v"])
    for path, found in enumerate(answers[index]):
        at = (u, v) if path == 0 else (u[:, None], v[None, :])
        compare(quintrig.analyse(surface, *at), found)


def test_the_edge_cases_are_on_the_edge():
    def at(name, key):
        job = JOBS[FIRST_EDGE + list(EDGES).index(name)]
        surface = quintrig.Model.from_dict(job["model"]).surface
        sample = quintrig.analyse(surface, np.array(job["u"]), np.array(job["v"]))
        if key == "slope":
            return np.abs(sample["normal"][:, 2])
        return sample[key]

    assert (at("vertical wall", "slope") < 1e-12).all()
    assert (at("vertical wall", "slope") > 0).any()  # nothing but VERTICAL makes these infinite
    assert np.isposinf(at("vertical wall", "beta0")).all()
    types = table.BY_KEY["hk_type"].classes
    assert {types[int(code)] for code in at("hardly bent across", "hk_type")} == {"valley"}
    assert {types[int(code)] for code in at("bent enough across", "hk_type")} == {"pit"}
    assert {types[int(code)] for code in at("hardly bent", "hk_type")} == {"flat"}
    assert {types[int(code)] for code in at("bent enough", "hk_type")} == {"pit"}
    assert np.isnan(at("single point", "gaussian")).all()


EXACT = {"gaussian": 2, "mean": 1, "k1": 1, "k2": 1, "curvedness": 1}


@pytest.mark.parametrize("index", range(len(CASES)), ids=NAMES[: len(CASES)])
def test_the_bundle_meets_the_exact_values_to_1e_11_of_the_curvedness(answers, index):
    points, found = CASES[index]["points"], answers[index][0]
    scale = np.array([p["curvedness"] for p in points])
    for key, power in EXACT.items():
        error = np.array(found[key][: len(points)], float) - [p[key] for p in points]
        assert (np.abs(error) <= 1e-11 * scale**power).all(), key


@pytest.mark.parametrize("index", range(FIRST_STILL, len(JOBS)), ids=NAMES[FIRST_STILL:])
def test_the_bundle_loses_no_digits_beside_an_edge_that_stands_still(answers, index):
    job = JOBS[index]
    surface = quintrig.Model.from_dict(job["model"]).surface
    sample = quintrig.analyse(surface, np.array(job["u"]), np.array(job["v"]))
    for key, power in EXACT.items():
        error = np.array(answers[index][0][key], float) - sample[key]
        assert (np.abs(error) <= 1e-12 * sample["curvedness"] ** power).all(), key


def compare(sample, found):
    assert set(found) == {q.key for q in QUANTITIES}
    if sample.size == 0.0:  # a single point: all else is the rounding of nothing
        np.testing.assert_allclose(np.reshape(found["point"], sample.point.shape), sample.point, rtol=1e-15)
        for q in QUANTITIES:
            if q.colour in ("classes", "diverging", "sequential") and q.key not in "EFGLMN":
                told = np.array([float(x) for x in found[q.key]]).reshape(sample[q.key].shape)
                np.testing.assert_array_equal(told, sample[q.key], err_msg=q.key)
        return
    scales = natural_scales(sample)
    for key, numbers in found.items():
        expected = sample[key]
        values = np.array([float(x) for x in numbers]).reshape(expected.shape)
        if BY_KEY[key].colour == "classes":
            np.testing.assert_array_equal(values, expected, err_msg=key)
            continue
        # Where the surface is flat to rounding, rounding decides whether it has a shape index and directions.
        decided = ~(sample["curvedness"] * sample.size <= 1e-10)
        decided = decided[..., None] if key.startswith("direction") else decided if key == "shape_index" else True
        good = np.isfinite(expected) & decided
        np.testing.assert_array_equal(np.isfinite(values) & decided, good, err_msg=key)
        if key == "beta0":  # slope over n_z²: infinite on a wall, whatever rounding does
            np.testing.assert_array_equal(np.isposinf(values), np.isposinf(expected))
        if key.startswith("direction"):
            # A direction has no sense: where rounding decides, both may be opposite.
            sense = np.sign(np.nansum(values * expected, axis=-1, keepdims=True))
            values = values * np.where(sense == 0, 1.0, sense)
        scale = np.broadcast_to(scales[key][..., None] if BY_KEY[key].components == 3 else scales[key], expected.shape)
        with np.errstate(invalid="ignore"):
            error = np.abs(values - expected)
        assert (error[good] <= 1e-11 * scale[good]).all(), (key, (error / scale)[good].max())


def natural_scales(sample):
    """The size to which each quantity is relative: that of its terms, so that a value near zero is not asked too much.

    The invariants in the plane divide by powers of n_z, whose own rounding is relative to 1: one power more.
    """
    e, f, g = sample["E"], sample["F"], sample["G"]
    second = np.linalg.norm(sample.surface.partials(sample.u, sample.v, 2), axis=-1)
    with np.errstate(all="ignore"):
        # A curvature is a difference of terms of this size: below 1e-12 of them all is rounding. Where
        # S_u x S_v nearly vanishes (beside an edge of regression) rounding grows by the inverse of its size.
        terms = second[2, 0] / e + second[1, 1] / np.sqrt(e * g) + second[0, 2] / g
        slant = 0.01 * sample.size**2 / np.sqrt(e * g - f * f)
        bend = np.maximum(sample["curvedness"], 0.1 * terms) * np.maximum(slant, 1.0) ** 2
    second = np.maximum(second, sample.size)
    speed, mixed, cross = e, np.sqrt(e * g), g
    one = np.ones_like(bend)
    reach = 1e-4 * np.abs(sample.point).max()  # far out a point is as exact as its coordinates, to a few units
    steep = np.abs(sample["normal"][..., 2])
    with np.errstate(all="ignore"):
        scales = {
            "point": one * (sample.size + reach), "normal": one, "shape_index": bend / sample["curvedness"],
            "direction1": bend / (sample["k1"] - sample["k2"]), "direction2": bend / (sample["k1"] - sample["k2"]),
            "E": speed, "F": mixed, "G": cross, "L": second[2, 0], "M": second[1, 1], "N": second[0, 2],
            "gaussian": bend**2, "mean": bend, "k1": bend, "k2": bend, "curvedness": bend,
            "beta0": steep**-3, "beta1": bend * steep**-4, "beta2": bend**2 * steep**-5,
            "gamma1": bend * steep**-6, "gamma2": bend * steep**-5, "gamma3": bend * steep**-4,
        }  # fmt: skip
    own = {f"{key}_surface": one if key == "beta0" else bend**2 if key == "beta2" else bend for key in scales}
    return scales | own
