"""Tables as LaTeX that compiles: with booktabs alone, or with siunitx, which aligns numbers at their points."""

import math
import re
import unicodedata
from collections.abc import Iterator

from quintrig.analysis.table import Column, Table

_ACROSS = 345.0
"""Points across a page of an article, which columns side by side fill."""

_DOWN, _NOTES = 36, 10
"""Rows on a page with a caption and so many lines of notes: more go on over pages, in a longtable."""

_LETTER, _WIDE, _BETWEEN = 5.0, 8.0, 12.0  # points: of a digit or small letter, of m, capitals and −, between columns

_LINE = 95
"""Letters of a line of notes."""

_LONGEST = 9
"""Letters of a number without a power of ten."""


def to_latex(table: Table, *, digits: int = 6, siunitx: bool = False) -> str:
    r"""Return a LaTeX ``table`` with booktabs rules, symbols in mathematics and units in the headings.

    Numbers have so many significant ``digits``, 1 to 17. The title is the caption; notes stand below. A table too wide
    for a page is cut into parts below one another, which repeat the columns that name the rows; one too tall is a
    ``longtable``, which goes on over pages. It needs ``\usepackage{booktabs}``, and those that its first line names.
    Raises ValueError for other digits.
    """
    if not 1 <= digits <= 17:
        raise ValueError(f"digits: expected 1 to 17, found {digits}")
    cut = [_Part(columns, digits, siunitx) for columns in parts(table, digits, siunitx)]
    words = " ".join(map(text, table.notes))
    tall = sum(len(part.rows) + 2 for part in cut) + len(words) // _LINE > _DOWN + _NOTES
    packages = ["booktabs", *(["siunitx"] if siunitx else []), *(["longtable"] if tall else [])]
    needed = " ".join(rf"\usepackage{{{name}}}" for name in packages)
    lines = [f"% needs {needed}"]
    caption = rf"\caption{{{text(table.title)}}}" if table.title else ""
    if tall:
        longs = [part.long(caption if index == 0 else "") for index, part in enumerate(cut)]
        return (
            "\n".join(
                [*lines, "\n\n".join(longs), *(["", rf"{{\footnotesize\noindent {words}\par}}"] if words else [])]
            )
            + "\n"
        )
    lines += [r"\begin{table}[htbp]", r"\centering", *([caption] if caption else [])]
    lines.append("\n\n\\medskip\n".join(part.tabular for part in cut))
    return (
        "\n".join(
            [
                *lines,
                *(["", r"\smallskip", rf"\parbox{{\linewidth}}{{\footnotesize {words}}}"] if words else []),
                r"\end{table}",
            ]
        )
        + "\n"
    )


def parts(table: Table, digits: int, siunitx: bool) -> Iterator[tuple[Column, ...]]:
    """Cut the columns into parts that fit on a page; every part repeats the columns that name the row."""
    names, rest = table.columns[: table.lead], table.columns[table.lead :]
    room = _ACROSS - sum(_width(column, digits, siunitx) for column in names)
    here: tuple[Column, ...] = ()
    taken = 0.0
    for column in rest:
        width = _width(column, digits, siunitx)
        if here and taken + width > room:
            yield names + here
            here, taken = (), 0.0
        here, taken = (*here, column), taken + width
    if here or not rest:
        yield names + here


def _width(column: Column, digits: int, siunitx: bool) -> float:
    """Return about how many points a column takes."""
    cells = [column.name] if column.is_text else [f"{column.symbol} ({column.unit})" if column.unit else column.symbol]
    if siunitx and not column.is_text:
        whole, fraction, power = _room(column, digits)
        cells.append("x" * (whole + fraction + 3 + (7 + power if power else 0)))
    for cell in _cells(column, digits, siunitx):
        # A power of ten: its sign and the raised exponent take the room of seven letters.
        cells.append(re.sub(r" \\times 10\^\{-?\d+\}|e-?\d+", "x" * 7, cell).strip("${}"))
    return _BETWEEN + max(sum(_WIDE if c in "-mw" or c.isupper() else _LETTER for c in cell) for cell in cells)


