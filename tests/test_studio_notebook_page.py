"""The Jupyter view in a real browser, against a kernel played by the test: quantity and height go both ways."""

import pytest

import quintrig
from test_studio_browser import MODEL, browser, context, opened, pytestmark, served, until  # noqa: F401

SCRIPT = """async (model) => {
  const { default: widget } = await import('/studio.js');
  const heard = {}, values = { model, quantity: 'mean', height: 400 };
  window.saved = [];
  let changed = {};
  window.kernel = {
    get: (key) => values[key], set: (key, value) => { values[key] = changed[key] = value; },
    save_changes: () => { window.saved.push(Object.keys(changed).sort().join()); changed = {}; },
    on: (event, act) => { heard[event] = act; }, off: (event) => { delete heard[event]; },
    said: (content) => heard['msg:custom']?.(content),
    push: (key, value) => { values[key] = value; heard['change:' + key]?.(); },
    heard: () => Object.keys(heard).sort(),
  };
  const el = document.createElement('div'); el.id = 'cell'; document.body.prepend(el);
  window.cleanup = widget.render({ model: window.kernel, el });
}"""
COLOUR = "document.getElementById('cell').studio.store.state.settings.quantity"


@pytest.fixture
def page(context, served):  # noqa: F811
    page = opened(context, served.site.address)
    page.evaluate(SCRIPT, quintrig.load(MODEL).to_dict())
    return page


def test_a_quantity_chosen_in_the_page_is_the_kernels(page):
    page.evaluate("document.getElementById('cell').studio.store.setting({ quantity: 'k1' })")
    until(page, "window.saved.length === 1")
    assert page.evaluate("window.kernel.get('quantity')") == "k1"
    assert page.evaluate("window.saved") == ["quantity"]


@pytest.mark.parametrize("key", ["k1", "hk_type", "none"])
def test_a_quantity_set_in_the_kernel_is_shown_and_not_said_back(page, key):
    page.evaluate("(key) => window.kernel.push('quantity', key)", key)
    assert page.evaluate(COLOUR) == key
    page.wait_for_timeout(200)
    assert page.evaluate("window.saved") == []


def test_an_unknown_quantity_changes_nothing(page):
    page.evaluate("window.kernel.push('quantity', 'nonsense')")
    assert page.evaluate(COLOUR) == "mean"


def test_a_height_set_in_the_kernel_is_the_views_and_not_said_back(page):
    assert page.evaluate("document.getElementById('cell').offsetHeight") == 400
    page.evaluate("window.kernel.push('height', 600)")
    assert page.evaluate("document.getElementById('cell').offsetHeight") == 600
    page.wait_for_timeout(200)
    assert page.evaluate("window.saved") == []


@pytest.mark.parametrize(("by", "height"), [(120, 520), (-300, 240)])
def test_a_height_dragged_to_in_the_page_is_the_kernels(page, by, height):
    box = page.locator("#cell").bounding_box()
    corner = (box["x"] + box["width"] - 4, box["y"] + box["height"] - 4)
    page.mouse.move(*corner)
    page.mouse.down()
    page.mouse.move(corner[0], corner[1] + by, steps=5)
    page.mouse.up()
    until(page, f"window.kernel.get('height') === {height}")
    assert page.evaluate("document.getElementById('cell').offsetHeight") == height


def test_after_the_view_is_gone_nothing_is_heard(page):
    assert page.evaluate("window.kernel.heard()") == ["change:height", "change:model", "change:quantity", "msg:custom"]
    page.evaluate("window.cleanup()")
    assert page.evaluate("window.kernel.heard()") == []
