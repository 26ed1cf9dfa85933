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


def laid(f, pace=0.0):
    """A Bernstein curve that is nearly f(t) run at another pace."""
    t = np.linspace(0, 1, 200)
    matrix = quintrig.Curve(np.zeros((16, 3)), basis="bernstein").functions.derivatives(t, 0)[0]
    return quintrig.Curve(np.linalg.lstsq(matrix, f(t + pace * t * (1 - t)), rcond=None)[0], basis="bernstein")


def arc(radius, z, pace=0.0, start=0.0, span=1.5):
    def f(t):
        angle = start + span * t
        return np.stack([radius * np.cos(angle), radius * np.sin(angle), 0 * t + z], axis=-1)

    return laid(f, pace)


def tangents(length, pace=0.0):
    """A curve on the developable of tangents of a helix."""

    def f(t):
        a = 0.3 + 1.5 * t
        c, d = [np.cos(a), np.sin(a), a / 2], [-np.sin(a), np.cos(a), 0.5 + 0 * a]
        return np.stack(c, axis=-1) + length * np.stack(d, axis=-1)

    return laid(f, pace)


ROWS = {
    "cylinder": [arc(3, 0), arc(3, 2, 0.3), arc(3, 3, -0.3)],
    "cone": [arc(4, 0), arc(3, 2, 0.4), arc(2, 4, -0.3)],
    "tangents": [tangents(1), tangents(2, 0.3), tangents(3.5, -0.2)],
}


def stretches(points, arcs):
    """Distances between points of a curve in the plane at shares of its arc length, which motions keep."""
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    places = np.stack([np.interp(arcs * length[-1], length, points[:, k]) for k in (0, 1)], axis=-1)
    return np.linalg.norm(places[:, None] - places, axis=-1)


@pytest.mark.parametrize("name", ROWS)
def test_one_developable_in_strips_and_pieces_is_smooth_and_its_patterns_fit(name):
    row = quintrig.strips(ROWS[name], pieces=2)
    assert [seam.along for seam in row.seams] == [None, None, "rail 2"]
    assert max(seam.angle for seam in row.seams[:2]) < 1e-10
    assert row.seams[2].angle < 1e-3
    assert row.seams[2].missed < 1e-6
    assert all(seam.continuity == "G1" for seam in row.seams)
    assert row.notes == ()
    assert max(part.twist for part in row.strips) < 1e-4
    assert all(join.order != "G0" for join in row.model.joins().joins)
    flat = [quintrig.unroll(patch.surface, allowed=1e-6) for patch in row.model.patches]
    arcs = np.linspace(0, 1, 7)
    for below, above in ((0, 2), (1, 3)):  # across the rail, bent the same way in the plane
        np.testing.assert_allclose(stretches(flat[below].second, arcs), stretches(flat[above].first, arcs), atol=1e-4)
    for left, right in ((0, 1), (2, 3)):  # along a ruling
        ends = [flat[left].second[-1] - flat[left].first[-1], flat[right].second[0] - flat[right].first[0]]
        assert np.linalg.norm(ends[0]) == pytest.approx(np.linalg.norm(ends[1]), rel=1e-9)


def test_strips_on_a_sphere_meet_at_the_angle_of_their_cones():
    """Between circles of latitude lie cones, whose slopes differ by half of what the outer latitudes do."""
    latitudes = np.radians([0, 30, 55])
    rings = 5 * np.stack([np.cos(latitudes), np.sin(latitudes)], axis=-1)
    rails = [arc(*ring, pace) for ring, pace in zip(rings, (0, 0.4, -0.3), strict=True)]
    row = quintrig.strips(rails, unit="m")
    assert row.angle == pytest.approx(27.5, abs=1e-4)
    assert row.seams[0].continuity == "G0"
    along = (rings[1] - rings[0]) / np.linalg.norm(rings[1] - rings[0])
    missed = abs(along[0] * (rings[2] - rings[0])[1] - along[1] * (rings[2] - rings[0])[0])
    assert row.seams[0].missed == pytest.approx(missed, rel=1e-6)
    assert row.notes[0].startswith("no smooth seam along rail 2")
    smooth = quintrig.strips(rails, join="G1", unit="m")
    assert smooth.angle < 1e-3
    assert [part.deviation for part in smooth.strips] == [pytest.approx(0, abs=1e-5), pytest.approx(missed, rel=1e-6)]
    assert max(part.twist for part in smooth.strips) < 1e-3
    assert f"misses rail 3 by {missed:.3g} m" in smooth.notes[0]
    with pytest.raises(ValueError, match="do not come near rail 3 when continued"):
        quintrig.strips([rails[0], rails[1], arc(2, -9)], join="G1")


def test_rails_of_several_curves_are_cut_where_they_meet_and_corners_are_told():
    parts = [arc(3, 0, 0.2, 0, 0.9), arc(3, 0, 0.1, 1.5, -0.6)]  # the second runs back
    row = quintrig.strips([parts, arc(3, 2, 0.3)])
    assert len(row.model.patches) == 2
    assert row.seams[0].angle < 1e-6
    assert row.strips[0].twist < 1e-3
    bent = [
        quintrig.Curve(x + np.linspace(0, 1, 6)[:, None] * d)
        for x, d in (([0, 0, 0], [4, 0, 0]), ([4, 0, 0], [3, 3, 0]))
    ]
    corner = quintrig.strips([bent, [quintrig.Curve(one.points + np.array([0, 0, 2])) for one in bent]])
    assert corner.angle == pytest.approx(45, abs=1e-6)
    assert "meet at a corner of a rail, at 45°" in corner.notes[0]
    with pytest.raises(ValueError, match=r"rail 1: expected curves joined end to end, found a gap of 1"):
        quintrig.strips([[bent[0], quintrig.Curve(bent[1].points + np.array([0, 1, 0]))], bent[0]])


def test_the_command_makes_rows_whose_joins_and_patterns_are_told_together(tmp_path):
    rails = quintrig.Model.of_curves(ROWS["cone"], unit="m")
    quintrig.save(rails, tmp_path / "rails.toml")
    done = run("strip", tmp_path / "rails.toml", "--pieces", 2, "-o", tmp_path / "row.toml", "--json")
    assert done.code == 0, done.err
    said = json.loads(done.out)
    assert said["angle"] < 1e-3
    assert said["strips"][1]["rails"] == ["curve 2", "curve 3"]
    assert {seam["along"] for seam in said["seams"]} == {"ruling", "rail"}
    told = run("check", tmp_path / "row.toml").out
    assert "G0" not in told.split("seams")[1]
    assert run("flatten", tmp_path / "row.toml", tmp_path / "row.dxf", "--distortion", 1e-6).code == 0
    assert (tmp_path / "row.dxf").read_text().count("LWPOLYLINE\n") >= 4
    words = run("strip", tmp_path / "rails.toml", "--rails", "curve 3,curve 2")
    assert "deviation from curve 2" in words.out
    for arguments, message in (
        (["--rails", "curve 1"], "--rails: expected two names or more"),
        (["--rails", "curve 1,curve 1"], "the curves meet"),
        (["--rails", "curve 1,curv 2"], "did you mean 'curve 2'"),
        (["--rails", "curve 1,curve 2", "--first", "curve 1"], "--rails: expected without"),
    ):
        wrong = run("strip", tmp_path / "rails.toml", *arguments)
        assert (wrong.code, wrong.err.strip().count("\n")) == (2, 0)
        assert message in wrong.err
