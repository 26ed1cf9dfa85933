"""Fairing lowers the energy, keeps what is held and the deviation allowed, and meets the minima that are known."""

import json
from pathlib import Path

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from quintrig.figure.fairness import combs
from quintrig.shaping.derivatives import affine
from quintrig.shaping.energies import ENERGIES, energy, measured

EXAMPLES = Path(__file__).parent.parent / "examples"
KINDS = ("tensor", "symmetric", "swept", "ruled", "car_boot")


def example(name):
    return quintrig.load(EXAMPLES / f"{name}.toml")


@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize("which", ENERGIES)
def test_gradients_are_those_of_differences(name, which):
    of = affine(example(name).patches[0])
    what = energy(which, of)
    direction = np.random.default_rng(3).normal(size=of.values.shape)
    direction *= 1e-4 * np.ptp(of.values) / np.linalg.norm(direction)
    ahead, back = what.value(of.values + direction)[0], what.value(of.values - direction)[0]
    assert what.value(of.values)[1] @ direction == pytest.approx((ahead - back) / 2.0, rel=1e-4)


@pytest.mark.parametrize("name", ["tensor", "symmetric", "swept"])
def test_energies_are_the_integrals(name):
    patch = example(name).patches[0]
    of, known = affine(patch), quintrig.integrals(patch.surface)
    for mine, theirs in (("bending", "bending_energy"), ("thin_plate", "thin_plate_energy")):
        assert energy(mine, of).value(of.values)[0] == pytest.approx(known[theirs].value, rel=1e-6)
        assert measured(patch.surface, mine) == pytest.approx(known[theirs].value, rel=1e-6)
    assert energy("variation", of).value(of.values)[0] == pytest.approx(measured(patch.surface, "variation"), rel=1e-9)


@pytest.mark.parametrize("which", ENERGIES)
@pytest.mark.parametrize(
    ("name", "vary", "within"),
    [("tensor", "net", None), ("symmetric", "net", 0.3), ("swept", "shape", None), ("swept", "both", 0.5)],
)
def test_the_energy_falls_and_what_is_held_stays(name, vary, within, which):
    model = example(name)
    done = quintrig.fair(model, energy=which, vary=vary, within=within)
    assert done.after[which] < done.before[which]
    before, after = model.patches[0].surface, done.model.patches[0].surface
    t = np.linspace(0.0, 1.0, 41)
    apart = np.sqrt(((before(t[:, None], t) - after(t[:, None], t)) ** 2).sum(-1))
    assert apart.max() <= done.deviation * 1.001
    assert within is None or apart.max() <= within
    rim = np.concatenate([apart[0], apart[-1], apart[:, 0], apart[:, -1]])
    assert (rim if vary == "net" else apart[[0, 0, -1, -1], [0, -1, 0, -1]]).max() <= 1e-9 * before.size


def test_a_dented_plane_is_flat_again():
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    z = np.zeros_like(x)
    z[2:4, 2:4] = 0.7
    dented = quintrig.tensor(np.stack([x, y, z], axis=-1), (0.5, 0.5, 0.5, 0.5))
    for which in ENERGIES:
        found = quintrig.fair(dented, energy=which)
        t = np.linspace(0.0, 1.0, 21)
        assert np.abs(found.model.surface(t[:, None], t)[..., 2]).max() < 1e-4
        assert found.after["bending"] < 1e-6


def test_tangents_and_points_are_held_to_their_order():
    model = example("tensor")
    done = quintrig.fair(model, hold=["u0:G2", "u1", "v0", "v1", "0.5,0.5:G1"])
    before, after = model.surface, done.model.surface
    v = np.linspace(0.0, 1.0, 9)
    for order in range(3):
        a, b = before.partials(0.0, v, 2)[order, 0], after.partials(0.0, v, 2)[order, 0]
        np.testing.assert_allclose(a, b, atol=1e-8 * before.size)
    for a, b in ((0, 0), (1, 0), (0, 1)):
        old, new = (one.partials(0.5, 0.5, 1)[a, b] for one in (before, after))
        np.testing.assert_allclose(old, new, atol=1e-9 * before.size)
    assert done.after["thin_plate"] < done.before["thin_plate"]


