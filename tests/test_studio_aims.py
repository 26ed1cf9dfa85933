"""A target beside the model, demands with lights, and fairing in the studio: on the server, and once in a browser."""

# ruff: noqa: F811, fixtures of another module are named by arguments

import base64

import numpy as np
import pytest

import quintrig
from quintrig.studio import aims
from studio_server import Running
from test_studio_browser import browser, context, kept, opened, pytestmark, served, state  # noqa: F401
from test_studio_drag import LOCATE

POINTS = [[0.5 * i, 0.5 * j, 0.2 * np.sin(i) * j] for i in range(6) for j in range(6)]
NET = {"name": "sheet", "unit": "m", "kind": "tensor", "points": np.reshape(POINTS, (6, 6, 3)).tolist()}


@pytest.fixture(scope="module")
def running(tmp_path_factory):
    folder = tmp_path_factory.mktemp("aims")
    (folder / "tent.toml").write_text('kind = "sphere"\nunit = "m"\nradius = 2\n', encoding="utf-8")
    ball = 2.5 * np.random.default_rng(1).normal(size=(400, 3))
    np.savetxt(folder / "scan.xyz", ball, header="unit m")
    (folder / ".hidden.xyz").write_text("1 2 3\n", encoding="utf-8")
    (folder / "away.xyz").symlink_to(folder / "scan.xyz")
    found = Running(folder)
    yield found, ball
    found.stop()


def numbers(text):
    return np.frombuffer(base64.b64decode(text), "<f8")


def test_distances_of_a_target_are_those_of_python(running):
    server, ball = running
    assert server.json("GET", "/api/targets") == (200, {"targets": ["scan.xyz"]})
    text = (server.folder / "tent.toml").read_text()
    asked = {"text": text, "target": "scan.xyz", "align": "", "tolerance": 0.5, "most": 100}
    status, found = server.json("POST", "/api/deviation", asked)
    assert status == 200
    assert (found["count"], found["points"], found["unit"]) == (400, 100, "m")
    assert numbers(found["distances"]) == pytest.approx(
        np.linalg.norm(numbers(found["places"]).reshape(-1, 3), axis=1) - 2.0, abs=1e-9
    )
    chosen = ball[np.linspace(0, 399, 100).astype(int)]
    assert found["within"] == np.mean(np.abs(np.linalg.norm(chosen, axis=1) - 2.0) <= 0.5)


@pytest.mark.parametrize("name", ["away.xyz", ".hidden.xyz", "../scan.xyz", "none.xyz", "tent.toml"])
def test_targets_are_files_of_the_folder_alone(running, name):
    server, _ = running
    asked = {"text": (server.folder / "tent.toml").read_text(), "target": name, "align": ""}
    status, found = server.json("POST", "/api/deviation", asked)
    assert status == 422
    assert "\n" not in found["error"]


def test_every_demand_has_its_light(running):
    server, _ = running
    asked = {"text": (server.folder / "tent.toml").read_text(), "patch": "Sphere", "target": ""}
    asked["text"] = 'name = "Sphere"\n' + asked["text"]
    lines = "gaussian >= 0.2\ncurvature_radius >= 3\narea <= 51\nnonsense\ndeviation <= 1"
    status, found = server.json("POST", "/api/demands", {**asked, "demands": lines})
    assert status == 200
    lights = found["lights"]
    assert [one.get("met") for one in lights] == [True, False, True, None, True]
    assert [one["worst"] for one in lights[:3]] == pytest.approx([0.25, 2.0, 16 * np.pi])
    assert "expected one such as" in lights[3]["error"]


def test_one_point_is_made_fair_and_so_is_a_curve():
    model = quintrig.Model.from_dict(NET)
    found = aims.fairer(model, "sheet", "points[2][3]")
    before, after = (np.array(one.patch().definition.points) for one in (model, found.model))
    moved = np.abs(after - before).max(axis=2) > 0
    assert np.argwhere(moved).tolist() == [[2, 3]]
    for step in np.eye(3):  # the least there is by that point
        aside = after.copy()
        aside[2, 3] += 0.01 * step
        there = quintrig.Model.from_dict({**NET, "points": aside.tolist()})
        assert quintrig.integrals(there.surface)["thin_plate_energy"].value > found.after["thin_plate"]
    curve = {"name": "c", "kind": "curve", "points": [[0, 0], [1, 2], [2, -3], [3, 3], [4, 1], [5, 0]]}
    bent = aims.fairer(quintrig.Model.from_dict(curve), "c", "points[2]")
    points = np.array(bent.model.curves[0].definition.points)
    assert (points == curve["points"]).all(axis=1).tolist() == [True, True, False, True, True, True]
    assert bent.after["thin_plate"] < bent.before["thin_plate"]


def test_a_target_and_lights_follow_a_drag(context, served):
    surface = quintrig.load(served.path).surface
    np.savetxt(served.path.parent / "beside.xyz", surface(*np.random.default_rng(3).random((2, 500))))
    page = opened(context, served.site.address)
    page.locator("summary", has_text="Target and demands").click()
    page.get_by_label("Target beside the model").select_option("beside.xyz")
    page.get_by_label("Demands, one a line").fill("deviation <= 1e-6")
    page.locator(".lights .met").wait_for()
    at = page.evaluate(LOCATE, "section[2]")
    page.mouse.move(at["x"], at["y"])
    page.mouse.down()
    page.mouse.move(at["x"], at["y"] - 40, steps=5)
    page.locator(".lights .missed").wait_for()  # while the button is still down
    assert state(page, "beside").get("rms") > 1e-3
    page.mouse.up()
    page.keyboard.press("Control+z")
    page.locator(".lights .met").wait_for()
    assert state(page, "lights")[0]["worst"] < 1e-9
