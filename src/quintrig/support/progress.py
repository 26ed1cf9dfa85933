"""How long work tells how far it is."""

from collections.abc import Callable

Progress = Callable[[str, int, int], None]
"""Called with what is being done, steps done and steps in all."""

Counted = Callable[[int, int], None]
"""Called with how much is done and how much there is in all: rows of a grid, or designs of a sweep."""
