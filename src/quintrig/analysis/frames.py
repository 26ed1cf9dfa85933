"""Samples as the tables and labelled arrays that other packages work with."""

from html import escape
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import numpy as np

from quintrig.quantities.table import BY_KEY
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import need

if TYPE_CHECKING:
    from quintrig.analysis.sample import Sample


_ROWS, _COLUMNS = 8, 10
"""What a notebook shows of a sample."""


def dataframe(sample: "Sample") -> Any:
    """Return a pandas or else a polars DataFrame with a row for each point; QuintrigError where neither is there."""
    u, v = np.broadcast_arrays(sample.u, sample.v)
    columns: dict[str, Any] = {"u": u.ravel(), "v": v.ravel()}
    for key in sample.values:
        row, values = BY_KEY[key], sample[key]
        if row.kind == "class":
            columns[key] = np.array(row.classes)[values.ravel()]
        elif row.components == 1:
            columns[key] = values.ravel()
        else:
            columns |= {_of_axis(key, x): values[..., i].ravel() for i, x in enumerate("xyz")}
    for package in ("pandas", "polars"):
        if find_spec(package) is not None:
            return import_module(package).DataFrame(columns)
    raise QuintrigError("a DataFrame needs pandas or polars; install one of them with: pip install pandas")


def html(sample: "Sample") -> str:
    """Return a small table of the first points and quantities, in the colours of the page around it."""
    u, v = (values.ravel()[:_ROWS] for values in np.broadcast_arrays(sample.u, sample.v))
    heads, columns = ["u", "v"], [[f"{x:.6g}" for x in u], [f"{x:.6g}" for x in v]]
    for key in list(sample.values)[:_COLUMNS]:
        row, values = BY_KEY[key], sample[key].reshape(-1, *((3,) if BY_KEY[key].components == 3 else ()))[:_ROWS]
        heads.append(row.symbol)
        if row.kind == "class":
            columns.append([row.classes[code] for code in values.tolist()])
        else:
            columns.append(["(" + ", ".join(f"{x:.4g}" for x in np.atleast_1d(one)) + ")" for one in values])
            columns[-1] = columns[-1] if row.components == 3 else [text.strip("()") for text in columns[-1]]
    head = "".join(f"<th>{escape(text)}</th>" for text in heads)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(text)}</td>" for text in row) + "</tr>" for row in zip(*columns, strict=True)
    )
    caption = escape(repr(sample).strip("<>"))
    return f"<table><caption>{caption}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def dataset(sample: "Sample") -> Any:
    """Return an xarray Dataset of the quantities; QuintrigError where xarray is not installed."""
    xarray = need("xarray", "an xarray Dataset")
    u, v = sample.u, sample.v
    if u.ndim == v.ndim == 2 and u.shape[1] == v.shape[0] == 1:
        names: tuple[str, ...] = ("u", "v")
        places: dict[str, Any] = {"u": u[:, 0], "v": v[0]}
    else:
        names = ("point_number",) if len(sample.shape) == 1 else tuple(f"axis_{k}" for k in range(len(sample.shape)))
        both = np.broadcast_arrays(u, v)
        places = {"u": (names, both[0]), "v": (names, both[1])}
    found: dict[str, Any] = {}
    for key in sample.values:
        row, values = BY_KEY[key], np.ascontiguousarray(sample[key])
        about: dict[str, Any] = {"long_name": row.name, "power_of_length": row.power}
        if row.kind == "class":
            about["classes"] = list(row.classes)
        found[key] = ((*names, "axis") if row.components == 3 else names, values, about)
    if any(BY_KEY[key].components == 3 for key in sample.values):
        places["axis"] = list("xyz")
    return xarray.Dataset(found, places, {"size": sample.size})


def _of_axis(key: str, axis: str) -> str:
    return axis if key == "point" else f"{key}_{axis}"
