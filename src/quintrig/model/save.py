"""Writing models to files, TOML or JSON."""

import json
from pathlib import Path

from tomlkit.exceptions import TOMLKitError

from quintrig.model.model import Model
from quintrig.model.reading import read_text
from quintrig.model.toml import edited, plain, to_toml
from quintrig.support.errors import ModelError
from quintrig.support.files import write_whole
from quintrig.support.parsing import parse


def save(model: Model, path: str | Path) -> Path:
    """Write a model to a file ending in .toml or .json, whole or not at all, and return the path.

    Where a TOML file is there already, its comments and what did not change stay as they are. Raises ModelError for
    another ending, QuintrigError where the file cannot be written.
    """
    if not isinstance(model, Model):  # pyright: ignore[reportUnnecessaryIsInstance]
        hint = "quintrig.Model(name, unit, (patch,)) holds a patch, Model.of_curves curves"
        raise ModelError(f"model: expected a model, found {type(model).__name__}; {hint}")
    path = Path(path)
    suffix = path.suffix.lower()
    if suffix not in (".toml", ".json"):
        raise ModelError(f"{path}: expected a file ending in .toml or .json")
    if suffix == ".json":
        return write_whole(path, to_json(model))
    return write_whole(path, merged(_text(path), model, path.parent))


def to_json(model: Model) -> str:
    """Return a model as the text of a JSON file."""
    return json.dumps(plain(model.to_dict()), ensure_ascii=False, indent=1) + "\n"


def merged(text: str, model: Model, folder: Path | None = None) -> str:
    """Return TOML of the model, as close to ``text`` as can be; ``folder`` is where the CSV files of the text lie.

    All is written anew where the text holds no model, or says something that cannot be changed in place.
    """
    wanted = model.to_dict()

    def said(toml: str) -> object:
        return Model.from_dict(parse(toml, ".toml"), folder).to_dict()

    try:
        before = Model.from_dict(parse(text, ".toml"), folder).to_dict()
        result = edited(text, before, wanted)
        if said(result) == wanted:
            return result
    except (ValueError, TOMLKitError):
        pass
    return to_toml(wanted)


def _text(path: Path) -> str:
    try:
        return read_text(path) if path.exists() else ""
    except ModelError:
        return ""
