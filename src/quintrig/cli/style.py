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
}


def with_style(command: Callable[..., None]) -> Callable[..., None]:
    """Return a command that takes the options of pictures too, and gets them as one ``style``."""
    plain = inspect.signature(command)
    kept = [p for name, p in plain.parameters.items() if name != "style"]
    added = [
        inspect.Parameter(
            name,
            inspect.Parameter.KEYWORD_ONLY,
            default=default,
            annotation=Annotated[kind, typer.Option(*flags, metavar=metavar, help=text, rich_help_panel="Pictures")],
        )
        for name, (kind, default, flags, metavar, text) in _OPTIONS.items()
    ]

    @wraps(command)
    def styled(*arguments: Any, **options: Any) -> None:
        chosen = {name: options.pop(name) for name in _OPTIONS}
        command(*arguments, style=_style(**chosen), **options)

    styled.__signature__ = plain.replace(parameters=[*kept, *added])  # pyright: ignore[reportFunctionMemberAccess, reportAttributeAccessIssue]
    styled.__annotations__ = {p.name: p.annotation for p in (*kept, *added)}
    return styled


def _style(
    style: str,
    title: bool | None,
    caption: bool | None,
    limits: str | None,
    percentiles: str | None,
    colours: str | None,
    levels: str | None,
    font: str | None,
    size: float | None,
) -> "Style":
    from quintrig.figure.style import changed, style_named

    return changed(
        style_named(style),
        title=title,
        caption=caption,
        limits=limits and session.numbers(limits, 2, "--range"),
        percentiles=percentiles and session.numbers(percentiles, 2, "--percentiles"),
        colours=colours,
        levels=_levels(levels),
        font=font,
        size=size,
    )


def _levels(text: str | None) -> int | tuple[float, ...] | None:
    if text is None:
        return None
    return int(text) if text.strip().isdigit() else session.numbers(text, None, "--levels")
