"""Reading CAD files in a process of its own: a damaged or hostile file may crash or hang the C++ that reads it."""

import json
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Collection, Sequence
from pathlib import Path
from time import monotonic
from typing import Any

from quintrig.exchange.cad.faces import Contents
from quintrig.support.errors import QuintrigError, printable
from quintrig.support.files import in_utf8, open_regular

LARGEST = 512 * 2**20
"""Bytes of a file that is read at all."""

_SECONDS, _SECONDS_A_MEGABYTE, _MOST_SECONDS = 10.0, 20.0, 300.0
_MEMORY, _MEMORY_A_BYTE, _MOST_MEMORY = 2 * 2**30, 100, 16 * 2**30
_PATIENCE = 3.0  # times the processor time, on a machine that is busy
_TRIES = 12  # processes that one file may bring down

_STOPPED = {1: "its terminal closed", 2: "interrupted", 9: "killed, perhaps for want of memory", 15: "terminated"}
"""Signals that are no fault of the file, in words."""

CAD_SUFFIXES = (".step", ".stp", ".iges", ".igs", ".brep", ".3dm")
"""Endings of the files that hold CAD surfaces."""


def allowance(size: int) -> float:
    """Return the seconds of processor time that a file of ``size`` bytes may take; a large assembly takes some."""
    return min(_SECONDS + _SECONDS_A_MEGABYTE * size / 2**20, _MOST_SECONDS)


def read(path: Path, seconds: float | None = None) -> Contents:
    """Return what a CAD file holds; a face on which the library breaks down has a problem, and the others are read.

    ``seconds`` of processor time are what it may take, by default as many as its size allows. Raises QuintrigError, in
    one line, where the file is missing, of another kind, damaged, too large or takes too long.
    """
    size = _check(path)
    seconds = allowance(size) if seconds is None else seconds
    ends = monotonic() + _PATIENCE * seconds
    skip: list[int] = []
    plain, how = False, ""
    for _ in range(_TRIES):
        told, stage, how = _tried(path, size, skip, plain, seconds, ends - monotonic())
        if told is not None:
            return Contents.from_dict(told)
        if stage > 0 and stage not in skip:
            skip.append(stage)
        elif stage == 0 and how and not plain and path.suffix.lower() in (".step", ".stp"):
            plain = True
        else:
            break
        if monotonic() > ends:
            break
    if not how:
        raise QuintrigError(
            f"{path}: reading took more than {seconds:.3g} s, too long for a file of {_bytes(size)}: it is damaged or "
            "holds what the CAD library never ends with; export it again, or in another format"
        )
    raise QuintrigError(
        f"{path}: the CAD library broke down on it ({how}): it is damaged or holds what the library cannot read; "
        "export it again, or in another format"
    )


def _tried(
    path: Path, size: int, skip: Sequence[int], plain: bool, seconds: float, patience: float
) -> tuple[dict[str, Any] | None, int, str]:
    """Read in a process of its own; return what it told, the face it was at (0: before the first), and how it ended.

    How it ended is empty where the time was up.
    """
    with tempfile.TemporaryDirectory() as folder:
        answer = Path(folder) / "contents.json"
        source = _spelt(path.absolute(), Path(folder))
        orders = {"skip": list(skip), "plain": plain, "seconds": seconds, "memory": _memory(size)}
        command = [sys.executable, "-m", "quintrig.exchange.cad.isolated", str(source), str(answer)]
        try:
            done = subprocess.run(
                [*command, json.dumps(orders)],
                capture_output=True,
                stdin=subprocess.DEVNULL,
                timeout=max(patience, 1.0),
                check=False,
            )
        except subprocess.TimeoutExpired:
            return None, _stage(answer), ""
        if answer.exists():
            told = json.loads(answer.read_text(encoding="utf-8"))
            if "error" in told:
                raise QuintrigError(str(told["error"]).replace(str(source), str(path)))
            return told, 0, ""
        if -done.returncode == getattr(signal, "SIGXCPU", None):
            return None, _stage(answer), ""
        if -done.returncode in _STOPPED:
            raise QuintrigError(f"{path}: reading was stopped from outside ({_STOPPED[-done.returncode]}); try again")
        # A crash in C++ leaves a signal or a code, and nothing that would help the user.
        how = f"signal {-done.returncode}" if done.returncode < 0 else f"code {done.returncode}"
        return None, _stage(answer), how


