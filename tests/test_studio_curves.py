"""Curves in the studio: drawn with polygon and comb, live under sliders and drags, saved; also from disk."""

# ruff: noqa: F811, fixtures of another module are named by arguments

import re

import numpy as np
import pytest

import quintrig
from quintrig.studio import embed
from test_studio_browser import DRAW, Served, browser, context, kept, opened, pytestmark, state, until  # noqa: F401
from test_studio_drag import LOCATE, drag

TWO = """# a remark that stays
name = "Two curves"
unit = "mm"

[[patch]]
kind = "curve"
name = "upper"
points = [[0, 0], [10, 40], [40, 50], [60, -10], [90, 0], [100, 30]]
shape = [0.5, -1]

[[patch]]
kind = "curve"
name = "lower"
basis = "cubic"
points = [[0, -20], [30, -60], [60, 10], [100, -20]]
"""
SPACE = """kind = "curve"
name = "Space"
unit = "mm"
basis = "sg_bezier"
points = [[0, 0, 0], [10, 40, 20], [40, 50, 60], [60, -10, 10], [90, 0, 0]]
"""
LINE = """(name) => { const s = document.querySelector('[data-quintrig]').studio, p = s.stage.cells[0].pieces[0];
  const { centre, scale } = s.frame, ends = Array.from(p.overlays.lines[name].drawn.ends);
  return { ends, centre, scale, tooth: s.painter.tooth }; }"""


@pytest.fixture
def folder(tmp_path):
    """Return what serves a folder with curves; the first one is open."""
    (tmp_path / "lid.toml").write_text(TWO)
    (tmp_path / "space.toml").write_text(SPACE)
    one = Served(tmp_path)
    yield one
    one.stop()


def line(page, name):
    """Return the ends of the drawn segments of a line, in model lengths, and the length of a tooth per curvature."""
    page.evaluate(DRAW)
    found = page.evaluate(LINE, name)
    ends = np.array(found["ends"]).reshape(-1, 2, 3) / found["scale"] + np.array(found["centre"])
    return ends, found["tooth"] / found["scale"]


def python(page):
    return quintrig.model.model.Model.from_dict(as_keys(page))


def as_keys(page):
    model = state(page)
    return {"name": model["name"], "unit": model["unit"], "patch": model["patches"]}


def test_curves_are_drawn_with_polygon_and_comb(context, folder):
    problems = []
    page = opened(context, folder.site.address, problems)
    kept(page, "curves")
    drawn, tooth = line(page, "curve")
    ours = quintrig.Curve([[0, 0], [10, 40], [40, 50], [60, -10], [90, 0], [100, 30]], 0.5, -1)
    t = np.linspace(0, 1, len(drawn) + 1)
    assert drawn[:, 0, :2] == pytest.approx(ours(t)[:-1], abs=1e-4)
    assert np.abs(drawn[:, :, 2]).max() < 1e-4
    comb, _ = line(page, "combU")
    assert comb[:, 0, :2] == pytest.approx(ours.comb(t, tooth)[:-1], abs=1e-3)
    polygon, _ = line(page, "net")
    assert polygon[:, 0, :2] == pytest.approx(ours.points[:-1], abs=1e-4)
    assert f"Length {ours.length():.5g} mm" in page.locator(".status").inner_text()
    assert page.locator(".legend").is_hidden()
    page.get_by_label("Size of the combs", exact=True).fill("2")
    longer, twice = line(page, "combU")
    assert twice == pytest.approx(2 * tooth)
    assert longer[:, 0, :2] == pytest.approx(ours.comb(t, twice)[:-1], abs=1e-3)
    page.locator(".toggle", has_text="Comb").click()
    assert len(line(page, "combU")[0]) == 0
    assert problems == []


def test_sliders_and_drags_move_the_curve_and_save_keeps_the_file(context, folder):
    page = opened(context, folder.site.address)
    page.get_by_label("alpha, number", exact=True).fill("-2.5")
    page.keyboard.press("Enter")
    start = page.evaluate(LOCATE, "points[2]")
    drag(page, start, (40, 30), 6)
    upper = state(page, "model.patches[0]")
    assert upper["shape"] == [-2.5, -1]
    assert upper["points"][2][0] > 40
    assert upper["points"][2][1] < 50
    assert len(upper["points"][2]) == 2
    ours = quintrig.Curve(upper["points"], -2.5, -1)
    drawn, _ = line(page, "curve")
    assert drawn[:, 0, :2] == pytest.approx(ours(np.linspace(0, 1, len(drawn) + 1))[:-1], abs=1e-4)
    page.get_by_role("option", name="lower").click()
    page.get_by_label("Basis", exact=True).select_option("c_bezier")
    page.get_by_label("phi, number", exact=True).fill("2.5")
    page.keyboard.press("Enter")
    page.keyboard.press("Control+s")
    until(page, "document.querySelector('[data-quintrig]').studio.store.state.model === "
                "document.querySelector('[data-quintrig]').studio.store.state.saved")  # fmt: skip
    text = folder.path.read_text()
    assert text.startswith("# a remark that stays")
    first, second = quintrig.load(folder.path).curves
    assert first.curve.points.tolist() == upper["points"]
    assert dict(second.curve.functions.parameters) == {"phi": 2.5}


