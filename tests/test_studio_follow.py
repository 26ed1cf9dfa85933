"""What follows an edited patch in the browser is what Python makes of it: in Node, on the bundle."""

import numpy as np
import pytest

import quintrig
from node import asked

SCRIPT = """
import { readFileSync } from "node:fs";
const studio = await import(process.argv[1]);
const jobs = JSON.parse(readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(jobs.map(({ keys, edited }) => {
  const model = studio.fromDict(keys);
  return [studio.followed(model, 0, { ...model.patches[0], ...edited }), studio.leftToPython(model)];
})));
"""


def tensor(name, x, y, seed, **more):
    i, j = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    z = 4.0 * np.random.default_rng(seed).standard_normal((6, 6))
    return {"name": name, "kind": "tensor", "points": np.stack([20 * i + x, 20 * j + y, z], -1).tolist(), **more}


def swept(name, x):
    section = [[x + 20 * i, 0, i * (5 - i)] for i in range(6)]
    return {"name": name, "kind": "swept", "section": section, "trajectory": [[0, 20 * j, j * j] for j in range(6)]}


def rule(first, second, order, ratio=1.0):
    return {"first": first, "second": second, "order": order, "ratio": ratio}


def corner(order):
    patches = [tensor("abcd"[k], 100 * (k % 2), 100 * (k // 2), k) for k in range(4)]
    pairs = (("a:u1", "b:u0"), ("a:v1", "c:v0"), ("c:u1", "d:u0"), ("b:v1", "d:v0"))
    return {"patch": patches, "join": [rule(*pair, order, 1.2) for pair in pairs]}


SHAPE = {"shape": [0.5, -1, 0.3, -2]}
MODELS = {
    order: {
        "patch": [tensor("a", 0, 0, 1, **SHAPE), tensor("b", 100, 0, 2, shape=[-0.5, 0.7, 0.3, -2])],
        "join": [rule("a:u1", "b:u0", order, 0.8)],
    }
    for order in ("G0", "G1", "G2", "G3")
}
TURNED = tensor("b", 100, 0, 2, shape=[0.3, -2, 1, 0])
TURNED["points"] = np.swapaxes(TURNED["points"], 0, 1)[::-1].tolist()
MODELS |= {
    "another side": {"patch": [tensor("a", 0, 0, 1, **SHAPE), TURNED], "join": [rule("a:u1", "b:v0", "G2")]},
    "other functions": {
        "patch": [tensor("a", 0, 0, 1, **SHAPE), tensor("b", 100, 0, 2)],
        "join": [rule("a:u1", "b:u0", "G1")],
    },
    "bernstein": {
        "patch": [tensor(n, 100 * k, 0, k, basis="bernstein") for k, n in enumerate("ab")],
        "join": [rule("a:u1", "b:u0", "G3", 1.5)],
    },
    "a chain": {
        "patch": [tensor(n, 100 * k, 0, k) for k, n in enumerate("abc")],
        "join": [rule("b:u1", "c:u0", "G3"), rule("a:u1", "b:u0", "G2")],
    },
    "swept": {"patch": [swept("a", 0), swept("b", 100)], "join": [rule("a:u1", "b:u0", "G2", 1.3)]},
    "ruled": {
        "patch": [
            tensor("a", 0, 0, 1),
            {
                "name": "b",
                "kind": "ruled",
                "first": [[100, 20 * j, 0] for j in range(6)],
                "second": [[160, 20 * j, j] for j in range(6)],
            },
        ],
        "join": [{"first": "a:u1", "second": "b:v0", "order": "G1"}],
    },
    "corner G1": corner("G1"),
    "corner G2": corner("G2"),
    "corner G3": corner("G3"),
}


def edit(keys):
    """Return the keys of the first patch that change: a point of the side that leads, and one behind it."""
    first = keys["patch"][0]
    key = "section" if first["kind"] == "swept" else "points"
    net = np.array(first[key])
    net[5, ..., 2] += np.linspace(1.0, 7.0, 6) if net.ndim == 3 else 3.0
    net[4, ..., 1] += 2.0
    return {key: net.tolist()}


@pytest.fixture(scope="module")
def followed():
    starts = {name: quintrig.Model.from_dict(keys).to_dict() for name, keys in MODELS.items()}
    jobs = [{"keys": keys, "edited": edit(keys)} for keys in starts.values()]
    return {
        name: (jobs[k]["keys"], *one) for k, (name, one) in enumerate(zip(MODELS, asked(SCRIPT, jobs), strict=True))
    }


@pytest.mark.parametrize("name", MODELS)
def test_the_browser_moves_what_follows_where_python_does(followed, name):
    keys, found, left = followed[name]
    assert [one["second"] for one in left] == (["b:v0"] if name == "ruled" else [])
    # From where the browser left it, and from where it began, Python comes to the same points.
    start = {**keys, "patch": [{**keys["patch"][0], **edit(keys)}, *keys["patch"][1:]]}
    for again in ({**keys, "patch": found["patches"]}, start):
        model = quintrig.Model.from_dict(again)
        for patch in found["patches"][1:]:
            for key in ("points", "section", "trajectory"):
                if key in patch:
                    wanted = getattr(model.patch(patch["name"]).definition, key)
                    assert np.abs(np.subtract(patch[key], wanted)).max() < 1e-9
