"""Tables as LaTeX that compiles: with booktabs alone, or with siunitx, which aligns numbers at their points."""

import math
import unicodedata
from collections.abc import Iterator
from itertools import pairwise

from quintrig.analysis.table import Column, Table

_WIDEST = 8
"""Columns of a table that fit on a page beside each other."""

_LONGEST = 9
"""Letters of a number without a power of ten."""


def to_latex(table: Table, *, digits: int = 6, siunitx: bool = False) -> str:
    r"""Return a LaTeX ``table`` with booktabs rules, symbols in mathematics and units in the headings.

    Numbers have so many significant ``digits``, 1 to 17. The title is the caption; notes stand below. A table too wide
    for a page is cut into parts below one another, which repeat the columns that name the rows. It needs
    ``\usepackage{booktabs}``, and with ``siunitx`` that package too. Raises ValueError for other digits.
    """
    if not 1 <= digits <= 17:
        raise ValueError(f"digits: expected 1 to 17, found {digits}")
    packages = ("booktabs", "siunitx") if siunitx else ("booktabs",)
    tabulars = [_tabular(columns, digits, siunitx) for columns in parts(table, _WIDEST)]
    needed = " ".join(rf"\usepackage{{{name}}}" for name in packages)
    lines = [f"% needs {needed}", r"\begin{table}[htbp]", r"\centering"]
    if table.title:
        lines.append(rf"\caption{{{text(table.title)}}}")
    lines.append("\n\n\\medskip\n".join(tabulars))
    if table.notes:
        lines += ["", r"\smallskip", rf"\parbox{{\linewidth}}{{\footnotesize {' '.join(map(text, table.notes))}}}"]
    return "\n".join([*lines, r"\end{table}"]) + "\n"


def parts(table: Table, widest: int) -> Iterator[tuple[Column, ...]]:
    """Cut the columns into parts of at most ``widest``; every part repeats the columns that name the row."""
    names, rest = table.columns[: table.lead], table.columns[table.lead :]
    count = max(1, math.ceil(len(rest) / max(1, widest - len(names))))
    cuts = [round(i * len(rest) / count) for i in range(count + 1)]
    for start, end in pairwise(cuts):
        yield names + rest[start:end]


def text(words: str) -> str:
    """Return words as LaTeX sets them: nothing of its own in them acts, and letters that it lacks are spelled out."""
    for plain, formula in _FORMULAS.items():
        words = words.replace(plain, f"\x00{formula}\x01")
    pieces = words.replace("\x01", "\x00").split("\x00")  # every second one is a formula
    return "".join(rf"${piece}$" if i % 2 else "".join(map(_letter, piece)) for i, piece in enumerate(pieces))


_FORMULAS = {
    "S_u × S_v": r"S_u \times S_v",
    "S_u x S_v": r"S_u \times S_v",
    "<=": r"\leq",
    ">=": r"\geq",
    **{
        f"{letter}{i}": rf"\{name}_{i}"
        for letter, name in (("κ", "kappa"), ("β", "beta"), ("γ", "gamma"))
        for i in range(4)
    },
    **{f"{letter}{i}": rf"\{name}_{i}" for letter, name in (("α", "alpha"), ("ζ", "zeta")) for i in (1, 2)},
}
"""What is a formula in notes, by how they write it."""

_GREEK = {chr(code): unicodedata.name(chr(code)).split()[-1].lower() for code in range(0x3B1, 0x3CA) if code != 0x3C2}

_LETTERS = {
    "\\": r"\textbackslash{}",
    **{c: f"\\{c}" for c in "&%$#_{}"},
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": "$<$",
    ">": "$>$",
    "|": "$|$",
    "²": "$^2$",
    "³": "$^3$",
    "×": r"$\times$",
    "·": r"$\cdot$",
    "ˢ": "$^{S}$",
    "−": "$-$",
    "∞": r"$\infty$",
    "≤": r"$\leq$",
    "≥": r"$\geq$",
    "√": r"$\surd$",
    "∫": r"$\int$",
    "±": r"$\pm$",
    "°": r"$^\circ$",
    "′": r"$'$",
    "–": "--",
    "—": "---",
    "“": "``",
    "”": "''",
    "„": r",,",
    "‘": "`",
    "’": "'",
    "…": r"\dots{}",
    "µ": r"$\mu$",
    **{
        letter: rf"$\{ {'lamda': 'lambda', 'omicron': 'mathit{o}'}.get(name, name) }$"
        for letter, name in _GREEK.items()
    },
    **{c: f"$_{i}$" for i, c in enumerate("₀₁₂₃₄₅₆₇₈₉")},
    **{c: f"$^{i}$" for i, c in enumerate("⁰\0\0\0⁴⁵⁶⁷⁸⁹") if c != "\0"},
    "⁻": "$^-$",
}
_ACCENTS = {0x300: "`", 0x301: "'", 0x302: "^", 0x303: "~", 0x304: "=", 0x306: "u", 0x307: ".", 0x308: '"', 0x30A: "r",
            0x30B: "H", 0x30C: "v", 0x327: "c", 0x328: "k"}  # fmt: skip
