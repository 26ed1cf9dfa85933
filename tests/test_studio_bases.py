"""Bases in the browser: formulas evaluated there are Python's to 1e-12, on every construction and curve."""

import numpy as np
import pytest

import quintrig
from node import asked
from quintrig.basis.library import LIBRARY
from quintrig.basis.registry import entry
from quintrig.model.model import Model
from quintrig.studio.bases import MOST_POINTS, beyond, library
from quintrig.studio.built import for_page
from quintrig.studio.data import table
from quintrig.support.errors import ModelError

SCRIPT = """
import { readFileSync } from "node:fs";
const studio = await import(process.argv[1]);
const numbers = (a) => Array.from(a, (x) => (Number.isFinite(x) ? x : null));
const tell = {
  functions: ({ name, points, values, t }) => {
    const formulas = new studio.Formulas(studio.entry(name).basis(points), values);
    return t.map((x) => formulas.series(x, 3).map(numbers));
  },
  fast: ({ name, points, values, t }) => {
    const functions = studio.family(studio.entry(name), points, values);
    const out = new Float64Array(3 * t.length * functions.size);
    functions.derivatives(Float64Array.from(t), t.length, out);
    return numbers(out);
  },
  surface: ({ model, u, v }) => {
    const sample = studio.analyse(studio.build(studio.fromDict(model).patches[0]), u, v);
    return Object.fromEntries(Object.entries(sample).map(([key, a]) => [key, numbers(a)]));
  },
  curve: ({ model, t }) => {
    const curve = studio.curveOf(studio.fromDict(model).patches[0]);
    const at = t.map((x) => curve.at(x));
    const keys = ["point", "curvature", "torsion", "bend"];
    return { length: curve.length, ...Object.fromEntries(keys.map((key) => [key, at.map((one) => one[key])])) };
  },
  said: ({ model }) => {
    try {
      studio.fromDict(model);
      return "";
    } catch (error) {
      return error.message;
    }
  },
};
const jobs = JSON.parse(readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(jobs.map(({ what, ...job }) => tell[what](job))));
"""


def inside(parameters, shares):
    """Return values of parameters at shares of their ranges, clear of ends that are left out."""
    return [
        one.low + (one.high - one.low) * (0.01 + 0.98 * share) for one, share in zip(parameters, shares, strict=True)
    ]


T = [0.0, 1e-7, 0.01, 0.3, 0.5, 0.77, 0.99, 1 - 1e-7, 1.0]
RANDOM = np.random.default_rng(11)
FUNCTIONS = [
    (one.name, points, inside(one.basis(points).parameters, RANDOM.uniform(0, 1, len(one.basis(points).parameters))))
    for one in LIBRARY
    for points in sorted({one.sizes[0], one.usual, max(n for n in one.sizes if n <= MOST_POINTS)})
    for _ in range(2)
]
OWN = {"functions": ["r*(1+lam*t*r)", "t*(1-lam*r^2)"], "parameters": {"lam": [-0.5, 0.5]}}
THREE = {
    "functions": ["exp(-k*t)*r^2", "1-exp(-k*t)*r^2-t^2*sqrt(1+k*r)", "t^2*sqrt(1+k*r)"],
    "parameters": {"k": [0.0, 2.0]},
}
BASES = {"line": OWN, "waxed": THREE}


def curve(count, dimension=3):
    return RANDOM.uniform(-5, 5, (count, dimension)).tolist()


def net(n, m):
    return RANDOM.uniform(-5, 5, (n, m, 3)).tolist()


