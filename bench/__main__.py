"""``python -m bench`` (``make bench``): every figure a ratio measured in this run, as Markdown tables."""

import os

# One thread for everybody: must be said before NumPy loads its matrix library.
for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import argparse  # noqa: E402
import json  # noqa: E402
import platform  # noqa: E402
from importlib.metadata import version  # noqa: E402
from pathlib import Path  # noqa: E402

from bench import accuracy, integrals, kept, pages, peers, proofs, scans, speed, startup, sweeps  # noqa: E402

PARTS = {
    "accuracy": accuracy,
    "integrals": integrals,
    "speed": speed,
    "peers": peers,
    "proofs": proofs,
    "sweeps": sweeps,
    "scans": scans,
    "startup": startup,
    "pages": pages,
}


def machine() -> str:
    """Return in words what this is measured on."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "numba"))
    processor = names[0] if names else platform.machine()
    return f"{processor}, {os.cpu_count()} cores, Python {platform.python_version()}, {packages}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer rounds and smaller grids")
    parser.add_argument("--keep", type=Path, metavar="FILE.json", help="keep the tables in a file, as of a release")
    parser.add_argument("parts", nargs="*", default=[*PARTS], metavar="PART", help=f"some of {', '.join(PARTS)}")
    options = parser.parse_args()
    unknown = [name for name in options.parts if name not in PARTS]
    if unknown:
        parser.error(f"unknown part {unknown[0]!r}; there are {', '.join(PARTS)}")
    on = machine()
    print(f"Measured on {on}.\nMedians of several rounds, ways in turn; spread is (longest - shortest) / median.\n")
    results: dict[str, object] = {}
    for name in options.parts:
        with kept.told() as text:
            PARTS[name].report(options.quick)
        results[name] = kept.tables(text.getvalue())
    if options.keep:
        record = {"quintrig": version("quintrig"), "machine": on, "quick": options.quick, "tables": results}
        options.keep.write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
