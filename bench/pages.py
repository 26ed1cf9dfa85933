"""How long whole pages take: fresh processes beside one that imports matplotlib and draws one surface its own way."""

import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from bench.timing import race, spelt, table

RIVAL = "matplotlib imported, one surface of 120 x 120 facets by plot_surface, as PNG"
DRAWN = """
import numpy
from matplotlib.figure import Figure
u, v = numpy.meshgrid(numpy.linspace(0, 1, 121), numpy.linspace(0, 1, 121))
figure = Figure(figsize=(5.6, 4.2))
figure.add_subplot(projection="3d").plot_surface(u, v, u * v, rcount=120, ccount=120)
figure.savefig({place!r}, dpi=144)
"""
ALONE = (
    "import quintrig; from pathlib import Path; from quintrig.report import write_report; "
    "write_report(quintrig.load('examples/car_boot.toml'), Path({place!r}))"
)


def report(quick: bool) -> None:
    """Print the table."""
    with TemporaryDirectory() as folder:
        place = str(Path(folder) / "page")
        commands: dict[str, tuple[str, ...]] = {
            RIVAL: ("-c", DRAWN.format(place=f"{place}.png")),
            "quintrig report examples/car_boot.toml (26 pictures)": (
                *("-m", "quintrig", "report", "examples/car_boot.toml"),
                place,
            ),
            "the same drawn in one process": ("-c", ALONE.format(place=f"{place}.html")),
        }
        if not quick:
            commands["quintrig reproduce"] = ("-m", "quintrig", "reproduce", f"{place}s")
        ways = {
            name: lambda words=words: subprocess.run(
                [sys.executable, *words], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
            )
            for name, words in commands.items()
        }
        times = race(ways, 3)
    print("Whole pages, in fresh processes\n")
    rows = [(name, f"{one.median:.2f}", f"{one.spread:.0%}", spelt(one, times[RIVAL])) for name, one in times.items()]
    table(("what", "seconds", "spread", "times the one surface"), rows)
