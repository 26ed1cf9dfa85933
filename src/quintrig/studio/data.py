"""What Python tells the browser: the tables of quantities, kinds, colours and presets, as one JSON document.

``python -m quintrig.studio.data OUT`` writes it; ``make bundle`` builds it into the bundle, so that names, units,
ranges and colours are stated once.
"""

import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import Colormap, to_hex

from quintrig import __version__
from quintrig.basis.trigonometric import SHAPE_RANGE
from quintrig.figure import palette
from quintrig.geometry.envelope import ROUNDING
from quintrig.geometry.surface import FAR_OFF, SAME_POINT, STEPS_FOR_SIZE
from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.definition import LARGEST_POLYGON, Definition
from quintrig.model.kinds.registry import OWN
from quintrig.model.model import SCHEMA_VERSION, UNITS, load
from quintrig.model.starter import starter
from quintrig.quantities.classify import SHAPE_BREAKS, Thresholds
from quintrig.quantities.signs import CLASSES, POINTS, TYPES, SignTable
from quintrig.quantities.table import BY_KEY, QUANTITIES, Quantity
from quintrig.shaping.shape_effect import SHAPE_SETS
from quintrig.studio import built
from quintrig.studio.bases import KEYS, library
from quintrig.studio.kinds import kind
from quintrig.studio.page import as_json
from quintrig.support.arrays import LARGEST
from quintrig.support.files import write_whole
from quintrig.support.parsing import parse
from quintrig.support.tolerance import NOISE, SAME_COLOUR, SINGULAR, VERTICAL

WORDS: dict[str, SignTable] = {"point_type": POINTS, "hk_type": TYPES, "shape_class": CLASSES}
"""The tables of signs that say in words what the types of a classification look like."""

DRAWN: dict[str, type[Definition]] = {**OWN, "curve": CurveKind}
"""Every kind that the browser draws: those of surfaces, and curves."""

EXAMPLES = Path(__file__).parents[3] / "examples"
"""The example models of the repository, which become the presets when the bundle is built."""

_LARGEST_PRESET = 8192
"""Bytes of an example: presets travel in every report page, so a body of many patches is none."""


def table() -> dict[str, Any]:
    """Return everything that the browser takes from Python."""
    return {
        "version": __version__,
        "schema": SCHEMA_VERSION,
        "units": list(UNITS),
        "shapeRange": list(SHAPE_RANGE),
        "shapeSets": {count: [list(one) for one in sets] for count, sets in SHAPE_SETS.items()},
        "quantities": [_quantity(q) for q in QUANTITIES],
        "limits": {
            **asdict(Thresholds()),
            "noise": NOISE,
            "sameColour": SAME_COLOUR,
            "rounding": ROUNDING,
            "singular": SINGULAR,
            "stepsForSize": STEPS_FOR_SIZE,
            "farOff": FAR_OFF,
            "samePoint": SAME_POINT,
            "vertical": VERTICAL,
            "largest": LARGEST,
            "largestPolygon": LARGEST_POLYGON,
        },
        "shapeBreaks": list(SHAPE_BREAKS),
        "families": [*built.FAMILIES.values(), "chebyshev"],
        "library": library(),
        "basisKeys": list(KEYS),
        "words": {key: _words(BY_KEY[key], signs) for key, signs in WORDS.items()},
        "kinds": {name: kind(form) for name, form in DRAWN.items()},
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
        "starters": {name: parse(starter(name), ".toml") for name in DRAWN},
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


def _stops(colours: Colormap) -> list[str]:
    return [to_hex(rgba) for rgba in colours(np.linspace(0.0, 1.0, 33))]


def _presets() -> list[dict[str, Any]]:
    small = [path for path in sorted(EXAMPLES.glob("*.toml")) if path.stat().st_size <= _LARGEST_PRESET]
    return [load(path).to_dict() for path in small]


def main(out: str) -> None:
    """Write the table to a file, whole or not at all."""
    write_whole(out, as_json(table()) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
