"""Taylor arithmetic on the trees of ``grammar``: derivatives of any order at once, none formed by cancellation."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.basis.grammar import Binary, Name, Node, Number, Power, ordered
from quintrig.basis.trigonometric import sines
from quintrig.support import taylor
from quintrig.support.arrays import FloatArray

Series = FloatArray
"""Coefficients (order + 1, ...) of a series, or a single number (): a constant."""


def series(trees: Sequence[Node], t: FloatArray, order: int, values: Mapping[str, FloatArray]) -> FloatArray:
    """Return the Taylor series of trees at t, shape (order + 1, *t.shape, len(trees)).

    ``values`` are those of the parameters, each of a shape that broadcasts with t. What divides by zero or leaves the
    real numbers gives inf or NaN.
    """
    found = node_series(ordered(trees), t, order, values)
    shape = (order + 1, *np.broadcast_shapes(t.shape, *(np.shape(value) for value in values.values())))
    like: FloatArray = np.zeros(shape)
    columns = [found[tree] if found[tree].ndim else taylor.constant(float(found[tree]), like) for tree in trees]
    return np.stack([np.broadcast_to(column, shape) for column in columns], axis=-1)


def node_series(
    nodes: Sequence[Node], t: FloatArray, order: int, values: Mapping[str, FloatArray]
) -> dict[Node, Series]:
    """Return the series of every node, each after those that it is made of; numbers without t stay numbers."""
    names: dict[str, Any] = _variables(t, order) | {"pi": np.float64(np.pi)}
    for name, value in values.items():
        one = np.asarray(value, dtype=np.float64)
        names[name] = one if not one.ndim else np.concatenate([one[None], np.zeros((order, *one.shape))])
    found: dict[Node, Any] = {}
    with np.errstate(all="ignore"):
        for node in nodes:
            found[node] = _value(node, found, names)
    return found


def _variables(t: FloatArray, order: int) -> dict[str, Any]:
    x: FloatArray = np.zeros((order + 1, *t.shape))
    x[0], x[1:2] = t, 1.0
    rest = -x
    rest[0] = 1.0 - t
    s, c, a, b = sines(t, order)
    return {"t": x, "r": rest, "s": s, "c": c, "a": a, "b": b}


def _value(node: Node, found: Mapping[Node, Series], names: Mapping[str, Series]) -> Any:
    if isinstance(node, Number):
        return np.float64(node.value)
    if isinstance(node, Name):
        return names[node.name]
    if isinstance(node, Power):
        return _power(found[node.base], node.exponent)
    if isinstance(node, Binary):
        return _OPERATIONS[node.sign](found[node.left], found[node.right])
    return called(node.function, found[node.argument])


def called(function: str, x: Series) -> Any:
    """Return the series of a function of ``grammar.Call`` at a series."""
    return _FUNCTIONS[function](x) if x.ndim else _FUNCTIONS[function](x[None])[0]


_FUNCTIONS: dict[str, Callable[[FloatArray], FloatArray]] = {
    "sqrt": taylor.root,
    "exp": taylor.exponential,
    "sin": lambda x: taylor.waves(x).sine,
    "cos": lambda x: taylor.waves(x).cosine,
    "versin": lambda x: taylor.waves(x).versine,
    "sinrest": taylor.rest,
    "sinh": lambda x: taylor.waves(x, hyperbolic=True).sine,
    "cosh": lambda x: taylor.waves(x, hyperbolic=True).cosine,
    "coshless": lambda x: taylor.waves(x, hyperbolic=True).versine,
    "sinhrest": lambda x: taylor.rest(x, hyperbolic=True),
}


def _power(x: Series, exponent: int) -> Any:
    if not x.ndim:
        return x**exponent
    result, square = None, x
    while exponent:
        if exponent & 1:
            result = square if result is None else taylor.product(result, square)
        exponent >>= 1
        square = taylor.product(square, square) if exponent else square
    return np.float64(1.0) if result is None else result


def _added(x: Series, y: Series) -> Any:
    if (x.ndim > 0) == (y.ndim > 0):
        return x + y
    moved, constant = (x, y) if x.ndim else (y, x)
    result = moved.copy()
    result[0] += constant
    return result


def _times(x: Series, y: Series) -> Any:
    return taylor.product(x, y) if x.ndim and y.ndim else x * y


def _divided(x: Series, y: Series) -> Any:
    if not y.ndim:
        return x / y
    return taylor.quotient(x if x.ndim else taylor.constant(float(x), y), y)


def _less(x: Series, y: Series) -> Any:
    return _added(x, -y)


_OPERATIONS = {"+": _added, "-": _less, "*": _times, "/": _divided}


def values_of(numbers: Mapping[str, float]) -> dict[str, NDArray[Any]]:
    """Return parameters as constants."""
    return {name: np.asarray(value, dtype=np.float64) for name, value in numbers.items()}
