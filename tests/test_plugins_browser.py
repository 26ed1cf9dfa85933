"""The recipe of CONTRIBUTING in the browser: the toy package's kinds in report page, live studio and notebook."""

import json
import subprocess
import sys
import time

import numpy as np
import pytest

import quintrig
from quintrig.shaping.shape_effect import SHAPE_SETS
from test_plugins import PLUGIN, done, environment, toy  # noqa: F401
from test_studio_browser import browser, context, kept, opened, pytestmark, served, state, until  # noqa: F401
from test_studio_notebook_page import SCRIPT as NOTEBOOK

STUDIO = "document.querySelector('[data-quintrig]').studio"
DRAWN = """(studio) => {
  const { grid } = studio.stage.cells[0].pieces[0].mesh, found = { nu: grid.nu, nv: grid.nv };
  for (const [key, width] of [['point', 3], ['gaussian', 1], ['mean', 1]]) {
    const out = new Float64Array(width * grid.count);
    grid.quantity(key, out, { relative: 1e-6, flat: 1e-6 });
    found[key] = Array.from(out);
  }
  return found;
}"""
NEAR = """(studio, point, cell = 0) => {
  const { surface } = studio.stage.cells[cell].pieces[0], at = Float64Array.of(0.5), { rows, blend, origin } = surface;
  const q = new Float64Array(3 * rows.size * 3), f = new Float64Array(3 * rows.size);
  rows.derivatives(at, 1, q);
  blend.derivatives(at, 1, f);
  const found = [0, 1, 2].map((x) => f.slice(0, rows.size).reduce((sum, d, j) => sum + d * q[3 * j + x], origin[x]));
  return found.every((value, x) => Math.abs(value - point[x]) < 1e-9);
}"""
CHANGES = {"scroll": ("height", 45.0), "bowl": ("radius", 3.5)}


@pytest.fixture(scope="module")
def toys():
    sys.path.insert(0, str(PLUGIN))
    import quintrig_toys

    yield {"scroll": quintrig_toys.Scroll, "bowl": quintrig_toys.Bowl}
    sys.path.remove(str(PLUGIN))


def agrees(page, definition, studio=STUDIO):
    """Check every number that is drawn against Python's."""
    found = page.evaluate(f"({DRAWN})({studio})")
    u, v = np.linspace(0, 1, found["nu"])[:, None], np.linspace(0, 1, found["nv"])[None, :]
    surface = definition.surface()
    ours = quintrig.analyse(surface, u, v, ("point", "gaussian", "mean", "curvedness"))
    bend = ours["curvedness"].max()
    for key, scale in (("point", surface.size), ("gaussian", bend**2), ("mean", bend)):
        assert np.abs(np.ravel(ours[key]) - np.asarray(found[key])).max() <= 1e-10 * scale, key


def read(definition, folder):
    """Return the definition of the toy model in a folder."""
    import tomllib

    keys = tomllib.loads((folder / "toy.toml").read_text(encoding="utf-8"))
    return definition.model_validate({key: value for key, value in keys.items() if key not in ("schema", "unit")})


def changed(definition, kind):
    key, value = CHANGES[kind]
    return definition.model_copy(update={key: value})


def edit(page, kind, studio=STUDIO):
    key, value = CHANGES[kind]
    page.evaluate(
        f"([key, value]) => {{ const {{ store }} = {studio}; "
        "store.editPatch({ ...store.state.model.patches[0], [key]: value }); }",
        [key, value],
    )


def test_the_report_page_shows_it_and_says_why_it_is_fixed(context, toy, toys):  # noqa: F811
    kind, folder = toy
    done("report", "toy.toml", "shown", folder=folder)
    problems = []
    page = opened(context, (folder / "shown" / "index.html").as_uri(), problems)
    definition = read(toys[kind], folder)
    agrees(page, definition)
    before = state(page)
    edit(page, kind)
    until(page, f"{STUDIO}.store.state.message !== null")
    assert f"a {kind} is built by Python" in state(page, "message.text")
    assert "quintrig view" in state(page, "message.text")
    assert state(page) == before
    agrees(page, definition)
    assert problems == []
    page.locator("[data-quintrig]").scroll_into_view_if_needed()
    kept(page, f"plugin-report-{kind}")


@pytest.fixture
def live(toy):  # noqa: F811
    """The address of a live studio on the toy model, served as a user serves it."""
    kind, folder = toy
    command = [sys.executable, "-m", "quintrig", "view", "toy.toml", "--no-browser"]
    with subprocess.Popen(command, env=environment(PLUGIN), cwd=folder, stdout=subprocess.PIPE, text=True) as process:
        line = process.stdout.readline()
        assert line.startswith("Studio: "), line
        address = line.removeprefix("Studio: ").strip()
        for _ in range(100):
            if _answers(address):
                break
            time.sleep(0.1)
        yield kind, folder, address
        process.terminate()


def _answers(address):
    import urllib.error
    import urllib.request

    try:
        urllib.request.urlopen(address, timeout=1).close()
    except urllib.error.HTTPError:
        return True
    except OSError:
        return False
    return True


