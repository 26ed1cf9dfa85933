"""The JSON Schema of model files, published by ``quintrig schema``."""

from typing import Any

from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.registry import kinds
from quintrig.model.model import SCHEMA_VERSION, UNITS


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
        "properties": header | {"patch": {"type": "array", "minItems": 1, "items": {"oneOf": forms}}},
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
    return form