FLAT = [[-2, 0.3, 1, 3], [-1, 0.2, 1, 1], [0.2, -0.1, 1, 0.5], [1.5, 0.1, 1, 2]]
MODELS = {
    "tensor, cubic and SG": {
        "kind": "tensor",
        "basis": ["cubic", "sg_bezier"],
        "points": net(4, 3),
        "shape": [0.3, -1, 0.5, -0.7],
    },
    "tensor, own": {
        "kind": "tensor",
        "basis": ["waxed", "line"],
        "bases": BASES,
        "points": net(3, 2),
        "shape": [0.7, 0.2],
    },
    "tensor where it starts": {"kind": "tensor", "basis": ["c_bezier", "h_bezier"], "points": net(4, 4)},
    "tensor of many": {"kind": "tensor", "basis": ["generalised_trigonometric", "lambda_bezier"], "points": net(16, 9)},
    "symmetric": {"kind": "symmetric", "basis": ["cubic", "quintic"], "points": net(2, 6), "mirror": [1, 0.2, 0, -7]},
    "symmetric with a middle row": {
        "kind": "symmetric",
        "basis": ["quadratic", "alpha_bernstein"],
        "points": [curve(5), [[0, y, y * y] for y in range(5)]],
        "mirror": [1, 0, 0, 0],
    },
    "swept": {
        "kind": "swept",
        "basis": ["normalised_trigonometric", "q_bernstein"],
        "section": curve(5),
        "trajectory": curve(4),
        "shape": [1.1, 0.6],
    },
    "swung": {
        "kind": "swung",
        "basis": ["ali_cubic", "generalised_trigonometric_squares"],
        "profile": curve(4, 2),
        "trajectory": curve(6, 2),
        "scale": 1.3,
    },
    "ruled": {
        "kind": "ruled",
        "basis": ["trigonometric", "quartic"],
        "first": curve(6),
        "second": curve(5),
        "shape": [-4, 0, 0.4, -2],
    },
    "ruled, still at an end of one": {
        "kind": "ruled",
        "basis": ["quintic", "bernstein"],
        "first": curve(6),
        "second": curve(3),
        "shape": [-4, -4],
    },
    "developable": {
        "kind": "developable",
        "basis": "cubic",
        "planes": FLAT,
        "bounds": [[0, 1, 0, 0], [0, 1, 0, -4]],
        "shape": [0.5, -1],
    },
    "developable, classical": {
        "kind": "developable",
        "basis": "bernstein",
        "planes": FLAT,
        "bounds": [[0, 1, 0, 0], [0, 1, 0, -4]],
    },
    "moves with the origin": {
        "kind": "tensor",
        "basis": ["off", "bernstein"],
        "bases": {"off": {"functions": ["r", "1.1*t"]}},
        "unchecked_basis": True,
        "points": (np.array(net(2, 4)) + 50).tolist(),
    },
    "far out": {"kind": "tensor", "basis": "cubic", "points": (np.array(net(4, 4)) + 1e6).tolist()},
}
CURVES = {
    "plane": {"kind": "curve", "points": curve(6, 2), "shape": [-1, 0.5]},
    "in space": {"kind": "curve", "points": curve(6), "shape": [0.5, -3]},
    "closed": {"kind": "curve", "points": curve(3, 2), "basis": "cubic", "close": True},
    "own": {"kind": "curve", "points": curve(3), "basis": "waxed", "bases": BASES, "shape": [1.5]},
    "from the other end": {"kind": "curve", "points": curve(6, 2), "flip": True, "shape": [0.5, -1]},
    "many": {"kind": "curve", "points": curve(20, 2), "basis": "lambda_bezier", "shape": [0.4]},
}
PARAMETERS = np.linspace(0.04, 0.97, 6)


def mistaken(table, **keys):
    return {"kind": "curve", "points": [[0, 0], [1, 2]], "basis": "mine", "bases": {"mine": table}, **keys}


