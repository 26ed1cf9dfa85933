"""What every test run begins with."""

import re
import signal
from pathlib import Path

import pytest

# Where a run was started with Ctrl-C ignored, as in the background of a shell, the processes that tests start would
# inherit that, and those that are interrupted would run on.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

SLOW = frozenset(
    [
        "cad",
        "cad_faults",
        "cluster",
        "compiled",
        "deviation",
        "durable",
        "examples",
        "exchange",
        "extreme_models",
        "figure_whole",
        "fit",
        "guides",
        "hostile_input",
        "lines",
        "mesh",
        "outputs",
        "plugins",
        "plugins_browser",
        "proofs_many",
        "properties",
        "readme",
        "recipes",
        "release",
        "report",
        "reproduce",
        "rhino_blocks",
        "scan",
        "site",
        "stream",
        "sweep_numbers",
        "sweep_refined",
        "sweep_unbounded",
        "tools",
    ]
)
"""Files of tests that take more than some twenty seconds, without ``test_``; those of the studio's pages besides."""


SHARING = re.compile(r'@pytest\.fixture\(scope="module".*\)\ndef (?!browser)|^from test_studio_browser import', re.M)
"""What a file of tests says that makes something once for all of them, or opens the browser."""


def pytest_itemcollected(item):
    """Mark what is slow, so that ``-m "not slow"`` leaves it out."""
    name = item.path.stem.removeprefix("test_")
    if name in SLOW or name.startswith("studio_"):
        item.add_marker(pytest.mark.slow)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Return the scheduler of pytest-xdist: a file's tests go to one process where they share what is made once."""
    from xdist.scheduler import LoadScopeScheduling

    files = Path(__file__).parent.glob("test_*.py")
    together = {path.name for path in files if SHARING.search(path.read_text("utf-8"))}

    class Together(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            file = nodeid.partition("::")[0]
            return file if Path(file).name in together else nodeid

    return Together(config, log)
