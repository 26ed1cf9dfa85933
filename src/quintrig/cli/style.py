"""The options by which every command that draws lets one choose how its pictures look."""

import inspect
from collections.abc import Callable
from functools import wraps
from typing import TYPE_CHECKING, Annotated, Any

import typer

from quintrig.cli import session

if TYPE_CHECKING:
    from quintrig.figure.style import Style

_OPTIONS: dict[str, Any] = {
    "style": (str, "standard", ("--style",), "NAME", "standard, or journal: serif letters, no titles, no notes."),
    "title": (bool | None, None, ("--title/--no-title",), None, "Set the title."),
    "caption": (bool | None, None, ("--caption/--no-caption",), None, "Set the note below: normal, unit, warnings."),
    "limits": (str | None, None, ("--range",), "LOW,HIGH", "Ends of the colour scale."),
    "percentiles": (str | None, None, ("--percentiles",), "LOW,HIGH", "Stretch colours between these, such as 2,98."),
    "colours": (str | None, None, ("--colours",), "MAP", "A colour map of matplotlib, such as viridis."),
    "levels": (
        str | None,
        None,
        ("--levels",),
        "N or VALUES",
        "Contour lines: how many, or the values.",
    ),
    "font": (str | None, None, ("--font",), "FAMILY", "Family of the letters, such as DejaVu Serif."),
    "size": (float | None, None, ("--font-size",), "POINTS", "Size of the numbers in points."),
    "width": (
        str | None,
        None,
        ("--width",),
        "WIDTH",
        "Width: inches, or such as 84mm, column or page (84 and 174 mm).",
    ),
    "dpi": (int | None, None, ("--dpi",), "N", "Dots per inch of a .png, 30 to 600."),
    "view": (str | None, None, ("--view",), "VIEW", "iso, side, back, top, or AZIMUTH,ELEVATION."),
    "net": (bool | None, None, ("--net/--no-net",), None, "Draw the control net."),
    "lines": (
        str | None,
        None,
        ("--lines",),
        "N|KIND",
        "Number of parameter lines each way, or a kind of `quintrig lines`.",
    ),
    "at": (list[str] | None, None, ("--at",), "U,V", "Mark a point of the surface. Repeatable."),
    "quantities": (str | None, None, ("-q", "--quantities"), "KEYS", "What the pictures show, such as K,H."),
}


def with_style(command: Callable[..., None]) -> Callable[..., None]:
    """Return a command that takes the options of pictures too, and gets them as one ``style``.

    Those of its own of the same name stay its own.
    """
    plain = inspect.signature(command)
    kept = [p for name, p in plain.parameters.items() if name != "style"]
    taken = {name: option for name, option in _OPTIONS.items() if name not in plain.parameters or name == "style"}
    added = [
        inspect.Parameter(
            name,
            inspect.Parameter.KEYWORD_ONLY,
            default=default,
            annotation=Annotated[kind, typer.Option(*flags, metavar=metavar, help=text, rich_help_panel="Pictures")],
        )
        for name, (kind, default, flags, metavar, text) in taken.items()
    ]

    @wraps(command)
    def styled(*arguments: Any, **options: Any) -> None:
        chosen = {name: options.pop(name) for name in taken}
        command(*arguments, style=_style(**chosen), **options)

    styled.__signature__ = plain.replace(parameters=[*kept, *added])  # pyright: ignore[reportFunctionMemberAccess, reportAttributeAccessIssue]
    styled.__annotations__ = {p.name: p.annotation for p in (*kept, *added)}
    return styled


def _style(style: str, **given: Any) -> "Style | None":
    """Return the style that is asked for, None where nothing is: then matplotlib is not imported for it."""
    if style == "standard" and not any(value is not None for value in given.values()):
        return None
    from quintrig.figure.style import changed, style_named
    from quintrig.quantities.drawn import read_quantities

    words = session.words(given.pop("quantities", None))
    read: dict[str, Callable[[Any], Any]] = {
        "limits": lambda text: session.numbers(text, 2, "--range"),
        "percentiles": lambda text: session.numbers(text, 2, "--percentiles"),
        "levels": _levels,
        "lines": lines_of,
        "at": lambda texts: tuple(session.numbers(text, 2, "--at") for text in texts) or None,
    }
    chosen = {name: read[name](value) if name in read and value else value for name, value in given.items()}
    keys = tuple(key or "surface" for key in read_quantities(words)) or None
    return changed(style_named(style), quantities=keys, **chosen)


def lines_of(text: str) -> int | str:
    """Return a number of lines, or the name of a kind."""
    return int(text) if text.lstrip("-+").isdecimal() else text


def _levels(text: str) -> int | tuple[float, ...]:
    return int(text) if text.strip().isdigit() else session.numbers(text, None, "--levels")
