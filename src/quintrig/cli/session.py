"""What every command shares: where messages go, and how models and numbers are read."""

import sys
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import typer
from typer.core import TyperCommand

from quintrig.cli.ending import MISTAKE, say
from quintrig.cli.remedies import worded
from quintrig.support.errors import printable

if TYPE_CHECKING:
    from rich.console import Console

    from quintrig.exchange.export import Written
    from quintrig.model.model import Model
    from quintrig.model.patch import Patch


def load(path: Path, face: int | None = None, whole: bool = False) -> "Model":
    """Read a model file of surfaces, or a CAD file, all its faces or one; ModelError or QuintrigError in one line.

    ``whole`` takes all of the surfaces that trimmed faces are cut from.
    """
    model = load_any(path, face, whole)
    model.refuse_curves()
    return model


def load_any(path: Path, face: int | None = None, whole: bool = False) -> "Model":
    """Read what ``load`` reads, or a model of curves."""
    model = _load(path, face)
    return replace(model, patches=tuple(patch.carrier for patch in model.patches)) if whole else model


def _load(path: Path, face: int | None) -> "Model":
    if face is not None or path.suffix.lower() not in (".toml", ".json"):
        from quintrig.exchange.cad import isolated
        from quintrig.exchange.imports import open_model

        if face is not None or path.suffix.lower() in isolated.CAD_SUFFIXES:
            return open_model(path, None if face is None else [face])
    from quintrig.model import model

    return model.load(path)


def only(model: "Model", name: str | None) -> "Model":
    """Return the model with the patch or curve of this name alone, or all of it."""
    if name is None:
        return model
    if not model.patches or name in [one.name for one in model.curves]:
        return replace(model, patches=(), curves=(model.curve(name),), held=())
    return replace(model, patches=(model.patch(name),), curves=(), held=())


def patches(model: "Model", name: str | None) -> "tuple[Patch, ...]":
    """Return the patch of this name, or every patch; ModelError where there is none of the name."""
    return model.patches if name is None else (model.patch(name),)


def messages() -> "Console":
    """Return the console for progress and remarks: stderr, so that stdout holds data alone."""
    from rich.console import Console

    return Console(stderr=True, highlight=False, soft_wrap=True)


def output() -> "Console":
    """Return the console for what the user asked to see: stdout."""
    from rich.console import Console

    return Console(highlight=False)


def emit(text: str) -> None:
    """Write data to stdout as it is, ending in a newline."""
    sys.stdout.write(text if text.endswith("\n") else text + "\n")
    sys.stdout.flush()  # whoever waits for the studio's address reads a pipe


@contextmanager
def progress() -> "Generator[Callable[[str, int, int], None]]":
    """Show a bar on stderr while a block runs; call it with what is being done, steps done and steps in all."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    console = messages()
    if not console.is_terminal:
        yield _log()
        return
    columns = (BarColumn(bar_width=24), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
    bar = Progress(*columns, console=console, transient=True)
    task = bar.add_task("", total=None)

    def show(what: str, done: int, total: int) -> None:
        bar.start()  # with the first word, not before: a bar is a thread, with which no process may be copied
        bar.update(task, description=what, completed=done, total=total)

    try:
        yield show
    finally:
        bar.stop()


def _log() -> "Callable[[str, int, int], None]":
    """Return what tells progress to a log: a line for each tenth of the work, so about ten however many the steps."""
    told: set[int] = set()

    def tell(what: str, done: int, total: int) -> None:
        tenth = 10 * done // max(total, 1)
        if tenth not in told:
            told.add(tenth)
            print(f"[{done}/{total}] {what}", file=sys.stderr, flush=True)

    return tell


def done(page: Path) -> None:
    """Say where the page is: the path on stdout, so that a script can take it, with a word on stderr."""
    sys.stderr.write("The page is ready; open it in a browser:\n")
    emit(printable(str(page)))


def complain(message: str) -> None:
    """Say on stderr, in one line, what is wrong with one of several inputs."""
    say(message, MISTAKE)


def remark(line: str) -> None:
    """Tell something about the result, on stderr."""
    sys.stderr.write(f"{printable(worded(line))}\n")


def told(result: "Written") -> None:
    """Tell what an export has to say, and the files that it wrote."""
    for line in result.notes:
        remark(line)
    for path in result.paths:
        wrote(path, path in result.replaced)


def wrote(path: Path, replaced: bool = False) -> None:
    """Say where the result is, and whether it took the place of another one, on stderr."""
    sys.stderr.write(f"{'replaced' if replaced else 'wrote'} {printable(str(path))}\n")


def deliver(text: str, file: Path | None, *sources: Path | None, force: bool | None = None) -> None:
    """Write data to a file, whole or not at all, and say so; without a file or to ``-``, to stdout.

    QuintrigError where the file is one of ``sources``, or a model and not ``force``.
    """
    if file is None or str(file) == "-":
        emit(text)
        return
    from quintrig.support.files import refuse_loss, write_whole

    refuse_loss(file, *sources, force=force)
    replaced = file.is_file()
    wrote(write_whole(file, text), replaced)


def numbers(text: str, count: int | None, name: str) -> tuple[float, ...]:
    """Read numbers separated by commas; ValueError naming the option, what was expected and what was found."""
    from quintrig.support.numerals import real

    words = text.split(",")
    expected = f"{count} numbers" if count else "numbers"
    try:
        values = tuple(map(real, words))
    except ValueError:
        values = ()
    if not values or (count and len(values) != count):
        raise ValueError(f"{name}: expected {expected} separated by commas, got {text[:60]!r}")
    return values


def words(text: str | None) -> list[str]:
    """Return the words of a list such as ``K,H``; none of none."""
    return [] if text is None else [word.strip() for word in text.split(",")]


def counts(
    text: str, name: str, most: int = 10**12, remedy: str = "choose a coarser grid", least: int = 2
) -> tuple[int, int]:
    """Read two counts such as 20x30, or one for both, at most ``most`` in all.

    Raises ValueError naming the option, and the ``remedy`` for too many.
    """
    words = text.lower().replace("×", "x").split("x")
    if len(words) == 1:
        words *= 2
    if len(words) != 2 or not all(word.strip().isascii() and word.strip().isdigit() for word in words):
        raise ValueError(f"{name}: expected two counts such as 20x30, got {text[:60]!r}")
    if any(len(word.strip()) > 12 for word in words) or int(words[0]) * int(words[1]) > most:
        raise ValueError(f"{name}: expected at most {most:,} points, got {text[:60]}; {remedy}")
    found = int(words[0]), int(words[1])
    if min(found) < least:
        raise ValueError(f"{name}: expected {least} or more each way, got {text[:60]}")
    return found


def add(
    app: typer.Typer,
    command: Callable[..., None],
    epilog: str,
    name: str | None = None,
    cls: type[TyperCommand] | None = None,
) -> None:
    """Add a command, its docstring as help with every paragraph on a line of its own, to wrap at the screen's width."""
    paragraphs = [" ".join(part.split()) for part in (command.__doc__ or "").split("\n\n")]
    app.command(name, cls=cls, help="\n\n".join(paragraphs), epilog=epilog)(command)


def examples(*pairs: tuple[str, str]) -> str:
    """Return the examples that end a help text: each a command and what it does."""
    lines = [f"  [cyan]{command}[/cyan]\n      [dim]{meaning}[/dim]" for command, meaning in pairs]
    return "[bold]Examples[/bold]\n" + "\n".join(lines)
