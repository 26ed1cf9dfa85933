"""The live studio's server moves what a [[join]] holds when a model is saved: seen without a browser."""

import quintrig
from quintrig.model.save import merged
from quintrig.model.toml import to_toml
from quintrig.support.parsing import parse


def strip(name, x, lift):
    points = [[[x + 20 * i, 20 * j, lift * i * j] for j in range(6)] for i in range(6)]
    return {"name": name, "kind": "tensor", "points": points}


def test_an_edit_of_the_first_patch_carries_the_second_along():
    keys = {"patch": [strip("a", 0, 0.1), strip("b", 100, 0.3)]}
    keys["join"] = [{"first": "a:u1", "second": "b:u0", "order": "G1"}]
    sent = quintrig.Model.from_dict(keys).to_dict()
    sent["patch"][0]["points"][5][3][2] += 7.0  # what the studio sends: the first patch edited, the second as it was
    saved = quintrig.Model.from_dict(parse(to_toml(sent), ".toml"))
    assert saved.joins()[0].order != "open"
    assert saved.joins()[0].angle.most < 1e-6
    again = quintrig.Model.from_dict(parse(merged("", saved), ".toml"))
    assert again.held == saved.held
