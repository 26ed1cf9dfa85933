"""Variants side by side in the studio: kept ones, and the four sets of shape parameters."""

# ruff: noqa: F811, fixtures of another module are named by arguments

from test_studio_browser import DRAW, browser, context, kept, opened, pytestmark, served, shape_of, state  # noqa: F401


def typed(page, label, value):
    page.get_by_label(label, exact=True).fill(value)
    page.keyboard.press("Enter")
    page.evaluate(DRAW)


def test_kept_variants_are_named_restored_and_deleted_and_say_what_differs(context, served):
    page = opened(context, served.site.address)
    before = shape_of(page)
    page.get_by_role("button", name="Keep the model").click()
    page.evaluate(DRAW)
    assert page.locator(".differs").all_inner_texts() == ["same as now"]
    typed(page, "alpha 2, number", "-4")
    assert page.locator(".differs").all_inner_texts() == [f"now: α2 {before[2]:g} → −4".replace(" -", " −")]
    page.get_by_role("button", name="Keep the model").click()
    page.get_by_role("button", name="Rename kept 1").click()
    page.get_by_label("Name of the variant").fill("soft rear")
    page.keyboard.press("Enter")
    page.evaluate(DRAW)
    assert page.locator(".cell-label").all_text_contents() == ["now", "soft rear", "kept 2"]
    kept(page, "variants")
    page.get_by_role("button", name="Restore soft rear").click()
    assert shape_of(page) == before
    page.locator("canvas.view").focus()
    page.keyboard.press("Control+z")  # restoring is a step like any other
    assert shape_of(page)[2] == -4
    page.get_by_role("button", name="Delete soft rear").click()
    page.evaluate(DRAW)
    assert page.locator(".cell-label").all_text_contents() == ["now", "kept 2"]
    page.get_by_role("button", name="Delete kept 2").click()
    assert state(page, "compare") == "off"
    for _ in range(6):
        page.get_by_role("button", name="Keep the model").click()
    assert [one["label"] for one in state(page, "kept")] == [
        f"kept {i}" for i in range(1, 6)
    ]  # none is dropped unasked


def test_shape_sliders_rest_while_four_sets_are_shown(context, served):
    page = opened(context, served.site.address)
    page.get_by_role("radio", name="Four sets").click()
    page.evaluate(DRAW)
    assert page.get_by_label("alpha 2", exact=True).is_disabled()
    assert page.get_by_label("alpha 2, number").is_disabled()
    assert page.locator(".shape .chip").first.is_disabled()
    assert "Four sets are shown" in page.locator(".shape").inner_text()
    page.get_by_role("radio", name="One", exact=True).click()
    page.evaluate(DRAW)
    assert page.get_by_label("alpha 2", exact=True).is_enabled()
