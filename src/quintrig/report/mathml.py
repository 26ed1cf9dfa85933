"""Formulas for the page: the small part of LaTeX that the table of quantities and the constructions use, as MathML."""

import re

from markupsafe import Markup, escape

_TOKEN = re.compile(r"\\[A-Za-z]+|\\[,;! ]|\d+(?:\.\d+)?|[A-Za-z]|\S")

_LETTERS = {
    "alpha": "α",
    "beta": "β",
    "gamma": "γ",
    "zeta": "ζ",
    "kappa": "κ",
    "lambda": "λ",
    "rho": "ρ",
    "theta": "θ",
    "pi": "π",
    "Pi": "Π",
}
_OPERATORS = {
    "times": "×",
    "cdot": "·",
    "cap": "∩",
    "in": "∈",
    "le": "≤",
    "leq": "≤",
    "pm": "±",
    "int": "∫",
    "iint": "∬",
    "sum": "∑",
    "prime": "′",
}
_FUNCTIONS = ("cos", "sin", "cosh", "sinh", "tan", "min", "max", "det")
SPACE = "\u00a0"
"""Kept at the ends of a text, where MathML drops others."""

_SPACES = {r"\,": "0.17em", r"\;": "0.28em", r"\ ": "0.3em", r"\!": "0em", r"\quad": "1em", r"\qquad": "2em"}


def mathml(latex: str, block: bool = False) -> Markup:
    r"""Return a formula as MathML, on a line of its own where ``block``.

    Known are letters, numbers, ``_ ^ '``, ``\frac \sqrt \overline \mathbf \mathrm \mbox \text``, sums, integrals, the
    functions and Greek letters of the field, and spaces. Raises ValueError for a command that is not known.
    """
    # The text inside \text{...} keeps its spaces: take it out before the rest is cut into tokens.
    texts: list[str] = []

    def aside(match: re.Match[str]) -> str:
        texts.append(match[2])
        return f"\\{match[1]}{{{len(texts) - 1}}}"

    tokens = _TOKEN.findall(re.sub(r"\\(text|mbox)\{([^}]*)\}", aside, latex))
    tokens.reverse()
    body = _row(tokens, texts, "")
    display = ' display="block"' if block else ""
    return Markup(f"<math{display}>{body}</math>")


def _row(tokens: list[str], texts: list[str], end: str) -> str:
    """Read atoms with their scripts up to ``end``."""
    parts: list[str] = []
    while tokens:
        if tokens[-1] == end:
            tokens.pop()
            break
        parts.append(_scripted(tokens, texts))
    return f"<mrow>{''.join(parts)}</mrow>"


def _scripted(tokens: list[str], texts: list[str]) -> str:
    token = tokens[-1]
    base = _atom(tokens, texts)
    below, above = "", ""
    while tokens and tokens[-1] in ("_", "^", "'"):
        mark = tokens.pop()
        if mark == "'":
            above += "<mo>′</mo>"
        elif mark == "_":
            below = _atom(tokens, texts)
        else:
            above += _atom(tokens, texts)
    if above:
        above = f"<mrow>{above}</mrow>"
    names = ("munder", "mover", "munderover") if token == r"\sum" else ("msub", "msup", "msubsup")
    if below and above:
        return f"<{names[2]}>{base}{below}{above}</{names[2]}>"
    if below:
        return f"<{names[0]}>{base}{below}</{names[0]}>"
    return f"<{names[1]}>{base}{above}</{names[1]}>" if above else base


def _atom(tokens: list[str], texts: list[str]) -> str:
    token = tokens.pop()
    if token == "{":
        return _row(tokens, texts, "}")
    if token in _SPACES:
        return f'<mspace width="{_SPACES[token]}"/>'
    if not token.startswith("\\"):
        return _plain(token)
    return _command(token[1:], tokens, texts)


def _plain(token: str) -> str:
    if token[0].isdigit():
        return f"<mn>{token}</mn>"
    if token.isalpha():
        return f"<mi>{token}</mi>"
    rigid = ' stretchy="false"' if token in "()|[]" else ""
    return f"<mo{rigid}>{'−' if token == '-' else escape(token)}</mo>"


def _command(name: str, tokens: list[str], texts: list[str]) -> str:
    result = ""
    if name in _LETTERS:
        result = f"<mi>{_LETTERS[name]}</mi>"
    elif name in _OPERATORS:
        result = f"<mo>{_OPERATORS[name]}</mo>"
    elif name in _FUNCTIONS:
        result = f'<mi mathvariant="normal">{name}</mi><mo>&#8289;</mo>'
    elif name == "frac":
        result = f"<mfrac>{_atom(tokens, texts)}{_atom(tokens, texts)}</mfrac>"
    elif name == "sqrt":
        result = f"<msqrt>{_atom(tokens, texts)}</msqrt>"
    elif name == "overline":
        result = f"<mover>{_atom(tokens, texts)}<mo>¯</mo></mover>"
    elif name == "mathbf":
        result = f'<mi mathvariant="normal" class="vector">{escape(_letters(tokens))}</mi>'
    elif name == "mathrm":
        result = f'<mi mathvariant="normal">{escape(_letters(tokens))}</mi>'
    elif name in ("mbox", "text"):
        result = f"<mtext>{escape(texts[int(_letters(tokens))].replace(' ', SPACE))}</mtext>"
    else:
        raise ValueError(f"formula: expected a known command, found \\{name}")
    return result


def _letters(tokens: list[str]) -> str:
    """Take a group such as ``{class}`` as one word."""
    tokens.pop()
    word = ""
    while tokens[-1] != "}":
        word += tokens.pop()
    tokens.pop()
    return word
