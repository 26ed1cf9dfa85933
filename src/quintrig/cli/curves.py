"""What ``quintrig check`` says of a curve."""

from typing import TYPE_CHECKING

from quintrig.cli.show import line

if TYPE_CHECKING:
    from quintrig.model.model import Model
    from quintrig.model.patch import NamedCurve


def tell_curve(one: "NamedCurve", model: "Model") -> int:
    """Print what a curve is; return the number of warnings."""
    from quintrig.analysis.curve_summary import curve_facts, summarise_curve

    if len(model.curves) + len(model.patches) > 1:
        line("  ", (one.name, "bold"))
    found = summarise_curve(one.curve)
    facts = curve_facts(found, model.unit)
    more = [("basis", one.definition.basis_words)] if one.definition.basis_words else []
    more += [("shape", one.label)] if one.definition.shape_symbols else []
    for name, value in [*facts[:2], *more, *facts[2:]]:
        line("  ", (f"{name:<12}", "cyan"), value)
    for warning in found.cautions:
        line("  ", (f"warning     {warning}", "yellow"))
    if not found.cautions:
        line("  ", ("no warnings", "green"))
    return len(found.cautions)
