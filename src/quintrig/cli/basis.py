"""``quintrig basis``: what holds of a basis and what does not."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session

if TYPE_CHECKING:
    from quintrig.analysis.basis_checks import BasisReport
    from quintrig.basis.formulas import Basis

_EPILOG = session.examples(
    ("quintrig basis", "the bases that are known, with their sources"),
    ("quintrig basis cubic", "what holds of one, and what does not"),
    ("quintrig basis paper.toml --json", "the bases of a file of [basis.NAME] tables, as data"),
    ('quintrig basis cubic --claim "z\'(0) = pi/2*(1 + alpha)*(P1 - P0)"', "is this formula right? it is not"),
    ("quintrig basis cubic --compare quintic,bernstein -o page.html", "several side by side"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, basis, _EPILOG)


def basis(
    name: Annotated[str | None, typer.Argument(metavar="[NAME|FILE]", help="A basis, or a file of bases.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print data.")] = False,
    compare: Annotated[str | None, typer.Option(metavar="A,B,...", help="Further bases, side by side.")] = None,
    claim: Annotated[
        list[str] | None,
        typer.Option(
            metavar="FORMULA", help='An end derivative as printed, such as "z\'(0) = 3*(P1 - P0)". Repeatable.'
        ),
    ] = None,
    output: Annotated[Path | None, typer.Option("-o", "--output", metavar="PAGE.html", help="Write a page.")] = None,
) -> None:
    """Check a basis: partition of unity, sign, ends, symmetry, precision, total positivity, circles.

    Without a name it lists the bases that are known. What a paper prints of the derivatives at t = 0 and 1 is entered
    with --claim, or as claims = [...] in the file, in the parameters and the control points P0, P1, ...; it says which
    coefficient is wrong, where and by how much.
    """
    import json

    asked = [word.strip() for word in [name or "", *(compare or "").split(",")] if word.strip()]
    if output is not None and output.suffix.lower() != ".html":
        raise ValueError(f"{output}: expected a name ending in .html; choose one such as basis.html")
    if not asked:
        if output is not None:
            raise ValueError("-o: expected the name of a basis, found none; quintrig basis lists them")
        _list(as_json)
        return
    from quintrig.analysis.basis_checks import check_basis

    chosen = [one for word in asked for one in _bases(word)]
    if claim and len(chosen) > 1:
        raise ValueError(f"--claim: expected one basis to compare with, found {len(chosen)}; put claims into the file")
    reports = [check_basis(one, claim or ()) for one in chosen]
    if output is not None:
        from quintrig.report.basis_page import basis_page

        session.deliver(basis_page(chosen, reports), output, *(Path(word) for word in asked))
    if as_json:
        data = [one.as_json() for one in reports]
        session.emit(json.dumps(data[0] if len(data) == 1 else data, indent=2, ensure_ascii=False))
    elif output is None:
        for one in reports:
            _print(one)


def _bases(word: str) -> "list[Basis]":
    """Return the basis of a name, or those of a file."""
    from quintrig.basis.registry import entry
    from quintrig.model.own_bases import own_bases
    from quintrig.model.patch import load_bases

    path = Path(word)
    if path.suffix.lower() not in (".toml", ".json"):
        return [entry(word).basis()]
    try:
        return [one.basis() for one in own_bases(load_bases(path)).values()]
    except ValueError as error:
        raise ValueError(str(error) if str(path) in str(error) else f"{path}: {error}") from None


def _list(as_json: bool) -> None:
    import json

    from quintrig.basis.registry import bases

    rows = [{"name": one.name, "title": one.title, "source": one.source} for one in bases().values()]
    if as_json:
        session.emit(json.dumps(rows, indent=2, ensure_ascii=False))
        return
    for row in rows:
        session.emit(f"{row['name']:34}{row['title']}; {row['source']}")


def _print(report: "BasisReport") -> None:
    from quintrig.analysis.basis_checks import PROPERTIES
    from quintrig.analysis.basis_ends import claim_words

    session.emit(f"{report.name}: {report.size} functions{'; ' if report.source else ''}{report.source}")
    for name, one in report.parameters.items():
        low, high = ("no end met" if end is None else f"{end:.4g}" for end in report.non_negative_range[name])
        session.emit(f"  {name} in {one['range']}; non-negative from {low} to {high}")
    for key, found in report.findings.items():
        at = ", ".join(f"{name} = {value:.4g}" for name, value in found.at.items())
        word = "yes" if found.holds else "NO "
        session.emit(f"  {word} {PROPERTIES[key]} (worst {found.worst:.3g}{at and f' at {at}'}; {found.how})")
    degree = "none" if report.rational_degree is None else f"degree {report.rational_degree}"
    session.emit(f"  exact rational form: {degree}; condition number {report.condition:.3g}")
    for end in report.end_derivatives:
        for order in range(1, 4):
            session.emit(f"  z{order * chr(39)}({end}) = {report.derivative(end, order)}")
    for one in report.claims:
        session.emit(f"  {'yes' if one.finding.holds else 'NO '} claimed: {one.text}")
        if not one.finding.holds:
            session.emit(f"      {claim_words(one)}")
