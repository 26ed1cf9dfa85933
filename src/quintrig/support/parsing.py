"""The one reader of TOML and JSON: text that no model has is refused before a parser spends time and memory on it."""

import json
import re
import secrets
import tomllib
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from quintrig.support.errors import ModelError

LARGEST_FILE = 16 * 2**20
"""Bytes; the largest real model is a few kilobytes."""

DEEPEST = 32
"""Levels of tables and lists in each other, and parts of a dotted key; a model has five."""

MOST_KEYS = 100_000
"""Keys and tables of one file: a parser takes about a kilobyte for each."""

MOST_PIECES = 1_000_000
"""Keys, texts and remarks of one TOML file: a second for looking at each."""

LARGEST_SLOW = 2 * 2**20
"""Letters of TOML beside its lists of plain numbers and its remarks, a second or two of work for the parser."""

_LONG = 4096  # letters of a list of numbers from which it is worth a parser of its own
_REST = r"[^\"'#=]++"
_BASIC = r'"(?:[^"\\\n]++|\\.)*+"?'
_TOML = re.compile(
    r"(?P<list>=[ \t]*+(?=\[))|(?P<remark>#[^\n]*+)|=|" + _REST + "|"
    r'(?P<text>"""(?:[^"\\]++|\\.|"(?!""))*+(?:"{3,5})?|\'\'\'(?:[^\']++|\'(?!\'\'))*+(?:\'{3,5})?|'
    + _BASIC
    + r"|'[^'\n]*+'?)",
    re.DOTALL,
)
_JSON_TEXT = re.compile(r'"[^"\\]*+(?:\\.[^"\\]*+)*+"?', re.DOTALL)
_NUMBERS = re.compile(r"[0-9eE+\-., \t\n\[\]]*+")
_LAST_COMMA = re.compile(r"(?<=[0-9\]]),(?=[ \t\n]*+\])")
_DOTTED = re.compile(r'(?<![\w"-])(?:(?:[\w-]++|"")[ \t]*+\.[ \t]*+){%d}' % DEEPEST)  # noqa: UP031
_HEADER = re.compile(r"^[ \t]*+\[[^\n,\]]*+\]", re.MULTILINE)


def parse(text: str, suffix: str, largest: int = LARGEST_FILE) -> Any:
    """Return what TOML or JSON text of at most ``largest`` letters holds, by the ending ``.toml`` or ``.json``.

    Raises ModelError, without the name of the file, for a mistake of syntax, a key given twice, and what is too deep,
    too large or of too many keys to be a model.
    """
    form = suffix[1:].upper()
    if len(text) > largest:
        raise ModelError(f"expected at most {largest >> 20} MB, found more; is this a model?")
    try:
        return _json(text) if form == "JSON" else _toml(text)
    except RecursionError:
        raise _too_deep() from None
    except ModelError:
        raise
    except ValueError as error:
        raise ModelError(f"not valid {form}: {_syntax(error)}") from None


def _json(text: str) -> Any:
    bare = _JSON_TEXT.sub('""', text)
    _check(bare, keys=bare.count(":") + bare.count("{"))
    return json.loads(text, object_pairs_hook=_once)


def _toml(text: str) -> Any:
    """Return the keys of TOML; long lists of plain numbers go through the parser of JSON, whose spelling is the same.

    They are ten times faster there, and so a net is as fast in one form as in the other.
    """
    folded = fold(text)
    return folded.filled(tomllib.loads(folded.text))


