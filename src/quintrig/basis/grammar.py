"""The small grammar in which the functions of a basis are written: parsed into a tree, never handed to ``eval``.

    sum      = ["-"] product (("+" | "-") product)*
    product  = factor (("*" | "/") factor)*
    factor   = "-" factor | atom ["^" whole number]
    atom     = number | name | function "(" sum ")" | "(" sum ")"

Names are the parameters of the basis, ``t``, ``r`` = 1 - t, ``s`` = sin(πt/2), ``c`` = cos(πt/2), ``a`` = 1 - s,
``b`` = 1 - c and ``pi``; functions are sin, cos, sinh, cosh, sqrt and exp. Differences that would cancel, such as
1 - s or x - sin(x), become nodes of their own, which are worked out without.
"""

import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass

from quintrig.support.errors import nearest

VARIABLES = ("t", "r", "s", "c", "a", "b")
"""The names that stand for functions of t."""

FUNCTIONS = ("sin", "cos", "sinh", "cosh", "sqrt", "exp")
"""The functions that may be called."""

RESERVED = (*VARIABLES, "pi", *FUNCTIONS)
"""Names that no parameter may have."""

LONGEST, DEEPEST, HIGHEST_POWER = 4000, 40, 64
"""Most characters of a formula, deepest nesting of its parentheses, highest power."""

_LARGEST_TREE = 200  # levels: long sums and products are chains of nodes


@dataclass(frozen=True)
class Number:
    """A number."""

    value: float


@dataclass(frozen=True)
class Name:
    """A variable, a parameter or ``pi``."""

    name: str


@dataclass(frozen=True)
class Binary:
    """``left`` and ``right`` joined by one of + - * /."""

    sign: str
    left: "Node"
    right: "Node"


@dataclass(frozen=True)
class Power:
    """``base`` to a whole power."""

    base: "Node"
    exponent: int


@dataclass(frozen=True)
class Call:
    """A function of ``argument``: one of FUNCTIONS, or one of these, which never cancel.

    ``versin`` 1 - cos x, ``coshless`` cosh x - 1, ``sinrest`` x - sin x, ``sinhrest`` sinh x - x.
    """

    function: str
    argument: "Node"


Node = Number | Name | Binary | Power | Call

_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?P<name>[^\W\d]\w*)|(?P<sign>\*\*|.))", re.S
)
_COMPLEMENT = {"s": "a", "c": "b", "t": "r", "a": "s", "b": "c", "r": "t"}


def parse(text: str, parameters: Collection[str] = ()) -> Node:
    """Return the tree of a formula; ValueError naming the character (from 1), what was expected and what was found."""
    if not isinstance(text, str):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise ValueError(f"expected a formula in quotation marks, found {text!r}"[:200])  # noqa: TRY004 — as in a file
    if len(text) > LONGEST:
        raise ValueError(f"expected at most {LONGEST} characters, found {len(text)}; shorten the formula")
    return _Parser(text, parameters).whole()


def children(node: Node) -> tuple[Node, ...]:
    """Return the nodes that a node is made of."""
    if isinstance(node, Binary):
        return node.left, node.right
    if isinstance(node, Power):
        return (node.base,)
    return (node.argument,) if isinstance(node, Call) else ()


def names(node: Node) -> Iterator[str]:
    """Yield the names in a tree, each as often as it occurs."""
    if isinstance(node, Name):
        yield node.name
    for child in children(node):
        yield from names(child)


def ordered(trees: Collection[Node]) -> list[Node]:
    """Return the distinct nodes of trees, every node after those that it is made of."""
    found: dict[Node, None] = {}

    def visit(node: Node) -> None:
        if node not in found:
            for child in children(node):
                visit(child)
            found[node] = None

    for tree in trees:
        visit(tree)
    return list(found)


