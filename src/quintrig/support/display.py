"""How a notebook shows a value: whoever can draw registers here, so that what is drawn need not know by whom."""

from collections.abc import Callable
from typing import Any

Bundle = dict[str, Any] | tuple[dict[str, Any], dict[str, Any]]
"""A MIME bundle, alone or with its metadata."""

_DRAWERS: list[Callable[[Any], Bundle]] = []


class Shown:
    """What a notebook shows as more than its ``repr``, where it is the value of a cell."""

    __slots__ = ()

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> Any:
        """Return the MIME bundle."""
        return mime_bundle(self)


def register(drawer: Callable[[Any], Bundle]) -> None:
    """Let ``drawer`` make the MIME bundles of values from now on."""
    _DRAWERS.append(drawer)


def mime_bundle(value: Any) -> Bundle:
    """Return the MIME bundle of a value by the drawer registered last; its ``repr`` as text where there is none."""
    return _DRAWERS[-1](value) if _DRAWERS else {"text/plain": repr(value)}
