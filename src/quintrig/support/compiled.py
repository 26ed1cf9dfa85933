"""Marks for what Numba compiles, and where compiled loops are kept.

A loop takes whole and real numbers only; arrays come as the addresses of their memory. So one loop is one piece of
machine code with one entry, which the next process loads from disk without importing Numba at all: Numba and its
registries take longer to import than every small command takes to run.

A file of machine code holds for one processor and one version of Numba, by its name, and for the sources of quintrig
that go into it, by the name of its folder: after any change the loops are compiled anew, and two versions of quintrig
never share one.
"""

import ctypes
import hashlib
import json
import os
import tempfile
from collections.abc import Callable
from functools import cache, cached_property
from importlib.util import find_spec
from inspect import get_annotations
from pathlib import Path
from threading import RLock
from typing import Any, TypeVar, cast

from quintrig.support.marks import MARKED, Use

Function = TypeVar("Function", bound=Callable[..., Any])

SOURCES = (
    "basis/tape_jit",
    "basis/trigonometric_jit",
    "interrogation/dop853",
    "interrogation/field_jit",
    "interrogation/follow_jit",
    "interrogation/line_jit",
    "interrogation/near_jit",
    "interrogation/step_jit",
    "kernel/blocks",
    "quantities/classify",
    "support/compiled",
    "support/machine_code",
    "support/memory",
    "support/marks",
    "support/numba_inside",
    "kernel/contraction",
    "quantities/curvature",
    "quantities/invariants",
    "kernel/driver",
    "support/tolerance",
    "kernel/outputs",
    "quantities/table",
    "sweep/summarise",
    "kernel/stores",
)
"""Modules whose text goes into compiled code."""

BLOCK = 64
"""Points in a block: 38 scratch rows of half a KiB stay in a level-1 cache beside the increments. Measured best of 32,
48, 64, 72, 96 and 128."""


_LOCK = RLock()


def scalar(function: Function) -> Function:
    """Mark a scalar formula, inlined where it is used, so that the loop around it vectorises."""
    MARKED[function] = Use(inlined=True, constants=False)
    return function


def unrolled(function: Function) -> Function:
    """Mark loops over a number of terms that is a constant where they are used, so that they unroll there."""
    MARKED[function] = Use(inlined=True, constants=True)
    return function


def part(function: Function) -> Function:
    """Mark a part of a loop that is compiled once and called."""
    MARKED[function] = Use(inlined=False, constants=False)
    return function


class Loop:
    """A function of numbers that is compiled, or found on disk, when it is first needed; it releases the interpreter.

    Parameters annotated ``float`` are real numbers, all others whole ones; nothing is returned. It must not reserve
    memory: Numba's way to do so is not there where Numba is not.
    """

    def __init__(self, function: Callable[..., None]) -> None:
        """Take the function; only numbers may be held in its closure, since they are part of the name of its file."""
        self.function = function
        words = get_annotations(function)
        self.kinds = tuple("d" if words[name] is float else "q" for name in words if name != "return")
        cells = [cast(object, cell.cell_contents) for cell in function.__closure__ or ()]
        if not all(isinstance(value, int) for value in cells):
            raise TypeError(f"{function.__qualname__}: expected only whole numbers in its closure, found {cells}")
        named = zip(function.__code__.co_freevars, cells, strict=True)
        self.name = ".".join([function.__module__, function.__name__, *(f"{key}{int(n)}" for key, n in named)])  # type: ignore[call-overload]

    def __call__(self, *numbers: float) -> None:
        """Run it."""
        self._entry(*numbers)

    @cached_property
    def address(self) -> int:
        """Where its machine code begins."""
        with _LOCK:
            return _found(self) or _compiled(self)

    @cached_property
    def _entry(self) -> Callable[..., None]:
        kinds = [ctypes.c_double if kind == "d" else ctypes.c_int64 for kind in self.kinds]
        return ctypes.CFUNCTYPE(None, *kinds)(self.address)


def loop(function: Callable[..., None]) -> Loop:
    """Make a loop that is compiled when first needed, and kept on disk where there is a folder to keep it in."""
    return Loop(function)


def cache_folder() -> Path | None:
    """Return the folder for compiled loops, made if need be, or None where none can be written.

    It lies in NUMBA_CACHE_DIR, else in XDG_CACHE_HOME/quintrig, else in ~/.cache/quintrig.
    """
    folder = _folder()
    try:
        if folder is not None:
            folder.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):
                return folder
    except OSError:  # no permission, or a full disk
        pass
    return None


def _folder() -> Path | None:
    named = os.environ.get("NUMBA_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME")
    try:
        return (Path(named) if named else Path.home() / ".cache") / "quintrig" / f"compiled-{_digest()}"
    except (OSError, RuntimeError):  # no home folder, or sources that cannot be read
        return None


def _found(wanted: Loop) -> int | None:
    """Return where the loop's machine code from an earlier process is loaded to; None for a missing or broken file."""
    from quintrig.support import machine_code

    folder = _folder()
    if folder is None:
        return None
    try:
        data = (folder / _file(wanted)).read_bytes()
    except OSError:
        return None
    return machine_code.load(data)


def _compiled(wanted: Loop) -> int:
    """Return where the loop lies after compiling it; its machine code is kept for later processes."""
    from quintrig.support import machine_code, numba_inside

    address, code = numba_inside.compiled(wanted.function, wanted.kinds, wanted.name)
    folder = cache_folder()
    if folder is not None:
        try:
            with tempfile.NamedTemporaryFile(dir=folder, suffix=".part", delete=False) as file:
                try:
                    file.write(machine_code.packed(code))
                    file.close()
                    Path(file.name).replace(folder / _file(wanted))
                except BaseException:
                    file.close()
                    Path(file.name).unlink(missing_ok=True)
                    raise
        except OSError:  # a full disk
            pass
    return address


def _file(wanted: Loop) -> str:
    return f"{wanted.name}-{_machine()}.code"


@cache
def _machine() -> str:
    """Return a digest of the processor and of Numba as it is installed and set up, without importing it."""
    from quintrig.support import machine_code

    found = find_spec("numba")
    stamps: list[object] = []
    if found is not None and found.origin:
        about = Path(found.origin).with_name("_version.py").stat()
        stamps = [about.st_mtime_ns, about.st_size]
    settings = sorted((k, v) for k, v in os.environ.items() if k.startswith("NUMBA_") and k != "NUMBA_CACHE_DIR")
    return hashlib.sha256(json.dumps([machine_code.processor(), stamps, settings]).encode()).hexdigest()[:12]


def _digest() -> str:
    """Return a digest of everything in quintrig that compiled code depends on."""
    here = Path(__file__).parents[1]
    return hashlib.sha256(b"".join((here / f"{name}.py").read_bytes() for name in SOURCES)).hexdigest()[:16]
