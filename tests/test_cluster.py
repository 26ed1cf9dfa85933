"""A sweep on a real ``dask.distributed`` cluster of two worker processes: complete and identical, whatever dies."""

import os
import signal
import sys
import time
from contextlib import suppress

import numpy as np
import pytest

import quintrig
from cli_runner import quintrig as command
from quintrig.support.errors import QuintrigError
from quintrig.sweep import Axis, DesignSpace, Task, open_sweep, run
from quintrig.sweep import store as sweep_store

distributed = pytest.importorskip("distributed")
pl = pytest.importorskip("polars")
pytest.importorskip("pyarrow")

CAR = "examples/car_boot.toml"


def two_workers():
    return distributed.LocalCluster(
        processes=True, n_workers=2, threads_per_worker=1, dashboard_address=":0", silence_logs=50
    )


@pytest.fixture(scope="module")
def cluster():
    with two_workers() as found:
        yield found


def task(counts=(9, 9, 6, 6), points=32):
    model = quintrig.load(CAR)
    names = ("alpha1", "zeta1", "alpha2", "zeta2")
    axes = tuple(Axis(name, -4.0, 1.0, count) for name, count in zip(names, counts, strict=True))
    return Task(model.to_dict(), model.name, DesignSpace(axes), points)


def everything(folder):
    return pl.read_parquet(sorted(folder.glob("part-*.parquet")))


def alive(pid):
    with suppress(OSError):
        os.kill(pid, 0)
        return True
    return False


def test_a_worker_that_is_killed_changes_nothing(cluster, tmp_path, monkeypatch):
    monkeypatch.setattr(sweep_store, "PART", 64)
    with distributed.Client(cluster, set_as_default=False) as client:
        pids = list(client.run(os.getpid).values())
    assert len(set(pids)) == 2
    assert os.getpid() not in pids
    wanted = task()
    killed = []

    def kill(done, total):
        if done >= 5 * 64 and not killed:
            killed.append(done)
            os.kill(pids[0], signal.SIGKILL)

    run(open_sweep(tmp_path / "cluster", wanted), cluster.scheduler_address, progress=kill)
    limit = time.monotonic() + 10
    while alive(pids[0]) and time.monotonic() < limit:
        time.sleep(0.01)
    assert not alive(pids[0])
    assert killed
    assert killed[0] < wanted.space.count / 2  # half of the work and more was still to do
    monkeypatch.setattr(sweep_store, "PART", 64)
    run(open_sweep(tmp_path / "here", wanted))
    found, local = (everything(tmp_path / name) for name in ("cluster", "here"))
    assert found.equals(local)
    assert len(found) == wanted.space.count
    assert np.array_equal(found.select(wanted.space.names).to_numpy(), wanted.space.designs(0, wanted.space.count))


def test_a_cluster_goes_on_with_a_sweep_begun_here(cluster, tmp_path, monkeypatch):
    monkeypatch.setattr(sweep_store, "PART", 16)

    class Stop(Exception):
        pass

    def stop(done, total):
        if done >= 32:
            raise Stop

    wanted = task((5, 5, 2, 2), 8)
    with pytest.raises(Stop):
        run(open_sweep(tmp_path / "s", wanted), progress=stop)
    before = {file.name: file.stat().st_mtime_ns for file in (tmp_path / "s").glob("part-*")}
    assert before
    run(open_sweep(tmp_path / "s", wanted), cluster.scheduler_address)
    run(open_sweep(tmp_path / "whole", wanted))
    after = {file.name: file.stat().st_mtime_ns for file in (tmp_path / "s").glob("part-*")}
    assert {name: after[name] for name in before} == before
    assert everything(tmp_path / "s").equals(everything(tmp_path / "whole"))


def test_a_scheduler_that_is_lost_is_told_in_one_line_and_the_sweep_goes_on_later(tmp_path, monkeypatch):
    cluster = two_workers()
    monkeypatch.setattr(sweep_store, "PART", 16)
    wanted = task((9, 9, 2, 2), 16)

    def lose(done, total):
        if done >= 32:
            cluster.close()

    with cluster, pytest.raises(QuintrigError, match=r"scheduler .*running it again goes on") as error:
        run(open_sweep(tmp_path / "s", wanted), cluster.scheduler_address, progress=lose)
    assert "\n" not in str(error.value)
    assert 2 <= len(list((tmp_path / "s").glob("part-*"))) < 21
    run(open_sweep(tmp_path / "s", wanted))
    assert len(everything(tmp_path / "s")) == wanted.space.count


@pytest.mark.parametrize(
    "address",
    ["tcp://127.0.0.1:1", "127.0.0.1:1", "nonsense", "tcp://", "carrier-pigeon://x:1", "tcp://nosuch.invalid:8786"],
)
def test_a_scheduler_that_cannot_be_reached_is_told_in_one_line(tmp_path, monkeypatch, address):
    monkeypatch.setattr(sys.modules["quintrig.sweep.run"], "_PATIENCE", 0.5)
    result = command(
        "sweep", CAR, "--vary", "zeta1=0:1:3", "-o", tmp_path / "out", "--points", 8, "--scheduler", address
    )
    assert result.code == 2
    assert f"--scheduler {address}: cannot be reached" in result.err
    assert result.err.splitlines()[-1].startswith("quintrig: --scheduler")
    # The folder is ready for another try.
    assert command("sweep", CAR, "--vary", "zeta1=0:1:3", "-o", tmp_path / "out", "--points", 8).code == 0


def test_a_scheduler_without_workers_is_told_in_one_line_and_the_sweep_goes_on_later(tmp_path, monkeypatch):
    monkeypatch.setattr(sys.modules["quintrig.sweep.run"], "_IDLE", 1.5)
    arguments = ("sweep", CAR, "--vary", "zeta1=0:1:3", "-o", tmp_path / "out", "--points", 8)
    with distributed.LocalCluster(n_workers=0, dashboard_address=":0", silence_logs=50) as empty:
        result = command(*arguments, "--scheduler", empty.scheduler_address)
        assert result.code == 2
        said = f"quintrig: --scheduler {empty.scheduler_address}: has had no worker"
        assert result.err.splitlines()[-1].startswith(said)
    assert command(*arguments).code == 0


def test_workers_that_all_die_are_told_of_and_what_they_did_stays(tmp_path, monkeypatch):
    monkeypatch.setattr(sys.modules["quintrig.sweep.run"], "_IDLE", 1.5)
    monkeypatch.setattr(sweep_store, "PART", 16)
    wanted = task((9, 9, 2, 2), 16)
    with two_workers() as cluster:

        def dismiss(done, total):
            if done >= 32:
                cluster.scale(0)

        with pytest.raises(QuintrigError, match="has had no worker"):
            run(open_sweep(tmp_path / "s", wanted), cluster.scheduler_address, progress=dismiss)
    assert 2 <= len(list((tmp_path / "s").glob("part-*"))) < 21
    run(open_sweep(tmp_path / "s", wanted))
    assert len(everything(tmp_path / "s")) == wanted.space.count
