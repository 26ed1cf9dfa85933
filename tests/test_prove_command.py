"""``quintrig prove`` and what else tells of proofs: claims read and refused, JSON, check, report, sweeps."""

import json

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as cli
from quintrig.analysis.certified import certify, ranges
from quintrig.enclosures.claims import read
from quintrig.sweep import Axis, DesignSpace, open_sweep, prove_rows
from quintrig.sweep.part import Task

SPHERE = {"schema": 1, "name": "ball", "unit": "mm", "kind": "sphere", "radius": 20.0}


@pytest.fixture
def ball(tmp_path):
    path = tmp_path / "ball.json"
    path.write_text(json.dumps(SPHERE))
    return path


@pytest.mark.parametrize("claim", ["-0.1 <= mean <= 0.1", "-.1 < mean", "-1 <= gaussian"])
def test_a_claim_may_begin_with_a_negative_number(claim, ball):
    done = cli("prove", ball, claim, "--json")
    assert done.code == 0, done.err
    found = json.loads(done.out)
    assert (found["verdict"], found["claim"]) == ("proved", claim)


def test_one_claim_is_one_object_and_several_are_a_list(ball):
    done = cli("prove", ball, "gaussian > 0", "--json")
    assert done.code == 0
    found = json.loads(done.out)
    assert {"verdict", "claim", "boxes", "witness", "bounds"} <= set(found)
    assert (found["verdict"], found["claim"], found["witness"]) == ("proved", "gaussian > 0", None)
    assert found["boxes"] >= 1
    assert found["bounds"] == pytest.approx([1 / 400, 1 / 400], rel=1e-9)
    several = json.loads(cli("prove", ball, "regular", "mean > 0", "--json").out)
    assert [one["verdict"] for one in several] == ["proved", "refuted"]
    witness = several[1]["witness"]
    assert witness["value"] == pytest.approx(-1 / 20)
    assert np.linalg.norm(witness["point"]) == pytest.approx(20.0)
    assert witness["patch"] == "ball"


def test_strict_fails_where_a_claim_is_not_proved(ball):
    assert cli("prove", ball, "gaussian > 0", "--strict").code == 0
    assert cli("prove", ball, "gaussian < 0", "--strict").code == 1
    assert cli("prove", ball, "gaussian < 0").code == 0


def test_the_text_names_the_place_and_the_unit(ball):
    text = cli("prove", ball, "curvature_radius >= 30").out
    assert "refuted" in text
    assert "fails" in text
    assert "20 mm" in text


@pytest.mark.parametrize(
    ("claim", "low", "high"),
    [
        ("curvature_radius >= 3 cm", 30.0, np.inf),
        ("30 <= curvature_radius", 30.0, np.inf),
        ("radius ≥ 1 in", 25.4, np.inf),
        ("mean in [-1/mm, 0.5 1/mm]", -1.0, 0.5),
        ("-1 1/cm <= mean <= 2 1/cm", -0.1, 0.2),
        ("gaussian < 1 1/cm²", -np.inf, 0.01),
        ("K < 1 /cm^2", -np.inf, 0.01),
        ("0 > k2", -np.inf, 0.0),
        ("slope <= 1 rad", -np.inf, 180.0 / np.pi),
        ("draft >= 3° along x", 3.0, np.inf),
        ("gaussian in [0, 2]", 0.0, 2.0),
        ("draft in [-5, 5] deg along -z", -5.0, 5.0),
        ("curvature radius in [3, 4] cm", 30.0, 40.0),
    ],
)
def test_claims_are_read_in_their_own_unit(claim, low, high):
    found = read(claim, "mm")
    assert (found.range.low, found.range.high) == pytest.approx((low, high))


