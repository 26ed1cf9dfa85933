"""The chapter on a target beside the model: how far its points are, in numbers and a picture."""

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from markupsafe import Markup, escape

from quintrig.figure.deviation import deviation_picture
from quintrig.report.pictures import Picture
from quintrig.report.tables import Grid, head
from quintrig.report.wording import aligned, digits_of, measure, pair, percent, prose

if TYPE_CHECKING:  # scans bring Numba and SciPy with them
    from quintrig.scan.deviation import Deviation

_COLUMNS = ("min", "mean", "max", "rms")


@dataclass(frozen=True)
class Beside:
    """A target that the page tells of beside the model: its name and its deviation."""

    name: str
    found: "Deviation"


def picture(beside: Beside) -> Picture:
    """Return the picture of a deviation, described."""
    found = beside.found
    unit = f" {found.unit}" if found.unit else ""
    alt = (
        f"The surface with {len(found):,} points of {beside.name} coloured by their distance, from {found.min:.3g} to "
        f"{found.max:.3g}{unit}, beside a histogram."
    )
    return Picture("deviation", alt, partial(deviation_picture, found))


def sentences(beside: Beside) -> tuple[Markup, ...]:
    """Say what the distances come to, what lies beyond the border, within the tolerance, and what was moved first."""
    found = beside.found
    said = [
        Markup("The {} points of <b>{}</b> are {} from the model (rms), at most {}.").format(
            f"{len(found):,}", beside.name, measure(found.rms, found.unit), measure(_largest(found), found.unit)
        )
    ]
    if found.within is not None and found.tolerance is not None:
        bound = measure(found.tolerance, found.unit)
        said.append(Markup("{} of them are within ±{}.").format(percent(found.within), bound))
    if found.edge.any():
        said.append(
            Markup("{} lie beyond the border; their distance is that from the border, not orthogonal.").format(
                f"{int(found.edge.sum()):,}"
            )
        )
    if found.motion is not None:
        moved = found.motion
        out = f"; {percent(moved.left_out)} did not count as outliers" if moved.left_out else ""
        said.append(
            Markup("They were first aligned as a rigid body: turned by {}°, moved by up to {}{}.").format(
                digits_of(moved.angle), measure(moved.largest, found.unit), out
            )
        )
    return (*said, *(escape(note[:1].upper() + note[1:] + ".") for note in found.notes))


def table(beside: Beside) -> Grid:
    """Return the distances of all points, of those beside the surface, beyond its border, and of every patch."""
    from quintrig.scan.deviation import SIGN

    told = beside.found.to_dict()
    rows = [("all points", told), ("orthogonal", told["orthogonal"]), ("beyond the border", told["edge"])]
    if len(told["patches"]) > 1:
        rows += [(part["name"], part) for part in told["patches"]]
    rows = [(name, part) for name, part in rows if part["points"]]
    power, texts = aligned([part[key] for _, part in rows for key in _COLUMNS])
    columns = [texts[k : k + len(_COLUMNS)] for k in range(0, len(texts), len(_COLUMNS))]
    cells = tuple(
        (escape(name), Markup(f"{part['points']:,}"), *(escape(text) for text in numbers))
        for (name, part), numbers in zip(rows, columns, strict=True)
    )
    heads = (Markup("of"), Markup("points"), *(head(Markup(key), beside.found.unit, power) for key in _COLUMNS))
    note = prose(f"A distance is {SIGN}.")
    return Grid("Deviation", heads, cells, (True, *([False] * (len(_COLUMNS) + 1))), (note,))


def worst(beside: Beside) -> Grid:
    """Return the points that are farthest away, with their places."""
    found = beside.found
    told = found.to_dict()["worst"]
    power, texts = aligned([one["distance"] for one in told])
    rows = tuple(
        (
            escape(f"({', '.join(f'{x:.6g}' for x in one['point'])})".replace("-", "−")),
            escape(text),
            escape(one["patch"]),
            pair(one["u"], one["v"]) + (Markup(", at the border") if one["edge"] else Markup("")),
        )
        for one, text in zip(told, texts, strict=True)
    )
    heads = (head(Markup("point"), found.unit), head(Markup("distance"), found.unit, power), Markup("patch"),
             Markup("nearest at (<i>u</i>, <i>v</i>)"))  # fmt: skip
    return Grid("Farthest points", heads, rows, (True, False, True, True))


def _largest(found: "Deviation") -> float:
    return max(abs(found.min), abs(found.max))
