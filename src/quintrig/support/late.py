"""Work that a value offers but a room above its own does: whoever does it registers here, and imports run one way."""

from collections.abc import Callable
from typing import Any

_WORK: dict[str, Callable[..., Any]] = {}


def register(name: str, work: Callable[..., Any]) -> None:
    """Let ``work`` do what is called ``name`` from now on."""
    _WORK[name] = work


def call(name: str, *args: Any, **kwargs: Any) -> Any:
    """Do it; the package's root has registered who."""
    return _WORK[name](*args, **kwargs)
