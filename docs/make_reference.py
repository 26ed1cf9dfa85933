"""Write docs/reference.md and docs/quantities.md from the code: ``python docs/make_reference.py``."""

import inspect
from pathlib import Path

import quintrig
from quintrig.quantity import QUANTITIES, Quantity

HERE = Path(__file__).parent

CHAPTERS = {
    "Curves and surfaces": (
        "Curve",
        "tensor",
        "symmetric",
        "swept",
        "swung",
        "ruled",
        "developable",
        "regression",
        "Surface",
    ),
    "Reference surfaces": (
        "sphere",
        "ellipsoid",
        "cylinder",
        "cone",
        "torus",
        "catenoid",
        "helicoid",
        "hyperbolic_paraboloid",
        "monkey_saddle",
        "enneper",
    ),
    "Analysis": ("grid", "analyse", "Sample", "Thresholds", "analyse_blocks"),
    "Summaries": ("summarise", "integrals", "find_extremes", "compare_methods", "check_hull", "check_curve_hull"),
    "Models": ("load", "Model", "ModelError"),
}
"""Public names by chapter; names that are in none come last."""


def reference() -> str:
    """Return the reference of the public names as Markdown."""
    listed = {name for names in CHAPTERS.values() for name in names}
    rest = tuple(name for name in dir(quintrig) if name not in listed and name != "__version__")
    parts = [
        "# Reference",
        "Everything below is `from quintrig import ...`. Lengths are in the model's unit; a power of length stands "
        "with each result. This page is written by `docs/make_reference.py` from the docstrings.",
    ]
    for chapter, names in {**CHAPTERS, "More": rest}.items():
        if names:
            parts.append(f"## {chapter}")
            parts.extend(_entry(name) for name in names)
    return "\n\n".join(parts) + "\n"


def quantities() -> str:
    """Return the table of quantities as Markdown."""
    rows = [
        "# Quantities",
        "",
        "`analyse` computes these, by key; tables, figures, reports and the studio all read this one table. *Turning "
        "the normal* says what `flip = true` does to the value. Written by `docs/make_reference.py`.",
        "",
        "| key | symbol | what it is | meaning | unit | turning the normal | source |",
        "|---|---|---|---|---|---|---|",
    ]
    rows += [
        f"| `{q.key}` | {q.symbol} | {q.name} | {q.meaning} | {_power(q)} | {_turned(q)} | {q.source} |"
        for q in QUANTITIES
    ]
    for q in QUANTITIES:
        if q.classes:
            names = ", ".join(f"{i} {name}" for i, name in enumerate(q.classes))
            rows += ["", f"**{q.name}** (`{q.key}`): {names}."]
    return "\n".join(rows) + "\n"


def _power(q: Quantity) -> str:
    return "" if q.power == 0 else f"length^{q.power}"


def _turned(q: Quantity) -> str:
    swapped = f"changes places with {q.partner}" if q.colour == "vector" else f"becomes -{q.partner}"
    return {"even": "same", "odd": "changes sign", "swap": swapped, "mirror": "mirrored class"}[q.parity]


def _entry(name: str) -> str:
    thing = getattr(quintrig, name)
    lines = [f"### `{name}`", f"```python\n{_signature(name, thing)}\n```", inspect.getdoc(thing) or ""]
    if inspect.isclass(thing) and not issubclass(thing, Exception):
        for key, value in vars(thing).items():
            function = value.fget if isinstance(value, property) else getattr(value, "__func__", value)
            shown = key == "__call__" or not key.startswith("_")
            if shown and inspect.isfunction(function) and function.__doc__:
                head = key if isinstance(value, property) else _signature(key, function)
                lines.append(f"- **`{head}`**: {' '.join(inspect.getdoc(function).split())}")
    return "\n\n".join(lines)


def _signature(name: str, thing: object) -> str:
    try:
        signature = inspect.signature(thing)
    except ValueError:
        return name
    kept = [p.replace(annotation=inspect.Parameter.empty) for p in signature.parameters.values() if p.name != "self"]
    shown = "" if name == "__call__" else name
    return f"{shown}{signature.replace(parameters=kept, return_annotation=inspect.Signature.empty)}"


if __name__ == "__main__":
    (HERE / "reference.md").write_text(reference())
    (HERE / "quantities.md").write_text(quantities())
