"""Analysis of grids of any size in constant memory: block by block, to Zarr or Parquet as it goes."""

import shutil
import tempfile
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from quintrig.analysis.integrate import orientation
from quintrig.analysis.sample import Sample, analyse
from quintrig.geometry.surface import Surface
from quintrig.quantities.classify import Thresholds
from quintrig.quantities.table import BY_KEY, quantity
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import need
from quintrig.support.progress import Counted, watched

_POINTS = 2**18  # points in a block: with all quantities 100 MB, with K and H 4 MB
_WIDEST = 2**24  # points in one row


@dataclass(frozen=True)
class Block:
    """Rows ``start`` to ``stop`` of a grid of ``nu`` x ``nv`` points, as a sample of shape (stop - start, nv)."""

    start: int
    stop: int
    sample: Sample


def analyse_blocks(
    surface: Surface,
    nu: int,
    nv: int,
    quantities: Iterable[str] | str = ("gaussian", "mean"),
    *,
    thresholds: Thresholds | None = None,
    threads: int | None = None,
) -> Iterator[Block]:
    """Yield the grid of nu x nv parameters, edges included, in blocks of rows: together, ``analyse`` of the whole.

    Memory is that of one block, whatever the size of the grid. Raises ValueError for counts below 2 or unknown keys.
    """
    keys = _keys(quantities)
    for name, count, most in (("nu", nu, 10**12), ("nv", nv, _WIDEST)):
        if not 2 <= count <= most:
            raise ValueError(f"{name}: expected 2 to {most:,} points, found {count:,}")
    return _blocks(surface, nu, nv, keys, thresholds, threads)


def _keys(quantities: Iterable[str] | str) -> tuple[str, ...]:
    """Return the keys that names and symbols stand for, each once."""
    names = [quantities] if isinstance(quantities, str) else quantities
    return tuple(dict.fromkeys(quantity(name).key for name in names))


@watched
def write_zarr(
    surface: Surface,
    out: Path,
    nu: int,
    nv: int,
    quantities: Iterable[str] | str = ("gaussian", "mean"),
    *,
    unit: str = "",
    thresholds: Thresholds | None = None,
    progress: Counted | None = None,
) -> Path:
    """Write a Zarr group with an array (nu, nv) or (nu, nv, 3) for each quantity, its name and unit beside it.

    Arrays ``u`` (nu,) and ``v`` (nv,) hold the parameters, the group's attributes say which way the normal points. The
    folder appears whole when all is done. Raises QuintrigError where Zarr is missing or ``out`` cannot be written.
    """
    need("zarr", "writing Zarr")
    import zarr

    keys = _keys(quantities)
    blocks = analyse_blocks(surface, nu, nv, keys, thresholds=thresholds)

    def fill(folder: Path) -> None:
        group: Any = cast(Any, zarr).open_group(str(folder), mode="w", attributes=_notes(surface, thresholds, unit))
        group.create_array("v", data=np.linspace(0.0, 1.0, nv))
        places: Any = group.create_array("u", shape=(nu,), chunks=(min(nu, _POINTS),), dtype="float64")
        arrays: dict[str, Any] = {}
        for key in keys:
            q = BY_KEY[key]
            tail = (3,) if q.components == 3 else ()
            arrays[key] = group.create_array(
                key,
                shape=(nu, nv, *tail),
                chunks=(min(nu, _rows(nv)), nv, *tail),
                dtype="int8" if q.kind == "class" else "float64",
                attributes={"name": q.name, "symbol": q.symbol, "unit": q.unit(unit), "classes": list(q.classes)},
            )
        for block in blocks:
            places[block.start : block.stop] = block.sample.u[:, 0]
            for key, array in arrays.items():
                array[block.start : block.stop] = block.sample[key]
            if progress:
                progress(block.stop, nu)

    return _whole_folder(out, fill)


