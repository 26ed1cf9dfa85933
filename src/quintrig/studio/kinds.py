"""What the browser needs to know of a kind: its keys, their types and defaults, and a starter."""

from collections.abc import Iterable
from typing import Any, cast

import annotated_types
from pydantic import TypeAdapter

from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.registry import OWN, kinds
from quintrig.model.model import Model
from quintrig.model.starter import starter
from quintrig.studio.bases import installed_bases
from quintrig.studio.built import for_page
from quintrig.support.errors import QuintrigError
from quintrig.support.parsing import parse

_ANY = TypeAdapter[Any](Any)


def kind(form: type[Definition]) -> dict[str, Any]:
    """Return the table of a kind: title, names of its shape parameters, and its keys."""
    properties = cast(dict[str, Any], form.model_json_schema()["properties"])
    keys = [key for key in form.model_fields if key not in ("kind", "name")]
    return {
        "title": (form.__doc__ or "").strip().splitlines()[0].rstrip("."),
        "construction": bool(form.nets),
        "surface": form is not CurveKind,
        "shapeNames": list(form.shape_names),
        "fields": {key: _field(form, key, properties[key]) for key in keys},
    }


def installed(names: Iterable[str] | None = None) -> dict[str, Any]:
    """Return tables and starters of the kinds that installed packages bring, all or those named; nothing without any.

    All come with the bases that packages bring; those of a model travel with it.

    The bundle holds the tables of quintrig's own kinds, and knows nothing of others until a page tells it.
    """
    forms = {name: form for name, form in kinds().items() if name not in OWN and (names is None or name in names)}
    bases = installed_bases() if names is None else []
    library = {"library": bases} if bases else {}
    if not forms:
        return library
    starters: dict[str, Any] = {}
    for name in forms:
        try:
            starters[name] = for_page(Model.from_dict(parse(starter(name), ".toml")))
        except QuintrigError:  # a starter that is not valid is none; its package's own tests say so
            continue
    tables = {name: kind(form) for name, form in forms.items()}
    for name in forms.keys() - starters.keys():
        tables[name]["construction"] = False
    return {"kinds": tables, "starters": starters} | library


def _field(form: type[Definition], key: str, schema: dict[str, Any]) -> dict[str, Any]:
    field = form.model_fields[key]
    result: dict[str, Any] = {"description": field.description or "", "required": field.is_required()}
    if not field.is_required():
        own = _ANY.dump_python(field.get_default(call_default_factory=True), mode="json")
        result["default"] = [0.0] * len(form.shape_names) if key == "shape" else own
    return result | _type(form, key, schema)


def _type(form: type[Definition], key: str, schema: dict[str, Any]) -> dict[str, Any]:
    if form is CurveKind and key in form.nets:
        return {"type": "points", "counts": [0], "dimension": 0}  # any number of points, in the plane or in space
    if key in form.nets and key in form.counts:
        return {"type": "points", "counts": list(form.counts[key]), "dimension": _dimension(schema)}
    if "enum" in schema:
        return {"type": "choice", "choices": schema["enum"]}
    positive = any(isinstance(limit, annotated_types.Gt) and limit.gt == 0 for limit in form.model_fields[key].metadata)
    plain = {"boolean": "boolean", "number": "positive" if positive else "number"}
    named = {"mirror": "plane", "basis": "basis"} | ({"shape": "shape"} if form.shape_names else {})
    return {"type": plain.get(str(schema.get("type"))) or named.get(key, "raw")}


def _dimension(schema: dict[str, Any]) -> int:
    """Return how many numbers a point of a net has."""
    while "items" in schema.get("items", {}):
        schema = schema["items"]
    return int(schema.get("minItems", 3))
