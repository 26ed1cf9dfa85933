"""Models: named surfaces with a unit, from TOML or JSON files."""

import csv
import json
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, cast

from pydantic import ValidationError

from quintrig.definition import KINDS, Bezier, Definition
from quintrig.errors import ModelError, nearest
from quintrig.surface import Surface

SCHEMA_VERSION = 1
UNITS = ("um", "mm", "cm", "m", "km", "in", "ft")
"""Units of length that a model may state."""

LARGEST_FILE = 16 * 2**20
"""Bytes; the largest real model is a few kilobytes."""

_HEADER = ("schema", "name", "unit", "patch")


@dataclass(frozen=True, eq=False)
class Patch:
    """One surface of a model: its name, what the file said of it, and the surface built from that."""

    name: str
    definition: Definition
    surface: Surface

    @property
    def kind(self) -> str:
        """The kind, such as ``swept``."""
        return str(getattr(self.definition, "kind", ""))

    @property
    def shape(self) -> tuple[float, ...]:
        """Shape parameters, empty for kinds that have none."""
        return self.definition.shape_values

    def with_shape(self, shape: Sequence[float]) -> "Patch":
        """Return the same patch with other shape parameters; ModelError where the kind has none or they do not fit."""
        if not self.shape:
            raise ModelError(f'patch "{self.name}": a {self.kind} has no shape parameters to vary')
        keys = {**self.definition.model_dump(), "shape": list(shape)}
        return _patch(keys, self.name, None)


@dataclass(frozen=True, eq=False)
class Model:
    """A model file: name, unit of length (empty: plain numbers) and patches."""

    name: str
    unit: str
    patches: tuple[Patch, ...]

    @property
    def surface(self) -> Surface:
        """The surface of the only patch; ModelError where there are several."""
        return self.patch().surface

    def patch(self, name: str | None = None) -> Patch:
        """Return a patch by name, or the only one; ModelError naming those there are."""
        known = [patch.name for patch in self.patches]
        if name is None and len(self.patches) == 1:
            return self.patches[0]
        if name is None:
            raise ModelError(
                f"model {self.name!r} has {len(known)} patches ({', '.join(known)}): choose one by its name"
            )
        if name not in known:
            raise ModelError(
                f"model {self.name!r} has no patch {name!r}{nearest(name, known)}; it has {', '.join(known)}"
            )
        return self.patches[known.index(name)]

    def with_shape(self, shape: Sequence[float]) -> "Model":
        """Return the model with every patch's shape parameters replaced."""
        return replace(self, patches=tuple(patch.with_shape(shape) for patch in self.patches))

    @staticmethod
    def from_dict(data: Mapping[str, Any], folder: Path | None = None) -> "Model":
        """Build a model from the keys of a model file; ``folder`` is where its CSV files lie.

        Raises ModelError naming the place, what was expected and what was found.
        """
        if not isinstance(data, Mapping):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise ModelError(f"model: expected keys and values, got {_spell(data)}")
        data = cast(dict[str, Any], _plain(dict(data)))
        version = data.pop("schema", SCHEMA_VERSION)
        if isinstance(version, bool) or version != SCHEMA_VERSION:
            raise ModelError(f"schema: expected {SCHEMA_VERSION}, got {_spell(version)}; this quintrig reads version 1")
        unit = _text(data.pop("unit", ""), "unit")
        if unit and unit not in UNITS:
            raise ModelError(f"unit: expected one of {', '.join(UNITS)}, got {unit!r}; leave it out for plain numbers")
        name = _text(data.pop("name", ""), "name")
        if "patch" in data:
            patches = _several(data, folder)
        else:
            patches = (_patch(data, name or str(data.get("kind", "surface")), folder),)
        return Model(name or patches[0].name, unit, patches)

    def to_dict(self) -> dict[str, Any]:
        """Return the keys of a model file that gives this model back; keys at their default are left out."""
        header: dict[str, Any] = {"schema": SCHEMA_VERSION, "name": self.name}
        if self.unit:
            header["unit"] = self.unit
        dumps = [
            {"kind": patch.kind, **patch.definition.model_dump(exclude_defaults=True, exclude={"kind", "name"})}
            for patch in self.patches
        ]
        if len(dumps) == 1:
            return header | dumps[0]
        named = [{"name": patch.name} | dump for patch, dump in zip(self.patches, dumps, strict=True)]
        return header | {"patch": named}


