"""``quintrig grid``: quantities on a grid of any size, to Zarr or Parquet."""

from pathlib import Path
from typing import Annotated

import typer

from quintrig.cli import session
from quintrig.cli.options import Face, ModelFile, WhichPatch

_EPILOG = session.examples(
    ("quintrig grid lid.toml lid.zarr --size 4000x4000", "K and H at 16 million points"),
    ("quintrig grid lid.toml lid.parquet --size 30000 -q gaussian,hk_type", "900 million rows, in constant memory"),
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    session.add(app, grid, _EPILOG)


def grid(
    model: ModelFile,
    output: Annotated[
        Path, typer.Argument(metavar="OUT", help="A name ending in .zarr or .parquet.", show_default=False)
    ],
    size: Annotated[str, typer.Option(metavar="NUxNV", help="Points in u and v, edges included.")] = "1000x1000",
    quantities: Annotated[
        str, typer.Option("-q", "--quantities", metavar="KEYS", help="Such as gaussian,mean,hk_type.")
    ] = "gaussian,mean",
    patch: WhichPatch = None,
    face: Face = None,
) -> None:
    """Compute quantities on a grid of any size, in constant memory.

    The file or folder appears when it is complete. Units are written beside the data.
    """
    from quintrig.support.errors import QuintrigError

    if output.suffix not in (".zarr", ".parquet"):
        raise QuintrigError(f"{output}: expected a name ending in .zarr or .parquet")
    nu, nv = session.counts(size, "--size")
    loaded = session.load(model, face)
    surface = loaded.patch(patch).surface
    keys = [word.strip() for word in quantities.split(",")]
    from quintrig.analysis.stream import write_parquet, write_zarr

    replaced = output.exists()
    write = write_zarr if output.suffix == ".zarr" else write_parquet
    with session.progress() as show:
        written = write(
            surface, output, nu, nv, keys, unit=loaded.unit, progress=lambda done, total: show("rows", done, total)
        )
    if surface.trim:
        session.remark("the face is trimmed; the grid is of its whole surface")
    session.wrote(written, replaced)
