"""``quintrig check``: is the model valid, what is it, and what to beware of."""

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from quintrig.cli import session
from quintrig.cli.ending import FOUND, MISTAKE, printable
from quintrig.cli.options import Whole
from quintrig.cli.show import line
from quintrig.support.errors import ModelError

if TYPE_CHECKING:
    from quintrig.analysis.extremes import Extreme
    from quintrig.analysis.summary import Summary
    from quintrig.model.model import Model
    from quintrig.model.patch import Patch
    from quintrig.multipatch.joins import Joins

_EPILOG = session.examples(
    ("quintrig check lid.toml", "tells kind, size, shape parameters, normal, curvature and warnings"),
    ("quintrig check lid.toml --prove", "also what is proved of the whole surface, such as K > 0"),
    ("quintrig check --strict models/*.toml", "fails, with exit code 1, where there is a warning"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, check, _EPILOG)


def check(
    models: Annotated[
        list[Path], typer.Argument(metavar="MODEL...", help="Model files, or CAD files.", show_default=False)
    ],
    whole: Whole = False,
    strict: Annotated[bool, typer.Option("--strict", help="Exit with 1 where there are warnings.")] = False,
    prove: Annotated[
        bool, typer.Option("--prove", help="Prove where it is regular, the sign of K, and bounds of K and H.")
    ] = False,
) -> None:
    """Check models, and tell in a few lines what each is and what to beware of.

    Warnings are singular points and edges, an edge of regression inside a developable strip, shape parameters outside
    their range, folds, coinciding control points, and seams between patches that are nearly closed. A note is no fault
    of the surface and does not fail --strict.
    """
    warnings = mistakes = 0
    for index, path in enumerate(models):
        if index:
            session.emit("")
        try:
            warnings += _tell(path, session.load_any(path, whole=whole), prove)
        except ModelError as error:
            session.complain(str(error))
            mistakes += 1
    if mistakes:
        raise typer.Exit(MISTAKE)
    if warnings and strict:
        raise typer.Exit(FOUND)


def _tell(path: Path, model: "Model", prove: bool) -> int:
    """Print what a model is; return the number of warnings."""
    line((printable(model.name), "bold"), "  ", (printable(str(path)), "dim"))
    warnings = sum(_tell_patch(patch, model, prove) for patch in model.patches) + _tell_seams(model)
    if model.curves:
        from quintrig.cli.curves import tell_curve

        warnings += sum(tell_curve(curve, model) for curve in model.curves)
    return warnings


def _tell_seams(model: "Model") -> int:
    """Print how many edges of several patches meet, and how smoothly; return the number of seams nearly closed."""
    if len(model.patches) < 2:
        return 0
    joins: Joins = model.joins()
    counts = ", ".join(f"{count} {order}" for order, count in joins.counts.items() if count) or "none"
    line("  ", ("seams", "bold"), f"     {counts}; free edges: {len(joins.free)}")
    for warning in joins.warnings:
        line("  ", (f"warning   {printable(warning)}", "yellow"))
    for join in joins.joins:
        if join.opposed:
            text = f"the normals of {join.first} and {join.second} look to opposite sides; flip one patch"
            line("  ", (f"note      {printable(text)}", "dim"))
    return len(joins.warnings)


def _tell_patch(patch: "Patch", model: "Model", prove: bool) -> int:
    from quintrig.analysis.summary import summarise

    summary = summarise(patch.surface, model.unit)
    if len(model.patches) + len(model.curves) > 1:
        line("  ", (patch.name, "bold"))
    for name, value in _facts(patch, model.unit, summary):
        line("  ", (f"{name:<10}", "cyan"), value)
    for name, value in _proofs(patch, model.unit) if prove else ():
        line("  ", (f"{name:<10}", "cyan"), value)
    for warning in summary.warnings:
        line("  ", (f"warning   {warning}", "yellow"))
    if not summary.warnings:
        line("  ", ("no warnings", "green"))
    for note in summary.notes:
        line("  ", (f"note      {note}", "dim"))
    return len(summary.warnings)


def _facts(patch: "Patch", unit: str, summary: "Summary") -> list[tuple[str, str]]:
    """Return the lines that describe a patch: what, and its value in words."""
    from quintrig.exchange.tables import shown

    box = " × ".join(shown(float(extent), 4) for extent in summary.box[1] - summary.box[0])
    area = _quantity(summary.integrals.area.value, f"{unit}²" if unit else "")
    facts = [("kind", _kind(patch)), ("size", f"{_quantity(box, unit)} along x, y, z; area {area}")]
    if not unit:
        facts.append(("unit", "none stated: plain numbers"))
    names = patch.definition.shape_symbols
    if names:
        facts.append(("shape", ", ".join(f"{n} = {value:g}" for n, value in zip(names, patch.shape, strict=True))))
    facts.append(("normal", _normal(patch, summary)))
    facts.append(("curvature", "; ".join(_range(key, unit, summary) for key in ("gaussian", "mean"))))
    return facts


def _proofs(patch: "Patch", unit: str) -> list[tuple[str, str]]:
    """Return the lines that tell what is proved of all of a patch."""
    from quintrig.analysis.certified import certify, ranges

    found = certify(patch.surface, unit)
    if found.reason:
        return [("proof", found.reason)]
    lines = [("proof", sentence) for sentence in found.sentences]
    return [*lines, *(("certified", line) for line in ranges(found))]


def _kind(patch: "Patch") -> str:
    words = (type(patch.definition).__doc__ or "").splitlines()[0].rstrip(".")
    first = words if words.partition("'")[0].lower() == patch.kind else f"{words[0].lower()}{words[1:]}"  # Enneper's
    if patch.definition.basis_words:
        first += f", {patch.definition.basis_words}"
    return first if first == patch.kind else f"{patch.kind}: {first}"


def _normal(patch: "Patch", summary: "Summary") -> str:
    from quintrig.analysis.sample import analyse

    middle = analyse(patch.surface, 0.5, 0.5, ("normal",)).normal
    along = summary.orientation.removeprefix("the normal points ")
    x, y, z = (round(float(part), 3) + 0.0 for part in middle)
    return along if math.isnan(x) else f"{along}; in the middle ({x:g}, {y:g}, {z:g})"


def _range(key: str, unit: str, summary: "Summary") -> str:
    from quintrig.exchange.tables import shown
    from quintrig.quantities.table import quantity
    from quintrig.support.tolerance import typical_rounding

    row, found = quantity(key), summary.extremes[key]
    if found.minimum.status == "undefined":
        return f"{row.symbol} undefined everywhere"
    rounding = typical_rounding(summary.extremes["curvedness"].mean.value, row.power)
    low, high = (_end(end, limit, rounding) for end, limit in ((found.minimum, -math.inf), (found.maximum, math.inf)))
    span = f"{row.symbol} from {shown(low, 4)} to {shown(high, 4)}" if low < high else f"{row.symbol} = {shown(low, 4)}"
    return _quantity(span, row.unit(unit))


def _end(extreme: "Extreme", limit: float, rounding: float) -> float:
    """Return an extreme value to be read: infinite where it has no bound, 0 where it is only rounding."""
    if extreme.status == "unbounded":
        return limit
    return 0.0 if abs(extreme.value) <= rounding else extreme.value


def _quantity(value: float | str, unit: str) -> str:
    from quintrig.exchange.tables import shown

    return f"{value if isinstance(value, str) else shown(value, 4)} {unit}".rstrip()
