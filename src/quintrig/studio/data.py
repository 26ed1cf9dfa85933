"""What Python tells the browser: the tables of quantities, kinds, colours and presets, as one JSON document.

``python -m quintrig.studio.data OUT`` writes it; ``make bundle`` builds it into the bundle, so that names, units,
ranges and colours are stated once.
"""

import sys
import tomllib
from dataclasses import asdict
from pathlib import Path
from typing import Any, cast

import annotated_types
import numpy as np
from matplotlib.colors import Colormap, to_hex

from quintrig import __version__
from quintrig.basis.trigonometric import SHAPE_RANGE
from quintrig.figure import palette
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.registry import CONSTRUCTIONS, OWN
from quintrig.model.model import SCHEMA_VERSION, UNITS, load
from quintrig.model.starter import starter
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.signs import CLASSES, POINTS, TYPES, SignTable
from quintrig.quantities.table import BY_KEY, QUANTITIES, Quantity
from quintrig.studio.page import as_json
from quintrig.support.files import write_whole
from quintrig.support.tolerance import SINGULAR, VERTICAL

SHAPE_SETS: dict[int, tuple[tuple[float, ...], ...]] = {
    4: ((1.0, 1.0, 1.0, 1.0), (1.0, 1.0, -3.0, -3.0), (1.0, -3.0, 1.0, -3.0), (1.0, 0.0, -2.0, -3.0)),
    2: ((1.0, 1.0), (0.0, -4.0), (-2.0, 0.0), (-2.0, -4.0)),
}
"""The four sets of shape parameters that the thesis compares (figures 4.3-4.6 and 4.29-4.32), by their number."""

WORDS: dict[str, SignTable] = {"point_type": POINTS, "hk_type": TYPES, "shape_class": CLASSES}
"""The tables of signs that say in words what the types of a classification look like."""

DRAWN = ("trigonometric", "bernstein")
"""The bases that the browser can draw."""

EXAMPLES = Path(__file__).parents[3] / "examples"
"""The example models of the repository, which become the presets when the bundle is built."""


def table() -> dict[str, Any]:
    """Return everything that the browser takes from Python."""
    return {
        "version": __version__,
        "schema": SCHEMA_VERSION,
        "units": list(UNITS),
        "shapeRange": list(SHAPE_RANGE),
        "shapeSets": {str(count): [list(one) for one in sets] for count, sets in SHAPE_SETS.items()},
        "quantities": [_quantity(q) for q in QUANTITIES],
        "limits": {**asdict(Thresholds()), "vertical": VERTICAL, "singular": SINGULAR},
        "words": {key: _words(BY_KEY[key], signs) for key, signs in WORDS.items()},
        "kinds": {name: _kind(form) for name, form in OWN.items()},
        "palette": {
            "undefined": palette.UNDEFINED,
            "front": palette.FRONT,
            "back": palette.BACK,
            "series": list(palette.SERIES),
            "classes": {key: list(colours) for key, colours in palette.CLASS_COLOURS.items()},
            "diverging": _stops(palette.DIVERGING),
            "sequential": _stops(palette.SEQUENTIAL),
        },
        "presets": _presets(),
        "starters": {kind: tomllib.loads(starter(kind)) for kind in OWN},
    }


def _quantity(q: Quantity) -> dict[str, Any]:
    return {
        "key": q.key,
        "symbol": q.symbol,
        "latex": q.latex,
        "name": q.name,
        "meaning": q.meaning,
        "source": q.source,
        "power": q.power,
        "parity": q.parity,
        "colour": q.colour,
        "partner": q.partner,
        "components": q.components,
        "classes": list(q.classes),
    }


def _words(q: Quantity, signs: SignTable) -> list[str]:
    """Return what each type of a classification looks like, empty where the table does not say."""
    said = {row[0]: row[-1] for row in signs.rows}
    return [said.get(name, "") for name in q.classes]


def _kind(form: type[Definition]) -> dict[str, Any]:
    properties = cast(dict[str, Any], form.model_json_schema()["properties"])
    keys = [key for key in form.model_fields if key not in ("kind", "name")]
    return {
        "title": (form.__doc__ or "").strip().splitlines()[0].rstrip("."),
        "construction": form in CONSTRUCTIONS,
        "fields": {key: _field(form, key, properties[key]) for key in keys},
    }


def _field(form: type[Definition], key: str, schema: dict[str, Any]) -> dict[str, Any]:
    field = form.model_fields[key]
    result: dict[str, Any] = {"description": field.description or "", "required": field.is_required()}
    if not field.is_required():
        result["default"] = [0.0] * len(form.shape_names) if key == "shape" else field.default
    if key in form.nets:
        return result | {"type": "points", "counts": list(form.counts[key]), "dimension": _dimension(schema)}
    if schema.get("type") == "boolean":
        return result | {"type": "boolean"}
    if schema.get("type") == "number":
        positive = any(isinstance(limit, annotated_types.Gt) for limit in field.metadata)
        return result | {"type": "positive" if positive else "number"}
    if key == "basis":
        return result | {"type": "choice", "choices": list(DRAWN)}
    if "enum" in schema:
        return result | {"type": "choice", "choices": schema["enum"]}
    return result | {"type": {"shape": "shape", "mirror": "plane"}.get(key, "raw")}


def _dimension(schema: dict[str, Any]) -> int:
    """Return how many numbers a point of a net has."""
    while "items" in schema.get("items", {}):
        schema = schema["items"]
    return int(schema.get("minItems", 3))


def _stops(colours: Colormap) -> list[str]:
    return [to_hex(rgba) for rgba in colours(np.linspace(0.0, 1.0, 33))]


def _presets() -> list[dict[str, Any]]:
    models = [load(path) for path in sorted(EXAMPLES.glob("*.toml"))]
    return [model.to_dict() for model in models]


def main(out: str) -> None:
    """Write the table to a file, whole or not at all."""
    write_whole(out, as_json(table()) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
