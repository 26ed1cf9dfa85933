"""The studio in a real browser (Debian's Chromium): what a designer does there, and what it must withstand."""

import json
import os
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import quintrig
from quintrig.quantities import table
from quintrig.studio import embed, policy
from test_studio_numbers import JOBS, compare

CHROMIUM = Path("/usr/bin/chromium")
SCREENS = Path(__file__).parents[1] / "out" / "studio"
MODEL = Path(__file__).parents[1] / "examples" / "car_boot.toml"
# Drawn in software, WebGL and nothing else: pages that are put together without it take a third less of the processor.
SOFTWARE = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing"]
FLAGS = ["--no-sandbox", *SOFTWARE]
DRIVER = "GL Driver Message"
"""What begins a remark of the software that draws on its own speed: no complaint of the page."""
DRAW = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


def _missing():
    try:
        import playwright.sync_api  # noqa: F401
        import uvicorn  # noqa: F401
    except ModuleNotFoundError as error:
        return f"{error.name} is not installed: pip install 'quintrig[dev]'"
    return "" if CHROMIUM.exists() else f"{CHROMIUM} is missing: apt-get install chromium"


if _missing() and os.environ.get("CI") == "true":
    raise RuntimeError(_missing())
pytestmark = pytest.mark.skipif(bool(_missing()), reason=_missing())


@pytest.fixture(scope="module")
def browser():
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield chromium
        chromium.close()


class Served:
    """A running studio over a folder with one model."""

    def __init__(self, folder, port=0):
        import uvicorn

        from quintrig.studio import server

        self.path = folder / "lid.toml"
        if not self.path.exists():
            self.path.write_text(MODEL.read_text())
        self.site = server.site(self.path, port=port)
        config = uvicorn.Config(
            server.application(self.site), host=self.site.host, port=self.site.port, log_level="error", lifespan="off",
            timeout_graceful_shutdown=1,
        )  # fmt: skip
        self.server = uvicorn.Server(config)
        self.thread = threading.Thread(target=self.server.run, daemon=True)
        self.thread.start()
        while not self.server.started:
            time.sleep(0.02)

    def stop(self):
        self.server.should_exit = True
        self.thread.join(10)


@pytest.fixture
def served(tmp_path):
    one = Served(tmp_path)
    yield one
    one.stop()


@pytest.fixture
def context(browser):
    # Reduced motion: views are there at once, however busy the machine is.
    size = {"width": 1280, "height": 720}
    made = browser.new_context(viewport=size, accept_downloads=True, reduced_motion="reduce")
    made.set_default_timeout(20_000)
    yield made
    made.close()


def opened(context, address, problems=None):
    page = context.new_page()
    if problems is not None:
        page.on(
            "console",
            lambda m: problems.append(m.text) if m.type in ("error", "warning") and DRIVER not in m.text else None,
        )
        page.on("pageerror", lambda e: problems.append(str(e)))
    page.goto(address)
    page.locator(".studio").wait_for()
    page.evaluate(DRAW)
    return page


def state(page, path="model"):
    return page.evaluate(f"document.querySelector('[data-quintrig]').studio.store.state.{path}")


def kept(page, name):
    """Keep a screenshot as a test artefact."""
    SCREENS.mkdir(parents=True, exist_ok=True)
    page.evaluate(DRAW)
    page.screenshot(path=SCREENS / f"{name}.png")


def until(page, expression):
    """Wait for an expression to be true; the page's policy forbids Playwright's own way, which needs eval."""
    for _ in range(200):
        if page.evaluate(expression):
            return
        page.wait_for_timeout(50)
    raise AssertionError(f"never true: {expression}")


def shape_of(page):
    return state(page, "model.patches[0].shape")


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
def test_it_opens_without_complaint_and_asks_nobody_else(context, served, size):
    problems, asked = [], []
    context.on("request", lambda request: asked.append(request.url))
    page = opened(context, served.site.address, problems)
    page.set_viewport_size({"width": size[0], "height": size[1]})
    kept(page, f"open-{size[0]}")
    assert page.title() == "Car boot lid – quintrig"
    assert "token" not in page.url
    own = f"http://127.0.0.1:{served.site.port}/"
    assert all(url.startswith((own, "blob:", "data:")) for url in asked), asked
    assert problems == []
    # Nothing runs out of the window, and the surface is really drawn: the picture has the map's colours in it.
    wide = page.evaluate("document.documentElement.scrollWidth")
    assert wide == size[0]
    shown = page.evaluate(
        """() => { const s = document.querySelector('[data-quintrig]').studio; s.stage.draw();
        const c = document.createElement('canvas'); c.width = c.height = 64;
        const x = c.getContext('2d'); x.drawImage(s.stage.canvas, 0, 0, 64, 64);
        return Array.from(x.getImageData(0, 0, 64, 64).data).filter((v, i) => i % 4 === 3 && v > 200).length; }"""
    )
    assert shown > 400


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("size", [(420, 860), (900, 700)])
def test_everything_is_within_reach_on_a_small_screen(context, served, size, theme):
    page = opened(context, served.site.address)
    page.set_viewport_size({"width": size[0], "height": size[1]})
    if theme == "dark":
        page.get_by_role("button", name="Light or dark").click()
    page.wait_for_timeout(200)
    kept(page, f"small-{size[0]}-{theme}")
    outside = page.evaluate(
        """() => [...document.querySelector('[data-quintrig]').shadowRoot
          .querySelectorAll('.bar button, .view-tools button')]
        .filter((e) => e.checkVisibility() && !e.closest('[hidden]'))
        .filter((e) => { const b = e.getBoundingClientRect(); return b.right > innerWidth + 1 || b.left < -1; })
        .map((e) => e.textContent || e.title)"""
    )
    assert outside == []
    # The whole surface is in the picture after the window has changed.
    inside = page.evaluate(
        """() => { const s = document.querySelector('[data-quintrig]').studio, c = s.stage.cells[0];
        const x = c.pieces[0].mesh.position, box = s.canvas.getBoundingClientRect();
        for (let i = 0; i < x.length; i += 300) {
          const p = s.stage.project(0, [x[i], x[i + 1], x[i + 2]]);
          if (p.x < 0 || p.y < 0 || p.x > box.width || p.y > box.height) return false;
        }
        return true; }"""
    )
    assert inside
    assert not page.get_by_label("Unit of length").is_visible()
    page.get_by_role("button", name="Construction and control points").click()
    page.get_by_label("Unit of length").select_option("cm")
    assert state(page, "model.unit") == "cm"
    kept(page, f"small-{size[0]}-{theme}-panel")


