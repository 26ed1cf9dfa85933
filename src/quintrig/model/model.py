"""Models: named surfaces with a unit, from TOML or JSON files."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, cast

from pydantic import ValidationError

from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.model.explain import HEADER, explain, spell
from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.registry import kinds
from quintrig.support.csv_rows import rows_of
from quintrig.support.display import mime_bundle
from quintrig.support.errors import ModelError, nearest
from quintrig.support.files import open_regular
from quintrig.support.parsing import LARGEST_FILE, parse

SCHEMA_VERSION = 1
UNITS = ("um", "mm", "cm", "m", "km", "in", "ft")
"""Units of length that a model may state."""

_UNIT_NAMES = {
    **dict.fromkeys(("µm", "μm", "micron", "microns", "micrometre", "micrometer"), "um"),
    **dict.fromkeys(("millimetre", "millimeter", "millimetres", "millimeters"), "mm"),
    **dict.fromkeys(("centimetre", "centimeter", "centimetres", "centimeters"), "cm"),
    **dict.fromkeys(("metre", "meter", "metres", "meters"), "m"),
    **dict.fromkeys(("kilometre", "kilometer", "kilometres", "kilometers"), "km"),
    **dict.fromkeys(("inch", "inches", '"'), "in"),
    **dict.fromkeys(("foot", "feet", "'"), "ft"),
}


@dataclass(frozen=True, eq=False)
class Patch:
    """One surface of a model: its name, what the file said of it, and the surface built from that."""

    name: str
    definition: Definition
    surface: Surface

    def __repr__(self) -> str:
        """Return one line: name, kind and shape parameters."""
        shape = f", shape {self.shape}" if self.shape else ""
        return f"<Patch {self.name!r}: {self.kind}{shape}>"

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
        return self._with(shape=list(shape))

    def with_parameters(self, values: Mapping[str, float]) -> "Patch":
        """Return the same patch with some of its parameters replaced, by name; ModelError where it has none such."""
        known = self.definition.parameters
        for name in values:
            if name not in known:
                has = f"it has {', '.join(known)}" if known else "it has none"
                raise ModelError(f'patch "{self.name}": a {self.kind} has no parameter {name!r}; {has}')
        names = self.definition.shape_names
        shape = [values.get(name, known.get(name, 0.0)) for name in names]
        sizes = {name: value for name, value in values.items() if name not in names}
        return self._with(**sizes, **({"shape": shape} if set(values) & set(names) else {}))

    def _with(self, **changed: Any) -> "Patch":
        return _patch({**self.definition.model_dump(), **changed}, self.name, None)


@dataclass(frozen=True, eq=False)
class NamedCurve:
    """One curve of a model: its name, what the file said of it, and the curve built from that."""

    name: str
    definition: CurveKind
    curve: Curve


@dataclass(frozen=True, eq=False)
class Model:
    """A model file: name, unit of length (empty: plain numbers), and patches or else curves."""

    name: str
    unit: str
    patches: tuple[Patch, ...]
    curves: tuple[NamedCurve, ...] = ()

    def __repr__(self) -> str:
        """Return one line: name, unit and patches."""
        parts = [(patch.name, patch.kind) for patch in self.patches] + [(curve.name, "curve") for curve in self.curves]
        kinds = ", ".join(f"{name!r} ({kind})" for name, kind in parts[:4])
        more = f" and {len(parts) - 4} more" if len(parts) > 4 else ""
        return f"<Model {self.name!r} in {self.unit or 'plain numbers'}: {kinds}{more}>"

    @property
    def surface(self) -> Surface:
        """The surface of the only patch; ModelError where there are several."""
        return self.patch().surface

    def patch(self, name: str | None = None) -> Patch:
        """Return a patch by name, or the only one; ModelError naming those there are."""
        self.refuse_curves()
        known = [patch.name for patch in self.patches]
        if name is None and len(self.patches) == 1:
            return self.patches[0]
        if name is None:
            raise ModelError(
                f"model {self.name!r} has {len(known)} patches ({', '.join(known)}): choose one by its name "
                "(--patch NAME)"
            )
        if name not in known:
            raise ModelError(
                f"model {self.name!r} has no patch {name!r}{nearest(name, known)}; it has {', '.join(known)}"
            )
        return self.patches[known.index(name)]

    def refuse_curves(self) -> None:
        """Raise ModelError for a model of curves, which has no surface."""
        if self.curves:
            raise ModelError(
                f"model {self.name!r}: expected a surface, found curves; quintrig check and plot read curves, and a "
                "swept or ruled model makes a surface of them"
            )

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> Any:
        """Return the interactive view that a notebook shows; only the text where the extra ``jupyter`` is missing."""
        return {"text/plain": repr(self)} if self.curves else mime_bundle(self)

    def with_shape(self, shape: Sequence[float]) -> "Model":
        """Return the model with every patch's shape parameters replaced."""
        self.refuse_curves()
        return replace(self, patches=tuple(patch.with_shape(shape) for patch in self.patches))

    @staticmethod
    def of_curves(curves: Sequence[Curve], name: str = "curves", unit: str = "") -> "Model":
        """Return a model of quintic trigonometric or Bernstein curves, called curve 1, curve 2, ...; ModelError."""
        tables = [
            {
                "kind": "curve",
                "name": f"curve {index}",
                "points": curve.points.tolist(),
                "shape": [curve.alpha, curve.zeta],
                "basis": curve.basis,
                "unchecked_shape": curve.unchecked_shape,
            }
            for index, curve in enumerate(curves, 1)
        ]
        return Model.from_dict({"name": name, "patch": tables} | ({"unit": unit} if unit else {}))

    @staticmethod
    def from_dict(data: Mapping[str, Any], folder: Path | None = None) -> "Model":
        """Build a model from the keys of a model file; ``folder`` is where its CSV files lie.

        Raises ModelError naming the place, what was expected and what was found.
        """
        if not isinstance(data, Mapping):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise ModelError(f"model: expected keys and values, got {spell(data)}")
        data = cast(dict[str, Any], _plain(dict(data)))
        version = data.pop("schema", SCHEMA_VERSION)
        if isinstance(version, bool) or version != SCHEMA_VERSION:
            raise ModelError(f"schema: expected {SCHEMA_VERSION}, got {spell(version)}; this quintrig reads version 1")
        unit = _text(data.pop("unit", ""), "unit")
        if unit and unit not in UNITS:
            meant = _UNIT_NAMES.get(unit.lower().rstrip("."), unit.lower())
            hint = f"did you mean {meant!r}?" if meant in UNITS else "leave it out for plain numbers"
            raise ModelError(f"unit: expected one of {', '.join(UNITS)}, got {unit!r}; {hint}")
        name = _text(data.pop("name", ""), "name")
        if curves := _curves(data, name, folder):
            return Model(name or curves[0].name, unit, (), curves)
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
        parts = self.patches or self.curves
        dumps = [
            {
                "kind": getattr(part.definition, "kind", ""),
                **part.definition.model_dump(exclude_defaults=True, exclude={"kind", "name"}),
            }
            for part in parts
        ]
        if len(dumps) == 1:
            return header | dumps[0]
        named = [{"name": part.name} | dump for part, dump in zip(parts, dumps, strict=True)]
        return header | {"patch": named}


