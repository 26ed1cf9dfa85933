"""Running a sweep: on threads of this machine, or on the workers of a Dask cluster."""

from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ThreadPoolExecutor, wait
from itertools import islice
from os import cpu_count
from time import monotonic, sleep
from typing import Any, cast
from uuid import uuid4

from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import need
from quintrig.support.progress import Counted, watched
from quintrig.sweep.part import summaries
from quintrig.sweep.store import Sweep

_PATIENCE = 5.0  # seconds to wait for a scheduler
_IDLE = 60.0  # seconds to wait for workers where a cluster has none
_ASK = 1.0  # seconds between two questions whether it has
_PAUSE = 0.02  # seconds between two looks at what has come
_AHEAD = 256  # parts handed to a cluster at a time


@watched
def run(
    sweep: Sweep, scheduler: str | None = None, progress: Counted | None = None, threads: int | None = None
) -> None:
    """Compute the parts that are missing and write each as it comes.

    ``scheduler`` is the address of a ``dask.distributed`` scheduler, such as tcp://host:8786; without one, threads
    here. Stopped at any moment, it loses only the parts under way. Raises QuintrigError for a cluster that cannot be
    reached, is lost or has had no workers for a minute, or a full disk.
    """
    missing = sweep.missing()
    total = sweep.task.space.count
    done = total - sum(stop - start for start, stop in map(sweep.span, missing))
    if progress:
        progress(done, total)
    if not missing:
        return
    results = _on_cluster(sweep, missing, scheduler) if scheduler else _on_threads(sweep, missing, threads)
    for part, rows in results:
        sweep.write(part, rows)
        done += len(rows)
        if progress:
            progress(done, total)


def _on_threads(sweep: Sweep, parts: list[int], threads: int | None) -> Iterator[tuple[int, FloatArray]]:
    workers = threads or cpu_count() or 1
    with ThreadPoolExecutor(workers) as pool:
        waiting = iter(parts)
        running: dict[Future[FloatArray], int] = {}

        def feed() -> None:
            for part in waiting:
                running[pool.submit(summaries, sweep.task, *sweep.span(part))] = part
                if len(running) > workers:
                    return

        try:
            feed()
            while running:
                finished, _ = wait(running, return_when=FIRST_COMPLETED)
                for future in finished:
                    part = running.pop(future)
                    yield part, future.result()
                feed()
        finally:
            for future in running:
                future.cancel()


def _on_cluster(sweep: Sweep, parts: list[int], scheduler: str) -> Iterator[tuple[int, FloatArray]]:
    need("distributed", "a cluster")
    from distributed import Client, KilledWorker, as_completed

    try:
        client: Any = cast(Any, Client)(scheduler, timeout=_PATIENCE, set_as_default=False)
    except Exception as error:  # an address that is none fails in many ways inside distributed, assertions among them
        reason = (str(error).splitlines() or [type(error).__name__])[0]
        raise QuintrigError(f"cannot be reached ({reason}); is it running?", "scheduler", scheduler) from None
    waiting = iter(parts)
    numbers: dict[str, int] = {}

    def submit(count: int) -> list[Any]:
        futures: list[Any] = []
        for part in islice(waiting, count):
            # The description goes with every part, so nothing is lost with a worker that dies.
            key = f"quintrig-{uuid4()}"
            future: Any = client.submit(summaries, sweep.task, *sweep.span(part), key=key, retries=3)
            numbers[future.key] = part
            futures.append(future)
        return futures

    try:
        with client:
            running: Any = cast(Any, as_completed)(submit(_AHEAD), loop=client.loop, with_results=True)
            for future, rows in _arriving(running, client, scheduler):
                if isinstance(rows, BaseException):  # how a lost scheduler shows itself
                    raise rows
                yield numbers.pop(future.key), rows
                future.release()
                for more in submit(1):
                    running.add(more)
    except (OSError, CancelledError, ImportError, KilledWorker) as error:
        reason = (str(error).splitlines() or [""])[0] or type(error).__name__
        raise QuintrigError(
            f"the cluster failed ({reason[:200]}); the parts written stay, and running it again goes on from them",
            "scheduler",
            scheduler,
        ) from None


def _arriving(running: Any, client: Any, scheduler: str) -> Iterator[tuple[Any, Any]]:
    """Give results as they come; QuintrigError where no worker is left or comes, for which Dask would wait forever."""
    asked = manned = monotonic()
    while not running.is_empty():
        batch = running.next_batch(block=False)
        yield from batch
        now = monotonic()
        if batch:
            asked = manned = now
        elif now - asked < _ASK:
            sleep(_PAUSE)
        else:
            asked = now
            manned = now if client.scheduler_info()["workers"] else manned
            if now - manned > _IDLE:
                raise QuintrigError(
                    f"has had no worker for {_IDLE:.0f} s; start some by 'dask worker {scheduler}' and give the same "
                    "command again: the parts written stay",
                    "scheduler",
                    scheduler,
                )
