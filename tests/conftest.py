"""What every test run begins with."""

import signal

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


def shares(item):
    """Return whether a test uses what is made once for its file; a browser starts at once and does not count."""
    defined = item._fixtureinfo.name2fixturedefs  # no public name tells
    return any(used[-1].scope == "module" for name, used in defined.items() if name != "browser")


@pytest.hookimpl(tryfirst=True)  # before xdist reads the groups
def pytest_collection_modifyitems(items):
    """Mark what is slow, so that ``-m "not slow"`` leaves it out, and keep tests together that share what was made."""
    for item in items:
        name = item.path.stem.removeprefix("test_")
        if name in SLOW or name.startswith("studio_"):
            item.add_marker(pytest.mark.slow)
        if shares(item):
            item.add_marker(pytest.mark.xdist_group(name))
