"""Exports by the menu in a real browser: what is offered, what is asked, and that colours are those shown."""

import json
import re

import pytest

from test_studio_browser import (  # noqa: F401
    browser,
    context,
    exported,
    kept,
    opened,
    opened_model,
    pytestmark,
    served,
    until,
)

CATENOID = {"kind": "catenoid", "waist": 1, "height": 3, "unit": "mm", "name": "Neck"}
STUDIO = "document.querySelector('[data-quintrig]').studio"


@pytest.fixture
def page(context, served):  # noqa: F811
    page = opened(context, served.site.address)
    opened_model(page, CATENOID)
    return page


@pytest.mark.parametrize(
    ("settings", "low"),
    [
        ({"range": "fixed", "low": -0.6, "high": 0.2}, -0.6),
        ({"range": "full"}, -0.9998),
        ({"range": "robust", "percentile": 20}, None),
    ],
)
def test_a_mesh_has_the_colours_shown(page, tmp_path, settings, low):
    page.evaluate(f"{STUDIO}.store.setting({json.dumps({'quantity': 'gaussian', **settings})})")
    until(page, f"{STUDIO}.range !== null && !{STUDIO}.stale")
    ends = page.evaluate(f"[{STUDIO}.range.low, {STUDIO}.range.high]")
    if low is not None:
        assert ends[0] == pytest.approx(low, rel=1e-4)
    _, told = exported(page, "Mesh", "OBJ", tmp_path)
    found = re.search(r"colours show Gaussian curvature K, (\S+) to (\S+) 1/mm²", told)
    assert [float(found[1]), float(found[2])] == pytest.approx(ends, rel=1e-3)


def test_no_colour_is_no_colour(page, tmp_path):
    page.get_by_label("Colour by").select_option("none")
    _, told = exported(page, "Mesh", "OBJ", tmp_path)
    assert "colours" not in told


def test_the_tolerance_that_is_typed_is_kept(page, tmp_path):
    def at(tolerance):
        page.get_by_role("button", name="Export").click()
        with page.expect_download() as waiting:
            page.get_by_role("menuitem", name="STL").click()
            page.get_by_label("Tolerance in mm").fill(tolerance)
            kept(page, "export")
            page.keyboard.press("Enter")
        return waiting.value.path().stat().st_size

    assert at("0.1") < at("0.01") < at("0.001")


def test_a_tolerance_that_is_none_is_asked_for_again(page):
    page.get_by_role("button", name="Export").click()
    page.get_by_role("menuitem", name="STL").click()
    page.get_by_label("Tolerance in mm").fill("-1")
    page.locator("dialog").get_by_role("button", name="Export").click()
    page.get_by_role("alert").filter(has_text="greater than 0").wait_for()
    page.keyboard.press("Escape")
    assert page.locator("dialog").count() == 0


def test_what_cannot_be_is_disabled_with_the_reason(page):
    page.get_by_role("button", name="Export").click()
    refused = page.get_by_role("menuitem", name="SVG")
    refused.filter(has_text="no straight rulings").wait_for()
    assert refused.is_disabled()
    assert page.get_by_role("menuitem", name="CSV").is_disabled()
    assert "no control points" in page.get_by_role("menuitem", name="CSV").inner_text()
    assert page.get_by_role("menuitem", name="STL").is_enabled()
    kept(page, "export-menu")
    opened_model(page, {"kind": "cylinder", "radius": 10, "height": 40, "unit": "mm", "name": "Pipe"})
    page.keyboard.press("Escape")
    page.get_by_role("button", name="Export").click()
    until(page, f"{STUDIO}.files.formats.every((one) => one.suffix !== '.svg' || !one.reason)")
    assert page.get_by_role("menuitem", name="SVG").is_enabled()