@dataclass
class Folded:
    """TOML in which texts stand for its long lists of plain numbers: ``mark``, then an index of ``values``.

    ``bodies`` holds how the lists were spelled.
    """

    text: str
    mark: str
    values: list[Any]
    bodies: list[str]

    def filled(self, value: Any) -> Any:
        """Return what was read of the text with the lists in their places."""
        if isinstance(value, str) and value.startswith(self.mark):
            return self.values[int(value[len(self.mark) :].partition(":")[0])]
        if isinstance(value, dict):
            return {key: self.filled(item) for key, item in cast(dict[str, Any], value).items()}
        if isinstance(value, list):
            return [self.filled(item) for item in cast(list[Any], value)]
        return value

    def put(self, body: str) -> str:
        """Return a text that ``unfolded`` replaces by ``body``."""
        self.values.append(None)
        self.bodies.append(body)
        return f"{self.mark}{len(self.bodies) - 1}:"

    def unfolded(self, text: str) -> str:
        """Return TOML with every list as it was spelled."""
        return re.sub(rf'"(?:"")?{self.mark}(\d+):\n*"(?:"" )?', lambda found: self.bodies[int(found[1])], text)


def fold(text: str) -> Folded:
    """Fold TOML up, its lines ended by newlines alone; ModelError for what is too large or too deep for a parser."""
    text = text.replace("\r\n", "\n")
    result = Folded("", secrets.token_hex(8), [], [])  # a mark that no file holds
    kept: list[str] = []
    bare: list[str] = []
    at = 0
    while found := _TOML.match(text, at):
        at = found.end()
        if len(kept) > MOST_PIECES:
            raise ModelError(f"expected at most {MOST_PIECES:,} keys, texts and remarks, found more; is this a model?")
        kept.append(found[0])
        bare.append('""' if found["text"] else "" if found["remark"] else found[0])
        numbers = _numbers(text, at) if found["list"] else None
        if numbers is not None:
            # The lines stay, so that a mistake further down is told in its own.
            value, end = numbers
            lines = "\n" * text.count("\n", at, end)
            kept.append(f'"""{result.put(text[at:end])}{lines}""" ')
            result.values[-1] = value
            at = end
    rest = "".join(bare)
    if _DOTTED.search(rest):
        raise _too_deep()
    _check(rest, keys=rest.count("=") + rest.count("{") + len(_HEADER.findall(rest)))
    if len(rest) > LARGEST_SLOW:
        raise ModelError(
            f"expected at most {LARGEST_SLOW >> 20} MB of TOML beside lists of plain numbers, found "
            f"{len(rest) / 2**20:.1f} MB; keep large nets in .csv files beside the model, or write it as .json"
        )
    result.text = "".join(kept)
    return result


def _numbers(text: str, start: int) -> tuple[Any, int] | None:
    """Return a long list of plain numbers that starts here, and where it ends; None for anything else."""
    found = _NUMBERS.match(text, start)
    if found is None or len(found[0]) < _LONG:
        return None
    _check(found[0], keys=0)
    try:
        value, length = json.JSONDecoder().raw_decode(_LAST_COMMA.sub(" ", found[0]))
    except ValueError:
        return None
    return value, start + length


def _check(bare: str, keys: int) -> None:
    """Raise ModelError for brackets too deep, or too many keys, in text without strings and remarks."""
    letters = np.frombuffer(bare.encode("ascii", "replace"), np.uint8)
    opened = (letters == ord("[")) | (letters == ord("{"))
    closed = (letters == ord("]")) | (letters == ord("}"))
    steps = opened.view(np.int8) - closed.view(np.int8)
    if steps.cumsum(dtype=np.int32).max(initial=0) > DEEPEST:
        raise _too_deep()
    if keys > MOST_KEYS:
        raise ModelError(f"expected at most {MOST_KEYS:,} keys and tables, found {keys:,}; is this a model?")


def _too_deep() -> ModelError:
    return ModelError(f"nested too deeply to be a model (more than {DEEPEST} levels)")


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Refuse a key given twice, of which JSON would keep the last in silence."""
    keys: dict[str, Any] = {}
    for key, value in pairs:
        if key in keys:
            raise ValueError(f"the key {key[:60]!r} is given twice")
        keys[key] = value
    return keys


def _syntax(error: ValueError) -> str:
    """Say in the user's terms what a parser found."""
    text = (str(error).splitlines() or [type(error).__name__])[0][:200]
    if "integer string conversion" in text:
        return "a number has thousands of digits"
    return text.replace("Cannot overwrite a value", "a key is given twice")
