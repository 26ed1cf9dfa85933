"""Models: named surfaces with a unit, from TOML or JSON files."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar, cast

from quintrig.basis.library import Entry
from quintrig.basis.registry import bases
from quintrig.geometry.curve import Curve
from quintrig.geometry.surface import Surface
from quintrig.model.explain import HEADER, spell
from quintrig.model.held import Held, held
from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.recognise import Bare
from quintrig.model.kinds.registry import kinds
from quintrig.model.own_bases import table_of
from quintrig.model.patch import NamedCurve, Patch, curve_of, patch_of, with_bases
from quintrig.model.reading import read_text
from quintrig.support.display import Shown
from quintrig.support.errors import ModelError, nearest
from quintrig.support.handed import Handed
from quintrig.support.late import call
from quintrig.support.parsing import parse

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


Part = TypeVar("Part", Patch, NamedCurve)


@dataclass(frozen=True, eq=False)
class Model(Handed, Shown):
    """A model file: name, unit of length (empty: plain numbers), patches with sides held together, and curves."""

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
        return self._named(self.patches, name, "patch", "patches")

    def curve(self, name: str | None = None) -> NamedCurve:
        """Return a curve by name, or the only one; ModelError naming those there are."""
        return self._named(self.curves, name, "curve", "curves")

    def _named(self, parts: Sequence[Part], name: str | None, one: str, several: str) -> Part:
        known = [part.name for part in parts]
        if name is None and len(parts) == 1:
            return parts[0]
        if name is None:
            raise ModelError(
                f"model {self.name!r} has {len(known)} {several} ({', '.join(known)}): choose one by its name",
                remedy=f"(model.{one}(name))",
                key="patch",
            )
        if name not in known:
            raise ModelError(
                f"model {self.name!r} has no {one} {name!r}{nearest(name, known)}; it has {', '.join(known)}"
            )
        return parts[known.index(name)]

    def refuse_curves(self) -> None:
        """Raise ModelError for a model of curves alone, which has no surface."""
        if not self.patches:
            raise ModelError(
                f"model {self.name!r}: expected a surface, found curves; a swept or ruled model makes a surface of them"
            )

    def joins(self, **limits: Any) -> Any:
        """Return which edges of the patches meet, how smoothly, and which are free.

        The result is a ``Joins``. Takes ``preset`` ("engineering" or "class-a"), ``tolerance`` (length¹), ``angle``
        (degrees), ``curvature`` (relative jump), ``near`` (part of an edge's length up to which near misses are told)
        and ``of`` (names of patches, for theirs alone). Raises ValueError for limits not above 0.
        """
        return call("joins", self, **limits)

    def with_shape(self, shape: Sequence[float]) -> "Model":
        """Return the model with every patch's shape parameters replaced, or every curve's where there are curves alone.

        Raises ModelError where they do not fit.
        """
        if not self.patches:
            return replace(self, curves=tuple(one.with_shape(shape) for one in self.curves))
        return replace(self, patches=tuple(patch.with_shape(shape) for patch in self.patches))._carried()

    def with_patch(self, patch: Patch) -> "Model":
        """Return the model with the patch of this name replaced, and with what its joins carry along."""
        old = self.patch(patch.name)
        return replace(self, patches=tuple(patch if one is old else one for one in self.patches))._carried()

    def replace(self, *parts: Patch | NamedCurve) -> "Model":
        """Return the model with the patches and curves of these names replaced, and with what joins carry along.

        Raises ModelError where it has none such.
        """
        new = {part.name: part for part in parts}
        for part in parts:
            _ = self.patch(part.name) if isinstance(part, Patch) else self.curve(part.name)
        patches = tuple(found if isinstance(found := new.get(one.name), Patch) else one for one in self.patches)
        curves = tuple(found if isinstance(found := new.get(one.name), NamedCurve) else one for one in self.curves)
        return replace(self, patches=patches, curves=curves)._carried()

    def _carried(self) -> "Model":
        """Return the model with every side that is held moved to what it is held to."""
        return call("hold", self) if self.held else self

    @staticmethod
    def of_curves(curves: Sequence[Curve], name: str = "curves", unit: str = "") -> "Model":
        """Return a model of curves in any basis, called curve 1, curve 2, ...; ModelError where it cannot hold them."""
        tables: list[dict[str, Any]] = [
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
        for curve, table in zip(curves, tables, strict=True):
            if table["basis"] not in bases() and isinstance(curve.basis, Entry):  # one of a model's own
                own = curve.basis.basis(len(curve.points))
                table |= {"bases": {own.name: table_of(own)}, "unchecked_basis": not own.partition}
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
        parts = _parts(data, name, folder)
        curves = _curves([part for part in parts if part[1].get("kind") == "curve"], folder)
        patches = tuple(patch_of(keys, called, folder) for called, keys in parts if keys.get("kind") != "curve")
        if tables is not None and not patches:
            raise ModelError("join: holds sides of surfaces together; curves are joined by join_curves")
        rules = () if tables is None else held(tables, tuple(patch.name for patch in patches))
        return Model(name or parts[0][0], unit, patches, rules, curves)._carried()

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
        parts: tuple[Patch | NamedCurve, ...] = (*self.patches, *self.curves)
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


def _parts(data: dict[str, Any], name: str, folder: Path | None) -> list[tuple[str, dict[str, Any]]]:
    """Return the name and the keys of each patch or curve, with the bases that a file has for all of them."""
    if "patch" not in data:
        return [(name or str(data.get("kind", "surface")), data)]
    tables: object = data.pop("patch")
    try:
        shared = with_bases({"bases": data.pop("bases", {})}, folder)["bases"]
    except ModelError:
        raise
    except ValueError as error:
        raise ModelError(str(error)) from None
    if not isinstance(tables, list) or not tables:
        raise ModelError(f"patch: expected one or more [[patch]] tables, got {spell(tables)}")
    if data:
        key = next(iter(data))
        raise ModelError(f"unknown key {key!r} beside [[patch]] tables{nearest(key, HEADER)}; move it into a patch")
    parts: dict[str, dict[str, Any]] = {}
    for index, table in enumerate(cast(list[Any], tables)):
        place = f"patch {index + 1}"
        if not isinstance(table, dict):
            raise ModelError(f"{place}: expected a table of keys, got {spell(table)}")
        keys = cast(dict[str, Any], table)
        called = _text(keys.get("name", place), f"{place}: name")
        if called in parts:
            raise ModelError(f'patch "{called}": two patches have this name; give each its own')
        form = {**kinds(), "curve": CurveKind}.get(str(keys.get("kind")))
        takes = shared and form is not None and "bases" in form.model_fields
        parts[called] = {"bases": shared, **keys} if takes else keys
    return list(parts.items())


def _curves(parts: list[tuple[str, dict[str, Any]]], folder: Path | None) -> tuple[NamedCurve, ...]:
    """Return the curves of a model; ModelError where some are in the plane and some in space."""
    curves = tuple(curve_of(keys, called, folder) for called, keys in parts)
    if len({one.curve.points.shape[1] for one in curves}) > 1:
        raise ModelError("points: expected curves all in the plane or all in space, found both in one model")
    return curves


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
