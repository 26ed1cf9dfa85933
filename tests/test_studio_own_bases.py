"""Any basis in the studio: chosen for each direction, a slider for every parameter, written by the user live."""

# ruff: noqa: F811, fixtures of another module are named by arguments

import tomllib

import numpy as np
import pytest

import quintrig
from quintrig.model.model import Model
from quintrig.studio import embed
from quintrig.support.errors import ModelError
from test_studio_browser import DRAW, Served, browser, context, kept, opened, pytestmark, state, until  # noqa: F401

OWN = """name = "Own"
unit = "mm"
kind = "tensor"
basis = ["mine", "lambda_bezier"]
points = [
    [[0, 0, 0], [0, 10, 5], [0, 20, 0], [0, 30, 3]],
    [[10, 0, 5], [10, 10, 15], [10, 20, 9], [10, 30, 0]],
    [[20, 0, 0], [20, 10, 0], [20, 20, 5], [20, 30, 0]],
]

[bases.mine]
functions = ["r^2*(1-lam*t)", "2*r*t+lam*r^2*t+mu*t^2*r", "t^2*(1-mu*r)"]
parameters = { lam = [-1, 1], mu = [-2, 1, 0.5] }
"""
MISTAKES = (("t^2*(1-mu*r)", "t^2*(1-mo*r)"), ("r^2*(1-lam*t)", "r^2*(1-lam*t"), ("t^2*(1-mu*r)", "t^2/(t-0.5)"))


@pytest.fixture
def own(tmp_path):
    (tmp_path / "lid.toml").write_text(OWN)
    one = Served(tmp_path)
    yield one
    one.stop()


def model_of(page):
    """Return the model of a page with one patch, as Python reads its keys."""
    model = state(page)
    return Model.from_dict({**model["patches"][0], "name": model["name"], "unit": model["unit"]})


def is_drawn(page):
    """Check that the drawn surface is the one that Python builds of the page's keys."""
    page.evaluate(DRAW)
    surface = model_of(page).surface
    told = page.evaluate(
        """() => { const s = document.querySelector('[data-quintrig]').studio, f = s.frame;
        const m = s.stage.cells[0].pieces[0].mesh;
        return { n: m.side, x: Array.from(m.position), centre: f.centre, scale: f.scale }; }"""
    )
    t = np.linspace(0, 1, told["n"])
    there = np.array(told["x"]).reshape(told["n"], told["n"], 3) / told["scale"] + np.array(told["centre"])
    assert np.abs(there - surface(t[:, None], t[None, :])).max() < 1e-5 * surface.size


def text(page, part):
    if page.locator(".studio .left").is_hidden() or not page.get_by_text("Model as text").is_visible():
        page.get_by_role("button", name="Construction and control points").click()
    if page.locator(".model-text").get_attribute("open") is None:
        page.get_by_text("Model as text").click()
    page.get_by_role("radio", name=part).click()
    return page.locator(".model-text textarea")


def told(page):
    wrong = page.locator(".model-text .error")
    wrong.wait_for(state="visible")
    return wrong.inner_text()


def no_mistake(page):
    page.locator(".model-text .error").wait_for(state="hidden")


def test_every_parameter_has_a_slider_over_its_range(context, own):
    problems = []
    page = opened(context, own.site.address, problems)
    for name, low, high, value in (("lam 1", "-1", "1", "0"), ("mu 1", "-2", "1", "0.5"), ("lam 2", "-1", "1", "0")):
        slider = page.get_by_label(name, exact=True)
        assert [slider.get_attribute(key) for key in ("min", "max")] == [low, high]
        assert slider.input_value() == value
    page.get_by_label("mu 1", exact=True).fill("-1.5")
    assert state(page, "model.patches[0].shape") == [0, -1.5, 0]
    is_drawn(page)
    page.get_by_label("mu 1, number", exact=True).fill("3")
    page.keyboard.press("Enter")
    assert state(page, "model.patches[0].shape") == [0, -1.5, 0]
    kept(page, "own-basis")
    assert problems == []


def test_a_basis_is_chosen_for_each_direction(context, own):
    page = opened(context, own.site.address)
    for name in ("cubic", "h_bezier", "q_bernstein", "generalised_trigonometric", "bernstein"):
        page.get_by_label("Basis in v").select_option(name)
        assert state(page, "model.patches[0].basis") == ["mine", name]
        is_drawn(page)
    page.get_by_label("Basis in u").select_option("quadratic")
    page.get_by_label("Basis in v").select_option("c_bezier")
    page.get_by_label("phi 2, number", exact=True).fill("3")
    page.keyboard.press("Enter")
    assert state(page, "model.patches[0].shape") == [0, 0, 3]
    is_drawn(page)
    page.keyboard.press("Control+s")
    until(page, "document.querySelector('[data-quintrig]').studio.store.state.model === "
                "document.querySelector('[data-quintrig]').studio.store.state.saved")  # fmt: skip
    saved = quintrig.load(own.path)
    assert saved.to_dict()["basis"] == ["quadratic", "c_bezier"]
    assert list(saved.to_dict()["bases"]) == ["mine"]