def load(path: str | Path) -> Model:
    """Read a model from a TOML or JSON file.

    Raises ModelError in one line for anything that is not a readable, valid model.
    """
    if not isinstance(path, (str, Path)):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise ModelError(f"load: expected the path of a model file, got {spell(path)}")
    path = Path(path)
    if path.suffix.lower() not in (".toml", ".json"):
        raise ModelError(f"{path}: expected a file ending in .toml or .json")
    text = read_text(path)
    if not text.strip():
        raise ModelError(f"{path}: the file is empty; expected a model, such as 'quintrig new swept' writes")
    try:
        return Model.from_dict(parse(text, path.suffix.lower()), path.parent)
    except ModelError as error:
        raise ModelError(f"{path}: {error}") from None


def read_text(path: Path, what: str = "a model") -> str:
    """Return the text of a small UTF-8 file; ModelError where it is missing, a folder, too large or not text.

    ``what`` is what the file should be, in words.
    """
    try:
        if path.is_dir():
            raise ModelError(f"{path}: expected a file, found a folder")
        size = path.stat().st_size
        if size > LARGEST_FILE:
            raise ModelError(
                f"{path}: expected at most {LARGEST_FILE >> 20} MB, found {size >> 20} MB; is this {what}?"
            )
        with open_regular(path) as file:
            # It may grow meanwhile.
            raw = file.read(LARGEST_FILE + 1)
    except ModelError:
        raise
    except FileNotFoundError:
        raise ModelError(f"{path}: no such file; check the path") from None
    except (OSError, ValueError) as error:
        raise ModelError(f"{path}: cannot be read ({_first_line(error)})") from None
    if len(raw) > LARGEST_FILE:
        raise ModelError(f"{path}: expected at most {LARGEST_FILE >> 20} MB, found more; is this {what}?")
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw.count(b"\n", 0, error.start) + 1
        raise ModelError(
            f"{path}: expected text in UTF-8, found the byte 0x{raw[error.start]:02x} in line {line}; is this {what}?"
        ) from None


