"""Strips between curves of known developables are developable, whatever the pace of the curves; the rest is told."""

import json

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as run

BASE = np.array([[0, 0, 0], [1, 2, 0], [3, 3, 0.5], [5, 2, 0.5], [7, 1, 0], [8, 0, 0]], dtype=float)


def cone(points, apex, share):
    return apex + share * (points - apex)


def test_a_cone_between_a_curve_and_its_image_is_exact():
    first, second = quintrig.Curve(BASE), quintrig.Curve(cone(BASE, np.array([3.0, 1.0, 9.0]), 0.4))
    found = quintrig.strip(first, second, "m")
    assert found.twist < 1e-6
    assert found.deviation == 0.0
    np.testing.assert_allclose(found.t, found.s)
    assert quintrig.unroll(found.surface).isometry.worst < 1e-9


@pytest.mark.parametrize("turned", [False, True])
def test_rulings_are_found_where_the_curves_run_at_other_paces(turned):
    """The second curve is the first one moved, at another pace: a cylinder, whose rulings are all parallel."""
    shift = np.array([0.5, 1.0, 6.0])
    first = quintrig.Curve(BASE, basis="bernstein")
    t = np.linspace(0, 1, 400)
    pace = t + 0.6 * t * (1 - t)
    points = first(pace) + shift
    f = quintrig.Curve(np.zeros((11, 3)), basis="bernstein").functions.derivatives(t, 0)[0]
    net = np.linalg.lstsq(f, points, rcond=None)[0]
    second = quintrig.Curve(net[::-1] if turned else net, basis="bernstein")
    found = quintrig.strip(first, second)
    assert found.twist < 0.05
    assert found.deviation < 1e-5
    lines = found.surface(found.s, np.ones_like(found.s)) - found.surface(found.s, np.zeros_like(found.s))
    np.testing.assert_allclose(lines / np.linalg.norm(lines, axis=1)[:, None],
                               np.tile(shift / np.linalg.norm(shift), (257, 1)), atol=2e-3)  # fmt: skip


def test_what_is_no_developable_is_told_and_is_better_than_equal_parameters():
    other = BASE * [1, 0.2, 1] + [1, 0, 4]
    first, second = quintrig.Curve(BASE), quintrig.Curve(other)
    found = quintrig.strip(first, second)
    plain = quintrig.Model.from_dict({"kind": "ruled", "first": BASE.tolist(), "second": other.tolist()})
    u, v = np.linspace(0, 1, 65)[:, None], np.array([0.0, 1.0])

    def twist(surface):
        p = surface.partials(u, v, 1)
        n = np.cross(p[1, 0], p[0, 1])
        n /= np.linalg.norm(n, axis=-1, keepdims=True)
        return np.degrees(np.arccos(np.clip((n[:, 0] * n[:, 1]).sum(-1), -1, 1)))

    assert np.sqrt((twist(found.surface) ** 2).mean()) < np.sqrt((twist(plain.surface) ** 2).mean())
    assert twist(found.surface).max() == pytest.approx(found.twist, rel=0.05)


def test_curves_in_the_plane_and_curves_that_meet_are_refused():
    with pytest.raises(ValueError, match="first: expected a curve in space"):
        quintrig.strip(quintrig.Curve(BASE[:, :2]), quintrig.Curve(BASE))
    with pytest.raises(ValueError, match="the curves meet"):
        quintrig.strip(quintrig.Curve(BASE), quintrig.Curve(BASE * [1, 2, 1]))


def test_the_command_writes_a_ruled_patch(tmp_path):
    model = quintrig.Model.of_curves([quintrig.Curve(BASE), quintrig.Curve(BASE + np.array([0, 1, 5]))], unit="m")
    quintrig.save(model, tmp_path / "rails.toml")
    done = run("strip", tmp_path / "rails.toml", "-o", tmp_path / "strip.toml", "--json")
    assert done.code == 0, done.err
    said = json.loads(done.out)
    assert said["twist"] < 1e-6
    assert said["unit"] == "m"
    assert quintrig.load(tmp_path / "strip.toml").patches[0].kind == "ruled"
    assert "twist" in run("strip", tmp_path / "rails.toml").out
    wrong = run("strip", tmp_path / "strip.toml")
    assert wrong.code == 2
    assert len(wrong.err.strip().splitlines()) == 1
