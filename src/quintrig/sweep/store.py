"""A sweep on disk: a folder with a description and one Parquet file a part, each written whole and never twice."""

import json
import shutil
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np

from quintrig.arrays import FloatArray
from quintrig.classify import Thresholds
from quintrig.errors import QuintrigError
from quintrig.files import refuse_unwritable, require, require_utf8, write_first, write_whole
from quintrig.integrate import orientation
from quintrig.parsing import parse
from quintrig.sweep.part import Task, column_unit, columns
from quintrig.sweep.space import DesignSpace

PART = 8192
"""Designs in a part: a second or two of work, 1.5 MB."""

_DESCRIPTION = "sweep.json"
_FORMAT = 3
_STALE = 60.0  # seconds after which a temporary file is that of a killed run: writing one takes a fraction of a second


@dataclass(frozen=True)
class Sweep:
    """A sweep in ``folder``."""

    folder: Path
    task: Task

    @property
    def parts(self) -> int:
        """Number of parts in all."""
        return -(-self.task.space.count // PART)

    def missing(self) -> list[int]:
        """Return the numbers of the parts that are not there yet."""
        return [part for part in range(self.parts) if not self._file(part).exists()]

    def files(self) -> list[Path]:
        """Return the parts that are there."""
        return [file for file in map(self._file, range(self.parts)) if file.exists()]

    def span(self, part: int) -> tuple[int, int]:
        """Return the numbers of the first design of a part and of the one after its last."""
        return part * PART, min((part + 1) * PART, self.task.space.count)

    def write(self, part: int, rows: FloatArray) -> None:
        """Write a part; a file that is already there is kept. Raises QuintrigError for a full disk and the like.

        Beside the columns the file says their units and which way the normal points.
        """
        import pyarrow
        from pyarrow import parquet

        target = self._file(part)
        if target.exists():
            return
        names = columns(self.task.space)
        # pyarrow carries no types.
        pa, pq = cast(Any, pyarrow), cast(Any, parquet)
        table = pa.table({name: np.ascontiguousarray(rows[:, i]) for i, name in enumerate(names)})
        sink = pa.BufferOutputStream()
        pq.write_table(table.replace_schema_metadata(self._notes()), sink, compression="zstd")
        try:
            write_whole(target, cast(bytes, sink.getvalue().to_pybytes()))
        except QuintrigError as error:
            raise QuintrigError(f"{error}; the parts written stay, and the same command goes on from them") from None

    def _notes(self) -> dict[str, str]:
        """Return what the file says of its columns: units, the normal, the length unit of the model."""
        unit = str(self.task.model.get("unit", ""))
        units = {f"unit of {name}": column_unit(name, unit) for name in columns(self.task.space)}
        return units | {"normal": orientation(self.task.built().surface), "unit of length": unit}

    def _file(self, part: int) -> Path:
        return self.folder / f"part-{part:06d}.parquet"


def open_sweep(folder: Path, task: Task) -> Sweep:
    """Return the sweep of ``task`` in ``folder``, begun or continued.

    Raises QuintrigError where the folder holds another sweep or other files, cannot be written, or the disk is too
    small.
    """
    require("pyarrow", "sweep")
    require_utf8(folder, "a folder")
    description = json.dumps({"format": _FORMAT} | task.to_dict(), indent=1, sort_keys=True)
    if folder.is_dir():
        _sweep_out(folder)
    if (folder / _DESCRIPTION).exists():
        if _read(folder) != json.loads(description):
            raise QuintrigError(
                f"{folder}: holds another sweep (other model, ranges or settings); choose another folder or delete it"
            )
        return Sweep(folder, task)
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise QuintrigError(f"{folder}: expected a new or empty folder, or one with a sweep; choose another")
    refuse_unwritable(folder / _DESCRIPTION)
    _check_disk(folder, task)
    # Of two that begin in one folder at the same moment, the second finds what the first has written.
    return Sweep(folder, task) if write_first(folder / _DESCRIPTION, description) else open_sweep(folder, task)


def load_sweep(folder: Path) -> Sweep:
    """Return the sweep that a folder holds; QuintrigError where there is none."""
    require_utf8(folder, "a folder")
    data = _read(folder)
    thresholds = Thresholds(float(data["relative"]), float(data["flat"]))
    space = DesignSpace.from_dict(data["space"])
    return Sweep(folder, Task(data["model"], data["patch"], space, int(data["points"]), thresholds))


def _sweep_out(folder: Path) -> None:
    """Remove the temporary files of a killed run."""
    for pattern in (".part-*.parquet.*", f".{_DESCRIPTION}.*"):
        for file in folder.glob(pattern):
            with suppress(OSError):  # another run may be at it too
                if time.time() - file.stat().st_mtime > _STALE:
                    file.unlink()


def _read(folder: Path) -> dict[str, Any]:
    try:
        data = parse((folder / _DESCRIPTION).read_text(encoding="utf-8"), ".json")
    except FileNotFoundError:
        raise QuintrigError(f"{folder}: holds no sweep ({_DESCRIPTION} is missing)") from None
    except (OSError, ValueError) as error:
        place = folder / _DESCRIPTION
        raise QuintrigError(f"{place}: cannot be read ({error}); delete the folder and start anew") from None
    if not isinstance(data, dict) or cast(dict[str, Any], data).get("format") != _FORMAT:
        raise QuintrigError(f"{folder / _DESCRIPTION}: is not a description of a sweep that this quintrig reads")
    return cast(dict[str, Any], data)


def _check_disk(folder: Path, task: Task) -> None:
    """Raise QuintrigError where the rows, uncompressed, would not fit the disk."""
    needed = task.space.count * len(columns(task.space)) * 8
    place = folder.absolute()
    while not place.exists():
        place = place.parent
    free = shutil.disk_usage(place).free
    if needed > free:
        raise QuintrigError(
            f"{folder}: {task.space.count:,} designs need up to {_size(needed)}, {_size(free)} are free; "
            "take fewer values or another disk"
        )


def _size(count: int) -> str:
    """Return a number of bytes in words."""
    power = max((p for p in (0, 3, 6, 9) if count >= 10**p), default=0)
    return f"{count / 10**power:.3g} {('bytes', 'kB', 'MB', 'GB')[power // 3]}"
