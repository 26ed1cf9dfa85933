"""Work in the studio and the file it belongs to: nothing is written over another file, and no key is lost."""

# ruff: noqa: F811, fixtures of another module are named by arguments

import numpy as np
import pytest

import quintrig
from test_studio_browser import (  # noqa: F401
    DRAW,
    MODEL,
    Served,
    browser,
    context,
    kept,
    opened,
    opened_model,
    pytestmark,
    served,
    shape_of,
    state,
    until,
)

STORE = "document.querySelector('[data-quintrig]').studio.store"
OTHER = (MODEL.parent / "rear_of_car.toml").read_text(encoding="utf-8")


def typed(page, value, label="alpha 1, number"):
    page.get_by_label(label, exact=True).fill(str(value))
    page.keyboard.press("Enter")


def other(page, served):
    """Write a second file into the folder and open it from the menu."""
    (served.path.parent / "other.toml").write_text(OTHER, encoding="utf-8")
    page.evaluate("document.querySelector('[data-quintrig]').studio.files.look()")
    page.get_by_role("button", name="Open a model").click()
    page.get_by_role("menuitem", name="other.toml").click()
    until(page, f"{STORE}.state.source?.name === 'other.toml'")


def test_restored_work_is_saved_to_its_own_file(context, served):
    page = opened(context, served.site.address)
    lid = served.path.read_bytes()
    other(page, served)
    typed(page, -2.5)
    changed = state(page, "model.patches")
    page.wait_for_timeout(600)
    page.reload()
    page.get_by_role("alert").filter(has_text="other.toml").wait_for()
    assert state(page, "source.name") == "other.toml"  # a reload comes back to it
    page.get_by_role("button", name="Restore it").click()
    assert state(page, "model.patches") == changed
    assert state(page, "source.name") == "other.toml"
    page.keyboard.press("Control+s")
    page.get_by_text("Saved other.toml").wait_for()
    assert served.path.read_bytes() == lid
    assert quintrig.load(served.path.parent / "other.toml").patches[0].shape[0] == -2.5


def test_a_draft_of_another_file_brings_its_file_along(context, served):
    page = opened(context, served.site.address)
    lid = served.path.read_bytes()
    other(page, served)
    typed(page, -2.5)
    page.wait_for_timeout(600)
    page.close()
    page = opened(context, served.site.address)  # a new tab: lid.toml is open, and the draft is offered
    assert state(page, "source.name") == "lid.toml"
    page.get_by_role("button", name="Restore it").click()
    assert state(page, "source.name") == "other.toml"
    page.keyboard.press("Control+z")  # back to the file before, and on again
    assert state(page, "source.name") == "lid.toml"
    page.keyboard.press("Control+Shift+Z")
    assert state(page, "source.name") == "other.toml"
    page.keyboard.press("Control+s")
    page.get_by_text("Saved other.toml").wait_for()
    assert served.path.read_bytes() == lid


def test_a_draft_of_a_version_that_is_gone_is_not_written_over_the_new_one(context, served):
    page = opened(context, served.site.address)
    typed(page, -2.5)
    page.wait_for_timeout(600)
    page.close()
    served.path.write_text('kind = "torus"\n')
    page = opened(context, served.site.address)
    page.get_by_role("button", name="Restore it").click()
    page.keyboard.press("Control+s")
    page.get_by_role("dialog", name="The file is another one now").wait_for()
    page.get_by_role("button", name="Cancel").click()
    assert served.path.read_text() == 'kind = "torus"\n'


def test_banners_belong_to_their_file(context, served):
    page = opened(context, served.site.address)
    typed(page, -2.5)
    page.wait_for_timeout(600)
    page.close()
    page = opened(context, served.site.address)
    page.get_by_role("alert").filter(has_text="lid.toml").wait_for()
    other(page, served)
    page.get_by_role("alert").filter(has_text="lid.toml").wait_for(state="detached")


def test_what_has_no_file_is_never_written_to_one_unasked(context, served):
    page = opened(context, served.site.address)
    lid = served.path.read_bytes()
    opened_model(page, {"kind": "torus"})
    page.keyboard.press("Control+s")
    page.get_by_role("dialog", name="Save as").wait_for()
    page.get_by_label("File name").fill("lid.toml")
    page.get_by_role("dialog").get_by_role("button", name="Save", exact=True).click()
    page.get_by_role("dialog", name="The file is another one now").wait_for()
    page.get_by_role("button", name="Cancel").click()
    assert served.path.read_bytes() == lid


def test_keys_work_wherever_the_focus_is(context, served):
    page = opened(context, served.site.address)
    focused = ["canvas.view", "button[aria-label='Fit (F)']", ".toggle input", "select", "body"]
    for where in focused:
        typed(page, -2)
        if where == "body":
            page.evaluate("document.querySelector('[data-quintrig]').shadowRoot.activeElement?.blur()")
        else:
            page.locator(f"{where}:visible").first.focus()
        page.keyboard.press("Control+z")
        assert shape_of(page)[0] == 1, where
        page.keyboard.press("Control+y")
        assert shape_of(page)[0] == -2, where
        page.keyboard.press("Control+z")
        if where != "select":  # a letter chooses there
            net = state(page, "settings.net")
            page.keyboard.press("n")
            assert state(page, "settings.net") is not net, where