def test_a_curve_in_space_a_closed_one_and_the_probe(context, folder):
    page = opened(context, folder.site.address)
    page.get_by_role("button", name="Open a model").click()
    page.get_by_role("menuitem", name="space.toml").click()
    until(page, "document.querySelector('[data-quintrig]').studio.store.state.model.name === 'Space'")
    for name, low, high in (("lam 1", -4, 1), ("lam 2", -6, 4), ("lam 4", -4, 1)):
        slider = page.get_by_label(name, exact=True)
        assert (slider.get_attribute("min"), slider.get_attribute("max")) == (str(low), str(high))
    page.get_by_label("lam 2", exact=True).fill("-5")
    kept(page, "curve-space")
    curve = python(page).curve().curve
    page.locator(".probe summary").click()
    page.get_by_label("u to pin").fill("0.4")
    page.keyboard.press("Enter")
    page.get_by_role("button", name="Pin the point at these parameters").click()
    cells = page.locator(".probe-body tbody td").all_inner_texts()
    told = [float(x.replace("−", "-")) for x in cells[1:-1]]
    assert told == pytest.approx(
        [0.4, *curve(0.4), curve.curvature(0.4), 1 / curve.curvature(0.4), curve.torsion(0.4)], rel=1e-3
    )
    page.locator(".toggle", has_text="End in the first point").click()
    assert state(page, "model.patches[0].close") is True
    assert len(state(page, "model.patches[0].points")) == 4
    drawn, _ = line(page, "curve")
    assert drawn[0, 0] == pytest.approx(drawn[-1, 1], abs=1e-4)


def test_a_curve_is_started_from_the_menu_and_surfaces_come_back(context, folder):
    problems = []
    page = opened(context, folder.site.address, problems)
    for name in ("My curve", "My tensor", "My curve"):
        page.get_by_role("button", name="Models: presets and starters").click()
        page.get_by_role("menuitem", name=re.compile(f"^{name.split()[1].capitalize()}")).click()
        until(page, "document.querySelector('[data-quintrig]').studio.store.state.model.name"
                    f".startsWith('{name}')")  # fmt: skip
        page.evaluate(DRAW)
        assert page.locator(".legend").is_hidden() == (name == "My curve")
        piece = "document.querySelector('[data-quintrig]').studio.stage.cells[0].pieces[0]"
        drawn = f"{piece}.overlays.lines.curve.mesh.visible"
        assert page.evaluate(drawn) == (name == "My curve")
        assert page.get_by_label("Colour by").is_visible() == (name != "My curve")
    assert problems == []


@pytest.mark.parametrize("size", [(1280, 720), (420, 860)])
def test_curves_in_a_page_from_disk(context, tmp_path, size):
    problems = []
    (tmp_path / "m.toml").write_text(TWO)
    page_file = tmp_path / "page.html"
    viewer = embed(quintrig.load(tmp_path / "m.toml"))
    page_file.write_text(f"<!doctype html><meta charset=utf-8><style>.quintrig-viewer{{height:640px}}</style>{viewer}")
    page = context.new_page()
    page.set_viewport_size({"width": size[0], "height": size[1]})
    page.on("console", lambda m: problems.append(m.text) if m.type == "error" else None)
    page.on("pageerror", lambda e: problems.append(str(e)))
    page.goto(page_file.as_uri())
    page.locator(".studio").wait_for()
    kept(page, f"curves-disk-{size[0]}")
    page.get_by_label("alpha, number", exact=True).fill("-3")
    page.keyboard.press("Enter")
    drawn, _ = line(page, "curve")
    points = state(page, "model.patches[0].points")
    ours = quintrig.Curve(points, -3, -1)
    assert drawn[:, 0, :2] == pytest.approx(ours(np.linspace(0, 1, len(drawn) + 1))[:-1], abs=1e-4)
    assert problems == []
