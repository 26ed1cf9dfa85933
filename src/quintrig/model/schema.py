"""The JSON Schema of model files, published by ``quintrig schema``."""

from typing import Any

from quintrig.basis.registry import bases
from quintrig.model.held import ORDERS, SIDES
from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.registry import kinds
from quintrig.model.model import SCHEMA_VERSION, UNITS

_SIDE = {"type": "string", "pattern": f"^.+:({'|'.join(SIDES)})$"}
_JOIN: dict[str, Any] = {
    "title": "A side held to another one",
    "type": "object",
    "properties": {
        "first": _SIDE | {"description": "PATCH:SIDE that leads, such as a:u1"},
        "second": _SIDE | {"description": "PATCH:SIDE that follows, such as b:u0"},
        "order": {"enum": list(ORDERS), "default": "G1", "description": "How smooth the seam is"},
        "ratio": {
            "type": "number",
            "exclusiveMinimum": 0,
            "default": 1,
            "description": "Speed across the seam",
        },
    },
    "required": ["first", "second"],
    "additionalProperties": False,
}


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema (2020-12) of a model file: one surface, or several in ``[[patch]]`` tables."""
    header: dict[str, Any] = {
        "schema": {"const": SCHEMA_VERSION, "description": "Version of this format"},
        "name": {"type": "string", "maxLength": 200, "description": "Name of the model"},
        "unit": {"enum": list(UNITS), "description": "Unit of length; leave it out for plain numbers"},
    }
    forms = [_form(form) for form in (*kinds().values(), CurveKind)]
    alone = [form | {"properties": header | form["properties"]} for form in forms]
    several = {
        "title": "Several patches",
        "type": "object",
        "properties": header
        | {
            "bases": {"type": ["object", "string"], "description": "Bases of the patches' own, by name"},
            "patch": {"type": "array", "minItems": 1, "items": {"oneOf": forms}},
            "join": {"type": "array", "minItems": 1, "items": _JOIN},
        },
        "required": ["patch"],
        "additionalProperties": False,
    }
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "quintrig model",
        "description": "Quintic trigonometric Bézier surfaces or curves; a CSV file beside it may hold a net.",
        "oneOf": [*alone, several],
    }


def _form(definition: type[Definition]) -> dict[str, Any]:
    form = definition.model_json_schema()
    form["required"] = ["kind", *[key for key in form.get("required", []) if key != "kind"]]
    for key in definition.nets:
        numbers = form["properties"][key]
        description = numbers.pop("description", "")
        file = {"type": "string", "pattern": r"\.[cC][sS][vV]$"}
        form["properties"][key] = {"description": description, "anyOf": [numbers, file]}
    return form | _of_basis(definition) if "basis" in form["properties"] else form


def _of_basis(definition: type[Definition]) -> dict[str, Any]:
    """Return what hangs on the basis: its name, and how many shape parameters the quintic one has."""
    name = {"enum": list(bases())}
    known = {"properties": {"basis": {"anyOf": [name, {"type": "array", "items": name, "minItems": 2, "maxItems": 2}]}}}
    count = len(definition.shape_names)
    shape = {"properties": {"shape": {"anyOf": [{"maxItems": 0}, {"minItems": count, "maxItems": count}]}}}
    return {
        "allOf": [
            {"if": {"not": {"required": ["bases"]}}, "then": known},
            {"if": {"not": {"required": ["basis"]}}, "then": shape},
        ]
    }
