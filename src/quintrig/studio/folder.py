"""The folder that the studio may read from and write to: model files directly in it, and nothing else."""

import hashlib
import os
from pathlib import Path
from typing import Any, cast

from quintrig.model.model import Model
from quintrig.model.reading import read_text
from quintrig.model.save import save as write
from quintrig.support.errors import ModelError, QuintrigError
from quintrig.support.files import nets_named, open_regular
from quintrig.support.parsing import parse

MODEL_SUFFIXES = (".toml", ".json")
_LONGEST_NAME = 200  # bytes: file systems take 255, of which a draft beside it needs some
_MOST_FILES = 500


class Changed(Exception):
    """The file on disk is another one than was read."""


def names(folder: Path, suffixes: tuple[str, ...] = MODEL_SUFFIXES) -> list[str]:
    """Return the names of the files in the folder that end so, hidden ones and links left out."""
    found = (path for path in folder.iterdir() if path.suffix.lower() in suffixes and not path.name.startswith("."))
    printable = (path for path in found if path.name.isprintable())  # others cannot be sent as text
    return sorted(path.name for path in printable if path.is_file() and not path.is_symlink())[:_MOST_FILES]


def confined(folder: Path, name: str, suffixes: tuple[str, ...] = MODEL_SUFFIXES) -> Path:
    """Return the path of a file directly in the folder.

    Raises ModelError for a name that leads elsewhere, is hidden, or does not end as it should.
    """
    path = Path(name)
    plain = name == path.name and "\\" not in name and ":" not in name and name.isprintable()
    if not plain or name.startswith(".") or not 0 < len(name.encode()) <= _LONGEST_NAME:
        raise ModelError(f"{name[:80]!r}: expected the plain name of a file in the folder that the studio is open on")
    if path.suffix.lower() not in suffixes:
        expected = f"{', '.join(suffixes[:-1])} or {suffixes[-1]}"
        raise ModelError(f"{name}: expected a name ending in {expected}")
    whole = folder / name
    if whole.is_symlink():
        raise ModelError(f"{name}: is a link to another place, which the studio does not follow")
    return whole


def read(folder: Path, name: str) -> tuple[Model, str]:
    """Return a model and the tag of the version on disk; ModelError as on the command line."""
    path = confined(folder, name)
    # Tag first: what is written between the two is then told as a change, not overwritten.
    tag = tag_of(path) if path.is_file() else ""
    return checked(name, read_text(path), folder), tag


def checked(name: str, text: str, folder: Path | None = None) -> Model:
    """Return the model that a file of this name and content would hold; ModelError as on the command line."""
    suffix = Path(name).suffix.lower()
    if suffix not in MODEL_SUFFIXES:
        raise ModelError(f"{name}: expected a file ending in .toml or .json")
    try:
        data = parse(text, suffix)
        if folder is not None and isinstance(data, dict):
            _refuse_way_out(cast(dict[str, Any], data), folder)
        model = Model.from_dict(cast(Any, data), folder)
    except ModelError as error:
        raise ModelError(f"{name}: {error}") from None
    return model


def _refuse_way_out(keys: dict[str, Any], folder: Path) -> None:
    """Raise ModelError where a CSV file that a model names is, through a link, one of another place."""
    for name in nets_named(keys):
        if not Path(os.path.realpath(folder / name)).is_relative_to(os.path.realpath(folder)):
            raise ModelError(f"{name}: leads out of the folder, where the studio does not follow; put a copy in it")


def save(folder: Path, name: str, model: Model, tag: str | None) -> str:
    """Write a model and return the tag of the new version.

    ``tag`` is that of the version that was read, empty for a new file, None to overwrite whatever there is. Where the
    file exists as TOML, its comments and unchanged keys stay. Raises Changed where the file is another one now,
    QuintrigError where it cannot be written.
    """
    path = confined(folder, name)
    there = path.exists()
    if tag is not None and tag != (tag_of(path) if there else ""):
        what = "was changed by something else since it was opened here" if tag else "exists already"
        raise Changed(f"{name} {what}.")
    write(model, path)
    return tag_of(path)


def tag_of(path: Path) -> str:
    """Return a short name of the content of a file, which tells versions apart."""
    try:
        with open_regular(path) as file:
            return hashlib.sha256(file.read()).hexdigest()[:16]
    except OSError as error:
        raise QuintrigError(f"{path.name}: cannot be read ({error.strerror or error})") from None
