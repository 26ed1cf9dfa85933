"""The studio's picture: views along the axes, what a pin does to it, light lines, and what is hidden."""

# ruff: noqa: F811, fixtures of another module are named by arguments

import numpy as np
import pytest

from test_studio_browser import DRAW, browser, context, kept, opened, opened_model, pytestmark, served, state  # noqa: F401

STUDIO = "document.querySelector('[data-quintrig]').studio"
# Where the points of the first surface are in the canvas, and the canvas's size, CSS pixels.
SPOTS = f"""() => {{ const s = {STUDIO}, x = s.stage.cells[0].pieces[0].mesh.position, spots = [];
    for (let i = 0; i < x.length; i += 297) {{
      const p = s.stage.project(0, [x[i], x[i + 1], x[i + 2]]);
      spots.push([p.x, p.y]);
    }}
    return {{ spots, size: [s.canvas.clientWidth, s.canvas.clientHeight] }}; }}"""


@pytest.mark.parametrize("size", [(1280, 720), (420, 860)])
def test_views_along_the_axes_are_parallel_and_fit(context, served, size):
    page = opened(context, served.site.address)
    page.set_viewport_size({"width": size[0], "height": size[1]})
    page.evaluate(DRAW)
    eyes = {"Top": (0, 0, 1), "Side": (0, -1, 0), "Back": (1, 0, 0), "Front": (-1, 0, 0), "Bottom": (0, 0, -1)}
    for name, eye in eyes.items():
        page.get_by_role("toolbar", name="View").get_by_role("button", name=name).click()
        page.evaluate(DRAW)
        assert page.evaluate(f"{STUDIO}.stage.orbit.projection") == "orthographic"
        assert page.get_by_role("radio", name="Parallel").get_attribute("aria-checked") == "true"
        towards = page.evaluate(f"{STUDIO}.stage.orbit.axes().towards.toArray()")
        assert np.abs(np.subtract(towards, eye)).max() < 1e-12
        found = page.evaluate(SPOTS)
        spots = np.array(found["spots"])
        assert (spots >= 0).all()
        assert (spots <= found["size"]).all()
        assert (np.ptp(spots, axis=0) / found["size"]).max() > 0.3
        kept(page, f"view-{name.lower()}-{size[0]}")
    page.get_by_role("toolbar", name="View").get_by_role("button", name="Oblique").click()
    page.evaluate(DRAW)
    assert page.evaluate(f"{STUDIO}.stage.orbit.projection") == "perspective"


def test_the_first_pin_does_not_move_the_picture(context, served):
    page = opened(context, served.site.address)
    before = page.evaluate(SPOTS)
    box = page.locator("canvas.view").bounding_box()
    page.mouse.click(box["x"] + 0.42 * box["width"], box["y"] + 0.52 * box["height"])
    page.wait_for_timeout(300)
    page.evaluate(DRAW)
    assert len(state(page, "pins")) == 1
    assert page.evaluate(SPOTS) == before
    kept(page, "first-pin")
    tools, probe = page.locator(".view-tools").bounding_box(), page.locator(".probe").bounding_box()
    assert tools["y"] + tools["height"] <= probe["y"]


def test_a_pole_counts_once(context, served):
    page = opened(context, served.site.address)
    rows = [[[i * np.cos(t), i * np.sin(t), 0.2 * i * i] for t in np.linspace(0, 1.2, 6)] for i in range(6)]
    opened_model(page, {"kind": "tensor", "points": rows})
    assert "1 of 22351 points singular" in page.locator(".status").inner_text()  # of 150 × 150, 149 stand in the pole
    assert "1 undefined" in page.locator(".legend").inner_text()


@pytest.mark.parametrize("size", [(1280, 720), (1100, 720), (420, 860)])
def test_the_buttons_of_light_lines_fit_their_bar(context, served, size):
    page = opened(context, served.site.address)
    page.set_viewport_size({"width": size[0], "height": size[1]})
    bar = page.get_by_role("radiogroup", name="Light lines")
    outside = bar.evaluate(
        """(bar) => { const box = bar.getBoundingClientRect(), panel = bar.closest('.panel').getBoundingClientRect();
        return [...bar.children].filter((e) => { const b = e.getBoundingClientRect();
          return b.right > box.right + 0.5 || b.right > panel.right || b.bottom > box.bottom + 0.5
            || e.scrollWidth > e.clientWidth; })
        .map((e) => e.textContent); }"""
    )
    assert outside == []


@pytest.mark.parametrize("kind", ["reflection", "highlight"])
def test_reflected_lines_do_not_turn_grey(context, served, kind):
    page = opened(context, served.site.address)
    page.evaluate(
        f"(stripes) => {STUDIO}.store.setting({{ stripes, quantity: 'none', density: 24, net: false, curves: false }})",
        kind,
    )
    page.wait_for_timeout(400)
    kept(page, f"lines-{kind}")
    shades = page.evaluate(
        f"""() => {{ const s = {STUDIO}; s.stage.draw();
        const c = document.createElement('canvas'), w = s.stage.canvas.width;
        c.width = w; c.height = s.stage.canvas.height; const x = c.getContext('2d'); x.drawImage(s.stage.canvas, 0, 0);
        const d = x.getImageData(0, 0, w, c.height).data, found = [];
        for (let i = 0; i < d.length; i += 4) if (d[i + 3] > 250) found.push(d[i]); return found; }}"""
    )
    shades = np.array(shades)
    assert len(shades) > 10_000
    dark, light = np.percentile(shades, [2, 98])
    grey = np.mean((shades > dark + 0.3 * (light - dark)) & (shades < dark + 0.7 * (light - dark)))
    assert light - dark > 100
    assert grey < 0.2
    assert np.mean(shades < dark + 0.3 * (light - dark)) > 0.05


def test_hidden_parts_of_the_net_stay_faintly_visible(context, served):
    page = opened(context, served.site.address)
    opened_model(page, {"kind": "tensor", "points": [[[i, j, 0] for j in range(6)] for i in range(6)]})
    hidden = page.evaluate(
        f"""() => {{ const s = {STUDIO}; s.store.setting({{ net: true, curves: false }});
        const o = s.stage.cells[0].pieces[0].overlays;
        // A cube's diagonal below the plane: hidden from above, and not drawn as strongly as what is seen.
        const far = [[-0.5, -0.3, -0.4], [0.5, 0.3, -0.4]], lines = (on) => {{ o.lines.net.begin();
          if (on) o.lines.net.join(...far); o.lines.net.end(); o.points.fill([], []);
          s.stage.orbit.azimuth = -90; s.stage.orbit.elevation = 90; s.stage.draw();
          const c = document.createElement('canvas'); c.width = s.stage.canvas.width; c.height = s.stage.canvas.height;
          const x = c.getContext('2d'); x.drawImage(s.stage.canvas, 0, 0);
          return x.getImageData(0, 0, c.width, c.height).data; }};
        const without = lines(false), given = lines(true); let most = 0;
        for (let i = 0; i < given.length; i += 4) most = Math.max(most, Math.abs(given[i] - without[i]));
        return most; }}"""
    )
    assert 10 < hidden < 110
