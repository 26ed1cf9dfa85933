"""The page of ``quintrig basis``: pictures, formulas and what holds, of one basis or of several side by side."""

from collections.abc import Sequence

import numpy as np
from markupsafe import Markup, escape

from quintrig.analysis.basis_checks import PROPERTIES, BasisReport
from quintrig.analysis.basis_ends import claim_words
from quintrig.basis.formulas import Basis
from quintrig.basis.functions import Functions
from quintrig.basis.grammar import Binary, Call, Name, Node, Number, Power, parse
from quintrig.figure.curve import basis_functions, plane_curves
from quintrig.figure.save import to_svg_text
from quintrig.geometry.curve import Curve
from quintrig.report.mathml import mathml

_STYLE = """body{font:16px/1.5 system-ui,sans-serif;max-width:64rem;margin:2rem auto;padding:0 1rem;color:#222}
table{border-collapse:collapse;font-size:.9rem}td,th{text-align:left;padding:.3rem .7rem;border-bottom:1px solid #ddd;
vertical-align:top}.no{color:#a3210f;font-weight:600}svg{max-width:100%;height:auto}pre,.wide{overflow-x:auto;overflow-y:hidden}"""

_MOST_SHOWN = 6  # parameters, the effect of which is drawn
_GREEK = ("alpha", "beta", "gamma", "zeta", "kappa", "lambda", "rho", "theta", "pi")


def basis_page(bases: Sequence[Basis], reports: Sequence[BasisReport]) -> str:
    """Return the page of bases and what was found of each, as HTML that needs no other file."""
    names = [one.name for one in bases]
    picture = Markup(_svg(to_svg_text(basis_functions([one.family() for one in bases], names))))
    title = f"Basis {', '.join(names)}"
    parts = [
        Markup("<!doctype html><html lang='en'><meta charset='utf-8'><title>{}</title>").format(title),
        Markup("<meta name='viewport' content='width=device-width'><style>{}</style><h1>{}</h1>").format(
            Markup(_STYLE), title
        ),
        Markup("<p>The functions at the starting values of the parameters.</p>{}").format(picture),
        *_curves(bases),
        Markup("<h2>What holds</h2><div class='wide'>{}</div>").format(_properties(reports)),
    ]
    parts += [_one(*pair) for pair in zip(bases, reports, strict=True)]
    return str(Markup("\n").join(parts)) + "</html>\n"


def latex(node: Node) -> str:  # noqa: PLR0911 — one for each kind of node
    """Return a formula as LaTeX."""
    if isinstance(node, Number):
        return f"{node.value:.15g}"
    if isinstance(node, Name):
        return _name(node.name)
    if isinstance(node, Power):
        return f"{_bracketed(node.base, isinstance(node.base, (Name, Number)))}^{{{node.exponent}}}"
    if isinstance(node, Call):
        if node.function == "sqrt":
            return f"\\sqrt{{{latex(node.argument)}}}"
        known = node.function in ("sin", "cos", "sinh", "cosh")
        function = "\\" + node.function if known else f"\\mathrm{{{node.function}}}"
        return f"{function}({latex(node.argument)})"
    if node.sign == "/":
        return f"\\frac{{{latex(node.left)}}}{{{latex(node.right)}}}"
    if node.sign == "*":
        sides = (_bracketed(one, not _is_sum(one)) for one in (node.left, node.right))
        return (" \\cdot " if isinstance(node.right, Number) else " \\, ").join(sides)
    right = _bracketed(node.right, not (node.sign == "-" and _is_sum(node.right)))
    return f"{latex(node.left)} {node.sign} {right}"


def _is_sum(node: Node) -> bool:
    return isinstance(node, Binary) and node.sign in "+-"


def _bracketed(node: Node, plain: bool) -> str:
    return latex(node) if plain else f"({latex(node)})"


def _name(name: str) -> str:
    stem = name.rstrip("0123456789")
    digits = name[len(stem) :]
    symbol = "\\lambda" if stem == "lam" else f"\\{stem}" if stem in _GREEK else stem
    symbol = symbol if len(stem) == 1 or symbol != stem else f"\\mathrm{{{stem.replace('_', '')}}}"
    return f"{symbol}_{{{digits}}}" if digits else symbol


def _curves(bases: Sequence[Basis]) -> list[Markup]:
    """Return the pictures of the curves on one polygon for each number of control points."""
    shown: list[Markup] = []
    for size in sorted({one.size for one in bases if one.size > 2}):
        same = [one for one in bases if one.size == size]
        x = np.linspace(0.0, 1.0, size)
        points = np.stack([x, np.where(np.arange(size) % (size - 1) > 0, 0.6 + 0.2 * x, 0.0)], axis=-1)
        picture = plane_curves([Curve(points, basis=one.family()) for one in same], [one.name for one in same])
        shown.append(Markup("<p>Curves on one polygon.</p>{}").format(Markup(_svg(to_svg_text(picture)))))
    return shown