def load(path: str | Path) -> Model:
    """Read a model from a TOML or JSON file.

    Raises ModelError in one line for anything that is not a readable, valid model.
    """
    path = Path(path)
    parsers = {".toml": tomllib.loads, ".json": json.loads}
    if path.suffix.lower() not in parsers:
        raise ModelError(f"{path}: expected a file ending in .toml or .json")
    text = read_text(path)
    try:
        data = parsers[path.suffix.lower()](text)
    except RecursionError:
        raise ModelError(f"{path}: nested too deeply to be a model") from None
    except ValueError as error:
        raise ModelError(f"{path}: not valid {path.suffix[1:].upper()}: {_first_line(error)}") from None
    try:
        return Model.from_dict(data, path.parent)
    except ModelError as error:
        raise ModelError(f"{path}: {error}") from None


def read_text(path: Path) -> str:
    """Return the text of a small UTF-8 file; ModelError where it is missing, a folder, too large or not text."""
    try:
        if path.is_dir():
            raise ModelError(f"{path}: expected a file, found a folder")
        size = path.stat().st_size
        if size > LARGEST_FILE:
            raise ModelError(
                f"{path}: expected at most {LARGEST_FILE >> 20} MB, found {size >> 20} MB; is this a model?"
            )
        with path.open("rb") as file:
            # A pipe or device has no size of its own.
            raw = file.read(LARGEST_FILE + 1)
    except FileNotFoundError:
        raise ModelError(f"{path}: no such file; check the path") from None
    except (OSError, ValueError) as error:
        raise ModelError(f"{path}: cannot be read ({_first_line(error)})") from None
    if len(raw) > LARGEST_FILE:
        raise ModelError(f"{path}: expected at most {LARGEST_FILE >> 20} MB, found more; is this a model?")
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise ModelError(f"{path}: expected text in UTF-8, found other bytes; is this a model?") from None


def read_net(path: Path) -> list[list[float]]:
    """Return the rows of numbers of a CSV file, comma or semicolon separated; a heading and ``#`` lines are skipped."""
    text = read_text(path)
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    delimiter = ";" if lines and ";" in lines[0] else ","
    rows: list[list[float]] = []
    for index, cells in enumerate(csv.reader(lines, delimiter=delimiter)):
        try:
            rows.append([float(cell) for cell in cells])
        except ValueError:
            if index == 0:
                continue
            raise ModelError(f"{path}: row {index + 1}: expected numbers, got {', '.join(cells)[:60]!r}") from None
    return rows


def _several(data: dict[str, Any], folder: Path | None) -> tuple[Patch, ...]:
    tables = data.pop("patch")
    if not isinstance(tables, list) or not tables:
        raise ModelError(f"patch: expected one or more [[patch]] tables, got {_spell(tables)}")
    if data:
        key = next(iter(data))
        raise ModelError(f"unknown key {key!r} beside [[patch]] tables{nearest(key, _HEADER)}; move it into a patch")
    patches: list[Patch] = []
    for index, table in enumerate(cast(list[Any], tables)):
        place = f"patch {index + 1}"
        if not isinstance(table, dict):
            raise ModelError(f"{place}: expected a table of keys, got {_spell(table)}")
        keys = cast(dict[str, Any], table)
        name = _text(keys.get("name", place), f"{place}: name")
        if name in [patch.name for patch in patches]:
            raise ModelError(f'patch "{name}": two patches have this name; give each its own')
        patches.append(_patch(keys, name, folder))
    return tuple(patches)


