"""The bases of a surface, one for each direction: how many points each takes, and the shape parameters of all."""

from collections.abc import Sequence

from quintrig.basis.formulas import Parameter
from quintrig.basis.functions import Functions
from quintrig.basis.library import Entry
from quintrig.basis.registry import Choice, bases, entry, family
from quintrig.support.arrays import frozen

Bases = Choice | Sequence[Choice]
"""One basis for both directions, or a pair for u and v."""


def pair(basis: Bases) -> tuple[Choice, Choice]:
    """Return the bases in u and v; ValueError for anything but one or two."""
    if isinstance(basis, Sequence) and not isinstance(basis, str):
        if len(basis) != 2:
            raise ValueError(f"basis: expected one basis, or two for u and v, found {len(basis)}")
        first, second = basis
    else:
        first = second = basis
    return _known(first), _known(second)


def parameters(choice: Choice, points: int | None = None) -> tuple[Parameter, ...]:
    """Return the shape parameters that a basis asks for; none where it is a family at values of its own."""
    return choice.basis(points).parameters if isinstance(choice, Entry) else ()


def names(choices: Sequence[Choice], counts: Sequence[int | None]) -> tuple[str, ...]:
    """Return the names of all shape parameters, numbered by the basis where there are two."""
    several = len(choices) > 1
    return tuple(
        _numbered(one.name, i) if several else one.name
        for i, (choice, points) in enumerate(zip(choices, counts, strict=True), 1)
        for one in parameters(choice, points)
    )


_LOWERED = {0x2080 + digit: str(digit) for digit in range(10)}

GREEK = {
    **{"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "zeta": "ζ", "theta": "θ", "kappa": "κ", "lam": "λ"},
    **{"lambda": "λ", "mu": "μ", "nu": "ν", "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ", "omega": "ω"},
}
"""Letters of parameters that are spelt out."""


def key_of(name: str) -> str:
    """Return the name of a shape parameter that is given as one reads it, such as ``alpha1`` for α1 and α₁."""
    plain = name.translate(_LOWERED)
    letters = plain.rstrip("0123456789_")
    return {letter: key for key, letter in GREEK.items()}.get(letters, letters) + plain[len(letters) :]


def symbol(name: str) -> str:
    """Return the name of a shape parameter to be read, such as α1 for ``alpha1``."""
    letters = name.rstrip("0123456789_")
    return GREEK.get(letters, letters) + name[len(letters) :].replace("_", ",")


def families(
    choices: Sequence[Choice],
    counts: Sequence[int],
    places: Sequence[str],
    shape: Sequence[float] | None,
    unchecked: bool,
) -> tuple[Functions, ...]:
    """Return the functions of each basis for so many points, with the values of all shape parameters one by one.

    Without a ``shape``, or with an empty one, all start where their basis says. Raises ValueError, naming the place,
    where the number of points, of values or a value does not fit.
    """
    for choice, points, place in zip(choices, counts, places, strict=True):
        check_count(choice, points, place)
    asked = [parameters(choice, points) for choice, points in zip(choices, counts, strict=True)]
    values = _values(choices, counts, asked, shape, unchecked)
    return tuple(
        family(choice, points, own, unchecked) for choice, points, own in zip(choices, counts, values, strict=True)
    )


def check_count(choice: Choice, points: int, place: str) -> None:
    """Raise ValueError, naming the ``place``, where a basis has no functions for so many control points."""
    if isinstance(choice, Entry):
        if points not in choice.sizes:
            counts = choice.counts.replace("points", "planes") if place == "planes" else choice.counts
            raise ValueError(f"{place}: expected {counts} for the {choice.name} basis, found {points}")
    elif not isinstance(choice, str) and choice.size != points:
        raise ValueError(f"{place}: expected {choice.size} control points, one for each function, found {points}")


def _known(choice: Choice) -> Choice:
    if isinstance(choice, str):
        return entry(choice)
    if isinstance(choice, Entry) or hasattr(choice, "derivatives"):
        return choice
    raise ValueError(f"basis: expected a name, one of {', '.join(bases())}, or a family of functions, found {choice!r}")


def _values(
    choices: Sequence[Choice],
    counts: Sequence[int],
    asked: Sequence[tuple[Parameter, ...]],
    shape: Sequence[float] | None,
    unchecked: bool,
) -> list[tuple[float, ...]]:
    total = sum(map(len, asked))
    found: list[float] = [] if shape is None else frozen(shape, "shape", (None,)).tolist()
    if not found:
        return [()] * len(choices)
    if not total and all(isinstance(one, Entry) and one.classical for one in choices):
        if len(found) not in (0, 2 * len(choices)):  # as many as the quintic basis has, so that models can change over
            raise ValueError(
                f"shape: expected none or {2 * len(choices)} numbers, which do not act in the bernstein basis, "
                f"found {len(found)}"
            )
        return [()] * len(choices)
    labels = names(choices, counts)
    if len(found) != total:
        told = f" ({', '.join(labels)})" if labels else ", as the basis has no shape parameters"
        raise ValueError(f"shape: expected {total} numbers{told}, found {len(found)}")
    result: list[tuple[float, ...]] = []
    start = 0
    for own in asked:
        places = [f"shape[{i}] ({labels[i]})" for i in range(start, start + len(own))]
        triples = zip(own, found[start : start + len(own)], places, strict=True)
        result.append(tuple(one.value(value, place, unchecked) for one, value, place in triples))
        start += len(own)
    return result


def _numbered(name: str, number: int) -> str:
    return f"{name}_{number}" if name[-1].isdigit() else f"{name}{number}"
