"""Formulas as forms with exact coefficients: the trees of the grammar worked out on those of ``exact_forms``."""

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from quintrig.basis.exact_forms import COSINE, POLYNOMIAL, RIGHT, SINE, Span, raised, times
from quintrig.basis.exact_numbers import PI, Exact, Surd, called, divided, fractions, plain
from quintrig.basis.formula_rational import linear
from quintrig.basis.grammar import Binary, Call, Name, Node, Number, Power, ordered
from quintrig.basis.rational import RIGHT_ANGLE, NotRationalError, TangentMap


def spans(trees: Sequence[Node], parameters: Mapping[str, float], to: TangentMap | None) -> tuple[Span, ...]:
    """Return formulas of the grammar as forms over the σ of ``to``; NotRationalError where they have none."""
    angle = to.angle if to else 0.0
    if not angle:
        unit = POLYNOMIAL
    elif to == RIGHT_ANGLE:
        unit = RIGHT
    else:
        unit = np.array([1, 2 * called("cos", _rounded(0.5 * angle)), 1], dtype=object)
    known: dict[str, Exact] = {name: fractions(np.array([value])) for name, value in parameters.items()}
    known["pi"] = np.array([PI], dtype=object)
    if unit is POLYNOMIAL:
        known |= {"t": np.array([0, 1], dtype=object), "r": np.array([1, 0], dtype=object)}
    elif unit is RIGHT:
        known |= {"s": SINE, "c": COSINE, "a": RIGHT - SINE, "b": RIGHT - COSINE}
    found: dict[Node, Exact] = {}
    for node in ordered(trees):
        if isinstance(node, Call):
            found[node] = _called(node, found[node.argument], linear(node, parameters), unit)
        else:
            found[node] = _form(node, found, known, unit)
    columns = [found[tree] for tree in trees]
    if any(not len(column) for column in columns):
        raise NotRationalError("they mix functions that have no common rational parameter")
    degree = max(map(len, columns)) - 1
    if unit is not POLYNOMIAL:
        degree += degree % 2
    stacked = np.stack([raised(column, degree, unit) for column in columns], axis=-1)
    for index, value in np.ndenumerate(stacked):
        stacked[index] = plain(value)
    return (Span(0.0, 1.0, unit if degree else None, stacked, angle),)


_ABSENT: Exact = np.zeros(0, dtype=object)


def _form(node: Node, found: Mapping[Node, Exact], known: Mapping[str, Exact], unit: Exact) -> Exact:
    if isinstance(node, Number):
        return np.array([Fraction(node.value)], dtype=object)
    if isinstance(node, Name):
        return known.get(node.name, _ABSENT)
    if isinstance(node, Power):
        result = np.array([1], dtype=object)
        for _ in range(node.exponent):
            result = times(result, found[node.base]) if len(found[node.base]) else _ABSENT
        return result
    if isinstance(node, Binary):
        return _binary(node, found[node.left], found[node.right], unit)
    return _ABSENT


def _binary(node: Binary, x: Exact, y: Exact, unit: Exact) -> Exact:
    if not (len(x) and len(y)):
        return _ABSENT
    if node.sign == "*":
        return times(x, y)
    if node.sign == "/":
        if len(y) > 1:
            raise NotRationalError("they divide by a function of t")
        return np.array([divided(value, y[0]) for value in x], dtype=object)
    y = y if node.sign == "+" else -y
    for one, other in ((x, y), (y, x)):
        if len(one) != len(other) and not any(other):  # a term that vanishes must not raise the degree
            return one
    degree = max(len(x), len(y)) - 1
    return raised(x, degree, unit) + raised(y, degree, unit)


def _called(node: Call, x: Exact, ends: tuple[float, float] | None, unit: Exact) -> Exact:
    if len(x) == 1:
        return np.array([called(node.function, x[0])], dtype=object)
    if ends is None or unit is POLYNOMIAL:
        raise NotRationalError("they hold other functions of t than sines of one angle")
    k = ends[0] or ends[1]
    if unit is RIGHT:  # q is sin(πt/4), p √2 sin(π(1-t)/4)
        size: Any = 1 if ends[1] else Surd(Fraction(0), Fraction(1, 2))
    else:
        size = called("sin", _rounded(abs(k)))
    size = size if k > 0.0 else -size
    return np.array([0, size] if ends[1] else [size, 0], dtype=object)


def _rounded(angle: float) -> Surd:
    """Return an angle that was worked out in a few rounded steps."""
    return Surd(Fraction(angle), Fraction(0), 4 * Fraction(math.ulp(angle)))
