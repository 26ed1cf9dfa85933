"""Whether no function of a basis is negative, proved over all of the range where the formulas allow it.

Formulas that are affine in each parameter are least at a corner of the range. At a corner a function of t is proved
non-negative by the Bernstein coefficients of its exact rational form, halved until all are of one sign, or else by
intervals: both to rounding, 1e-13 of the largest coefficient.
"""

import itertools
import math
from collections.abc import Mapping, Sequence

import numpy as np

from quintrig.basis.formulas import Basis
from quintrig.basis.grammar import Binary, Call, Name, Node, Number, Power, ordered
from quintrig.basis.rational import NotRationalError
from quintrig.support.arrays import FloatArray

HOW = "certified to rounding over the whole range"
_MOST_CORNERS = 64
_NOISE = 1e-13
_DEEPEST = 24  # halvings
_INTERVALS = 4096


def certified(basis: Basis) -> bool:
    """Return whether the functions are proved non-negative for all t and all of the range; False may mean unknown."""
    if 2 ** len(basis.parameters) > _MOST_CORNERS:
        return False
    if any(_degree(tree, one.name) > 1 for one in basis.parameters for tree in basis.trees):
        return False
    corners = itertools.product(*((one.low, one.high) for one in basis.parameters))
    return all(_at_corner(basis, corner) for corner in corners)


def _at_corner(basis: Basis, values: tuple[float, ...]) -> bool:
    try:
        form = basis.family(values, unchecked=True).rational()
    except (NotRationalError, ValueError):
        return _by_intervals(basis, values)
    if len(set(form.knots)) > 2 or not form.weights.min() > 0.0:
        return _by_intervals(basis, values)
    noise = _NOISE * float(np.abs(form.coefficients).max())
    return all(_not_negative(column, noise) for column in form.coefficients.T) or _by_intervals(basis, values)


def _not_negative(coefficients: FloatArray, noise: float) -> bool:
    """Return whether a polynomial in Bernstein form is not negative, by de Casteljau's halving."""
    waiting = [(coefficients, 0)]
    while waiting:
        here, depth = waiting.pop()
        if here.min() >= -noise:
            continue
        if min(here[0], here[-1]) < -noise or depth == _DEEPEST:
            return False
        left, right, rest = [here[0]], [here[-1]], here
        while len(rest) > 1:
            rest = 0.5 * (rest[:-1] + rest[1:])
            left.append(rest[0])
            right.append(rest[-1])
        waiting += [(np.array(left), depth + 1), (np.array(right[::-1]), depth + 1)]
    return True


def _degree(node: Node, name: str) -> float:  # noqa: PLR0911 — one for each kind of node
    """Return the degree of a formula in a parameter, infinite where it is no polynomial in it."""
    if isinstance(node, Number):
        return 0
    if isinstance(node, Name):
        return int(node.name == name)
    if isinstance(node, Power):
        return _degree(node.base, name) * node.exponent if node.exponent else 0
    if isinstance(node, Call):
        return 0 if _degree(node.argument, name) == 0 else math.inf
    left, right = _degree(node.left, name), _degree(node.right, name)
    if node.sign == "*":
        return left + right
    if node.sign == "/":
        return left if right == 0 else math.inf
    return max(left, right)


def _by_intervals(basis: Basis, values: tuple[float, ...]) -> bool:
    """Return whether naive intervals of t prove it: they do for sums of products that are not negative."""
    t = np.linspace(0.0, 1.0, _INTERVALS + 1)
    low, high = t[:-1], t[1:]
    quarter = 0.5 * np.pi
    known: dict[str, tuple[FloatArray, FloatArray]] = {
        "t": (low, high),
        "r": (1.0 - high, 1.0 - low),
        "s": (np.sin(quarter * low), np.sin(quarter * high)),
        "c": (np.sin(quarter * (1.0 - high)), np.sin(quarter * (1.0 - low))),
        "a": (2.0 * np.sin(0.5 * quarter * (1.0 - high)) ** 2, 2.0 * np.sin(0.5 * quarter * (1.0 - low)) ** 2),
        "b": (2.0 * np.sin(0.5 * quarter * low) ** 2, 2.0 * np.sin(0.5 * quarter * high) ** 2),
        "pi": (np.full(1, np.pi), np.full(1, np.pi)),
    }
    for one, value in zip(basis.parameters, values, strict=True):
        known[one.name] = np.full(1, value), np.full(1, value)
    found = _intervals(basis.trees, known)
    return found is not None and all(bool((found[tree][0] >= -_NOISE).all()) for tree in basis.trees)


def _intervals(
    trees: Sequence[Node], known: Mapping[str, tuple[FloatArray, FloatArray]]
) -> dict[Node, tuple[FloatArray, FloatArray]] | None:
    """Return lower and upper bounds of every node; None where one is a call, or divides by an interval around zero."""
    found: dict[Node, tuple[FloatArray, FloatArray]] = {}
    for node in ordered(trees):
        if isinstance(node, Number):
            found[node] = np.full(1, node.value), np.full(1, node.value)
        elif isinstance(node, Name):
            found[node] = known[node.name]
        elif isinstance(node, Call):
            return None
        elif isinstance(node, Power):
            low, high = found[node.base]
            ends = np.stack(np.broadcast_arrays(low**node.exponent, high**node.exponent))
            least = np.where((low < 0.0) & (high > 0.0) & (node.exponent % 2 == 0), 0.0, ends.min(axis=0))
            found[node] = least, ends.max(axis=0)
        else:
            sides = _joined(node, found[node.left], found[node.right])
            if sides is None:
                return None
            found[node] = sides
    return found


def _joined(
    node: Binary, left: tuple[FloatArray, FloatArray], right: tuple[FloatArray, FloatArray]
) -> tuple[FloatArray, FloatArray] | None:
    if node.sign == "+":
        return left[0] + right[0], left[1] + right[1]
    if node.sign == "-":
        return left[0] - right[1], left[1] - right[0]
    if node.sign == "/":
        if ((right[0] <= 0.0) & (right[1] >= 0.0)).any():
            return None
        right = 1.0 / right[1], 1.0 / right[0]
    products = np.stack(np.broadcast_arrays(*(x * y for x in left for y in right)))
    return products.min(axis=0), products.max(axis=0)
