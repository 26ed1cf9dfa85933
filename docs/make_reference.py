"""Write docs/reference.md and docs/quantities.md from the code: ``python docs/make_reference.py``."""

import inspect
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from importlib import import_module
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

import quintrig
from quintrig.quantities.table import QUANTITIES, Quantity
from quintrig.support.handed import Handed

HERE = Path(__file__).parent

CHAPTERS = {
    "Curves and surfaces": (
        "Curve",
        "interpolate",
        "join_curves",
        "split_curve",
        "offset_curve",
        "tensor",
        "symmetric",
        "swept",
        "swung",
        "ruled",
        "developable",
        "regression",
        "Surface",
    ),
    "Measured points": (
        "read_scan",
        "Scan",
        "deviation",
        "Deviation",
        "fit",
        "Fit",
        "scan_curvature",
        "ScanCurvature",
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
    "Bodies": (
        "find_joins",
        "Joins",
        "join",
        "mirror",
        "blend",
        "extend",
        "fill",
        "cap",
        "grid_of_patches",
    ),
    "Lines": (
        "lines",
        "curvature_lines",
        "asymptotic_lines",
        "parabolic_lines",
        "ridges",
        "isophotes",
        "reflection_lines",
        "silhouettes",
        "section",
        "geodesic",
        "write_lines",
        "Lines",
        "Line",
        "umbilics",
        "Umbilics",
    ),
    "Proofs": ("prove", "bounds", "Verdict", "Bounds"),
    "Design": ("design", "Design", "fair", "fair_curve", "Fairing", "strip", "Strip", "strips", "Strips"),
    "Pictures": ("plot", "Style", "animate", "Animation"),
    "Exchange": ("save", "export", "open_model", "exact_surface", "unroll", "Sheet"),
    "From modules of their own": (
        "basis.registry.bases",
        "sweep.DesignSpace",
        "sweep.run",
        "sweep.load_sweep",
        "sweep.select",
        "sweep.Question",
        "mesh.mesh",
        "studio.viewer",
        "studio.code",
        "studio.policy",
        "studio.jupyter.show",
    ),
    "Other tools": ("from_pyvista", "from_trimesh", "from_compas", "from_build123d"),
}
"""Public names by chapter; names that are in none come last."""


def reference() -> str:
    """Return the reference of the public names as Markdown."""
    listed = {name for names in CHAPTERS.values() for name in names}
    rest = tuple(name for name in dir(quintrig) if name not in listed and name != "__version__")
    parts = [
        "# Reference",
        "Everything below is `from quintrig import ...`; a name with a dot is `from quintrig.module import ...`. "
        "Lengths are in the model's unit; a power of length stands with each result. This page is written by "
        "`docs/make_reference.py` from the docstrings.",
    ]
    for chapter, names in {**CHAPTERS, "More": rest}.items():
        if names:
            parts.append(f"## {chapter}")
            parts.extend(_entry(name) for name in names)
        if chapter == "Other tools":
            parts.append("### `Surface`, `Patch` and `Model`")
            parts.extend(_methods(Handed))
    parts.append("## Results")
    parts.append("What the functions above return, field by field. Each is a frozen dataclass.")
    parts.extend(_result(result) for result in _results())
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


def _entry(path: str) -> str:
    name, thing = path.rpartition(".")[2], _thing(path)
    lines = [f"### `{path}`", f"```python\n{_signature(name, thing)}\n```", inspect.getdoc(thing) or ""]
    returned = _returned(thing) if inspect.isfunction(thing) else None
    if returned is not None and returned.__name__ not in dir(quintrig):
        whole = _kind(get_type_hints(thing)["return"])
        lines.append(f"Returns {whole}, with {', '.join(f'`{field.name}`' for field in fields(returned))}.")
    if inspect.isclass(thing) and not issubclass(thing, Exception):
        lines.extend(_methods(thing))
    return "\n\n".join(lines)


def _thing(path: str) -> Any:
    """Return what a name of ``CHAPTERS`` stands for."""
    module, _, name = f"quintrig.{path}".rpartition(".")
    return getattr(import_module(module), name)


def _methods(thing: type) -> Iterator[str]:
    for key, value in vars(thing).items():
        function = value.fget if isinstance(value, property) else getattr(value, "__func__", value)
        shown = key == "__call__" or not key.startswith("_")
        if shown and inspect.isfunction(function) and function.__doc__:
            head = key if isinstance(value, property) else _signature(key, function)
            yield f"- **`{head}`**: {' '.join(inspect.getdoc(function).split())}"


def _hints(one: object) -> dict[str, object]:
    """Return the types that a function or dataclass names; those imported for checking alone are public names."""
    return get_type_hints(one, localns={name: getattr(quintrig, name) for name in dir(quintrig)})


def _returned(function: object) -> type | None:
    """Return the dataclass that a function returns, alone or in a mapping; None for anything else."""
    return next(_dataclasses(_hints(function).get("return")), None)


def _results() -> list[type]:
    """Return the dataclasses that public functions return and those in their fields, in the order met."""
    names = [name for names in CHAPTERS.values() for name in names]
    functions = [thing for name in names if inspect.isfunction(thing := _thing(name))]
    waiting = [found for function in functions if (found := _returned(function)) is not None]
    met: list[type] = []
    while waiting:
        one = waiting.pop(0)
        if one not in met and one.__name__ not in dir(quintrig):
            met.append(one)
            waiting += [inner for hint in _hints(one).values() for inner in _dataclasses(hint)]
    return met


def _dataclasses(hint: object) -> Iterator[type]:
    """Return the dataclasses that a type names."""
    if inspect.isclass(hint) and is_dataclass(hint):
        yield hint
    for part in get_args(hint):
        yield from _dataclasses(part)


def _result(result: type) -> str:
    hints = _hints(result)
    lines = [f"- `{field.name}`: {_kind(hints[field.name])}" for field in fields(result)]
    for key, value in vars(result).items():
        if isinstance(value, property) and not key.startswith("_"):
            lines.append(f"- `{key}`: {inspect.getdoc(value) or ''}")
        elif inspect.isfunction(value) and not key.startswith("_"):
            lines.append(f"- `{_signature(key, value)}`: {' '.join((inspect.getdoc(value) or '').split())}")
    return "\n\n".join((f"### `{result.__name__}`", inspect.getdoc(result) or "", "\n".join(lines)))


def _kind(hint: object) -> str:
    """Return a type in words."""
    origin, parts = get_origin(hint), get_args(hint)
    if origin is None:
        name = getattr(hint, "__name__", str(hint))
        return f"`{name}`" if is_dataclass(hint) else "None" if hint is NoneType else name
    if origin is Literal:
        return " or ".join(f'"{part}"' for part in parts)
    inner = list(dict.fromkeys(_kind(part) for part in parts if part is not Ellipsis))
    if origin in (Union, UnionType):
        return " or ".join(inner)
    if origin is np.ndarray:
        return "array"
    many = origin.__name__.lower()
    return f"{inner[-1]}, by {inner[0]}" if issubclass(origin, Mapping) else f"{many} of {' and '.join(inner)}"


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
