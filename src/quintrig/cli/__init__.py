"""The command line: ``quintrig COMMAND ...``. Only this package prints or exits."""

import gc
import os
import sys
import warnings


def main() -> None:
    """Run the command line and exit: 0 done, 1 a check found problems, 2 a mistake in what was asked."""
    from quintrig.cli.app import build
    from quintrig.cli.ending import run, warn
    from quintrig.cli.streams import prepare

    prepare()
    gc.set_threshold(50_000)  # modules and models make many things that stay; looking for cycles is a tenth of a start
    # Matrices are small here, and large work has threads of its own: NumPy's would only wait for each other.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    warnings.showwarning = warn
    sys.exit(run(build, sys.argv[1:]))
