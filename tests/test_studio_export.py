"""Exports from the studio: the colours that are shown, a tolerance, and the reason where a format cannot be."""

import base64
import re

import numpy as np
import pytest

pytest.importorskip("uvicorn", reason="the extra 'studio' is not installed")

from quintrig.exchange.formats import FORMATS
from quintrig.figure import palette
from quintrig.quantities.table import quantity
from studio_server import MODEL, Running

CATENOID = 'kind = "catenoid"\nwaist = 1\nheight = 3\nunit = "mm"\n'
SADDLE = 'kind = "monkey_saddle"\nsize = 1\n'
POINT = 'kind = "tensor"\nbasis = "bernstein"\npoints = [[[0,0,0],[0,0,0]],[[0,0,0],[0,0,0]]]\n'


@pytest.fixture
def running(tmp_path):
    (tmp_path / "tent.toml").write_text(MODEL)
    one = Running(tmp_path)
    yield one
    one.stop()


def exported(running, text, suffix, **more):
    body = {"text": text, "suffix": suffix, "patch": "", "colour": ""} | more
    status, answer = running.json("POST", "/api/export", body)
    assert status == 200, answer
    return base64.b64decode(answer["content"]), answer["notes"]


def points_and_colours(data):
    """The points and the colours of an OBJ file's vertices."""
    rows = np.array([line.split()[1:] for line in data.decode().splitlines() if line.startswith("v ")], dtype=float)
    return rows[:, :3], rows[:, 3:]


@pytest.mark.parametrize("ends", [(-1.5, 1.0), (-0.5, -0.1), (-0.75, 0.25)])
def test_the_colours_are_those_between_the_ends_that_are_shown(running, ends):
    """On a catenoid r = cosh z, K = -1 / r⁴."""
    data, notes = exported(running, CATENOID, ".obj", colour="gaussian", low=ends[0], high=ends[1])
    points, colours = points_and_colours(data)
    gaussian = -(np.hypot(*points[:, :2].T) ** -4.0)
    expected = palette.real_colours(gaussian, quantity("gaussian"), palette.Limits(*ends))
    np.testing.assert_allclose(colours, expected, rtol=0, atol=5e-3)
    told = next(note for note in notes if note.startswith("colours show"))
    assert f"{ends[0]:.4g} to {ends[1]:.4g} 1/mm²" in told
    beyond = re.search(r"([\d.]+) % of the points beyond", told)
    share = 100 * np.mean((gaussian < ends[0]) | (gaussian > ends[1]))
    assert float(beyond[1] if beyond else 0) == pytest.approx(share, abs=2)


def test_without_ends_they_are_those_of_the_figures_and_without_a_quantity_there_are_none(running):
    usual, _ = exported(running, CATENOID, ".obj", colour="gaussian")
    other, _ = exported(running, CATENOID, ".obj", colour="gaussian", low=-9.0, high=9.0)
    assert not np.array_equal(points_and_colours(usual)[1], points_and_colours(other)[1])
    plain, notes = exported(running, CATENOID, ".obj")
    assert points_and_colours(plain)[1].shape[1] == 0
    assert not any("colours" in note for note in notes)


@pytest.mark.parametrize("suffix", [".stl", ".obj", ".ply", ".glb"])
def test_a_mesh_keeps_to_the_tolerance(running, suffix):
    sizes = []
    for tolerance in (0.1, 0.01, 0.001):
        data, notes = exported(running, CATENOID, suffix, tolerance=tolerance)
        measured = float(re.search(r"chord measured ([\d.e-]+), allowed", notes[0])[1])
        assert 0 < measured <= tolerance
        sizes.append(len(data))
    assert sizes[0] < sizes[1] < sizes[2]


def test_a_flat_pattern_takes_a_tolerance(running):
    cone = MODEL.replace('"m"', '"mm"')
    fine, _ = exported(running, cone, ".svg", tolerance=1e-4)
    coarse, _ = exported(running, cone, ".svg", tolerance=1e-1)
    assert len(coarse) < len(fine)


@pytest.mark.parametrize(
    "more",
    [
        {"tolerance": 0},
        {"tolerance": -1},
        {"tolerance": "1"},
        {"tolerance": True},
        {"tolerance": 10**400},
        {"colour": "gaussian", "low": 1, "high": 1},
        {"colour": "gaussian", "low": 2, "high": 1},
        {"colour": "gaussian", "low": "a", "high": 1},
    ],
)
def test_a_tolerance_or_colours_that_cannot_be_are_refused_in_one_line(running, more):
    body = {"text": CATENOID, "suffix": ".obj", "patch": "", "colour": ""} | more
    status, answer = running.json("POST", "/api/export", body)
    assert status == 422
    assert "\n" not in answer["error"]


def reasons(running, text):
    status, answer = running.json("POST", "/api/formats", {"text": text, "patch": ""})
    assert status == 200
    return {one["suffix"]: one["reason"] for one in answer["formats"]}


@pytest.mark.parametrize(
    ("text", "families"),
    [
        (MODEL.replace('"m"', '"mm"'), {"net"}),
        (CATENOID, {"net", "pattern"}),
        (SADDLE, {"net", "pattern"}),
        (POINT, {"cad", "mesh", "pattern"}),
    ],
)
def test_a_format_has_a_reason_exactly_where_its_export_is_refused(running, text, families):
    found = reasons(running, text)
    for one in FORMATS:
        if one.family == "model" or not one.installed:
            continue
        assert bool(found[one.suffix]) == (one.family in families), one
        if one.family != "cad" or found[one.suffix]:
            body = {"text": text, "suffix": one.suffix, "patch": "", "colour": ""}
            status, answer = running.json("POST", "/api/export", body)
            assert (status == 200) == (not found[one.suffix])
            if found[one.suffix]:
                assert found[one.suffix] in answer["error"]


def test_what_is_not_installed_says_what_installs_it(running, monkeypatch):
    monkeypatch.setattr("quintrig.exchange.formats.find_spec", lambda name: None)
    found = reasons(running, CATENOID)
    assert found[".step"] == "needs pip install 'quintrig[cad]'"
    assert found[".vtu"] == "needs pip install 'quintrig[mesh]'"
    assert not found[".stl"]
