"""What takes long and several tests read is made once a run, also where tests run in several processes."""

import fcntl
import os


def once(factory, name, make):
    """Return the folder of this name, which ``make(folder)`` filled in whichever process came first."""
    base = factory.getbasetemp()
    folder = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / name
    with folder.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        done = folder.with_suffix(".done")
        if not done.exists():
            folder.mkdir(exist_ok=True)
            make(folder)
            done.touch()
    return folder
