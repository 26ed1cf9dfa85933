"""End derivatives of a basis as formulas in its parameters, and what a paper claims of them."""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from quintrig.analysis.basis_samples import Finding, Samples
from quintrig.basis.expression import series
from quintrig.basis.formulas import Basis
from quintrig.basis.grammar import VARIABLES, Call, Name, Node, Number, Power, names, ordered, parse
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import need

HIGHEST = 3
"""Order of the derivatives that are given as formulas."""

_MOST = 16  # functions of a basis that gets formulas
_CLAIM = re.compile(r"\s*(?:[A-Za-z]\w*)?\s*(?P<primes>['’′″‴]*)\s*\(\s*(?P<end>[01])\s*\)\s*=(?P<formula>.+)", re.S)
_PRIMES = {"'": 1, "’": 1, "′": 1, "″": 2, "‴": 3}


@dataclass(frozen=True)
class Claim:
    """What a paper says of an end derivative, whether it is so, by how much it is missed at worst and where.

    ``finding.worst`` is relative to the largest coefficient over the range; ``point`` is the control point that it is
    missed for, and ``right`` the formula that holds, empty where SymPy is not installed.
    """

    text: str
    finding: Finding
    point: str
    right: str


def claim_words(claim: Claim) -> str:
    """Return where a claim fails, by how much, and what holds instead."""
    at = ", ".join(f"{name} = {value:.4g}" for name, value in claim.finding.at.items() if name not in ("t", "i"))
    off = f"off by {claim.finding.worst:.3g} of the largest coefficient for {claim.point}{f' at {at}' if at else ''}"
    return f"{off}; it is {claim.right}" if claim.right else off


def end_formulas(basis: Basis) -> dict[str, list[list[str]]] | None:
    """Return, for t = 0 and 1, formulas of the coefficients of derivatives 0 to 3 on each control point.

    They are written in the grammar of bases. None without SymPy (extra ``formulas``), and for more than 16 functions.
    """
    if basis.size > _MOST:
        return None
    try:
        sympy = need("sympy", "formulas of end derivatives")
    except QuintrigError:
        return None
    return {str(end): _at_end(sympy, basis, end) for end in (0, 1)}


def derivative_words(coefficients: Sequence[str]) -> str:
    """Return the sum of coefficients times control points, such as ``-2*pi*P0 + 2*pi*P1``."""
    parts: list[str] = []
    for i, one in enumerate(coefficients):
        if one == "0":
            continue
        whole = re.fullmatch(r"-?[^\s+-]+|-?\([^()]*\)", one) is not None
        term = f"P{i}" if one == "1" else f"-P{i}" if one == "-1" else f"{one if whole else _product(one)}*P{i}"
        parts.append(f"- {term[1:]}" if term.startswith("-") and parts else f"+ {term}" if parts else term)
    return " ".join(parts) or "0"


def _product(text: str) -> str:
    """Return a formula that may be multiplied as it stands: a sum in parentheses."""
    depth = 0
    for place, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if depth == 0 and letter in "+-" and place:
            return f"({text})"
    return text


def check_claim(basis: Basis, text: str, formulas: dict[str, list[list[str]]] | None = None) -> Claim:
    """Return whether a claim such as ``z''(0) = pi^2*(3*P2 - 2*P1)*(3 + alpha) + P0*(3 + 2*alpha)`` holds.

    The right side is a formula in the parameters of the basis and the control points P0, P1, ... ValueError for text
    that is no such claim.
    """
    match = _CLAIM.fullmatch(text.strip())
    order = sum(_PRIMES[one] for one in match["primes"]) if match else 0
    if match is None or order > HIGHEST:
        raise ValueError(f"claim: expected such as \"z''(0) = ...\" with up to 3 primes, found {text[:60]!r}")
    end = int(match["end"])
    samples, time = Samples(basis), np.array([float(match["end"])])
    told = _coefficients(basis, samples, match["formula"])
    true = samples.derivatives(samples.values, time, order)[order, :, 0]
    finding = compared(basis, samples, told, true, end)
    right = "" if formulas is None else derivative_words(formulas[str(end)][order])
    return Claim(" ".join(text.split()), finding, f"P{int(finding.at['i'])}", right)


def compared(basis: Basis, samples: Samples, told: FloatArray, true: FloatArray, end: int) -> Finding:
    """Return by how much told coefficients (samples, size) miss the true ones, and where."""
    off = np.abs(told - true) / max(float(np.abs(true).max()), 1e-300)
    row, point = np.unravel_index(int(off.argmax()), off.shape)
    worst = float(off[row, point])
    return Finding(worst <= 1e-11, worst, {"t": float(end), "i": float(point)} | samples.named(int(row)))