def read_net(path: Path) -> list[list[float]]:
    """Return the rows of numbers of a CSV file, comma or semicolon separated; a heading and ``#`` lines are skipped.

    Raises ModelError, naming file and row, for anything else.
    """
    return list(read_rows(path).values())


def read_rows(path: Path) -> dict[int, list[float]]:
    """Return the rows that ``read_net`` does, by their numbers in the file, which count every line from 1."""
    text = read_text(path, "a table of numbers")
    try:
        return rows_of(text)
    except ModelError as error:
        raise ModelError(f"{path}: {error}") from None


def in_rows(points: list[Any], columns: int, place: str) -> list[Any]:
    """Return points listed row by row in rows of ``columns``; ValueError, naming ``place``, if one is not full."""
    if len(points) % columns:
        raise ValueError(f"{place}: expected a multiple of {columns} rows, got {len(points)}")
    return [points[i : i + columns] for i in range(0, len(points), columns)]


def _several(data: dict[str, Any], folder: Path | None) -> tuple[Patch, ...]:
    tables = data.pop("patch")
    if not isinstance(tables, list) or not tables:
        raise ModelError(f"patch: expected one or more [[patch]] tables, got {spell(tables)}")
    if data:
        key = next(iter(data))
        raise ModelError(f"unknown key {key!r} beside [[patch]] tables{nearest(key, HEADER)}; move it into a patch")
    patches: list[Patch] = []
    for index, table in enumerate(cast(list[Any], tables)):
        place = f"patch {index + 1}"
        if not isinstance(table, dict):
            raise ModelError(f"{place}: expected a table of keys, got {spell(table)}")
        keys = cast(dict[str, Any], table)
        name = _text(keys.get("name", place), f"{place}: name")
        if name in [patch.name for patch in patches]:
            raise ModelError(f'patch "{name}": two patches have this name; give each its own')
        patches.append(_patch(keys, name, folder))
    return tuple(patches)


def _curves(data: dict[str, Any], name: str, folder: Path | None) -> tuple[NamedCurve, ...]:
    """Return the curves of a model of curves; nothing for a model of surfaces."""
    several = "patch" in data
    tables: Any = data.get("patch") if several else [data]
    if not isinstance(tables, list) or not any(_is_curve(table) for table in cast(list[Any], tables)):
        return ()
    if several and len(data) > 1:
        key = next(key for key in data if key != "patch")
        raise ModelError(f"unknown key {key!r} beside [[patch]] tables{nearest(key, HEADER)}; move it into a patch")
    curves: list[NamedCurve] = []
    for index, table in enumerate(cast(list[Any], tables)):
        place = f"patch {index + 1}" if several else name or "curve"
        if not _is_curve(table):
            raise ModelError(f"{place}: expected a curve, as the others are; keep surfaces in a model of their own")
        called = _text(table.get("name", place), f"{place}: name")
        if called in [curve.name for curve in curves]:
            raise ModelError(f'patch "{called}": two curves have this name; give each its own')
        curves.append(_curve(table, called, folder))
    if len({curve.curve.points.shape[1] for curve in curves}) > 1:
        raise ModelError("points: expected curves all in the plane or all in space, found both in one model")
    return tuple(curves)