def read_here(
    path: Path, skip: Collection[int] = (), plain: bool = False, begin: Callable[[int], None] = lambda _: None
) -> Contents:
    """Return what a file holds, read in this process: for files that quintrig itself has just written."""
    if path.suffix.lower() == ".3dm":
        from quintrig.exchange.cad.rhino import read_3dm

        return read_3dm(path)
    from quintrig.exchange.cad.read import read_cad

    return read_cad(path, skip, plain, begin)


def _memory(size: int) -> int:
    """Return the bytes of address space that reading a file of ``size`` bytes may take."""
    return min(_MEMORY + _MEMORY_A_BYTE * size, _MOST_MEMORY)


def _bytes(size: int) -> str:
    return f"{size:,} bytes" if size < 10_000 else f"{size / 1000:,.0f} kB"


def _stage(answer: Path) -> int:
    """Return the number of the face that the process had begun."""
    try:
        return int(answer.with_suffix(".face").read_text(encoding="utf-8") or 0)
    except (OSError, ValueError):
        return 0


def _spelt(path: Path, folder: Path) -> Path:
    """Return the file under a name that C++ takes: through a link in ``folder`` where its own is no UTF-8."""
    if in_utf8(path):
        return path
    link = folder / f"{printable(path.stem)[:60]}{path.suffix}"
    try:
        link.symlink_to(path)
    except OSError:  # not on every Windows
        shutil.copyfile(path, link)
    return link


def _check(path: Path) -> int:
    """Return the size of the file in bytes; QuintrigError where there is nothing to be read."""
    if path.suffix.lower() not in CAD_SUFFIXES:
        raise QuintrigError(f"{path}: expected a file ending in {', '.join(CAD_SUFFIXES)}")
    try:
        if path.is_dir():
            raise QuintrigError(f"{path}: expected a file, found a folder")
        size = path.stat().st_size
        with open_regular(path) as file:
            file.read(1)
    except FileNotFoundError:
        raise QuintrigError(f"{path}: no such file; check the path") from None
    except (OSError, ValueError) as error:
        raise QuintrigError(f"{path}: cannot be read ({getattr(error, 'strerror', None) or error})") from None
    if not 0 < size <= LARGEST:
        found = "an empty one" if size == 0 else f"{size >> 20} MB"
        raise QuintrigError(f"{path}: expected a CAD file of at most {LARGEST >> 20} MB, found {found}")
    return size


def _bound(seconds: float, memory: int) -> None:
    """Let a file that asks for absurd amounts of time or memory fail alone; where the system can."""
    try:
        import resource
    except ImportError:  # not on Windows
        return
    for kind, most in ((resource.RLIMIT_AS, memory), (resource.RLIMIT_CPU, int(seconds) + 1)):
        _, hard = resource.getrlimit(kind)
        resource.setrlimit(kind, (most if hard == resource.RLIM_INFINITY else min(hard, most), hard))


def _answer(path: Path, answer: Path, orders: dict[str, Any]) -> None:
    at = answer.with_suffix(".face")

    def begin(number: int) -> None:
        at.write_text(str(number), encoding="utf-8")

    try:
        told = read_here(path, orders["skip"], orders["plain"], begin).to_dict()
    except QuintrigError as error:
        told = {"error": str(error)}
    except MemoryError:
        told = {
            "error": f"{path}: needs far more memory than a file of its size should; it is damaged, export it again"
        }
    except Exception as error:
        first = (str(error).splitlines() or [""])[0][:200]
        told = {"error": f"{path}: cannot be read as CAD ({type(error).__name__}: {first}); export it again"}
    partial = answer.with_suffix(".part")
    partial.write_text(json.dumps(told), encoding="utf-8")
    partial.replace(answer)


if __name__ == "__main__":
    given = json.loads(sys.argv[3])
    _bound(given["seconds"], given["memory"])
    _answer(Path(sys.argv[1]), Path(sys.argv[2]), given)