def _patch(keys: dict[str, Any], name: str, folder: Path | None) -> Patch:
    place = f'patch "{name}"'
    kind = keys.get("kind")
    if not isinstance(kind, str) or kind not in KINDS:
        found = "no kind" if kind is None else _spell(kind)
        hint = nearest(kind, KINDS) if isinstance(kind, str) else ""
        raise ModelError(f"{place}: kind: expected one of {', '.join(KINDS)}, got {found}{hint}")
    form = KINDS[kind]
    try:
        keys = _with_nets(keys, form, folder)
        definition = form.model_validate(keys)
        if not isinstance(definition, Bezier) or definition.basis == "trigonometric":
            for key, counts in form.counts.items():
                _check_counts(getattr(definition, key), counts, key)
        return Patch(name, definition, definition.surface())
    except ValidationError as error:
        raise ModelError(f"{place}: {_explain(error, form)}") from None
    except ValueError as error:
        raise ModelError(f"{place}: {error}") from None


def _with_nets(keys: dict[str, Any], form: type[Definition], folder: Path | None) -> dict[str, Any]:
    """Replace the name of a CSV file by its numbers."""
    result = dict(keys)
    for key in form.nets:
        if not isinstance(result.get(key), str):
            continue
        file = Path(result[key])
        if folder is None or file.is_absolute() or ".." in file.parts or file.suffix.lower() != ".csv":
            raise ValueError(f"{key}: expected numbers, or the name of a .csv file beside the model, got {str(file)!r}")
        rows = read_net(folder / file)
        # A net of rows x columns is listed row by row, as many columns as the trigonometric basis has.
        columns = form.counts[key][-1] if len(form.counts[key]) == 2 else 0
        if columns and len(rows) % columns:
            raise ValueError(f"{key}: {file}: expected a multiple of {columns} rows, got {len(rows)}")
        result[key] = [rows[i : i + columns] for i in range(0, len(rows), columns)] if columns else rows
    return result


def _check_counts(value: Sequence[Any], counts: tuple[int, ...], place: str) -> None:
    if len(value) != counts[0]:
        raise ValueError(f"{place}: expected {counts[0]} {'rows' if len(counts) == 2 else 'points'}, got {len(value)}")
    for index, row in enumerate(value if len(counts) == 2 else ()):
        _check_counts(row, counts[1:], f"{place}[{index}]")


def _explain(error: ValidationError, form: type[Definition]) -> str:
    """Tell the first mistake in one line: where, what was expected, what was found."""
    details = error.errors(include_url=False)
    first = details[0]
    place = "".join(
        f"[{part}]" if isinstance(part, int) else f"{'.' if i else ''}{part}" for i, part in enumerate(first["loc"])
    )
    kind, found, context = first["type"], first["input"], first.get("ctx", {})
    more = f" (and {len(details) - 1} more)" if len(details) > 1 else ""
    if kind == "extra_forbidden":
        known = [*form.model_fields, "schema", "unit"]
        message = f"unknown key {place!r}{nearest(place, known)}"
    elif kind == "missing":
        message = f"missing key {place!r}: expected {form.model_fields[place].description}"
    elif kind in ("too_short", "too_long"):
        count = context.get("min_length" if kind == "too_short" else "max_length")
        rows = isinstance(found, list) and len(cast(list[Any], found)) > 0 and isinstance(found[0], list)
        message = f"{place}: expected {count} {'rows' if rows else 'numbers'}, got {context.get('actual_length')}"
    elif kind == "finite_number":
        message = f"{place}: expected a finite number, got {found}"
    elif kind in ("float_type", "float_parsing"):
        message = f"{place}: expected a number, got {_spell(found)}"
    elif kind == "list_type":
        message = f"{place}: expected a list, got {_spell(found)}"
    else:
        message = f"{place}: {first['msg'][0].lower()}{first['msg'][1:]}, got {_spell(found)}"
    return message + more


def _plain(value: Any) -> Any:
    """Turn NumPy arrays and numbers inside ``value`` into lists and numbers."""
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in cast(dict[Any, Any], value).items()}
    return value.tolist() if hasattr(value, "tolist") else value


def _text(value: Any, place: str) -> str:
    if not isinstance(value, str) or len(value) > 200:
        raise ModelError(f"{place}: expected a short text, got {_spell(value)}")
    return value


def _spell(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _first_line(error: Exception) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0][:200]
