"""Work that is spread over processes: copies of this one where that is safe, new ones where it is not."""

import subprocess
import sys

import pytest

SCRIPT = """
import math, sys, threading, time
from quintrig.support.processes import pool
wait = threading.Event()
if {threads}:
    threading.Thread(target=wait.wait).start()
import colorsys
with pool(2) as workers:
    assert list(workers.map(math.sqrt, [4.0, 9.0, 16.0])) == [2.0, 3.0, 4.0]
    print(workers.submit(eval, "'colorsys' in __import__('sys').modules").result())
wait.set()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="only there is a process copied")
@pytest.mark.parametrize("threads", [False, True])
def test_a_process_without_other_threads_is_copied(threads):
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT.format(threads=threads)], capture_output=True, text=True, timeout=60, check=False
    )
    assert (done.stdout.strip(), done.stderr) == (str(not threads), "")
