"""Figures to bytes and files: PNG, SVG, PDF and EPS, the same bytes each time from the same figure."""

import io
import logging
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib
from matplotlib.figure import Figure

from quintrig.figure.sheet import ONE_AT_A_TIME
from quintrig.support.errors import ArgumentError, QuintrigError
from quintrig.support.files import write_whole

KINDS = ("png", "svg", "pdf", "eps")
"""Kinds of file, by suffix."""

DPI = 200
"""Dots per inch of PNG files and of the shaded surfaces inside SVG and PDF."""

_SETTINGS = {"svg.hashsalt": "quintrig", "svg.fonttype": "path", "pdf.fonttype": 42, "ps.fonttype": 42}
"""Fonts in PDF and EPS are TrueType: publishers refuse matplotlib's usual Type 3."""

_UNDATED: dict[str, dict[str, None]] = {
    "png": {"Software": None},
    "svg": {"Date": None},
    "pdf": {"CreationDate": None},
    "eps": {},
}


def save(figure: Figure, path: str | Path, dpi: int = DPI) -> Path:
    """Write a figure to a file, whole or not at all, in the kind its suffix names.

    Raises QuintrigError for another suffix, or where the file cannot be written.
    """
    kind = kind_of(path)
    return write_whole(path, to_bytes(figure, kind, dpi))


def kind_of(path: str | Path) -> str:
    """Return the kind of file a suffix names; QuintrigError for one that is not known."""
    suffix = Path(path).suffix.lower()
    if suffix.removeprefix(".") not in KINDS:
        found = f"the suffix {suffix!r}" if suffix else "no suffix"
        known = ", ".join(f".{kind}" for kind in KINDS)
        raise QuintrigError(f"{path}: expected a file name ending in {known}, found {found}; choose one of them")
    return suffix.removeprefix(".")


def formats_of(words: Sequence[str]) -> tuple[str, ...]:
    """Return the kinds of file that words such as ``png`` or ``.PDF`` name, each once; ValueError for others."""
    found = tuple(dict.fromkeys(word.strip().lower().lstrip(".") for word in words if word.strip()))
    for form in found:
        if form not in KINDS:
            raise ArgumentError(f"expected some of {', '.join(KINDS)}, found {form[:40]!r}", "figures")
    return found


def to_bytes(figure: Figure, kind: str, dpi: int = DPI) -> bytes:
    """Return a figure as a file's content; ``kind`` is png, svg, pdf or eps."""
    if kind not in KINDS:
        raise ValueError(f"kind: expected {', '.join(KINDS)}, found {kind!r}")
    buffer = io.BytesIO()
    drawn: Any = figure  # its stubs leave arguments untyped
    library: Any = matplotlib
    # The lock also guards matplotlib's global settings, through which identifiers in SVG are set.
    with ONE_AT_A_TIME, library.rc_context(_SETTINGS), _opaque():
        drawn.savefig(buffer, format=kind, dpi=dpi, metadata=_UNDATED[kind])
    return buffer.getvalue()


@contextmanager
def _opaque() -> Generator[None]:
    """Keep back what matplotlib tells a user of EPS, that thin lines and halos are opaque there, as they may be."""
    told = logging.getLogger("matplotlib.backends.backend_ps")
    before = told.level
    told.setLevel(logging.ERROR)
    try:
        yield
    finally:
        told.setLevel(before)


def to_png_bytes(figure: Figure, dpi: int = DPI) -> bytes:
    """Return a figure as PNG."""
    return to_bytes(figure, "png", dpi)


def to_svg_text(figure: Figure, dpi: int = DPI) -> str:
    """Return a figure as SVG text, its surfaces as pictures of ``dpi``, its text as outlines."""
    return to_bytes(figure, "svg", dpi).decode()
