"""How long from moving a slider to the drawn frame, in a real browser: ``make bench-studio``.

For every move the page notes the time, changes the slider, and waits until the surface is worked out, handed to the
graphics card, and drawn (a pixel is read back, which waits for the card). The parts are timed apart, so that a run
without a graphics card, as on a server, still says what it would be with one: all but the last part is the same there.
"""

import argparse
import json
import tempfile
import threading
import time
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import uvicorn
from playwright.sync_api import Browser, Page, Playwright, sync_playwright

from quintrig.studio import server

MODEL = Path(__file__).parents[1] / "examples" / "car_boot.toml"
FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]

RUN = """async ([moves, points, whole]) => {
  const studio = document.querySelector('[data-quintrig]').studio, { stage, root } = studio;
  studio.store.setting({ resolution: points });
  if (whole) {
    studio.painter.pace = () => { studio.painter.coarse = points; };
    studio.painter.waited = () => {};
  }
  const slider = root.querySelector('input[type=range]');
  // What hands data to the card, and nothing else, is timed apart.
  let handing = 0;
  const gl = stage.renderer.getContext();
  for (const name of ['bufferData', 'bufferSubData', 'texImage2D', 'texSubImage2D']) {
    const plain = gl[name].bind(gl);
    gl[name] = (...given) => {
      const start = performance.now();
      plain(...given);
      handing += performance.now() - start;
    };
  }
  const results = [];
  for (let i = 0; i < moves + 10; i++) {
    const start = performance.now();
    handing = 0;
    const drawn = new Promise((done) => root.addEventListener('drawn', ({ detail }) => {
      const { surfaces, evaluated, drawn: asked } = detail, upload = handing, before = performance.now();
      stage.finish();
      const drawing = performance.now() - before;
      done({
        waiting: detail.start - start, surfaces, panels: evaluated - surfaces, upload, asked: asked - upload, drawing,
        total: performance.now() - start, side: stage.cells[0].pieces[0].side,
      });
    }, { once: true }));
    slider.value = String(1 - (i % 40) / 10);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    results.push(await drawn);
  }
  return results.slice(10);
}"""

DRAG = """async ([seconds, points]) => {
  const studio = document.querySelector('[data-quintrig]').studio, { stage, root } = studio;
  studio.store.setting({ resolution: points });
  const slider = root.querySelector('input[type=range]'), sides = [], end = performance.now() + 1000 * seconds;
  let frames = 0;
  root.addEventListener('drawn', () => { frames++; sides.push(stage.cells[0].pieces[0].side); });
  for (let i = 0; performance.now() < end; i++) {
    slider.value = String(1 - (i % 400) / 100);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    await new Promise((done) => setTimeout(done, 8));  // as often as a mouse tells
  }
  stage.finish();
  const side = sides.sort((a, b) => a - b)[sides.length >> 1];
  return { frames, seconds: (performance.now() - end) / 1000 + seconds, side };
}"""

# What happens besides the surfaces, part by part, while one patch of many changes.
PANELS = """async ([moves, points]) => {
  const studio = document.querySelector('[data-quintrig]').studio, { root } = studio, times = {};
  studio.store.setting({ resolution: points });
  const parts = [['painter', 'decorate'], ['stage', 'style'], ['legend', 'real'], ['bar', 'refresh'],
    ['inspector', 'refresh'], ['model', 'refresh'], ['hud', 'labels'], ['hud', 'refresh'], ['status', 'refresh']];
  for (const [owner, name] of parts) {
    const plain = studio[owner][name].bind(studio[owner]);
    studio[owner][name] = (...given) => {
      const start = performance.now(), answer = plain(...given);
      times[`${owner}.${name}`] = (times[`${owner}.${name}`] ?? 0) + performance.now() - start;
      return answer;
    };
  }
  const slider = root.querySelector('input[type=range]'), results = [];
  for (let i = 0; i < moves + 5; i++) {
    for (const key in times) delete times[key];
    const drawn = new Promise((done) => root.addEventListener('drawn', ({ detail }) => done(
      { panels: detail.evaluated - detail.surfaces, ...times }), { once: true }));
    slider.value = String(1 - (i % 40) / 10);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    studio.store.settle();  // as for a number typed: at rest, with all points
    results.push(await drawn);
  }
  return results.slice(5);
}"""

