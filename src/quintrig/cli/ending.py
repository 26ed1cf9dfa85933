"""How a run ends: mistakes told in one line on stderr, exit codes, nothing more."""

import re
import signal
import sys
import threading
import traceback
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

import typer

from quintrig.cli.remedies import worded
from quintrig.support.errors import ModelError, QuintrigError, printable

FOUND, MISTAKE, FAULT, INTERRUPTED = 1, 2, 70, 130
"""Exit codes: a check found problems, the user's mistake, a fault of quintrig, Ctrl-C."""

_STOPS = tuple(getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name))
"""Signals that stop a run as Ctrl-C does; the exit code is 128 and their number."""


def run(build: Callable[[Sequence[str]], typer.Typer], arguments: Sequence[str]) -> int:
    """Run the application and return the exit code; a mistake of the user is told in one line on stderr."""
    with _stoppable() as stopped:
        code = _run(build, arguments)
    return 128 + stopped[0] if stopped and code == INTERRUPTED else code


@contextmanager
def _stoppable() -> Generator[list[int]]:
    """Let signals that would end the process at once interrupt it as Ctrl-C does, so that it cleans up.

    Yields the signals that came. A second one does not disturb the cleaning. Signals that are ignored stay so.
    """
    came: list[int] = []

    def stop(number: int, _frame: FrameType | None) -> None:
        came.append(number)
        if len(came) == 1:
            raise KeyboardInterrupt

    main = threading.current_thread() is threading.main_thread()  # only there signals may be handled
    handled = [number for number in _STOPS if main and signal.getsignal(number) == signal.SIG_DFL]
    for number in handled:
        signal.signal(number, stop)
    try:
        yield came
    finally:
        for number in handled:
            signal.signal(number, signal.SIG_DFL)


def _run(build: Callable[[Sequence[str]], typer.Typer], arguments: Sequence[str]) -> int:
    debug = "--debug" in arguments
    _prepare_streams()
    try:
        words = [word for word in arguments if word != "--debug"]
        result = build(words)(args=words, prog_name="quintrig", standalone_mode=False)
        sys.stdout.flush()
    except (KeyboardInterrupt, typer.Abort):
        return say("interrupted", INTERRUPTED)
    except Exception as error:
        if debug:
            traceback.print_exc()
        return _tell(error)
    if result == INTERRUPTED:  # typer has caught it before
        return say("interrupted", INTERRUPTED)
    # Outside standalone mode typer returns the code of an Exit, or else what the command returned.
    return result if isinstance(result, int) else 0


def warn(message: Warning | str, category: type[Warning], *_: object) -> None:
    """Say a warning in one line on stderr, whatever place in the code it comes from."""
    sys.stderr.write(f"quintrig: warning: {printable(str(message))}\n")


def _tell(error: Exception) -> int:
    """Say in one line what went wrong, and return the exit code."""
    usage = getattr(error, "format_message", None)
    if usage is not None:  # typer's own: a wrong option, a missing argument
        text = str(usage()).rstrip(".")
        return say(f"{text}{_see_help(error)}", MISTAKE) if text else MISTAKE
    if isinstance(error, (ModelError, QuintrigError)) or (isinstance(error, ValueError) and _is_ours(error)):
        return say(worded(error), MISTAKE)
    if isinstance(error, OSError):
        place = f"{error.filename}: " if error.filename else ""
        return say(f"{place}{error.strerror or error}; check the path, the permissions and the free space", MISTAKE)
    if isinstance(error, MemoryError):
        return say("not enough memory; ask for fewer points", MISTAKE)
    what = f"{type(error).__name__}: {error}"[:200]
    return say(
        f"a fault in quintrig itself ({what}); please report it with the command and the model; --debug shows where",
        FAULT,
    )


def _see_help(error: Exception) -> str:
    context = getattr(error, "ctx", None)
    return f"; see {context.command_path} --help" if context is not None else ""


def _is_ours(error: Exception) -> bool:
    """Tell whether quintrig's own code raised the error: anything deeper is a fault, not a user's mistake."""
    if type(error.__cause__).__name__ == "_RemoteTraceback":  # of another process, such as one that draws
        files = re.findall(r'File "(.*?)"', str(error.__cause__))
        return bool(files) and "quintrig" in Path(files[-1]).parts
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    return trace is not None and str(trace.tb_frame.f_globals.get("__name__", "")).startswith("quintrig")


def say(message: str, code: int) -> int:
    """Say on stderr, in one line, what ended the run; return the exit code."""
    sys.stderr.write(f"quintrig: {printable(message)}\n")
    return code


def _prepare_streams() -> None:
    """Write UTF-8 to files and pipes, and never fail on a letter that the terminal lacks."""
    reconfigure = getattr(sys.stdout, "reconfigure", None)
    if reconfigure is not None and sys.stdout.isatty():
        reconfigure(errors="replace")
    elif reconfigure is not None:
        reconfigure(encoding="utf-8", errors="backslashreplace")
