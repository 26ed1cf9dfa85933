"""``quintrig plot``: pictures of a model."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from quintrig.cli import session
from quintrig.cli.options import Face, Listing, ModelFile, OnlyPatch, Whole
from quintrig.cli.scans import Degree, Neighbours, ScanUnit, is_scan
from quintrig.cli.scans import draw as draw_scan
from quintrig.cli.style import with_style

if TYPE_CHECKING:
    from quintrig.figure.style import Style
    from quintrig.model.model import Model

_WIDTH = 8  # inches
_EPILOG = session.examples(
    ("quintrig plot lid.toml -o lid.png", "the surface, seen obliquely, with its normal"),
    ("quintrig plot lid.toml -o lid.png --net", "with its control net"),
    ("quintrig plot lid.toml -q gaussian -o k.pdf --view flat", "a map of K over (u, v), with the line K = 0"),
    ("quintrig plot lid.toml -q surface,gaussian,mean -o lid.svg", "three pictures side by side"),
    ("quintrig plot lid.toml -q mean --view 30,20 -o h.png", "seen from azimuth 30°, elevation 20°"),
    ("quintrig plot lid.toml --lines curvature -o lines.png", "with a net of lines of curvature"),
    ("quintrig plot scan.ply -q mean -o h.png", "a scan, coloured by the curvature of its points"),
    ("quintrig plot lid.toml -q K --animate alpha1=-4:1 -o k.gif", "a moving picture: what a shape parameter does"),
    ("quintrig plot lid.toml --view all -o lid.png", "side, back and top view"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, with_style(plot), _EPILOG)


def plot(
    model: ModelFile,
    output: Annotated[
        Path,
        typer.Option(
            "-o",
            "--output",
            metavar="FILE",
            help="Picture to write: .png, .svg, .pdf or .eps; .gif or .mp4 with --animate.",
            show_default=False,
        ),
    ],
    quantities: Annotated[
        str,
        typer.Option(
            "-q", "--quantities", metavar="KEYS", help="What to colour by, such as gaussian,mean; --list shows all."
        ),
    ] = "surface",
    view: Annotated[
        str | None,
        typer.Option(
            metavar="VIEW",
            help="iso, side, back, top, all (side, back and top), flat, or AZIMUTH,ELEVATION.",
            show_default="iso",
            rich_help_panel="Pictures",
        ),
    ] = None,
    shape: Annotated[
        str | None, typer.Option(metavar="NUMBERS", help="Other shape parameters, such as 1,1,-3,-3.")
    ] = None,
    patch: OnlyPatch = None,
    animate: Annotated[
        str | None,
        typer.Option(metavar="NAME=LOW:HIGH", help="A shape parameter that runs over a range, such as alpha1=-4:1."),
    ] = None,
    frames: Annotated[int | None, typer.Option(metavar="N", help="Frames of an animation; 40 if not said.")] = None,
    listing: Listing = False,
    face: Face = None,
    whole: Whole = False,
    unit: ScanUnit = "",
    neighbours: Neighbours = None,
    degree: Degree = None,
    style: "Style | None" = None,
) -> None:
    """Draw a model in space, with true proportions, or as flat maps over its parameters.

    One picture a quantity, each with its scale; surface stands for the plain surface.

    Of a scan (.csv .xyz .ply .obj .stl) the colours show the curvature of its points themselves.

    Of a model of curves, -q takes curve, comb, hull, curvature or torsion; the last two run over arc length where the
    curves go on end to end. Curves beside surfaces are drawn with them.
    """
    if is_scan(model):
        if animate is not None or shape is not None or patch is not None or frames is not None:
            raise ValueError("--animate, --frames, --shape and --patch: belong to models, and this is a scan")
        draw_scan(model, output, quantities, view, style, unit, neighbours, degree)
        return
    loaded = session.load_any(model, face, whole)
    chosen = _chosen(loaded, patch, shape)
    from quintrig.figure.plot import plot as draw
    from quintrig.figure.save import DPI, kind_of, save
    from quintrig.figure.style import STANDARD
    from quintrig.support.files import refuse_unwritable

    words, style = session.words(quantities), style or STANDARD
    if animate is not None:
        if style.at:
            raise ValueError("--at: marks no point of a moving surface; leave it out, or --animate")
        _film(chosen, animate, frames, output, words, {"view": view, "style": style, "width": style.width or _WIDTH})
        return
    if frames is not None:
        raise ValueError("--frames: are those of an animation; add --animate NAME=LOW:HIGH")
    if output.suffix.lower() in (".gif", ".mp4"):
        raise ValueError(f"{output}: expected a file name ending in .png, .svg, .pdf, .eps, or --animate for a film")
    kind_of(output)
    refuse_unwritable(output)
    figure = draw(chosen, words, view=view, style=style, width=style.width or _WIDTH)
    replaced = output.is_file()
    session.wrote(save(figure, output, style.dpi or DPI), replaced)


def _film(
    model: "Model", text: str, frames: int | None, output: Path, words: list[str], look: "dict[str, Any]"
) -> None:
    """Write an animation, with progress."""
    from quintrig.figure.animate import animate

    name, given, rest = (part.strip() for part in text.partition("="))
    low = high = None
    if given:
        parts = rest.split(":")
        if len(parts) != 2:
            raise ValueError(f"--animate: expected NAME=LOW:HIGH, such as alpha1=-4:1, got {text[:60]!r}")
        low, high = session.numbers(",".join(parts), 2, "--animate")
    replaced = output.is_file()
    with session.progress() as progress:
        animate(
            model,
            name,
            low,
            high,
            quantity=words,
            frames=40 if frames is None else frames,
            processes=None,
            progress=progress,
            save=output,
            **look,
        )
    session.wrote(output, replaced)


def _chosen(model: "Model", name: str | None, shape: str | None) -> "Model":
    """Return the model with the part of this name alone, or all of it, with other shape parameters if asked for."""
    one = session.only(model, name)
    return one if shape is None else one.with_shape(session.numbers(shape, None, "--shape"))