class _Parser:
    """One pass over the tokens of one formula."""

    def __init__(self, text: str, parameters: Collection[str]) -> None:
        self.text, self.parameters = text, parameters
        self.place, self.depth = 0, 0
        self.kind, self.token, self.start = "", "", 0
        self.advance()

    def whole(self) -> Node:
        node, _ = self.sum()
        if self.kind:
            self.fail(
                "expected an operator + - * / ^ or the end",
                "write 2*t for a product" if self.kind != "sign" else self.remedy(),
            )
        return node

    def advance(self) -> None:
        match = _TOKEN.match(self.text, self.place)
        if match is None:  # only blanks are left
            self.kind, self.token, self.start = "", "", len(self.text.rstrip())
            return
        self.kind = match.lastgroup or ""
        self.token, self.start, self.place = match[self.kind], match.start(self.kind), match.end()

    def fail(self, expected: str, remedy: str = "") -> None:
        found = repr(self.token[:40]) if self.kind else "the end of the formula"
        hint = f"; {remedy}" if remedy else ""
        raise ValueError(f"character {self.start + 1}: {expected}, found {found}{hint}")

    def sum(self) -> tuple[Node, int]:
        left, level = self.product()
        while self.kind == "sign" and self.token in "+-":
            sign = self.token
            self.advance()
            right, other = self.product()
            left, level = _binary(sign, left, right), self.higher(level, other)
        return left, level

    def product(self) -> tuple[Node, int]:
        left, level = self.factor()
        while self.kind == "sign" and self.token in "*/":
            sign = self.token
            self.advance()
            right, other = self.factor()
            left, level = _binary(sign, left, right), self.higher(level, other)
        return left, level

    def factor(self) -> tuple[Node, int]:
        if self.kind == "sign" and self.token == "-":
            self.deeper()
            self.advance()
            node, level = self.factor()
            self.depth -= 1
            negative = Number(-node.value) if isinstance(node, Number) else Binary("*", Number(-1.0), node)
            return negative, self.higher(level)
        node, level = self.atom()
        if self.kind == "sign" and self.token == "**":
            self.fail("expected an operator + - * / ^", "write ^ for a power")
        if self.kind == "sign" and self.token == "^":
            self.advance()
            node, level = Power(node, self.exponent()), self.higher(level)
            if self.kind == "sign" and self.token in ("^", "**"):
                self.fail("expected one power only", "set parentheses: (x^2)^3")
        return node, level

    def exponent(self) -> int:
        if self.kind != "number" or not self.token.isdigit():
            self.fail(
                f"expected a whole power from 0 to {HIGHEST_POWER}", "write products, quotients or sqrt for others"
            )
        if len(self.token) > 4 or int(self.token) > HIGHEST_POWER:
            self.fail(f"expected a power of at most {HIGHEST_POWER}", "lower it")
        value = int(self.token)
        self.advance()
        return value

    def atom(self) -> tuple[Node, int]:
        if self.kind == "number":
            value = float(self.token)
            if value > 1e100:
                self.fail("expected a number of at most 1e100")
            self.advance()
            return Number(value), 1
        if self.kind == "name":
            return self.named()
        if self.kind == "sign" and self.token == "(":
            return self.bracket()
        self.fail("expected a number, a name or '('", self.remedy())
        raise AssertionError

    def named(self) -> tuple[Node, int]:
        name = self.token
        if name in FUNCTIONS:
            self.advance()
            if self.token != "(":
                self.fail(f"expected '(' after {name}", f"write {name}(...)")
            node, level = self.bracket()
            return Call(name, node), self.higher(level)
        known = (*VARIABLES, "pi", *self.parameters)
        if name not in known:
            called = re.match(r"\s*\(", self.text[self.place :])
            what = f"a function, one of {', '.join(FUNCTIONS)}" if called else f"a name, one of {', '.join(known)}"
            hint = nearest(name, FUNCTIONS if called else known) or ("" if called else "; list it under parameters")
            self.fail(f"expected {what}", hint.removeprefix("; "))
        self.advance()
        if self.kind == "sign" and self.token == "(":
            self.fail("expected an operator + - * / ^", "write t*(...) for a product")
        return Name(name), 1

    def bracket(self) -> tuple[Node, int]:
        self.deeper()
        self.advance()
        node, level = self.sum()
        if self.token != ")":
            self.fail("expected ')'", self.remedy())
        self.advance()
        self.depth -= 1
        return node, level

    def deeper(self) -> None:
        self.depth += 1
        if self.depth > DEEPEST:
            self.fail(f"expected at most {DEEPEST} levels of nesting", "simplify the formula")

    def higher(self, *levels: int) -> int:
        level = max(levels) + 1
        if level > _LARGEST_TREE:
            self.fail(f"expected at most {_LARGEST_TREE} terms or factors in a row", "simplify the formula")
        return level

    def remedy(self) -> str:
        if self.token in (".", "[", "{", "_", "'", '"', ";", ":", "@", "=", "!", "`"):
            return "a formula holds numbers, names, + - * / ^ and parentheses only"
        return "write one argument only" if self.token == "," else ""


def _binary(sign: str, left: Node, right: Node) -> Node:
    """Return the node of an operation, in a form that does not cancel where there is one."""
    if sign == "-" and left == Number(1.0):
        if isinstance(right, Name) and right.name in _COMPLEMENT:
            return Name(_COMPLEMENT[right.name])
        if isinstance(right, Call) and right.function == "cos":
            return Call("versin", right.argument)
    if sign == "-" and isinstance(right, Call) and right == Call("sin", left):
        return Call("sinrest", left)
    if sign == "-" and isinstance(left, Call):
        if left.function == "cosh" and right == Number(1.0):
            return Call("coshless", left.argument)
        if left == Call("sinh", right):
            return Call("sinhrest", right)
    return Binary(sign, left, right)