LINE = {"functions": ["r", "t"]}
MISTAKES = [
    mistaken({"functions": ["1-t", "t*sinn(t)"]}),
    mistaken({"functions": ["1-t", "t*x"]}),
    mistaken({"functions": ["1-t", "2t"]}),
    mistaken({"functions": ["1-t", "t**2"]}),
    mistaken({"functions": ["1-t", "t^2^3"]}),
    mistaken({"functions": ["1-t", "t^2.5"]}),
    mistaken({"functions": ["1-t", "t^99"]}),
    mistaken({"functions": ["1-t", "(t"]}),
    mistaken({"functions": ["1-t", ""]}),
    mistaken({"functions": ["1-t", "t.real"]}),
    mistaken({"functions": ["1-t", "__import__('os')"]}),
    mistaken({"functions": ["1-t", "sin(t, 2)"]}),
    mistaken({"functions": ["1-t", "(" * 60 + "t" + ")" * 60]}),
    mistaken({"functions": ["1-t", "+".join(["t"] * 500)]}),
    mistaken({"functions": ["1-t", "t" * 5000]}),
    mistaken({"functions": ["1-t", "1/(t-0.5)"]}),
    mistaken({"functions": ["1-t", "sqrt(t-0.5)"]}),
    mistaken({"functions": ["1-t", "t/k"], "parameters": {"k": [0, 1]}}),
    mistaken({"functions": ["1-t", "exp(800*t)"]}),
    mistaken({"functions": ["1-t"]}),
    mistaken({"functions": ["t"] * 65}),
    mistaken({"functions": "1-t"}),
    mistaken({"functions": ["1-t", 3]}),
    mistaken({"funktions": ["1-t", "t"]}),
    mistaken({"functions": ["1-t", "t"], "parameters": {"k": [1, 0]}}),
    mistaken({"functions": ["1-t", "t"], "parameters": {"k": 3}}),
    mistaken({"functions": ["1-t", "t"], "parameters": {"t": [0, 1]}}),
    mistaken({"functions": ["1-t", "t"], "parameters": {"k k": [0, 1]}}),
    mistaken({"functions": ["1-t", "1.2*t"]}),
    mistaken(LINE, points=[[0, 0], [1, 1], [2, 0]]),
    mistaken(LINE, shape=[1]),
    mistaken(LINE, basis="mien"),
    mistaken({**LINE, "parameters": {"k": [0, 1]}}, shape=[2]),
    mistaken({**LINE, "parameters": {"k": [0, 1]}}, shape=[1, 1]),
    {"kind": "curve", "points": [[0, 0], [1, 2]], "bases": {"cubic": LINE}, "basis": "cubic"},
    {"kind": "curve", "points": [[0, 0], [1, 2], [2, 0]]},
    {"kind": "curve", "points": [[0, 0], [1, 2], [2, 0]], "basis": "cubic", "flip": True, "close": True},
    {"kind": "tensor", "basis": ["cubic", "quintic"], "points": np.zeros((4, 5, 3)).tolist()},
    {"kind": "tensor", "basis": ["cubic", "quintic", "cubic"], "points": np.zeros((4, 6, 3)).tolist()},
    {"kind": "symmetric", "basis": "cubic", "points": np.zeros((3, 4, 3)).tolist(), "mirror": [1, 0, 0, 0]},
    {"kind": "symmetric", "basis": "quadratic", "points": np.ones((2, 3, 3)).tolist(), "mirror": [1, 0, 0, 0]},
    {"kind": "swept", "basis": "cubic", "section": np.zeros((4, 3)).tolist(), "trajectory": np.zeros((5, 3)).tolist()},
    {"kind": "swept", "basis": "cubic", "section": curve(4), "trajectory": curve(4), "shape": [0, 0, 0, 2]},
    {
        "bases": {"mine": {"functions": ["r", "t+"]}},
        "patch": [{"kind": "curve", "points": [[0, 0], [1, 1]], "basis": "mine"}],
    },
]


@pytest.fixture(scope="module")
def told():
    """Return what Node says, by kind of question: all are put at once."""
    t, grid = T, PARAMETERS.tolist()
    jobs = {
        "functions": [{"name": n, "points": p, "values": v, "t": t} for n, p, v in FUNCTIONS],
        "fast": [{"name": n, "points": p, "values": v, "t": t} for n, p, v in FUNCTIONS],
        "surface": [{"model": for_page(Model.from_dict(one)), "u": grid, "v": grid} for one in MODELS.values()],
        "curve": [{"model": for_page(Model.from_dict(one)), "t": grid} for one in CURVES.values()],
        "said": [{"model": one} for one in MISTAKES],
    }
    answers = iter(asked(SCRIPT, [{"what": what, **job} for what, them in jobs.items() for job in them]))
    return {what: [next(answers) for _ in them] for what, them in jobs.items()}


