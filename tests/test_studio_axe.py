"""Accessibility by axe-core in a real browser: no critical or serious finding, in whatever state the studio is."""

import os
from pathlib import Path

import pytest

import quintrig
from quintrig.studio import embed
from test_studio_browser import (  # noqa: F401
    DRAW,
    MODEL,
    browser,
    context,
    opened,
    opened_model,
    served,
    until,
)
from test_studio_browser import pytestmark as in_browser

AXE = Path(__file__).parents[1] / "studio" / "node_modules" / "axe-core" / "axe.min.js"
if not AXE.exists() and os.environ.get("CI") == "true":
    raise RuntimeError(f"{AXE} is missing: make studio/node_modules")
pytestmark = [
    in_browser,
    pytest.mark.skipif(not AXE.exists(), reason="axe-core is not there: make studio/node_modules"),
]

FINDINGS = """async () => {
  const { violations } = await axe.run(document, { resultTypes: ['violations'] });
  const grave = violations.filter((one) => one.impact === 'critical' || one.impact === 'serious');
  const told = (id, { target, any }) => `${id}: ${target.flat().join(' ')} ${any.map((a) => a.message).join(' ')}`;
  return grave.flatMap(({ id, nodes }) => nodes.map((node) => told(id, node).slice(0, 300)));
}"""


def seen(page):
    """What axe finds as the page is; its code comes past the page's policy, which a test may and a page may not."""
    page.evaluate(DRAW)
    if not page.evaluate("typeof axe === 'object'"):
        page.evaluate(AXE.read_text(encoding="utf-8"))
    return page.evaluate(FINDINGS)


def findings(page):
    """What axe finds in light and in dark."""
    found = []
    for theme in ("light", "dark"):
        page.evaluate(f"document.querySelector('[data-quintrig]').studio.store.setting({{ theme: '{theme}' }})")
        until(page, f"document.querySelector('[data-quintrig]').studio.root.dataset.theme === '{theme}'")
        found += [f"{theme}: {one}" for one in seen(page)]
    return found


@pytest.fixture
def page(context, served):  # noqa: F811
    return opened(context, served.site.address)


def test_axe_sees_the_studio(page):
    """A button without a name, put there by hand, is found: the studio's shadow tree is looked into."""
    page.evaluate(
        "document.querySelector('[data-quintrig]').shadowRoot.querySelector('.bar').append(document.createElement('button'))"
    )
    assert sum("button-name" in one for one in findings(page)) == 2


def test_the_studio_at_rest(page):
    assert "\n".join(findings(page)) == ""


def test_every_panel_unfolded_and_every_overlay_on(page):
    page.evaluate(
        """() => { const element = document.querySelector('[data-quintrig]');
        for (const one of element.shadowRoot.querySelectorAll('details')) one.open = true;
        element.studio.store.setting({
          range: 'fixed', contours: true, net: true, curves: true, directions: true, normals: true, combs: 'both',
          zeroK: true, minRadius: true, stripes: 'zebra', section: true, clip: true, wireframe: true, snap: true });
        element.studio.store.set({ pins: [{ patch: 0, u: 0.3, v: 0.4 }] }); }"""
    )
    assert "\n".join(findings(page)) == ""


def test_a_curve_its_text_and_a_mistake_in_it(page):
    opened_model(page, {"kind": "curve", "basis": "sg_bezier", "points": [[0, 0], [1, 3], [4, 2], [5, 0]]})
    page.get_by_text("Model as text").click()
    page.locator(".model-text textarea").fill("kind = 'kurve'")
    page.locator(".model-text .error").wait_for(state="visible")
    page.evaluate("document.querySelector('[data-quintrig]').studio.store.set({ pins: [{ patch: 0, u: 0.3, v: 0 }] })")
    assert "\n".join(findings(page)) == ""


def test_other_quantities(page):
    for key in ("hk_type", "shape_index", "none"):
        page.get_by_label("Colour by").select_option(key)
        assert "\n".join(findings(page)) == "", key


def test_comparisons(page):
    for compare in ("before", "sets"):
        page.evaluate(f"document.querySelector('[data-quintrig]').studio.store.set({{ compare: '{compare}' }})")
        assert "\n".join(findings(page)) == "", compare


def test_kept_variants_and_their_tools(page):
    page.get_by_role("button", name="Keep the model").click()
    page.get_by_label("alpha 2, number").fill("-3")
    page.keyboard.press("Enter")
    assert "\n".join(findings(page)) == ""
    page.get_by_role("button", name="Rename kept 1").click()
    assert "\n".join(findings(page)) == ""


def test_a_lost_server(page, served):  # noqa: F811
    served.stop()
    page.evaluate("void document.querySelector('[data-quintrig]').studio.files.save()")
    page.get_by_role("button", name="Download the model").wait_for()
    assert "\n".join(findings(page)) == ""


def test_menus(page):
    for name in ("Models: presets and starters", "Open a model", "Save the model", "Export"):
        page.get_by_role("button", name=name, exact=True).first.click()
        if name == "Export":
            until(page, "document.querySelector('[data-quintrig]').studio.files.formats.length > 0")
        assert page.locator(".menu:not([hidden])").count() == 1
        assert "\n".join(findings(page)) == "", name
        page.keyboard.press("Escape")


def dialog(page, name):
    if name == "help":
        page.locator("canvas.view").press("?")
    elif name == "picture":
        page.evaluate("void document.querySelector('[data-quintrig]').studio.files.picture()")
    elif name == "save as":
        page.evaluate("void document.querySelector('[data-quintrig]').studio.files.saveAs()")
    elif name == "construction":
        page.get_by_label("Construction", exact=True).select_option("sphere")
    elif name == "export":
        page.get_by_role("button", name="Export").click()
        page.get_by_role("menuitem", name="OBJ").click()
    else:
        page.get_by_label("alpha 1, number").fill("-1")
        page.keyboard.press("Enter")
        page.evaluate("void document.querySelector('[data-quintrig]').studio.files.load('lid.toml')")
    page.locator("dialog[open]").wait_for()


@pytest.mark.parametrize("name", ["help", "picture", "save as", "export", "leave", "construction"])
def test_dialogs(page, name):
    dialog(page, name)
    assert "\n".join(findings(page)) == ""


def test_messages(page):
    for kind in ("error", "note"):
        message = {"kind": kind, "text": f"An {kind} is told", "lines": ["one", "two"]}
        page.evaluate("(message) => document.querySelector('[data-quintrig]').studio.store.set({ message })", message)
        page.get_by_text(message["text"]).wait_for()
        assert "\n".join(findings(page)) == "", kind


def test_several_patches_and_a_chosen_point(page):
    opened_model(page, quintrig.load(MODEL.parent / "rear_of_car.toml").to_dict())
    opened_model(page, quintrig.load(MODEL.parent / "tensor.toml").to_dict())
    page.locator("canvas.view").press("]")
    assert "\n".join(findings(page)) == ""


def test_a_viewer_in_a_page_from_disk(context, tmp_path):  # noqa: F811
    style = "<style>:root { color-scheme: light dark } .quintrig-viewer { height: 600px }</style>"
    head = f'<!doctype html><html lang="en"><head><title>A page</title>{style}</head><body><main>'
    (tmp_path / "page.html").write_text(f"{head}{embed(quintrig.load(MODEL))}</main></body></html>", encoding="utf-8")
    page = context.new_page()
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        page.goto((tmp_path / "page.html").as_uri())
        page.locator(".studio").wait_for()
        assert "\n".join(seen(page)) == "", scheme