def test_field_and_model_never_differ(context, served):
    page = opened(context, served.site.address)
    field = page.get_by_label("alpha 1, number", exact=True)
    typed(page, -2)  # the focus stays in the field
    assert shape_of(page)[0] == -2
    page.keyboard.press("Control+z")
    page.evaluate(DRAW)
    assert (field.input_value(), shape_of(page)[0]) == ("1", 1)
    page.keyboard.press("Control+Shift+Z")
    page.evaluate(DRAW)
    assert (field.input_value(), shape_of(page)[0]) == ("-2", -2)
    field.fill("-3")  # not committed: the browser's own undo, and the model stays
    page.keyboard.press("Control+z")
    assert shape_of(page)[0] == -2
    field.fill("-3")
    page.keyboard.press("Escape")
    assert (field.input_value(), shape_of(page)[0]) == ("-2", -2)
    net = state(page, "settings.net")
    field.press("n")
    assert state(page, "settings.net") is net


POINTS = """async (keys) => { const s = await import('/studio.js');
    const u = [0, 0.13, 0.5, 0.77, 1], v = [0.2, 1, 0.41, 0.03, 0.6];
    const points = (patch) => Array.from(s.analyse(s.build(patch), u, v, true, ['point']).point);
    const patch = s.fromDict(keys).patches[0];
    return ['tensor', 'nurbs'].map((kind) => { const found = s.converted(patch, kind);
      return found && [points(patch), points(s.fromDict(found).patches[0]), found.flip ?? false]; }); }"""
ROW = [[0, 0, 0], [1, 0, 1], [2, 1, 1.5], [3, 0, 1], [4, -1, 0.5], [5, 0, 0]]
LINE = [[0.1 * x, y, z + 2] for x, y, z in ROW]
FLAT = [[1 + 0.2 * i, 0.3 * i * i] for i in range(6)]
EXACT = [
    {"kind": "symmetric", "points": [ROW, LINE, ROW[::-1]], "mirror": [1, 0.5, 0, 4], "shape": [1, -2, 0.5, -4]},
    {"kind": "swept", "section": ROW, "trajectory": LINE, "shape": [1, -2, 0.5, -4], "flip": True},
    {"kind": "swung", "profile": FLAT, "trajectory": FLAT[::-1], "scale": 0.4, "shape": [-3, 1, 0, 0.5]},
    {"kind": "swept", "section": ROW, "trajectory": LINE[:3], "basis": "bernstein"},
    {"kind": "ruled", "first": ROW, "second": LINE, "basis": "bernstein"},
]


@pytest.mark.parametrize("keys", EXACT, ids=lambda keys: f"{keys['kind']}-{keys.get('basis', '')}")
def test_exact_conversions_keep_every_point(context, served, keys):
    page = opened(context, served.site.address)
    tensor, nurbs = page.evaluate(POINTS, keys)
    assert (nurbs is not None) == (keys.get("basis") == "bernstein")
    for before, after, flip in filter(None, [tensor, nurbs]):
        assert np.abs(np.subtract(before, after)).max() < 1e-13 * np.abs(before).max()
        assert flip == keys.get("flip", False)
    opened_model(page, keys)
    page.get_by_label("Construction", exact=True).select_option("tensor")
    assert page.locator("dialog[open]").count() == 0
    assert state(page, "model.patches[0].kind") == "tensor"
    page.keyboard.press("Control+z")
    assert state(page, "model.patches[0].kind") == keys["kind"]


def test_another_surface_is_asked_for_first(context, served):
    page = opened(context, served.site.address)
    opened_model(page, {"kind": "ruled", "first": ROW, "second": LINE})
    before = state(page, "model.patches[0]")
    chosen = page.get_by_label("Construction", exact=True)
    for kind in ("tensor", "developable", "sphere"):
        chosen.select_option(kind)
        page.get_by_role("dialog", name="Another surface?").wait_for()
        kept(page, "another-surface")
        page.get_by_role("button", name="Keep it").click()
        assert state(page, "model.patches[0]") == before
        assert chosen.input_value() == "ruled"
    chosen.select_option("sphere")
    page.get_by_role("button", name="Start anew").click()
    until(page, f"{STORE}.state.model.patches[0].kind === 'sphere'")


@pytest.mark.parametrize("again", [False, True])
def test_a_tab_whose_server_is_gone_says_so_and_offers_the_model(context, tmp_path, again):
    first = Served(tmp_path)
    page = opened(context, first.site.address)
    typed(page, -2.5)
    first.stop()
    second = Served(tmp_path, port=first.site.port) if again else None
    try:
        page.keyboard.press("Control+s")
        told = page.locator(".banner.message.error")
        told.filter(has_text="started anew" if again else "has stopped").wait_for()
        assert "quintrig view" in told.inner_text()
        kept(page, f"server-gone-{again}")
        with page.expect_download() as waiting:
            page.get_by_role("button", name="Download the model").click()
        waiting.value.save_as(tmp_path / "kept.toml")
        assert quintrig.load(tmp_path / "kept.toml").patches[0].shape[0] == -2.5
        second = second or Served(tmp_path, port=first.site.port)
        opened(context, second.site.address).close()  # the address that quintrig view printed
        page.get_by_role("button", name="Try again").click()
        page.get_by_text("Connected to the studio's server again").wait_for()
        page.keyboard.press("Control+s")
        page.get_by_text("Saved lid.toml").wait_for()
        assert quintrig.load(first.path).patches[0].shape[0] == -2.5
    finally:
        if second:
            second.stop()
