"""A sweep on disk: a folder with a description and one Parquet file a part, each written whole and never twice."""

import hashlib
import json
import os
import shutil
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

import numpy as np

from quintrig.quantities.classify import Thresholds
from quintrig.support.arrays import FloatArray
from quintrig.support.errors import QuintrigError
from quintrig.support.extras import need
from quintrig.support.files import open_regular, refuse_unwritable, require_utf8, write_first, write_whole
from quintrig.support.parsing import parse
from quintrig.sweep.part import Task
from quintrig.sweep.space import DesignSpace

PART = 8192
"""Designs in a part: a second or two of work, 1.5 MB."""

_DESCRIPTION = "sweep.json"
_FORMAT = 3
_MAGIC = b"PAR1"  # at both ends of a Parquet file
_STALE = 60.0  # seconds after which a temporary file is that of a killed run: writing one takes a fraction of a second


@dataclass(frozen=True)
class Sweep:
    """A sweep in ``folder``; ``repaired`` names the files that were damaged when it was continued."""

    folder: Path
    task: Task
    repaired: tuple[str, ...] = ()

    @property
    def parts(self) -> int:
        """Number of parts in all."""
        return -(-self.task.space.count // PART)

    def missing(self) -> list[int]:
        """Return the numbers of the parts that are not there yet, or cut off."""
        return [part for part in range(self.parts) if not _sound(self._file(part))]

    def files(self) -> list[Path]:
        """Return the parts that are there."""
        return [file for file in map(self._file, range(self.parts)) if _sound(file)]

    def repair(self, strictly: bool = False) -> list[str]:
        """Remove the parts that cannot be read, and return their names; QuintrigError for one of another sweep.

        ``strictly`` where there is no description: then a part must itself say what sweep it is of.
        """
        damaged: list[str] = []
        for part in range(self.parts):
            file = self._file(part)
            if not file.exists():
                continue
            start, stop = self.span(part)
            found = _contents(file) if _sound(file) else None
            if found is None:
                file.unlink(missing_ok=True)
                damaged.append(file.name)
            elif found[0] != stop - start or ((found[1] or strictly) and found[1] != self.mark):
                raise QuintrigError(f"{file}: belongs to another sweep; choose another folder or delete it")
        return damaged

    @property
    def mark(self) -> str:
        """What tells the parts of this sweep from those of others."""
        return hashlib.sha256(_describe(self.task).encode()).hexdigest()

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
        if _sound(target):
            return
        names = self.task.columns
        # pyarrow carries no types.
        pa, pq = cast(Any, pyarrow), cast(Any, parquet)
        table = pa.table({name: np.ascontiguousarray(rows[:, i]) for i, name in enumerate(names)})
        sink = pa.BufferOutputStream()
        pq.write_table(table.replace_schema_metadata(self._notes()), sink, compression="zstd", write_page_checksum=True)
        try:
            write_whole(target, cast(bytes, sink.getvalue().to_pybytes()))
        except QuintrigError as error:
            raise QuintrigError(f"{error}; the parts written stay, and running it again goes on from them") from None

    def _notes(self) -> dict[str, str]:
        """Return what the file says of its columns: units, the normal, the length unit of the model."""
        unit = str(self.task.model.get("unit", ""))
        units = {f"unit of {name}": self.task.unit_of(name) for name in self.task.columns}
        return units | {"normal": self.task.side, "unit of length": unit, "sweep": self.mark}

    def _file(self, part: int) -> Path:
        return self.folder / f"part-{part:06d}.parquet"


def open_sweep(folder: Path, task: Task) -> Sweep:
    """Return the sweep of ``task`` in ``folder``, begun or continued; a damaged description or part is made anew.

    Raises QuintrigError where the folder holds another sweep or other files, cannot be written, or the disk is too
    small.
    """
    need("pyarrow", "a sweep")
    require_utf8(folder, "a folder")
    description = _describe(task)
    if folder.is_dir():
        _sweep_out(folder)
    place = folder / _DESCRIPTION
    if place.exists() or any(folder.glob("part-*.parquet")):
        try:
            found = _read(folder)
        except DamagedError:
            repaired = Sweep(folder, task).repair(strictly=True)
            write_whole(place, description)
            return Sweep(folder, task, (_DESCRIPTION, *repaired))
        if found != json.loads(description):
            raise QuintrigError(
                f"{folder}: holds another sweep (other model, ranges or settings); choose another folder or delete it"
            )
        return Sweep(folder, task, tuple(Sweep(folder, task).repair()))
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise QuintrigError(f"{folder}: expected a new or empty folder, or one with a sweep; choose another")
    refuse_unwritable(place)
    _check_disk(folder, task)
    # Of two that begin in one folder at the same moment, the second finds what the first has written.
    return Sweep(folder, task) if write_first(place, description) else open_sweep(folder, task)


class DamagedError(QuintrigError):
    """A description of a sweep that is cut off or overwritten."""


def _describe(task: Task) -> str:
    return json.dumps({"format": _FORMAT} | task.to_dict(), indent=1, sort_keys=True)


def _sound(file: Path) -> bool:
    """Return whether a part is there from its first to its last byte: an empty one or one cut off is not."""
    try:
        with file.open("rb") as part:
            head = part.read(4)
            part.seek(-8, os.SEEK_END)
            tail = part.read(8)
            length = part.tell()
    except OSError:
        return False
    return head == tail[4:] == _MAGIC and 12 + int.from_bytes(tail[:4], "little") <= length


def _contents(file: Path) -> tuple[int, str] | None:
    """Return the number of rows of a part and the mark of its sweep; None where its bytes are not what was written."""
    import pyarrow
    from pyarrow import parquet

    pa, pq = cast(Any, pyarrow), cast(Any, parquet)
    try:
        table = pq.read_table(file, page_checksum_verification=True, partitioning=None)
    except (pa.ArrowException, OSError):
        return None
    notes = cast(dict[bytes, bytes], table.schema.metadata or {})
    return int(table.num_rows), notes.get(b"sweep", b"").decode()


def load_sweep(folder: Path) -> Sweep:
    """Return the sweep that a folder holds; QuintrigError where there is none."""
    require_utf8(folder, "a folder")
    return Sweep(folder, _task(_read(folder)))


def _task(data: dict[str, Any]) -> Task:
    thresholds = Thresholds(float(data["relative"]), float(data["flat"]))
    space = DesignSpace.from_dict(data["space"])
    return Task(data["model"], data["patch"], space, int(data["points"]), thresholds)


def _sweep_out(folder: Path) -> None:
    """Remove the temporary files of a killed run."""
    for pattern in (".part-*.parquet.*", f".{_DESCRIPTION}.*"):
        for file in folder.glob(pattern):
            with suppress(OSError):  # another run may be at it too
                if time.time() - file.stat().st_mtime > _STALE:
                    file.unlink()


def _read(folder: Path) -> dict[str, Any]:
    place = folder / _DESCRIPTION
    try:
        with open_regular(place) as file:
            data = parse(file.read().decode("utf-8"), ".json")
    except FileNotFoundError:
        if any(folder.glob("part-*.parquet")):
            raise _damaged(place) from None
        raise QuintrigError(f"{folder}: holds no sweep ({_DESCRIPTION} is missing)") from None
    except (ValueError, RecursionError) as error:
        raise _damaged(place, f" ({error})") from None
    except OSError as error:
        raise QuintrigError(f"{place}: cannot be read ({error.strerror}); check the permissions") from None
    if not isinstance(data, dict):
        raise _damaged(place)
    found = cast(dict[str, Any], data)
    if found.get("format", _FORMAT) != _FORMAT:
        raise QuintrigError(f"{place}: is not a description of a sweep that this quintrig reads; choose another folder")
    try:
        _task(found)
    except (KeyError, TypeError, ValueError, AttributeError):
        raise _damaged(place) from None
    return found


def _damaged(place: Path, why: str = "") -> DamagedError:
    return DamagedError(f"{place}: is damaged{why}; give the command that began the sweep again, which repairs it")


def _check_disk(folder: Path, task: Task) -> None:
    """Raise QuintrigError where the rows, uncompressed, would not fit the disk."""
    needed = task.space.count * len(task.columns) * 8
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
