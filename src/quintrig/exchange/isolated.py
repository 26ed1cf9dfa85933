"""Reading CAD files in a process of its own: a damaged or hostile file may crash or hang the C++ that reads it."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

from quintrig.errors import QuintrigError
from quintrig.exchange.faces import Contents

SECONDS = 300
"""Time that a file may take; a large assembly takes some seconds."""

LARGEST = 512 * 2**20
"""Bytes of a file that is read at all."""

_MEMORY = 16 * 2**30  # bytes of address space for the reading process

_STOPPED = {1: "its terminal closed", 2: "interrupted", 9: "killed, perhaps for want of memory", 15: "terminated"}
"""Signals that are no fault of the file, in words."""

SUFFIXES = (".step", ".stp", ".iges", ".igs", ".brep", ".3dm")
"""Endings of the files that hold CAD surfaces."""


def read(path: Path, seconds: float = SECONDS) -> Contents:
    """Return what a CAD file holds.

    Raises QuintrigError, in one line, where it is missing, of another kind, damaged, too large or takes too long.
    """
    _check(path)
    with tempfile.TemporaryDirectory() as folder:
        answer = Path(folder) / "contents.json"
        command = [sys.executable, "-m", "quintrig.exchange.isolated", str(path.absolute()), str(answer)]
        try:
            done = subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL, timeout=seconds, check=False)
        except subprocess.TimeoutExpired:
            raise QuintrigError(f"{path}: reading took more than {seconds:g} s; export fewer faces") from None
        if not answer.exists() and -done.returncode in _STOPPED:
            raise QuintrigError(f"{path}: reading was stopped from outside ({_STOPPED[-done.returncode]}); try again")
        if not answer.exists():
            # A crash in C++ leaves a signal or a code, and nothing that would help the user.
            how = f"signal {-done.returncode}" if done.returncode < 0 else f"code {done.returncode}"
            raise QuintrigError(
                f"{path}: the CAD library broke down on it ({how}); the file is damaged, export it again"
            )
        told = json.loads(answer.read_text(encoding="utf-8"))
    if "error" in told:
        raise QuintrigError(str(told["error"]).replace(str(path.absolute()), str(path)))
    return Contents.from_dict(told)


def read_here(path: Path) -> Contents:
    """Return what a file holds, read in this process: for files that quintrig itself has just written."""
    if path.suffix.lower() == ".3dm":
        from quintrig.exchange.rhino import read_3dm

        return read_3dm(path)
    from quintrig.exchange.cad_read import read_cad

    return read_cad(path)


def _check(path: Path) -> None:
    if path.suffix.lower() not in SUFFIXES:
        raise QuintrigError(f"{path}: expected a file ending in {', '.join(SUFFIXES)}")
    try:
        if path.is_dir():
            raise QuintrigError(f"{path}: expected a file, found a folder")
        size = path.stat().st_size
        with path.open("rb") as file:
            file.read(1)
    except FileNotFoundError:
        raise QuintrigError(f"{path}: no such file; check the path") from None
    except (OSError, ValueError) as error:
        raise QuintrigError(f"{path}: cannot be read ({getattr(error, 'strerror', None) or error})") from None
    if not 0 < size <= LARGEST:
        found = "an empty one" if size == 0 else f"{size >> 20} MB"
        raise QuintrigError(f"{path}: expected a CAD file of at most {LARGEST >> 20} MB, found {found}")


def _bound_memory() -> None:
    """Let a file that asks for absurd amounts of memory fail alone; where the system can."""
    try:
        import resource
    except ImportError:  # not on Windows
        return
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = _MEMORY if hard == resource.RLIM_INFINITY else min(hard, _MEMORY)
    resource.setrlimit(resource.RLIMIT_AS, (most, hard))


def _answer(path: Path, answer: Path) -> None:
    try:
        told = read_here(path).to_dict()
    except QuintrigError as error:
        told = {"error": str(error)}
    except Exception as error:
        first = (str(error).splitlines() or [""])[0][:200]
        told = {"error": f"{path}: cannot be read as CAD ({type(error).__name__}: {first}); export it again"}
    partial = answer.with_suffix(".part")
    partial.write_text(json.dumps(told), encoding="utf-8")
    partial.replace(answer)


if __name__ == "__main__":
    _bound_memory()
    _answer(Path(sys.argv[1]), Path(sys.argv[2]))
