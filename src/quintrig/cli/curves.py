"""What ``quintrig check`` says of a curve."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console

    from quintrig.model.model import Model
    from quintrig.model.patch import NamedCurve


def tell_curve(one: "NamedCurve", model: "Model", console: "Console") -> int:
    """Print what a curve is; return the number of warnings."""
    from rich.markup import escape

    from quintrig.analysis.curve_summary import curve_facts, summarise_curve

    if len(model.curves) + len(model.patches) > 1:
        console.print(f"  [bold]{escape(one.name)}[/bold]")
    found = summarise_curve(one.curve)
    facts = curve_facts(found, model.unit)
    more = [("basis", one.definition.basis_words)] if one.definition.basis_words else []
    more += [("shape", one.label)] if one.definition.shape_symbols else []
    for name, value in [*facts[:2], *more, *facts[2:]]:
        console.print(f"  [cyan]{name:<12}[/cyan]{escape(value)}", soft_wrap=True)
    for warning in found.cautions:
        console.print(f"  [yellow]warning     {escape(warning)}[/yellow]", soft_wrap=True)
    if not found.cautions:
        console.print("  [green]no warnings[/green]")
    return len(found.cautions)