@pytest.mark.parametrize("index", range(len(FUNCTIONS)), ids=lambda i: f"{FUNCTIONS[i][0]}-{FUNCTIONS[i][1]}-{i % 2}")
def test_functions_and_three_derivatives_are_pythons(told, index):
    name, points, values = FUNCTIONS[index]
    ours = entry(name).basis(points).family(values).derivatives(np.array(T), 3)
    theirs = np.array(told["functions"][index], dtype=float).transpose(2, 0, 1) * np.array([1, 1, 2, 6])[:, None, None]
    scale = np.abs(ours).max(axis=(1, 2), keepdims=True)
    assert (np.abs(theirs - ours) <= 1e-12 * scale).all()
    # Nothing cancels at the ends: what is tiny there is right in its own digits, but where the definition subtracts.
    rounding = 1e-13 if name in ("c_bezier", "h_bezier") else 0.0
    assert (np.abs(theirs - ours)[0] <= 1e-12 * np.abs(ours[0]) + rounding).all()
    fast = np.array(told["fast"][index]).reshape(3, len(T), -1)
    assert (np.abs(fast - ours[:3]) <= 1e-12 * scale[:3]).all()


@pytest.mark.parametrize("name", MODELS)
def test_surfaces_on_any_bases_are_pythons(told, name):
    there = told["surface"][list(MODELS).index(name)]
    surface = Model.from_dict(MODELS[name]).surface
    keys = ("point", "normal", "gaussian", "mean", "curvedness", "E", "L")
    ours = quintrig.analyse(surface, PARAMETERS[:, None], PARAMETERS[None, :], keys)
    bend = np.nanmax(ours["curvedness"])
    scales = {"gaussian": bend**2, "mean": bend, "curvedness": bend, "normal": 1.0, "L": bend * np.nanmax(ours["E"])}
    for key in keys:
        own, theirs = np.asarray(ours[key], dtype=float).ravel(), np.array(there[key], dtype=float)
        assert np.array_equal(np.isnan(own), np.isnan(theirs)), key
        scale = scales.get(key, np.nanmax(np.abs(own)))
        assert np.nanmax(np.abs(own - theirs), initial=0.0) <= 1e-12 * scale, key


@pytest.mark.parametrize("name", CURVES)
def test_curves_are_pythons(told, name):
    there = told["curve"][list(CURVES).index(name)]
    ours = Model.from_dict(CURVES[name]).curve().curve
    flat = ours.points.shape[1] == 2
    size = np.abs(ours.points).max()
    assert np.abs(np.array(there["point"])[:, : 2 if flat else 3] - ours(PARAMETERS)).max() <= 1e-13 * size
    curvature = ours.signed_curvature(PARAMETERS) if flat else ours.curvature(PARAMETERS)
    assert there["curvature"] == pytest.approx(curvature, rel=1e-11, abs=1e-12 / size)
    assert there["length"] == pytest.approx(ours.length(), rel=1e-8)
    if not flat:
        assert there["torsion"] == pytest.approx(ours.torsion(PARAMETERS), rel=1e-10)
    tips = ours(PARAMETERS) - 0.7 * np.array(there["bend"])[:, : 2 if flat else 3]
    assert tips == pytest.approx(ours.comb(PARAMETERS, 0.7), rel=1e-11, abs=1e-12 * size)


@pytest.mark.parametrize("index", range(len(MISTAKES)))
def test_mistakes_are_told_as_python_tells_them(told, index):
    with pytest.raises(ModelError) as caught:
        Model.from_dict(MISTAKES[index])
    assert told["said"][index] == str(caught.value)
    assert "\n" not in told["said"][index]


def test_the_page_holds_every_basis_and_is_sent_the_rest():
    assert (
        [one["name"] for one in library()]
        == [one.name for one in LIBRARY]
        == [one["name"] for one in table()["library"]]
    )
    small = Model.from_dict(MODELS["tensor of many"])
    assert beyond(small) == []
    (sent,) = beyond(Model.from_dict(CURVES["many"]))
    assert (sent["name"], list(sent["formulas"])) == ("lambda_bezier", ["20"])
    assert "built" not in for_page(small)