def test_a_slider_is_moved_undone_and_redone(context, served):
    page = opened(context, served.site.address)
    before = shape_of(page)
    slider = page.get_by_label("alpha 2", exact=True)
    slider.focus()
    for _ in range(5):
        page.keyboard.press("ArrowLeft")
    assert shape_of(page) == pytest.approx([*before[:2], before[2] - 0.05, before[3]])
    page.get_by_label("alpha 2, number").fill("-3.25")
    page.keyboard.press("Enter")
    assert shape_of(page)[2] == -3.25
    page.get_by_label("alpha 2, number").fill("7")
    page.keyboard.press("Enter")
    assert shape_of(page)[2] == -3.25
    # What is being typed is not replaced by a frame that comes meanwhile.
    page.get_by_label("alpha 2, number").fill("-1.5")
    page.evaluate("document.querySelector('[data-quintrig]').studio.plan(true)")
    page.evaluate(DRAW)
    assert page.get_by_label("alpha 2, number").input_value() == "-1.5"
    page.get_by_label("alpha 2, number").fill("-3.25")
    page.locator("canvas.view").focus()
    page.keyboard.press("Control+z")
    assert shape_of(page)[2] == pytest.approx(before[2] - 0.05)
    page.keyboard.press("Control+Shift+z")
    assert shape_of(page)[2] == -3.25
    page.locator(".dirty").wait_for(state="visible")


def test_a_control_point_is_dragged_along_a_free_axis_only(context, served):
    page = opened(context, served.site.address)
    before = state(page, "model.patches[0].section")
    page.locator(".locks .toggle", has_text="y").click()
    page.locator(".locks .toggle", has_text="x").click()
    at = page.evaluate("document.querySelector('[data-quintrig]').studio.locate('section[1]')")
    page.mouse.move(at["x"], at["y"])
    page.mouse.down()
    page.mouse.move(at["x"] + 3, at["y"] - 30, steps=4)
    page.mouse.move(at["x"] + 5, at["y"] - 60, steps=4)
    page.mouse.up()
    kept(page, "dragged")
    after = state(page, "model.patches[0].section")
    assert after[1][:2] == before[1][:2]
    assert after[1][2] > before[1][2] + 20
    assert [after[i] for i in (0, 2, 3, 4, 5)] == [before[i] for i in (0, 2, 3, 4, 5)]
    now = page.evaluate("document.querySelector('[data-quintrig]').studio.locate('section[1]')")
    assert abs(now["y"] - (at["y"] - 60)) < 4
    page.keyboard.press("Control+z")  # one drag, one step
    assert state(page, "model.patches[0].section") == before


def segments(page, line):
    """The ends of the segments of a line over the first surface, in the model's lengths, (n, 3)."""
    found = page.evaluate(
        """(name) => { const s = document.querySelector('[data-quintrig]').studio;
        const line = s.stage.cells[0].pieces[0].overlays.lines[name];
        return { ends: Array.from(line.data.slice(0, 6 * line.count)), frame: s.frame }; }""",
        line,
    )
    return np.reshape(found["ends"], (-1, 3)) / found["frame"]["scale"] + found["frame"]["centre"]


def test_snapping_rounds_what_is_dragged(context, served):
    page = opened(context, served.site.address)
    before = state(page, "model.patches[0].trajectory")
    page.get_by_label("Snap step").fill("12.5")
    page.keyboard.press("Enter")
    page.locator(".toggle", has_text="Snap to").click()
    at = page.evaluate("document.querySelector('[data-quintrig]').studio.locate('trajectory[1]')")
    page.mouse.move(at["x"], at["y"])
    page.mouse.down()
    page.mouse.move(at["x"] - 20, at["y"] - 31, steps=5)
    page.mouse.up()
    after = state(page, "model.patches[0].trajectory")
    assert after[1] != before[1]
    # What moves is rounded; the coordinate across the plane that it is dragged in stays as it was.
    assert all(x % 12.5 == 0 for x, was in zip(after[1], before[1], strict=True) if x != was)
    assert sum(x == was for x, was in zip(after[1], before[1], strict=True)) == 1


def test_a_section_plane_stands_at_any_angle(context, served):
    page = opened(context, served.site.address)
    page.locator("summary", has_text="Section").click()
    page.locator(".toggle", has_text="Section by a plane").click()
    page.get_by_label("Azimuth of the plane's normal in degrees, number").fill("40")
    page.keyboard.press("Enter")
    page.get_by_label("Tilt of the plane's normal in degrees, number").fill("30")
    page.keyboard.press("Enter")
    page.evaluate(DRAW)
    page.get_by_label("Place of the section plane, number").fill("120")
    page.keyboard.press("Enter")
    page.evaluate(DRAW)
    kept(page, "section")
    a, e = np.radians([40, 30])
    normal = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    points = segments(page, "section")
    assert len(points) > 100
    np.testing.assert_allclose(points @ normal, 120, atol=0.05)  # of a surface 1700 across, drawn in 32 bits
    assert "= 120 mm" in page.locator(".right").inner_text()

    for grip, turned in (("move", False), ("tilt", True)):
        before = state(page, "settings")
        where = "(grip) => document.querySelector('[data-quintrig]').studio.locate(grip)"
        at, other = page.evaluate(where, grip), page.evaluate(where, "tilt" if grip == "move" else "move")
        goal = {x: at[x] + 0.4 * (other[x] - at[x]) for x in "xy"}
        page.mouse.move(at["x"], at["y"])
        page.mouse.down()
        page.mouse.move(goal["x"], goal["y"], steps=5)
        page.mouse.up()
        page.evaluate(DRAW)
        after = state(page, "settings")
        moved = {key for key in after if after[key] != before[key]}
        assert moved == ({"sectionAzimuth", "sectionTilt"} if turned else {"sectionAt"})
        now = page.evaluate(where, grip)
        assert np.hypot(now["x"] - goal["x"], now["y"] - goal["y"]) < 4  # the grip stays under the pointer
    page.get_by_role("radio", name="z", exact=True).click()
    page.evaluate(DRAW)
    assert np.ptp(segments(page, "section")[:, 2]) < 0.01


