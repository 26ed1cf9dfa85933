"""Numbers as people write them: Python's own reader also takes 1_0 for 10, and digits of every script."""

import re

_REAL = re.compile(r"[+-]?(?:(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?|inf(?:inity)?|nan)", re.ASCII | re.IGNORECASE)
_WHOLE = re.compile(r"[+-]?\d{1,18}", re.ASCII)


def real(text: str) -> float:
    """Return the number that a text spells, space around it aside; ValueError for anything else."""
    if not _REAL.fullmatch(text.strip()):
        raise ValueError(f"expected a number, got {text[:60]!r}")
    return float(text)


def whole(text: str) -> int:
    """Return the whole number of at most 18 digits that a text spells; ValueError for anything else."""
    if not _WHOLE.fullmatch(text.strip()):
        raise ValueError(f"expected a whole number, got {text[:60]!r}")
    return int(text)
