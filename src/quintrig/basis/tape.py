"""Formulas as a tape of operations, for the compiled loop of ``tape_jit``: numbers folded, shared parts done once.

One compiled loop reads every tape, so no basis needs compiling of its own.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quintrig.basis.expression import called
from quintrig.basis.grammar import VARIABLES, Binary, Call, Name, Node, Number, Power, ordered
from quintrig.support.arrays import FloatArray
from quintrig.support.memory import address

CODES = (
    *("number", *VARIABLES, "add", "subtract", "multiply", "divide", "scale", "shift", "invert"),
    *("sin", "cos", "versin", "sinrest", "sinh", "cosh", "coshless", "sinhrest", "sqrt", "exp"),
)
"""What an operation does, by its number. The last ten are functions; ``invert`` divides a number by a series."""

_BY_NAME = {name: code for code, name in enumerate(CODES)}
_SIGNS = {"+": "add", "-": "subtract", "*": "multiply", "/": "divide"}


@dataclass(frozen=True, eq=False)
class Tape:
    """Operations (n, 3): code, and the operations that it works on; ``numbers`` (n,), and the ``roots`` asked for."""

    operations: NDArray[np.int64]
    numbers: FloatArray
    roots: NDArray[np.int64]

    def fill(self, t: FloatArray, partition: bool, out: FloatArray) -> None:
        """Write increments of the roots and two derivatives at blocks of parameters (blocks, BLOCK) to ``out``."""
        from quintrig.basis.tape_jit import SPARE, run

        whole = out if out.flags.c_contiguous else np.empty(out.shape)
        places, scratch = np.ascontiguousarray(t), np.empty(3 * len(self.operations) * t.shape[1] + SPARE)
        taped = address(self.operations), len(self.operations), address(self.numbers), address(self.roots)
        run(address(places), len(t), *taped, len(self.roots), partition, address(scratch), address(whole))
        if whole is not out:
            out[...] = whole


def tape(trees: Sequence[Node], values: Mapping[str, float]) -> Tape:
    """Return the tape of trees at values of the parameters."""
    writer = _Writer()
    found: dict[Node, float | int] = {}  # a number, or the operation that gives a series
    with np.errstate(all="ignore"):
        for node in ordered(trees):
            found[node] = writer.node(node, found, values)
    roots = [writer.placed(found[tree]) for tree in trees]
    operations = np.array([key[:3] for key in writer.known], dtype=np.int64).reshape(-1, 3)
    numbers = np.array([key[3] for key in writer.known], dtype=np.float64)
    return Tape(operations, numbers, np.array(roots, dtype=np.int64))


class _Writer:
    """Operations by what they do, in the order in which they are needed."""

    def __init__(self) -> None:
        self.known: dict[tuple[int, int, int, float], int] = {}

    def put(self, name: str, x: int = 0, y: int = 0, number: float = 0.0) -> int:
        return self.known.setdefault((_BY_NAME[name], x, y, float(number)), len(self.known))

    def placed(self, value: float | int) -> int:
        return self.put("number", number=value) if isinstance(value, float) else value

    def node(self, node: Node, found: Mapping[Node, float | int], values: Mapping[str, float]) -> float | int:
        if isinstance(node, Number):
            return float(node.value)
        if isinstance(node, Name):
            return self.put(node.name) if node.name in VARIABLES else float(values.get(node.name, np.pi))
        if isinstance(node, Power):
            return self.power(found[node.base], node.exponent)
        if isinstance(node, Call):
            x = found[node.argument]
            return float(called(node.function, np.array(x))) if isinstance(x, float) else self.put(node.function, x)
        return self.binary(node, found[node.left], found[node.right])

    def binary(self, node: Binary, x: float | int, y: float | int) -> float | int:
        if isinstance(x, float) and isinstance(y, float):
            first, second = np.float64(x), np.float64(y)
            results = {"+": first + second, "-": first - second, "*": first * second, "/": first / second}
            return float(results[node.sign])
        if isinstance(y, float):  # x is a series
            amounts = {"+": y, "-": -y, "*": y, "/": float(np.float64(1.0) / y)}
            return self.put("scale" if node.sign in "*/" else "shift", int(x), number=amounts[node.sign])
        if isinstance(x, float):
            moved = self.put("scale", y, number=-1.0) if node.sign == "-" else y
            return self.put({"/": "invert", "*": "scale"}.get(node.sign, "shift"), moved, number=x)
        return self.put(_SIGNS[node.sign], x, y)

    def power(self, x: float | int, exponent: int) -> float | int:
        if isinstance(x, float):
            return float(np.float64(x) ** exponent)
        if not exponent:
            return 1.0
        result, square = -1, x
        while exponent:
            if exponent & 1:
                result = square if result < 0 else self.put("multiply", result, square)
            exponent >>= 1
            square = self.put("multiply", square, square) if exponent else square
        return result
