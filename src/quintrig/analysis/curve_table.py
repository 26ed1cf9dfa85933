"""Tables of a curve: points, tangents, curvature and torsion over the parameter and the arc length."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from quintrig.analysis.table import Column, Table
from quintrig.geometry.curve import Curve
from quintrig.support.arrays import FloatArray, parameter
from quintrig.support.errors import ArgumentError, nearest


def tabulate_curve(
    curve: Curve, t: ArrayLike, quantities: Sequence[str] | None = None, *, unit: str = "", title: str = ""
) -> Table:
    """Return a table of t, point, arc length s, unit tangent and κ, with τ in space, at parameters (n,).

    ``quantities`` are the keys or symbols of the columns beside t, such as curvature, κ or T_x; all where None. κ has a
    sign in the plane, positive where the curve turns left. NaN where it is not defined. Raises ValueError for
    parameters outside [0, 1], and for unknown quantities.
    """
    at = np.atleast_1d(parameter(t, "t")).ravel()
    plane = curve.points.shape[1] == 2
    per = f"1/{unit}" if unit else ""
    ends = np.concatenate([[0.0], np.sort(at)])
    pieces = [curve.length(a, b) for a, b in zip(ends[:-1].tolist(), ends[1:].tolist(), strict=True)]
    lengths = np.empty(at.size)
    lengths[np.argsort(at, kind="stable")] = np.cumsum(pieces)
    columns = [_column("t", "t", "t", "parameter t", "", at)]
    columns += [_column(a, a, a, f"{a} of the point", unit, x) for a, x in zip("xyz", curve(at).T, strict=False)]
    columns.append(_column("s", "s", "s", "arc length from the start", unit, lengths))
    for axis, values in zip("xyz", curve.tangent(at).T, strict=False):
        columns.append(_column(f"tangent_{axis}", f"T_{axis}", f"T_{axis}", f"{axis} of the unit tangent", "", values))
    bend = curve.signed_curvature(at) if plane else curve.curvature(at)
    columns.append(_column("curvature", "κ", r"\kappa", "curvature", per, bend))
    notes = ["Curvature is positive where the curve turns left." if plane else "Curvature is not negative in space."]
    if not plane:
        columns.append(_column("torsion", "τ", r"\tau", "torsion", per, curve.torsion(at)))
    if quantities is not None:
        columns = [columns[0], *(_chosen(columns[1:], name) for name in quantities)]
    lengths_in = f"Lengths in {unit}." if unit else "No unit of length is given: plain numbers."
    return Table(title, (lengths_in, *notes, *curve.caveats), tuple(columns), 1)


def _chosen(columns: Sequence[Column], name: str) -> Column:
    """Return the column of a key or symbol; ValueError with those that there are."""
    for column in columns:
        if name in (column.key, column.symbol, column.latex.removeprefix("\\")):
            return column
    known = [column.key for column in columns]
    raise ArgumentError(f"unknown quantity {name[:40]!r}{nearest(name, known)}; a curve has {', '.join(known)}")


def _column(key: str, symbol: str, latex: str, name: str, unit: str, values: FloatArray) -> Column:
    numbers = tuple(values.tolist())
    return Column(key, symbol, latex, name, unit, numbers, numbers)
