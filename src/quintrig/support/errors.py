"""The errors that quintrig raises for a user's mistake, apart from plain ``ValueError``."""

import difflib
from collections.abc import Iterable


class ModelError(ValueError):
    """A model file, or a part of one, that cannot be used.

    The message names the place, what was expected, what was found and the remedy, in one line.
    """


class QuintrigError(Exception):
    """A failure outside the model, such as a file that cannot be written, told in one line."""


def nearest(word: str, known: Iterable[str]) -> str:
    """Return a hint such as ``; did you mean 'profile'?``, or an empty string when nothing is near."""
    found = closest(word, known)
    return f"; did you mean {found!r}?" if found else ""


def closest(word: str, known: Iterable[str]) -> str:
    """Return the known word that is spelt most like ``word``, or an empty string when nothing is near."""
    return next(iter(difflib.get_close_matches(word, list(known), n=1, cutoff=0.6)), "")


def printable(text: str) -> str:
    """Return the text on one line, with control characters, which could act on a terminal, spelled out."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in " ".join(text.splitlines()))
