"""Patches and curves of a model: what a file says of each, and what is built from that."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

from pydantic import ValidationError

from quintrig.basis.library import Entry
from quintrig.basis.registry import bases
from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.model.explain import explain, spell
from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.recognise import recognised
from quintrig.model.kinds.registry import kinds
from quintrig.model.own_bases import own_bases, tables_of
from quintrig.model.reading import in_rows, read_net, read_text
from quintrig.support.display import Shown
from quintrig.support.errors import ModelError, nearest
from quintrig.support.handed import Handed
from quintrig.support.parsing import parse


@dataclass(frozen=True, eq=False)
class Patch(Handed, Shown):
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
        """The same patch with all of the surface that a trimmed face is cut from, in its definition too."""
        return Patch.of(self.surface.carrier, self.name) if self.surface.trim else self

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

    def replace(self, **keys: Any) -> "Patch":
        """Return a copy with some keys of its kind replaced, such as ``points``, ``shape`` or its ``name``.

        Raises ModelError where they do not fit, or the kind has none such.
        """
        name = str(keys.pop("name", self.name))
        return patch_of({**self.definition.model_dump(), **_listed(keys)}, name, None)

    def rebuilt(self, **keys: Any) -> "Patch":
        """Return a patch of this name built from the keys of a model file; ModelError where they do not fit."""
        return patch_of(keys, self.name, None)

    def _with(self, **changed: Any) -> "Patch":
        return patch_of({**self.definition.model_dump(), **changed}, self.name, None)


@dataclass(frozen=True, eq=False)
class NamedCurve(Shown):
    """One curve of a model: its name, what the file said of it, and the curve built from that."""

    name: str
    definition: CurveKind
    curve: Curve

    @property
    def kind(self) -> str:
        """The kind: ``curve``."""
        return self.definition.kind

    @property
    def shape(self) -> tuple[float, ...]:
        """Shape parameters, empty where the basis has none."""
        return self.definition.shape_values

    @property
    def label(self) -> str:
        """The shape parameters that act, by their letters, or else what is said of the basis."""
        values = zip(self.definition.shape_symbols, self.definition.acting.values(), strict=True)
        return ", ".join(f"{name} = {value:g}" for name, value in values) or self.definition.basis_words

    def with_shape(self, shape: Sequence[float]) -> "NamedCurve":
        """Return the same curve with other shape parameters; ModelError where it has none or they do not fit."""
        if not self.definition.acting:
            raise ModelError(f'patch "{self.name}": a curve in this basis has no shape parameters to vary')
        return curve_of({**self.definition.model_dump(), "shape": list(shape)}, self.name, None)

    def replace(self, **keys: Any) -> "NamedCurve":
        """Return a copy with some keys replaced, such as ``points``, ``shape`` or its ``name``; ModelError as above."""
        name = str(keys.pop("name", self.name))
        return curve_of({**self.definition.model_dump(), **_listed(keys)}, name, None)

    def with_parameters(self, values: Mapping[str, float]) -> "NamedCurve":
        """Return the same curve with some shape parameters replaced, by name; ModelError where it has none such."""
        known = self.definition.acting
        for name in values:
            if name not in known:
                has = f"it has {', '.join(known)}" if known else "it has none"
                raise ModelError(f'patch "{self.name}": a curve has no parameter {name!r}; {has}')
        return self.with_shape([values.get(name, value) for name, value in known.items()])


def _listed(keys: Mapping[str, Any]) -> dict[str, Any]:
    """Return keys with NumPy's arrays as lists, as a file would have them."""
    return {name: value.tolist() if hasattr(value, "tolist") else value for name, value in keys.items()}


def curve_of(keys: dict[str, Any], name: str, folder: Path | None) -> NamedCurve:
    """Build a curve from the keys of a model file; ``folder`` is where its CSV files lie. Raises ModelError."""
    place = f'patch "{name}"'
    try:
        if isinstance(keys.get("points"), str):
            keys = {**keys, "points": read_net(_beside(keys["points"], "points", folder))}
        definition = CurveKind.model_validate(with_bases(keys, folder))
        curve = definition.curve()
        definition.check_basis()
        return NamedCurve(name, definition, curve)
    except ValidationError as error:
        raise ModelError(f"{place}: {explain(error, CurveKind, keys)}") from None
    except ValueError as error:
        raise ModelError(f"{place}: {error}") from None


def patch_of(keys: dict[str, Any], name: str, folder: Path | None) -> Patch:
    """Build a patch from the keys of a model file; ``folder`` is where its CSV files lie. Raises ModelError."""
    place = f'patch "{name}"'
    kind = keys.get("kind")
    if not isinstance(kind, str) or kind not in kinds():
        found = "no kind" if kind is None else spell(kind)
        hint = nearest(kind, [*kinds(), "curve"]) if isinstance(kind, str) else ""
        raise ModelError(f"{place}: kind: expected one of {', '.join(kinds())}, curve, got {found}{hint}")
    form = kinds()[kind]
    try:
        keys = _with_nets(with_bases(keys, folder), form, folder)
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


def with_bases(keys: dict[str, Any], folder: Path | None) -> dict[str, Any]:
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
