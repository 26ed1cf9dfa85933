"""Models as TOML text: the few kinds of value that model files hold."""

import json
import textwrap
from typing import Any, cast

_WIDTH = 110
TABLES = ("patch", "join")
"""Keys whose values are lists of tables."""


def to_toml(keys: dict[str, Any], remarks: tuple[str, ...] = ()) -> str:
    """Return the keys of a model file as TOML, ``patch`` and ``join`` as tables, remarks as comments on top."""
    lines = [f"# {' '.join(remark.split())}" for remark in remarks]
    lines += [_line(key, value) for key, value in keys.items() if key not in TABLES]
    for name in TABLES:
        for table in keys.get(name, ()):
            lines += ["", f"[[{name}]]", *(_line(key, value) for key, value in table.items())]
    return "\n".join(lines) + "\n"


def _line(key: str, value: Any) -> str:
    return f"{key} = {_value(value, '')}"


def _value(value: Any, indent: str) -> str:
    """Return a value in one line where it fits, else one item a line; JSON's spelling of these values is TOML's."""
    flat = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, list) or len(indent) + len(flat) <= _WIDTH:
        return flat
    items = cast(list[Any], value)
    inner = indent + "    "
    if not isinstance(items[0], list):
        words = [json.dumps(item, ensure_ascii=False) for item in items]
        text = textwrap.fill(", ".join(words), _WIDTH, initial_indent=inner, subsequent_indent=inner)
    else:
        text = ",\n".join(inner + _value(item, inner) for item in items)
    return f"[\n{text},\n{indent}]"