def _is_curve(table: Any) -> bool:
    return isinstance(table, dict) and cast(dict[str, Any], table).get("kind") == "curve"


def _curve(keys: dict[str, Any], name: str, folder: Path | None) -> NamedCurve:
    place = f'patch "{name}"'
    try:
        if isinstance(keys.get("points"), str):
            keys = {**keys, "points": read_net(_beside(keys["points"], "points", folder))}
        definition = CurveKind.model_validate(keys)
        return NamedCurve(name, definition, definition.curve())
    except ValidationError as error:
        raise ModelError(f"{place}: {explain(error, CurveKind, keys)}") from None
    except ValueError as error:
        raise ModelError(f"{place}: {error}") from None


def _patch(keys: dict[str, Any], name: str, folder: Path | None) -> Patch:
    place = f'patch "{name}"'
    kind = keys.get("kind")
    if not isinstance(kind, str) or kind not in kinds():
        found = "no kind" if kind is None else spell(kind)
        hint = nearest(kind, [*kinds(), "curve"]) if isinstance(kind, str) else ""
        raise ModelError(f"{place}: kind: expected one of {', '.join(kinds())}, curve, got {found}{hint}")
    form = kinds()[kind]
    try:
        keys = _with_nets(keys, form, folder)
        definition = form.model_validate(keys)
        if not definition.classical:
            for key, counts in form.counts.items():
                _check_counts(getattr(definition, key), counts, key)
        surface = definition.surface()
        _ = surface.size  # which refuses what is too large or too small to compute with
        return Patch(name, definition, surface)
    except ValidationError as error:
        raise ModelError(f"{place}: {explain(error, form, keys)}") from None
    except ValueError as error:
        raise ModelError(f"{place}: {error}") from None


def _with_nets(keys: dict[str, Any], form: type[Definition], folder: Path | None) -> dict[str, Any]:
    """Replace the name of a CSV file by its numbers."""
    result = dict(keys)
    for key in form.nets:
        if not isinstance(result.get(key), str):
            continue
        file = Path(result[key])
        rows = read_net(_beside(file, key, folder))
        # A net of rows x columns is listed row by row, as many columns as the trigonometric basis has.
        columns = form.counts[key][-1] if len(form.counts[key]) == 2 else 0
        result[key] = in_rows(rows, columns, f"{key}: {file}") if columns else rows
    return result


def _beside(name: str | Path, key: str, folder: Path | None) -> Path:
    """Return the CSV file of this name beside the model; ValueError for any other name."""
    file = Path(name)
    if folder is None or file.is_absolute() or ".." in file.parts or file.suffix.lower() != ".csv":
        raise ValueError(f"{key}: expected numbers, or the name of a .csv file beside the model, got {str(file)!r}")
    return folder / file


def _check_counts(value: Sequence[Any], counts: tuple[int, ...], place: str) -> None:
    if len(value) != counts[0]:
        noun = "rows" if len(counts) == 2 else "planes" if place in ("planes", "bounds") else "points"
        raise ValueError(f"{place}: expected {counts[0]} {noun}, got {len(value)}")
    for index, row in enumerate(value if len(counts) == 2 else ()):
        _check_counts(row, counts[1:], f"{place}[{index}]")


def _plain(value: Any, depth: int = 0) -> Any:
    """Turn NumPy arrays and numbers inside ``value`` into lists and numbers."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, dict) and depth < 2:  # a model has no deeper tables than those of its patches
        return {str(key): _plain(item, depth + 1) for key, item in cast(dict[Any, Any], value).items()}
    return cast(Any, value)


def _text(value: Any, place: str) -> str:
    if not isinstance(value, str) or len(value) > 200 or not value.isprintable():
        raise ModelError(f"{place}: expected a text of at most 200 letters on one line, got {spell(value)}")
    return value


def _first_line(error: Exception) -> str:
    return (str(error).splitlines() or [type(error).__name__])[0][:200]
