"""The bundle as text: in a page of its own, inside a report, or for Jupyter."""

import json
from typing import Any


def as_json(value: Any) -> str:
    """Return JSON that may stand inside a script element: no ``<``, no line separators."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")