class _Part:
    """Columns that stand beside each other: their heading, rows and kinds."""

    def __init__(self, columns: tuple[Column, ...], digits: int, siunitx: bool) -> None:
        cells = [[_heading(column, siunitx), *_cells(column, digits, siunitx)] for column in columns]
        self.kinds = "".join(
            "l" if column.is_text else _number_column(column, digits) if siunitx else "r" for column in columns
        )
        self.heading, *self.rows = (" & ".join(row) + r" \\" for row in zip(*cells, strict=True))

    @property
    def tabular(self) -> str:
        lines = (r"\toprule", self.heading, r"\midrule", *self.rows, r"\bottomrule")
        return "\n".join((rf"\begin{{tabular}}{{{self.kinds}}}", *lines, r"\end{tabular}"))

    def long(self, caption: str) -> str:
        """Return a table over pages, its heading on each; without a caption it has no number."""
        head = (r"\toprule", self.heading, r"\midrule")
        first = (rf"{caption}\\", *head, r"\endfirsthead") if caption else ()
        lines = (*first, *head, r"\endhead", r"\bottomrule", r"\endfoot", *self.rows)
        back = "" if caption else "\n\\addtocounter{table}{-1}"
        return "\n".join((rf"\begin{{longtable}}{{{self.kinds}}}", *lines, r"\end{longtable}")) + back


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


def _heading(column: Column, siunitx: bool) -> str:
    if column.is_text:
        return text(column.name)
    symbol = f"${column.latex}$" + (f" ({text(column.unit)})" if column.unit else "")
    return f"{{{symbol}}}" if siunitx else symbol


def _number_column(column: Column, digits: int) -> str:
    """Return the kind of a siunitx column that has room for its numbers."""
    whole, fraction, power = _room(column, digits)
    return f"S[table-format=-{whole}.{fraction}{f'e-{power}' if power else ''}]"


def _room(column: Column, digits: int) -> tuple[int, int, int]:
    """Return how many digits stand before the point, behind it and in the power of ten, at most."""
    whole, fraction, power = 1, 0, 0
    for value in column.rounded:
        if isinstance(value, float) and math.isfinite(value):
            mantissa, _, exponent = _written(value, digits).partition("e")
            left, _, right = mantissa.lstrip("-").partition(".")
            whole, fraction, power = (
                max(whole, len(left)),
                max(fraction, len(right)),
                max(power, len(exponent.lstrip("+-0"))),
            )
    return whole, fraction, power


def _cells(column: Column, digits: int, siunitx: bool) -> list[str]:
    if column.is_text:
        return [text(str(value)) for value in column.rounded]
    numbers = [float(value) for value in column.rounded]
    decimals = None if siunitx else _decimals(numbers, digits)
    return [_number(value, digits, siunitx, decimals) for value in numbers]


def _written(value: float, digits: int) -> str:
    """Return a number with so many significant digits; what has less than seven before its point needs no power."""
    shown = f"{value:.{digits}g}"
    return f"{float(shown):.0f}" if "e+" in shown and abs(float(shown)) < 1e6 else shown


def _decimals(numbers: list[float], digits: int) -> int | None:
    """Return how many decimals show all numbers with ``digits`` figures at least, None where that takes too many."""
    sizes = [abs(value) for value in numbers if math.isfinite(value) and value != 0.0]
    if not sizes:
        return 0
    # No more decimals than any number has: a column of round numbers stays one.
    needed = max(len(_written(size, digits).partition("e")[0].partition(".")[2]) for size in sizes)
    small, large = (math.floor(math.log10(size)) for size in (min(sizes), max(sizes)))
    if (
        any("e" in _written(size, digits) for size in sizes)
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
    mantissa, _, exponent = _written(value, digits).partition("e")
    if siunitx:
        return f"{mantissa}e{int(exponent)}" if exponent else mantissa
    return rf"${mantissa} \times 10^{{{int(exponent)}}}$" if exponent else f"${mantissa}$"
