"""Models as TOML text: written anew, or into a text that people wrote, whose comments and order stay."""

import json
import textwrap
from typing import Any, cast

import tomlkit

from quintrig.support.parsing import Folded, fold

_WIDTH = 110
TABLES = ("patch", "join")
"""Keys whose values are lists of tables."""

_LARGEST_EDITED = 2**18  # letters beside long lists of numbers: a second of tomlkit


def to_toml(keys: dict[str, Any]) -> str:
    """Return the keys of a model file as TOML, ``patch`` and ``join`` as ``[[...]]`` tables."""
    lines = [f"{key} = {spell(value)}" for key, value in keys.items() if key not in TABLES]
    for name in TABLES:
        for table in keys.get(name, ()):
            lines += ["", f"[[{name}]]", *(f"{key} = {spell(value)}" for key, value in table.items())]
    return "\n".join(lines) + "\n"


def spell(value: Any, indent: str = "") -> str:
    """Return a value as TOML: points of a net one a line or in rows, numbers as ``plain`` has them."""
    flat = json.dumps(plain(value), ensure_ascii=False)  # JSON's spelling of these values is TOML's
    if not isinstance(value, list):
        return flat
    items = cast(list[Any], value)
    nested = any(isinstance(item, list) for item in items)
    if len(indent) + len(flat) <= _WIDTH and not (nested and not indent):
        return flat
    inner = indent + "    "
    if nested:
        text = ",\n".join(inner + spell(item, inner) for item in items)
    else:
        words = ", ".join(map(spell, items))
        text = textwrap.fill(words, _WIDTH, initial_indent=inner, subsequent_indent=inner)
    return f"[\n{text},\n{indent}]"


def plain(value: Any) -> Any:
    """Return a value of a model file with whole numbers as such, as people write them: 100 for 100.0."""
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15 and (value or str(value) == "0.0"):
        return int(value)
    if isinstance(value, dict):
        return {key: plain(item) for key, item in cast(dict[str, Any], value).items()}
    return [plain(item) for item in cast(list[Any], value)] if isinstance(value, list) else value


def edited(text: str, before: dict[str, Any], wanted: dict[str, Any]) -> str:
    """Return TOML that says ``before`` changed so that it says ``wanted``, all else as it was.

    Raises ValueError where that cannot be done in place.
    """
    folded = fold(text)
    if len(folded.text) > _LARGEST_EDITED:
        raise ValueError("expected a shorter text to edit in place")
    if before.get("join") != wanted.get("join"):
        raise ValueError("joins: expected those that are there")
    document = tomlkit.parse(folded.text)
    if "patch" in before and "patch" in wanted:
        _edit_patches(cast(Any, document)["patch"], before["patch"], wanted["patch"], folded)
        before, wanted = ({key: value for key, value in keys.items() if key != "patch"} for keys in (before, wanted))
    _edit(document, before, wanted, folded)
    result = folded.unfolded(tomlkit.dumps(document))
    return result.replace("\n", "\r\n") if "\r\n" in text else result


def _edit(table: Any, before: dict[str, Any], wanted: dict[str, Any], folded: Folded) -> None:
    for key in [key for key in before if key not in wanted and key in table]:
        del table[key]
    for key, value in wanted.items():
        if before.get(key) != value:
            table[key] = folded.put(spell(value))


def _edit_patches(tables: Any, before: list[dict[str, Any]], wanted: list[dict[str, Any]], folded: Folded) -> None:
    """Edit tables that stay, by place where there are as many as before, else by name; new ones come last."""
    if len(before) != len(wanted):
        names = [keys["name"] for keys in wanted]
        for index in reversed(range(len(before))):
            if before[index]["name"] not in names:
                del tables[index]
        before = [keys for keys in before if keys["name"] in names]
    for table, old, new in zip(tables, before, wanted, strict=False):
        _edit(table, old, new, folded)
    for new in wanted[len(before) :]:
        table = tomlkit.table()
        _edit(table, {}, new, folded)
        tables.append(table)
