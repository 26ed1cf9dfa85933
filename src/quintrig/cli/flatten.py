"""``quintrig flatten``: the flat pattern of a developable surface, or of all patches of a model."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from quintrig.cli import session
from quintrig.cli.options import Face, ModelFile, WhichPatch, Whole

_EPILOG = session.examples(
    ("quintrig flatten duct.toml duct.dxf", "outline, bend lines, dimensions, on layers"),
    ("quintrig flatten duct.toml duct.dxf --thickness 1.5 --k-factor 0.42", "for sheet of 1.5"),
    ("quintrig flatten duct.toml duct.svg --sheet 2000x1000 --margin 10", "in parts that fit the sheet, with marks"),
    ("quintrig flatten part.step pattern.pdf --face 3", "a face of a CAD file, on a page at true scale"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, flatten, _EPILOG)


def flatten(
    model: ModelFile,
    output: Annotated[
        Path, typer.Argument(metavar="OUT", help="A name ending in .dxf, .svg or .pdf.", show_default=False)
    ],
    patch: WhichPatch = None,
    face: Face = None,
    whole: Whole = False,
    thickness: Annotated[float, typer.Option(metavar="LENGTH", help="Thickness of the sheet.")] = 0.0,
    k_factor: Annotated[
        float, typer.Option(metavar="K", help="Place of the neutral layer from the inside of a bend, share of it.")
    ] = 0.5,
    side: Annotated[
        Literal["middle", "back", "front"],
        typer.Option(help="Where the model is in the sheet, seen against its normal: its middle, or that face."),
    ] = "middle",
    step: Annotated[float, typer.Option(metavar="DEGREES", help="Largest bend at one line.")] = 5.0,
    sheet: Annotated[
        str | None, typer.Option(metavar="WxH", help="Split into parts that fit a sheet of this size.")
    ] = None,
    margin: Annotated[float, typer.Option(metavar="LENGTH", help="Kept free along the sheet's edges.")] = 0.0,
    chord: Annotated[
        float | None, typer.Option(metavar="LENGTH", help="Largest distance of the polygons from the true outline.")
    ] = None,
    distortion: Annotated[
        float, typer.Option(metavar="SHARE", help="Largest change of a length that still counts as none.")
    ] = 1e-9,
) -> None:
    """Unroll a developable surface into a pattern to cut from sheet, at true scale; all patches of a model on one page.

    The lengths of both boundaries, of all rulings and the area are compared with the surface and printed. A surface
    that is not developable is refused with what flattening would distort, and one whose edge of regression lies
    inside with the place where it does.
    """
    from quintrig.developables.unroll import Sheet
    from quintrig.exchange.pattern.flatten import FlattenOptions, export_pattern
    from quintrig.exchange.pattern.layout import PatternOptions
    from quintrig.support.files import refuse_loss

    stock = None if sheet is None else _size(sheet)
    drawing = PatternOptions(step, stock, margin)
    options = FlattenOptions(Sheet(thickness, k_factor, side), drawing, chord, distortion)
    loaded = session.load(model, face, whole)
    refuse_loss(output, model)
    replaced = output.is_file()
    several = patch is None and len(loaded.patches) > 1
    try:
        told = export_pattern(loaded.patches if several else loaded.patch(patch), loaded.unit, output, options)
    except ValueError as error:
        if several:
            raise ValueError(f"{error}; of several patches choose one by its name (--patch NAME)") from None
        raise
    for line in told:
        session.remark(line)
    session.wrote(output, replaced)


def _size(text: str) -> tuple[float, float]:
    """Read WxH; ValueError naming the option."""
    from quintrig.support.numerals import real

    words = text.lower().replace("×", "x").split("x")
    try:
        width, height = map(real, words)
    except ValueError:
        width = height = float("nan")
    if not (0.0 < width < float("inf") and 0.0 < height < float("inf")):
        raise ValueError(f"--sheet: expected width x height, such as 2000x1000, got {text[:60]!r}")
    return width, height
