"""Fairing a curve lowers the energy, keeps what is held and allowed, and finds the curves that are known."""

import json

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run
from quintrig.shaping.energies import ENERGIES, nodes
from quintrig.shaping.fair_curve import _bending

POINTS = [[0, 0], [10, 40], [40, 50], [60, -10], [90, 0], [100, 30]]


def model(points=POINTS, **keys):
    return quintrig.Model.from_dict({"kind": "curve", "unit": "mm", "points": points, "name": "c"} | keys)


@pytest.mark.parametrize("energy", ENERGIES)
@pytest.mark.parametrize("within", [None, 0.5])
def test_the_energy_falls_and_the_ends_stay(energy, within):
    given = model(shape=[0.5, -1.0])
    done = quintrig.fair_curve(given, energy=energy, within=within)
    assert done.after[energy] < done.before[energy]
    first, second = (one.curves[0].curve.derivatives(np.array([0.0, 1.0]), 1) for one in (given, done.model))
    np.testing.assert_allclose(first, second, atol=1e-9)
    t = np.linspace(0, 1, 401)
    apart = np.linalg.norm(given.curves[0].curve(t) - done.model.curves[0].curve(t), axis=1).max()
    assert apart == pytest.approx(done.deviation, rel=1e-3)
    assert within is None or apart <= within
    assert done.before["bending"] == pytest.approx(given.curves[0].curve.bending_energy(), rel=1e-6)


@pytest.mark.parametrize("energy", ["bending", "thin_plate"])
def test_between_two_points_it_is_the_straight_line(energy):
    done = quintrig.fair_curve(model([[0, 0, 0], [2, 1, 1], [4, 0, -1], [6, 1, 0], [8, -1, 1], [10, 5, 0]]),
                               hold=["0", "1"], energy=energy)  # fmt: skip
    points = done.model.curves[0].curve(np.linspace(0, 1, 33))
    across = np.cross(points, np.array([10, 5, 0]) / np.hypot(10, 5))
    assert np.linalg.norm(across, axis=1).max() < 0.02


def test_the_gradient_of_bending_is_that_of_differences():
    family = model().curves[0].curve.functions
    t, weights = nodes(family.breaks, 32)
    f, points = family.derivatives(t, 3), np.array(POINTS, dtype=float)
    way = np.random.default_rng(4).normal(size=points.shape)
    ahead, back = (_bending(points + sign * 1e-4 * way, f, weights)[0] for sign in (1, -1))
    assert (_bending(points, f, weights)[1] * way).sum() == pytest.approx((ahead - back) / 2e-4, rel=1e-6)


def test_a_closed_curve_stays_closed():
    done = quintrig.fair_curve(model([[0, 0], [10, 0], [12, 9], [5, 8], [-3, 9]], close=True), hold=["0"], within=1.0)
    assert done.model.curves[0].curve.closed
    assert done.after["thin_plate"] < done.before["thin_plate"]


@pytest.mark.parametrize(
    ("options", "words"),
    [({"hold": ["2"]}, "parameter from 0 to 1"), ({"hold": ["0:G3", "1:G3"]}, "leaves no control point free"),
     ({"energy": "bend"}, "expected one of"), ({"within": -1.0}, "within"), ({"curve": "x"}, "no curve 'x'")],
)  # fmt: skip
def test_what_cannot_be_is_one_line(options, words):
    with pytest.raises(ValueError, match=words):
        quintrig.fair_curve(model(), **options)


def test_the_command_takes_a_model_of_curves(tmp_path):
    quintrig.save(model(), tmp_path / "c.toml")
    done = run("fair", tmp_path / "c.toml", "-o", tmp_path / "d.toml", "--energy", "bending", "--within", "2", "--json")
    assert done.code == 0, done.err
    said = json.loads(done.out)
    assert said["after"]["bending"] < said["before"]["bending"]
    assert quintrig.load(tmp_path / "d.toml").curves[0].curve.bending_energy() == pytest.approx(
        said["after"]["bending"], rel=1e-6)  # fmt: skip
    assert "1/mm" in run("fair", tmp_path / "c.toml").out
