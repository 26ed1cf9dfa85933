"""What writing needs: files whole or not at all, and packages that may be missing."""

import os
import tempfile
from collections.abc import Generator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

from quintrig.errors import QuintrigError


def write_whole(path: str | Path, data: bytes | str) -> Path:
    """Write ``data`` (text as UTF-8) to ``path`` through a temporary file beside it, and return the path.

    An existing file is replaced in one step or kept. Missing parent folders are made. Raises QuintrigError, naming the
    path and the remedy, when it cannot be written.
    """
    target = Path(path)
    with _draft(target, data) as draft:
        draft.replace(target)
    return target


def write_first(path: Path, data: bytes | str) -> bool:
    """Write a new file as ``write_whole`` does; False, and nothing done, where another process was there first."""
    with _draft(path, data) as draft:
        try:
            os.link(draft, path)
        except FileExistsError:
            return False
        except OSError:  # a file system without links: two processes at the same instant write one after the other
            if path.exists():
                return False
            draft.replace(path)
    return True


@contextmanager
def _draft(target: Path, data: bytes | str) -> Generator[Path]:
    """Give a temporary file beside the target with the data in it, and remove it if it is still there at the end."""
    if target.is_dir():
        raise QuintrigError(f"{target}: expected the name of a file to write, found a folder; add a file name")
    temporary = ""
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(data.encode() if isinstance(data, str) else data)
        Path(temporary).chmod(0o666 & ~_umask())
        yield Path(temporary)
    except OSError as error:
        raise _refusal(target, error) from None
    finally:
        if temporary:
            Path(temporary).unlink(missing_ok=True)


def refuse_unwritable(path: str | Path) -> None:
    """Raise the QuintrigError of ``write_whole`` where it would fail, before long work whose result goes there."""
    target = Path(path)
    if target.is_dir():
        raise QuintrigError(f"{target}: expected the name of a file to write, found a folder; add a file name")
    there = next(folder for folder in target.absolute().parents if folder.exists())
    try:
        with tempfile.TemporaryFile(dir=there):
            pass
    except OSError as error:
        raise _refusal(target, error) from None


def _refusal(target: Path, error: OSError) -> QuintrigError:
    reason = error.strerror or str(error)
    if isinstance(error, (FileExistsError, NotADirectoryError)):
        reason = "a part of the path is a file, not a folder"
    return QuintrigError(f"{target}: cannot be written ({reason}); choose another place or free it")


def require(package: str, extra: str) -> None:
    """Raise QuintrigError with the command that installs an optional package, where it is missing."""
    if find_spec(package) is None:
        raise QuintrigError(f"this needs {package}, which is not installed: run pip install 'quintrig[{extra}]'")


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
