"""All that is used of Numba, and above all what Numba does not promise to keep, so that a new version is tried here.

tests/test_numba_inside.py says what a version must have, and pyproject.toml the newest that was tried.
"""

# pyright: reportUnknownLambdaType=false
# Numba reads what a word means from functions of functions, whose arguments have types of Numba.

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, cast

import numba
import numba.extending
from llvmlite import ir as _ir

from quintrig.support import memory
from quintrig.support.machine_code import NEVER_CALLED, Code
from quintrig.support.marks import MARKED

ir = cast(Any, _ir)
_numba = cast(Any, numba)
_types = _numba.types
_extending = cast(Any, numba.extending)
_known: set[Callable[..., Any]] = set()
_kept: list[Any] = []

# NaN and infinity must survive, since they mark singular points, and sums keep their order, since differences such as
# 1 - t carry the relative accuracy at the end points. Fused multiply-add and shared reciprocals are all that is gained.
_OPTIONS: dict[str, Any] = {"fastmath": {"contract", "nsz", "arcp"}, "error_model": "numpy"}


def compiled(function: Callable[..., None], kinds: Sequence[str], name: str) -> tuple[int, Code]:
    """Return where a loop lies in memory once compiled, and its machine code.

    ``kinds`` of its parameters are d for real numbers and q for whole ones. RuntimeError for a loop that needs more
    than the process gives, such as memory of its own.
    """
    _acquaint()
    types = [_types.float64 if kind == "d" else _types.int64 for kind in kinds]
    made = _numba.cfunc(_types.void(*types), **_OPTIONS)(function)
    _kept.append(made)
    library = made._library
    module = library._final_module
    missing = [item.name for item in (*module.functions, *module.global_variables) if item.is_declaration]
    needs = tuple(name for name in missing if not name.startswith("llvm."))
    refused = [one for one in needs if one.startswith(("NRT_", "numba_")) and one not in NEVER_CALLED]
    if refused:
        raise RuntimeError(f"{name}: expected a loop that needs nothing of Numba, found {', '.join(refused)}")
    return int(made.address), Code(made.native_name, needs, library._get_compiled_object())


def _acquaint() -> None:
    """Tell Numba of every marked function that it does not know yet."""
    _memory()
    for function, use in MARKED.items():
        if function not in _known:
            # By LLVM: inlined by Numba, every use would be typed anew.
            options = {"forceinline": use.inlined, **_OPTIONS}
            _extending.overload(function, jit_options=options, strict=False, prefer_literal=use.constants)(
                lambda *_, function=function: function
            )
            _known.add(function)


@cache
def _memory() -> None:
    """Give the words of ``memory`` their meaning in compiled code."""
    floats, words, codes = _pointer(_types.float64), _pointer(_types.int64), _pointer(_types.int8)
    line, barrier, jump = (_extending.intrinsic(word) for word in (_stream, _fence, _call))
    carray = _numba.carray
    meanings: dict[Any, Any] = {
        memory.floats_at: lambda p: lambda p: floats(p),  # noqa: PLW0108
        memory.words_at: lambda p: lambda p: words(p),  # noqa: PLW0108
        memory.codes_at: lambda p: lambda p: codes(p),  # noqa: PLW0108
        memory.table_at: lambda p, n, m: lambda p, n, m: carray(floats(p), (n, m)),
        memory.whole_table_at: lambda p, n, m: lambda p, n, m: carray(words(p), (n, m)),
        memory.stack_at: lambda p, k, n, m: lambda p, k, n, m: carray(floats(p), (k, n, m)),
        memory.stream_line: lambda p, q: lambda p, q: line(p, q),  # noqa: PLW0108
        memory.fence: lambda: lambda: barrier(),  # noqa: PLW0108
        memory.call: lambda p, a, b, c, d, e, f, g: lambda p, a, b, c, d, e, f, g: jump(p, a, b, c, d, e, f, g),  # noqa: PLW0108
    }
    for word, meaning in meanings.items():
        _extending.overload(word, jit_options={"forceinline": True, **_OPTIONS})(meaning)


def _pointer(item: Any) -> Any:
    """Return a compiled function from an address to a pointer that is indexed like an array."""

    def typed(_context: Any, _address: Any) -> Any:
        def generated(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.inttoptr(arguments[0], context.get_value_type(signature.return_type))

        return _types.CPointer(item)(_types.intp), generated

    return _extending.intrinsic(typed)


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