def _coefficients(basis: Basis, samples: Samples, formula: str) -> FloatArray:
    """Return the coefficients (samples, size) of a formula that is linear in the control points."""
    points = [f"P{i}" for i in range(basis.size)]
    tree = parse(formula, [*(one.name for one in basis.parameters), *points])
    wrong = next((name for name in names(tree) if name in VARIABLES), None)
    if wrong is not None:
        raise ValueError(
            f"claim: expected a formula in the parameters and {points[0]} to {points[-1]}, found {wrong!r}"
        )
    given = {one.name: samples.values[:, i] for i, one in enumerate(basis.parameters)}

    def at(place: FloatArray) -> FloatArray:
        values = {name: np.full(len(samples.values), x) for name, x in zip(points, place.tolist(), strict=True)}
        found = series([tree], np.zeros(len(samples.values)), 0, given | values)[0, ..., 0]
        return np.broadcast_to(found, (len(samples.values),))

    still = at(np.zeros(basis.size))
    columns = np.stack([at(unit) - still for unit in np.eye(basis.size)], axis=-1)
    some = 0.3 + np.cos(np.arange(basis.size, dtype=np.float64))
    size = np.maximum(np.abs(columns).max(axis=-1), 1.0)
    if (np.abs(still) > 1e-12 * size).any() or (np.abs(at(some) - columns @ some) > 1e-9 * size).any():
        raise ValueError("claim: expected a sum of control points times coefficients, found another formula of them")
    return columns


def _at_end(sympy: Any, basis: Basis, end: int) -> list[list[str]]:
    """Return the formulas at one end: Taylor coefficients by truncated series of exact expressions."""
    count = HIGHEST + 1
    pi = sympy.pi
    angle = [pi / 2 * end, pi / 2, *[sympy.Integer(0)] * (count - 2)]
    sine, cosine = _called(sympy, "sin", angle), _called(sympy, "cos", angle)
    time = [sympy.Integer(end), sympy.Integer(1), *[sympy.Integer(0)] * (count - 2)]
    one = [sympy.Integer(1), *[sympy.Integer(0)] * (count - 1)]
    known: dict[str, list[Any]] = {
        "t": time,
        "r": _sum(one, time, -1),
        "s": sine,
        "c": cosine,
        "a": _sum(one, sine, -1),
        "b": _sum(one, cosine, -1),
        "pi": [pi, *[sympy.Integer(0)] * (count - 1)],
    }
    for parameter in basis.parameters:
        known[parameter.name] = [sympy.Symbol(parameter.name, real=True), *[sympy.Integer(0)] * (count - 1)]
    found: dict[Node, list[Any]] = {}
    for node in ordered(basis.trees):
        found[node] = _node(sympy, node, found, known)
    return [
        [_written(sympy, found[tree][order] * math.factorial(order)) for tree in basis.trees] for order in range(count)
    ]


def _written(sympy: Any, value: Any) -> str:
    """Return an expression in the grammar of bases, factored where that is quick."""
    value = sympy.sympify(value)
    if not value.has(sympy.sin, sympy.cos, sympy.sinh, sympy.cosh, sympy.exp, sympy.sqrt):
        value = sympy.factor(sympy.expand(value))
    elif abs(float(value.subs({one: 0.3 + 0.11 * i for i, one in enumerate(value.free_symbols)}))) < 1e-9:
        value = sympy.Integer(0)
    else:
        value = sympy.factor_terms(sympy.together(value))  # simplify takes minutes on hyperbolic functions
    return str(value).replace("**", "^")


def _node(sympy: Any, node: Node, found: dict[Node, list[Any]], known: dict[str, list[Any]]) -> list[Any]:
    zero = sympy.Integer(0)
    if isinstance(node, Number):
        return [sympy.Rational(repr(node.value)), *[zero] * HIGHEST]
    if isinstance(node, Name):
        return known[node.name]
    if isinstance(node, Power):
        result = [sympy.Integer(1), *[zero] * HIGHEST]
        for _ in range(node.exponent):
            result = _times(sympy, result, found[node.base])
        return result
    if isinstance(node, Call):
        return _called(sympy, node.function, found[node.argument])
    left, right = found[node.left], found[node.right]
    if node.sign in "+-":
        return _sum(left, right, 1 if node.sign == "+" else -1)
    return _times(sympy, left, right if node.sign == "*" else _inverse(sympy, right))


def _sum(left: list[Any], right: list[Any], sign: int) -> list[Any]:
    return [x + sign * y for x, y in zip(left, right, strict=True)]


def _times(sympy: Any, left: list[Any], right: list[Any]) -> list[Any]:
    products = ([left[j] * right[k - j] for j in range(k + 1)] for k in range(len(left)))
    return [sum(one, sympy.Integer(0)) for one in products]


def _inverse(sympy: Any, x: list[Any]) -> list[Any]:
    result = [1 / x[0]]
    for k in range(1, len(x)):
        result.append(-sum(x[j] * result[k - j] for j in range(1, k + 1)) / x[0])
    return result


def _called(sympy: Any, function: str, x: list[Any]) -> list[Any]:
    """Return the series of a function of a series: Taylor's formula about its first term."""
    u = sympy.Dummy()
    rest = {
        "versin": 1 - sympy.cos(u),
        "coshless": sympy.cosh(u) - 1,
        "sinrest": u - sympy.sin(u),
        "sinhrest": sympy.sinh(u) - u,
    }
    outer = rest[function] if function in rest else getattr(sympy, function)(u)
    inner = [sympy.Integer(0), *x[1:]]
    result = [sympy.Integer(0)] * len(x)
    power = [sympy.Integer(1), *[sympy.Integer(0)] * HIGHEST]
    for order in range(len(x)):
        factor = sympy.diff(outer, u, order).subs(u, x[0]) / math.factorial(order)
        result = [a + factor * b for a, b in zip(result, power, strict=True)]
        power = _times(sympy, power, inner)
    return result
