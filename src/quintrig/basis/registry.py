"""The bases that constructions, curves and model files take: by name, as a family, or as a pair for u and v."""

from collections.abc import Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType
from typing import Any, cast

from quintrig.basis.formulas import Basis, Parameter
from quintrig.basis.functions import Functions
from quintrig.basis.library import LIBRARY, Entry, of_basis
from quintrig.support.errors import nearest
from quintrig.support.plugins import with_plugins

GROUP = "quintrig.bases"
"""Entry points of this group add bases: an ``Entry``, a ``Basis``, or a table as in a model file."""

DEFAULT = "trigonometric"

_OWN = {one.name: one for one in LIBRARY}

Choice = str | Entry | Functions
"""One basis: a name, an entry, or a family at values of its own."""


@lru_cache(maxsize=1)
def bases() -> Mapping[str, Entry]:
    """Return all bases by name: those of the library, then those of installed packages."""
    return MappingProxyType(with_plugins(GROUP, _OWN, _accepted))


def entry(name: str, own: Mapping[str, Entry] | None = None) -> Entry:
    """Return a basis by name, of a model's ``own`` or of all; ValueError with the nearest known name."""
    if name == DEFAULT and not own:  # without a look at what is installed
        return _OWN[name]
    known = {**bases(), **(own or {})}
    if name not in known:
        raise ValueError(f"basis: expected one of {', '.join(known)}, found {name!r}{nearest(name, known)}")
    return known[name]


def family(choice: Choice, points: int, values: Sequence[float] = (), unchecked: bool = False) -> Functions:
    """Return the functions of a basis for so many control points; ValueError where they do not fit.

    ``values`` are those of the shape parameters; without any they start where the basis says.
    """
    if isinstance(choice, (str, Entry)):
        found = entry(choice) if isinstance(choice, str) else choice
        try:
            return found.family(points, values, unchecked)
        except ValueError as error:
            raise ValueError(f"points: {error}" if str(error).startswith("expected") else str(error)) from None
    if choice.size != points:
        raise ValueError(f"points: expected {choice.size} control points, one for each function, found {points}")
    return choice


def own_basis(name: str, table: object) -> Basis:
    """Return a basis from a table with ``functions``, and what else it has of ``_KEYS``; ValueError."""
    if name in _OWN:
        raise ValueError(f"{name!r} is the name of a basis that quintrig brings; choose another name")
    if not name.isidentifier() or not name.isascii() or len(name) > 60:
        raise ValueError(f"expected a name of letters, digits and _, found {name[:60]!r}")
    keys = _table(table, "expected a table with functions = [...] and parameters = {...}")
    unknown = next((key for key in keys if key not in _KEYS), None)
    if unknown is not None:
        raise ValueError(f"unknown key {unknown!r}{nearest(unknown, _KEYS)}; the keys are {', '.join(_KEYS)}")
    functions = _list(keys.get("functions"), 'functions: expected a list of formulas, such as ["1-t", "t"]')
    ranges = _table(keys.get("parameters", {}), "parameters: expected a table such as { lam = [-1, 1] }")
    source = keys.get("source", "")
    if not isinstance(source, str) or len(source) > 400:
        raise ValueError(f"source: expected a text of at most 400 letters, found {_found(source)}")
    parameters: list[Parameter] = []
    for one, ends in ranges.items():
        expected = f"parameters.{one[:40]}: expected its range [low, high], such as [-1, 1]"
        pair = _list(ends, expected)
        if len(pair) not in (2, 3):  # the third is where it starts
            raise ValueError(f"{expected}, found {_found(ends)}")
        parameters.append(Parameter(one, *pair))
    claims = _list(keys.get("claims", []), 'claims: expected a list of formulas, such as ["z\'(0) = 3*(P1 - P0)"]')
    if len(claims) > _MOST_CLAIMS or not all(isinstance(one, str) for one in claims):
        raise ValueError(f"claims: expected at most {_MOST_CLAIMS} texts, found {_found(claims)}")
    return Basis(name, tuple(functions), tuple(parameters), source, tuple(claims))


_KEYS = ("functions", "parameters", "source", "claims")
_MOST_CLAIMS = 64


def _table(value: object, expected: str) -> dict[str, Any]:
    if not isinstance(value, Mapping):
        raise ValueError(f"{expected}, found {_found(value)}")  # noqa: TRY004 — a mistake in a file, told as one
    return {str(key): one for key, one in cast(Mapping[Any, Any], value).items()}


def _list(value: object, expected: str) -> list[Any]:
    if not isinstance(value, (list, tuple)):
        raise ValueError(f"{expected}, found {_found(value)}")  # noqa: TRY004 — a mistake in a file, told as one
    return list(cast(Sequence[Any], value))


def _found(value: object) -> str:
    return "none" if value is None else repr(value)[:60]


def _accepted(name: str, thing: Any) -> Entry:
    """Return what an entry point stands for; ValueError where it is no basis."""
    if isinstance(thing, Entry):
        if thing.name != name:
            raise ValueError(f"expected a basis called {name!r}, found {thing.name!r}")
        thing.basis()
        return thing
    if isinstance(thing, Basis):
        return of_basis(Basis(name, thing.functions, thing.parameters, thing.source))
    if isinstance(thing, Mapping):
        return of_basis(own_basis(name, cast(object, thing)))
    raise ValueError(f"expected an Entry, a Basis or a table of formulas, found {type(thing).__name__}")
