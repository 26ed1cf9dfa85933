"""What is said to be written is on the disk: files, and the folders that name them, survive a loss of power."""

import os
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO


def flush(file: BinaryIO) -> None:
    """Wait until what was written to an open file is on the disk; OSError where the disk fails."""
    file.flush()
    os.fsync(file.fileno())


def make_folder(folder: Path) -> None:
    """Make a folder and the parents that are missing, and wait until their names are on the disk."""
    new = [place for place in (folder, *folder.parents) if not place.exists()]
    folder.mkdir(parents=True, exist_ok=True)
    for place in new:
        settle(place.parent)


def settle(folder: Path) -> None:
    """Wait until the names in a folder are on the disk, where the system knows how; not on Windows."""
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
