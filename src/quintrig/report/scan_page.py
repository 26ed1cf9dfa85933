"""The report on a scan: what it is, its curvature with errors, pictures; one HTML file."""

from base64 import b64encode
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from quintrig import __version__
from quintrig.exchange.tables import WRITERS, shown
from quintrig.figure.save import DPI, formats_of, to_bytes, to_png_bytes
from quintrig.figure.scan import scan_picture
from quintrig.figure.style import STANDARD, Style
from quintrig.quantities.table import quantity
from quintrig.scan.curvature import CLASSES, VALUES, ScanCurvature
from quintrig.scan.curvature_table import notes_of, tabulate_scan
from quintrig.support.files import refuse_unwritable, write_whole

_STYLE = (
    "body{font:15px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222}"
    "table{display:block;overflow-x:auto;border-collapse:collapse}"
    "td,th{padding:.2rem .8rem;text-align:right;border-bottom:1px solid #ccc}"
    "td:first-child,th:first-child{text-align:left}img{max-width:100%}"
)
_SHARES = (0, 5, 25, 50, 75, 95, 100)


def write_scan_report(found: ScanCurvature, out: Path, figures: Sequence[str] = (), style: Style = STANDARD) -> Path:
    """Write a self-contained page on a scan's curvature, ``out/index.html`` or ``out`` itself, and return its path.

    ``figures`` are formats, such as pdf, in which its pictures are files beside the page too, with the table of all
    points as CSV; ``style`` is how they look.
    """
    formats = formats_of(figures)
    target = out if out.suffix.lower() in (".html", ".htm") else out / "index.html"
    refuse_unwritable(target)
    name = escape(found.scan.name)
    keys = [key for key in style.quantities if key != "surface"] or ["gaussian", "mean", "point_type"]
    drawn = {key: scan_picture(found, [key], style=style) for key in keys}
    body = [
        f"<h1>{name}</h1>",
        f"<p>{len(found.scan.points):,} points"
        + (f", {len(found.scan.triangles):,} triangles" if found.scan.triangles is not None else "")
        + f"; size {shown(found.scan.size, 4)} {escape(found.scan.unit)}.</p>",
        "<ul>" + "".join(f"<li>{escape(note)}</li>" for note in notes_of(found)) + "</ul>",
        "<h2>Curvature</h2>",
        _numbers(found),
        *(
            f"<h2>{escape(quantity(key).name.capitalize())}</h2>{_picture(drawn[key], key)}"
            for key in drawn
            if key != "point_type"
        ),
        "<h2>Errors</h2><p>The error of a value is what about 95 of 100 values are nearer to the truth than.</p>",
        _errors(found),
        *(f"<h2>{escape(quantity(key).name.capitalize())}</h2>{_counts(found, key)}" for key in CLASSES),
        *([_picture(drawn["point_type"], "point_type")] if "point_type" in drawn else []),
    ]
    page = (
        f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{name}</title><style>{_STYLE}</style>'
        f"</head><body>{''.join(body)}<p><small>quintrig {__version__}</small></p></body></html>\n"
    )
    for key, figure in drawn.items():
        for form in formats:
            write_whole(target.parent / "figures" / f"{key}.{form}", to_bytes(figure, form, style.dpi or DPI))
    if formats:
        write_whole(target.parent / "tables" / "points.csv", WRITERS["csv"](tabulate_scan(found)))
    return write_whole(target, page)


def _picture(figure: Figure, key: str) -> str:
    png = to_png_bytes(figure, 130)
    q = quantity(key)
    return f'<img alt="The scan coloured by {escape(q.name)}" src="data:image/png;base64,{b64encode(png).decode()}">'


def _numbers(found: ScanCurvature) -> str:
    inner = ~found.border if (~found.border).any() else np.ones_like(found.border)
    rows = [[_named(key, found), *_spread(found[key][inner])] for key in VALUES]
    return _table(["inside the border", *(f"{share} %" for share in _SHARES)], rows)


def _errors(found: ScanCurvature) -> str:
    inner = ~found.border if (~found.border).any() else np.ones_like(found.border)
    rows = [[_named(key, found), *_spread(found.errors[key][inner])] for key in VALUES]
    return _table(["error", *(f"{share} %" for share in _SHARES)], rows)


def _spread(values: Any) -> list[str]:
    finite = values[np.isfinite(values)]
    return [shown(float(x), 4) for x in np.percentile(finite, _SHARES)] if len(finite) else ["–"] * len(_SHARES)


def _named(key: str, found: ScanCurvature) -> str:
    q = quantity(key)
    unit = q.unit(found.scan.unit)
    return f"{q.name} {q.symbol}{f' ({unit})' if unit else ''}"


def _counts(found: ScanCurvature, key: str) -> str:
    counts = np.bincount(found[key], minlength=len(quantity(key).classes))
    rows = [
        [name, f"{count:,}", f"{100.0 * count / len(found[key]):.1f} %"]
        for name, count in zip(quantity(key).classes, counts.tolist(), strict=True)
        if count
    ]
    return _table(["class", "points", "share"], rows)


def _table(heading: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    head = "".join(f"<th>{escape(word)}</th>" for word in heading)
    lines = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><tr>{head}</tr>{lines}</table>"
