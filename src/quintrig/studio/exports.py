"""Exports through the exchange package: what is installed is offered, and what there is to tell is told."""

import io
import re
import tempfile
import zipfile
from dataclasses import dataclass
from pathlib import Path

from quintrig.exchange.formats import FAMILIES, FORMATS, Format
from quintrig.exchange.nets import net_paths
from quintrig.exchange.origin import refuse_point
from quintrig.model.model import Model
from quintrig.quantities.table import quantity
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import EXTRAS, install

_ALL = tuple(one for one in FORMATS if one.family != "model")
_ANY = "model"  # stands for the name of a file


@dataclass(frozen=True)
class Exported:
    """A file to hand over, and what to tell about it, one line each."""

    name: str
    content: bytes
    notes: tuple[str, ...]


@dataclass(frozen=True)
class Order:
    """What to write.

    A flat pattern is of one ``patch``. A mesh is coloured by the quantity ``colour``, not at all without one, between
    the ``ends`` of its map. ``tolerance``, length¹, is that of meshes and flat patterns. None stands for the usual.
    """

    suffix: str
    patch: str | None = None
    colour: str | None = None
    ends: tuple[float, float] | None = None
    tolerance: float | None = None


def formats() -> list[Format]:
    """Return the formats that can be written here; model files have a menu of their own."""
    return [one for one in _ALL if one.installed]


def refusals(model: Model | None = None, patch: str | None = None) -> dict[str, str]:
    """Return why formats cannot be written, by suffix: what is not installed, and what this model does not have."""
    reasons = {one.suffix: f"needs {install(EXTRAS[one.needs][0])}" for one in _ALL if not one.installed}
    if model is None:
        return reasons
    for one in formats():
        try:
            _refuse(model, one, patch)
        except (QuintrigError, ValueError) as error:
            reasons[one.suffix] = str(error).removeprefix(f"{_ANY}{one.suffix}: ")
    return reasons


def rows(reasons: dict[str, str]) -> list[dict[str, str]]:
    """Return the menu of all formats, each with the reason why it cannot be written, empty where it can."""
    return [
        {
            "suffix": one.suffix,
            "label": one.label,
            "family": FAMILIES[one.family],
            "reason": reasons.get(one.suffix, ""),
            "takes": {"mesh": "tolerance and colours", "pattern": "tolerance"}.get(one.family, ""),
        }
        for one in _ALL
    ]


def _refuse(model: Model, form: Format, patch: str | None) -> None:
    """Raise the error of writing a format as far as that is told by little work."""
    if not model.patches:  # curves are soon written: what cannot be is told by that
        with tempfile.TemporaryDirectory(prefix="quintrig-") as folder:
            path = Path(folder) / f"{_ANY}{form.suffix}"
            try:
                _written(model, path, form, Order(form.suffix))
            except (QuintrigError, ValueError) as error:
                raise QuintrigError(str(error).replace(str(path), path.name)) from None
    elif form.family in ("cad", "mesh"):
        refuse_point(model)
    elif form.family == "net":
        net_paths(model, Path(f"{_ANY}{form.suffix}"))
    elif form.family == "pattern":
        from quintrig.developables.unroll import unroll

        unroll(model.patch(patch).surface)


def export(model: Model, order: Order) -> Exported:
    """Return the file of a format, a ZIP where there are several.

    Raises QuintrigError or ValueError where the format is not offered or the model has no such form.
    """
    known = {one.suffix: one for one in formats()}
    if order.suffix not in known:
        raise QuintrigError(
            f"export: no format {order.suffix!r} is installed here (offered: {', '.join(known) or 'none'})"
        )
    with tempfile.TemporaryDirectory(prefix="quintrig-") as folder:
        path = Path(folder) / f"{_stem(model.name)}{order.suffix}"
        try:
            notes = _written(model, path, known[order.suffix], order)
        except (QuintrigError, ValueError) as error:
            # The user knows nothing of this folder.
            told = str(error).removeprefix(f"{path}: ").replace(str(path), path.name)
            kind = ValueError if isinstance(error, ValueError) else QuintrigError
            raise kind(f"{known[order.suffix].label}: {told}") from None
        files = sorted(Path(folder).iterdir())
        if len(files) == 1:
            return Exported(files[0].name, files[0].read_bytes(), notes)
        names = ", ".join(one.name for one in files)
        return Exported(f"{path.stem}.zip", _zipped(files), (f"{len(files)} files in one ZIP: {names}", *notes))


def _written(model: Model, path: Path, form: Format, order: Order) -> tuple[str, ...]:
    # Each pulls in what only its formats need.
    if form.family == "pattern" and model.patches:
        from quintrig.exchange.pattern.flatten import FlattenOptions, export_pattern

        patches = model.patches if order.patch is None else model.patch(order.patch)
        return export_pattern(patches, model.unit, path, FlattenOptions(chord=order.tolerance))
    from quintrig.exchange.export import ExportOptions
    from quintrig.exchange.export import export as write
    from quintrig.exchange.mesh.write import MeshOptions

    colour = None if order.colour is None else quantity(order.colour).key
    mesh = MeshOptions(order.tolerance, colour=colour, ends=order.ends)
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
