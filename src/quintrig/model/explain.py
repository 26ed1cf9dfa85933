"""What is wrong with a model file, in one line: where, what was expected, what was found."""

import json
import reprlib
from typing import Any

from pydantic import ValidationError

from quintrig.model.kinds.definition import Definition
from quintrig.support.arrays import LARGEST, SMALLEST
from quintrig.support.errors import closest, nearest

HEADER = ("schema", "name", "unit", "bases", "patch", "join")
"""Keys that stand at the top of a file, whatever the kind."""

_NUMBER = f"a number of size at most {LARGEST:.0e}".replace("e+", "e")
_LONGEST = 60


def explain(error: ValidationError, form: type[Definition], keys: dict[str, Any]) -> str:
    """Tell the first mistake that pydantic found in the ``keys`` of a ``form``, and how many more there are.

    An unknown key comes before the others: it is why the key that it misspells is missing.
    """
    details = error.errors(include_url=False)
    first = next((one for one in details if one["type"] == "extra_forbidden"), details[0])
    if first["type"] == "extra_forbidden":
        meant = closest(str(first["loc"][0]), form.model_fields)
        details = [one for one in details if one["type"] != "missing" or one["loc"] != (meant,)]
    place = "".join(
        f"[{part}]" if isinstance(part, int) else f"{'.' if i else ''}{part}" for i, part in enumerate(first["loc"])
    )
    kind, found, context = first["type"], first["input"], first.get("ctx", {})
    more = f" (and {len(details) - 1} more such)" if len(details) > 1 else ""
    if kind == "extra_forbidden":
        return _unknown(place, form) + more
    if kind == "value_error":
        return f"{place}: {context['error']}{more}"
    if kind == "missing":
        return f"missing key {place!r}: expected {form.model_fields[place].description}{more}"
    if kind in ("too_short", "too_long"):
        expected, found = _count(first["loc"], form, keys, context, kind), len(found)
    else:
        expected = expected_in_place(kind, found, context) or f"{first['msg'][0].lower()}{first['msg'][1:]}"
    return f"{place}: expected {expected}, got {spell(found)}{more}"


def spell(value: Any) -> str:
    """Return a value as it would stand in a model file, cut short where it is long."""
    if isinstance(value, bool) or value is None:
        return json.dumps(value)
    short = reprlib.Repr()
    short.maxlevel, short.maxlist, short.maxdict = 3, 4, 3
    short.maxstring = short.maxother = short.maxlong = _LONGEST
    try:
        text = short.repr(value)
    except ValueError:  # Python does not spell integers of more than 4300 digits
        return "a number with thousands of digits"
    return text if len(text) <= _LONGEST else text[: _LONGEST - 3] + "..."


def _unknown(place: str, form: type[Definition]) -> str:
    if place in HEADER:
        return f"unknown key {place!r}: it belongs at the top of the file, above the patches"
    known = dict.fromkeys((*form.model_fields, *HEADER))
    hint = nearest(place, known) or f"; the keys of this kind are {', '.join(form.model_fields)}"
    return f"unknown key {place!r}{hint}"


def expected_in_place(kind: str, found: Any, context: dict[str, Any]) -> str:
    """Return what was expected in place of one value, or an empty string for a rare kind of mistake."""
    too_large = isinstance(found, (int, float)) and not isinstance(found, bool)
    if kind in ("less_than_equal", "greater_than_equal") and abs(context[kind[0] + "e"]) == LARGEST:
        return _NUMBER
    if kind == "greater_than_equal" and context["ge"] == SMALLEST:
        return "a number greater than 0" if found <= 0 else f"a number of size at least {SMALLEST:g}"
    words = {
        "finite_number": "a finite number",
        "float_type": _NUMBER if too_large else "a number",
        "int_type": "a whole number",
        "list_type": "a list",
        "bool_type": "true or false",
        "string_type": "a text",
        "string_too_short": "a text that is not empty",
        "string_too_long": "a text of at most {max_length} characters",
        "literal_error": "{expected}",
        "greater_than": "a number greater than {gt:g}",
        "greater_than_equal": "a number of at least {ge:g}",
        "less_than_equal": "a number of at most {le:g}",
    }
    return words[kind].format(**context) if kind in words else ""


def _count(
    location: tuple[int | str, ...], form: type[Definition], keys: dict[str, Any], context: dict[str, Any], kind: str
) -> str:
    """Return how many points, rows or numbers were expected."""
    key, depth = str(location[0]), len(location) - 1
    counts = form.counts.get(key, ())
    nouns = ("rows", "points") if len(counts) == 2 else ("planes" if key in ("planes", "bounds") else "points",)
    noun = nouns[depth] if key in form.counts and depth < len(nouns) else "numbers"
    if depth < len(counts) and keys.get("basis", "trigonometric") == "trigonometric":
        return f"{counts[depth]} {noun}"
    limits = form.model_json_schema()["properties"].get(key, {})
    for _ in range(depth):
        limits = limits.get("items", {})
    if limits.get("minItems") is not None and limits.get("minItems") == limits.get("maxItems"):
        return f"{limits['minItems']} {noun}"
    return (
        f"at least {context['min_length']} {noun}" if kind == "too_short" else f"at most {context['max_length']} {noun}"
    )
