"""Work that is spread over processes, such as pictures, which one process draws one at a time."""

import os
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context


def pool(processes: int | None = 1) -> Executor:
    """Return what runs work in so many processes, None for as many as the machine has; 1 is a thread of this one.

    With several, the program that asks must guard its beginning by ``if __name__ == "__main__"``, as Python says.
    """
    count = processes or os.cpu_count() or 1
    # A copy of this process would have its threads' locks, and not the threads that hold them.
    return ThreadPoolExecutor(1) if count == 1 else ProcessPoolExecutor(count, mp_context=get_context("spawn"))
