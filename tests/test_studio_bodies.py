"""Several patches edited together in the studio: seams, shared points, joins, and patches added and taken away."""

# ruff: noqa: F811, fixtures of another module are named by arguments

import pytest

import quintrig
from test_studio_browser import browser, context, kept, opened, pytestmark, served, state, until  # noqa: F401
from test_studio_drag import LOCATE, drag


def strip(name, x, lift, *, turned=False):
    points = [[[x + 20.0 * i, 20.0 * j, lift * i * j] for j in range(6)] for i in range(6)]
    return {"name": name, "kind": "tensor", "points": [row[::-1] for row in points] if turned else points}


def two(join=None, *, turned=False):
    keys = {"name": "pair", "unit": "mm", "patch": [strip("a", 0, 0.1), strip("b", 100, 0.3, turned=turned)]}
    for row, j in zip(keys["patch"][0]["points"][5], range(6), strict=True):
        keys["patch"][1]["points"][0][5 - j if turned else j] = list(row)
    if join:
        keys["join"] = [{"first": "a:u1", "second": "b:u0", "order": join}]
        keys = quintrig.Model.from_dict(keys).to_dict()
    return keys


def shown(context, served, keys):
    """A studio that shows a model of several patches."""
    page = opened(context, served.site.address)
    page.evaluate(
        """({ name, unit, patch, join }) => document.querySelector('[data-quintrig]').studio.store.edit(
        { name, unit, patches: patch, ...(join ? { join } : {}) })""",
        keys,
    )
    page.wait_for_function("() => document.querySelector('[data-quintrig]').studio.stage.cells[0].pieces.length > 1")
    page.wait_for_timeout(900)
    return page


def seams(page):
    return page.evaluate(
        "() => document.querySelector('[data-quintrig]').studio.painter.seams.map(({ points, ...rest }) => rest)"
    )


def keys_of(page):
    found = state(page, "model")
    table = {"name": found["name"], "unit": found["unit"], "patch": found["patches"]}
    return table | ({"join": found["join"]} if "join" in found else {})


@pytest.mark.parametrize("turned", [False, True])
def test_a_shared_point_moves_both_and_one_undo_brings_both_back(context, served, turned):
    page = shown(context, served, two(turned=turned))
    before = keys_of(page)
    drag(page, page.evaluate(LOCATE, "points[5][3]"), (5, -40), 4)
    after = keys_of(page)
    moved = after["patch"][0]["points"][5][3]
    assert moved != before["patch"][0]["points"][5][3]
    assert after["patch"][1]["points"][0][2 if turned else 3] == moved
    (seam,) = seams(page)
    assert seam["order"] == "G0"
    assert seam["reversed"] == turned
    page.locator("canvas.view").focus()
    page.keyboard.press("Control+z")
    assert keys_of(page) == before


@pytest.mark.parametrize("order", ["G1", "G2", "G3"])
@pytest.mark.parametrize("handle", ["points[5][3]", "points[4][0]"])
def test_a_join_keeps_its_order_under_the_pointer(context, served, order, handle):
    page = shown(context, served, two(order))
    before = keys_of(page)
    drag(page, page.evaluate(LOCATE, handle), (5, -40), 4)
    after = keys_of(page)
    assert after["patch"][1] != before["patch"][1]
    (seam,) = seams(page)
    assert seam["order"] >= order
    (join,) = quintrig.Model.from_dict({k: v for k, v in after.items() if k != "join"}).joins()
    assert join.order >= order
    # What Python makes of the saved model is what was seen.
    carried = quintrig.Model.from_dict(after).patch("b").surface.net
    assert carried == pytest.approx(quintrig.Model.from_dict({**after["patch"][1]}).surface.net, abs=1e-9)


def test_two_clicked_sides_are_joined_and_released(context, served):
    page = shown(context, served, two())
    click = """(sides) => { const { stage, canvas, store, frame } = document.querySelector('[data-quintrig]').studio;
        const box = canvas.getBoundingClientRect();
        return sides.map(([patch, i, j]) => { const s = store.state.model.patches[patch].points[i][j];
        const p = stage.project(0, s.map((x, k) => (x - frame.centre[k]) * frame.scale));
        return { x: box.left + p.x, y: box.top + p.y }; }); }"""
    page.evaluate("() => document.querySelector('[data-quintrig]').studio.store.setting({ net: false })")
    page.locator(".toggle", has_text="Join or release").click()
    for rules in ([{"first": "a:u1", "second": "b:u0", "order": "G1"}], None):
        for at in page.evaluate(click, [[0, 4, 2], [1, 1, 2]]):
            page.mouse.click(at["x"], at["y"])
            page.wait_for_timeout(200)
        assert keys_of(page).get("join") == rules
        until(page, "document.querySelector('[data-quintrig]').studio.painter.seams[0].order >= 'G1'")


def test_patches_are_added_doubled_mirrored_and_taken_away_and_all_is_undone(context, served):
    page = shown(context, served, two("G1"))
    before = keys_of(page)
    names = ["a", "b"]
    for press in ("Add", "Duplicate", "Mirror x"):
        page.locator(".body-tools button", has_text=press).click()
        now = [patch["name"] for patch in keys_of(page)["patch"]]
        assert len(now) == len(set(now)) == len(names) + 1
        names = now
    assert keys_of(page)["patch"][-1]["points"][2][1][0] == -keys_of(page)["patch"][-2]["points"][2][1][0]
    page.locator(".patch").nth(1).click()
    page.locator(".body-tools button", has_text="Delete").click()
    assert "join" not in keys_of(page)
    assert [patch["name"] for patch in keys_of(page)["patch"]] == [names[0], *names[2:]]
    page.locator("canvas.view").focus()
    for _ in range(4):
        page.keyboard.press("Control+z")
    assert keys_of(page) == before
