"""Bases as the browser takes them: their formulas, for each number of control points, and the ranges of parameters."""

from collections.abc import Iterable
from typing import Any

from quintrig.basis.formulas import Basis
from quintrig.basis.library import LIBRARY, Entry
from quintrig.basis.registry import _KEYS, bases  # pyright: ignore[reportPrivateUsage] — the browser reads tables too
from quintrig.model.model import Model

MOST_POINTS = 16
"""Control points up to which the bundle holds formulas: those for more come with a model that needs them."""

KEYS = _KEYS
"""Keys of the table of a basis."""

_BY_NAME = {one.name: one for one in LIBRARY}


def library() -> list[dict[str, Any]]:
    """Return the bases that the bundle holds."""
    return [_told(one, (n for n in one.sizes if n <= MOST_POINTS)) for one in LIBRARY]


def installed_bases() -> list[dict[str, Any]]:
    """Return the bases that installed packages bring."""
    brought = [one for name, one in bases().items() if name not in _BY_NAME]
    return [_told(one, (n for n in one.sizes if n <= MOST_POINTS)) for one in brought]


def beyond(model: Model) -> list[dict[str, Any]]:
    """Return the bases of a model that the bundle does not hold: of installed packages, or for very many points."""
    wanted: dict[str, tuple[Entry, set[int]]] = {}
    for part in (*model.patches, *model.curves):
        pairs = zip(getattr(part.definition, "choices", ()), part.definition.point_counts, strict=False)
        own = getattr(part.definition, "bases", {})
        for one, points in pairs:
            held = _BY_NAME.get(one.name) is one and points <= MOST_POINTS
            if not held and one.name not in own and not one.classical:
                wanted.setdefault(one.name, (one, set()))[1].add(points)
    return [_told(one, sorted(counts)) for one, counts in wanted.values()]


def _told(one: Entry, counts: Iterable[int]) -> dict[str, Any]:
    formulas = {} if one.classical else {str(n): _formulas(one.basis(n)) for n in counts}  # the browser writes those
    return {
        "name": one.name,
        "title": one.title,
        "counts": one.counts,
        "sizes": list(one.sizes),
        "usual": one.usual,
        "formulas": formulas,
    }


def _formulas(basis: Basis) -> dict[str, Any]:
    ranges = [[one.name, one.low, one.high, one.start, *one.open] for one in basis.parameters]
    return {"functions": list(basis.functions), "parameters": ranges}