PARTS = {
    "waiting": "waiting for the browser's next frame",
    "surfaces": "surface and curvature worked out",
    "panels": "scale, lines, legend, panels",
    "upload": "points, normals, values to the card",
    "asked": "drawing asked for",
    "drawing": "drawn by {card}",
    "total": "input to drawn",
}


def main() -> None:
    """Print medians and 95th percentiles of the parts over many moves."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--moves", type=int, default=100)
    parser.add_argument("--points", type=int, default=150, help="points a side")
    parser.add_argument("--chromium", default="/usr/bin/chromium")
    parser.add_argument("--panels", action="store_true", help="only the panels, at 10 and 50 patches")
    parser.add_argument("--gpu", action="store_true", help="draw with the graphics card of this machine")
    options = parser.parse_args()
    if not options.panels:
        moves(options)
    for count in (10, 50):
        many(count, options)


def moves(options: argparse.Namespace) -> None:
    """Print the parts of a slider move on one patch, and how smooth a drag is."""
    with served(MODEL) as address, sync_playwright() as playwright:
        browser = launched(playwright, options)
        page = browser.new_page(viewport={"width": 1280, "height": 720})
        opened(page, address)
        page.evaluate(RUN, [30, options.points, True])  # the first visit warms up shaders and compiled code
        for whole in (False, True):
            opened(page, address)
            report(page.evaluate(RUN, [options.moves, options.points, whole]), options, whole)
        opened(page, address)
        drag = page.evaluate(DRAG, [4, options.points])
        rate = drag["frames"] / drag["seconds"]
        print(f"a drag of {drag['seconds']:.1f} s: {rate:.0f} frames a second, of {drag['side']} points a side")
        browser.close()


def many(count: int, options: argparse.Namespace) -> None:
    """Print what a slider move costs besides the surfaces in a model of so many patches."""
    lid = tomllib.loads(MODEL.read_text())
    patch = {key: value for key, value in lid.items() if key not in ("schema", "unit", "name")}
    model = {"schema": 1, "name": "Many", "unit": "mm", "patch": [patch | {"name": f"lid {i}"} for i in range(count)]}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "many.json"
        path.write_text(json.dumps(model))
        with served(path) as address, sync_playwright() as playwright:
            browser = launched(playwright, options)
            page = browser.new_page(viewport={"width": 1280, "height": 720})
            opened(page, address)
            found = page.evaluate(PANELS, [min(options.moves, 30), options.points])
            browser.close()
    print(f"{count} patches, one of them changing, without its surface:")
    for name in found[0]:
        times = sorted(one.get(name, 0.0) for one in found)
        print(f"  {name:38}{times[len(times) // 2]:6.1f} ms{times[int(0.95 * len(times))]:7.1f} ms")


@contextmanager
def served(path: Path) -> Iterator[str]:
    """A running studio on a model: its address."""
    site = server.site(path)
    config = uvicorn.Config(server.application(site), host=site.host, port=site.port, log_level="error", lifespan="off")
    running = uvicorn.Server(config)
    threading.Thread(target=running.run, daemon=True).start()
    while not running.started:
        time.sleep(0.02)
    yield site.address
    running.should_exit = True


def launched(playwright: Playwright, options: argparse.Namespace) -> Browser:
    """The browser to measure in."""
    flags = ["--no-sandbox"] if options.gpu else FLAGS
    return playwright.chromium.launch(executable_path=options.chromium, args=flags, headless=not options.gpu)


def opened(page: Page, address: str) -> None:
    """Open the studio anew."""
    page.goto(address)
    page.locator(".studio").wait_for()
    page.wait_for_timeout(500)


def report(found: list[dict[str, float]], options: argparse.Namespace, whole: bool) -> None:
    """Print one table."""
    sides = sorted({int(one["side"]) for one in found})
    shown = f"{sides[0]}" if len(sides) == 1 else f"{sides[0]} to {sides[-1]}"
    how = "always all points" if whole else "as many points as a frame's time allows"
    print(f"{len(found)} slider moves on {MODEL.name}, {how}: {shown} a side")
    print(f"{'':40}median     95 %")
    card = "the graphics card" if options.gpu else "software, no graphics card"
    for key, name in PARTS.items():
        times = sorted(one[key] for one in found)
        middle, most = times[len(times) // 2], times[int(0.95 * len(times))]
        print(f"{name.format(card=card):40}{middle:6.1f} ms{most:7.1f} ms")
    print()


if __name__ == "__main__":
    main()
