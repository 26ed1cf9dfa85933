"""What writing needs: files whole or not at all, and no model lost."""

import os
import stat
import tempfile
from collections.abc import Generator, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, BinaryIO, cast

from quintrig.support.durable import flush, make_folder, settle
from quintrig.support.errors import QuintrigError
from quintrig.support.parsing import LARGEST_FILE, parse


def open_regular(path: Path) -> BinaryIO:
    """Open a file for reading bytes; OSError for a pipe, socket or device, which may never end or never begin."""
    found = _special(path)
    if found:
        raise OSError(f"expected a regular file, found {found}")
    return open(path, "rb", opener=_without_waiting)


def _without_waiting(path: str, flags: int) -> int:
    # Where the file has become a pipe since it was looked at, opening it still returns at once.
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _special(path: Path) -> str:
    """Return in words what a path leads to, where that is neither a regular file nor nothing."""
    try:
        mode = path.stat().st_mode
    except FileNotFoundError:
        return ""
    kinds = {stat.S_IFREG: "", stat.S_IFDIR: "a folder", stat.S_IFIFO: "a pipe", stat.S_IFSOCK: "a socket"}
    return kinds.get(stat.S_IFMT(mode), "a device")


def write_whole(path: str | Path, data: bytes | str) -> Path:
    """Write ``data`` (text as UTF-8) to ``path`` through a temporary file beside it, and return the path.

    An existing file is replaced in one step or kept; its permissions stay, and a link stays one, to the new content.
    Missing parent folders are made. Raises QuintrigError, naming the path and the remedy, when it cannot be written.
    """
    target = Path(path)
    real = Path(os.path.realpath(target)) if target.is_symlink() else target
    with _draft(real, data) as draft:
        draft.replace(real)
        settle(real.parent)
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
        settle(path.parent)
    return True


@contextmanager
def _draft(target: Path, data: bytes | str) -> Generator[Path]:
    """Give a temporary file beside the target with the data in it, and remove it if it is still there at the end."""
    _refuse_special(target)
    temporary = ""
    try:
        make_folder(target.parent)
        handle, temporary = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(data.encode() if isinstance(data, str) else data)
            flush(file)
        _dress(Path(temporary), target)
        yield Path(temporary)
    except (OSError, UnicodeError) as error:
        raise _refusal(target, error) from None
    finally:
        if temporary:
            Path(temporary).unlink(missing_ok=True)


def _dress(draft: Path, target: Path) -> None:
    """Give a draft the owner and the permissions of the file that it will replace, or those of a new file."""
    try:
        old = target.stat()
    except FileNotFoundError:
        draft.chmod(0o666 & ~_umask())
        return
    with suppress(OSError, AttributeError):  # only root may give a file away, and Windows has no such thing
        os.chown(draft, old.st_uid, old.st_gid)
    draft.chmod(stat.S_IMODE(old.st_mode))


def _refuse_special(target: Path) -> None:
    found = ""
    try:
        found = _special(target)
    except UnicodeError as error:
        raise _refusal(target, error) from None
    except OSError:
        pass  # told when it is written
    if found:
        remedy = "add a file name" if found == "a folder" else "choose another name"
        raise QuintrigError(f"{target}: expected the name of a file to write, found {found}; {remedy}")


def refuse_unwritable(path: str | Path) -> None:
    """Raise the QuintrigError of ``write_whole`` where it would fail, before long work whose result goes there."""
    target = Path(path)
    _refuse_special(target)
    there = next(folder for folder in target.absolute().parents if folder.exists())
    try:
        with tempfile.TemporaryFile(dir=there):
            pass
    except OSError as error:
        raise _refusal(target, error) from None


def refuse_loss(
    target: str | Path, *sources: Path | None, edited: Path | None = None, force: bool | None = None
) -> None:
    """Raise QuintrigError where writing ``target`` would lose what a user wrote: a source of this run, or a model.

    ``sources`` are the files that are read, with the CSV files that models among them name; those are never written
    over. Another model file is, where ``force`` is true, and so is the one that the command ``edited``; None stands for
    a command without that option.
    """
    path = Path(target)
    if not path.is_file():
        return
    if edited is not None and edited.exists() and path.samefile(edited):
        if force:
            return
        message = f"{path}: this file is read here, and writing to it would lose the original"
        raise QuintrigError(message, remedy="choose another name, or force=True to replace it", key="replace")
    if edited is not None:
        sources = (*sources, edited)
    for source in sources:
        if source is not None and any(one.exists() and path.samefile(one) for one in (source, *_named_nets(source))):
            raise QuintrigError(
                f"{path}: this file is read here, and writing to it would lose the original; choose another name"
            )
    if not force and _is_model(path):
        message, name = f"{path}: exists already and is a model", "choose another name, or"
        if force is None:
            raise QuintrigError(message, remedy=f"{name} remove it first")
        raise QuintrigError(message, remedy=f"{name} force=True to replace it", key="replace")


def _is_model(path: Path) -> bool:
    """Return whether a file is a model: any TOML, for people write those, and JSON with the keys of one."""
    return path.suffix.lower() == ".toml" or bool({"kind", "patch"} & set(_keys(path) or ()))


def _named_nets(path: Path) -> Iterator[Path]:
    """Yield the CSV files that a model names in place of numbers."""
    yield from (path.parent / name for name in nets_named(_keys(path) or {}))


def nets_named(keys: dict[str, Any]) -> Iterator[str]:
    """Yield the names of CSV files that the keys of a model hold in place of numbers."""
    several = keys.get("patch", ())
    tables = [keys, *(cast(list[Any], several) if isinstance(several, list) else ())]
    for table in tables:
        for value in cast(dict[str, Any], table).values() if isinstance(table, dict) else ():
            if isinstance(value, str) and value.lower().endswith(".csv"):
                yield value


def _keys(path: Path) -> dict[str, Any] | None:
    """Return the keys of a TOML or JSON file, None where it has none or cannot be read."""
    suffix = path.suffix.lower()
    if suffix not in (".toml", ".json"):
        return None
    try:
        with open_regular(path) as file:
            raw = file.read(LARGEST_FILE + 1)
        found: object = parse(raw.decode("utf-8-sig"), suffix)
    except (OSError, ValueError):
        return None
    return cast(dict[str, Any], found) if isinstance(found, dict) else None


def _refusal(target: Path, error: OSError | UnicodeError) -> QuintrigError:
    if isinstance(error, UnicodeError):
        return QuintrigError(f"{target}: this system cannot spell the name; choose another, or set LC_ALL=C.UTF-8")
    reason = error.strerror or str(error)
    if isinstance(error, (FileExistsError, NotADirectoryError)):
        reason = "a part of the path is a file, not a folder"
    return QuintrigError(f"{target}: cannot be written ({reason}); choose another place or free it")


def in_utf8(path: Path) -> bool:
    """Return whether a name is text that other libraries take; one in another encoding than the system's is not."""
    try:
        str(path).encode()
    except UnicodeEncodeError:
        return False
    return True


def require_utf8(path: Path, what: str) -> None:
    """Raise QuintrigError where the name is no text in UTF-8, before work that would end in vain."""
    if not in_utf8(path):
        raise QuintrigError(f"{path}: expected {what} whose name is in UTF-8; rename it, or set LC_ALL=C.UTF-8")


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
