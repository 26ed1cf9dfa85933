"""``[[join]]``: sides that follow others, at load and afterwards; circles and contradictions refused by name."""

import json
from dataclasses import replace

import jsonschema
import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from quintrig.model.save import merged, to_json
from quintrig.model.schema import json_schema
from quintrig.model.toml import to_toml
from quintrig.support.parsing import parse


def net(i, j, seed):
    x, y = np.meshgrid(100 * i + 20.0 * np.arange(6), 100 * j + 20.0 * np.arange(6), indexing="ij")
    return np.stack([x, y, 10 * np.random.default_rng(seed).normal(size=(6, 6))], axis=-1).tolist()


def patch(name, i, j=0, shape=(0.2, -0.5, 0.3, -1.0)):
    return {"name": name, "kind": "tensor", "points": net(i, j, ord(name[0])), "shape": list(shape)}


def keys(*joins, names="abc"):
    patches = [patch(name, k) for k, name in enumerate(names)]
    return {
        "unit": "mm",
        "patch": patches,
        "join": [dict(zip(("first", "second", "order"), one, strict=False)) for one in joins],
    }


def orders(model):
    return {f"{one.first} {one.second}": one.order for one in model.joins()}


CHAIN = (("b:u1", "c:u0", "G3"), ("a:u1", "b:u0", "G2"))


def test_a_chain_is_followed_from_its_head():
    model = quintrig.Model.from_dict(keys(*CHAIN))
    assert orders(model) == {"a:u1 b:u0": "G2", "b:u1 c:u0": "G3"}
    np.testing.assert_array_equal(model.patch("a").surface.net, net(0, 0, ord("a")))


def test_a_change_carries_what_follows_along():
    model = quintrig.Model.from_dict(keys(*CHAIN))
    head = model.patch("a").with_parameters({"zeta1": 0.9})
    after = model.with_patch(head)
    assert orders(after) == orders(model)
    moved = np.abs(after.patch("b").surface.net - model.patch("b").surface.net).max(axis=(1, 2)) > 1e-6
    # ζ changes the end speed alone, and what it adds to the second row is along P5 - P4, which μ takes up.
    assert moved.tolist() == [False, True, False, False, False, False]
    torn = replace(model, patches=(head, *model.patches[1:]))
    assert torn.joins()[0].order != "G2"
    assert orders(model.with_shape((0.5, -1, 0.1, 0.4))) == orders(model)


def test_what_is_written_is_read_back_the_same(tmp_path):
    model = quintrig.Model.from_dict(keys(*CHAIN))
    again = quintrig.Model.from_dict(model.to_dict())
    assert again.to_dict() == model.to_dict()
    for text, suffix in ((to_toml(model.to_dict()), ".toml"), (merged("", model), ".toml"), (to_json(model), ".json")):
        assert quintrig.Model.from_dict(parse(text, suffix)).to_dict() == model.to_dict()
    jsonschema.validate(model.to_dict(), json_schema())


def test_a_patch_between_two_follows_both():
    model = quintrig.Model.from_dict(keys(("a:u1", "b:u0", "G2"), ("c:u0", "b:u1", "G2")))
    assert orders(model) == {"a:u1 b:u0": "G2", "b:u1 c:u0": "G2"}


def four(order):
    patches = [patch(name, i, j) for name, i, j in (("a", 0, 0), ("b", 1, 0), ("c", 0, 1), ("d", 1, 1))]
    joins = [("a:u1", "b:u0"), ("a:v1", "c:v0"), ("b:v1", "d:v0"), ("c:u1", "d:u0")]
    return {"patch": patches, "join": [{"first": one, "second": two, "order": order} for one, two in joins]}


@pytest.mark.parametrize("order", ["G0", "G1"])
def test_four_patches_meet_at_a_corner_with_equal_ratios(order):
    model = quintrig.Model.from_dict(four(order))
    assert set(orders(model).values()) == {order}
    assert len(orders(model)) == 4


def test_unequal_ratios_at_a_corner_contradict_each_other():
    data = four("G1")
    data["join"][3]["ratio"] = 2.0
    with pytest.raises(ValueError, match=r"d:v0 to b:v1 \(G1\) and d:u0 to c:u1 \(G1\) contradict each other"):
        quintrig.Model.from_dict(data)


@pytest.mark.parametrize(
    ("joins", "message"),
    [
        ([("a:u1", "b:u0"), ("b:u1", "c:u0"), ("c:u1", "a:u0")], r"run in a circle \(.*a:u1 leads b:u0"),
        ([("a:u1", "b:u0"), ("c:u0", "b:u0")], "b:u0 is held to a:u1 and to c:u0"),
        ([("a:u1", "a:u0")], "sides of two patches"),
        ([("a:u1", "x:u0")], "no patch 'x'"),
        ([("a:u1", "b")], 'expected "PATCH:SIDE"'),
        ([("a:u1", "b:u0", "G4")], "order: expected one of"),
    ],
)
def test_joins_that_cannot_hold_are_refused_by_name(joins, message):
    with pytest.raises(quintrig.ModelError, match=message):
        quintrig.Model.from_dict(keys(*joins))


@pytest.mark.parametrize("ratio", [0, -1, True, "1", float("inf")])
def test_ratios_must_be_above_zero(ratio):
    data = keys(("a:u1", "b:u0"))
    data["join"][0]["ratio"] = ratio
    with pytest.raises(quintrig.ModelError, match="ratio: expected a finite number greater than 0"):
        quintrig.Model.from_dict(data)


def test_joins_need_patches_and_a_list_of_tables():
    one = {"kind": "sphere", "join": [{"first": "a:u1", "second": "b:u0"}]}
    with pytest.raises(quintrig.ModelError, match="no patch 'a'"):
        quintrig.Model.from_dict(one)
    with pytest.raises(quintrig.ModelError, match=r"expected one or more \[\[join\]\] tables"):
        quintrig.Model.from_dict({**keys(), "join": []})


def test_the_command_keeps_a_join_on_request(tmp_path):
    path, out = tmp_path / "m.json", tmp_path / "held.toml"
    data = keys()
    del data["join"]
    path.write_text(json.dumps(data))
    assert run("join", path, "a:u1", "b:u0", "--order", "G2", "--hold", "-o", out).code == 0
    model = quintrig.load(out)
    (rule,) = model.held
    assert (rule.first, rule.second, rule.order) == ("a:u1", "b:u0", "G2")
    moved = model.with_patch(model.patch("a").with_parameters({"zeta1": -2.0}))
    assert moved.joins()[0].order == "G2"


def test_a_join_that_a_kind_cannot_keep_is_told():
    lead = {"name": "lead", "kind": "tensor", "points": [[[20 * i, 20 * j, i * j] for j in range(6)] for i in range(6)]}
    own = {"name": "own", "kind": "swept", "section": [[100 + 20 * i, 0, i * i] for i in range(6)]}
    own["trajectory"] = [[0, 20 * j, j * (5 - j)] for j in range(6)]
    table = {"first": "lead:u1", "second": "own:u0", "order": "G1"}
    (line,) = quintrig.Model.from_dict({"patch": [lead, own], "join": [table]}).joins().warnings
    assert line.startswith("own:u0 is held to lead:u1 to G1 and reaches G0")
