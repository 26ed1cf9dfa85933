"""Joins against closed forms, and patches joined at random, measured from points alone."""

import json

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from measured import seam
from quintrig.model.kinds.registry import kinds
from test_join import model, net, tensor

ARC = [[20.0, 0.0], [20.0, 10.0], [10.0, 20.0], [0.0, 20.0]]


def test_parts_of_a_sphere_join_to_third_order():
    octant = {"kind": "swung", "profile": ARC, "trajectory": [[1, 0], [1, 0.5], [0.5, 1], [0, 1]], "basis": "cubic"}
    eighth = quintrig.Model.from_dict({"unit": "mm", "name": "o", **octant})
    points = eighth.surface(*np.random.default_rng(0).random((2, 40)))
    np.testing.assert_allclose(np.linalg.norm(points, axis=-1), 20.0, rtol=1e-12)
    half = quintrig.mirror(quintrig.mirror(eighth, "x=0", "G2"), "z=0", "G2")
    found = half.joins()
    assert [one.order for one in found] == ["G3"] * 4
    for one in found:
        assert one.first_curvature.least == pytest.approx(one.second_curvature.most, rel=1e-9)
        assert abs(one.first_curvature.least) == pytest.approx(1 / 20, rel=1e-9)


def test_a_torus_meets_itself_all_round():
    found = quintrig.Model.from_dict({"name": "t", **kinds()["torus"].starter, "kind": "torus"}).joins()
    assert sorted(f"{one.first} {one.second}" for one in found) == ["t:u0 t:u1", "t:v0 t:v1"]
    assert {one.order for one in found} == {"G3"}
    assert found.free == ()


@pytest.mark.parametrize("order", ["G0", "G1", "G2", "G3"])
def test_random_pairs_are_joined_to_the_order_asked_for(order):
    for seed in range(2):
        rng = np.random.default_rng(seed)
        along = rng.uniform(-3, 1, 2).tolist()
        shapes = [[*rng.uniform(-3, 1, 2).tolist(), *along] for _ in range(2)]
        pair = model(
            tensor("a", net(0.0, 10 + seed), shapes[0]),
            tensor("b", net(100.0, 20 + seed) + rng.normal(size=3), shapes[1]),
        )
        after = quintrig.join(pair, "a:u1", "b:u0", order, both=seed == 1)
        gap, angle, jump = seam((after.patch("a").surface, "u1"), (after.patch("b").surface, "u0"))
        assert gap < 1e-10
        assert order == "G0" or angle < 1e-6
        assert order in ("G0", "G1") or jump < 1e-7  # what differences of points leave


def test_names_may_hold_colons(tmp_path):
    pair = model(tensor("a:u1", net(0.0, 1)), tensor("b: rear", net(100.0, 2)))
    after = quintrig.join(pair, "a:u1:u1", "b: rear:u0", "G1", hold=True)
    quintrig.save(after, tmp_path / "pair.toml")
    (found,) = json.loads(run("joins", tmp_path / "pair.toml", "--json").out)["joins"]
    assert (found["first"]["patch"], found["first"]["side"], found["order"]) == ("a:u1", "u1", "G1")
    longer = quintrig.extend(after, "b: rear:u1", 10)
    assert [one.name for one in longer.patches] == ["a:u1", "b: rear", "extension"]


@pytest.mark.parametrize("value", [0, -1, float("nan")])
@pytest.mark.parametrize("name", ["tolerance", "angle", "curvature"])
def test_limits_must_be_above_zero(name, value):
    with pytest.raises(ValueError, match=f"{name}: expected a finite number greater than 0"):
        model(tensor("a", net(0.0, 1)), tensor("b", net(100.0, 2))).joins(**{name: value})