_OTHERS = {"ß": r"\ss{}", "æ": r"\ae{}", "Æ": r"\AE{}", "ø": r"\o{}", "Ø": r"\O{}", "œ": r"\oe{}", "Œ": r"\OE{}",
           "ł": r"\l{}", "Ł": r"\L{}", "ı": r"\i{}", "¿": "?`", "¡": "!`", "§": r"\S{}"}  # fmt: skip


def _letter(c: str) -> str:
    if c in _LETTERS or c in _OTHERS:
        return _LETTERS.get(c) or _OTHERS[c]
    if " " <= c <= "~":
        return c
    if c.isspace():
        return " "
    base, *marks = unicodedata.normalize("NFD", c)
    if len(marks) == 1 and ord(marks[0]) in _ACCENTS and base.isascii() and base.isalpha():
        return rf"\{_ACCENTS[ord(marks[0])]}{{{base}}}"
    return rf"\texttt{{U+{ord(c):04X}}}" if c.isprintable() else ""


def _tabular(columns: tuple[Column, ...], digits: int, siunitx: bool) -> str:
    cells = [[_heading(column, siunitx), *_cells(column, digits, siunitx)] for column in columns]
    kinds = "".join("l" if column.is_text else _number_column(column, digits) if siunitx else "r" for column in columns)
    heading, *rows = (" & ".join(row) + r" \\" for row in zip(*cells, strict=True))
    return "\n".join(
        (rf"\begin{{tabular}}{{{kinds}}}", r"\toprule", heading, r"\midrule", *rows, r"\bottomrule", r"\end{tabular}")
    )


def _heading(column: Column, siunitx: bool) -> str:
    if column.is_text:
        return text(column.name)
    symbol = f"${column.latex}$" + (f" ({text(column.unit)})" if column.unit else "")
    return f"{{{symbol}}}" if siunitx else symbol


def _number_column(column: Column, digits: int) -> str:
    """Return the kind of a siunitx column that has room for its numbers."""
    whole, fraction, power = 1, 0, 0
    for value in column.rounded:
        if isinstance(value, float) and math.isfinite(value):
            mantissa, _, exponent = f"{value:.{digits}g}".partition("e")
            left, _, right = mantissa.lstrip("-").partition(".")
            whole, fraction, power = (
                max(whole, len(left)),
                max(fraction, len(right)),
                max(power, len(exponent.lstrip("+-0"))),
            )
    room = f"table-format=-{whole}.{fraction}" + (f"e-{power}" if power else "")
    return f"S[{room}]"


def _cells(column: Column, digits: int, siunitx: bool) -> list[str]:
    if column.is_text:
        return [text(str(value)) for value in column.rounded]
    numbers = [float(value) for value in column.rounded]
    decimals = None if siunitx else _decimals(numbers, digits)
    return [_number(value, digits, siunitx, decimals) for value in numbers]


def _decimals(numbers: list[float], digits: int) -> int | None:
    """Return how many decimals show all numbers with ``digits`` figures at least, None where that takes too many."""
    sizes = [abs(value) for value in numbers if math.isfinite(value) and value != 0.0]
    if not sizes:
        return 0
    # No more decimals than any number has: a column of round numbers stays one.
    needed = max(len(f"{size:.{digits}g}".partition("e")[0].partition(".")[2]) for size in sizes)
    small, large = (math.floor(math.log10(size)) for size in (min(sizes), max(sizes)))
    if (
        any("e" in f"{size:.{digits}g}" for size in sizes)
        or max(large, 0) + needed > _LONGEST + digits - 6
        or small < -4
    ):
        return None
    return needed


def _number(value: float, digits: int, siunitx: bool, decimals: int | None) -> str:
    if not math.isfinite(value):
        word = "--" if math.isnan(value) else r"$\infty$" if value > 0 else r"$-\infty$"
        return f"{{{word}}}" if siunitx else word
    if decimals is not None:
        return f"${value + 0.0:.{decimals}f}$"
    mantissa, _, exponent = f"{value:.{digits}g}".partition("e")
    if siunitx:
        return f"{mantissa}e{int(exponent)}" if exponent else mantissa
    return rf"${mantissa} \times 10^{{{int(exponent)}}}$" if exponent else f"${mantissa}$"
