"""Commented starter models, one for every kind.

The comments are the descriptions of the keys in ``definition``, so that there is one place that says what a key means.
"""

import textwrap
from typing import Any

from quintrig.model.kinds.curve import CurveKind
from quintrig.model.kinds.definition import Definition
from quintrig.model.kinds.registry import kinds
from quintrig.model.model import SCHEMA_VERSION, UNITS
from quintrig.model.toml import spell
from quintrig.support.errors import nearest

_WIDTH = 100


def starter(kind: str, remark: str = "") -> str:
    """Return a valid, commented TOML model of this kind, with a remark on top; ValueError with the nearest kind."""
    known: dict[str, type[Definition]] = {**kinds(), "curve": CurveKind}
    if kind not in known:
        raise ValueError(f"kind: expected one of {', '.join(known)}, got {kind!r}{nearest(kind, known)}")
    form = known[kind]
    values = form.starter
    lines = [
        *_comment(f"{_first_line(form)} {remark}"),
        "",
        f"schema = {SCHEMA_VERSION}",
        f'name = "My {kind.replace("_", " ")}{" surface" if form.nets and kind != "curve" else ""}"',
        *_comment(f"Unit of length, one of {', '.join(UNITS)}; leave it out for plain numbers."),
        'unit = "mm"',
        f'kind = "{kind}"',
    ]
    for key in sorted(form.model_fields, key=lambda key: _place(form, key, values)):
        field = form.model_fields[key]
        if key in ("kind", "name"):
            continue
        lines += ["", *_comment(f"{field.description}.")]
        if key in values or field.is_required():
            lines.append(f"{key} = {spell(values[key])}")
        elif key == "shape":
            lines.append(f"{key} = {spell([0.0] * len(form.shape_names))}")
        else:  # an option at its default: there to be switched on
            lines.append(f"# {key} = {spell(field.default)}" if field.default is not None else f"# {key} = ...")
    return "\n".join(lines) + "\n"


def _place(form: type[Definition], key: str, values: dict[str, Any]) -> int:
    """Order the keys: what must be there, what is worth changing, then options left at their default."""
    if form.model_fields[key].is_required():
        return 0
    return 1 if key == "shape" else 2 if key in values else 3


def _first_line(form: type[Definition]) -> str:
    return (form.__doc__ or "").splitlines()[0]


def _comment(text: str) -> list[str]:
    return [f"# {line}" for line in textwrap.wrap(text, _WIDTH)]
