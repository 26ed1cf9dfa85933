"""The errors that quintrig raises for a user's mistake, apart from plain ``ValueError``.

They speak of arguments and functions. The command line, which has options and commands in their place, says the same in
its own words by ``argument`` and ``key``.
"""

import difflib
from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Telling:
    """One line: the ``argument`` that it is about, with its ``value``, what is wrong, and the ``remedy``.

    ``key`` names the remedy, and ``file`` what it is to be done with, for who words it anew.
    """

    message: str
    argument: str = ""
    value: str = ""
    remedy: str = ""
    key: str = ""
    file: str = ""

    def line(self, argument: str, remedy: str) -> str:
        """Return the line with other words for the argument and the remedy."""
        place = f"{argument} {self.value}".strip()
        joint = " " if remedy.startswith("(") else "; "
        return f"{place and place + ': '}{self.message}{remedy and joint + remedy}"

    def __str__(self) -> str:
        """Return the line in terms of the library."""
        return self.line(self.argument, self.remedy)


class ToldError(Exception):
    """An error of one line; ``telling`` holds its parts."""

    def __init__(
        self, message: str, argument: str = "", value: str = "", *, remedy: str = "", key: str = "", file: str = ""
    ) -> None:
        """Keep the parts of the line."""
        self.telling = Telling(message, argument, value, remedy, key, file)
        super().__init__(str(self.telling))


class ModelError(ToldError, ValueError):
    """A model file, or a part of one, that cannot be used.

    The message names the place, what was expected, what was found and the remedy, in one line.
    """


class ArgumentError(ToldError, ValueError):
    """A value of an argument that cannot be used, told in one line."""


class QuintrigError(ToldError):
    """A failure outside the model, such as a file that cannot be written, told in one line."""


class Note(str):
    """A line about a result that has a remedy; ``telling`` holds its parts."""

    __slots__ = ("telling",)

    telling: Telling

    def __new__(cls, message: str, *, remedy: str, key: str) -> "Note":
        """Return the line in terms of the library."""
        telling = Telling(message, remedy=remedy, key=key)
        note = super().__new__(cls, str(telling))
        note.telling = telling
        return note


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
