"""The studio shows of a trimmed face what its loops leave: the picture, its statistics, and what can be clicked."""

# ruff: noqa: F811, fixtures of another module are named by arguments

import numpy as np

from quintrig.analysis.summary import summarise
from quintrig.geometry.nurbs import nurbs
from test_studio_browser import DRAW, browser, context, kept, opened, opened_model, pytestmark, served, state  # noqa: F401

STUDIO = "document.querySelector('[data-quintrig]').studio"


def circle(radius, count=200, u=0.5, v=0.5):
    t = 2 * np.pi * np.arange(count) / count
    return np.stack([u + radius * np.cos(t), v + radius * np.sin(t)], axis=1).tolist()


def ring():
    """A bump with a round outline and a round hole; its steepest and sharpest places are cut off."""
    t = np.linspace(-1, 1, 5)
    points = [[[x, y, 3 * x**4 + 2 * y**4] for y in t] for x in t]
    knots = [0, 0, 0, 0.4, 0.7, 1, 1, 1]
    loops = [circle(0.42), circle(0.2)[::-1]]
    return {"kind": "nurbs", "degrees": [2, 2], "knots": [knots] * 2, "points": points, "trim": loops}


def settle(page, setting):
    page.evaluate(
        f"() => {{ const {{ store }} = {STUDIO}; "
        f"store.set({{ settings: {{ ...store.state.settings, {setting} }} }}); }}"
    )


def shown(page, u, v):
    """Where a point of the surface is in the page, CSS pixels."""
    script = f"""async ([u, v]) => {{
        const s = {STUDIO}, {{ analyse, build }} = await import('/studio.js'), {{ patch }} = s.stage.cells[0].pieces[0];
        const p = Array.from(analyse(build(patch), [u], [v], true, ['point']).point);
        const at = s.stage.project(0, p.map((x, i) => (x - s.frame.centre[i]) * s.frame.scale));
        const r = s.canvas.getBoundingClientRect();
        return [at.x + r.x, at.y + r.y]; }}"""
    return page.evaluate(script, [u, v])


def test_a_trimmed_face_is_shown_without_what_its_loops_cut_off(context, served):
    page = opened(context, served.site.address)
    opened_model(page, ring())
    page.get_by_role("toolbar", name="View").get_by_role("button", name="Top").click()
    page.wait_for_timeout(600)
    page.evaluate(DRAW)
    kept(page, "trimmed-ring")
    # Beside the loops the shader leaves what is on the face, to a pixel or two.
    pixels = f"""async (spots) => {{
        const s = {STUDIO}, b = await s.stage.picture(s.canvas.clientWidth, s.canvas.clientHeight, null);
        const r = s.canvas.getBoundingClientRect(), c = b.getContext('2d');
        return spots.map(([x, y]) => c.getImageData(Math.round(x - r.x), Math.round(y - r.y), 1, 1).data[3]); }}"""
    settle(page, "net: false")
    page.evaluate(DRAW)
    turns = np.linspace(0.3, 6.3, 9)[:-1]
    for radius, covered in ((0.185, 0), (0.215, 255), (0.405, 255), (0.435, 0)):
        at = [shown(page, 0.5 + radius * np.cos(t), 0.5 + radius * np.sin(t)) for t in turns]
        assert page.evaluate(pixels, at) == [covered] * len(turns), radius
    # Only what is drawn can be clicked.
    for radius, pins in ((0.1, 0), (0.3, 1), (0.46, 1), (0.25, 2)):
        page.mouse.click(*shown(page, 0.5 + radius, 0.5))
        page.wait_for_timeout(350)
        assert len(state(page, "pins")) == pins, radius
    for pin, radius in zip(state(page, "pins"), (0.3, 0.25), strict=True):
        assert abs(pin["u"] - 0.5 - radius) < 0.02
        assert abs(pin["v"] - 0.5) < 0.02
    # A pin set by numbers off the face has no values, as in the tables.
    page.get_by_label("u to pin").fill("0.5")
    page.get_by_label("v to pin").fill("0.5")
    page.get_by_role("button", name="Pin the point at these parameters").click()
    rows = page.locator(".probe tbody tr")
    assert rows.count() == 3
    assert "outside the trimmed face" in rows.nth(2).inner_text()
    assert "outside" not in rows.nth(0).inner_text()


def test_statistics_are_those_of_the_trimmed_face(context, served):
    page = opened(context, served.site.address)
    page.evaluate(
        f"() => {STUDIO}.store.set({{ settings: {{ ...{STUDIO}.store.state.settings, quantity: 'gaussian' }} }})"
    )
    opened_model(page, ring())
    keys = ring()
    surface = nurbs(keys["points"], None, keys["degrees"], keys["knots"], trim=keys["trim"])
    found = page.evaluate(f"() => {{ const r = {STUDIO}.range; return [r.least, r.most]; }}")
    k = summarise(surface).extremes["gaussian"]
    whole = summarise(surface.carrier).extremes["gaussian"]
    assert whole.minimum.value < 0.5 * k.minimum.value
    assert np.allclose(found, [k.minimum.value, k.maximum.value], rtol=0.03)
