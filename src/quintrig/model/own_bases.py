"""Bases of a model's own: ``[bases.NAME]`` tables, or a file of ``[basis.NAME]`` tables beside the model."""

import json
from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType
from typing import Any, cast

from quintrig.basis.formulas import Basis
from quintrig.basis.library import Entry, of_basis
from quintrig.basis.registry import own_basis
from quintrig.support.errors import nearest

MOST_BASES = 64
"""Most bases in one file."""

Tables = Mapping[str, Any]
"""Bases by name, each a table with ``functions``, ``parameters`` and ``source``."""


def own_bases(tables: Tables) -> Mapping[str, Entry]:
    """Return the bases of a model by name; ValueError naming the basis, the formula and the character."""
    return _parsed(json.dumps(dict(tables), default=str)) if tables else MappingProxyType({})


def tables_of(data: Mapping[str, Any], place: str = "basis") -> dict[str, Any]:
    """Return the tables of a file of bases, the keys of which are ``data``; ValueError where it holds none."""
    keys = dict(data)
    tables = keys.pop(place, None)
    if not isinstance(tables, Mapping) or not tables:
        hint = nearest(place, keys) if keys else ""
        raise ValueError(f"expected [{place}.NAME] tables with functions = [...], found none{hint}")
    unknown = next((key for key in keys if key != "schema"), None)
    if unknown is not None:
        raise ValueError(f"unknown key {unknown!r} beside the [{place}.NAME] tables; take it out")
    return {str(name): table for name, table in cast(Mapping[Any, Any], tables).items()}


def table_of(basis: Basis) -> dict[str, Any]:
    """Return the table that gives a basis back."""
    ranges = {one.name: [one.low, one.high, one.start] for one in basis.parameters}
    parts = {"functions": list(basis.functions), "parameters": ranges, "source": basis.source}
    parts |= {"claims": list(basis.claims)}
    return {key: part for key, part in parts.items() if part}


@lru_cache(maxsize=64)
def _parsed(text: str) -> Mapping[str, Entry]:
    tables: dict[str, Any] = json.loads(text)
    if len(tables) > MOST_BASES:
        raise ValueError(f"bases: expected at most {MOST_BASES} bases, found {len(tables)}")
    result: dict[str, Entry] = {}
    for name, table in tables.items():
        try:
            result[name] = of_basis(own_basis(name, table))
        except ValueError as error:
            raise ValueError(f"bases.{name[:60]}: {error}") from None
    return MappingProxyType(result)