@pytest.mark.parametrize(
    ("claim", "said"),
    [
        ("gausian > 0", "did you mean 'gaussian'"),
        ("regulr", "did you mean 'regular'"),
        ("beta0 > 0", "beta0 has no proof; these have: gaussian"),
        ("slope <= 30", "expected a unit, as in '30 deg'"),
        ("curvature_radius >= 30 deg", "expected a length such as mm"),
        ("gaussian > 1 mm", "expected 1/mm²"),
        ("slope <= 30 mm", "expected deg or rad"),
        ("gaussian == 0", "expected >, >=, < or <="),
        ("gaussian >", "expected a number"),
        ("0 < gaussian > 1", "expected a range such as"),
        ("1 <= gaussian <= 0", "with some value in it"),
        ("draft >= 1 deg along up", "expected a direction"),
        ("gaussian > 0 along x", "slope and draft are along a direction, gaussian is not"),
        ("no fold along x", "no fold is a claim by itself"),
        ("> 0", "expected a quantity to compare, found none"),
        ("", "expected one such as"),
        ("x" * 300, "expected one such as"),
    ],
)
def test_a_claim_that_cannot_be_read_is_one_line(ball, claim, said):
    done = cli("prove", ball, claim)
    assert done.code == 2
    assert said in done.err
    assert len(done.err.strip().splitlines()) == 1
    assert done.out == ""


def test_a_model_without_a_unit_takes_plain_numbers_alone():
    assert read("curvature_radius >= 30").range.low == 30.0
    with pytest.raises(ValueError, match="states no unit"):
        read("curvature_radius >= 30 mm")


def test_a_model_of_several_patches_fails_where_one_does():
    model = quintrig.Model.from_dict(
        {
            "schema": 1,
            "name": "two",
            "patch": [
                {"kind": "sphere", "name": "ball", "radius": 1.0},
                {"kind": "torus", "name": "ring", "major": 3.0, "minor": 1.0},
            ],
        }
    )
    verdict = quintrig.prove(model, "gaussian >= 0")
    assert verdict.verdict == "refuted"
    assert verdict.witness.patch == "ring"
    assert quintrig.prove(model, "curvature_radius >= 0.99").proved
    found = quintrig.bounds(model, "gaussian")
    assert found.minimum[0] <= -0.5
    assert found.maximum[1] >= 1.0


def test_check_says_what_is_proved(ball):
    text = cli("check", "--prove", ball).out
    assert "K > 0 on the whole patch, proved" in text
    assert "regular on the whole patch, proved" in text
    assert "radius of curvature at least 19." in text
    assert "whole patch" not in cli("check", ball).out


@pytest.mark.parametrize(
    ("surface", "sentence"),
    [
        (quintrig.ellipsoid(3.0, 2.0, 1.0), "K > 0 on the whole patch, proved"),
        (quintrig.hyperbolic_paraboloid(1.0), "K < 0 on the whole patch, proved"),
        (quintrig.monkey_saddle(1.0), "K <= 0 on the whole patch, proved"),
        (quintrig.cylinder(1.0, 2.0), "K = 0 on the whole patch, proved"),
    ],
)
def test_sentences_are_as_strong_as_what_is_proved(surface, sentence):
    assert sentence in certify(surface).sentences


def test_a_surface_without_a_proof_says_why():
    found = certify(quintrig.catenoid(1.0, 2.0))
    assert found.sentences == ()
    assert "can only be sampled" in found.reason
    assert ranges(found) == []


def test_extremes_come_with_certified_bounds_where_they_are_asked_for():
    torus = quintrig.torus(3.0, 1.0)
    (found,) = quintrig.find_extremes(torus, ("gaussian",), certified=True).values()
    assert found.certified.minimum[0] <= found.minimum.value <= found.certified.minimum[1] + 1e-12
    assert found.certified.maximum[0] - 1e-12 <= found.maximum.value <= found.certified.maximum[1]
    (plain,) = quintrig.find_extremes(torus, ("gaussian",)).values()
    assert plain.certified is None


def test_designs_of_a_sweep_are_proved(tmp_path):
    model = quintrig.load("examples/wavy.toml").to_dict()
    space = DesignSpace((Axis("alpha1", -1.0, 1.0, 2),))
    sweep = open_sweep(tmp_path / "sweep", Task(model, None, space, 8))
    rows = {"alpha1": np.array([-1.0, 1.0])}
    found = prove_rows(sweep, rows, ("regular", "gaussian >= 0"))
    assert [[one.verdict for one in verdicts] for verdicts in found] == [["proved", "refuted"]] * 2
    with pytest.raises(ValueError, match="did you mean"):
        prove_rows(sweep, rows, ("gausian >= 0",))
