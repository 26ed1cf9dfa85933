"""Samples as the tables and labelled arrays that other packages work with."""

from collections.abc import Mapping
from html import escape
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quintrig.quantities.table import BY_KEY
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import need

Values = Mapping[str, NDArray[Any]]
"""Quantities by key, over parameters u and v that broadcast."""


_ROWS, _COLUMNS = 8, 10
"""What a notebook shows of a sample."""


def dataframe(u: FloatArray, v: FloatArray, values: Values) -> Any:
    """Return a pandas or else a polars DataFrame with a row for each point; QuintrigError where neither is there."""
    u, v = np.broadcast_arrays(u, v)
    columns: dict[str, Any] = {"u": u.ravel(), "v": v.ravel()}
    for key, array in values.items():
        row = BY_KEY[key]
        if row.kind == "class":
            columns[key] = np.array(row.classes)[array.ravel()]
        elif row.components == 1:
            columns[key] = array.ravel()
        else:
            columns |= {_of_axis(key, x): array[..., i].ravel() for i, x in enumerate("xyz")}
    for package in ("pandas", "polars"):
        if find_spec(package) is not None:
            return import_module(package).DataFrame(columns)
    raise QuintrigError("a DataFrame needs pandas or polars; install one of them with: pip install pandas")


def html(u: FloatArray, v: FloatArray, values: Values, caption: str) -> str:
    """Return a small table of the first points and quantities, in the colours of the page around it."""
    u, v = (one.ravel()[:_ROWS] for one in np.broadcast_arrays(u, v))
    heads, columns = ["u", "v"], [[f"{x:.6g}" for x in u], [f"{x:.6g}" for x in v]]
    for key in list(values)[:_COLUMNS]:
        row, array = BY_KEY[key], values[key].reshape(-1, *((3,) if BY_KEY[key].components == 3 else ()))[:_ROWS]
        heads.append(row.symbol)
        if row.kind == "class":
            columns.append([row.classes[code] for code in array.tolist()])
        else:
            columns.append(["(" + ", ".join(f"{x:.4g}" for x in np.atleast_1d(one)) + ")" for one in array])
            columns[-1] = columns[-1] if row.components == 3 else [text.strip("()") for text in columns[-1]]
    head = "".join(f"<th>{escape(text)}</th>" for text in heads)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(text)}</td>" for text in row) + "</tr>" for row in zip(*columns, strict=True)
    )
    return f"<table><caption>{escape(caption)}</caption><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def dataset(u: FloatArray, v: FloatArray, values: Values, size: float) -> Any:
    """Return an xarray Dataset of the quantities; QuintrigError where xarray is not installed."""
    xarray = need("xarray", "an xarray Dataset")
    if u.ndim == v.ndim == 2 and u.shape[1] == v.shape[0] == 1:
        names: tuple[str, ...] = ("u", "v")
        places: dict[str, Any] = {"u": u[:, 0], "v": v[0]}
    else:
        both = np.broadcast_arrays(u, v)
        names = ("point_number",) if both[0].ndim == 1 else tuple(f"axis_{k}" for k in range(both[0].ndim))
        places = {"u": (names, both[0]), "v": (names, both[1])}
    found: dict[str, Any] = {}
    for key, array in values.items():
        row = BY_KEY[key]
        about: dict[str, Any] = {"long_name": row.name, "power_of_length": row.power}
        if row.kind == "class":
            about["classes"] = list(row.classes)
        found[key] = ((*names, "axis") if row.components == 3 else names, np.ascontiguousarray(array), about)
    if any(BY_KEY[key].components == 3 for key in values):
        places["axis"] = list("xyz")
    return xarray.Dataset(found, places, {"size": size})


def _of_axis(key: str, axis: str) -> str:
    return axis if key == "point" else f"{key}_{axis}"