def test_the_live_studio_shows_it_and_changes_it(context, live, toys):  # noqa: F811
    kind, folder, address = live
    problems = []
    page = opened(context, address, problems)
    definition = read(toys[kind], folder)
    agrees(page, definition)
    kept(page, f"plugin-live-{kind}")
    size = page.evaluate(f"{STUDIO}.stage.cells[0].pieces[0].mesh.grid.size")
    edit(page, kind)
    until(page, f"Math.abs({STUDIO}.stage.cells[0].pieces[0].mesh.grid.size - {size}) > 1e-3")
    agrees(page, changed(definition, kind))
    page.evaluate(f"{STUDIO}.store.undo()")
    until(page, f"{STUDIO}.stage.cells[0].pieces[0].mesh.grid.size === {size}")
    assert state(page) == page.evaluate(f"{STUDIO}.store.state.saved")
    assert problems == []
    # What Python refuses is told in its words, and the picture stays.
    key, _ = CHANGES[kind]
    page.evaluate(
        f"() => {{ const {{ store }} = {STUDIO}; store.editPatch({{ ...store.state.model.patches[0], {key}: -1 }}); }}"
    )
    until(page, f"({STUDIO}.store.state.message?.text ?? '').includes('{key}')")
    assert page.evaluate(f"{STUDIO}.stage.cells[0].pieces[0].mesh.grid.size") == size


def test_control_points_are_dragged_and_sets_compared(context, live, toys):  # noqa: F811
    kind, folder, address = live
    if kind == "bowl":
        pytest.skip("a bowl has neither")
    problems = []
    page = opened(context, address, problems)
    at = page.evaluate(f"{STUDIO}.locate('section[2]')")
    page.mouse.move(at["x"], at["y"])
    page.mouse.down()
    page.mouse.move(at["x"] + 40, at["y"] - 25, steps=6)
    page.mouse.up()
    section = state(page, "model.patches[0].section")
    definition = read(toys[kind], folder)
    assert section[2] != definition.section[2]
    assert [*section[:2], *section[3:]] == [*definition.section[:2], *definition.section[3:]]
    moved = definition.model_copy(update={"section": section})
    point = moved.surface()(0.5, 0.5)
    until(page, f"({NEAR})({STUDIO}, {point.tolist()})")
    page.wait_for_timeout(300)
    agrees(page, moved)
    page.evaluate(f"{STUDIO}.store.set({{ compare: 'sets' }})")
    until(page, f"{STUDIO}.stage.cells.length === 4")
    page.wait_for_timeout(1000)
    for i, shape in enumerate(SHAPE_SETS[4]):
        varied = moved.model_copy(update={"shape": [float(x) for x in shape]})
        middle = varied.surface()(0.5, 0.5).tolist()
        until(page, f"({NEAR})({STUDIO}, {middle}, {i})")
    kept(page, "plugin-live-sets")
    assert state(page, "message") is None
    assert problems == []


def test_the_live_studio_starts_one(context, live):  # noqa: F811
    """A construction stands in the list of starters."""
    kind, _, address = live
    page = opened(context, address)
    page.get_by_role("button", name="Models: presets and starters").click()
    entry = page.get_by_role("menuitem", name="Scroll")
    assert entry.count() == 1  # whatever is open; a bowl is no construction and stands in no list
    entry.click()
    until(page, f"{STUDIO}.store.state.model.patches[0].kind === 'scroll'")
    until(page, f"{STUDIO}.stage.cells[0].pieces[0].mesh.grid.size > 30")
    assert kind in ("scroll", "bowl")


KERNEL = """
import json, sys
import quintrig
from quintrig.studio.built import rebuilt
from quintrig.studio.jupyter import show
view = show(quintrig.load("toy.toml"))
keys = {key: value for key, value in view.model.items() if key not in ("schema", "unit")}
patch = keys | dict([json.loads(sys.argv[1])])
print(json.dumps({"model": view.model, "brought": view.brought, "answer": {"built": rebuilt([patch])}}))
"""


def test_a_notebook_shows_it_and_its_kernel_rebuilds_it(context, served, toy, toys):  # noqa: F811
    """On a page of a server that knows no toys: what the view brings is all that it has."""
    pytest.importorskip("anywidget", reason="the extra 'jupyter' is not installed")
    kind, folder = toy
    change = json.dumps(CHANGES[kind])
    run = subprocess.run(
        [sys.executable, "-c", KERNEL, change],
        env=environment(PLUGIN), cwd=folder, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert run.returncode == 0, run.stderr
    told = json.loads(run.stdout)
    page = opened(context, served.site.address)
    page.evaluate("(brought) => { window.brought = brought; }", told["brought"])
    script = NOTEBOOK.replace("quantity: 'mean',", "quantity: 'mean', brought: window.brought,")
    assert script != NOTEBOOK
    page.evaluate(script, told["model"])
    page.evaluate(
        "(said) => { window.kernel.send = () => setTimeout(() => window.kernel.said(said), 20); }", told["answer"]
    )
    cell = "document.getElementById('cell').studio"
    until(page, f"{cell}.stage.cells[0]?.pieces[0]?.mesh.grid.size > 0")
    definition = read(toys[kind], folder)
    agrees(page, definition, cell)
    size = page.evaluate(f"{cell}.stage.cells[0].pieces[0].mesh.grid.size")
    edit(page, kind, cell)
    until(page, f"Math.abs({cell}.stage.cells[0].pieces[0].mesh.grid.size - {size}) > 1e-3")
    agrees(page, changed(definition, kind), cell)
    key, value = CHANGES[kind]
    until(page, f"window.kernel.get('model').{key} === {value}")