@pytest.fixture
def touch(browser, served):
    """A page on a screen to touch, and a function that sends one touch event with fingers at these points."""
    context = browser.new_context(viewport={"width": 1280, "height": 720}, has_touch=True, reduced_motion="reduce")
    context.set_default_timeout(20_000)
    page = opened(context, served.site.address)
    session = context.new_cdp_session(page)

    def send(kind, *points):
        fingers = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": fingers})
        page.evaluate(DRAW)

    yield page, send
    context.close()


ORBIT = """() => { const orbit = document.querySelector('[data-quintrig]').studio.stage.orbit;
    const { azimuth, elevation, span, target } = orbit;
    return [azimuth, elevation, span, ...target.toArray()]; }"""


def test_two_fingers_zoom_and_pan_and_one_turns(touch):
    page, send = touch
    start = page.evaluate(ORBIT)
    send("touchStart", (600, 330))
    send("touchMove", (640, 350))
    send("touchEnd")
    turned = page.evaluate(ORBIT)
    assert turned[0] == pytest.approx(start[0] - 14)
    assert turned[2:] == pytest.approx(start[2:], abs=1e-9)

    page.keyboard.press("3")
    page.evaluate(DRAW)
    turned = page.evaluate(ORBIT)
    under = "document.querySelector('[data-quintrig]').studio.locate('section[3]')"
    at = page.evaluate(under)
    send("touchStart", (at["x"] - 50, at["y"]))
    send("touchStart", (at["x"] - 50, at["y"]), (at["x"] + 50, at["y"]))
    send("touchMove", (at["x"] - 100, at["y"]), (at["x"] + 100, at["y"]))
    zoomed = page.evaluate(ORBIT)
    assert zoomed[:2] == pytest.approx(turned[:2], abs=1e-9)
    assert zoomed[2] == pytest.approx(turned[2] / 2)  # twice as far apart, twice as large
    kept_under = page.evaluate(under)
    assert np.hypot(kept_under["x"] - at["x"], kept_under["y"] - at["y"]) < 12  # about the point between the fingers
    send("touchMove", (at["x"] - 60, at["y"] + 30), (at["x"] + 140, at["y"] + 30))
    panned = page.evaluate(ORBIT)
    assert panned[:3] == pytest.approx(zoomed[:3], rel=1e-9, abs=1e-9)  # by a distance that is the same to rounding
    moved = page.evaluate(under)
    assert moved["x"] - kept_under["x"] == pytest.approx(40, abs=5)
    assert moved["y"] - kept_under["y"] == pytest.approx(30, abs=5)
    send("touchEnd", (at["x"] + 140, at["y"] + 30))  # one finger is lifted: the other does not turn the picture
    send("touchMove", (at["x"] + 40, at["y"] - 30))
    assert page.evaluate(ORBIT) == pytest.approx(panned, abs=1e-9)
    send("touchEnd")
    assert state(page, "pins") == []
    assert state(page, "model") == state(page, "saved")


def test_a_finger_drags_a_control_point_and_pins_by_a_tap(touch):
    page, send = touch
    before = state(page, "model.patches[0].section")
    at = page.evaluate("document.querySelector('[data-quintrig]').studio.locate('section[1]')")
    send("touchStart", (at["x"] + 14, at["y"]))  # fingers are less exact than pointers
    send("touchMove", (at["x"] + 14, at["y"] - 30))
    send("touchMove", (at["x"] + 14, at["y"] - 50))
    send("touchEnd")
    after = state(page, "model.patches[0].section")
    assert after[1][2] > before[1][2] + 20
    assert [after[i] for i in (0, 2, 3, 4, 5)] == [before[i] for i in (0, 2, 3, 4, 5)]
    box = page.locator("canvas.view").bounding_box()
    send("touchStart", (box["x"] + 0.42 * box["width"], box["y"] + 0.52 * box["height"]))
    send("touchEnd")
    assert len(state(page, "pins")) == 1


def test_what_has_no_size_and_what_runs_off_to_infinity(context, served):
    problems = []
    page = opened(context, served.site.address, problems)
    opened_model(page, {"kind": "tensor", "basis": "bernstein", "points": [[[0.1, 0.2, 0.3]] * 4] * 4})
    assert "A single point" in page.locator(".status").inner_text()
    assert "no point has a finite value" in page.locator(".legend").inner_text()
    drawn = "document.querySelector('[data-quintrig]').studio.stage.cells[0].pieces[0].mesh.position"
    assert page.evaluate(f"Math.max(...{drawn}.map(Math.abs))") < 1e-6  # nothing but the point itself
    kept(page, "single-point")
    opened_model(page, {"kind": "tensor", "points": [[[i, i, 0]] * 6 for i in range(6)]})
    assert "this is a curve" in page.locator(".status").inner_text()
    planes = ((0, 1, 4, -20), (1, 1, 5, -24), (2, 1, 4, -30), (3, 0, 4, -33), (4, 1, 3, -40), (5, 2, 4, -44))
    opened_model(page, {"kind": "developable", "planes": planes, "bounds": ((0, 0, 1, 0), (0, 0, 1, -5))})
    assert "edge of regression (magenta)" in page.locator(".status").inner_text()
    kept(page, "edge-of-regression")
    shown = page.evaluate(
        f"""() => {{ const p = {drawn}; let n = 0, all = 0;
        for (let i = 0; i < p.length; i += 3) {{ all++; n += Math.hypot(p[i], p[i + 1], p[i + 2]) < 1; }}
        return n / all; }}"""
    )
    assert shown > 0.5  # the picture is of the strip, not of what is far away
    lines = "document.querySelector('[data-quintrig]').studio.stage.cells[0].pieces[0].overlays.lines.edge.count"
    assert page.evaluate(lines) > 50
    assert problems == []


