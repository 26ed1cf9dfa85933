"""Commented starter models, one for every kind: ``quintrig new KIND``.

The comments are the descriptions of the keys in ``definition``, so that there is one place that says what a key means.
"""

import json
import textwrap
from typing import Any, cast

from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.registry import kinds
from quintrig.model.model import SCHEMA_VERSION, UNITS
from quintrig.support.errors import nearest

_WIDTH = 100


def starter(kind: str) -> str:
    """Return a valid, commented TOML model of this kind; ValueError with the nearest known kind."""
    known: dict[str, type[Definition]] = {**kinds(), "curve": CurveKind}
    if kind not in known:
        raise ValueError(f"kind: expected one of {', '.join(known)}, got {kind!r}{nearest(kind, known)}")
    form = known[kind]
    values = form.starter
    lines = [
        *_comment(f"{_first_line(form)} Check it with: quintrig check FILE.toml"),
        "",
        f"schema = {SCHEMA_VERSION}",
        f'name = "My {kind.replace("_", " ")}{" surface" if form.nets and kind != "curve" else ""}"',
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
