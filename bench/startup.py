"""How long it takes to begin: fresh processes, medians, less the time of a Python that does nothing else."""

import subprocess
import sys

from bench.timing import Timing, race, table

FIRST = (
    "import quintrig, numpy; x, y = numpy.meshgrid(range(6), range(6)); "
    "quintrig.analyse(quintrig.tensor(numpy.stack([x, y, x * y], axis=-1)), *quintrig.grid(9, 9), ('gaussian', 'mean'))"
)


def report(quick: bool) -> None:
    """Print the table."""
    commands = {
        "python, nothing else": ("-c", "pass"),
        "import numpy": ("-c", "import numpy"),
        "import numpy, quintrig": ("-c", "import numpy, quintrig"),
        "import numpy, quintrig with tensor and Curve": (
            "-c",
            "import numpy, quintrig; quintrig.tensor, quintrig.Curve",
        ),
        "import quintrig, first analyse, kernels from the cache": ("-c", FIRST),
        "quintrig --help": ("-m", "quintrig", "--help"),
        "quintrig check examples/car_boot.toml": ("-m", "quintrig", "check", "examples/car_boot.toml"),
        "quintrig table examples/car_boot.toml --at 0.5,0.5": (
            *("-m", "quintrig", "table", "examples/car_boot.toml"),
            *("--at", "0.5,0.5"),
        ),
    }
    ways = {
        name: lambda words=words: subprocess.run([sys.executable, *words], check=True, stdout=subprocess.DEVNULL)
        for name, words in commands.items()
    }
    times = race(ways, 5 if quick else 11)
    numpy = times["import numpy"]
    rows = [
        (
            name,
            f"{timing.median:.3f}",
            f"{timing.spread:.0%}",
            _beyond(timing, numpy),
            f"{timing.median / numpy.median:.1f}",
        )
        for name, timing in times.items()
    ]
    print("Start-up of a fresh process\n")
    table(("command", "seconds", "spread", "beyond NumPy's import", "times NumPy's import"), rows)


def _beyond(timing: Timing, numpy: Timing) -> str:
    return f"{timing.median - numpy.median:+.3f}"