def become(page, kind):
    """Choose another construction; where that is another surface, say yes."""
    page.get_by_label("Construction", exact=True).select_option(kind)
    again = page.get_by_role("button", name="Start anew")
    until(
        page,
        f"""(() => {{ const {{ studio }} = document.querySelector('[data-quintrig]');
        return studio.root.querySelector('dialog[open]')
            || studio.store.state.model.patches[0].kind === '{kind}'; }})()""",
    )
    if again.count():
        again.click()
    until(page, f"document.querySelector('[data-quintrig]').studio.store.state.model.patches[0].kind === '{kind}'")
    page.evaluate(DRAW)


def test_a_plane_of_a_developable_is_dragged_along_its_normal(context, served):
    page = opened(context, served.site.address)
    become(page, "developable")
    before = state(page, "model.patches[0].planes")
    at = page.evaluate("document.querySelector('[data-quintrig]').studio.locate('planes[2]')")
    page.mouse.move(at["x"], at["y"])
    page.mouse.down()
    page.mouse.move(at["x"], at["y"] - 25, steps=5)
    page.mouse.up()
    after = state(page, "model.patches[0].planes")
    assert after[2][:3] == before[2][:3]
    assert after[2][3] != before[2][3]
    assert [after[i] for i in (0, 1, 3, 4, 5)] == [before[i] for i in (0, 1, 3, 4, 5)]
    page.get_by_label("Snap step").fill("0.25")
    page.keyboard.press("Enter")
    page.locator(".toggle", has_text="Snap to").click()
    page.evaluate(DRAW)
    at = page.evaluate("document.querySelector('[data-quintrig]').studio.locate('planes[2]')")
    page.mouse.move(at["x"], at["y"])
    page.mouse.down()
    page.mouse.move(at["x"], at["y"] - 25, steps=5)
    page.mouse.up()
    snapped = state(page, "model.patches[0].planes")[2][3]
    assert snapped != after[2][3]
    assert snapped % 0.25 == pytest.approx(0, abs=1e-9) or snapped % 0.25 == pytest.approx(0.25, abs=1e-9)


