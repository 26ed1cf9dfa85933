"""Commented starter models, one for every kind: ``quintrig new KIND``.

The comments are the descriptions of the keys in ``definition``, so that there is one place that says what a key means.
"""

import json
import textwrap
from typing import Any, cast

from quintrig.model.definition import KINDS, Definition
from quintrig.model.model import SCHEMA_VERSION, UNITS
from quintrig.support.errors import nearest

_WIDTH = 100

_HILL = (0, 14, 38, 42, 18, 4)
_ARCH = (0, 10, 30, 30, 10, 0)

_VALUES: dict[str, dict[str, Any]] = {
    "tensor": {
        "points": [[[20 * i, 20 * j, round(a * b / 36)] for j, b in enumerate(_HILL)] for i, a in enumerate(_HILL)]
    },
    "symmetric": {
        "points": [
            [[20 * i, 20 * j, a + round(0.6 * b)] for j, b in enumerate(_HILL)] for i, a in enumerate(_ARCH[:3])
        ],
        "mirror": [1, 0, 0, -50],
    },
    "swept": {
        "section": [[20 * i, 0, z] for i, z in enumerate(_ARCH)],
        "trajectory": [[0, 20 * i, round(0.8 * z)] for i, z in enumerate(_HILL)],
    },
    "swung": {
        "profile": [[20, 0], [60, 10], [80, 40], [50, 70], [30, 100], [40, 120]],
        "trajectory": [[1, 0], [1, 0.6], [0.7, 1], [-0.7, 1], [-1, 0.6], [-1, 0]],
        "scale": 1,
        "flip": True,
    },
    "ruled": {
        "first": [[20 * i, 0, z] for i, z in enumerate(_ARCH)],
        "second": [[20 * i, 100, round(z / 3)] for i, z in enumerate(_HILL)],
    },
    "developable": {
        "planes": [
            [-1, 0.2, 1, -110],
            [-0.8, 0.1, 1, -90],
            [-0.35, -0.05, 1, -60],
            [0.35, -0.05, 1, -60],
            [0.8, 0.1, 1, -90],
            [1, 0.2, 1, -110],
        ],
        "bounds": [[0, 1, 0, 0], [0, 1, 0, -100]],
    },
    "nurbs": {
        "degrees": [2, 2],
        "knots": [[0, 0, 0, 1, 1, 1], [0, 0, 0, 1, 1, 1]],
        "points": [
            [[x, y, z + rise] for y, z in ((0, 0), (50, 50), (100, 0))] for x, rise in ((0, 0), (50, 30), (100, 0))
        ],
        "weights": [[1, 0.7, 1], [1, 0.7, 1], [1, 0.7, 1]],
    },
}
"""A good-looking surface for each kind whose keys have no default of their own, lengths in mm."""

_REFERENCE_LENGTHS: dict[str, dict[str, Any]] = {
    "sphere": {"radius": 20},
    "ellipsoid": {"a": 30, "b": 20, "c": 10},
    "cylinder": {"radius": 10, "height": 40},
    "cone": {"radius": 10, "height": 20},
    "torus": {"major": 30, "minor": 10},
    "catenoid": {"waist": 10, "height": 20},
    "helicoid": {"radius": 10, "pitch": 20},
}


def starter(kind: str) -> str:
    """Return a valid, commented TOML model of this kind; ValueError with the nearest known kind."""
    if kind not in KINDS:
        raise ValueError(f"kind: expected one of {', '.join(KINDS)}, got {kind!r}{nearest(kind, KINDS)}")
    form = KINDS[kind]
    values = _VALUES.get(kind, {}) | _REFERENCE_LENGTHS.get(kind, {})
    lines = [
        *_comment(f"{_first_line(form)} Check it with: quintrig check FILE.toml"),
        "",
        f"schema = {SCHEMA_VERSION}",
        f'name = "My {kind.replace("_", " ")}{"" if kind in _REFERENCE_LENGTHS else " surface"}"',
        *_comment(f"Unit of length, one of {', '.join(UNITS)}; leave it out for plain numbers."),
        'unit = "mm"',
        f'kind = "{kind}"',
    ]
    for key in sorted(form.model_fields, key=lambda key: _place(form, key, values)):
        field = form.model_fields[key]
        if key in ("kind", "name"):
            continue
        lines += ["", *_comment(f"{field.description}.")]
        if key in values or field.is_required():
            lines.append(f"{key} = {_toml(values[key])}")
        elif key == "shape":
            lines.append(f"{key} = {_toml(field.default)}")
        else:  # an option at its default: there to be switched on
            lines.append(f"# {key} = {_toml(field.default)}" if field.default is not None else f"# {key} = ...")
    return "\n".join(lines) + "\n"


def _place(form: type[Definition], key: str, values: dict[str, Any]) -> int:
    """Order the keys: what must be there, what is worth changing, then options left at their default."""
    if form.model_fields[key].is_required():
        return 0
    return 1 if key == "shape" else 2 if key in values else 3


def _first_line(form: type[Definition]) -> str:
    return (form.__doc__ or "").splitlines()[0]


def _comment(text: str) -> list[str]:
    return [f"# {line}" for line in textwrap.wrap(text, _WIDTH)]


def _toml(value: Any) -> str:
    """Return a value as TOML; the points of a net with one row a line."""
    if isinstance(value, list) and _depth(value) > 1:
        return "[\n" + "".join(f"    {_inline(row)},\n" for row in cast(list[Any], value)) + "]"
    return _inline(value)


def _inline(value: Any) -> str:
    if isinstance(value, list):
        return "[" + ", ".join(_inline(item) for item in cast(list[Any], value)) + "]"
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return json.dumps(value)


def _depth(value: Any) -> int:
    return 1 + max(map(_depth, cast(list[Any], value)), default=0) if isinstance(value, list) else 0
