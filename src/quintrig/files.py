"""What writing needs: files whole or not at all, and packages that may be missing."""

import os
import tempfile
from importlib.util import find_spec
from pathlib import Path

from quintrig.errors import QuintrigError


def write_whole(path: str | Path, data: bytes | str) -> Path:
    """Write ``data`` (text as UTF-8) to ``path`` through a temporary file beside it, and return the path.

    An existing file is replaced in one step or kept. Missing parent folders are made. Raises QuintrigError, naming the
    path and the remedy, when it cannot be written.
    """
    target = Path(path)
    content = data.encode() if isinstance(data, str) else data
    if target.is_dir():
        raise QuintrigError(f"{target}: expected the name of a file to write, found a folder; add a file name")
    temporary = ""
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        Path(temporary).chmod(0o666 & ~_umask())
        Path(temporary).replace(target)
    except OSError as error:
        if temporary:
            Path(temporary).unlink(missing_ok=True)
        reason = error.strerror or str(error)
        if isinstance(error, (FileExistsError, NotADirectoryError)):
            reason = "a part of the path is a file, not a folder"
        raise QuintrigError(f"{target}: cannot be written ({reason}); choose another place or free it") from None
    return target


def require(package: str, extra: str) -> None:
    """Raise QuintrigError with the command that installs an optional package, where it is missing."""
    if find_spec(package) is None:
        raise QuintrigError(f"this needs {package}, which is not installed: run pip install 'quintrig[{extra}]'")


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
