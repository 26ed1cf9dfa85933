"""Exports through the exchange package, of which only what is installed is offered."""

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from quintrig.errors import QuintrigError
from quintrig.model import Model


@dataclass(frozen=True)
class Format:
    """A kind of file that a model can be exported to."""

    key: str
    label: str
    suffix: str


def formats() -> list[Format]:
    """Return what the installed exchange package writes; empty without one."""
    if find_spec("quintrig.exchange") is None:
        return []
    offered: list[Any] = list(getattr(import_module("quintrig.exchange"), "studio_formats", list)())
    return [Format(one.key, one.label, one.suffix) for one in offered]


def export(model: Model, key: str) -> bytes:
    """Return the file of a format; QuintrigError where it is not offered or cannot be written."""
    known = {one.key: one for one in formats()}
    if key not in known:
        offered = ", ".join(known) or "none"
        raise QuintrigError(f"export: no format {key!r} is installed here (offered: {offered})")
    write: Callable[[Model, Path, str], None] = import_module("quintrig.exchange").studio_export
    with tempfile.TemporaryDirectory(prefix="quintrig-") as folder:
        path = Path(folder) / f"model.{known[key].suffix}"
        write(model, path, key)
        return path.read_bytes()
