"""How long from moving a slider to the drawn frame, in a real browser: ``make bench-studio``.

For every move the page notes the time, changes the slider, and waits until the surface is worked out, handed to the
graphics card, and drawn (a pixel is read back, which waits for the card). The parts are timed apart, so that a run
without a graphics card, as on a server, still says what it would be with one: all but the last part is the same there.
"""

import argparse
import threading
import time
from pathlib import Path

import uvicorn
from playwright.sync_api import Page, sync_playwright

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
    parser.add_argument("--gpu", action="store_true", help="draw with the graphics card of this machine")
    options = parser.parse_args()
    site = server.site(MODEL)
    config = uvicorn.Config(server.application(site), host=site.host, port=site.port, log_level="error", lifespan="off")
    running = uvicorn.Server(config)
    threading.Thread(target=running.run, daemon=True).start()
    while not running.started:
        time.sleep(0.02)
    with sync_playwright() as playwright:
        flags = ["--no-sandbox"] if options.gpu else FLAGS
        browser = playwright.chromium.launch(executable_path=options.chromium, args=flags, headless=not options.gpu)
        page = browser.new_page(viewport={"width": 1280, "height": 720})
        opened(page, site.address)
        page.evaluate(RUN, [30, options.points, True])  # the first visit warms up shaders and compiled code
        for whole in (False, True):
            opened(page, site.address)
            report(page.evaluate(RUN, [options.moves, options.points, whole]), options, whole)
        opened(page, site.address)
        drag = page.evaluate(DRAG, [4, options.points])
        rate = drag["frames"] / drag["seconds"]
        print(f"a drag of {drag['seconds']:.1f} s: {rate:.0f} frames a second, of {drag['side']} points a side")
        browser.close()
    running.should_exit = True


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
