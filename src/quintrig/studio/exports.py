"""Exports through the exchange package: what is installed is offered, and what there is to tell is told."""

import io
import re
import tempfile
import zipfile
from dataclasses import dataclass
from pathlib import Path

from quintrig.errors import QuintrigError
from quintrig.exchange.formats import FORMATS, Format
from quintrig.model import Model
from quintrig.quantity import quantity


@dataclass(frozen=True)
class Exported:
    """A file to hand over, and what to tell about it, one line each."""

    name: str
    content: bytes
    notes: tuple[str, ...]


def formats() -> list[Format]:
    """Return the formats that can be written here; model files have a menu of their own."""
    return [one for one in FORMATS if one.family != "model" and one.installed]


def export(model: Model, suffix: str, patch: str | None = None, colour: str | None = None) -> Exported:
    """Return the file of a format, a ZIP where there are several.

    A flat pattern is of one ``patch``; meshes are coloured by the quantity ``colour``, by K without one. Raises
    QuintrigError or ValueError where the format is not offered or the model has no such form.
    """
    known = {one.suffix: one for one in formats()}
    if suffix not in known:
        raise QuintrigError(f"export: no format {suffix!r} is installed here (offered: {', '.join(known) or 'none'})")
    with tempfile.TemporaryDirectory(prefix="quintrig-") as folder:
        path = Path(folder) / f"{_stem(model.name)}{suffix}"
        try:
            notes = _written(model, path, known[suffix], patch, colour)
        except (QuintrigError, ValueError) as error:
            # The user knows nothing of this folder.
            told = str(error).removeprefix(f"{path}: ").replace(str(path), path.name)
            kind = ValueError if isinstance(error, ValueError) else QuintrigError
            raise kind(f"{known[suffix].label}: {told}") from None
        files = sorted(Path(folder).iterdir())
        if len(files) == 1:
            return Exported(files[0].name, files[0].read_bytes(), notes)
        names = ", ".join(one.name for one in files)
        return Exported(f"{path.stem}.zip", _zipped(files), (f"{len(files)} files in one ZIP: {names}", *notes))


def _written(model: Model, path: Path, form: Format, patch: str | None, colour: str | None) -> tuple[str, ...]:
    # Each pulls in what only its formats need.
    if form.family == "pattern":
        from quintrig.exchange.flatten import export_pattern

        return export_pattern(model.patch(patch), model.unit, path)
    from quintrig.exchange.export import ExportOptions
    from quintrig.exchange.export import export as write
    from quintrig.exchange.meshes import MeshOptions

    mesh = MeshOptions(colour=quantity(colour).key) if colour else MeshOptions()
    return write(model, path, ExportOptions(mesh=mesh)).notes


def _zipped(files: list[Path]) -> bytes:
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as archive:
        for one in files:
            archive.write(one, one.name)
    return whole.getvalue()


def _stem(name: str) -> str:
    """Return a plain file name from a model's name."""
    return re.sub(r"[^\w-]+", "_", name).strip("_").lower()[:80] or "surface"
