"""A sweep on disk: resumed where it was, whole files only, every failure told in one line."""

import errno
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from quintrig.quantities.classify import Thresholds
from quintrig.support.errors import QuintrigError
from quintrig.sweep import Axis, DesignSpace, Question, Task, load_sweep, open_sweep, run, select
from quintrig.sweep import store as sweep_store
from quintrig.sweep.part import columns

pl = pytest.importorskip("polars")
pytest.importorskip("pyarrow")

MODEL = {
    "name": "hill",
    "unit": "mm",
    "kind": "tensor",
    "points": [[[2 * i, 2 * j, np.sin(i) * np.cos(0.7 * j)] for j in range(6)] for i in range(6)],
}
NAMES = ("alpha1", "zeta1", "alpha2", "zeta2")


def task(*counts, points=6, low=-3.0):
    axes = tuple(Axis(name, low, 1.0, count) for name, count in zip(NAMES, counts, strict=False))
    return Task(MODEL, "hill", DesignSpace(axes), points)


@pytest.fixture
def small_parts(monkeypatch):
    monkeypatch.setattr(sweep_store, "PART", 16)


def parts(folder):
    return sorted(folder.glob("part-*.parquet"))


def stamps(folder):
    return {file.name: (file.stat().st_ino, file.stat().st_mtime_ns) for file in parts(folder)}


def everything(folder):
    return pl.read_parquet(parts(folder))


# ---------------------------------------------------------------------------------------------- what is written


def test_parts_hold_every_design_in_order_with_units_and_normal(tmp_path, small_parts):
    wanted = task(5, 4, 3)
    run(open_sweep(tmp_path / "s", wanted))
    table = everything(tmp_path / "s")
    assert table.columns == list(columns(wanted.space))
    assert np.array_equal(table.select(wanted.space.names).to_numpy(), wanted.space.designs(0, 60))
    assert [len(pl.read_parquet(part)) for part in parts(tmp_path / "s")] == [16, 16, 16, 12]
    for part in parts(tmp_path / "s"):
        notes = pl.read_parquet_metadata(part)
        assert notes["unit of gaussian_min"] == "1/mm²"
        assert notes["unit of mean_mean"] == "1/mm"
        assert notes["unit of area"] == notes["unit of thin_plate_energy"] == "mm²"
        assert notes["unit of bending_energy"] == notes["unit of singular"] == notes["unit of alpha1"] == ""
        assert notes["normal"] == "the normal points along S_u × S_v"
        assert notes["unit of length"] == "mm"


def test_threads_change_nothing(tmp_path, small_parts):
    for threads in (1, 3):
        run(open_sweep(tmp_path / str(threads), task(5, 4, 3)), threads=threads)
    assert everything(tmp_path / "1").equals(everything(tmp_path / "3"))


def test_a_sweep_is_read_back_as_it_was_begun(tmp_path):
    axes = (Axis("alpha1", -4.0, 1.0, 11), Axis("zeta2", 0.0, 1.0, 11))
    begun = open_sweep(tmp_path / "s", Task(MODEL, "hill", DesignSpace(axes, "sobol", 9, 5), 7, Thresholds(1e-5, 1e-4)))
    found = load_sweep(tmp_path / "s")
    assert (found.task, found.folder) == (begun.task, begun.folder)


# ---------------------------------------------------------------------------------------------- resuming


def test_a_stopped_sweep_goes_on_and_keeps_what_is_there(tmp_path, small_parts):
    class Stop(Exception):
        pass

    def stop(done, total):
        if done >= 32:
            raise Stop

    run(open_sweep(tmp_path / "whole", task(5, 4, 3)))
    with pytest.raises(Stop):
        run(open_sweep(tmp_path / "s", task(5, 4, 3)), progress=stop)
    before = stamps(tmp_path / "s")
    assert 0 < len(before) < 4
    kept = sum(len(pl.read_parquet(part)) for part in parts(tmp_path / "s"))  # the last part is a short one
    seen = []
    run(open_sweep(tmp_path / "s", task(5, 4, 3)), progress=lambda done, total: seen.append((done, total)))
    assert seen[0] == (kept, 60)
    assert seen[-1] == (60, 60)
    after = stamps(tmp_path / "s")
    assert {name: after[name] for name in before} == before
    assert everything(tmp_path / "s").equals(everything(tmp_path / "whole"))


def test_a_finished_sweep_is_not_touched(tmp_path, small_parts):
    run(open_sweep(tmp_path / "s", task(5, 4)))
    before = stamps(tmp_path / "s")
    run(open_sweep(tmp_path / "s", task(5, 4)))
    assert stamps(tmp_path / "s") == before


KILLED = """
import sys
from pathlib import Path
import quintrig.sweep.store as store
from quintrig.sweep import Task, open_sweep, run
from quintrig.sweep.space import DesignSpace
import json
store.PART = 64
data = json.loads(sys.argv[2])
task = Task(data["model"], "hill", DesignSpace.from_dict(data["space"]), data["points"])
run(open_sweep(Path(sys.argv[1]), task), threads=2)
"""


