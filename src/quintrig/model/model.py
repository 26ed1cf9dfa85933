"""Models: named surfaces with a unit, from TOML or JSON files."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, cast

from pydantic import ValidationError

from quintrig.basis.library import Entry
from quintrig.basis.registry import bases
from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.model.explain import HEADER, explain, spell
from quintrig.model.held import Held, held
from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.recognise import Bare, recognised
from quintrig.model.kinds.registry import kinds
from quintrig.model.own_bases import own_bases, tables_of
from quintrig.support.csv_rows import rows_of
from quintrig.support.display import mime_bundle
from quintrig.support.errors import ModelError, nearest
from quintrig.support.files import open_regular
from quintrig.support.late import call
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
    """One surface of a model: its name, what the file said of it, and the surface built from that.

    Given None for the definition of a surface that no file holds, it has that of ``Patch.of``.
    """

    name: str
    definition: Definition
    surface: Surface

    def __post_init__(self) -> None:
        """See to it that there is a definition."""
        if not isinstance(self.definition, Definition):  # pyright: ignore[reportUnnecessaryIsInstance]
            object.__setattr__(self, "definition", recognised(self.surface))

    @staticmethod
    def of(surface: Surface, name: str = "surface") -> "Patch":
        """Return a patch of a surface, by the first kind that would build it, or ``Bare`` where none would."""
        return Patch(name, recognised(surface), surface)

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

    @property
    def carrier(self) -> "Patch":
        """The same patch with all of the surface that a trimmed face is cut from."""
        return replace(self, surface=self.surface.carrier)

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
        names = tuple(self.definition.ranges)
        shape = [values.get(name, known.get(name, 0.0)) for name in names]
        sizes = {name: value for name, value in values.items() if name not in names}
        return self._with(**sizes, **({"shape": shape} if set(values) & set(names) else {}))

    def rebuilt(self, **keys: Any) -> "Patch":
        """Return a patch of this name built from the keys of a model file; ModelError where they do not fit."""
        return _patch(keys, self.name, None)

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
    """A model file: name, unit of length (empty: plain numbers), patches with sides held together, or curves."""

    name: str
    unit: str
    patches: tuple[Patch, ...]
    held: tuple[Held, ...] = ()
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
                f"model {self.name!r} has {len(known)} patches ({', '.join(known)}): choose one by its name",
                remedy="(model.patch(name))",
                key="patch",
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
                f"model {self.name!r}: expected a surface, found curves; a swept or ruled model makes a surface of them"
            )

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> Any:
        """Return the interactive view that a notebook shows; only the text where the extra ``jupyter`` is missing."""
        return {"text/plain": repr(self)} if self.curves else mime_bundle(self)

    def joins(self, **limits: Any) -> Any:
        """Return which edges of the patches meet, how smoothly, and which are free.

        The result is a ``Joins``. Takes ``preset`` ("engineering" or "class-a"), ``tolerance`` (length¹), ``angle``
        (degrees), ``curvature`` (relative jump) and ``near`` (part of an edge's length up to which near misses are
        told). Raises ValueError for limits not above 0.
        """
        return call("joins", self, **limits)

    def with_shape(self, shape: Sequence[float]) -> "Model":
        """Return the model with every patch's shape parameters replaced."""
        self.refuse_curves()
        return replace(self, patches=tuple(patch.with_shape(shape) for patch in self.patches))._carried()

    def with_patch(self, patch: Patch) -> "Model":
        """Return the model with the patch of this name replaced, and with what its joins carry along."""
        old = self.patch(patch.name)
        return replace(self, patches=tuple(patch if one is old else one for one in self.patches))._carried()

    def _carried(self) -> "Model":
        """Return the model with every side that is held moved to what it is held to."""
        return call("hold", self) if self.held else self

    @staticmethod
    def of_curves(curves: Sequence[Curve], name: str = "curves", unit: str = "") -> "Model":
        """Return a model of quintic trigonometric or Bernstein curves, called curve 1, curve 2, ...; ModelError."""
        tables = [
            {
                "kind": "curve",
                "name": f"curve {index}",
                "points": curve.points.tolist(),
                "shape": list(curve.functions.parameters.values()),
                "basis": curve.basis if isinstance(curve.basis, str) else str(getattr(curve.basis, "name", "")),
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
        tables = data.pop("join", None)
        if curves := _curves(data, name, folder):
            if tables is not None:
                raise ModelError("join: holds sides of surfaces together; curves are joined by join_curves")
            return Model(name or curves[0].name, unit, (), curves=curves)
        if "patch" in data:
            patches = _several(data, _with_bases(data, folder).get("bases", {}), folder)
        else:
            patches = (_patch(data, name or str(data.get("kind", "surface")), folder),)
        rules = () if tables is None else held(tables, tuple(patch.name for patch in patches))
        return Model(name or patches[0].name, unit, patches, rules)._carried()

    def to_dict(self) -> dict[str, Any]:
        """Return the keys of a model file that gives this model back; keys at their default are left out.

        Raises ModelError for a surface made in Python that no kind of model would build.
        """
        for patch in self.patches:
            if isinstance(patch.definition, Bare):
                raise ModelError(
                    f'patch "{patch.name}": a surface made in Python of rows that no kind of model has cannot be '
                    "written as a model; export it as a mesh, or make a model near it"
                )
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
        shared = [dump["bases"] for dump in dumps if "bases" in dump]
        if shared and all(one == shared[0] for one in shared):
            header["bases"] = shared[0]
            dumps = [{key: value for key, value in dump.items() if key != "bases"} for dump in dumps]
        named = [{"name": patch.name} | dump for patch, dump in zip(parts, dumps, strict=True)]
        joins = {"join": [rule.to_dict() for rule in self.held]} if self.held else {}
        return header | {"patch": named} | joins


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
        raise ModelError(f"{path}: the file is empty; expected a model", remedy="quintrig.save writes one", key="new")
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


def _several(data: dict[str, Any], bases: Any, folder: Path | None) -> tuple[Patch, ...]:
    tables = data.pop("patch")
    data.pop("bases", None)
    _ = own_bases(bases)  # which says what is wrong with them
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
        form = kinds().get(str(keys.get("kind")))
        own = {"bases": bases} if bases and form is not None and "bases" in form.model_fields else {}
        patches.append(_patch(own | keys, name, folder))
    return tuple(patches)


def _curves(data: dict[str, Any], name: str, folder: Path | None) -> tuple[NamedCurve, ...]:
    """Return the curves of a model of curves; nothing for a model of surfaces."""
    several = "patch" in data
    tables: Any = data.get("patch") if several else [data]
    if not isinstance(tables, list) or not any(_is_curve(table) for table in cast(list[Any], tables)):
        return ()
    shared = _with_bases(data, folder).get("bases") if several else None
    key = next((key for key in data if key not in ("patch", "bases")), None) if several else None
    if key is not None:
        raise ModelError(f"unknown key {key!r} beside [[patch]] tables{nearest(key, HEADER)}; move it into a patch")
    curves: list[NamedCurve] = []
    for index, table in enumerate(cast(list[Any], tables)):
        place = f"patch {index + 1}" if several else name or "curve"
        if not _is_curve(table):
            raise ModelError(f"{place}: expected a curve, as the others are; keep surfaces in a model of their own")
        called = _text(table.get("name", place), f"{place}: name")
        if called in [curve.name for curve in curves]:
            raise ModelError(f'patch "{called}": two curves have this name; give each its own')
        curves.append(_curve({"bases": shared, **table} if shared else table, called, folder))
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
        definition = CurveKind.model_validate(_with_bases(keys, folder))
        curve = definition.curve()
        definition.check_basis()
        return NamedCurve(name, definition, curve)
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
        keys = _with_nets(_with_bases(keys, folder), form, folder)
        definition = form.model_validate(keys)
        if definition.standard:
            for key, counts in form.counts.items():
                _check_counts(getattr(definition, key), counts, key)
        surface = definition.surface()
        definition.check_basis()
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
        # A net of rows x columns is listed row by row, as many columns as the basis in v has functions.
        columns = _columns(keys, form.counts[key][-1]) if len(form.counts[key]) == 2 else 0
        result[key] = in_rows(rows, columns, f"{key}: {file}") if columns else rows
    return result


def _columns(keys: dict[str, Any], usual: int) -> int:
    """Return how many points a row of a net has, where the basis in v says, else the usual number."""
    name = keys.get("basis")
    names = cast(list[object], name) if isinstance(name, list) else [name]
    last = str(names[-1]) if names else ""
    tables = keys.get("bases")
    own: Mapping[str, Entry] = own_bases(cast(dict[str, Any], tables)) if isinstance(tables, dict) else {}
    found: Entry | None = {**bases(), **own}.get(last)
    return found.sizes[0] if found is not None and len(found.sizes) == 1 else usual


def _with_bases(keys: dict[str, Any], folder: Path | None) -> dict[str, Any]:
    """Replace the name of a file of bases by what it holds, and check them before what is built on them."""
    if isinstance(keys.get("bases"), dict):
        _ = own_bases(keys["bases"])
    if not isinstance(keys.get("bases"), str):
        return keys
    file = Path(keys["bases"])
    if folder is None or file.is_absolute() or ".." in file.parts or file.suffix.lower() not in (".toml", ".json"):
        raise ValueError(
            f"bases: expected [bases.NAME] tables, or the name of a .toml file beside the model, got {str(file)!r}"
        )
    return {**keys, "bases": load_bases(folder / file)}


def load_bases(path: Path) -> dict[str, Any]:
    """Return the tables of a file of ``[basis.NAME]`` tables, by name; ModelError where it is none."""
    text = read_text(path, "a file of bases")
    try:
        return tables_of(parse(text, path.suffix.lower()))
    except ValueError as error:
        raise ModelError(f"{path}: {error}") from None


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
