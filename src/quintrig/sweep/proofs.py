"""Claims proved on the designs that a question returns: on threads of this machine, or on a Dask cluster."""

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from typing import Any, cast

from quintrig.analysis.proofs import prove
from quintrig.enclosures.claims import read
from quintrig.enclosures.prove import NoProofError
from quintrig.enclosures.verdicts import Verdict
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import ModelError, QuintrigError
from quintrig.support.extras import need
from quintrig.sweep.part import Task
from quintrig.sweep.store import Sweep

_PATIENCE = 5.0  # seconds to wait for a scheduler


def check_claims(sweep: Sweep, claims: Sequence[str]) -> None:
    """Raise ValueError, before the work, for a claim that cannot be read."""
    for claim in claims:
        read(claim, str(sweep.task.model.get("unit", "")))


def prove_rows(
    sweep: Sweep, rows: dict[str, FloatArray], claims: Sequence[str], scheduler: str | None = None
) -> list[tuple[Verdict, ...]]:
    """Return what comes of claims on each of the designs ``rows``, as ``select_refined`` gives them.

    ``scheduler`` is the address of a ``dask.distributed`` scheduler; without one, threads here. Raises ValueError for a
    claim that cannot be read, QuintrigError for a cluster that cannot be reached.
    """
    check_claims(sweep, claims)
    names = sweep.task.space.names
    count = len(rows[names[0]])
    designs = [{name: float(rows[name][index]) for name in names} for index in range(count)]
    if not scheduler:
        with ThreadPoolExecutor(cpu_count() or 1) as pool:
            return [one.result() for one in [pool.submit(prove_design, sweep.task, d, claims) for d in designs]]
    need("distributed", "a cluster")
    from distributed import Client

    try:
        client: Any = cast(Any, Client)(scheduler, timeout=_PATIENCE, set_as_default=False)
    except Exception as error:  # an address that is none fails in many ways inside distributed
        reason = (str(error).splitlines() or [type(error).__name__])[0]
        raise QuintrigError(f"cannot be reached ({reason}); is it running?", "scheduler", scheduler) from None
    with client:
        futures = [client.submit(prove_design, sweep.task, design, claims, pure=False) for design in designs]
        return list(client.gather(futures))


def prove_design(task: Task, design: dict[str, float], claims: Sequence[str]) -> tuple[Verdict, ...]:
    """Return what comes of claims on one design; undecided, with why, where it has no surface or no proof."""
    try:
        family = task.family()
        # Of a model of one patch it goes without saying on which a claim is proved.
        subject = family.varied[0].with_parameters(design) if len(family.names) == 1 else family.design(design)
        return prove(subject, tuple(claims), unit=str(task.model.get("unit", "")))
    except (ModelError, NoProofError) as error:
        return tuple(Verdict("undecided", claim, 0, why=str(error)) for claim in claims)
