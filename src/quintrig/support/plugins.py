"""What installed packages add: objects by name, from entry points, beside those that quintrig brings itself."""

import warnings
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, TypeVar

from quintrig.support.errors import QuintrigError

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

Thing = TypeVar("Thing")


def with_plugins(group: str, own: dict[str, Thing], accept: Callable[[str, Any], Thing]) -> dict[str, Thing]:
    """Return ``own`` and what entry points of the group add, by name.

    ``accept`` takes an entry point's name and object, and returns what it stands for; its ValueError, like any failure
    to import, leaves that one out with a warning that names it. Raises QuintrigError where two bring one name.
    """
    from importlib.metadata import entry_points  # which costs as much as half of NumPy

    result = dict(own)
    owners = dict.fromkeys(own, "quintrig")
    for point in _sorted(entry_points(group=group)):
        package = point.dist.name if point.dist else point.value
        if point.name in owners:
            raise QuintrigError(
                f"{group}: {point.name!r} is brought by {owners[point.name]} and by {package}; "
                "uninstall one of them, or ask its authors for another name"
            )
        owners[point.name] = package
        try:
            result[point.name] = accept(point.name, point.load())
        except Exception as error:
            reason = str(error).partition("\n")[0] or type(error).__name__
            warnings.warn(f"{group}: {point.name!r} of {package} is left out: {reason}", stacklevel=2)
    return result


def _sorted(points: "Iterable[EntryPoint]") -> "list[EntryPoint]":
    """Return entry points in an order that does not hang on the file system, each once."""
    found = {(point.name, point.value, point.dist.name if point.dist else ""): point for point in points}
    return [found[key] for key in sorted(found)]
