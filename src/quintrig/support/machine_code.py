"""Machine code of compiled loops as bytes, and how it gets into memory again: LLVM's loader alone, without Numba."""

import ctypes
import hashlib
import json
import sys
from functools import cache
from typing import Any, NamedTuple, cast

import llvmlite
import llvmlite.binding as _binding

llvm = cast(Any, _binding)

NEVER_CALLED = frozenset(
    {
        *("NRT_Free", "NRT_MemInfo_call_dtor", "numba_gil_ensure", "numba_gil_release"),
        *("numba_do_raise", "numba_runtime_build_excinfo_struct", "numba_unpickle"),
    }
)
"""What Numba's machine code names for arrays of Python and for exceptions; no loop has either."""

_kept: list[Any] = []


class Code(NamedTuple):
    """An object file, the name of the function where it is entered, and what it needs of the process."""

    entry: str
    needs: tuple[str, ...]
    binary: bytes


def packed(code: Code) -> bytes:
    """Return the code as bytes, with a digest that tells a whole file from a broken one."""
    head = json.dumps([code.entry, code.needs]).encode()
    body = len(head).to_bytes(4, "little") + head + code.binary
    return hashlib.sha256(body).digest() + body


def load(data: bytes) -> int | None:
    """Return where the entry of packed code lies once loaded; None for broken bytes or where something is missing."""
    digest, body = data[:32], data[32:]
    if hashlib.sha256(body).digest() != digest:
        return None
    start = 4 + int.from_bytes(body[:4], "little")
    entry, needs = json.loads(body[4:start])
    if not all(_is_there(name) for name in needs):
        return None
    machine = _machine()
    # Code of two processes may name different things alike, so each has an engine, that is a namespace, to itself.
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(f'target triple = "{machine.triple}"'), machine)
    engine.add_object_file(llvm.ObjectFileRef.from_data(body[start:]))
    engine.finalize_object()
    _kept.append(engine)
    return int(engine.get_function_address(entry)) or None


def processor() -> list[str]:
    """Return what machine code depends on beside its source: the processor, and the version of what loads it."""
    try:
        features = llvm.get_host_cpu_features().flatten()
    except RuntimeError:  # unknown to LLVM
        features = ""
    return [llvmlite.__version__, llvm.get_process_triple(), llvm.get_host_cpu_name(), features]


def _is_there(name: str) -> bool:
    if llvm.address_of_symbol(name):
        return True
    where = ctypes.pythonapi if name.startswith("Py") else _mathematics()
    function = getattr(where, name, ctypes.pythonapi.Py_FatalError if name in NEVER_CALLED else None)
    if function is None:
        return False
    llvm.add_symbol(name, ctypes.cast(function, ctypes.c_void_p).value)
    return True


@cache
def _mathematics() -> ctypes.CDLL:
    """Return the functions of C that the process has."""
    return ctypes.CDLL("ucrtbase" if sys.platform == "win32" else None)


@cache
def _machine() -> Any:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.Target.from_default_triple().create_target_machine(jit=True)
