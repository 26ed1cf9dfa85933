"""Compiled loops over arrays, for work that is long enough that importing Numba does not matter.

``compiled.loop`` is for what small commands run: its machine code is loaded without Numba, but takes addresses alone.
"""

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numba

_Function = TypeVar("_Function", bound=Callable[..., Any])

_njit = cast(Callable[..., Callable[[Any], Any]], numba.njit)  # pyright: ignore[reportUnknownMemberType]


def array_loop(function: _Function) -> _Function:
    """Compile a loop when it is first called, and keep it where Numba keeps its code; it releases the interpreter."""
    # NaN and infinity survive, and sums keep their order, as in ``numba_inside``.
    options: dict[str, Any] = {"fastmath": {"contract", "nsz", "arcp"}, "error_model": "numpy", "nogil": True}
    return cast(_Function, _njit(cache=True, **options)(function))
