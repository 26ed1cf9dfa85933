"""What writing needs: files whole or not at all, no model lost, and packages that may be missing."""

import json
import os
import tempfile
import tomllib
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import Any, cast

from quintrig.durable import flush, make_folder, settle
from quintrig.errors import QuintrigError


def write_whole(path: str | Path, data: bytes | str) -> Path:
    """Write ``data`` (text as UTF-8) to ``path`` through a temporary file beside it, and return the path.

    An existing file is replaced in one step or kept. Missing parent folders are made. Raises QuintrigError, naming the
    path and the remedy, when it cannot be written.
    """
    target = Path(path)
    with _draft(target, data) as draft:
        draft.replace(target)
        settle(target.parent)
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
    if target.is_dir():
        raise QuintrigError(f"{target}: expected the name of a file to write, found a folder; add a file name")
    temporary = ""
    try:
        make_folder(target.parent)
        handle, temporary = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(data.encode() if isinstance(data, str) else data)
            flush(file)
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


def refuse_loss(target: str | Path, *sources: Path | None, force: bool | None = None) -> None:
    """Raise QuintrigError where writing ``target`` would lose what a user wrote: a source of this run, or a model.

    ``sources`` are the files that are read, with the CSV files that models among them name; those are never written
    over. Another model file is, where ``force`` is true; None stands for a command without that option.
    """
    path = Path(target)
    if not path.is_file():
        return
    for source in sources:
        if source is not None and any(one.exists() and path.samefile(one) for one in (source, *_named_nets(source))):
            raise QuintrigError(
                f"{path}: this file is read here, and writing to it would lose the original; choose another name"
            )
    if not force and _is_model(path):
        remedy = "remove it first" if force is None else "--force to replace it"
        raise QuintrigError(f"{path}: exists already and is a model; choose another name, or {remedy}")


def _is_model(path: Path) -> bool:
    """Return whether a file is a model: any TOML, for people write those, and JSON with the keys of one."""
    return path.suffix.lower() == ".toml" or bool({"kind", "patch"} & set(_keys(path) or ()))


def _named_nets(path: Path) -> Iterator[Path]:
    """Yield the CSV files that a model names in place of numbers."""
    keys = _keys(path) or {}
    several = keys.get("patch", ())
    tables = [keys, *(cast(list[Any], several) if isinstance(several, list) else ())]
    for table in tables:
        for value in cast(dict[str, Any], table).values() if isinstance(table, dict) else ():
            if isinstance(value, str) and value.lower().endswith(".csv"):
                yield path.parent / value


def _keys(path: Path) -> dict[str, Any] | None:
    """Return the keys of a TOML or JSON file, None where it has none or cannot be read."""
    suffix = path.suffix.lower()
    if suffix not in (".toml", ".json"):
        return None
    try:
        text = path.read_text(encoding="utf-8-sig")
        found: object = tomllib.loads(text) if suffix == ".toml" else json.loads(text)
    except (OSError, ValueError, RecursionError):
        return None
    return cast(dict[str, Any], found) if isinstance(found, dict) else None


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