def _effect(basis: Basis) -> Markup:
    """Return the picture of the functions at both ends of each parameter's range, the others at their start."""
    families: list[Functions] = []
    titles: list[str] = []
    for i, one in enumerate(basis.parameters[:_MOST_SHOWN]):
        for inset, end in enumerate((one.low, one.high)):
            other = one.high + one.low - end
            value = end + 1e-3 * (other - end) * one.open[inset]
            families.append(basis.family([*basis.starts[:i], value, *basis.starts[i + 1 :]]))
            titles.append(f"{one.name} = {value:.4g}")
    if not families:
        return Markup("")
    return Markup("<p>The effect of each parameter.</p>{}").format(
        Markup(_svg(to_svg_text(basis_functions(families, titles))))
    )


def _derivative(basis: Basis, report: BasisReport, end: str, order: int) -> Markup:
    """Return an end derivative as MathML, or in words where it has no formula in the grammar of bases."""
    words = report.derivative(end, order)
    left = f"\\mathbf{{z}}{order * chr(39)}({end})"
    points = [f"P{i}" for i in range(basis.size)]
    try:
        right = latex(parse(words, [*(one.name for one in basis.parameters), *points]))
    except ValueError:
        return Markup("derivative {} at t = {}: {}").format(order, end, words)
    return mathml(f"{left} = {right}", block=True)


def _svg(text: str) -> str:
    return text[text.index("<svg") :]


def _properties(reports: Sequence[BasisReport]) -> Markup:
    head = Markup("").join(Markup("<th>{}</th>").format(one.name) for one in reports)
    rows = [Markup("<tr><th></th>{}</tr>").format(head)]
    for key, words in PROPERTIES.items():
        cells = Markup("").join(_cell(one, key) for one in reports)
        rows.append(Markup("<tr><th>{}</th>{}</tr>").format(words, cells))
    degrees = ["none" if one.rational_degree is None else f"degree {one.rational_degree}" for one in reports]
    for words, values in (
        ("exact rational form", degrees),
        ("condition number", [f"{one.condition:.3g}" for one in reports]),
    ):
        cells = Markup("").join(Markup("<td>{}</td>").format(value) for value in values)
        rows.append(Markup("<tr><th>{}</th>{}</tr>").format(words, cells))
    return Markup("<table>{}</table>").format(Markup("").join(rows))


def _cell(report: BasisReport, key: str) -> Markup:
    found = report.findings[key]
    at = ", ".join(f"{name} = {value:.4g}" for name, value in found.at.items())
    word = Markup("yes") if found.holds else Markup("<span class='no'>no</span>")
    return Markup("<td>{}; worst {} at {} ({})</td>").format(word, f"{found.worst:.3g}", at, found.how)


def _one(basis: Basis, report: BasisReport) -> Markup:
    written = [f"f_{{{i}}} = {latex(tree)}" for i, tree in enumerate(basis.trees)]
    shown = Markup("").join(Markup("<div class='wide'>{}</div>").format(mathml(one, block=True)) for one in written)
    rows: list[Markup] = []
    for name, one in report.parameters.items():
        low, high = ("no end met" if end is None else f"{end:.4g}" for end in report.non_negative_range[name])
        rows.append(Markup("<li>{} in {}; non-negative from {} to {}</li>").format(name, one["range"], low, high))
    for end in report.end_derivatives:
        for order in range(1, 4):
            rows.append(Markup("<li>{}</li>").format(_derivative(basis, report, end, order)))
    for claim in report.claims:
        told = "holds" if claim.finding.holds else claim_words(claim)
        rows.append(
            Markup("<li>claimed: {}: <span class='{}'>{}</span></li>").format(
                claim.text, "yes" if claim.finding.holds else "no", told
            )
        )
    effect = _effect(basis)
    source = "\n".join(one + r" \\" for one in written)
    return (
        Markup("<h2>{}</h2><p>{}</p><p>r = 1 - t, s = sin(πt/2), c = cos(πt/2), a = 1 - s, b = 1 - c.</p>{}").format(
            basis.name, basis.source, shown
        )
        + effect
        + Markup("<ul>{}</ul><details><summary>LaTeX</summary><pre>{}</pre></details>").format(
            Markup("").join(rows), escape(source)
        )
    )
