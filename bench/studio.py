"""How long from moving a slider to the drawn frame, in a real browser: ``make bench-studio``.

For every move the page notes the time, changes the slider, and waits until the surface is worked out, handed to the
graphics card, and drawn (a pixel is read back, which waits for the card). A run without a graphics card, as on a
server, draws in software: there the work before drawing is what compares with other machines.
"""

import argparse
import threading
import time
from pathlib import Path

import uvicorn
from playwright.sync_api import sync_playwright

from quintrig.studio import server

MODEL = Path(__file__).parents[1] / "examples" / "car_boot.toml"
FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]

RUN = """async ([moves, points]) => {
  const studio = document.querySelector('[data-quintrig]').studio;
  studio.store.setting({ resolution: points });
  const root = studio.root, slider = root.querySelector('input[type=range]');
  const results = [];
  for (let i = 0; i < moves; i++) {
    const start = performance.now();
    const drawn = new Promise((done) => root.addEventListener('drawn', (e) => {
      studio.stage.finish();
      done({ ...e.detail, total: performance.now() - start, side: studio.stage.cells[0].pieces[0].side });
    }, { once: true }));
    slider.value = String(1 - (i % 40) / 10);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    results.push(await drawn);
  }
  return results.slice(10);
}"""


def main() -> None:
    """Print medians and 95th percentiles over many moves."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--moves", type=int, default=110)
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
        page.goto(site.address)
        page.locator(".studio").wait_for()
        page.wait_for_timeout(500)
        found = page.evaluate(RUN, [options.moves, options.points])
        browser.close()
    running.should_exit = True
    print(f"{len(found)} slider moves on {MODEL.name}, {options.points} x {options.points} points at rest")
    print(f"{'':34}median     95 %")
    names = {
        "evaluated": "surface, colours, panels worked out",
        "drawn": "handed to the card",
        "total": "input to drawn",
    }
    for key, name in names.items():
        times = sorted(one[key] for one in found)
        print(f"{name:34}{times[len(times) // 2]:6.1f} ms{times[int(0.95 * len(times))]:7.1f} ms")
    sides = sorted(one["side"] for one in found)
    print(f"points a side while moving: {sides[0]} to {sides[-1]}")
    if not options.gpu:
        print("(drawn in software, without a graphics card)")


if __name__ == "__main__":
    main()