def test_every_construction_is_edited_by_dragging(context, served):
    page = opened(context, served.site.address)
    kinds = page.get_by_label("Construction", exact=True).locator("optgroup[label=Constructions] option")
    dragged = {}
    for kind in [*kinds.evaluate_all("(options) => options.map((o) => o.value)"), "nurbs"]:
        become(page, kind)
        handles = page.evaluate(
            "document.querySelector('[data-quintrig]').studio.model.list.map((h) => [h.key, h.id, h.index])"
        )
        for key in dict.fromkeys(key for key, _, _ in handles):
            mine = [(identity, index) for one, identity, index in handles if one == key]
            identity, index = mine[len(mine) // 2]
            before = state(page, "model.patches[0]")
            page.locator("canvas.view").focus()
            page.keyboard.press("1")
            page.evaluate(DRAW)
            at = page.evaluate("(id) => document.querySelector('[data-quintrig]').studio.locate(id)", identity)
            page.mouse.move(at["x"], at["y"])
            page.mouse.down()
            page.mouse.move(at["x"] + 6, at["y"] - 14, steps=3)
            page.mouse.move(at["x"] + 12, at["y"] - 28, steps=3)
            page.mouse.up()
            after = state(page, "model.patches[0]")
            assert state(page, "selected") == identity, kind  # nothing lies in front of it
            changed = np.argwhere((np.array(after[key]) != np.array(before[key])).any(axis=-1)).tolist()
            assert changed == [index], (kind, key)
            assert {name for name in after if after[name] != before[name]} == {key}
            dragged.setdefault(kind, []).append(key)
            page.keyboard.press("Control+z")
            assert state(page, "model.patches[0]") == before
            page.keyboard.press("Escape")
    assert dragged == {
        "tensor": ["points"], "symmetric": ["points"], "swept": ["section", "trajectory"],
        "swung": ["profile", "trajectory"], "ruled": ["first", "second"], "developable": ["planes", "bounds"],
        "nurbs": ["points"],
    }  # fmt: skip


def test_the_image_of_a_symmetric_net_moves_its_source(context, served):
    page = opened(context, served.site.address)
    become(page, "symmetric")
    before = np.array(state(page, "model.patches[0].points"))
    at = page.evaluate("document.querySelector('[data-quintrig]').studio.locate('points[1][5]′')")
    page.mouse.move(at["x"], at["y"])
    page.mouse.down()
    page.mouse.move(at["x"] + 30, at["y"], steps=5)
    page.mouse.up()
    moved = np.array(state(page, "model.patches[0].points")) - before
    assert np.abs(moved[1, 5]).max() > 1
    moved[1, 5] = 0
    assert np.all(moved == 0)


def test_the_arrow_keys_move_the_chosen_point(context, served):
    page = opened(context, served.site.address)
    before = np.array(state(page, "model.patches[0].section"))
    page.locator("canvas.view").focus()
    page.keyboard.press("3")
    page.evaluate(DRAW)
    page.keyboard.press("]")
    assert state(page, "selected") == "section[0]"
    page.keyboard.press("ArrowUp")
    after = np.array(state(page, "model.patches[0].section"))
    assert (after - before)[0] == pytest.approx([0, 0, state(page, "settings.snapStep")])


def test_the_probe_tells_what_python_tells(context, served, tmp_path):
    page = opened(context, served.site.address)
    box = page.locator("canvas.view").bounding_box()
    page.mouse.click(box["x"] + 0.42 * box["width"], box["y"] + 0.5 * box["height"])
    page.get_by_label("u to pin").fill("0.25")
    page.get_by_label("v to pin").fill("0.75")
    page.keyboard.press("Tab")
    page.get_by_role("button", name="Pin the point").click()
    kept(page, "probe")
    pins = state(page, "pins")
    assert len(pins) == 2
    assert page.locator(".probe tbody tr").count() == 2
    with page.expect_download() as waiting:
        page.get_by_role("button", name="Save the table as CSV").click()
    target = tmp_path / "probe.csv"
    waiting.value.save_as(target)
    lines = [line for line in target.read_text().splitlines() if not line.startswith("#")]
    names = lines[0].split(",")
    surface = quintrig.load(served.path).surface
    for pin, line in zip(pins, lines[1:], strict=True):
        row = dict(zip(names, line.split(","), strict=True))
        sample = quintrig.analyse(surface, pin["u"], pin["v"])
        for key in ("gaussian", "mean", "k1", "k2", "curvedness", "shape_index"):
            assert float(row[key]) == pytest.approx(float(sample[key]), rel=1e-10)
        assert row["hk_type"] == table.BY_KEY["hk_type"].classes[int(sample["hk_type"])]


def test_saving_writes_the_file_and_a_changed_file_is_not_lost(context, served):
    page = opened(context, served.site.address)
    page.get_by_label("zeta 2, number").fill("-2")
    page.keyboard.press("Enter")
    page.keyboard.press("Control+s")
    page.get_by_text("Saved lid.toml").wait_for()
    assert quintrig.load(served.path).patches[0].shape == (1, 1, 0, -2)
    comments = [line for line in MODEL.read_text().splitlines() if line.startswith("#")]
    assert all(comment in served.path.read_text() for comment in comments)
    page.locator(".dirty").wait_for(state="hidden")
    served.path.write_text('kind = "torus"\n')
    page.get_by_label("zeta 2, number").fill("-1")
    page.keyboard.press("Enter")
    page.keyboard.press("Control+s")
    page.get_by_role("button", name="Cancel").click()
    assert served.path.read_text() == 'kind = "torus"\n'
    page.keyboard.press("Control+s")
    page.get_by_role("button", name="Overwrite it").click()
    page.locator(".dirty").wait_for(state="hidden")
    assert quintrig.load(served.path).patches[0].shape == (1, 1, 0, -1)


def test_unsaved_work_is_offered_after_a_reload_and_a_restart(context, served, tmp_path):
    page = opened(context, served.site.address)
    page.get_by_label("alpha 1, number").fill("-3.5")
    page.keyboard.press("Enter")
    page.reload()
    page.get_by_text("Unsaved work").wait_for()
    kept(page, "draft")
    assert shape_of(page)[0] == 1
    page.get_by_role("button", name="Restore it").click()
    assert shape_of(page)[0] == -3.5
    page.wait_for_timeout(600)
    page.close()
    served.stop()
    again = Served(tmp_path)
    try:
        assert again.site.port == served.site.port
        page = opened(context, again.site.address)
        page.get_by_role("button", name="Restore it").click()
        assert shape_of(page)[0] == -3.5
    finally:
        again.stop()


def test_two_tabs_do_not_disturb_each_other(context, served):
    first, second = opened(context, served.site.address), opened(context, served.site.address)
    first.get_by_label("alpha 1, number").fill("-1")
    first.keyboard.press("Enter")
    first.wait_for_timeout(600)
    assert shape_of(second)[0] == 1
    third = opened(context, served.site.address)
    third.wait_for_timeout(300)
    assert third.get_by_text("Unsaved work").count() == 0
    first.reload()
    first.get_by_text("Unsaved work").wait_for()


def test_a_bad_file_gets_the_message_of_the_command_line_and_the_work_is_kept(context, served, tmp_path):
    page = opened(context, served.site.address)
    page.get_by_label("alpha 1, number").fill("-1")
    page.keyboard.press("Enter")
    bad = tmp_path / "bad.toml"
    bad.write_text('kind = "swept"\nsection = [[0, 0, 0], [1, 2]]\n')
    with pytest.raises(quintrig.ModelError) as told:
        quintrig.load(bad)
    drop = """([name, text]) => { const data = new DataTransfer(); data.items.add(new File([text], name));
        document.querySelector('[data-quintrig]').studio.root.dispatchEvent(
          new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true })); }"""
    page.evaluate(drop, [bad.name, bad.read_text()])
    page.get_by_role("alert").filter(has_text=str(told.value).replace(str(bad), "bad.toml")).wait_for()
    kept(page, "bad-file")
    assert shape_of(page)[0] == -1
    page.evaluate(drop, ["good.json", '{"kind": "torus"}'])
    page.get_by_role("button", name="Leave them").click()
    until(page, "document.querySelector('[data-quintrig]').studio.store.state.model.patches[0].kind === 'torus'")


def test_a_file_that_went_bad_is_told_and_the_draft_is_still_offered(context, served):
    page = opened(context, served.site.address)
    page.get_by_label("alpha 1, number").fill("-2.5")
    page.keyboard.press("Enter")
    page.wait_for_timeout(600)
    served.path.write_text('kind = "cone"\nradius = "wide"\n')
    page.reload()
    page.get_by_role("alert").filter(has_text="lid.toml").filter(has_text="radius").wait_for()
    kept(page, "went-bad")
    page.get_by_role("button", name="Restore it").click()
    assert shape_of(page)[0] == -2.5


def test_kept_models_stand_beside_the_model_on_one_scale(context, served):
    page = opened(context, served.site.address)
    page.get_by_role("radio", name="Kept").click()  # with nothing kept yet, what is there is kept
    page.get_by_label("alpha 2, number").fill("-4")
    page.keyboard.press("Enter")
    page.get_by_role("button", name="Keep the model").click()
    page.get_by_label("alpha 2, number").fill("1")
    page.keyboard.press("Enter")
    page.evaluate(DRAW)
    assert page.locator(".cell-label").all_text_contents() == ["now", "kept 1", "kept 2"]
    found = page.evaluate(
        """() => document.querySelector('[data-quintrig]').studio.stage.cells.map((c) => [
        c.pieces[0].patch.shape[2], ...c.pieces[0].mesh.material.uniforms.range.value.toArray()])"""
    )
    assert [one[0] for one in found] == [1, 0, -4]
    assert len({tuple(one[1:]) for one in found}) == 1


def test_four_sets_share_one_scale(context, served):
    page = opened(context, served.site.address)
    page.get_by_role("radio", name="Four sets").click()
    page.evaluate(DRAW)
    assert page.locator(".cell-label").all_text_contents() == [
        "(1, 1, 1, 1)", "(1, 1, −3, −3)", "(1, −3, 1, −3)", "(1, 0, −2, −3)",
    ]  # fmt: skip
    kept(page, "four-sets")
    ranges = page.evaluate(
        """() => document.querySelector('[data-quintrig]').studio.stage.cells.map(
        (c) => c.pieces[0].mesh.material.uniforms.range.value.toArray())"""
    )
    assert len(ranges) == 4
    assert all(one == ranges[0] for one in ranges)
    page.get_by_role("radio", name="Before | now").click()
    page.evaluate(DRAW)
    assert page.locator(".cell-label").all_text_contents() == ["before", "now"]


def test_every_kind_and_quantity_is_drawn(context, served):
    problems = []
    page = opened(context, served.site.address, problems)
    kinds = page.get_by_label("Construction", exact=True).locator("option").evaluate_all("(o) => o.map((x) => x.value)")
    for kind in kinds:
        become(page, kind)
        assert state(page, "model.patches[0].kind") == kind
    page.keyboard.press("Control+z")
    quantities = page.get_by_label("Colour by").locator("option").evaluate_all("(o) => o.map((x) => x.value)")
    for key in quantities:
        page.get_by_label("Colour by").select_option(key)
        page.evaluate(DRAW)
    assert len(quantities) > 20
    for label in ("Directions", "Normals", "Smallest radius", "Wireframe", "Contour lines"):
        page.locator(".toggle", has_text=label).first.click()
    for value in ("zebra", "isophotes", "reflection", "highlight"):
        page.locator(f"[aria-label='Light lines'] [data-value={value}]").click()
        page.evaluate(DRAW)
    kept(page, "everything")
    assert problems == []


def test_zero_lines_and_the_smallest_radius_are_where_they_are_on_a_torus(context, served):
    page = opened(context, served.site.address)
    opened_model(page, {"kind": "torus", "major": 1.2, "minor": 1.0, "unit": "mm"})
    for label in ("K = 0", "H = 0", "Smallest radius"):
        page.locator(".toggle", has_text=label).click()
    page.evaluate(DRAW)
    kept(page, "zero-lines")
    away = np.hypot(*segments(page, "zeroK")[:, :2].T)
    assert len(away) > 200
    np.testing.assert_allclose(away, 1.2, atol=2e-3)  # K = cos w / (r (R + r cos w)) = 0 on top and below
    away = np.hypot(*segments(page, "zeroH")[:, :2].T)
    assert len(away) > 200
    np.testing.assert_allclose(away, 0.6, atol=2e-3)  # H = 0 where R + 2 r cos w = 0
    assert "smallest radius 0.2 mm" in page.locator(".status").inner_text()  # R - r, round the hole


def test_the_ends_of_the_scale_follow_percentiles_all_values_or_the_hand(context, served):
    page = opened(context, served.site.address)

    def ends():
        page.evaluate(DRAW)
        return page.evaluate(
            """() => document.querySelector('[data-quintrig]').studio.stage.cells[0].pieces[0]
            .mesh.material.uniforms.range.value.toArray()"""
        )

    values = np.abs(quintrig.analyse(quintrig.load(served.path).surface, *quintrig.grid(150, 150))["gaussian"])
    for cut in (2, 10):
        page.get_by_label("Percentile cut at either end, number").fill(str(cut))
        page.keyboard.press("Enter")
        assert ends()[1] == pytest.approx(np.percentile(values, 100 - cut), rel=1e-3)
    page.get_by_role("radio", name="All", exact=True).click()
    assert ends() == pytest.approx([-values.max(), values.max()], rel=1e-5)
    page.get_by_role("radio", name="Fixed").click()
    page.get_by_label("Lowest colour").fill("-0.0001")
    page.get_by_label("Highest colour").fill("0.0003")
    page.keyboard.press("Enter")
    assert ends() == pytest.approx([-0.0001, 0.0003])


def test_the_light_is_moved(context, served):
    page = opened(context, served.site.address)
    light = """() => document.querySelector('[data-quintrig]').studio.stage.cells[0].pieces[0]
        .mesh.material.uniforms.light.value.toArray()"""
    for kind in ("zebra", "isophotes", "reflection", "highlight"):
        page.locator(f"[aria-label='Light lines'] [data-value={kind}]").click()
        page.locator(".light-ball").scroll_into_view_if_needed()
        ball = page.locator(".light-ball").bounding_box()
        x, y = ball["x"] + ball["width"] / 2, ball["y"] + ball["height"] / 2
        page.mouse.move(x, y)
        page.mouse.down()
        page.evaluate(DRAW)
        assert page.evaluate(light) == pytest.approx([0, 0, 1], abs=0.05)  # from above
        page.mouse.move(x + 0.499 * ball["width"], y)
        page.mouse.up()
        page.evaluate(DRAW)
        assert page.evaluate(light) == pytest.approx([1, 0, 0], abs=0.1)
        kept(page, f"light-{kind}")


def test_a_picture_of_any_size(context, served, tmp_path):
    from PIL import Image

    page = opened(context, served.site.address)
    page.get_by_role("button", name="Save a picture").click()
    page.get_by_label("Width in pixels").fill("900")
    page.get_by_label("Height in pixels").fill("500")
    page.get_by_label("Background").select_option("white")
    with page.expect_download() as waiting:
        page.get_by_role("button", name="Save PNG").click()
    SCREENS.mkdir(parents=True, exist_ok=True)
    target = SCREENS / "picture.png"
    waiting.value.save_as(target)
    image = Image.open(target).convert("RGB")
    assert image.size == (900, 500)
    assert image.getpixel((5, 250)) == (255, 255, 255)
    assert len(image.getcolors(900 * 500)) > 500


def opened_model(page, keys):
    """Open a model, given as the keys of its file, in the page."""
    page.evaluate(
        """async (keys) => { const s = await import('/studio.js');
        document.querySelector('[data-quintrig]').studio.receive(s.fromDict(keys)); }""",
        keys,
    )
    page.evaluate(DRAW)


def exported(page, family, label, folder):
    """Export by the menu; return the file and what the page says of it."""
    page.get_by_role("button", name="Export").click()
    page.locator(".menu-title", has_text=family).wait_for()
    with page.expect_download() as waiting:
        page.get_by_role("menuitem", name=label).click()
        if family in ("Mesh", "Flat pattern"):
            page.get_by_role("button", name="Export", exact=True).last.click()
    target = folder / waiting.value.suggested_filename
    waiting.value.save_as(target)
    told = page.locator(".banner.message").filter(has_text=f"Exported {target.name}")
    told.wait_for()
    return target, told.inner_text()


def test_exports_through_the_server_are_read_by_others(context, served, tmp_path):
    for reader in ("OCP", "ezdxf", "trimesh"):
        pytest.importorskip(reader)
    import ezdxf
    import trimesh

    from quintrig.basis.rational import RIGHT_ANGLE
    from quintrig.exchange.imports import open_model

    page = opened(context, served.site.address)
    page.get_by_label("alpha 1, number").fill("-1")  # what is shown is exported, not what was saved
    page.keyboard.press("Enter")
    page.get_by_label("Colour by").select_option("mean")
    lid = quintrig.Model.from_dict({**quintrig.load(MODEL).to_dict(), "shape": [-1, 1, 0, 0]})

    step, told = exported(page, "CAD", "STEP", tmp_path)
    kept(page, "exported")
    assert step.name == "car_boot_lid.step"
    assert "read back, largest deviation" in told
    again = open_model(step)
    assert again.unit == "mm"
    x = np.linspace(0, 1, 9)
    expected = lid.surface(*np.ix_(RIGHT_ANGLE.backward(x), RIGHT_ANGLE.backward(x)))
    np.testing.assert_allclose(again.surface(*np.ix_(x, x)), expected, rtol=0, atol=1e-9)

    glb, told = exported(page, "Mesh", "glTF", tmp_path)
    assert "chord measured" in told
    assert "colours show mean curvature" in told
    mesh = trimesh.load(glb, force="mesh")
    wide = np.ptp(expected.reshape(-1, 3), axis=0).max()
    assert np.ptp(mesh.vertices, axis=0).max() == pytest.approx(wide / 1000, rel=0.01)  # glTF is in metres
    least = quintrig.analyse(lid.surface, *quintrig.grid(60, 60))["mean"].min()
    assert mesh.vertex_attributes["_MEAN"].min() == pytest.approx(least, rel=0.05)  # curvature goes along

    page.get_by_role("button", name="Export").click()
    refused = page.get_by_role("menuitem", name="DXF")
    refused.filter(has_text="no straight rulings").wait_for()  # a boot lid has no flat pattern
    assert refused.is_disabled()
    page.keyboard.press("Escape")

    archive, told = exported(page, "Control net", "CSV", tmp_path)
    assert archive.suffix == ".zip"
    assert "2 files in one ZIP" in told

    opened_model(page, {"kind": "cylinder", "radius": 10, "height": 40, "unit": "mm", "name": "Pipe"})
    dxf, told = exported(page, "Flat pattern", "DXF", tmp_path)
    assert "changed by" in told
    document = ezdxf.readfile(dxf)
    assert not document.audit().errors
    outline = [e for e in document.modelspace() if e.dxftype() == "LWPOLYLINE"]
    wide = max(np.ptp([p[:2] for p in e.get_points()], axis=0).max() for e in outline)
    assert wide == pytest.approx(20 * np.pi, rel=1e-6)


DEVELOPABLE = {
    "planes": ((1, 0.1, 0.3, -10), (1, 0.3, 0.32, -10.2), (0.9, 0.6, 0.34, -10.3), (0.7, 0.8, 0.33, -10.6),
               (0.5, 0.9, 0.31, -10.7), (0.3, 1, 0.28, -11)),
    "bounds": ((0, 0, 1, 0), (0, 0, 1, -5)), "shape": (0.5, -1),
}  # fmt: skip
TENSOR = {"kind": "tensor", "points": [[[i, j, (i - 2.5) ** 2 + (j - 2.5) ** 2] for j in range(6)] for i in range(6)]}


def test_the_words_on_the_normal_are_pythons(context, served):
    from quintrig.analysis.table import normal_note
    from quintrig.quantities import signs

    names = table.BY_KEY["hk_type"].classes
    words = {row[0]: row[-1] for row in signs.TYPES.rows}
    page = opened(context, served.site.address)
    seen = set()
    for keys in ({"kind": "sphere"}, {"kind": "cylinder"}, {"kind": "torus"}, {"kind": "enneper"}, TENSOR):
        for flip in (False, True):
            opened_model(page, {**keys, "flip": flip})
            surface = quintrig.Model.from_dict({**keys, "flip": flip}).surface
            side = "against" if "against" in normal_note(quintrig.analyse(surface, 0.3, 0.3)) else "along"
            assert page.locator(".status").inner_text().startswith(f"Normal {side} Su × Sv"), (keys["kind"], flip)
            box = page.locator("canvas.view").bounding_box()
            page.mouse.move(box["x"] + 0.42 * box["width"], box["y"] + 0.5 * box["height"])
            until(page, "document.querySelector('[data-quintrig]').studio.store.state.hover !== null")
            page.evaluate(DRAW)
            at = state(page, "hover")
            name = names[int(quintrig.analyse(surface, at["u"], at["v"])["hk_type"])]
            told = page.locator(".tip").inner_text()
            assert name in told
            assert words[name] in told
            seen.add((keys["kind"], side, name))
            page.mouse.move(box["x"] + 5, box["y"] + 5)
            page.evaluate(DRAW)
            page.get_by_label("u to pin").evaluate("e => e.closest('details').open = true")
            page.get_by_role("button", name="Pin the point").click()
            with page.expect_download() as waiting:
                page.get_by_role("button", name="Save the table as CSV").click()
            assert f"normal {side} S_u x S_v" in Path(waiting.value.path()).read_text()
    opened_model(page, {"kind": "developable", **DEVELOPABLE})
    page.get_by_role("button", name="Pin the point").click()
    page.evaluate(DRAW)
    assert float(quintrig.analyse(quintrig.developable(**DEVELOPABLE), 0.5, 0.5)["gaussian"]) != 0.0
    cells = page.locator(".probe tbody td").all_inner_texts()
    assert cells[6] == "0"  # K: rounding is not told as curvature
    assert ("sphere", "against", "peak") in seen
    assert ("sphere", "along", "pit") in seen


def test_every_control_has_a_name_and_shows_its_focus(context, served):
    page = opened(context, served.site.address)
    nameless = page.evaluate(
        """() => [...document.querySelector('[data-quintrig]').shadowRoot
          .querySelectorAll('button, input, select, canvas[tabindex]')]
        .filter((e) => !(e.getAttribute('aria-label') || e.textContent.trim() || e.closest('label')?.textContent))
        .map((e) => e.outerHTML)"""
    )
    assert nameless == []
    seen = set()
    for _ in range(40):
        page.keyboard.press("Tab")
        style = page.evaluate(
            """() => { const e = document.querySelector('[data-quintrig]').shadowRoot.activeElement;
            if (!e) return null;
            const s = getComputedStyle(e);
            return [e.getAttribute('aria-label') || e.textContent, s.outlineStyle, e.type, s.borderColor]; }"""
        )
        if style is None:
            continue
        seen.add(style[0])
        assert style[1] != "none" or style[2] == "range" or "name" in style[0].lower(), style
    assert len(seen) > 20


def test_the_browsers_numbers_are_pythons(context, served):
    page = opened(context, served.site.address)
    script = """async (jobs) => {
      const studio = await import('/studio.js');
      const numbers = (array) => Array.from(array, (x) => (Number.isFinite(x) ? x : String(x)));
      return jobs.map(({ model, u, v }) => {
        const sample = studio.analyse(studio.build(studio.fromDict(model).patches[0]), u, v, true);
        return Object.fromEntries(Object.entries(sample).map(([key, a]) => [key, numbers(a)]));
      });
    }"""
    for job, found in zip(JOBS, page.evaluate(script, JOBS), strict=True):
        surface = quintrig.Model.from_dict(job["model"]).surface
        compare(quintrig.analyse(surface, np.array(job["u"]), np.array(job["v"])), found)


def test_a_report_page_works_from_disk_without_network(context, tmp_path):
    page_file = tmp_path / "report.html"
    model = quintrig.load(MODEL)
    page_file.write_text(
        '<!doctype html><html><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{policy()}">'
        f"<style>.quintrig-viewer {{ height: 600px }} h1 {{ color: red }}</style></head><body><h1>Report</h1>"
        f"{embed(model, 'mean')}</body></html>"
    )
    context.set_offline(True)
    problems, asked = [], []
    context.on("request", lambda request: asked.append(request.url))
    page = opened(context, page_file.as_uri(), problems)
    kept(page, "report")
    assert problems == []
    assert asked == [page_file.as_uri()]
    assert state(page, "settings.quantity") == "mean"
    page.get_by_label("alpha 1, number").fill("-2")
    page.keyboard.press("Enter")
    assert shape_of(page)[0] == -2
    page.set_viewport_size({"width": 900, "height": 700})  # the narrow column of a report, where less is shown
    page.get_by_role("button", name="Save the model").click()
    with page.expect_download() as waiting:
        page.get_by_role("menuitem", name="Download TOML").click()
    target = tmp_path / "saved.toml"
    waiting.value.save_as(target)
    assert quintrig.load(target).patches[0].shape == (-2, 1, 0, 0)
    assert quintrig.load(target).unit == "mm"


def test_without_webgl_there_are_still_pictures(browser, served):
    with browser.browser_type.launch(executable_path=CHROMIUM, args=["--no-sandbox", "--disable-3d-apis"]) as chromium:
        page = opened(chromium.new_context(viewport={"width": 1280, "height": 720}), served.site.address)
        page.get_by_text("has no WebGL").wait_for()
        page.evaluate(DRAW)
        at = page.evaluate("document.querySelector('[data-quintrig]').studio.locate('section[1]')")
        colour = page.evaluate(
            """(at) => { const c = document.querySelector('[data-quintrig]').studio.stage.canvas;
            const b = c.getBoundingClientRect();
            return Array.from(c.getContext('2d').getImageData(at.x - b.x, at.y - b.y, 1, 1).data); }""",
            at,
        )
        assert colour[2] > 150 > 80 > colour[0]  # the blue control point is painted where it can be taken hold of
        kept(page, "no-webgl")
        page.get_by_label("alpha 1, number").fill("-2")
        page.keyboard.press("Enter")
        assert shape_of(page)[0] == -2
        coloured = page.evaluate(
            """() => { const c = document.querySelector('[data-quintrig]').studio.stage.canvas;
            const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
            let n = 0; for (let i = 3; i < d.length; i += 4) n += d[i] > 0; return n / (c.width * c.height); }"""
        )
        assert coloured > 0.1


def test_a_notebook_and_its_kernel_follow_each_other(context, served, tmp_path):
    page = opened(context, served.site.address)
    model = quintrig.load(MODEL).to_dict()
    script = """async (model) => {
      const { default: widget } = await import('/studio.js');
      const listeners = {}; const values = { model, quantity: 'mean', height: 400 };
      window.saves = 0;
      window.kernel = {
        get: (k) => values[k], set: (k, v) => { values[k] = v; }, save_changes: () => { window.saves += 1; },
        on: (e, act) => { listeners[e] = act; }, off: () => {},
        push: (m) => { values.model = m; listeners['change:model'](); },
      };
      const el = document.createElement('div'); el.id = 'cell'; document.body.append(el);
      window.cleanup = widget.render({ model: window.kernel, el });
    }"""
    page.evaluate(script, model)
    page.evaluate(
        """() => { const s = document.getElementById('cell').studio.store;
        const p = s.state.model.patches[0]; s.editPatch({ ...p, shape: [0.5, 1, 0, 0] }); }"""
    )
    until(page, "window.saves === 1")
    assert page.evaluate("window.kernel.get('model').shape") == [0.5, 1, 0, 0]
    page.evaluate("(model) => window.kernel.push(model)", {**model, "shape": [-2, -2, -2, -2]})
    assert page.evaluate("document.getElementById('cell').studio.store.state.model.patches[0].shape") == [-2] * 4
    page.wait_for_timeout(200)
    assert page.evaluate("window.saves") == 1  # what the kernel said is not said back to it
    page.evaluate("window.cleanup()")


def test_the_numbers_come_back_the_same_through_saved_files(context, served):
    page = opened(context, served.site.address)
    for path in sorted(MODEL.parent.glob("*.toml")):
        model = quintrig.load(path).to_dict()
        text = page.evaluate(
            "async (m) => { const s = await import('/studio.js'); return JSON.stringify(s.toDict(s.fromDict(m))); }",
            model,
        )
        assert quintrig.Model.from_dict(json.loads(text)).to_dict() == model
