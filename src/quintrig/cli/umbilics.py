"""``quintrig umbilics``: where κ1 = κ2."""

import json
import math
from typing import Annotated

import typer

from quintrig.cli import session
from quintrig.cli.options import Face, ModelFile, OnlyPatch, Whole
from quintrig.support.errors import printable

_EPILOG = session.examples(
    ("quintrig umbilics lid.toml", "all umbilics: place, curvature, index, type"),
    ("quintrig umbilics lid.toml --json", "the same for programs"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, umbilics, _EPILOG)


def umbilics(
    model: ModelFile,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON: umbilics, complete, regions, sums.")] = False,
    patch: OnlyPatch = None,
    face: Face = None,
    whole: Whole = False,
) -> None:
    """Find the umbilics of a model: points where κ1 = κ2, so that no direction is principal.

    Each has its index (half turns of the lines of curvature around it) and type: star (-1/2), lemon or monstar (+1/2),
    planar where the curvature is 0 too. Curves and regions of umbilics are told as such, and the sum of the indices is
    checked against how the directions turn along the boundary. Where it can be, it is proved that there are no others.
    """
    from quintrig.interrogation.umbilics import umbilics as find

    loaded = session.only(session.load(model, face, whole), patch)
    found = find(loaded)
    if as_json:
        session.emit(json.dumps(found.to_dict(), ensure_ascii=False))
        return
    unit = f" 1/{loaded.unit}" if loaded.unit else ""
    for one in found.umbilics:
        point = ", ".join(f"{x:.6g}" for x in one.point.tolist())
        session.emit(
            f"{printable(one.patch)}: {one.type}, index {_index(one.index)}, at (u, v) = ({one.u:.9g}, {one.v:.9g}), "
            f"point ({point}), curvature {one.curvature:.6g}{unit}"
        )
    ones = "1 isolated umbilic" if len(found) == 1 else f"{len(found)} isolated umbilics"
    known = "proved complete" if found.complete else "no proof that there are no others"
    if found.none_elsewhere and not found.complete:
        known = "proved that there are none elsewhere, not how many these are"
    session.emit(f"{ones}; {known}")
    for region in found.regions:
        what = "every point is an umbilic" if region.kind == "region" else "a curve of umbilics"
        session.emit(f"{printable(region.patch)}: {what}, curvature {region.curvature:.6g}{unit}")
    for told in found.sums:
        agree = {True: "as it must be", False: "which DIFFERS", None: "which cannot be compared"}[told["agree"]]
        both = f"sum of indices {told['index_sum']}, rotation along the boundary {told['boundary_rotation']}"
        session.emit(f"{printable(str(told['patch']))}: {both}, {agree}")
    for note in found.notes:
        session.remark(note)


def _index(index: float) -> str:
    return "unknown" if math.isnan(index) else f"{index:+g}"
