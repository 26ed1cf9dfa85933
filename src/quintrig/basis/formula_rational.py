"""Exact rational forms of formulas: the same trees, worked out on Bernstein coefficients instead of series.

Functions of t alone are polynomials. Functions of s, c, a, b (and sin(kt), sin(kr) with k = π/4) are forms of even
degree in p = sin(γr), q = sin(γt), γ = π/4; others of sin(kt) and sin(kr) likewise, with γ = k. The constant 1 is
[1, cos γ, 1] / sin² γ there (Sánchez-Reyes 1998).
"""

import math
from collections.abc import Mapping, Sequence

import numpy as np

from quintrig.basis.expression import called
from quintrig.basis.grammar import Binary, Call, Name, Node, Number, Power, names, ordered
from quintrig.basis.rational import RIGHT_ANGLE, NotRationalError, TangentMap, bernstein_product
from quintrig.support.arrays import FloatArray

Form = FloatArray
"""Bernstein coefficients (degree + 1,): one for a constant, none for what has no form in this parameter."""

_ABSENT: Form = np.zeros(0)


def tangent_map(trees: Sequence[Node], parameters: Mapping[str, float]) -> TangentMap | None:
    """Return the identity for polynomials, the map of the angle for trigonometric forms, None for constants.

    Raises NotRationalError where the functions ask for several.
    """
    used = {name for tree in trees for name in names(tree)}
    rates = _rates(trees, parameters)
    found = {RIGHT_ANGLE if math.isclose(k, 0.25 * math.pi, rel_tol=1e-14) else TangentMap(2.0 * k) for k in rates}
    found |= {RIGHT_ANGLE} if used & {"s", "c", "a", "b"} else set()
    found |= {TangentMap()} if used & {"t", "r"} and not rates else set()
    if len(found) > 1:
        raise NotRationalError("they mix functions that have no common rational parameter")
    return next(iter(found), None)


def forms(trees: Sequence[Node], parameters: Mapping[str, float], to: TangentMap) -> list[Form]:
    """Return the trees as forms in the parameter of ``to``; NotRationalError for those that are none."""
    result = _forms(trees, parameters, to)
    if not all(len(form) and (len(form) - 1) % (len(_unit(to)) - 1) == 0 for form in result):
        raise NotRationalError("they mix functions that have no common rational parameter")
    return result


def numerators(trees: Sequence[Node], parameters: Mapping[str, float], to: TangentMap, degree: int) -> FloatArray:
    """Return the coefficients (degree + 1, len(trees)) of the numerators over the common weights of ``to``."""
    unit = _unit(to)
    columns = [_raised(form, degree, unit) for form in forms(trees, parameters, to)]
    return np.stack(columns, axis=-1) * (math.sin(0.5 * to.angle) ** degree if to.angle else 1.0)


def _unit(to: TangentMap) -> Form:
    """Return the constant 1 in the lowest degree."""
    if not to.angle:
        return np.ones(2)
    middle = math.sqrt(0.5) if to == RIGHT_ANGLE else math.cos(0.5 * to.angle)
    return np.array([1.0, middle, 1.0]) / math.sin(0.5 * to.angle) ** 2


def _rates(trees: Sequence[Node], parameters: Mapping[str, float]) -> set[float]:
    """Return the k of all sin(kt) and sin(kr)."""
    moving = [node for node in ordered(trees) if isinstance(node, Call) and set(names(node)) & {"t", "r"}]
    ends = [linear(node, parameters) for node in moving]
    return {abs(end[0] or end[1]) for end in ends if end}


def linear(node: Call, parameters: Mapping[str, float]) -> tuple[float, float] | None:
    """Return the argument's values at t = 0 and 1 where the call is sin(kt) or sin(kr), |k| < π/2, else None."""
    try:
        form = _forms([node.argument], parameters, TangentMap())[0]
    except NotRationalError:
        return None
    if node.function != "sin" or len(form) != 2 or form.all() or not 0.0 < abs(form.sum()) < 0.5 * math.pi:
        return None
    return float(form[0]), float(form[1])


def _forms(trees: Sequence[Node], parameters: Mapping[str, float], to: TangentMap) -> list[Form]:
    known = _names(to) | {"pi": np.array([math.pi])} | {one: np.array([value]) for one, value in parameters.items()}
    unit, found = _unit(to), dict[Node, Form]()
    for node in ordered(trees):
        if isinstance(node, Number):
            found[node] = np.array([node.value])
        elif isinstance(node, Name):
            found[node] = known.get(node.name, _ABSENT)
        elif isinstance(node, Power):
            found[node] = _power(found[node.base], node.exponent)
        elif isinstance(node, Call):
            found[node] = _called(node, found[node.argument], parameters)
        else:
            found[node] = _binary(node, found[node.left], found[node.right], unit)
    return [found[tree] for tree in trees]


def _names(to: TangentMap) -> dict[str, Form]:
    if not to.angle:
        return {"t": np.array([0.0, 1.0]), "r": np.array([1.0, 0.0])}
    if to != RIGHT_ANGLE:
        return {}
    rising, one = np.array([0.0, math.sqrt(2.0), 2.0]), np.array([2.0, 0.0, 0.0])
    return {"s": rising, "c": rising[::-1], "a": one, "b": one[::-1]}


def _binary(node: Binary, x: Form, y: Form, unit: Form) -> Form:
    if not (len(x) and len(y)):
        return _ABSENT
    if node.sign == "*":
        return bernstein_product(x, y)
    if node.sign == "/":
        if len(y) > 1:
            raise NotRationalError("they divide by a function of t")
        return x / y
    y = y if node.sign == "+" else -y
    if len(x) != len(y) and not (x.any() and y.any()):
        return x if x.any() else y  # a term that vanishes must not raise the degree
    if (len(x) - len(y)) % (len(unit) - 1):
        raise NotRationalError("they add even and odd forms in the half angle")
    degree = max(len(x), len(y)) - 1
    return _raised(x, degree, unit) + _raised(y, degree, unit)


def _called(node: Call, x: Form, parameters: Mapping[str, float]) -> Form:
    if len(x) == 1:
        return called(node.function, x)
    ends = linear(node, parameters)
    if ends is None:
        raise NotRationalError("they hold other functions of t than sines of one angle")
    return np.sign(ends)


def _power(x: Form, exponent: int) -> Form:
    result: Form = np.ones(1)
    for _ in range(exponent if len(x) else 0):
        result = bernstein_product(result, x)
    return result if len(x) else x


def _raised(form: Form, degree: int, unit: Form) -> Form:
    while len(form) <= degree:
        form = bernstein_product(form, unit)
    return form
