"""All that is used of Numba and that Numba does not promise to keep, so that a new version is tried in one place.

tests/test_numba_inside.py says what a version must have, and pyproject.toml the newest that was tried.
"""

from collections.abc import Callable
from typing import Any, cast

import numba


def address(function: Callable[[int, int, int, int, int, int, int], None]) -> int:
    """Return where a loop that takes seven whole numbers is found in memory, compiled if need be.

    A loop that is called by its address is compiled once; one that is called by its name, anew in every caller.
    """
    compiled = cast(Any, function)
    signature = (cast(Any, numba).types.intp,) * 7
    compiled.compile(signature)
    found = compiled.overloads[signature]
    return found.library.get_pointer_to_function(found.fndesc.llvm_cfunc_wrapper_name)


def share_cache(compiled: Any, word: str) -> None:
    """Make the cache of one loop safe with several processes, full disks and broken files.

    Numba numbers the files of a loop by the index that it read last, so two processes that compile at once would give
    one name to different code; the ``word`` of each process in its names keeps them apart. A file that cannot be read
    or written is as good as none: the loop is compiled instead. Where Numba has changed inside, nothing is done.
    """
    cache: Any = getattr(compiled, "_cache", None)
    files: Any = getattr(cache, "_cache_file", None)
    if not hasattr(files, "_data_name_pattern"):
        return
    files._data_name_pattern = files._data_name_pattern.replace("{number:d}", "{number:d}-" + word)
    cache.load_overload, cache.save_overload = _lenient(cache.load_overload), _lenient(cache.save_overload)


def _lenient(action: Callable[..., Any]) -> Callable[..., Any]:
    """Return the action, but with None for a failure."""

    def tried(*arguments: Any) -> Any:
        try:
            return action(*arguments)
        except Exception:  # a truncated file fails in many ways
            return None

    return tried