@pytest.mark.parametrize("size", [(1280, 720), (420, 860)])
def test_formulas_are_changed_live_and_a_mistake_is_told_as_python_tells_it(context, own, size):
    page = opened(context, own.site.address)
    page.set_viewport_size({"width": size[0], "height": size[1]})
    page.evaluate(DRAW)
    box = text(page, "Own bases")
    box.wait_for(state="visible")
    before = box.input_value()
    for good, bad in (
        ("t^2*(1-mu*r)", "t^2*(1-mo*r)"),
        ("r^2*(1-lam*t)", "r^2*(1-lam*t"),
        ("t^2*(1-mu*r)", "t^2/(t-0.5)"),
    ):
        box.fill(before.replace(good, bad))
        with pytest.raises(ModelError) as caught:
            Model.from_dict(tomllib.loads(OWN.replace(good, bad)))
        page.wait_for_timeout(400)
        assert told(page) == str(caught.value)
        assert state(page, "model.patches[0].bases.mine.functions")[2] == "t^2*(1-mu*r)"  # what holds stays
    kept(page, f"own-basis-mistake-{size[0]}")
    box.fill(before.replace("-2, 1, 0.5", "-2, 1, -1").replace("mu", "nu"))
    no_mistake(page)
    until(page, "JSON.stringify(document.querySelector('[data-quintrig]').studio.store.state.model).includes('nu*r')")
    assert page.get_by_label("nu 1", exact=True).count() == 1
    is_drawn(page)


def test_the_whole_file_is_changed_as_text_and_undone_at_once(context, own):
    page = opened(context, own.site.address)
    box = text(page, "Whole file")
    first = box.input_value()
    assert Model.from_dict(tomllib.loads(first)).to_dict() == Model.from_dict(tomllib.loads(OWN)).to_dict()
    box.fill(first.replace("[10, 10, 15]", "[10, 10, 40]").replace('"lambda_bezier"', '"ali_cubic"'))
    until(page, "document.querySelector('[data-quintrig]').studio.store.state.model.patches[0].points[1][1][2] === 40")
    is_drawn(page)
    box.fill(box.input_value().replace("ali_cubic", "ali_cubik"))
    assert "did you mean 'ali_cubic'?" in told(page)
    box.fill("kind = ")
    page.wait_for_timeout(400)
    assert "not valid TOML" in told(page)
    page.locator("canvas.view").focus()
    page.keyboard.press("Control+z")
    assert state(page, "model.patches[0].points[1][1][2]") == 15


def test_a_basis_is_copied_to_one_of_the_users_own(context, tmp_path):
    (tmp_path / "lid.toml").write_text('kind = "curve"\nbasis = "q_bernstein"\npoints = [[0, 0], [1, 3], [4, 2]]\n')
    one = Served(tmp_path)
    page = opened(context, one.site.address)
    text(page, "Own bases")
    page.get_by_role("button", name="Copy the formulas of the basis").click()
    assert state(page, "model.patches[0].basis") == "my_q_bernstein"
    slider = page.get_by_label("q", exact=True)
    assert (slider.get_attribute("min"), slider.get_attribute("max")) == ("0.001", "1")
    no_mistake(page)
    one.stop()


def test_what_moves_with_the_origin_says_so(context, own):
    page = opened(context, own.site.address)
    box = text(page, "Whole file")
    box.fill(
        box.input_value()
        .replace("t^2*(1-mu*r)", "1.1*t^2*(1-mu*r)")
        .replace("basis =", "unchecked_basis = true\nbasis =")
    )
    no_mistake(page)
    until(page, "document.querySelector('[data-quintrig]').studio.root.querySelector('.warning').textContent !== ''")
    warning = page.locator(".status .warning").inner_text()
    assert "do not sum to 1 (their sum is 1.1 at t = 1" in warning
    assert "the surface moves with the origin" in warning
    is_drawn(page)


def test_a_page_from_disk_needs_no_python(context, tmp_path):
    problems = []
    (tmp_path / "m.toml").write_text(OWN)
    viewer = embed(quintrig.load(tmp_path / "m.toml"))
    page_file = tmp_path / "page.html"
    page_file.write_text(f"<!doctype html><meta charset=utf-8><style>.quintrig-viewer{{height:700px}}</style>{viewer}")
    page = context.new_page()
    page.on("console", lambda m: problems.append(m.text) if m.type == "error" else None)
    page.on("pageerror", lambda e: problems.append(str(e)))
    page.goto(page_file.as_uri())
    page.locator(".studio").wait_for()
    page.get_by_label("lam 1", exact=True).fill("0.8")
    is_drawn(page)
    page.get_by_label("Basis in v").select_option("h_bezier")
    is_drawn(page)
    box = text(page, "Own bases")
    box.fill(box.input_value().replace("lam*t", "lamb*t"))
    assert "did you mean 'lam'?" in told(page)
    # A file that is dropped is read here too, and its mistakes are told.
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Open a model").click()
        page.get_by_role("menuitem", name="From this computer").click()
    bad = tmp_path / "bad.toml"
    bad.write_text(OWN.replace("t^2*(1-mu*r)", "t^2*(1-mu*r))"))
    chooser.value.set_files(bad)
    banner = page.locator(".banner.error")
    banner.wait_for()
    with pytest.raises(ModelError) as caught:
        quintrig.load(bad)
    assert str(caught.value).removeprefix(f"{tmp_path}/") in banner.inner_text()
    assert problems == []
