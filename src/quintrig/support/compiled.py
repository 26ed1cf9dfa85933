"""The two ways in which quintrig compiles with Numba, as decorators that keep the types they are put on.

Compiled loops are kept on disk. Numba checks only the file that a loop is written in, not the files of the formulas
inlined into it, so the folder's name carries a digest of all of them: after any change the loops are compiled anew,
and two versions of quintrig never share one.
"""

import hashlib
import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast
from uuid import uuid4

import numba
import numba.extending
from llvmlite import ir as _ir

from quintrig.support.numba_inside import share_cache

Function = TypeVar("Function", bound=Callable[..., Any])

SOURCES = (
    "basis/tape_jit",
    "basis/trigonometric_jit",
    "kernel/blocks",
    "quantities/classify",
    "support/compiled",
    "support/numba_inside",
    "kernel/contraction",
    "quantities/curvature",
    "quantities/invariants",
    "kernel/driver",
    "support/tolerance",
    "kernel/outputs",
    "quantities/table",
    "scan/jets_jit",
    "scan/nearest_jit",
    "shaping/fitting/gram_jit",
    "sweep/summarise",
    "kernel/stores",
)
"""Modules whose text goes into compiled code."""

BLOCK = 64
"""Points in a block: 38 scratch rows of half a KiB stay in a level-1 cache beside the increments. Measured best of 32,
48, 64, 72, 96 and 128."""

_PROCESS = uuid4().hex[:8]

_config = cast(Any, numba).config
_types = cast(Any, numba).types
ir = cast(Any, _ir)
_intrinsic = cast(Callable[[Any], Any], numba.extending.intrinsic)
_njit = cast(Callable[..., Callable[[Any], Any]], numba.njit)

# NaN and infinity must survive, since they mark singular points, and sums keep their order, since differences such as
# 1 - t carry the relative accuracy at the end points. Fused multiply-add and shared reciprocals are all that is gained.
_FAST = {"contract", "nsz", "arcp"}


def scalar(function: Function) -> Function:
    """Compile a scalar formula, inlined where it is used, so that the loop around it vectorises."""
    return cast(Function, _njit(inline="always", error_model="numpy")(function))


def loop(function: Function) -> Function:
    """Compile a loop over arrays that releases the interpreter, kept on disk where there is a folder to keep it in."""
    folder = cache_folder()
    before = _config.CACHE_DIR
    try:
        # Numba reads this setting as the decorator runs; other packages must not see ours.
        _config.CACHE_DIR = str(folder or "")
        options: dict[str, Any] = {"fastmath": _FAST, "error_model": "numpy", "nogil": True}
        compiled = _njit(cache=folder is not None, **options)(function)
    finally:
        _config.CACHE_DIR = before
    if folder is not None:
        share_cache(compiled, _PROCESS)
    return cast(Function, compiled)


def _pointer(item: Any) -> Callable[[int], Any]:
    """Return a compiled function from an address to a pointer that is indexed like an array."""

    def typed(_context: Any, _address: Any) -> Any:
        def generated(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.inttoptr(arguments[0], context.get_value_type(signature.return_type))

        return _types.CPointer(item)(_types.intp), generated

    return cast(Callable[[int], Any], _intrinsic(typed))


def _stream(_context: Any, _target: Any, _source: Any) -> Any:
    def generated(context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        line = ir.VectorType(ir.DoubleType(), 8).as_pointer()
        value = builder.load(builder.inttoptr(arguments[1], line), align=8)
        store = builder.store(value, builder.inttoptr(arguments[0], line), align=64)
        store.set_metadata("nontemporal", builder.module.add_metadata([ir.Constant(ir.IntType(32), 1)]))
        return context.get_dummy_value()

    return _types.void(_types.intp, _types.intp), generated


def _fence(_context: Any) -> Any:
    def generated(context: Any, builder: Any, _signature: Any, _arguments: Any) -> Any:
        builder.fence("seq_cst")
        return context.get_dummy_value()

    return _types.void(), generated


def _call(_context: Any, _function: Any, _a: Any, _b: Any, _c: Any, _d: Any, _e: Any, _f: Any, _g: Any) -> Any:
    def generated(context: Any, builder: Any, _signature: Any, values: Any) -> Any:
        function = ir.FunctionType(ir.IntType(8).as_pointer(), [value.type for value in values[1:]])
        builder.call(builder.inttoptr(values[0], function.as_pointer()), values[1:])
        return context.get_dummy_value()

    return _types.void(*[_types.intp] * 8), generated


floats_at = _pointer(_types.float64)
words_at = _pointer(_types.int64)
codes_at = _pointer(_types.int8)
"""Memory at an address, as numbers; whoever gives the address keeps the array alive."""

call = cast(Callable[..., None], _intrinsic(_call))
"""Call the compiled function at an address with seven whole numbers."""

stream_line = cast(Callable[[int, int], None], _intrinsic(_stream))
"""Copy eight numbers to an address at the start of a cache line, past the cache: the line is not read first."""

fence = cast(Callable[[], None], _intrinsic(_fence))
"""Make all streamed lines visible to other threads."""


def cache_folder() -> Path | None:
    """Return the folder for compiled loops, made if need be, or None where none can be written.

    It lies in NUMBA_CACHE_DIR, else in XDG_CACHE_HOME/quintrig, else in ~/.cache/quintrig.
    """
    named = os.environ.get("NUMBA_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME")
    try:
        folder = (Path(named) if named else Path.home() / ".cache") / "quintrig" / f"compiled-{_digest()}"
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except (OSError, RuntimeError):  # no permission, a full disk, or no home folder
        return None


def _digest() -> str:
    """Return a digest of everything that compiled code depends on, Numba itself aside, which checks its own version."""
    here = Path(__file__).parents[1]
    return hashlib.sha256(b"".join((here / f"{name}.py").read_bytes() for name in SOURCES)).hexdigest()[:16]