def test_a_killed_run_leaves_whole_files_and_is_resumed(tmp_path, monkeypatch):
    monkeypatch.setattr(sweep_store, "PART", 64)
    wanted = task(9, 9, 9, 5, points=32)
    folder = tmp_path / "s"
    child = subprocess.Popen([sys.executable, "-c", KILLED, str(folder), json.dumps(wanted.to_dict())])
    try:
        limit = time.monotonic() + 60
        while len(parts(folder)) < 3 and time.monotonic() < limit and child.poll() is None:
            time.sleep(0.002)
    finally:
        child.send_signal(signal.SIGKILL)
        child.wait()
    before = stamps(folder)
    assert 3 <= len(before) < -(-wanted.space.count // 64)
    for part in parts(folder):
        assert len(pl.read_parquet(part)) == 64
    run(open_sweep(folder, wanted))
    after = stamps(folder)
    assert {name: after[name] for name in before} == before
    run(open_sweep(tmp_path / "whole", wanted))
    assert everything(folder).equals(everything(tmp_path / "whole"))


def test_what_a_killed_run_left_half_written_is_removed(tmp_path, small_parts):
    run(open_sweep(tmp_path / "s", task(5, 4)))
    old, young = (tmp_path / "s" / f".part-000001.parquet.{name}" for name in ("old", "young"))
    for file in (old, young):
        file.write_bytes(b"PAR1")
    os.utime(old, (1, 1))
    assert len(select(load_sweep(tmp_path / "s"), Question())["area"]) == 20
    open_sweep(tmp_path / "s", task(5, 4))
    assert not old.exists()
    assert young.exists()  # it may belong to a run that is under way


def test_a_run_killed_before_it_wrote_anything_can_be_begun_again(tmp_path):
    folder = tmp_path / "s"
    folder.mkdir()
    left = folder / ".sweep.json.abc"
    left.write_text("{")
    os.utime(left, (1, 1))
    run(open_sweep(folder, task(2)))
    assert [file.name for file in sorted(folder.iterdir())] == ["part-000000.parquet", "sweep.json"]


# ---------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize("other", [task(5, 5), task(5, 4, points=8), task(5, 4, low=-2.0)])
def test_another_sweep_in_the_folder_is_refused(tmp_path, other):
    run(open_sweep(tmp_path / "s", task(5, 4)))
    before = stamps(tmp_path / "s")
    with pytest.raises(QuintrigError, match="holds another sweep"):
        open_sweep(tmp_path / "s", other)
    assert stamps(tmp_path / "s") == before


def test_of_two_that_begin_at_once_in_one_folder_the_second_is_refused(tmp_path, monkeypatch):
    first, check = task(5, 4), sweep_store._check_disk
    begun = []

    def meanwhile(folder, wanted):
        check(folder, wanted)
        if not begun:
            begun.append(wanted)
            open_sweep(folder, first)

    monkeypatch.setattr(sweep_store, "_check_disk", meanwhile)
    with pytest.raises(QuintrigError, match="holds another sweep"):
        open_sweep(tmp_path / "s", task(5, 5))
    assert load_sweep(tmp_path / "s").task == first
    begun.clear()
    assert open_sweep(tmp_path / "t", first).task == first  # the same one twice is no harm
    assert [file.name for file in (tmp_path / "t").iterdir()] == ["sweep.json"]


def test_a_folder_with_other_files_is_refused(tmp_path):
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(QuintrigError, match="expected a new or empty folder"):
        open_sweep(tmp_path, task(5))
    assert [file.name for file in tmp_path.iterdir()] == ["letter.txt"]


def test_a_file_in_place_of_the_folder_is_refused(tmp_path):
    (tmp_path / "s").write_text("dear")
    with pytest.raises(QuintrigError, match="expected a new or empty folder"):
        open_sweep(tmp_path / "s", task(5))
    with pytest.raises(QuintrigError, match="cannot be written"):
        open_sweep(tmp_path / "s" / "below", task(5))


@pytest.mark.parametrize(
    ("text", "said"),
    [("{", "is damaged"), ("[]", "is damaged"), ('{"format": 99}', "not a description"), (None, "no sweep")],
)
def test_a_folder_without_a_readable_description_is_refused(tmp_path, text, said):
    if text is not None:
        (tmp_path / "sweep.json").write_text(text)
    with pytest.raises(QuintrigError, match=said) as error:
        load_sweep(tmp_path)
    assert "\n" not in str(error.value)


def test_a_disk_that_is_too_small_is_told_before_anything_is_done(tmp_path, monkeypatch):
    usage = shutil.disk_usage(tmp_path)
    monkeypatch.setattr(shutil, "disk_usage", lambda path: usage._replace(free=100))
    with pytest.raises(QuintrigError, match=r"20 designs need .* kB, 100 bytes are free; take fewer") as error:
        open_sweep(tmp_path / "new" / "s", task(5, 4))
    assert "\n" not in str(error.value)
    assert not (tmp_path / "new").exists()


def test_a_disk_that_fills_up_is_told_in_one_line_and_the_sweep_goes_on_later(tmp_path, small_parts, monkeypatch):
    written = []
    replace = Path.replace

    def full(self, target):
        if "part" in str(target):
            written.append(target)
            if len(written) > 2:
                raise OSError(errno.ENOSPC, "No space left on device")
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(QuintrigError, match=r"No space left on device.*running it again goes on") as error:
        run(open_sweep(tmp_path / "s", task(5, 4, 3)))
    assert "\n" not in str(error.value)
    monkeypatch.undo()
    monkeypatch.setattr(sweep_store, "PART", 16)
    before = stamps(tmp_path / "s")
    assert len(before) == 2
    assert len(list((tmp_path / "s").iterdir())) == 3  # nothing half written
    run(open_sweep(tmp_path / "s", task(5, 4, 3)))
    after = stamps(tmp_path / "s")
    assert {name: after[name] for name in before} == before
    assert len(everything(tmp_path / "s")) == 60
