"""What is said to be written is on the disk, what is damaged is made anew, and what is terminated cleans up."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from cli_runner import quintrig
from quintrig.exchange.cad import isolated
from quintrig.model.starter import starter
from quintrig.support import durable, files
from quintrig.support.errors import QuintrigError
from quintrig.sweep import Axis, DesignSpace, Question, Task, load_sweep, open_sweep, run, select
from quintrig.sweep import store as sweep_store
from test_sweep_store import MODEL, NAMES, parts, stamps

pytest.importorskip("polars")
pytest.importorskip("pyarrow")


def task(low=-3.0):
    return Task(MODEL, "hill", DesignSpace((Axis(NAMES[0], low, 1.0, 40),)), 6)


@pytest.fixture
def finished(tmp_path, monkeypatch):
    monkeypatch.setattr(sweep_store, "PART", 16)
    folder = tmp_path / "out"
    run(open_sweep(folder, task()))
    return folder


def rows(folder):
    return select(load_sweep(folder), Question())


# ------------------------------------------------------------------------------------------------ damaged sweeps

DAMAGED = {
    "empty": b"",
    "cut off": b'{"format": 3, "mod',
    "zeros": bytes(400),
    "another thing": b"[1, 2]",
    "keys missing": b'{"format": 3, "model": {}}',
    "wrong types": b'{"format": 3, "model": 1, "patch": 2, "space": 3, "points": "x", "relative": null, "flat": 0}',
    "not text": b"\xff\xfe\x00",
}


@pytest.mark.parametrize("data", DAMAGED.values(), ids=DAMAGED)
def test_a_damaged_description_is_told_in_one_line_and_made_anew(finished, data):
    place, before, there = finished / "sweep.json", rows(finished), stamps(finished)
    whole = place.read_bytes()
    place.write_bytes(data)
    told = quintrig("sweep", finished)
    assert (told.code, told.err.count("\n")) == (2, 1)
    assert "the command that began the sweep again" in told.err
    sweep = open_sweep(finished, task())
    assert sweep.repaired == ("sweep.json",)
    run(sweep)
    assert place.read_bytes() == whole
    assert stamps(finished) == there  # nothing is computed twice
    np.testing.assert_equal(rows(finished), before)


def test_a_lost_description_is_made_anew_but_never_around_parts_of_another_sweep(finished):
    (finished / "sweep.json").unlink()
    there = stamps(finished)
    with pytest.raises(QuintrigError, match="belongs to another sweep"):
        open_sweep(finished, task(low=-2.0))
    assert stamps(finished) == there
    assert open_sweep(finished, task()).missing() == []


def cut(data):
    return data[: len(data) // 2]


def flipped(data):
    middle = len(data) // 4
    return data[:middle] + bytes([data[middle] ^ 255]) + data[middle + 1 :]


@pytest.mark.parametrize("damage", [lambda _: b"", cut, lambda d: bytes(len(d)), lambda _: b"PAR1", flipped])
def test_a_damaged_part_is_computed_again_and_no_other(finished, damage):
    before, there = rows(finished), stamps(finished)
    part = parts(finished)[1]
    part.write_bytes(damage(part.read_bytes()))
    sweep = open_sweep(finished, task())
    assert sweep.repaired == (part.name,)
    assert sweep.missing() == [1]
    run(sweep)
    np.testing.assert_equal(rows(finished), before)
    after = stamps(finished)
    assert {name for name in after if after[name] != there[name]} == {part.name}


def test_a_question_leaves_out_an_empty_part_and_says_so(finished):
    parts(finished)[0].write_bytes(b"")
    told = quintrig("sweep", finished)
    assert told.code == 0
    assert told.err == "1 of 3 parts are missing or cut off: the answer is of the others\n"
    assert "24 of 40 designs" in told.out


# ---------------------------------------------------------------------------------------------------- on the disk


@pytest.mark.skipif(sys.platform == "win32", reason="folders cannot be synchronised there")
@pytest.mark.parametrize("write", [files.write_whole, files.write_first])
def test_a_file_and_the_folders_that_name_it_are_on_the_disk_before_it_counts_as_written(tmp_path, monkeypatch, write):
    synced = []
    real = os.fsync

    def fsync(handle):
        synced.append(str(Path(f"/proc/self/fd/{handle}").readlink()) if sys.platform == "linux" else str(handle))
        real(handle)

    monkeypatch.setattr(durable.os, "fsync", fsync)
    write(tmp_path / "new" / "deep" / "file.txt", "text")
    assert len(synced) == 4
    if sys.platform == "linux":
        new = tmp_path / "new"
        assert synced[:2] == [str(new), str(tmp_path)]  # the names of the folders
        assert synced[2].startswith(str(new / "deep" / ".file.txt."))  # the content, still under its draft's name
        assert synced[3] == str(new / "deep")  # the name


# ---------------------------------------------------------------------------------------------------- terminated

posix = pytest.mark.skipif(sys.platform == "win32", reason="has no such signals")


def started(tmp_path, script, *arguments):
    """Start quintrig after a script that may hold it somewhere; wait until it says so."""
    heard = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"  # nohup may have silenced it
    command = f"{heard}{script}\nfrom quintrig.cli import main\nmain()"
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    process = subprocess.Popen(
        [sys.executable, "-c", command, *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
    )
    deadline = time.monotonic() + 60.0
    while not (tmp_path / "held").exists():
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < deadline
        time.sleep(0.02)
    return process


HELD = """
import time, pathlib, quintrig.support.files as files
real = files.flush
def hold(file):
    real(file)
    pathlib.Path({held!r}).touch()
    time.sleep(60)
