"""The functions that compiled loops are made of, and how loops use each."""

from collections.abc import Callable
from typing import Any, NamedTuple


class Use(NamedTuple):
    """How loops use a function: put in place, or called; and whether it is compiled anew for other constants."""

    inlined: bool
    constants: bool


MARKED: dict[Callable[..., Any], Use] = {}
"""The functions, marked by ``scalar``, ``unrolled`` and ``part`` of ``compiled``."""
