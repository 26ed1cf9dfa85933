"""Work that is spread over processes, such as pictures, which one process draws one at a time."""

import gc
import os
import sys
import threading
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context


def pool(processes: int | None = 1) -> Executor:
    """Return what runs work in so many processes, None for as many as the machine has; 1 is a thread of this one.

    With several, the program that asks must guard its beginning by ``if __name__ == "__main__"``, as Python says.
    """
    count = processes or os.cpu_count() or 1
    if count == 1:
        return ThreadPoolExecutor(1)
    # A copy of this process has imported and compiled already what a new one would have to. But it would have the locks
    # of other threads too, and not the threads that hold them; and libraries of macOS do not bear it.
    copied = sys.platform == "linux" and threading.active_count() == 1
    if not copied:
        return ProcessPoolExecutor(count, mp_context=get_context("spawn"))
    # What is there already is not looked through for cycles, by which its pages would be copied.
    workers = ProcessPoolExecutor(count, mp_context=get_context("fork"), initializer=gc.freeze)
    workers.submit(os.getpid)  # copies are made now, before whoever asked begins threads
    return workers