def test_seams_with_neighbours_keep_their_order():
    x, y = np.meshgrid(np.linspace(0, 1, 6), np.linspace(0, 1, 6), indexing="ij")
    bump = np.random.default_rng(1).normal(size=(6, 6)) * 0.1
    left = {"name": "left", "kind": "tensor", "points": np.stack([x, y, bump], -1).tolist()}
    right = {"name": "right", "kind": "tensor", "points": np.stack([x + 1.0, y, bump[::-1]], -1).tolist()}
    model = quintrig.Model.from_dict({"name": "two", "unit": "m", "patch": [left, right]})
    model = quintrig.join(model, "left:u1", "right:u0", "G2")
    done = quintrig.fair(model, patch="right")
    assert "u0:G2" in done.held
    assert done.model.joins()[0].order in ("G2", "G3")
    assert done.after["thin_plate"] < 0.95 * done.before["thin_plate"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"energy": "bendign"}, r"energy: expected one of .*'bendign'.*bending"),
        ({"vary": "all"}, r"vary: expected net, shape or both"),
        ({"hold": ["w0"]}, r"hold 'w0': expected a side"),
        ({"hold": ["2,0"]}, r"expected u and v from 0 to 1"),
        ({"hold": ["u0:G9"]}, r"hold 'u0:G9'"),
        ({"within": 0.0}, r"within: expected a length greater than 0"),
        ({"hold": ["u0"]}, r"within: expected a largest deviation where not all"),
        ({"hold": ["u0:G3", "u1:G3", "v0", "v1"]}, r"leaves no control point free"),
        ({"hold": ["u0", "u1", "v0", "v1"], "vary": "shape"}, r"leaves no shape parameter free"),
    ],
)
def test_what_cannot_be_is_one_line(options, words):
    with pytest.raises(ValueError, match=words):
        quintrig.fair(example("tensor"), **options)


def test_kinds_without_a_free_net_say_what_can_be_done():
    with pytest.raises(quintrig.ModelError, match=r"tensor-product|shape parameters alone"):
        quintrig.fair(example("swung"))
    with pytest.raises(quintrig.ModelError, match="shape parameters alone"):
        quintrig.fair(example("developable"))
    done = quintrig.fair(example("swung"), vary="shape")
    assert done.after["thin_plate"] <= done.before["thin_plate"]


def test_teeth_of_combs_are_the_curvature_away_from_the_centre():
    points, teeth = combs(quintrig.cylinder(2.0, 5.0))
    long = np.linalg.norm(teeth, axis=-1)
    rulings = np.ptp(points[..., 2], axis=1) > 1.0
    assert np.abs(long[rulings]).max() < 1e-12
    np.testing.assert_allclose(long[~rulings], 0.5, rtol=1e-12)
    np.testing.assert_allclose(teeth[~rulings][..., :2], 0.25 * points[~rulings][..., :2], rtol=0, atol=1e-12)


def test_the_command_writes_model_json_and_picture(tmp_path):
    out, picture = tmp_path / "fairer.toml", tmp_path / "both.png"
    done = run("fair", EXAMPLES / "tensor.toml", "-o", out, "--energy", "thin-plate", "--json", "--picture", picture)
    assert done.code == 0, done.err
    said = json.loads(done.out)
    assert said["after"]["thin_plate"] < said["before"]["thin_plate"]
    assert measured(quintrig.load(out).surface, "thin_plate") == pytest.approx(said["after"]["thin_plate"])
    assert picture.read_bytes()[:4] == b"\x89PNG"
    again = run("fair", EXAMPLES / "tensor.toml", "-o", out)
    assert again.code == 2
    assert "--force" in again.err
    same = run("fair", out, "-o", out, "--vary", "shape")
    assert same.code == 2
    assert "read here" in same.err
    assert "--force" in same.err
    assert run("fair", out, "-o", out, "--vary", "shape", "--force").code == 0
    shown = run("fair", EXAMPLES / "tensor.toml", "--vary", "shape")
    assert "thin-plate" in shown.out
