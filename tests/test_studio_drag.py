"""Dragging in the studio: where it ends depends on where it began and ended, not on how many events told of it."""

# ruff: noqa: F811, fixtures of another module are named by arguments

import pytest

from test_studio_browser import DRAW, browser, context, opened, pytestmark, served, state  # noqa: F401

LOCATE = "(id) => document.querySelector('[data-quintrig]').studio.locate(id)"


def drag(page, start, by, steps):
    """Press at a point, move by (x, y) pixels in so many pointer events, and let go."""
    page.mouse.move(start["x"], start["y"])
    page.mouse.down()
    page.mouse.move(start["x"] + by[0], start["y"] + by[1], steps=steps)
    page.mouse.up()


def dragged(page, handle, by, steps):
    """The active patch after a drag of a control point, which is undone again."""
    drag(page, page.evaluate(LOCATE, handle), by, steps)
    after = state(page, "model.patches[0]")
    page.locator("canvas.view").focus()
    page.keyboard.press("Control+z")
    return after


def snap(page, step):
    page.get_by_label("Snap step").fill(str(step))
    page.keyboard.press("Enter")
    page.locator(".toggle", has_text="Snap to").click()


COUNTS = (1, 5, 20, 100)


@pytest.mark.parametrize(("step", "locks"), [(0, ""), (10, ""), (70, "xy")])
def test_a_drag_ends_at_one_place_however_many_events_tell_of_it(context, served, step, locks):
    page = opened(context, served.site.address)
    if step:
        snap(page, step)
    for axis in locks:
        page.locator(".locks .toggle", has_text=axis).click()
    before = state(page, "model.patches[0].section")[2]
    ends = [dragged(page, "section[2]", (31, -83), count)["section"][2] for count in COUNTS]
    assert ends[0] != before
    assert ends == [ends[0]] * len(COUNTS)
    if step:
        assert all(x % step == 0 for x, y in zip(ends[0], before, strict=True) if x != y)


def test_a_plane_of_a_developable_ends_at_one_place(context, served):
    page = opened(context, served.site.address)
    page.get_by_label("Construction", exact=True).select_option("developable")
    page.evaluate(DRAW)  # the picture is framed anew
    for step in (0, 0.25):
        if step:
            snap(page, step)
        before = state(page, "model.patches[0].planes")[2]
        ends = [dragged(page, "planes[2]", (12, -37), count)["planes"][2] for count in COUNTS]
        assert ends[0][:3] == before[:3]
        assert ends[0] != before
        assert ends == [ends[0]] * len(COUNTS)
        if step:
            assert ends[0][3] % step == 0


@pytest.mark.parametrize("grip", ["move", "tilt"])
def test_a_section_plane_ends_at_one_place(context, served, grip):
    page = opened(context, served.site.address)
    page.locator("summary", has_text="Section").click()
    page.locator(".toggle", has_text="Section by a plane").click()
    keys = ("sectionAt", "sectionAzimuth", "sectionTilt")
    start = state(page, "settings")
    ends = []
    for count in COUNTS:
        drag(page, page.evaluate(LOCATE, grip), (43, -29), count)
        ends.append([state(page, "settings")[key] for key in keys])
        page.evaluate(
            "(at) => document.querySelector('[data-quintrig]').studio.store.setting(at)", {key: start[key] for key in keys}
        )
    assert ends[0] != [start[key] for key in keys]
    assert ends == [ends[0]] * len(COUNTS)
