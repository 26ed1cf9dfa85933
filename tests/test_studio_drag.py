"""Dragging in the studio: where it ends depends on where it began and ended, not on how many events told of it."""

# ruff: noqa: F811, fixtures of another module are named by arguments

import numpy as np
import pytest

from test_studio_browser import DRAW, become, browser, context, kept, opened, pytestmark, served, state  # noqa: F401

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


COUNTS = (1, 5, 30)


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
    become(page, "developable")
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
            "(at) => document.querySelector('[data-quintrig]').studio.store.setting(at)",
            {key: start[key] for key in keys},
        )
    assert ends[0] != [start[key] for key in keys]
    assert ends == [ends[0]] * len(COUNTS)


GIZMO = """() => [...document.querySelector('[data-quintrig]').shadowRoot.querySelectorAll('.gizmo polygon')]
    .map((e) => {
    const box = document.querySelector('[data-quintrig]').studio.canvas.getBoundingClientRect();
    const p = e.getAttribute('points').split(' ').map((s) => s.split(',').map(Number));
    return { name: e.getAttribute('class'), x: box.left + p.reduce((s, q) => s + q[0], 0) / p.length,
             y: box.top + p.reduce((s, q) => s + q[1], 0) / p.length }; })"""


@pytest.mark.parametrize(("handle", "flat"), [("section[2]", True), ("trajectory[2]", False)])
def test_a_drag_stays_in_a_plane_and_on_round_numbers(context, served, handle, flat):
    page = opened(context, served.site.address)
    key, i = handle[:-3], 2
    before = np.array(state(page, f"model.patches[0].{key}"))
    normal = np.linalg.svd(before - before.mean(axis=0))[2][-1]
    assert (np.abs((before - before[0]) @ normal).max() < 1e-9 * np.ptp(before)) == flat
    after = np.array(dragged(page, handle, (23, -41), 7)[key][i])
    moving = after != before[i]
    assert moving.any()
    if flat:  # the plane of the curve
        assert abs((after - before[0]) @ normal) < 1e-8 * np.ptp(before)
    assert moving.sum() <= 2  # the plane of two axes
    assert all(round(x, 1) == x for x in after[moving])  # a pixel is worth about 3 mm


def test_the_gizmo_moves_along_an_axis_or_in_a_plane(context, served):
    page = opened(context, served.site.address)
    page.evaluate("document.querySelector('[data-quintrig]').studio.store.set({ selected: 'section[3]' })")
    page.evaluate(DRAW)
    kept(page, "gizmo")
    parts = {part["name"]: part for part in page.evaluate(GIZMO)}
    assert {"arm axis-x", "arm axis-y", "arm axis-z"} <= set(parts)
    for name, part in parts.items():
        before = state(page, "model.patches[0].section")[3]
        drag(page, part, (25, -33), 4)
        after = state(page, "model.patches[0].section")[3]
        moved = {axis for axis, x, y in zip("xyz", before, after, strict=True) if x != y}
        kind, axis = name.split(" axis-")
        assert moved == ({axis} if kind == "arm" else set("xyz") - {axis}), name
        page.locator("canvas.view").focus()
        page.keyboard.press("Control+z")
        page.evaluate(DRAW)
