"""The seams that the studio measures in the browser against Python's ``Model.joins``: in Node, on the bundle."""

from pathlib import Path

import pytest

import quintrig
from node import asked

SCRIPT = """
import { readFileSync } from "node:fs";
const studio = await import(process.argv[1]);
const jobs = JSON.parse(readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(jobs.map((keys) => studio.seams(studio.fromDict(keys)))));
"""
EXAMPLES = Path(__file__).parents[1] / "examples"


def net(x, lift):
    return [[[x + 20.0 * i, 20.0 * j, lift * i * j] for j in range(6)] for i in range(6)]


def pair(lift, order=None, *, turned=False):
    keys = {"unit": "mm", "patch": [{"name": "a", "kind": "tensor", "points": net(0, 0.1)}]}
    second = [row[::-1] for row in net(100, lift)] if turned else net(100, lift)
    keys["patch"].append({"name": "b", "kind": "tensor", "points": second})
    if order:
        keys["join"] = [{"first": "a:u1", "second": "b:u0", "order": order}]
    return quintrig.Model.from_dict(keys)


def flat(name, x, y, wide, high):
    """A plane patch from (x, y), with its sides v along y."""
    points = [[[x + wide * i / 5, y + high * j / 5, 0.0] for j in range(6)] for i in range(6)]
    return {"name": name, "kind": "tensor", "points": points}


MODELS = {
    "open": pair(0.3),
    "G0": pair(0.3, "G0"),
    "G1": pair(0.3, "G1"),
    "G2": pair(0.3, "G2"),
    "G3": pair(0.3, "G3"),
    "reversed": pair(0.3, "G1", turned=True),
    "torus": quintrig.Model.from_dict({"kind": "torus"}),
    "T-junction": quintrig.Model.from_dict(
        {"unit": "mm", "patch": [flat("a", -60, 0, 60, 90), flat("b", 0, 0, 40, 35), flat("c", 0, 90, 40, -55)]}
    ),
    "a third beside two": quintrig.Model.from_dict(
        {"unit": "mm", "patch": [flat("a", -60, 0, 60, 90), flat("b", 0, 0, 40, 90), flat("c", 0.4, 0, -50, 90)]}
    ),
    "capped": quintrig.cap(quintrig.Model.from_dict({"kind": "cylinder", "name": "tube"}), "tube:u1"),
    "partial": quintrig.Model.from_dict({"unit": "mm", "patch": [flat("a", -60, 0, 60, 90), flat("b", 0, 30, 40, 90)]}),
    "body": quintrig.load(EXAMPLES / "body.toml"),
}


@pytest.fixture(scope="module")
def seams():
    jobs = [model.to_dict() for model in MODELS.values()]
    return dict(zip(MODELS, asked(SCRIPT, jobs), strict=True))


@pytest.mark.parametrize("name", MODELS)
def test_the_browser_finds_and_orders_the_seams_as_python_does(seams, name):
    model = MODELS[name]
    names = [patch.name for patch in model.patches]

    def ends(seam):
        return frozenset((names[seam[k]["patch"]], seam[k]["side"]) for k in ("first", "second"))

    found = {ends(seam): seam for seam in seams[name]}
    wanted = {frozenset({(j.first.patch, j.first.side), (j.second.patch, j.second.side)}): j for j in model.joins()}
    assert found.keys() == wanted.keys()
    for key, join in wanted.items():
        seam = found[key]
        assert (seam["order"], seam["reversed"]) == (join.order, join.reversed)
        first, second = (
            (seam["first"], seam["second"])
            if names[seam["first"]["patch"]] == join.first.patch and seam["first"]["side"] == join.first.side
            else (seam["second"], seam["first"])
        )
        for end, wanted_end in ((first, join.first), (second, join.second)):
            assert (end["from"], end["to"]) == pytest.approx((wanted_end.start, wanted_end.stop), abs=1e-6)
        # Python samples an edge at more points: largest values between two of the browser's differ a little.
        assert seam["gap"] == pytest.approx(join.gap.most, rel=0.02, abs=1e-9)
        assert seam["angle"] == pytest.approx(join.angle.most, rel=0.02, abs=1e-6)
        assert seam["curvature"] == pytest.approx(join.curvature.most, rel=0.02, abs=5e-4)
