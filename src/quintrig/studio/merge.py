"""Saving into a TOML file that people wrote: values that changed are replaced, comments and all else stay."""

import json
import re
from pathlib import Path
from typing import Any

from quintrig.model.model import Model
from quintrig.model.toml import TABLES
from quintrig.support.errors import ModelError
from quintrig.support.parsing import parse

_KEY = re.compile(r"[ \t]*([A-Za-z0-9_-]+)[ \t]*=[ \t]*")
_STRING = re.compile(r'"""(?:[^\\]|\\.)*?"""|\'\'\'.*?\'\'\'|"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'', re.DOTALL)


def merged(text: str, model: Model, folder: Path | None = None) -> str:
    """Return TOML of the model, as close to ``text`` as can be; ``folder`` is where its CSV files lie.

    Falls back to writing everything anew where the file says something that cannot be changed in place.
    """
    wanted = model.to_dict()
    if not text or "patch" in wanted:
        return whole(wanted)
    try:
        data = parse(text, ".toml")
        before = Model.from_dict(data, folder).to_dict()
    except ModelError:
        return whole(wanted)
    result = text
    for key in sorted(set(before) | set(wanted) | set(data)):
        if before.get(key) == wanted.get(key):
            continue
        result = _with_value(result, key, wanted.get(key))
    try:
        same = Model.from_dict(parse(result, ".toml"), folder).to_dict() == wanted
    except ModelError:
        same = False
    return result if same else whole(wanted)


def whole(keys: dict[str, Any]) -> str:
    """Return the keys of a model file as TOML."""
    lines = [f"{key} = {spell(value)}" for key, value in keys.items() if key not in TABLES and value is not None]
    for name in TABLES:
        for table in keys.get(name, []):
            values = (f"{key} = {spell(value)}" for key, value in table.items() if value is not None)
            lines += ["", f"[[{name}]]", *values]
    return "\n".join(lines) + "\n"


def spell(value: Any, indent: str = "") -> str:
    """Return a value as TOML: lists of lists one a line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, float):
        return repr(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)
    if not isinstance(value, list | tuple):
        return str(value)
    items: list[Any] = list(value)  # pyright: ignore[reportUnknownArgumentType]
    if not any(isinstance(item, list | tuple) for item in items):
        return f"[{', '.join(spell(item) for item in items)}]"
    inner = indent + "    "
    return "[\n" + "".join(f"{inner}{spell(item, inner)},\n" for item in items) + indent + "]"


def _with_value(text: str, key: str, value: Any) -> str:
    """Replace, remove (None) or add a top-level key."""
    for name, start, value_start, end in _assignments(text):
        if name == key:
            if value is None:
                return text[:start] + text[end:].removeprefix("\n")
            return text[:value_start] + spell(value) + text[end:]
    if value is None:
        return text
    return f"{text.rstrip()}\n{key} = {spell(value)}\n"


def _assignments(text: str) -> list[tuple[str, int, int, int]]:
    """Return (key, start of its line, start and end of its value) of the top-level keys."""
    found: list[tuple[str, int, int, int]] = []
    at = 0
    while at < len(text):
        match = _KEY.match(text, at)
        if match:
            end = _value_end(text, match.end())
            found.append((match[1], at, match.end(), end))
            at = end
        newline = text.find("\n", at)
        at = len(text) if newline < 0 else newline + 1
    return found


def _value_end(text: str, at: int) -> int:
    """Return where the value that starts here ends: at the line's end or comment, outside strings and brackets."""
    depth = 0
    last = at
    while at < len(text):
        string = _STRING.match(text, at)
        if string:
            at = last = string.end()
            continue
        letter = text[at]
        if letter == "#":
            if depth == 0:
                return last
            at = text.find("\n", at) if "\n" in text[at:] else len(text)
            continue
        if letter == "\n" and depth == 0:
            return last
        depth += (letter in "[{") - (letter in "]}")
        at += 1
        if not letter.isspace():
            last = at
    return last