files.flush = hold
"""


@posix
@pytest.mark.parametrize(("name", "code"), [("SIGTERM", 143), ("SIGHUP", 129), ("SIGINT", 130)])
@pytest.mark.parametrize("command", [("export", "m.toml", "m.stl"), ("table", "m.toml", "-o", "m.csv")])
def test_a_run_that_is_terminated_leaves_no_draft(tmp_path, monkeypatch, name, code, command):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "m.toml").write_text(starter("sphere"))
    process = started(tmp_path, HELD.format(held=str(tmp_path / "held")), *command)
    process.send_signal(getattr(signal, name))
    _, err = process.communicate(timeout=30)
    assert (process.returncode, err) == (code, "quintrig: interrupted\n")
    assert sorted(file.name for file in tmp_path.iterdir()) == ["held", "m.toml"]


READING = """
import sys, pathlib
from quintrig.exchange.cad import isolated
isolated.sys = type("S", (), {{"executable": {python!r}}})
"""


def ended(pid, patience=10.0):
    """Whether a process is gone within seconds, or waits only for whoever takes its place's word of it."""
    until = time.monotonic() + patience
    while time.monotonic() < until:
        try:
            os.kill(pid, 0)
            if Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z":
                return True
        except (ProcessLookupError, FileNotFoundError):
            return True
        time.sleep(0.05)
    return False


@posix
def test_a_terminated_import_ends_its_reader_and_removes_its_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "m.brep").write_text("never read")
    python = tmp_path / "python"
    python.write_text(f"#!/bin/sh\necho $$ > {tmp_path}/pid\ntouch {tmp_path}/held\nexec sleep 60\n")
    python.chmod(0o755)
    process = started(tmp_path, READING.format(python=str(python)), "check", "m.brep")
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=30)
    assert process.returncode == 143
    assert ended(int((tmp_path / "pid").read_text()))
    assert sorted(file.name for file in tmp_path.iterdir()) == ["held", "m.brep", "pid", "python"]


@posix
@pytest.mark.parametrize("name", ["SIGTERM", "SIGKILL"])
def test_a_reader_that_is_stopped_does_not_blame_the_file(tmp_path, monkeypatch, name):
    file = tmp_path / "m.brep"
    file.write_text("never read")
    python = tmp_path / "python"
    python.write_text(f"#!/bin/sh\nkill -{name[3:]} $$\n")
    python.chmod(0o755)
    monkeypatch.setattr(isolated.sys, "executable", str(python))
    with pytest.raises(QuintrigError, match="reading was stopped from outside") as found:
        isolated.read(file)
    assert "damaged" not in str(found.value)


def test_a_handler_of_the_caller_is_left_alone():
    before = signal.getsignal(signal.SIGTERM)
    assert quintrig("--version").code == 0
    assert signal.getsignal(signal.SIGTERM) == before
