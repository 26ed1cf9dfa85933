"""``python -m bench`` (``make bench``): every figure a ratio measured in this run."""

import os

# One thread for everybody: must be said before NumPy loads its matrix library.
for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import argparse  # noqa: E402

from bench import accuracy, speed  # noqa: E402


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="fewer rounds and smaller grids")
    quick = parser.parse_args().quick
    accuracy.report()
    speed.report(quick)


if __name__ == "__main__":
    main()