@watched
def write_parquet(
    surface: Surface,
    out: Path,
    nu: int,
    nv: int,
    quantities: Iterable[str] | str = ("gaussian", "mean"),
    *,
    unit: str = "",
    thresholds: Thresholds | None = None,
    progress: Counted | None = None,
) -> Path:
    """Write a Parquet file with a row a point: u, v and a column for each quantity, three for a vector.

    The file appears whole when all is done. Raises QuintrigError where pyarrow is missing or ``out`` cannot be written.
    """
    need("pyarrow", "writing Parquet", "stream")
    import pyarrow
    from pyarrow import parquet

    pa, pq = cast(Any, pyarrow), cast(Any, parquet)  # pyarrow carries no types
    keys = _keys(quantities)
    blocks = analyse_blocks(surface, nu, nv, keys, thresholds=thresholds)
    v = np.linspace(0.0, 1.0, nv)

    def fill(file: Path) -> None:
        writer: Any = None
        sink = file.open("wb")  # pyarrow takes no name that is not UTF-8
        try:
            for block in blocks:
                shape = block.sample.shape
                columns = {"u": np.broadcast_to(block.sample.u, shape), "v": np.broadcast_to(v, shape)}
                columns |= _columns(block.sample, keys)
                table = pa.table({name: np.ascontiguousarray(values).reshape(-1) for name, values in columns.items()})
                if writer is None:
                    units = {f"unit of {key}": BY_KEY[key].unit(unit) for key in keys}
                    units |= _notes(surface, thresholds, unit)
                    writer = pq.ParquetWriter(sink, table.schema.with_metadata(units), compression="zstd")
                writer.write_table(table.cast(writer.schema))
                if progress:
                    progress(block.stop, nu)
        finally:
            if writer is not None:
                writer.close()
            sink.close()

    return _whole_file(out, fill)


def _blocks(
    surface: Surface, nu: int, nv: int, keys: tuple[str, ...], thresholds: Thresholds | None, threads: int | None
) -> Iterator[Block]:
    v = np.linspace(0.0, 1.0, nv)[None, :]
    for start in range(0, nu, _rows(nv)):
        stop = min(start + _rows(nv), nu)
        # As linspace computes them, without holding all of them; the last is exactly 1.
        u = np.arange(start, stop) * (1.0 / (nu - 1))
        u = np.where(np.arange(start, stop) == nu - 1, 1.0, u)
        yield Block(start, stop, analyse(surface, u[:, None], v, keys, thresholds=thresholds, threads=threads))


def _notes(surface: Surface, thresholds: Thresholds | None, unit: str) -> dict[str, str]:
    """Return what a reader must know of all quantities."""
    words = (thresholds or Thresholds()).describe(surface.size, unit) if surface.size > 0.0 else ""
    region = {"region": "the whole surface that the trimmed face is cut from"} if surface.trim else {}
    return {"normal": orientation(surface), "unit of length": unit, "thresholds": words} | region


def _rows(nv: int) -> int:
    """Return how many rows of nv points make a block."""
    return max(1, _POINTS // nv)


def _columns(sample: Sample, keys: tuple[str, ...]) -> dict[str, NDArray[Any]]:
    result: dict[str, NDArray[Any]] = {}
    for key in keys:
        if BY_KEY[key].components == 1:
            result[key] = sample[key]
        else:
            result |= {f"{key}_{axis}": sample[key][..., i] for i, axis in enumerate("xyz")}
    return result


def _whole_folder(out: Path, fill: Callable[[Path], None]) -> Path:
    """Let ``fill`` write a folder beside ``out`` and put it in its place when it is complete."""
    if out.exists() and not (out / "zarr.json").exists():
        raise QuintrigError(f"{out}: exists and is no Zarr group; choose another name or remove it")
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=out.parent, prefix=f".{out.name}.") as place:
            fill(Path(place) / "new")
            if out.exists():
                out.rename(Path(place) / "old")
            (Path(place) / "new").rename(out)
    except OSError as error:
        raise QuintrigError(f"{out}: cannot be written ({error.strerror or error}); choose another place") from None
    return out


def _whole_file(out: Path, fill: Callable[[Path], None]) -> Path:
    """Let ``fill`` write a file beside ``out`` and put it in its place when it is complete."""
    if out.is_dir():
        raise QuintrigError(f"{out}: expected the name of a file to write, found a folder; add a file name")
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
        place = Path(tempfile.mkdtemp(dir=out.parent, prefix=f".{out.name}."))
        try:
            fill(place / "new")
            (place / "new").replace(out)
        finally:
            shutil.rmtree(place, ignore_errors=True)
    except OSError as error:
        raise QuintrigError(f"{out}: cannot be written ({error.strerror or error}); choose another place") from None
    return out
